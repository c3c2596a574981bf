# The error of lhs - rhs: edge_ca.radius of published, fma, binary32, on the absolute domain.
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
ac = rnd(a_z * c_z + rnd(a_y * c_y + rnd(a_x * c_x)));
cc = rnd(c_z * c_z + rnd(c_y * c_y + rnd(c_x * c_x)));
d3 = rnd(ac - cc);
e3 = rnd(CA_z * CA_z + rnd(CA_y * CA_y + rnd(CA_x * CA_x)));
Q3_x = rnd(rnd(c_x * e3) - rnd(CA_x * d3));
Q3_y = rnd(rnd(c_y * e3) - rnd(CA_y * d3));
Q3_z = rnd(rnd(c_z * e3) - rnd(CA_z * d3));
lhs = rnd(Q3_z * Q3_z + rnd(Q3_y * Q3_y + rnd(Q3_x * Q3_x)));
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
Mac = Ma_z * Mc_z + (Ma_y * Mc_y + Ma_x * Mc_x);
Mcc = Mc_z * Mc_z + (Mc_y * Mc_y + Mc_x * Mc_x);
Md3 = Mac - Mcc;
Me3 = MCA_z * MCA_z + (MCA_y * MCA_y + MCA_x * MCA_x);
MQ3_x = Mc_x * Me3 - MCA_x * Md3;
MQ3_y = Mc_y * Me3 - MCA_y * Md3;
MQ3_z = Mc_z * Me3 - MCA_z * Md3;
Mlhs = MQ3_z * MQ3_z + (MQ3_y * MQ3_y + MQ3_x * MQ3_x);
Mrhs = Mrr * Me3 * Me3;
product = Q3_z * Q3_z + (Q3_y * Q3_y + Q3_x * Q3_x);
by_Q3 = MQ3_z * (Q3_z - MQ3_z) + (MQ3_y * (Q3_y - MQ3_y) + MQ3_x * (Q3_x - MQ3_x));
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
  (|Q3_x - MQ3_x| <= 5633b-28 /\ |Q3_y - MQ3_y| <= 5633b-28 /\ |Q3_z - MQ3_z| <= 5633b-28) /\
  (|by_Q3| <= 234164b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 517353b-28)
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
