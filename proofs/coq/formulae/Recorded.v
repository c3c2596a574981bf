From Coq Require Import Reals.
Open Scope R_scope.

(* Written by write_proofs from kernel/sphere_triangle/formulae.h and kernel/sphere_triangle/rungs/reduced.h, through the recorder: do not edit.

   F_exact_K_lhs, F_exact_K_rhs: the sides of comparison K of the formulae F over the reals.
   F_float_K_lhs, F_float_K_rhs: as the kernel computes them, every operation rounded, in its operation order.
   F_fma_K_lhs, F_fma_K_rhs: the same where dot and cross products use fused multiply-add. *)

Definition published_exact_plane_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  let d := a_x * V_x + a_y * V_y + a_z * V_z in
  d * d.

Definition published_exact_plane_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let rr := r * r in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  let e := V_x * V_x + V_y * V_y + V_z * V_z in
  rr * e.

Definition published_exact_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  a_x * a_x + a_y * a_y + a_z * a_z.

Definition published_exact_vertex_a_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  r * r.

Definition published_exact_vertex_a_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  a_x * b_x + a_y * b_y + a_z * b_z.

Definition published_exact_vertex_a_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  a_x * a_x + a_y * a_y + a_z * a_z.

Definition published_exact_vertex_a_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  a_x * c_x + a_y * c_y + a_z * c_z.

Definition published_exact_vertex_a_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  a_x * a_x + a_y * a_y + a_z * a_z.

Definition published_exact_vertex_b_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  b_x * b_x + b_y * b_y + b_z * b_z.

Definition published_exact_vertex_b_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  r * r.

Definition published_exact_vertex_b_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  a_x * b_x + a_y * b_y + a_z * b_z.

Definition published_exact_vertex_b_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  b_x * b_x + b_y * b_y + b_z * b_z.

Definition published_exact_vertex_b_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  b_x * c_x + b_y * c_y + b_z * c_z.

Definition published_exact_vertex_b_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  b_x * b_x + b_y * b_y + b_z * b_z.

Definition published_exact_vertex_c_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  c_x * c_x + c_y * c_y + c_z * c_z.

Definition published_exact_vertex_c_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  r * r.

Definition published_exact_vertex_c_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  a_x * c_x + a_y * c_y + a_z * c_z.

Definition published_exact_vertex_c_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  c_x * c_x + c_y * c_y + c_z * c_z.

Definition published_exact_vertex_c_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  b_x * c_x + b_y * c_y + b_z * c_z.

Definition published_exact_vertex_c_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  c_x * c_x + c_y * c_y + c_z * c_z.

Definition published_exact_edge_ab_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  let Q1_x := a_x * e1 - AB_x * d1 in
  let Q1_y := a_y * e1 - AB_y * d1 in
  let Q1_z := a_z * e1 - AB_z * d1 in
  Q1_x * Q1_x + Q1_y * Q1_y + Q1_z * Q1_z.

Definition published_exact_edge_ab_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let rr := r * r in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  rr * e1 * e1.

Definition published_exact_edge_ab_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  let Q1_x := a_x * e1 - AB_x * d1 in
  let Q1_y := a_y * e1 - AB_y * d1 in
  let Q1_z := a_z * e1 - AB_z * d1 in
  let QC_x := c_x * e1 - Q1_x in
  let QC_y := c_y * e1 - Q1_y in
  let QC_z := c_z * e1 - Q1_z in
  Q1_x * QC_x + Q1_y * QC_y + Q1_z * QC_z.

Definition published_exact_edge_ab_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition published_exact_edge_bc_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  let Q2_x := b_x * e2 - BC_x * d2 in
  let Q2_y := b_y * e2 - BC_y * d2 in
  let Q2_z := b_z * e2 - BC_z * d2 in
  Q2_x * Q2_x + Q2_y * Q2_y + Q2_z * Q2_z.

Definition published_exact_edge_bc_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let rr := r * r in
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  rr * e2 * e2.

Definition published_exact_edge_bc_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  let Q2_x := b_x * e2 - BC_x * d2 in
  let Q2_y := b_y * e2 - BC_y * d2 in
  let Q2_z := b_z * e2 - BC_z * d2 in
  let QA_x := a_x * e2 - Q2_x in
  let QA_y := a_y * e2 - Q2_y in
  let QA_z := a_z * e2 - Q2_z in
  Q2_x * QA_x + Q2_y * QA_y + Q2_z * QA_z.

Definition published_exact_edge_bc_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition published_exact_edge_ca_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  let Q3_x := c_x * e3 - CA_x * d3 in
  let Q3_y := c_y * e3 - CA_y * d3 in
  let Q3_z := c_z * e3 - CA_z * d3 in
  Q3_x * Q3_x + Q3_y * Q3_y + Q3_z * Q3_z.

Definition published_exact_edge_ca_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let rr := r * r in
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  rr * e3 * e3.

Definition published_exact_edge_ca_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  let Q3_x := c_x * e3 - CA_x * d3 in
  let Q3_y := c_y * e3 - CA_y * d3 in
  let Q3_z := c_z * e3 - CA_z * d3 in
  let QB_x := b_x * e3 - Q3_x in
  let QB_y := b_y * e3 - Q3_y in
  let QB_z := b_z * e3 - Q3_z in
  Q3_x * QB_x + Q3_y * QB_y + Q3_z * QB_z.

