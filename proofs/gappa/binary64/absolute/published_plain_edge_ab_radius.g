# The error of lhs - rhs: edge_ab.radius of published, plain, binary64, on the absolute domain.
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
rr = rnd(r * r);
AB_x = rnd(b_x - a_x);
AB_y = rnd(b_y - a_y);
AB_z = rnd(b_z - a_z);
aa = rnd(rnd(rnd(a_x * a_x) + rnd(a_y * a_y)) + rnd(a_z * a_z));
ab = rnd(rnd(rnd(a_x * b_x) + rnd(a_y * b_y)) + rnd(a_z * b_z));
d1 = rnd(ab - aa);
e1 = rnd(rnd(rnd(AB_x * AB_x) + rnd(AB_y * AB_y)) + rnd(AB_z * AB_z));
Q1_x = rnd(rnd(a_x * e1) - rnd(AB_x * d1));
Q1_y = rnd(rnd(a_y * e1) - rnd(AB_y * d1));
Q1_z = rnd(rnd(a_z * e1) - rnd(AB_z * d1));
lhs = rnd(rnd(rnd(Q1_x * Q1_x) + rnd(Q1_y * Q1_y)) + rnd(Q1_z * Q1_z));
rhs = rnd(rnd(rr * e1) * e1);
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
Maa = Ma_x * Ma_x + Ma_y * Ma_y + Ma_z * Ma_z;
Mab = Ma_x * Mb_x + Ma_y * Mb_y + Ma_z * Mb_z;
Md1 = Mab - Maa;
Me1 = MAB_x * MAB_x + MAB_y * MAB_y + MAB_z * MAB_z;
MQ1_x = Ma_x * Me1 - MAB_x * Md1;
MQ1_y = Ma_y * Me1 - MAB_y * Md1;
MQ1_z = Ma_z * Me1 - MAB_z * Md1;
Mlhs = MQ1_x * MQ1_x + MQ1_y * MQ1_y + MQ1_z * MQ1_z;
Mrhs = Mrr * Me1 * Me1;
product = Q1_x * Q1_x + Q1_y * Q1_y + Q1_z * Q1_z;
by_Q1 = MQ1_x * (Q1_x - MQ1_x) + MQ1_y * (Q1_y - MQ1_y) + MQ1_z * (Q1_z - MQ1_z);
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
  Md1 in [-12,3] ->
  MQ1_x in [-16,16] ->
  MQ1_y in [-16,16] ->
  MQ1_z in [-16,16] ->
  (|Q1_x - MQ1_x| <= 6017b-57 /\ |Q1_y - MQ1_y| <= 6017b-57 /\ |Q1_z - MQ1_z| <= 6017b-57) /\
  (|by_Q1| <= 250127b-57 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 559007b-57)
}
rr ~ Mrr;
AB_x ~ MAB_x;
AB_y ~ MAB_y;
AB_z ~ MAB_z;
aa ~ Maa;
ab ~ Mab;
d1 ~ Md1;
e1 ~ Me1;
Q1_x ~ MQ1_x;
Q1_y ~ MQ1_y;
Q1_z ~ MQ1_z;
lhs ~ Mlhs;
rhs ~ Mrhs;
Mb_x - Ma_x -> Bx - Ax;
Mb_y - Ma_y -> By - Ay;
Mb_z - Ma_z -> Bz - Az;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_Q1 + by_Q1) + ((Q1_x - MQ1_x) * (Q1_x - MQ1_x) + (Q1_y - MQ1_y) * (Q1_y - MQ1_y) + (Q1_z - MQ1_z) * (Q1_z - MQ1_z));
