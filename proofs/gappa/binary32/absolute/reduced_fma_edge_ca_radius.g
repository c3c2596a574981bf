# The error of lhs - rhs: edge_ca.radius of reduced, fma, binary32, on the absolute domain.
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
rr = rnd(r * r);
CA_x = rnd(a_x - c_x);
CA_y = rnd(a_y - c_y);
CA_z = rnd(a_z - c_z);
N3_x = rnd(c_y * a_z + (-rnd(c_z * a_y)));
N3_y = rnd(c_z * a_x + (-rnd(c_x * a_z)));
N3_z = rnd(c_x * a_y + (-rnd(c_y * a_x)));
e3 = rnd(CA_z * CA_z + rnd(CA_y * CA_y + rnd(CA_x * CA_x)));
lhs = rnd(N3_z * N3_z + rnd(N3_y * N3_y + rnd(N3_x * N3_x)));
rhs = rnd(rr * e3);
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mc_x = Cx - Px;
Mc_y = Cy - Py;
Mc_z = Cz - Pz;
Mrr = r * r;
MCA_x = Ma_x - Mc_x;
MCA_y = Ma_y - Mc_y;
MCA_z = Ma_z - Mc_z;
MN3_x = Mc_y * Ma_z + (-(Mc_z * Ma_y));
MN3_y = Mc_z * Ma_x + (-(Mc_x * Ma_z));
MN3_z = Mc_x * Ma_y + (-(Mc_y * Ma_x));
Me3 = MCA_z * MCA_z + (MCA_y * MCA_y + MCA_x * MCA_x);
Mlhs = MN3_z * MN3_z + (MN3_y * MN3_y + MN3_x * MN3_x);
Mrhs = Mrr * Me3;
product = N3_z * N3_z + (N3_y * N3_y + N3_x * N3_x);
by_N3 = MN3_z * (N3_z - MN3_z) + (MN3_y * (N3_y - MN3_y) + MN3_x * (N3_x - MN3_x));
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
  MN3_x in [-4,4] ->
  MN3_y in [-4,4] ->
  MN3_z in [-4,4] ->
  (|N3_x - MN3_x| <= 224b-28 /\ |N3_y - MN3_y| <= 224b-28 /\ |N3_z - MN3_z| <= 224b-28) /\
  (|by_N3| <= 2688b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 7873b-28)
}
rr ~ Mrr;
CA_x ~ MCA_x;
CA_y ~ MCA_y;
CA_z ~ MCA_z;
N3_x ~ MN3_x;
N3_y ~ MN3_y;
N3_z ~ MN3_z;
e3 ~ Me3;
lhs ~ Mlhs;
rhs ~ Mrhs;
Ma_x - Mc_x -> Ax - Cx;
Ma_y - Mc_y -> Ay - Cy;
Ma_z - Mc_z -> Az - Cz;
Mc_x - Ma_x -> Cx - Ax;
Mc_y - Ma_y -> Cy - Ay;
Mc_z - Ma_z -> Cz - Az;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_N3 + by_N3) + ((N3_x - MN3_x) * (N3_x - MN3_x) + (N3_y - MN3_y) * (N3_y - MN3_y) + (N3_z - MN3_z) * (N3_z - MN3_z));
