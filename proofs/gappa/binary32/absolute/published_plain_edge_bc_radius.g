# The error of lhs - rhs: edge_bc.radius of published, plain, binary32, on the absolute domain.
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
bb = rnd(rnd(rnd(b_x * b_x) + rnd(b_y * b_y)) + rnd(b_z * b_z));
bc = rnd(rnd(rnd(b_x * c_x) + rnd(b_y * c_y)) + rnd(b_z * c_z));
d2 = rnd(bc - bb);
e2 = rnd(rnd(rnd(BC_x * BC_x) + rnd(BC_y * BC_y)) + rnd(BC_z * BC_z));
Q2_x = rnd(rnd(b_x * e2) - rnd(BC_x * d2));
Q2_y = rnd(rnd(b_y * e2) - rnd(BC_y * d2));
Q2_z = rnd(rnd(b_z * e2) - rnd(BC_z * d2));
lhs = rnd(rnd(rnd(Q2_x * Q2_x) + rnd(Q2_y * Q2_y)) + rnd(Q2_z * Q2_z));
rhs = rnd(rnd(rr * e2) * e2);
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
Mbb = Mb_x * Mb_x + Mb_y * Mb_y + Mb_z * Mb_z;
Mbc = Mb_x * Mc_x + Mb_y * Mc_y + Mb_z * Mc_z;
Md2 = Mbc - Mbb;
Me2 = MBC_x * MBC_x + MBC_y * MBC_y + MBC_z * MBC_z;
MQ2_x = Mb_x * Me2 - MBC_x * Md2;
MQ2_y = Mb_y * Me2 - MBC_y * Md2;
MQ2_z = Mb_z * Me2 - MBC_z * Md2;
Mlhs = MQ2_x * MQ2_x + MQ2_y * MQ2_y + MQ2_z * MQ2_z;
Mrhs = Mrr * Me2 * Me2;
product = Q2_x * Q2_x + Q2_y * Q2_y + Q2_z * Q2_z;
by_Q2 = MQ2_x * (Q2_x - MQ2_x) + MQ2_y * (Q2_y - MQ2_y) + MQ2_z * (Q2_z - MQ2_z);
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
  Md2 in [-12,3] ->
  MQ2_x in [-16,16] ->
  MQ2_y in [-16,16] ->
  MQ2_z in [-16,16] ->
  (|Q2_x - MQ2_x| <= 6017b-28 /\ |Q2_y - MQ2_y| <= 6017b-28 /\ |Q2_z - MQ2_z| <= 6017b-28) /\
  (|by_Q2| <= 250127b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 559007b-28)
}
rr ~ Mrr;
BC_x ~ MBC_x;
BC_y ~ MBC_y;
BC_z ~ MBC_z;
bb ~ Mbb;
bc ~ Mbc;
d2 ~ Md2;
e2 ~ Me2;
Q2_x ~ MQ2_x;
Q2_y ~ MQ2_y;
Q2_z ~ MQ2_z;
lhs ~ Mlhs;
rhs ~ Mrhs;
Mc_x - Mb_x -> Cx - Bx;
Mc_y - Mb_y -> Cy - By;
Mc_z - Mb_z -> Cz - Bz;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_Q2 + by_Q2) + ((Q2_x - MQ2_x) * (Q2_x - MQ2_x) + (Q2_y - MQ2_y) * (Q2_y - MQ2_y) + (Q2_z - MQ2_z) * (Q2_z - MQ2_z));
