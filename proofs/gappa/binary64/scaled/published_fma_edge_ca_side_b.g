# The error of lhs - rhs: edge_ca.side_b of published, fma, binary64, on the scaled domain.
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
FCA_x = a_x - c_x;
FCA_y = a_y - c_y;
FCA_z = a_z - c_z;
Fac = a_z * c_z + (a_y * c_y + a_x * c_x);
Fcc = c_z * c_z + (c_y * c_y + c_x * c_x);
Fd3 = Fac - Fcc;
Fe3 = FCA_z * FCA_z + (FCA_y * FCA_y + FCA_x * FCA_x);
FQ3_x = c_x * Fe3 - FCA_x * Fd3;
FQ3_y = c_y * Fe3 - FCA_y * Fd3;
FQ3_z = c_z * Fe3 - FCA_z * Fd3;
FQB_x = b_x * Fe3 - FQ3_x;
FQB_y = b_y * Fe3 - FQ3_y;
FQB_z = b_z * Fe3 - FQ3_z;
Flhs = FQ3_z * FQB_z + (FQ3_y * FQB_y + FQ3_x * FQB_x);
product = Q3_z * QB_z + (Q3_y * QB_y + Q3_x * QB_x);
by_QB = MQ3_z * (QB_z - MQB_z) + (MQ3_y * (QB_y - MQB_y) + MQ3_x * (QB_x - MQB_x));
by_Q3 = MQB_z * (Q3_z - MQ3_z) + (MQB_y * (Q3_y - MQ3_y) + MQB_x * (Q3_x - MQ3_x));
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
  Md3 in [-6,0.75] ->
  Fd3 in [-6,0.75] ->
  MQ3_x in [-8,8] ->
  FQ3_x in [-8,8] ->
  |FQ3_x - MQ3_x| <= 24b-54 ->
  MQ3_y in [-8,8] ->
  FQ3_y in [-8,8] ->
  |FQ3_y - MQ3_y| <= 24b-54 ->
  MQ3_z in [-8,8] ->
  FQ3_z in [-8,8] ->
  |FQ3_z - MQ3_z| <= 24b-54 ->
  MQB_x in [-16,16] ->
  FQB_x in [-16,16] ->
  |FQB_x - MQB_x| <= 60b-54 ->
  MQB_y in [-16,16] ->
  FQB_y in [-16,16] ->
  |FQB_y - MQB_y| <= 60b-54 ->
  MQB_z in [-16,16] ->
  FQB_z in [-16,16] ->
  |FQB_z - MQB_z| <= 60b-54 ->
  (|QB_x - MQB_x| <= 2657b-57 /\ |QB_y - MQB_y| <= 2657b-57 /\ |QB_z - MQB_z| <= 2657b-57) /\
  (|by_QB| <= 36827b-57 ->
  |lhs - Mlhs| <= 119260b-57)
}
CA_x ~ MCA_x;
CA_x ~ FCA_x;
FCA_x ~ MCA_x;
CA_y ~ MCA_y;
CA_y ~ FCA_y;
FCA_y ~ MCA_y;
CA_z ~ MCA_z;
CA_z ~ FCA_z;
FCA_z ~ MCA_z;
ac ~ Mac;
ac ~ Fac;
Fac ~ Mac;
cc ~ Mcc;
cc ~ Fcc;
Fcc ~ Mcc;
d3 ~ Md3;
d3 ~ Fd3;
Fd3 ~ Md3;
e3 ~ Me3;
e3 ~ Fe3;
Fe3 ~ Me3;
Q3_x ~ MQ3_x;
Q3_x ~ FQ3_x;
FQ3_x ~ MQ3_x;
Q3_y ~ MQ3_y;
Q3_y ~ FQ3_y;
FQ3_y ~ MQ3_y;
Q3_z ~ MQ3_z;
Q3_z ~ FQ3_z;
FQ3_z ~ MQ3_z;
QB_x ~ MQB_x;
QB_x ~ FQB_x;
FQB_x ~ MQB_x;
QB_y ~ MQB_y;
QB_y ~ FQB_y;
FQB_y ~ MQB_y;
QB_z ~ MQB_z;
QB_z ~ FQB_z;
FQB_z ~ MQB_z;
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_QB + by_Q3) + ((Q3_x - MQ3_x) * (QB_x - MQB_x) + (Q3_y - MQ3_y) * (QB_y - MQB_y) + (Q3_z - MQ3_z) * (QB_z - MQB_z));
