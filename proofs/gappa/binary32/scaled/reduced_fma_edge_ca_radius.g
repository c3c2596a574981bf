# The error of lhs - rhs: edge_ca.radius of reduced, fma, binary32, on the scaled domain.
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
N3_x = rnd(c_y * a_z + (-rnd(c_z * a_y)));
N3_y = rnd(c_z * a_x + (-rnd(c_x * a_z)));
N3_z = rnd(c_x * a_y + (-rnd(c_y * a_x)));
e3 = rnd(CA_z * CA_z + rnd(CA_y * CA_y + rnd(CA_x * CA_x)));
lhs = rnd(N3_z * N3_z + rnd(N3_y * N3_y + rnd(N3_x * N3_x)));
rhs = rnd(rr * e3);
Mrr = r * r;
MCA_x = Ma_x - Mc_x;
MCA_y = Ma_y - Mc_y;
MCA_z = Ma_z - Mc_z;
MN3_x = Mc_y * Ma_z + (-(Mc_z * Ma_y));
MN3_y = Mc_z * Ma_x + (-(Mc_x * Ma_z));
MN3_z = Mc_x * Ma_y + (-(Mc_y * Ma_x));
Me3 = MCA_z * MCA_z + (MCA_y * MCA_y + MCA_x * MCA_x);
Mlhs = MN3_z * MN3_z + (MN3_y * MN3_y + MN3_x * MN3_x);
Mrhs = Mrr * Me3;
FCA_x = a_x - c_x;
FCA_y = a_y - c_y;
FCA_z = a_z - c_z;
FN3_x = c_y * a_z + (-(c_z * a_y));
FN3_y = c_z * a_x + (-(c_x * a_z));
FN3_z = c_x * a_y + (-(c_y * a_x));
Fe3 = FCA_z * FCA_z + (FCA_y * FCA_y + FCA_x * FCA_x);
Flhs = FN3_z * FN3_z + (FN3_y * FN3_y + FN3_x * FN3_x);
Frhs = Mrr * Fe3;
product = N3_z * N3_z + (N3_y * N3_y + N3_x * N3_x);
by_N3 = MN3_z * (N3_z - MN3_z) + (MN3_y * (N3_y - MN3_y) + MN3_x * (N3_x - MN3_x));
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  MN3_x in [-2,2] ->
  FN3_x in [-2,2] ->
  |FN3_x - MN3_x| <= 4b-25 ->
  MN3_y in [-2,2] ->
  FN3_y in [-2,2] ->
  |FN3_y - MN3_y| <= 4b-25 ->
  MN3_z in [-2,2] ->
  FN3_z in [-2,2] ->
  |FN3_z - MN3_z| <= 4b-25 ->
  (|N3_x - MN3_x| <= 56b-28 /\ |N3_y - MN3_y| <= 56b-28 /\ |N3_z - MN3_z| <= 56b-28) /\
  (|by_N3| <= 224b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 1569b-28)
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
N3_x ~ MN3_x;
N3_x ~ FN3_x;
FN3_x ~ MN3_x;
N3_y ~ MN3_y;
N3_y ~ FN3_y;
FN3_y ~ MN3_y;
N3_z ~ MN3_z;
N3_z ~ FN3_z;
FN3_z ~ MN3_z;
e3 ~ Me3;
e3 ~ Fe3;
Fe3 ~ Me3;
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_N3 + by_N3) + ((N3_x - MN3_x) * (N3_x - MN3_x) + (N3_y - MN3_y) * (N3_y - MN3_y) + (N3_z - MN3_z) * (N3_z - MN3_z));