Definition published_exact_edge_ca_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_exact_plane_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  let d := a_x * V_x + a_y * V_y + a_z * V_z in
  d * d.

Definition reduced_exact_plane_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let rr := r * r in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  let e := V_x * V_x + V_y * V_y + V_z * V_z in
  rr * e.

Definition reduced_exact_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  a_x * a_x + a_y * a_y + a_z * a_z.

Definition reduced_exact_vertex_a_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  r * r.

Definition reduced_exact_vertex_a_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  a_x * b_x + a_y * b_y + a_z * b_z.

Definition reduced_exact_vertex_a_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  a_x * a_x + a_y * a_y + a_z * a_z.

Definition reduced_exact_vertex_a_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  a_x * c_x + a_y * c_y + a_z * c_z.

Definition reduced_exact_vertex_a_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  a_x * a_x + a_y * a_y + a_z * a_z.

Definition reduced_exact_vertex_b_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  b_x * b_x + b_y * b_y + b_z * b_z.

Definition reduced_exact_vertex_b_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  r * r.

Definition reduced_exact_vertex_b_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  a_x * b_x + a_y * b_y + a_z * b_z.

Definition reduced_exact_vertex_b_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  b_x * b_x + b_y * b_y + b_z * b_z.

Definition reduced_exact_vertex_b_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  b_x * c_x + b_y * c_y + b_z * c_z.

Definition reduced_exact_vertex_b_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  b_x * b_x + b_y * b_y + b_z * b_z.

Definition reduced_exact_vertex_c_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  c_x * c_x + c_y * c_y + c_z * c_z.

Definition reduced_exact_vertex_c_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  r * r.

Definition reduced_exact_vertex_c_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  a_x * c_x + a_y * c_y + a_z * c_z.

Definition reduced_exact_vertex_c_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  c_x * c_x + c_y * c_y + c_z * c_z.

Definition reduced_exact_vertex_c_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  b_x * c_x + b_y * c_y + b_z * c_z.

Definition reduced_exact_vertex_c_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  c_x * c_x + c_y * c_y + c_z * c_z.

Definition reduced_exact_edge_ab_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let N1_x := a_y * b_z - a_z * b_y in
  let N1_y := a_z * b_x - a_x * b_z in
  let N1_z := a_x * b_y - a_y * b_x in
  N1_x * N1_x + N1_y * N1_y + N1_z * N1_z.

Definition reduced_exact_edge_ab_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let rr := r * r in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  rr * e1.

Definition reduced_exact_edge_ab_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_exact_edge_ab_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let N1_x := a_y * b_z - a_z * b_y in
  let N1_y := a_z * b_x - a_x * b_z in
  let N1_z := a_x * b_y - a_y * b_x in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  N1_x * V_x + N1_y * V_y + N1_z * V_z.

Definition reduced_exact_edge_bc_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let N2_x := b_y * c_z - b_z * c_y in
  let N2_y := b_z * c_x - b_x * c_z in
  let N2_z := b_x * c_y - b_y * c_x in
  N2_x * N2_x + N2_y * N2_y + N2_z * N2_z.

Definition reduced_exact_edge_bc_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let rr := r * r in
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  rr * e2.

Definition reduced_exact_edge_bc_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_exact_edge_bc_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let N2_x := b_y * c_z - b_z * c_y in
  let N2_y := b_z * c_x - b_x * c_z in
  let N2_z := b_x * c_y - b_y * c_x in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  N2_x * V_x + N2_y * V_y + N2_z * V_z.

Definition reduced_exact_edge_ca_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let N3_x := c_y * a_z - c_z * a_y in
  let N3_y := c_z * a_x - c_x * a_z in
  let N3_z := c_x * a_y - c_y * a_x in
  N3_x * N3_x + N3_y * N3_y + N3_z * N3_z.

Definition reduced_exact_edge_ca_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let rr := r * r in
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  rr * e3.

Definition reduced_exact_edge_ca_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_exact_edge_ca_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := Ax - Px in
  let a_y := Ay - Py in
  let a_z := Az - Pz in
  let b_x := Bx - Px in
  let b_y := By - Py in
  let b_z := Bz - Pz in
  let c_x := Cx - Px in
  let c_y := Cy - Py in
  let c_z := Cz - Pz in
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let N3_x := c_y * a_z - c_z * a_y in
  let N3_y := c_z * a_x - c_x * a_z in
  let N3_z := c_x * a_y - c_y * a_x in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  N3_x * V_x + N3_y * V_y + N3_z * V_z.

Section Rounded.
Variable rnd : R -> R.

Definition published_float_plane_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (rnd (AB_y * AC_z) - rnd (AB_z * AC_y)) in
  let V_y := rnd (rnd (AB_z * AC_x) - rnd (AB_x * AC_z)) in
  let V_z := rnd (rnd (AB_x * AC_y) - rnd (AB_y * AC_x)) in
  let d := rnd (rnd (rnd (a_x * V_x) + rnd (a_y * V_y)) + rnd (a_z * V_z)) in
  rnd (d * d).

