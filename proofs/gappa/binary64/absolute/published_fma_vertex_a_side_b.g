# The error of lhs - rhs: vertex_a.side_b of published, fma, binary64, on the absolute domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
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
b_x = rnd(Bx - Px);
b_y = rnd(By - Py);
b_z = rnd(Bz - Pz);
lhs = rnd(a_z * b_z + rnd(a_y * b_y + rnd(a_x * b_x)));
rhs = rnd(a_z * a_z + rnd(a_y * a_y + rnd(a_x * a_x)));
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mb_x = Bx - Px;
Mb_y = By - Py;
Mb_z = Bz - Pz;
Mlhs = Ma_z * Mb_z + (Ma_y * Mb_y + Ma_x * Mb_x);
Mrhs = Ma_z * Ma_z + (Ma_y * Ma_y + Ma_x * Ma_x);
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
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 832b-57
}
lhs ~ Mlhs;
rhs ~ Mrhs;
Mb_x - Ma_x -> Bx - Ax;
Mb_y - Ma_y -> By - Ay;
Mb_z - Ma_z -> Bz - Az;
