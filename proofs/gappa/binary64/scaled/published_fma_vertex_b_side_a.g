# The error of lhs - rhs: vertex_b.side_a of published, fma, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
lhs = rnd(a_z * b_z + rnd(a_y * b_y + rnd(a_x * b_x)));
rhs = rnd(b_z * b_z + rnd(b_y * b_y + rnd(b_x * b_x)));
Mlhs = Ma_z * Mb_z + (Ma_y * Mb_y + Ma_x * Mb_x);
Mrhs = Mb_z * Mb_z + (Mb_y * Mb_y + Mb_x * Mb_x);
Flhs = a_z * b_z + (a_y * b_y + a_x * b_x);
Frhs = b_z * b_z + (b_y * b_y + b_x * b_x);
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 208b-57
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