Definition published_float_plane_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (rnd (AB_y * AC_z) - rnd (AB_z * AC_y)) in
  let V_y := rnd (rnd (AB_z * AC_x) - rnd (AB_x * AC_z)) in
  let V_z := rnd (rnd (AB_x * AC_y) - rnd (AB_y * AC_x)) in
  let e := rnd (rnd (rnd (V_x * V_x) + rnd (V_y * V_y)) + rnd (V_z * V_z)) in
  rnd (rr * e).

Definition published_float_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)).

Definition published_float_vertex_a_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition published_float_vertex_a_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (a_x * b_x) + rnd (a_y * b_y)) + rnd (a_z * b_z)).

Definition published_float_vertex_a_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)).

Definition published_float_vertex_a_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (a_x * c_x) + rnd (a_y * c_y)) + rnd (a_z * c_z)).

Definition published_float_vertex_a_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)).

Definition published_float_vertex_b_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)).

Definition published_float_vertex_b_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition published_float_vertex_b_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (a_x * b_x) + rnd (a_y * b_y)) + rnd (a_z * b_z)).

Definition published_float_vertex_b_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)).

Definition published_float_vertex_b_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (b_x * c_x) + rnd (b_y * c_y)) + rnd (b_z * c_z)).

Definition published_float_vertex_b_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)).

Definition published_float_vertex_c_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)).

Definition published_float_vertex_c_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition published_float_vertex_c_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (a_x * c_x) + rnd (a_y * c_y)) + rnd (a_z * c_z)).

Definition published_float_vertex_c_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)).

Definition published_float_vertex_c_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (b_x * c_x) + rnd (b_y * c_y)) + rnd (b_z * c_z)).

Definition published_float_vertex_c_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)).

Definition published_float_edge_ab_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let aa := rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)) in
  let ab := rnd (rnd (rnd (a_x * b_x) + rnd (a_y * b_y)) + rnd (a_z * b_z)) in
  let d1 := rnd (ab - aa) in
  let e1 := rnd (rnd (rnd (AB_x * AB_x) + rnd (AB_y * AB_y)) + rnd (AB_z * AB_z)) in
  let Q1_x := rnd (rnd (a_x * e1) - rnd (AB_x * d1)) in
  let Q1_y := rnd (rnd (a_y * e1) - rnd (AB_y * d1)) in
  let Q1_z := rnd (rnd (a_z * e1) - rnd (AB_z * d1)) in
  rnd (rnd (rnd (Q1_x * Q1_x) + rnd (Q1_y * Q1_y)) + rnd (Q1_z * Q1_z)).

Definition published_float_edge_ab_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let e1 := rnd (rnd (rnd (AB_x * AB_x) + rnd (AB_y * AB_y)) + rnd (AB_z * AB_z)) in
  rnd (rnd (rr * e1) * e1).

Definition published_float_edge_ab_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let aa := rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)) in
  let ab := rnd (rnd (rnd (a_x * b_x) + rnd (a_y * b_y)) + rnd (a_z * b_z)) in
  let d1 := rnd (ab - aa) in
  let e1 := rnd (rnd (rnd (AB_x * AB_x) + rnd (AB_y * AB_y)) + rnd (AB_z * AB_z)) in
  let Q1_x := rnd (rnd (a_x * e1) - rnd (AB_x * d1)) in
  let Q1_y := rnd (rnd (a_y * e1) - rnd (AB_y * d1)) in
  let Q1_z := rnd (rnd (a_z * e1) - rnd (AB_z * d1)) in
  let QC_x := rnd (rnd (c_x * e1) - Q1_x) in
  let QC_y := rnd (rnd (c_y * e1) - Q1_y) in
  let QC_z := rnd (rnd (c_z * e1) - Q1_z) in
  rnd (rnd (rnd (Q1_x * QC_x) + rnd (Q1_y * QC_y)) + rnd (Q1_z * QC_z)).

Definition published_float_edge_ab_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition published_float_edge_bc_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let bb := rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)) in
  let bc := rnd (rnd (rnd (b_x * c_x) + rnd (b_y * c_y)) + rnd (b_z * c_z)) in
  let d2 := rnd (bc - bb) in
  let e2 := rnd (rnd (rnd (BC_x * BC_x) + rnd (BC_y * BC_y)) + rnd (BC_z * BC_z)) in
  let Q2_x := rnd (rnd (b_x * e2) - rnd (BC_x * d2)) in
  let Q2_y := rnd (rnd (b_y * e2) - rnd (BC_y * d2)) in
  let Q2_z := rnd (rnd (b_z * e2) - rnd (BC_z * d2)) in
  rnd (rnd (rnd (Q2_x * Q2_x) + rnd (Q2_y * Q2_y)) + rnd (Q2_z * Q2_z)).

Definition published_float_edge_bc_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let e2 := rnd (rnd (rnd (BC_x * BC_x) + rnd (BC_y * BC_y)) + rnd (BC_z * BC_z)) in
  rnd (rnd (rr * e2) * e2).

