# The error of lhs - rhs: vertex_c.side_b of published, fma, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
lhs = rnd(b_z * c_z + rnd(b_y * c_y + rnd(b_x * c_x)));
rhs = rnd(c_z * c_z + rnd(c_y * c_y + rnd(c_x * c_x)));
Mlhs = Mb_z * Mc_z + (Mb_y * Mc_y + Mb_x * Mc_x);
Mrhs = Mc_z * Mc_z + (Mc_y * Mc_y + Mc_x * Mc_x);
Flhs = b_z * c_z + (b_y * c_y + b_x * c_x);
Frhs = c_z * c_z + (c_y * c_y + c_x * c_x);
{
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 208b-28
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
