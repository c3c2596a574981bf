# The error of lhs - rhs: edge_ab.radius of reduced, plain, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
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
N1_x = rnd(rnd(a_y * b_z) - rnd(a_z * b_y));
N1_y = rnd(rnd(a_z * b_x) - rnd(a_x * b_z));
N1_z = rnd(rnd(a_x * b_y) - rnd(a_y * b_x));
e1 = rnd(rnd(rnd(AB_x * AB_x) + rnd(AB_y * AB_y)) + rnd(AB_z * AB_z));
lhs = rnd(rnd(rnd(N1_x * N1_x) + rnd(N1_y * N1_y)) + rnd(N1_z * N1_z));
rhs = rnd(rr * e1);
Mrr = r * r;
MAB_x = Mb_x - Ma_x;
MAB_y = Mb_y - Ma_y;
MAB_z = Mb_z - Ma_z;
MN1_x = Ma_y * Mb_z - Ma_z * Mb_y;
MN1_y = Ma_z * Mb_x - Ma_x * Mb_z;
MN1_z = Ma_x * Mb_y - Ma_y * Mb_x;
Me1 = MAB_x * MAB_x + MAB_y * MAB_y + MAB_z * MAB_z;
Mlhs = MN1_x * MN1_x + MN1_y * MN1_y + MN1_z * MN1_z;
Mrhs = Mrr * Me1;
FAB_x = b_x - a_x;
FAB_y = b_y - a_y;
FAB_z = b_z - a_z;
FN1_x = a_y * b_z - a_z * b_y;
FN1_y = a_z * b_x - a_x * b_z;
FN1_z = a_x * b_y - a_y * b_x;
Fe1 = FAB_x * FAB_x + FAB_y * FAB_y + FAB_z * FAB_z;
Flhs = FN1_x * FN1_x + FN1_y * FN1_y + FN1_z * FN1_z;
Frhs = Mrr * Fe1;
product = N1_x * N1_x + N1_y * N1_y + N1_z * N1_z;
by_N1 = MN1_x * (N1_x - MN1_x) + MN1_y * (N1_y - MN1_y) + MN1_z * (N1_z - MN1_z);
{
  Ma_x in [-1,1] ->
  Ma_y in [-1,1] ->
  Ma_z in [-1,1] ->
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  r in [0,1] ->
  MN1_x in [-2,2] ->
  FN1_x in [-2,2] ->
  |FN1_x - MN1_x| <= 4b-54 ->
  MN1_y in [-2,2] ->
  FN1_y in [-2,2] ->
  |FN1_y - MN1_y| <= 4b-54 ->
  MN1_z in [-2,2] ->
  FN1_z in [-2,2] ->
  |FN1_z - MN1_z| <= 4b-54 ->
  (|N1_x - MN1_x| <= 64b-57 /\ |N1_y - MN1_y| <= 64b-57 /\ |N1_z - MN1_z| <= 64b-57) /\
  (|by_N1| <= 256b-57 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 1761b-57)
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
N1_x ~ MN1_x;
N1_x ~ FN1_x;
FN1_x ~ MN1_x;
N1_y ~ MN1_y;
N1_y ~ FN1_y;
FN1_y ~ MN1_y;
N1_z ~ MN1_z;
N1_z ~ FN1_z;
FN1_z ~ MN1_z;
e1 ~ Me1;
e1 ~ Fe1;
Fe1 ~ Me1;
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
lhs ~ product;
lhs - Mlhs -> (lhs - product) + (product - Mlhs);
product - Mlhs -> (by_N1 + by_N1) + ((N1_x - MN1_x) * (N1_x - MN1_x) + (N1_y - MN1_y) * (N1_y - MN1_y) + (N1_z - MN1_z) * (N1_z - MN1_z));