Definition published_float_edge_bc_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let bb := rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)) in
  let bc := rnd (rnd (rnd (b_x * c_x) + rnd (b_y * c_y)) + rnd (b_z * c_z)) in
  let d2 := rnd (bc - bb) in
  let e2 := rnd (rnd (rnd (BC_x * BC_x) + rnd (BC_y * BC_y)) + rnd (BC_z * BC_z)) in
  let Q2_x := rnd (rnd (b_x * e2) - rnd (BC_x * d2)) in
  let Q2_y := rnd (rnd (b_y * e2) - rnd (BC_y * d2)) in
  let Q2_z := rnd (rnd (b_z * e2) - rnd (BC_z * d2)) in
  let QA_x := rnd (rnd (a_x * e2) - Q2_x) in
  let QA_y := rnd (rnd (a_y * e2) - Q2_y) in
  let QA_z := rnd (rnd (a_z * e2) - Q2_z) in
  rnd (rnd (rnd (Q2_x * QA_x) + rnd (Q2_y * QA_y)) + rnd (Q2_z * QA_z)).

Definition published_float_edge_bc_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition published_float_edge_ca_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let ac := rnd (rnd (rnd (a_x * c_x) + rnd (a_y * c_y)) + rnd (a_z * c_z)) in
  let cc := rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)) in
  let d3 := rnd (ac - cc) in
  let e3 := rnd (rnd (rnd (CA_x * CA_x) + rnd (CA_y * CA_y)) + rnd (CA_z * CA_z)) in
  let Q3_x := rnd (rnd (c_x * e3) - rnd (CA_x * d3)) in
  let Q3_y := rnd (rnd (c_y * e3) - rnd (CA_y * d3)) in
  let Q3_z := rnd (rnd (c_z * e3) - rnd (CA_z * d3)) in
  rnd (rnd (rnd (Q3_x * Q3_x) + rnd (Q3_y * Q3_y)) + rnd (Q3_z * Q3_z)).

Definition published_float_edge_ca_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let e3 := rnd (rnd (rnd (CA_x * CA_x) + rnd (CA_y * CA_y)) + rnd (CA_z * CA_z)) in
  rnd (rnd (rr * e3) * e3).

Definition published_float_edge_ca_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let ac := rnd (rnd (rnd (a_x * c_x) + rnd (a_y * c_y)) + rnd (a_z * c_z)) in
  let cc := rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)) in
  let d3 := rnd (ac - cc) in
  let e3 := rnd (rnd (rnd (CA_x * CA_x) + rnd (CA_y * CA_y)) + rnd (CA_z * CA_z)) in
  let Q3_x := rnd (rnd (c_x * e3) - rnd (CA_x * d3)) in
  let Q3_y := rnd (rnd (c_y * e3) - rnd (CA_y * d3)) in
  let Q3_z := rnd (rnd (c_z * e3) - rnd (CA_z * d3)) in
  let QB_x := rnd (rnd (b_x * e3) - Q3_x) in
  let QB_y := rnd (rnd (b_y * e3) - Q3_y) in
  let QB_z := rnd (rnd (b_z * e3) - Q3_z) in
  rnd (rnd (rnd (Q3_x * QB_x) + rnd (Q3_y * QB_y)) + rnd (Q3_z * QB_z)).

Definition published_float_edge_ca_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition published_fma_plane_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (AB_y * AC_z + (-rnd (AB_z * AC_y))) in
  let V_y := rnd (AB_z * AC_x + (-rnd (AB_x * AC_z))) in
  let V_z := rnd (AB_x * AC_y + (-rnd (AB_y * AC_x))) in
  let d := rnd (a_z * V_z + rnd (a_y * V_y + rnd (a_x * V_x))) in
  rnd (d * d).

Definition published_fma_plane_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (AB_y * AC_z + (-rnd (AB_z * AC_y))) in
  let V_y := rnd (AB_z * AC_x + (-rnd (AB_x * AC_z))) in
  let V_z := rnd (AB_x * AC_y + (-rnd (AB_y * AC_x))) in
  let e := rnd (V_z * V_z + rnd (V_y * V_y + rnd (V_x * V_x))) in
  rnd (rr * e).

Definition published_fma_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))).

Definition published_fma_vertex_a_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition published_fma_vertex_a_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (a_z * b_z + rnd (a_y * b_y + rnd (a_x * b_x))).

Definition published_fma_vertex_a_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))).

Definition published_fma_vertex_a_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (a_z * c_z + rnd (a_y * c_y + rnd (a_x * c_x))).

Definition published_fma_vertex_a_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))).

Definition published_fma_vertex_b_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))).

Definition published_fma_vertex_b_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition published_fma_vertex_b_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (a_z * b_z + rnd (a_y * b_y + rnd (a_x * b_x))).

Definition published_fma_vertex_b_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))).

Definition published_fma_vertex_b_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (b_z * c_z + rnd (b_y * c_y + rnd (b_x * c_x))).

Definition published_fma_vertex_b_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))).

Definition published_fma_vertex_c_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))).

Definition published_fma_vertex_c_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition published_fma_vertex_c_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (a_z * c_z + rnd (a_y * c_y + rnd (a_x * c_x))).

Definition published_fma_vertex_c_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))).

Definition published_fma_vertex_c_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (b_z * c_z + rnd (b_y * c_y + rnd (b_x * c_x))).

Definition published_fma_vertex_c_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))).

