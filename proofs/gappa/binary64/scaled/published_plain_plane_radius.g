# The error of lhs - rhs: plane.radius of published, plain, binary64, on the scaled domain.
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
rr = rnd(r * r);
AB_x = rnd(b_x - a_x);
AB_y = rnd(b_y - a_y);
AB_z = rnd(b_z - a_z);
AC_x = rnd(c_x - a_x);
AC_y = rnd(c_y - a_y);
AC_z = rnd(c_z - a_z);
V_x = rnd(rnd(AB_y * AC_z) - rnd(AB_z * AC_y));
V_y = rnd(rnd(AB_z * AC_x) - rnd(AB_x * AC_z));
V_z = rnd(rnd(AB_x * AC_y) - rnd(AB_y * AC_x));
d = rnd(rnd(rnd(a_x * V_x) + rnd(a_y * V_y)) + rnd(a_z * V_z));
e = rnd(rnd(rnd(V_x * V_x) + rnd(V_y * V_y)) + rnd(V_z * V_z));
lhs = rnd(d * d);
rhs = rnd(rr * e);
Mrr = r * r;
MAB_x = Mb_x - Ma_x;
MAB_y = Mb_y - Ma_y;
MAB_z = Mb_z - Ma_z;
MAC_x = Mc_x - Ma_x;
MAC_y = Mc_y - Ma_y;
MAC_z = Mc_z - Ma_z;
MV_x = MAB_y * MAC_z - MAB_z * MAC_y;
MV_y = MAB_z * MAC_x - MAB_x * MAC_z;
MV_z = MAB_x * MAC_y - MAB_y * MAC_x;
Md = Ma_x * MV_x + Ma_y * MV_y + Ma_z * MV_z;
Me = MV_x * MV_x + MV_y * MV_y + MV_z * MV_z;
Mlhs = Md * Md;
Mrhs = Mrr * Me;
FAB_x = b_x - a_x;
FAB_y = b_y - a_y;
FAB_z = b_z - a_z;
FAC_x = c_x - a_x;
FAC_y = c_y - a_y;
FAC_z = c_z - a_z;
FV_x = FAB_y * FAC_z - FAB_z * FAC_y;
FV_y = FAB_z * FAC_x - FAB_x * FAC_z;
FV_z = FAB_x * FAC_y - FAB_y * FAC_x;
Fd = a_x * FV_x + a_y * FV_y + a_z * FV_z;
Fe = FV_x * FV_x + FV_y * FV_y + FV_z * FV_z;
Flhs = Fd * Fd;
Frhs = Mrr * Fe;
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
  Md in [-4,4] ->
  Fd in [-4,4] ->
  |Fd - Md| <= 18b-54 ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 21761b-57
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
d ~ Md;
d ~ Fd;
Fd ~ Md;
e ~ Me;
e ~ Fe;
Fe ~ Me;
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
