# The error of lhs - rhs: edge_ca.radius of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
a_x = rnd(Ma_x);
a_y = rnd(Ma_y);
a_z = rnd(Ma_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
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
FCA_x = a_x - c_x;
FCA_y = a_y - c_y;
FCA_z = a_z - c_z;
Fac = a_x * c_x + a_y * c_y + a_z * c_z;
Fcc = c_x * c_x + c_y * c_y + c_z * c_z;
Fd3 = Fac - Fcc;
Fe3 = FCA_x * FCA_x + FCA_y * FCA_y + FCA_z * FCA_z;
FQ3_x = c_x * Fe3 - FCA_x * Fd3;
FQ3_y = c_y * Fe3 - FCA_y * Fd3;
FQ3_z = c_z * Fe3 - FCA_z * Fd3;
Flhs = FQ3_x * FQ3_x + FQ3_y * FQ3_y + FQ3_z * FQ3_z;
Frhs = Mrr * Fe3 * Fe3;
product = Q3_x * Q3_x + Q3_y * Q3_y + Q3_z * Q3_z;
by_Q3 = MQ3_x * (Q3_x - MQ3_x) + MQ3_y * (Q3_y - MQ3_y) + MQ3_z * (Q3_z - MQ3_z);
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  Md3 in [-6,0.75] ->
  Fd3 in [-6,0.75] ->
  MQ3_x in [-8,8] ->
  FQ3_x in [-8,8] ->
  |FQ3_x - MQ3_x| <= 24b-25 ->
  MQ3_y in [-8,8] ->
  FQ3_y in [-8,8] ->
  |FQ3_y - MQ3_y| <= 24b-25 ->
  MQ3_z in [-8,8] ->
  FQ3_z in [-8,8] ->
  |FQ3_z - MQ3_z| <= 24b-25 ->
  (|Q3_x - MQ3_x| <= 1633b-28 /\ |Q3_y - MQ3_y| <= 1633b-28 /\ |Q3_z - MQ3_z| <= 1633b-28) /\
  (|by_Q3| <= 22634b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 74837b-28)
}
rr ~ Mrr;
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
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_Q3 + by_Q3) + ((Q3_x - MQ3_x) * (Q3_x - MQ3_x) + (Q3_y - MQ3_y) * (Q3_y - MQ3_y) + (Q3_z - MQ3_z) * (Q3_z - MQ3_z));
