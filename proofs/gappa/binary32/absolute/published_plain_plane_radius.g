# The error of lhs - rhs: plane.radius of published, plain, binary32, on the absolute domain.
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
b_x = rnd(Bx - Px);
b_y = rnd(By - Py);
b_z = rnd(Bz - Pz);
c_x = rnd(Cx - Px);
c_y = rnd(Cy - Py);
c_z = rnd(Cz - Pz);
rr = rnd(r * r);
AB_x = rnd(b_x - a_x);
AB_y = rnd(b_y - a_y);
AB_z = rnd(b_z - a_z);
AC_x = rnd(c_x - a_x);
AC_y = rnd(c_y - a_y);
AC_z = rnd(c_z - a_z);
V_x = rnd(rnd(AB_y * AC_z) - rnd(AB_z * AC_y));
V_y = rnd(rnd(AB_z * AC_x) - rnd(AB_x * AC_z));
V_z = rnd(rnd(AB_x * AC_y) - rnd(AB_y * AC_x));
d = rnd(rnd(rnd(a_x * V_x) + rnd(a_y * V_y)) + rnd(a_z * V_z));
e = rnd(rnd(rnd(V_x * V_x) + rnd(V_y * V_y)) + rnd(V_z * V_z));
lhs = rnd(d * d);
rhs = rnd(rr * e);
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mb_x = Bx - Px;
Mb_y = By - Py;
Mb_z = Bz - Pz;
Mc_x = Cx - Px;
Mc_y = Cy - Py;
Mc_z = Cz - Pz;
Mrr = r * r;
MAB_x = Mb_x - Ma_x;
MAB_y = Mb_y - Ma_y;
MAB_z = Mb_z - Ma_z;
MAC_x = Mc_x - Ma_x;
MAC_y = Mc_y - Ma_y;
MAC_z = Mc_z - Ma_z;
MV_x = MAB_y * MAC_z - MAB_z * MAC_y;
MV_y = MAB_z * MAC_x - MAB_x * MAC_z;
MV_z = MAB_x * MAC_y - MAB_y * MAC_x;
Md = Ma_x * MV_x + Ma_y * MV_y + Ma_z * MV_z;
Me = MV_x * MV_x + MV_y * MV_y + MV_z * MV_z;
Mlhs = Md * Md;
Mrhs = Mrr * Me;
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
  Md in [-16,16] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 179841b-28
}
rr ~ Mrr;
AB_x ~ MAB_x;
AB_y ~ MAB_y;
AB_z ~ MAB_z;
AC_x ~ MAC_x;
AC_y ~ MAC_y;
AC_z ~ MAC_z;
V_x ~ MV_x;
V_y ~ MV_y;
V_z ~ MV_z;
d ~ Md;
e ~ Me;
lhs ~ Mlhs;
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
