# The error of lhs - rhs: vertex_b.radius of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
lhs = rnd(rnd(rnd(b_x * b_x) + rnd(b_y * b_y)) + rnd(b_z * b_z));
rhs = rnd(r * r);
Mlhs = Mb_x * Mb_x + Mb_y * Mb_y + Mb_z * Mb_z;
Mrhs = r * r;
Flhs = b_x * b_x + b_y * b_y + b_z * b_z;
Frhs = r * r;
{
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 128b-28
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
