# The error of lhs - rhs: edge_ca.radius of published, fma, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
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
ac = rnd(a_z * c_z + rnd(a_y * c_y + rnd(a_x * c_x)));
cc = rnd(c_z * c_z + rnd(c_y * c_y + rnd(c_x * c_x)));
d3 = rnd(ac - cc);
e3 = rnd(CA_z * CA_z + rnd(CA_y * CA_y + rnd(CA_x * CA_x)));
Q3_x = rnd(rnd(c_x * e3) - rnd(CA_x * d3));
Q3_y = rnd(rnd(c_y * e3) - rnd(CA_y * d3));
Q3_z = rnd(rnd(c_z * e3) - rnd(CA_z * d3));
lhs = rnd(Q3_z * Q3_z + rnd(Q3_y * Q3_y + rnd(Q3_x * Q3_x)));
rhs = rnd(rnd(rr * e3) * e3);
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
Flhs = FQ3_z * FQ3_z + (FQ3_y * FQ3_y + FQ3_x * FQ3_x);
Frhs = Mrr * Fe3 * Fe3;
product = Q3_z * Q3_z + (Q3_y * Q3_y + Q3_x * Q3_x);
by_Q3 = MQ3_z * (Q3_z - MQ3_z) + (MQ3_y * (Q3_y - MQ3_y) + MQ3_x * (Q3_x - MQ3_x));
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
  |FQ3_x - MQ3_x| <= 24b-54 ->
  MQ3_y in [-8,8] ->
  FQ3_y in [-8,8] ->
  |FQ3_y - MQ3_y| <= 24b-54 ->
  MQ3_z in [-8,8] ->
  FQ3_z in [-8,8] ->
  |FQ3_z - MQ3_z| <= 24b-54 ->
  (|Q3_x - MQ3_x| <= 1505b-57 /\ |Q3_y - MQ3_y| <= 1505b-57 /\ |Q3_z - MQ3_z| <= 1505b-57) /\
  (|by_Q3| <= 20860b-57 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 67705b-57)
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
