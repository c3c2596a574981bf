# The error of lhs - rhs: vertex_c.side_a of published, fma, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
lhs = rnd(a_z * c_z + rnd(a_y * c_y + rnd(a_x * c_x)));
rhs = rnd(c_z * c_z + rnd(c_y * c_y + rnd(c_x * c_x)));
Mlhs = Ma_z * Mc_z + (Ma_y * Mc_y + Ma_x * Mc_x);
Mrhs = Mc_z * Mc_z + (Mc_y * Mc_y + Mc_x * Mc_x);
Flhs = a_z * c_z + (a_y * c_y + a_x * c_x);
Frhs = c_z * c_z + (c_y * c_y + c_x * c_x);
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
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
