# The error of lhs - rhs: edge_ca.side_b of published, fma, binary64, on the absolute domain.
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
CA_x = rnd(a_x - c_x);
CA_y = rnd(a_y - c_y);
CA_z = rnd(a_z - c_z);
ac = rnd(a_z * c_z + rnd(a_y * c_y + rnd(a_x * c_x)));
cc = rnd(c_z * c_z + rnd(c_y * c_y + rnd(c_x * c_x)));
d3 = rnd(ac - cc);
e3 = rnd(CA_z * CA_z + rnd(CA_y * CA_y + rnd(CA_x * CA_x)));
Q3_x = rnd(rnd(c_x * e3) - rnd(CA_x * d3));
Q3_y = rnd(rnd(c_y * e3) - rnd(CA_y * d3));
Q3_z = rnd(rnd(c_z * e3) - rnd(CA_z * d3));
QB_x = rnd(rnd(b_x * e3) - Q3_x);
QB_y = rnd(rnd(b_y * e3) - Q3_y);
QB_z = rnd(rnd(b_z * e3) - Q3_z);
lhs = rnd(Q3_z * QB_z + rnd(Q3_y * QB_y + rnd(Q3_x * QB_x)));
Ma_x = Ax - Px;
Ma_y = Ay - Py;
Ma_z = Az - Pz;
Mb_x = Bx - Px;
Mb_y = By - Py;
Mb_z = Bz - Pz;
Mc_x = Cx - Px;
Mc_y = Cy - Py;
Mc_z = Cz - Pz;
MCA_x = Ma_x - Mc_x;
MCA_y = Ma_y - Mc_y;
MCA_z = Ma_z - Mc_z;
Mac = Ma_z * Mc_z + (Ma_y * Mc_y + Ma_x * Mc_x);
Mcc = Mc_z * Mc_z + (Mc_y * Mc_y + Mc_x * Mc_x);
Md3 = Mac - Mcc;
Me3 = MCA_z * MCA_z + (MCA_y * MCA_y + MCA_x * MCA_x);
MQ3_x = Mc_x * Me3 - MCA_x * Md3;
MQ3_y = Mc_y * Me3 - MCA_y * Md3;
MQ3_z = Mc_z * Me3 - MCA_z * Md3;
MQB_x = Mb_x * Me3 - MQ3_x;
MQB_y = Mb_y * Me3 - MQ3_y;
MQB_z = Mb_z * Me3 - MQ3_z;
Mlhs = MQ3_z * MQB_z + (MQ3_y * MQB_y + MQ3_x * MQB_x);
product = Q3_z * QB_z + (Q3_y * QB_y + Q3_x * QB_x);
by_QB = MQ3_z * (QB_z - MQB_z) + (MQ3_y * (QB_y - MQB_y) + MQ3_x * (QB_x - MQB_x));
by_Q3 = MQB_z * (Q3_z - MQ3_z) + (MQB_y * (Q3_y - MQ3_y) + MQB_x * (Q3_x - MQ3_x));
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
  Md3 in [-12,3] ->
  MQ3_x in [-16,16] ->
  MQ3_y in [-16,16] ->
  MQ3_z in [-16,16] ->
  (|QB_x - MQB_x| <= 8577b-57 /\ |QB_y - MQB_y| <= 8577b-57 /\ |QB_z - MQB_z| <= 8577b-57) /\
  (|by_QB| <= 356546b-57 ->
  |lhs - Mlhs| <= 1073347b-57)
}
CA_x ~ MCA_x;
CA_y ~ MCA_y;
CA_z ~ MCA_z;
ac ~ Mac;
cc ~ Mcc;
d3 ~ Md3;
e3 ~ Me3;
Q3_x ~ MQ3_x;
Q3_y ~ MQ3_y;
Q3_z ~ MQ3_z;
QB_x ~ MQB_x;
QB_y ~ MQB_y;
QB_z ~ MQB_z;
lhs ~ Mlhs;
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
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_QB + by_Q3) + ((Q3_x - MQ3_x) * (QB_x - MQB_x) + (Q3_y - MQ3_y) * (QB_y - MQB_y) + (Q3_z - MQ3_z) * (QB_z - MQB_z));
