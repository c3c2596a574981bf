# The error of lhs - rhs: vertex_b.radius of published, fma, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
r = rnd(r_);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
lhs = rnd(b_z * b_z + rnd(b_y * b_y + rnd(b_x * b_x)));
rhs = rnd(r * r);
Mlhs = Mb_z * Mb_z + (Mb_y * Mb_y + Mb_x * Mb_x);
Mrhs = r * r;
Flhs = b_z * b_z + (b_y * b_y + b_x * b_x);
Frhs = r * r;
{
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 112b-57
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
