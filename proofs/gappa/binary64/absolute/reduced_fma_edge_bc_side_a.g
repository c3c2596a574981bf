# The error of lhs - rhs: edge_bc.side_a of reduced, fma, binary64, on the absolute domain.
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
c_x = rnd(Cx - Px);
c_y = rnd(Cy - Py);
c_z = rnd(Cz - Pz);
AB_x = rnd(b_x - a_x);
AB_y = rnd(b_y - a_y);
AB_z = rnd(b_z - a_z);
N2_x = rnd(b_y * c_z + (-rnd(b_z * c_y)));
N2_y = rnd(b_z * c_x + (-rnd(b_x * c_z)));
N2_z = rnd(b_x * c_y + (-rnd(b_y * c_x)));
AC_x = rnd(c_x - a_x);
AC_y = rnd(c_y - a_y);
AC_z = rnd(c_z - a_z);
V_x = rnd(AB_y * AC_z + (-rnd(AB_z * AC_y)));
V_y = rnd(AB_z * AC_x + (-rnd(AB_x * AC_z)));
V_z = rnd(AB_x * AC_y + (-rnd(AB_y * AC_x)));
rhs = rnd(N2_z * V_z + rnd(N2_y * V_y + rnd(N2_x * V_x)));
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mb_x = Bx - Px;
Mb_y = By - Py;
Mb_z = Bz - Pz;
Mc_x = Cx - Px;
Mc_y = Cy - Py;
Mc_z = Cz - Pz;
MAB_x = Mb_x - Ma_x;
MAB_y = Mb_y - Ma_y;
MAB_z = Mb_z - Ma_z;
MN2_x = Mb_y * Mc_z + (-(Mb_z * Mc_y));
MN2_y = Mb_z * Mc_x + (-(Mb_x * Mc_z));
MN2_z = Mb_x * Mc_y + (-(Mb_y * Mc_x));
MAC_x = Mc_x - Ma_x;
MAC_y = Mc_y - Ma_y;
MAC_z = Mc_z - Ma_z;
MV_x = MAB_y * MAC_z + (-(MAB_z * MAC_y));
MV_y = MAB_z * MAC_x + (-(MAB_x * MAC_z));
MV_z = MAB_x * MAC_y + (-(MAB_y * MAC_x));
Mrhs = MN2_z * MV_z + (MN2_y * MV_y + MN2_x * MV_x);
product = N2_z * V_z + (N2_y * V_y + N2_x * V_x);
by_V = MN2_z * (V_z - MV_z) + (MN2_y * (V_y - MV_y) + MN2_x * (V_x - MV_x));
by_N2 = MV_z * (N2_z - MN2_z) + (MV_y * (N2_y - MN2_y) + MV_x * (N2_x - MN2_x));
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
  MV_x in [-4,4] ->
  MV_y in [-4,4] ->
  MV_z in [-4,4] ->
  MN2_x in [-4,4] ->
  MN2_y in [-4,4] ->
  MN2_z in [-4,4] ->
  (|V_x - MV_x| <= 608b-57 /\ |V_y - MV_y| <= 608b-57 /\ |V_z - MV_z| <= 608b-57) /\
  (|by_V| <= 7296b-57 ->
  |rhs - Mrhs| <= 11265b-57)
}
AB_x ~ MAB_x;
AB_y ~ MAB_y;
AB_z ~ MAB_z;
N2_x ~ MN2_x;
N2_y ~ MN2_y;
N2_z ~ MN2_z;
AC_x ~ MAC_x;
AC_y ~ MAC_y;
AC_z ~ MAC_z;
V_x ~ MV_x;
V_y ~ MV_y;
V_z ~ MV_z;
rhs ~ Mrhs;
Mb_x - Ma_x -> Bx - Ax;
Mb_y - Ma_y -> By - Ay;
Mb_z - Ma_z -> Bz - Az;
Mc_x - Mb_x -> Cx - Bx;
Mc_y - Mb_y -> Cy - By;
Mc_z - Mb_z -> Cz - Bz;
Ma_x - Mc_x -> Ax - Cx;
Ma_y - Mc_y -> Ay - Cy;
Ma_z - Mc_z -> Az - Cz;
Mc_x - Ma_x -> Cx - Ax;
Mc_y - Ma_y -> Cy - Ay;
Mc_z - Ma_z -> Cz - Az;
rhs ~ product;
rhs - Mrhs -> (rhs - product) + (product - Mrhs);
product - Mrhs -> (by_V + by_N2) + ((N2_x - MN2_x) * (V_x - MV_x) + (N2_y - MN2_y) * (V_y - MV_y) + (N2_z - MN2_z) * (V_z - MV_z));
