# The error of lhs - rhs: edge_bc.side_a of published, plain, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
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
QA_x = rnd(rnd(a_x * e2) - Q2_x);
QA_y = rnd(rnd(a_y * e2) - Q2_y);
QA_z = rnd(rnd(a_z * e2) - Q2_z);
lhs = rnd(rnd(rnd(Q2_x * QA_x) + rnd(Q2_y * QA_y)) + rnd(Q2_z * QA_z));
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
MQA_x = Ma_x * Me2 - MQ2_x;
MQA_y = Ma_y * Me2 - MQ2_y;
MQA_z = Ma_z * Me2 - MQ2_z;
Mlhs = MQ2_x * MQA_x + MQ2_y * MQA_y + MQ2_z * MQA_z;
FBC_x = c_x - b_x;
FBC_y = c_y - b_y;
FBC_z = c_z - b_z;
Fbb = b_x * b_x + b_y * b_y + b_z * b_z;
Fbc = b_x * c_x + b_y * c_y + b_z * c_z;
Fd2 = Fbc - Fbb;
Fe2 = FBC_x * FBC_x + FBC_y * FBC_y + FBC_z * FBC_z;
FQ2_x = b_x * Fe2 - FBC_x * Fd2;
FQ2_y = b_y * Fe2 - FBC_y * Fd2;
FQ2_z = b_z * Fe2 - FBC_z * Fd2;
FQA_x = a_x * Fe2 - FQ2_x;
FQA_y = a_y * Fe2 - FQ2_y;
FQA_z = a_z * Fe2 - FQ2_z;
Flhs = FQ2_x * FQA_x + FQ2_y * FQA_y + FQ2_z * FQA_z;
product = Q2_x * QA_x + Q2_y * QA_y + Q2_z * QA_z;
by_QA = MQ2_x * (QA_x - MQA_x) + MQ2_y * (QA_y - MQA_y) + MQ2_z * (QA_z - MQA_z);
by_Q2 = MQA_x * (Q2_x - MQ2_x) + MQA_y * (Q2_y - MQ2_y) + MQA_z * (Q2_z - MQ2_z);
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  Md2 in [-6,0.75] ->
  Fd2 in [-6,0.75] ->
  MQ2_x in [-8,8] ->
  FQ2_x in [-8,8] ->
  |FQ2_x - MQ2_x| <= 24b-54 ->
  MQ2_y in [-8,8] ->
  FQ2_y in [-8,8] ->
  |FQ2_y - MQ2_y| <= 24b-54 ->
  MQ2_z in [-8,8] ->
  FQ2_z in [-8,8] ->
  |FQ2_z - MQ2_z| <= 24b-54 ->
  MQA_x in [-16,16] ->
  FQA_x in [-16,16] ->
  |FQA_x - MQA_x| <= 60b-54 ->
  MQA_y in [-16,16] ->
  FQA_y in [-16,16] ->
  |FQA_y - MQA_y| <= 60b-54 ->
  MQA_z in [-16,16] ->
  FQA_z in [-16,16] ->
  |FQA_z - MQA_z| <= 60b-54 ->
  (|QA_x - MQA_x| <= 2849b-57 /\ |QA_y - MQA_y| <= 2849b-57 /\ |QA_z - MQA_z| <= 2849b-57) /\
  (|by_QA| <= 39488b-57 ->
  |lhs - Mlhs| <= 132161b-57)
}
BC_x ~ MBC_x;
BC_x ~ FBC_x;
FBC_x ~ MBC_x;
BC_y ~ MBC_y;
BC_y ~ FBC_y;
FBC_y ~ MBC_y;
BC_z ~ MBC_z;
BC_z ~ FBC_z;
FBC_z ~ MBC_z;
bb ~ Mbb;
bb ~ Fbb;
Fbb ~ Mbb;
bc ~ Mbc;
bc ~ Fbc;
Fbc ~ Mbc;
d2 ~ Md2;
d2 ~ Fd2;
Fd2 ~ Md2;
e2 ~ Me2;
e2 ~ Fe2;
Fe2 ~ Me2;
Q2_x ~ MQ2_x;
Q2_x ~ FQ2_x;
FQ2_x ~ MQ2_x;
Q2_y ~ MQ2_y;
Q2_y ~ FQ2_y;
FQ2_y ~ MQ2_y;
Q2_z ~ MQ2_z;
Q2_z ~ FQ2_z;
FQ2_z ~ MQ2_z;
QA_x ~ MQA_x;
QA_x ~ FQA_x;
FQA_x ~ MQA_x;
QA_y ~ MQA_y;
QA_y ~ FQA_y;
FQA_y ~ MQA_y;
QA_z ~ MQA_z;
QA_z ~ FQA_z;
FQA_z ~ MQA_z;
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_QA + by_Q2) + ((Q2_x - MQ2_x) * (QA_x - MQA_x) + (Q2_y - MQ2_y) * (QA_y - MQA_y) + (Q2_z - MQ2_z) * (QA_z - MQA_z));
