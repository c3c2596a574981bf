# The error of lhs - rhs: vertex_c.side_a of published, fma, binary32, on the absolute domain.
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
c_x = rnd(Cx - Px);
c_y = rnd(Cy - Py);
c_z = rnd(Cz - Pz);
lhs = rnd(a_z * c_z + rnd(a_y * c_y + rnd(a_x * c_x)));
rhs = rnd(c_z * c_z + rnd(c_y * c_y + rnd(c_x * c_x)));
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mc_x = Cx - Px;
Mc_y = Cy - Py;
Mc_z = Cz - Pz;
Mlhs = Ma_z * Mc_z + (Ma_y * Mc_y + Ma_x * Mc_x);
Mrhs = Mc_z * Mc_z + (Mc_y * Mc_y + Mc_x * Mc_x);
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
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 832b-28
}
lhs ~ Mlhs;
rhs ~ Mrhs;
Ma_x - Mc_x -> Ax - Cx;
Ma_y - Mc_y -> Ay - Cy;
Ma_z - Mc_z -> Az - Cz;
Mc_x - Ma_x -> Cx - Ax;
Mc_y - Ma_y -> Cy - Ay;
Mc_z - Ma_z -> Cz - Az;
