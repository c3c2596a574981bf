# The error of lhs - rhs: edge_bc.side_a of reduced, fma, binary64, on the scaled domain.
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
N2_x = rnd(b_y * c_z + (-rnd(b_z * c_y)));
N2_y = rnd(b_z * c_x + (-rnd(b_x * c_z)));
N2_z = rnd(b_x * c_y + (-rnd(b_y * c_x)));
AC_x = rnd(c_x - a_x);
AC_y = rnd(c_y - a_y);
AC_z = rnd(c_z - a_z);
V_x = rnd(AB_y * AC_z + (-rnd(AB_z * AC_y)));
V_y = rnd(AB_z * AC_x + (-rnd(AB_x * AC_z)));
V_z = rnd(AB_x * AC_y + (-rnd(AB_y * AC_x)));
rhs = rnd(N2_z * V_z + rnd(N2_y * V_y + rnd(N2_x * V_x)));
MAB_x = Mb_x - Ma_x;
MAB_y = Mb_y - Ma_y;
MAB_z = Mb_z - Ma_z;
MN2_x = Mb_y * Mc_z + (-(Mb_z * Mc_y));
MN2_y = Mb_z * Mc_x + (-(Mb_x * Mc_z));
MN2_z = Mb_x * Mc_y + (-(Mb_y * Mc_x));
MAC_x = Mc_x - Ma_x;
MAC_y = Mc_y - Ma_y;
MAC_z = Mc_z - Ma_z;
MV_x = MAB_y * MAC_z + (-(MAB_z * MAC_y));
MV_y = MAB_z * MAC_x + (-(MAB_x * MAC_z));
MV_z = MAB_x * MAC_y + (-(MAB_y * MAC_x));
Mrhs = MN2_z * MV_z + (MN2_y * MV_y + MN2_x * MV_x);
FAB_x = b_x - a_x;
FAB_y = b_y - a_y;
FAB_z = b_z - a_z;
FN2_x = b_y * c_z + (-(b_z * c_y));
FN2_y = b_z * c_x + (-(b_x * c_z));
FN2_z = b_x * c_y + (-(b_y * c_x));
FAC_x = c_x - a_x;
FAC_y = c_y - a_y;
FAC_z = c_z - a_z;
FV_x = FAB_y * FAC_z + (-(FAB_z * FAC_y));
FV_y = FAB_z * FAC_x + (-(FAB_x * FAC_z));
FV_z = FAB_x * FAC_y + (-(FAB_y * FAC_x));
Frhs = FN2_z * FV_z + (FN2_y * FV_y + FN2_x * FV_x);
product = N2_z * V_z + (N2_y * V_y + N2_x * V_x);
by_V = MN2_z * (V_z - MV_z) + (MN2_y * (V_y - MV_y) + MN2_x * (V_x - MV_x));
by_N2 = MV_z * (N2_z - MN2_z) + (MV_y * (N2_y - MN2_y) + MV_x * (N2_x - MN2_x));
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
  MN2_x in [-2,2] ->
  FN2_x in [-2,2] ->
  |FN2_x - MN2_x| <= 4b-54 ->
  MN2_y in [-2,2] ->
  FN2_y in [-2,2] ->
  |FN2_y - MN2_y| <= 4b-54 ->
  MN2_z in [-2,2] ->
  FN2_z in [-2,2] ->
  |FN2_z - MN2_z| <= 4b-54 ->
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
N2_x ~ MN2_x;
N2_x ~ FN2_x;
FN2_x ~ MN2_x;
N2_y ~ MN2_y;
N2_y ~ FN2_y;
FN2_y ~ MN2_y;
N2_z ~ MN2_z;
N2_z ~ FN2_z;
FN2_z ~ MN2_z;
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
product - Mrhs -> (by_V + by_N2) + ((N2_x - MN2_x) * (V_x - MV_x) + (N2_y - MN2_y) * (V_y - MV_y) + (N2_z - MN2_z) * (V_z - MV_z));
