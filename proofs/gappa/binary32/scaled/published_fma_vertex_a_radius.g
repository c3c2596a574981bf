# The error of lhs - rhs: vertex_a.radius of published, fma, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
lhs = rnd(a_z * a_z + rnd(a_y * a_y + rnd(a_x * a_x)));
rhs = rnd(r * r);
Mlhs = Ma_z * Ma_z + (Ma_y * Ma_y + Ma_x * Ma_x);
Mrhs = r * r;
Flhs = a_z * a_z + (a_y * a_y + a_x * a_x);
Frhs = r * r;
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 112b-28
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