Definition published_fma_edge_ab_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let aa := rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))) in
  let ab := rnd (a_z * b_z + rnd (a_y * b_y + rnd (a_x * b_x))) in
  let d1 := rnd (ab - aa) in
  let e1 := rnd (AB_z * AB_z + rnd (AB_y * AB_y + rnd (AB_x * AB_x))) in
  let Q1_x := rnd (rnd (a_x * e1) - rnd (AB_x * d1)) in
  let Q1_y := rnd (rnd (a_y * e1) - rnd (AB_y * d1)) in
  let Q1_z := rnd (rnd (a_z * e1) - rnd (AB_z * d1)) in
  rnd (Q1_z * Q1_z + rnd (Q1_y * Q1_y + rnd (Q1_x * Q1_x))).

Definition published_fma_edge_ab_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let e1 := rnd (AB_z * AB_z + rnd (AB_y * AB_y + rnd (AB_x * AB_x))) in
  rnd (rnd (rr * e1) * e1).

Definition published_fma_edge_ab_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let aa := rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))) in
  let ab := rnd (a_z * b_z + rnd (a_y * b_y + rnd (a_x * b_x))) in
  let d1 := rnd (ab - aa) in
  let e1 := rnd (AB_z * AB_z + rnd (AB_y * AB_y + rnd (AB_x * AB_x))) in
  let Q1_x := rnd (rnd (a_x * e1) - rnd (AB_x * d1)) in
  let Q1_y := rnd (rnd (a_y * e1) - rnd (AB_y * d1)) in
  let Q1_z := rnd (rnd (a_z * e1) - rnd (AB_z * d1)) in
  let QC_x := rnd (rnd (c_x * e1) - Q1_x) in
  let QC_y := rnd (rnd (c_y * e1) - Q1_y) in
  let QC_z := rnd (rnd (c_z * e1) - Q1_z) in
  rnd (Q1_z * QC_z + rnd (Q1_y * QC_y + rnd (Q1_x * QC_x))).

Definition published_fma_edge_ab_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition published_fma_edge_bc_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let bb := rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))) in
  let bc := rnd (b_z * c_z + rnd (b_y * c_y + rnd (b_x * c_x))) in
  let d2 := rnd (bc - bb) in
  let e2 := rnd (BC_z * BC_z + rnd (BC_y * BC_y + rnd (BC_x * BC_x))) in
  let Q2_x := rnd (rnd (b_x * e2) - rnd (BC_x * d2)) in
  let Q2_y := rnd (rnd (b_y * e2) - rnd (BC_y * d2)) in
  let Q2_z := rnd (rnd (b_z * e2) - rnd (BC_z * d2)) in
  rnd (Q2_z * Q2_z + rnd (Q2_y * Q2_y + rnd (Q2_x * Q2_x))).

Definition published_fma_edge_bc_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let e2 := rnd (BC_z * BC_z + rnd (BC_y * BC_y + rnd (BC_x * BC_x))) in
  rnd (rnd (rr * e2) * e2).

Definition published_fma_edge_bc_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let bb := rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))) in
  let bc := rnd (b_z * c_z + rnd (b_y * c_y + rnd (b_x * c_x))) in
  let d2 := rnd (bc - bb) in
  let e2 := rnd (BC_z * BC_z + rnd (BC_y * BC_y + rnd (BC_x * BC_x))) in
  let Q2_x := rnd (rnd (b_x * e2) - rnd (BC_x * d2)) in
  let Q2_y := rnd (rnd (b_y * e2) - rnd (BC_y * d2)) in
  let Q2_z := rnd (rnd (b_z * e2) - rnd (BC_z * d2)) in
  let QA_x := rnd (rnd (a_x * e2) - Q2_x) in
  let QA_y := rnd (rnd (a_y * e2) - Q2_y) in
  let QA_z := rnd (rnd (a_z * e2) - Q2_z) in
  rnd (Q2_z * QA_z + rnd (Q2_y * QA_y + rnd (Q2_x * QA_x))).

Definition published_fma_edge_bc_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition published_fma_edge_ca_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let ac := rnd (a_z * c_z + rnd (a_y * c_y + rnd (a_x * c_x))) in
  let cc := rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))) in
  let d3 := rnd (ac - cc) in
  let e3 := rnd (CA_z * CA_z + rnd (CA_y * CA_y + rnd (CA_x * CA_x))) in
  let Q3_x := rnd (rnd (c_x * e3) - rnd (CA_x * d3)) in
  let Q3_y := rnd (rnd (c_y * e3) - rnd (CA_y * d3)) in
  let Q3_z := rnd (rnd (c_z * e3) - rnd (CA_z * d3)) in
  rnd (Q3_z * Q3_z + rnd (Q3_y * Q3_y + rnd (Q3_x * Q3_x))).

Definition published_fma_edge_ca_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let e3 := rnd (CA_z * CA_z + rnd (CA_y * CA_y + rnd (CA_x * CA_x))) in
  rnd (rnd (rr * e3) * e3).

