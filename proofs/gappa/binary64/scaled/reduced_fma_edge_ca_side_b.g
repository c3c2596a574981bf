# The error of lhs - rhs: edge_ca.side_b of reduced, fma, binary64, on the scaled domain.
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
AB_x = rnd(b_x - a_x);
AB_y = rnd(b_y - a_y);
AB_z = rnd(b_z - a_z);
N3_x = rnd(c_y * a_z + (-rnd(c_z * a_y)));
N3_y = rnd(c_z * a_x + (-rnd(c_x * a_z)));
N3_z = rnd(c_x * a_y + (-rnd(c_y * a_x)));
AC_x = rnd(c_x - a_x);
AC_y = rnd(c_y - a_y);
AC_z = rnd(c_z - a_z);
V_x = rnd(AB_y * AC_z + (-rnd(AB_z * AC_y)));
V_y = rnd(AB_z * AC_x + (-rnd(AB_x * AC_z)));
V_z = rnd(AB_x * AC_y + (-rnd(AB_y * AC_x)));
rhs = rnd(N3_z * V_z + rnd(N3_y * V_y + rnd(N3_x * V_x)));
MAB_x = Mb_x - Ma_x;
MAB_y = Mb_y - Ma_y;
MAB_z = Mb_z - Ma_z;
MN3_x = Mc_y * Ma_z + (-(Mc_z * Ma_y));
MN3_y = Mc_z * Ma_x + (-(Mc_x * Ma_z));
MN3_z = Mc_x * Ma_y + (-(Mc_y * Ma_x));
MAC_x = Mc_x - Ma_x;
MAC_y = Mc_y - Ma_y;
MAC_z = Mc_z - Ma_z;
MV_x = MAB_y * MAC_z + (-(MAB_z * MAC_y));
MV_y = MAB_z * MAC_x + (-(MAB_x * MAC_z));
MV_z = MAB_x * MAC_y + (-(MAB_y * MAC_x));
Mrhs = MN3_z * MV_z + (MN3_y * MV_y + MN3_x * MV_x);
FAB_x = b_x - a_x;
FAB_y = b_y - a_y;
FAB_z = b_z - a_z;
FN3_x = c_y * a_z + (-(c_z * a_y));
FN3_y = c_z * a_x + (-(c_x * a_z));
FN3_z = c_x * a_y + (-(c_y * a_x));
FAC_x = c_x - a_x;
FAC_y = c_y - a_y;
FAC_z = c_z - a_z;
FV_x = FAB_y * FAC_z + (-(FAB_z * FAC_y));
FV_y = FAB_z * FAC_x + (-(FAB_x * FAC_z));
FV_z = FAB_x * FAC_y + (-(FAB_y * FAC_x));
Frhs = FN3_z * FV_z + (FN3_y * FV_y + FN3_x * FV_x);
product = N3_z * V_z + (N3_y * V_y + N3_x * V_x);
by_V = MN3_z * (V_z - MV_z) + (MN3_y * (V_y - MV_y) + MN3_x * (V_x - MV_x));
by_N3 = MV_z * (N3_z - MN3_z) + (MV_y * (N3_y - MN3_y) + MV_x * (N3_x - MN3_x));
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
  MV_x in [-4,4] ->
  FV_x in [-4,4] ->
  |FV_x - MV_x| <= 12b-54 ->
  MV_y in [-4,4] ->
  FV_y in [-4,4] ->
  |FV_y - MV_y| <= 12b-54 ->
  MV_z in [-4,4] ->
  FV_z in [-4,4] ->
  |FV_z - MV_z| <= 12b-54 ->
  MN3_x in [-2,2] ->
  FN3_x in [-2,2] ->
  |FN3_x - MN3_x| <= 4b-54 ->
  MN3_y in [-2,2] ->
  FN3_y in [-2,2] ->
  |FN3_y - MN3_y| <= 4b-54 ->
  MN3_z in [-2,2] ->
  FN3_z in [-2,2] ->
  |FN3_z - MN3_z| <= 4b-54 ->
  (|V_x - MV_x| <= 320b-57 /\ |V_y - MV_y| <= 320b-57 /\ |V_z - MV_z| <= 320b-57) /\
  (|by_V| <= 1280b-57 ->
  |rhs - Mrhs| <= 2593b-57)
}
AB_x ~ MAB_x;
AB_x ~ FAB_x;
FAB_x ~ MAB_x;
AB_y ~ MAB_y;
AB_y ~ FAB_y;
FAB_y ~ MAB_y;
AB_z ~ MAB_z;
AB_z ~ FAB_z;
FAB_z ~ MAB_z;
N3_x ~ MN3_x;
N3_x ~ FN3_x;
FN3_x ~ MN3_x;
N3_y ~ MN3_y;
N3_y ~ FN3_y;
FN3_y ~ MN3_y;
N3_z ~ MN3_z;
N3_z ~ FN3_z;
FN3_z ~ MN3_z;
AC_x ~ MAC_x;
AC_x ~ FAC_x;
FAC_x ~ MAC_x;
AC_y ~ MAC_y;
AC_y ~ FAC_y;
FAC_y ~ MAC_y;
AC_z ~ MAC_z;
AC_z ~ FAC_z;
FAC_z ~ MAC_z;
V_x ~ MV_x;
V_x ~ FV_x;
FV_x ~ MV_x;
V_y ~ MV_y;
V_y ~ FV_y;
FV_y ~ MV_y;
V_z ~ MV_z;
V_z ~ FV_z;
FV_z ~ MV_z;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
rhs ~ product;
rhs - Mrhs -> (rhs - product) + (product - Mrhs);
product - Mrhs -> (by_V + by_N3) + ((N3_x - MN3_x) * (V_x - MV_x) + (N3_y - MN3_y) * (V_y - MV_y) + (N3_z - MN3_z) * (V_z - MV_z));
