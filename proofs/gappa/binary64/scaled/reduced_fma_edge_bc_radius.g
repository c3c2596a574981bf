# The error of lhs - rhs: edge_bc.radius of reduced, fma, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
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
N2_x = rnd(b_y * c_z + (-rnd(b_z * c_y)));
N2_y = rnd(b_z * c_x + (-rnd(b_x * c_z)));
N2_z = rnd(b_x * c_y + (-rnd(b_y * c_x)));
e2 = rnd(BC_z * BC_z + rnd(BC_y * BC_y + rnd(BC_x * BC_x)));
lhs = rnd(N2_z * N2_z + rnd(N2_y * N2_y + rnd(N2_x * N2_x)));
rhs = rnd(rr * e2);
Mrr = r * r;
MBC_x = Mc_x - Mb_x;
MBC_y = Mc_y - Mb_y;
MBC_z = Mc_z - Mb_z;
MN2_x = Mb_y * Mc_z + (-(Mb_z * Mc_y));
MN2_y = Mb_z * Mc_x + (-(Mb_x * Mc_z));
MN2_z = Mb_x * Mc_y + (-(Mb_y * Mc_x));
Me2 = MBC_z * MBC_z + (MBC_y * MBC_y + MBC_x * MBC_x);
Mlhs = MN2_z * MN2_z + (MN2_y * MN2_y + MN2_x * MN2_x);
Mrhs = Mrr * Me2;
FBC_x = c_x - b_x;
FBC_y = c_y - b_y;
FBC_z = c_z - b_z;
FN2_x = b_y * c_z + (-(b_z * c_y));
FN2_y = b_z * c_x + (-(b_x * c_z));
FN2_z = b_x * c_y + (-(b_y * c_x));
Fe2 = FBC_z * FBC_z + (FBC_y * FBC_y + FBC_x * FBC_x);
Flhs = FN2_z * FN2_z + (FN2_y * FN2_y + FN2_x * FN2_x);
Frhs = Mrr * Fe2;
product = N2_z * N2_z + (N2_y * N2_y + N2_x * N2_x);
by_N2 = MN2_z * (N2_z - MN2_z) + (MN2_y * (N2_y - MN2_y) + MN2_x * (N2_x - MN2_x));
{
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  MN2_x in [-2,2] ->
  FN2_x in [-2,2] ->
  |FN2_x - MN2_x| <= 4b-54 ->
  MN2_y in [-2,2] ->
  FN2_y in [-2,2] ->
  |FN2_y - MN2_y| <= 4b-54 ->
  MN2_z in [-2,2] ->
  FN2_z in [-2,2] ->
  |FN2_z - MN2_z| <= 4b-54 ->
  (|N2_x - MN2_x| <= 56b-57 /\ |N2_y - MN2_y| <= 56b-57 /\ |N2_z - MN2_z| <= 56b-57) /\
  (|by_N2| <= 224b-57 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 1569b-57)
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
N2_x ~ MN2_x;
N2_x ~ FN2_x;
FN2_x ~ MN2_x;
N2_y ~ MN2_y;
N2_y ~ FN2_y;
FN2_y ~ MN2_y;
N2_z ~ MN2_z;
N2_z ~ FN2_z;
FN2_z ~ MN2_z;
e2 ~ Me2;
e2 ~ Fe2;
Fe2 ~ Me2;
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_N2 + by_N2) + ((N2_x - MN2_x) * (N2_x - MN2_x) + (N2_y - MN2_y) * (N2_y - MN2_y) + (N2_z - MN2_z) * (N2_z - MN2_z));