Definition published_fma_edge_ca_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let ac := rnd (a_z * c_z + rnd (a_y * c_y + rnd (a_x * c_x))) in
  let cc := rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))) in
  let d3 := rnd (ac - cc) in
  let e3 := rnd (CA_z * CA_z + rnd (CA_y * CA_y + rnd (CA_x * CA_x))) in
  let Q3_x := rnd (rnd (c_x * e3) - rnd (CA_x * d3)) in
  let Q3_y := rnd (rnd (c_y * e3) - rnd (CA_y * d3)) in
  let Q3_z := rnd (rnd (c_z * e3) - rnd (CA_z * d3)) in
  let QB_x := rnd (rnd (b_x * e3) - Q3_x) in
  let QB_y := rnd (rnd (b_y * e3) - Q3_y) in
  let QB_z := rnd (rnd (b_z * e3) - Q3_z) in
  rnd (Q3_z * QB_z + rnd (Q3_y * QB_y + rnd (Q3_x * QB_x))).

Definition published_fma_edge_ca_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_float_plane_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (rnd (AB_y * AC_z) - rnd (AB_z * AC_y)) in
  let V_y := rnd (rnd (AB_z * AC_x) - rnd (AB_x * AC_z)) in
  let V_z := rnd (rnd (AB_x * AC_y) - rnd (AB_y * AC_x)) in
  let d := rnd (rnd (rnd (a_x * V_x) + rnd (a_y * V_y)) + rnd (a_z * V_z)) in
  rnd (d * d).

Definition reduced_float_plane_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (rnd (AB_y * AC_z) - rnd (AB_z * AC_y)) in
  let V_y := rnd (rnd (AB_z * AC_x) - rnd (AB_x * AC_z)) in
  let V_z := rnd (rnd (AB_x * AC_y) - rnd (AB_y * AC_x)) in
  let e := rnd (rnd (rnd (V_x * V_x) + rnd (V_y * V_y)) + rnd (V_z * V_z)) in
  rnd (rr * e).

Definition reduced_float_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)).

Definition reduced_float_vertex_a_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition reduced_float_vertex_a_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (a_x * b_x) + rnd (a_y * b_y)) + rnd (a_z * b_z)).

Definition reduced_float_vertex_a_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)).

Definition reduced_float_vertex_a_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (a_x * c_x) + rnd (a_y * c_y)) + rnd (a_z * c_z)).

Definition reduced_float_vertex_a_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (rnd (rnd (a_x * a_x) + rnd (a_y * a_y)) + rnd (a_z * a_z)).

Definition reduced_float_vertex_b_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)).

Definition reduced_float_vertex_b_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition reduced_float_vertex_b_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (a_x * b_x) + rnd (a_y * b_y)) + rnd (a_z * b_z)).

Definition reduced_float_vertex_b_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)).

Definition reduced_float_vertex_b_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (b_x * c_x) + rnd (b_y * c_y)) + rnd (b_z * c_z)).

Definition reduced_float_vertex_b_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (rnd (rnd (b_x * b_x) + rnd (b_y * b_y)) + rnd (b_z * b_z)).

Definition reduced_float_vertex_c_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)).

Definition reduced_float_vertex_c_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition reduced_float_vertex_c_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (a_x * c_x) + rnd (a_y * c_y)) + rnd (a_z * c_z)).

Definition reduced_float_vertex_c_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)).

Definition reduced_float_vertex_c_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (b_x * c_x) + rnd (b_y * c_y)) + rnd (b_z * c_z)).

Definition reduced_float_vertex_c_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (rnd (rnd (c_x * c_x) + rnd (c_y * c_y)) + rnd (c_z * c_z)).

Definition reduced_float_edge_ab_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let N1_x := rnd (rnd (a_y * b_z) - rnd (a_z * b_y)) in
  let N1_y := rnd (rnd (a_z * b_x) - rnd (a_x * b_z)) in
  let N1_z := rnd (rnd (a_x * b_y) - rnd (a_y * b_x)) in
  rnd (rnd (rnd (N1_x * N1_x) + rnd (N1_y * N1_y)) + rnd (N1_z * N1_z)).

Definition reduced_float_edge_ab_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let e1 := rnd (rnd (rnd (AB_x * AB_x) + rnd (AB_y * AB_y)) + rnd (AB_z * AB_z)) in
  rnd (rr * e1).

Definition reduced_float_edge_ab_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_float_edge_ab_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let N1_x := rnd (rnd (a_y * b_z) - rnd (a_z * b_y)) in
  let N1_y := rnd (rnd (a_z * b_x) - rnd (a_x * b_z)) in
  let N1_z := rnd (rnd (a_x * b_y) - rnd (a_y * b_x)) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (rnd (AB_y * AC_z) - rnd (AB_z * AC_y)) in
  let V_y := rnd (rnd (AB_z * AC_x) - rnd (AB_x * AC_z)) in
  let V_z := rnd (rnd (AB_x * AC_y) - rnd (AB_y * AC_x)) in
  rnd (rnd (rnd (N1_x * V_x) + rnd (N1_y * V_y)) + rnd (N1_z * V_z)).

Definition reduced_float_edge_bc_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let N2_x := rnd (rnd (b_y * c_z) - rnd (b_z * c_y)) in
  let N2_y := rnd (rnd (b_z * c_x) - rnd (b_x * c_z)) in
  let N2_z := rnd (rnd (b_x * c_y) - rnd (b_y * c_x)) in
  rnd (rnd (rnd (N2_x * N2_x) + rnd (N2_y * N2_y)) + rnd (N2_z * N2_z)).

