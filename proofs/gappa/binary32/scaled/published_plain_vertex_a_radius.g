# The error of lhs - rhs: vertex_a.radius of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
lhs = rnd(rnd(rnd(a_x * a_x) + rnd(a_y * a_y)) + rnd(a_z * a_z));
rhs = rnd(r * r);
Mlhs = Ma_x * Ma_x + Ma_y * Ma_y + Ma_z * Ma_z;
Mrhs = r * r;
Flhs = a_x * a_x + a_y * a_y + a_z * a_z;
Frhs = r * r;
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 128b-28
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
