# The error of lhs - rhs: edge_ab.radius of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
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
FAB_x = b_x - a_x;
FAB_y = b_y - a_y;
FAB_z = b_z - a_z;
Faa = a_x * a_x + a_y * a_y + a_z * a_z;
Fab = a_x * b_x + a_y * b_y + a_z * b_z;
Fd1 = Fab - Faa;
Fe1 = FAB_x * FAB_x + FAB_y * FAB_y + FAB_z * FAB_z;
FQ1_x = a_x * Fe1 - FAB_x * Fd1;
FQ1_y = a_y * Fe1 - FAB_y * Fd1;
FQ1_z = a_z * Fe1 - FAB_z * Fd1;
Flhs = FQ1_x * FQ1_x + FQ1_y * FQ1_y + FQ1_z * FQ1_z;
Frhs = Mrr * Fe1 * Fe1;
product = Q1_x * Q1_x + Q1_y * Q1_y + Q1_z * Q1_z;
by_Q1 = MQ1_x * (Q1_x - MQ1_x) + MQ1_y * (Q1_y - MQ1_y) + MQ1_z * (Q1_z - MQ1_z);
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  r in [0,1] ->
  Md1 in [-6,0.75] ->
  Fd1 in [-6,0.75] ->
  MQ1_x in [-8,8] ->
  FQ1_x in [-8,8] ->
  |FQ1_x - MQ1_x| <= 24b-25 ->
  MQ1_y in [-8,8] ->
  FQ1_y in [-8,8] ->
  |FQ1_y - MQ1_y| <= 24b-25 ->
  MQ1_z in [-8,8] ->
  FQ1_z in [-8,8] ->
  |FQ1_z - MQ1_z| <= 24b-25 ->
  (|Q1_x - MQ1_x| <= 1633b-28 /\ |Q1_y - MQ1_y| <= 1633b-28 /\ |Q1_z - MQ1_z| <= 1633b-28) /\
  (|by_Q1| <= 22634b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 74837b-28)
}
rr ~ Mrr;
AB_x ~ MAB_x;
AB_x ~ FAB_x;
FAB_x ~ MAB_x;
AB_y ~ MAB_y;
AB_y ~ FAB_y;
FAB_y ~ MAB_y;
AB_z ~ MAB_z;
AB_z ~ FAB_z;
FAB_z ~ MAB_z;
aa ~ Maa;
aa ~ Faa;
Faa ~ Maa;
ab ~ Mab;
ab ~ Fab;
Fab ~ Mab;
d1 ~ Md1;
d1 ~ Fd1;
Fd1 ~ Md1;
e1 ~ Me1;
e1 ~ Fe1;
Fe1 ~ Me1;
Q1_x ~ MQ1_x;
Q1_x ~ FQ1_x;
FQ1_x ~ MQ1_x;
Q1_y ~ MQ1_y;
Q1_y ~ FQ1_y;
FQ1_y ~ MQ1_y;
Q1_z ~ MQ1_z;
Q1_z ~ FQ1_z;
FQ1_z ~ MQ1_z;
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_Q1 + by_Q1) + ((Q1_x - MQ1_x) * (Q1_x - MQ1_x) + (Q1_y - MQ1_y) * (Q1_y - MQ1_y) + (Q1_z - MQ1_z) * (Q1_z - MQ1_z));