Definition reduced_float_edge_bc_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let e2 := rnd (rnd (rnd (BC_x * BC_x) + rnd (BC_y * BC_y)) + rnd (BC_z * BC_z)) in
  rnd (rr * e2).

Definition reduced_float_edge_bc_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_float_edge_bc_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let N2_x := rnd (rnd (b_y * c_z) - rnd (b_z * c_y)) in
  let N2_y := rnd (rnd (b_z * c_x) - rnd (b_x * c_z)) in
  let N2_z := rnd (rnd (b_x * c_y) - rnd (b_y * c_x)) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (rnd (AB_y * AC_z) - rnd (AB_z * AC_y)) in
  let V_y := rnd (rnd (AB_z * AC_x) - rnd (AB_x * AC_z)) in
  let V_z := rnd (rnd (AB_x * AC_y) - rnd (AB_y * AC_x)) in
  rnd (rnd (rnd (N2_x * V_x) + rnd (N2_y * V_y)) + rnd (N2_z * V_z)).

Definition reduced_float_edge_ca_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let N3_x := rnd (rnd (c_y * a_z) - rnd (c_z * a_y)) in
  let N3_y := rnd (rnd (c_z * a_x) - rnd (c_x * a_z)) in
  let N3_z := rnd (rnd (c_x * a_y) - rnd (c_y * a_x)) in
  rnd (rnd (rnd (N3_x * N3_x) + rnd (N3_y * N3_y)) + rnd (N3_z * N3_z)).

Definition reduced_float_edge_ca_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let e3 := rnd (rnd (rnd (CA_x * CA_x) + rnd (CA_y * CA_y)) + rnd (CA_z * CA_z)) in
  rnd (rr * e3).

Definition reduced_float_edge_ca_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_float_edge_ca_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let N3_x := rnd (rnd (c_y * a_z) - rnd (c_z * a_y)) in
  let N3_y := rnd (rnd (c_z * a_x) - rnd (c_x * a_z)) in
  let N3_z := rnd (rnd (c_x * a_y) - rnd (c_y * a_x)) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (rnd (AB_y * AC_z) - rnd (AB_z * AC_y)) in
  let V_y := rnd (rnd (AB_z * AC_x) - rnd (AB_x * AC_z)) in
  let V_z := rnd (rnd (AB_x * AC_y) - rnd (AB_y * AC_x)) in
  rnd (rnd (rnd (N3_x * V_x) + rnd (N3_y * V_y)) + rnd (N3_z * V_z)).

Definition reduced_fma_plane_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (AB_y * AC_z + (-rnd (AB_z * AC_y))) in
  let V_y := rnd (AB_z * AC_x + (-rnd (AB_x * AC_z))) in
  let V_z := rnd (AB_x * AC_y + (-rnd (AB_y * AC_x))) in
  let d := rnd (a_z * V_z + rnd (a_y * V_y + rnd (a_x * V_x))) in
  rnd (d * d).

Definition reduced_fma_plane_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (AB_y * AC_z + (-rnd (AB_z * AC_y))) in
  let V_y := rnd (AB_z * AC_x + (-rnd (AB_x * AC_z))) in
  let V_z := rnd (AB_x * AC_y + (-rnd (AB_y * AC_x))) in
  let e := rnd (V_z * V_z + rnd (V_y * V_y + rnd (V_x * V_x))) in
  rnd (rr * e).

Definition reduced_fma_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))).

Definition reduced_fma_vertex_a_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition reduced_fma_vertex_a_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (a_z * b_z + rnd (a_y * b_y + rnd (a_x * b_x))).

Definition reduced_fma_vertex_a_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))).

Definition reduced_fma_vertex_a_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (a_z * c_z + rnd (a_y * c_y + rnd (a_x * c_x))).

Definition reduced_fma_vertex_a_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  rnd (a_z * a_z + rnd (a_y * a_y + rnd (a_x * a_x))).

Definition reduced_fma_vertex_b_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))).

Definition reduced_fma_vertex_b_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition reduced_fma_vertex_b_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (a_z * b_z + rnd (a_y * b_y + rnd (a_x * b_x))).

Definition reduced_fma_vertex_b_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))).

Definition reduced_fma_vertex_b_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (b_z * c_z + rnd (b_y * c_y + rnd (b_x * c_x))).

Definition reduced_fma_vertex_b_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  rnd (b_z * b_z + rnd (b_y * b_y + rnd (b_x * b_x))).

Definition reduced_fma_vertex_c_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))).

Definition reduced_fma_vertex_c_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  rnd (r * r).

Definition reduced_fma_vertex_c_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (a_z * c_z + rnd (a_y * c_y + rnd (a_x * c_x))).

Definition reduced_fma_vertex_c_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))).

Definition reduced_fma_vertex_c_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (b_z * c_z + rnd (b_y * c_y + rnd (b_x * c_x))).

Definition reduced_fma_vertex_c_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  rnd (c_z * c_z + rnd (c_y * c_y + rnd (c_x * c_x))).

