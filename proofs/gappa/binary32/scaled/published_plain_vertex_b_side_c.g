# The error of lhs - rhs: vertex_b.side_c of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
lhs = rnd(rnd(rnd(b_x * c_x) + rnd(b_y * c_y)) + rnd(b_z * c_z));
rhs = rnd(rnd(rnd(b_x * b_x) + rnd(b_y * b_y)) + rnd(b_z * b_z));
Mlhs = Mb_x * Mc_x + Mb_y * Mc_y + Mb_z * Mc_z;
Mrhs = Mb_x * Mb_x + Mb_y * Mb_y + Mb_z * Mb_z;
Flhs = b_x * c_x + b_y * c_y + b_z * c_z;
Frhs = b_x * b_x + b_y * b_y + b_z * b_z;
{
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 240b-28
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
