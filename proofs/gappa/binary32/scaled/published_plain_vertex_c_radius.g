# The error of lhs - rhs: vertex_c.radius of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
lhs = rnd(rnd(rnd(c_x * c_x) + rnd(c_y * c_y)) + rnd(c_z * c_z));
rhs = rnd(r * r);
Mlhs = Mc_x * Mc_x + Mc_y * Mc_y + Mc_z * Mc_z;
Mrhs = r * r;
Flhs = c_x * c_x + c_y * c_y + c_z * c_z;
Frhs = r * r;
{
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 128b-28
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
