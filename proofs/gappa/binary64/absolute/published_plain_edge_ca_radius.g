# The error of lhs - rhs: edge_ca.radius of published, plain, binary64, on the absolute domain.
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
c_x = rnd(Cx - Px);
c_y = rnd(Cy - Py);
c_z = rnd(Cz - Pz);
rr = rnd(r * r);
CA_x = rnd(a_x - c_x);
CA_y = rnd(a_y - c_y);
CA_z = rnd(a_z - c_z);
ac = rnd(rnd(rnd(a_x * c_x) + rnd(a_y * c_y)) + rnd(a_z * c_z));
cc = rnd(rnd(rnd(c_x * c_x) + rnd(c_y * c_y)) + rnd(c_z * c_z));
d3 = rnd(ac - cc);
e3 = rnd(rnd(rnd(CA_x * CA_x) + rnd(CA_y * CA_y)) + rnd(CA_z * CA_z));
Q3_x = rnd(rnd(c_x * e3) - rnd(CA_x * d3));
Q3_y = rnd(rnd(c_y * e3) - rnd(CA_y * d3));
Q3_z = rnd(rnd(c_z * e3) - rnd(CA_z * d3));
lhs = rnd(rnd(rnd(Q3_x * Q3_x) + rnd(Q3_y * Q3_y)) + rnd(Q3_z * Q3_z));
rhs = rnd(rnd(rr * e3) * e3);
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
Mac = Ma_x * Mc_x + Ma_y * Mc_y + Ma_z * Mc_z;
Mcc = Mc_x * Mc_x + Mc_y * Mc_y + Mc_z * Mc_z;
Md3 = Mac - Mcc;
Me3 = MCA_x * MCA_x + MCA_y * MCA_y + MCA_z * MCA_z;
MQ3_x = Mc_x * Me3 - MCA_x * Md3;
MQ3_y = Mc_y * Me3 - MCA_y * Md3;
MQ3_z = Mc_z * Me3 - MCA_z * Md3;
Mlhs = MQ3_x * MQ3_x + MQ3_y * MQ3_y + MQ3_z * MQ3_z;
Mrhs = Mrr * Me3 * Me3;
product = Q3_x * Q3_x + Q3_y * Q3_y + Q3_z * Q3_z;
by_Q3 = MQ3_x * (Q3_x - MQ3_x) + MQ3_y * (Q3_y - MQ3_y) + MQ3_z * (Q3_z - MQ3_z);
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
  (|Q3_x - MQ3_x| <= 6017b-57 /\ |Q3_y - MQ3_y| <= 6017b-57 /\ |Q3_z - MQ3_z| <= 6017b-57) /\
  (|by_Q3| <= 250127b-57 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 559007b-57)
}
rr ~ Mrr;
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
product - Mlhs -> (by_Q3 + by_Q3) + ((Q3_x - MQ3_x) * (Q3_x - MQ3_x) + (Q3_y - MQ3_y) * (Q3_y - MQ3_y) + (Q3_z - MQ3_z) * (Q3_z - MQ3_z));
