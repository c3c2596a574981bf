# The error of lhs - rhs: edge_bc.radius of reduced, fma, binary64, on the absolute domain.
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
rr = rnd(r * r);
BC_x = rnd(c_x - b_x);
BC_y = rnd(c_y - b_y);
BC_z = rnd(c_z - b_z);
N2_x = rnd(b_y * c_z + (-rnd(b_z * c_y)));
N2_y = rnd(b_z * c_x + (-rnd(b_x * c_z)));
N2_z = rnd(b_x * c_y + (-rnd(b_y * c_x)));
e2 = rnd(BC_z * BC_z + rnd(BC_y * BC_y + rnd(BC_x * BC_x)));
lhs = rnd(N2_z * N2_z + rnd(N2_y * N2_y + rnd(N2_x * N2_x)));
rhs = rnd(rr * e2);
Mb_x = Bx - Px;
Mb_y = By - Py;
Mb_z = Bz - Pz;
Mc_x = Cx - Px;
Mc_y = Cy - Py;
Mc_z = Cz - Pz;
Mrr = r * r;
MBC_x = Mc_x - Mb_x;
MBC_y = Mc_y - Mb_y;
MBC_z = Mc_z - Mb_z;
MN2_x = Mb_y * Mc_z + (-(Mb_z * Mc_y));
MN2_y = Mb_z * Mc_x + (-(Mb_x * Mc_z));
MN2_z = Mb_x * Mc_y + (-(Mb_y * Mc_x));
Me2 = MBC_z * MBC_z + (MBC_y * MBC_y + MBC_x * MBC_x);
Mlhs = MN2_z * MN2_z + (MN2_y * MN2_y + MN2_x * MN2_x);
Mrhs = Mrr * Me2;
product = N2_z * N2_z + (N2_y * N2_y + N2_x * N2_x);
by_N2 = MN2_z * (N2_z - MN2_z) + (MN2_y * (N2_y - MN2_y) + MN2_x * (N2_x - MN2_x));
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
  MN2_x in [-4,4] ->
  MN2_y in [-4,4] ->
  MN2_z in [-4,4] ->
  (|N2_x - MN2_x| <= 224b-57 /\ |N2_y - MN2_y| <= 224b-57 /\ |N2_z - MN2_z| <= 224b-57) /\
  (|by_N2| <= 2688b-57 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 7873b-57)
}
rr ~ Mrr;
BC_x ~ MBC_x;
BC_y ~ MBC_y;
BC_z ~ MBC_z;
N2_x ~ MN2_x;
N2_y ~ MN2_y;
N2_z ~ MN2_z;
e2 ~ Me2;
lhs ~ Mlhs;
rhs ~ Mrhs;
Mc_x - Mb_x -> Cx - Bx;
Mc_y - Mb_y -> Cy - By;
Mc_z - Mb_z -> Cz - Bz;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_N2 + by_N2) + ((N2_x - MN2_x) * (N2_x - MN2_x) + (N2_y - MN2_y) * (N2_y - MN2_y) + (N2_z - MN2_z) * (N2_z - MN2_z));
