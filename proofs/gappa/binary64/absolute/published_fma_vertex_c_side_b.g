# The error of lhs - rhs: vertex_c.side_b of published, fma, binary64, on the absolute domain.
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
b_x = rnd(Bx - Px);
b_y = rnd(By - Py);
b_z = rnd(Bz - Pz);
c_x = rnd(Cx - Px);
c_y = rnd(Cy - Py);
c_z = rnd(Cz - Pz);
lhs = rnd(b_z * c_z + rnd(b_y * c_y + rnd(b_x * c_x)));
rhs = rnd(c_z * c_z + rnd(c_y * c_y + rnd(c_x * c_x)));
Mb_x = Bx - Px;
Mb_y = By - Py;
Mb_z = Bz - Pz;
Mc_x = Cx - Px;
Mc_y = Cy - Py;
Mc_z = Cz - Pz;
Mlhs = Mb_z * Mc_z + (Mb_y * Mc_y + Mb_x * Mc_x);
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
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 832b-57
}
lhs ~ Mlhs;
rhs ~ Mrhs;
Mc_x - Mb_x -> Cx - Bx;
Mc_y - Mb_y -> Cy - By;
Mc_z - Mb_z -> Cz - Bz;
