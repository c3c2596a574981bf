# The error of lhs - rhs: vertex_b.side_c of published, fma, binary64, on the scaled domain.
# Written by write_proofs from the formulae: do not edit.
@rnd = float<53,-1074,ne>;
r = rnd(r_);
b_x = rnd(Mb_x);
b_y = rnd(Mb_y);
b_z = rnd(Mb_z);
c_x = rnd(Mc_x);
c_y = rnd(Mc_y);
c_z = rnd(Mc_z);
lhs = rnd(b_z * c_z + rnd(b_y * c_y + rnd(b_x * c_x)));
rhs = rnd(b_z * b_z + rnd(b_y * b_y + rnd(b_x * b_x)));
Mlhs = Mb_z * Mc_z + (Mb_y * Mc_y + Mb_x * Mc_x);
Mrhs = Mb_z * Mb_z + (Mb_y * Mb_y + Mb_x * Mb_x);
Flhs = b_z * c_z + (b_y * c_y + b_x * c_x);
Frhs = b_z * b_z + (b_y * b_y + b_x * b_x);
{
  Mb_x in [-1,1] ->
  Mb_y in [-1,1] ->
  Mb_z in [-1,1] ->
  Mc_x in [-1,1] ->
  Mc_y in [-1,1] ->
  Mc_z in [-1,1] ->
  r in [0,1] ->
  |(lhs - rhs) - (Mlhs - Mrhs)| <= 208b-57
}
lhs ~ Mlhs;
lhs ~ Flhs;
Flhs ~ Mlhs;
rhs ~ Mrhs;
rhs ~ Frhs;
Frhs ~ Mrhs;
