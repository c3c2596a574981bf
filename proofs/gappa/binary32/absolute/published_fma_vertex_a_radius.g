# The error of lhs - rhs: vertex_a.radius of published, fma, binary32, on the absolute domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
Ax = rnd(Ax_);
Ay = rnd(Ay_);
Az = rnd(Az_);
Bx = rnd(Bx_);
By = rnd(By_);
Bz = rnd(Bz_);
Cx = rnd(Cx_);
Cy = rnd(Cy_);
Cz = rnd(Cz_);
Px = rnd(Px_);
Py = rnd(Py_);
Pz = rnd(Pz_);
r = rnd(r_);
a_x = rnd(Ax - Px);
a_y = rnd(Ay - Py);
a_z = rnd(Az - Pz);
lhs = rnd(a_z * a_z + rnd(a_y * a_y + rnd(a_x * a_x)));
rhs = rnd(r * r);
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mlhs = Ma_z * Ma_z + (Ma_y * Ma_y + Ma_x * Ma_x);
Mrhs = r * r;
{
  Ax in [-1,1] ->
  Ay in [-1,1] ->
  Az in [-1,1] ->
  Bx in [-1,1] ->
  By in [-1,1] ->
  Bz in [-1,1] ->
  Cx in [-1,1] ->
  Cy in [-1,1] ->
  Cz in [-1,1] ->
  Px in [-1,1] ->
  Py in [-1,1] ->
  Pz in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 424b-28
}
lhs ~ Mlhs;
rhs ~ Mrhs;
