# The error of lhs - rhs: edge_bc.radius of published, plain, binary32, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<24,-149,ne>;
r = rnd(r_);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
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
Flhs = FQ2_x * FQ2_x + FQ2_y * FQ2_y + FQ2_z * FQ2_z;
Frhs = Mrr * Fe2 * Fe2;
product = Q2_x * Q2_x + Q2_y * Q2_y + Q2_z * Q2_z;
by_Q2 = MQ2_x * (Q2_x - MQ2_x) + MQ2_y * (Q2_y - MQ2_y) + MQ2_z * (Q2_z - MQ2_z);
{
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
  |FQ2_x - MQ2_x| <= 24b-25 ->
  MQ2_y in [-8,8] ->
  FQ2_y in [-8,8] ->
  |FQ2_y - MQ2_y| <= 24b-25 ->
  MQ2_z in [-8,8] ->
  FQ2_z in [-8,8] ->
  |FQ2_z - MQ2_z| <= 24b-25 ->
  (|Q2_x - MQ2_x| <= 1633b-28 /\ |Q2_y - MQ2_y| <= 1633b-28 /\ |Q2_z - MQ2_z| <= 1633b-28) /\
  (|by_Q2| <= 22634b-28 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 74837b-28)
}
rr ~ Mrr;
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
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_Q2 + by_Q2) + ((Q2_x - MQ2_x) * (Q2_x - MQ2_x) + (Q2_y - MQ2_y) * (Q2_y - MQ2_y) + (Q2_z - MQ2_z) * (Q2_z - MQ2_z));
