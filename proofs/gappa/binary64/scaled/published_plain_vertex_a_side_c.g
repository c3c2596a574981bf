# The error of lhs - rhs: vertex_a.side_c of published, plain, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
lhs = rnd(rnd(rnd(a_x * c_x) + rnd(a_y * c_y)) + rnd(a_z * c_z));
rhs = rnd(rnd(rnd(a_x * a_x) + rnd(a_y * a_y)) + rnd(a_z * a_z));
Mlhs = Ma_x * Mc_x + Ma_y * Mc_y + Ma_z * Mc_z;
Mrhs = Ma_x * Ma_x + Ma_y * Ma_y + Ma_z * Ma_z;
Flhs = a_x * c_x + a_y * c_y + a_z * c_z;
Frhs = a_x * a_x + a_y * a_y + a_z * a_z;
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 240b-57
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
