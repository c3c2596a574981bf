# The error of lhs - rhs: edge_ab.radius of reduced, plain, binary32, on the absolute domain.
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
rr = rnd(r * r);
AB_x = rnd(b_x - a_x);
AB_y = rnd(b_y - a_y);
AB_z = rnd(b_z - a_z);
N1_x = rnd(rnd(a_y * b_z) - rnd(a_z * b_y));
N1_y = rnd(rnd(a_z * b_x) - rnd(a_x * b_z));
N1_z = rnd(rnd(a_x * b_y) - rnd(a_y * b_x));
e1 = rnd(rnd(rnd(AB_x * AB_x) + rnd(AB_y * AB_y)) + rnd(AB_z * AB_z));
lhs = rnd(rnd(rnd(N1_x * N1_x) + rnd(N1_y * N1_y)) + rnd(N1_z * N1_z));
rhs = rnd(rr * e1);
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mb_x = Bx - Px;
Mb_y = By - Py;
Mb_z = Bz - Pz;
Mrr = r * r;
MAB_x = Mb_x - Ma_x;
MAB_y = Mb_y - Ma_y;
MAB_z = Mb_z - Ma_z;
MN1_x = Ma_y * Mb_z - Ma_z * Mb_y;
MN1_y = Ma_z * Mb_x - Ma_x * Mb_z;
MN1_z = Ma_x * Mb_y - Ma_y * Mb_x;
Me1 = MAB_x * MAB_x + MAB_y * MAB_y + MAB_z * MAB_z;
Mlhs = MN1_x * MN1_x + MN1_y * MN1_y + MN1_z * MN1_z;
Mrhs = Mrr * Me1;
product = N1_x * N1_x + N1_y * N1_y + N1_z * N1_z;
by_N1 = MN1_x * (N1_x - MN1_x) + MN1_y * (N1_y - MN1_y) + MN1_z * (N1_z - MN1_z);
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
  MN1_x in [-4,4] ->
  MN1_y in [-4,4] ->
  MN1_z in [-4,4] ->
  (|N1_x - MN1_x| <= 256b-28 /\ |N1_y - MN1_y| <= 256b-28 /\ |N1_z - MN1_z| <= 256b-28) /\
  (|by_N1| <= 3072b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 9217b-28)
}
rr ~ Mrr;
AB_x ~ MAB_x;
AB_y ~ MAB_y;
AB_z ~ MAB_z;
N1_x ~ MN1_x;
N1_y ~ MN1_y;
N1_z ~ MN1_z;
e1 ~ Me1;
lhs ~ Mlhs;
rhs ~ Mrhs;
Mb_x - Ma_x -> Bx - Ax;
Mb_y - Ma_y -> By - Ay;
Mb_z - Ma_z -> Bz - Az;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_N1 + by_N1) + ((N1_x - MN1_x) * (N1_x - MN1_x) + (N1_y - MN1_y) * (N1_y - MN1_y) + (N1_z - MN1_z) * (N1_z - MN1_z));
