# The error of lhs - rhs: vertex_a.side_b of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
lhs = rnd(rnd(rnd(a_x * b_x) + rnd(a_y * b_y)) + rnd(a_z * b_z));
rhs = rnd(rnd(rnd(a_x * a_x) + rnd(a_y * a_y)) + rnd(a_z * a_z));
Mlhs = Ma_x * Mb_x + Ma_y * Mb_y + Ma_z * Mb_z;
Mrhs = Ma_x * Ma_x + Ma_y * Ma_y + Ma_z * Ma_z;
Flhs = a_x * b_x + a_y * b_y + a_z * b_z;
Frhs = a_x * a_x + a_y * a_y + a_z * a_z;
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 240b-28
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