Definition reduced_fma_edge_ab_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let N1_x := rnd (a_y * b_z + (-rnd (a_z * b_y))) in
  let N1_y := rnd (a_z * b_x + (-rnd (a_x * b_z))) in
  let N1_z := rnd (a_x * b_y + (-rnd (a_y * b_x))) in
  rnd (N1_z * N1_z + rnd (N1_y * N1_y + rnd (N1_x * N1_x))).

Definition reduced_fma_edge_ab_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let rr := rnd (r * r) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let e1 := rnd (AB_z * AB_z + rnd (AB_y * AB_y + rnd (AB_x * AB_x))) in
  rnd (rr * e1).

Definition reduced_fma_edge_ab_side_c_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_fma_edge_ab_side_c_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let N1_x := rnd (a_y * b_z + (-rnd (a_z * b_y))) in
  let N1_y := rnd (a_z * b_x + (-rnd (a_x * b_z))) in
  let N1_z := rnd (a_x * b_y + (-rnd (a_y * b_x))) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (AB_y * AC_z + (-rnd (AB_z * AC_y))) in
  let V_y := rnd (AB_z * AC_x + (-rnd (AB_x * AC_z))) in
  let V_z := rnd (AB_x * AC_y + (-rnd (AB_y * AC_x))) in
  rnd (N1_z * V_z + rnd (N1_y * V_y + rnd (N1_x * V_x))).

Definition reduced_fma_edge_bc_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let N2_x := rnd (b_y * c_z + (-rnd (b_z * c_y))) in
  let N2_y := rnd (b_z * c_x + (-rnd (b_x * c_z))) in
  let N2_z := rnd (b_x * c_y + (-rnd (b_y * c_x))) in
  rnd (N2_z * N2_z + rnd (N2_y * N2_y + rnd (N2_x * N2_x))).

Definition reduced_fma_edge_bc_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let BC_x := rnd (c_x - b_x) in
  let BC_y := rnd (c_y - b_y) in
  let BC_z := rnd (c_z - b_z) in
  let e2 := rnd (BC_z * BC_z + rnd (BC_y * BC_y + rnd (BC_x * BC_x))) in
  rnd (rr * e2).

Definition reduced_fma_edge_bc_side_a_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_fma_edge_bc_side_a_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let N2_x := rnd (b_y * c_z + (-rnd (b_z * c_y))) in
  let N2_y := rnd (b_z * c_x + (-rnd (b_x * c_z))) in
  let N2_z := rnd (b_x * c_y + (-rnd (b_y * c_x))) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (AB_y * AC_z + (-rnd (AB_z * AC_y))) in
  let V_y := rnd (AB_z * AC_x + (-rnd (AB_x * AC_z))) in
  let V_z := rnd (AB_x * AC_y + (-rnd (AB_y * AC_x))) in
  rnd (N2_z * V_z + rnd (N2_y * V_y + rnd (N2_x * V_x))).

Definition reduced_fma_edge_ca_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let N3_x := rnd (c_y * a_z + (-rnd (c_z * a_y))) in
  let N3_y := rnd (c_z * a_x + (-rnd (c_x * a_z))) in
  let N3_z := rnd (c_x * a_y + (-rnd (c_y * a_x))) in
  rnd (N3_z * N3_z + rnd (N3_y * N3_y + rnd (N3_x * N3_x))).

Definition reduced_fma_edge_ca_radius_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let rr := rnd (r * r) in
  let CA_x := rnd (a_x - c_x) in
  let CA_y := rnd (a_y - c_y) in
  let CA_z := rnd (a_z - c_z) in
  let e3 := rnd (CA_z * CA_z + rnd (CA_y * CA_y + rnd (CA_x * CA_x))) in
  rnd (rr * e3).

Definition reduced_fma_edge_ca_side_b_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  0.

Definition reduced_fma_edge_ca_side_b_rhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=
  let a_x := rnd (Ax - Px) in
  let a_y := rnd (Ay - Py) in
  let a_z := rnd (Az - Pz) in
  let b_x := rnd (Bx - Px) in
  let b_y := rnd (By - Py) in
  let b_z := rnd (Bz - Pz) in
  let c_x := rnd (Cx - Px) in
  let c_y := rnd (Cy - Py) in
  let c_z := rnd (Cz - Pz) in
  let AB_x := rnd (b_x - a_x) in
  let AB_y := rnd (b_y - a_y) in
  let AB_z := rnd (b_z - a_z) in
  let N3_x := rnd (c_y * a_z + (-rnd (c_z * a_y))) in
  let N3_y := rnd (c_z * a_x + (-rnd (c_x * a_z))) in
  let N3_z := rnd (c_x * a_y + (-rnd (c_y * a_x))) in
  let AC_x := rnd (c_x - a_x) in
  let AC_y := rnd (c_y - a_y) in
  let AC_z := rnd (c_z - a_z) in
  let V_x := rnd (AB_y * AC_z + (-rnd (AB_z * AC_y))) in
  let V_y := rnd (AB_z * AC_x + (-rnd (AB_x * AC_z))) in
  let V_z := rnd (AB_x * AC_y + (-rnd (AB_y * AC_x))) in
  rnd (N3_z * V_z + rnd (N3_y * V_y + rnd (N3_x * V_x))).

End Rounded.
