(* The recorded sides (Recorded.v) by comparison, for proofs about all sixteen. *)
From Coq Require Import Reals.
From Axiscert Require Import Vectors Recorded.
Open Scope R_scope.

Record query := Query { vertex_a : vec; vertex_b : vec; vertex_c : vec; centre : vec; query_radius : R }.

Definition on (side : R -> R -> R -> R -> R -> R -> R -> R -> R -> R -> R -> R -> R -> R) (q : query) : R :=
  side (cx (vertex_a q)) (cy (vertex_a q)) (cz (vertex_a q)) (cx (vertex_b q)) (cy (vertex_b q)) (cz (vertex_b q))
       (cx (vertex_c q)) (cy (vertex_c q)) (cz (vertex_c q)) (cx (centre q)) (cy (centre q)) (cz (centre q))
       (query_radius q).

Definition recorded_published_exact (q : query) (K : comparison) : R * R :=
  match K with
  | plane_radius => (on published_exact_plane_radius_lhs q, on published_exact_plane_radius_rhs q)
  | vertex_a_radius => (on published_exact_vertex_a_radius_lhs q, on published_exact_vertex_a_radius_rhs q)
  | vertex_a_side_b => (on published_exact_vertex_a_side_b_lhs q, on published_exact_vertex_a_side_b_rhs q)
  | vertex_a_side_c => (on published_exact_vertex_a_side_c_lhs q, on published_exact_vertex_a_side_c_rhs q)
  | vertex_b_radius => (on published_exact_vertex_b_radius_lhs q, on published_exact_vertex_b_radius_rhs q)
  | vertex_b_side_a => (on published_exact_vertex_b_side_a_lhs q, on published_exact_vertex_b_side_a_rhs q)
  | vertex_b_side_c => (on published_exact_vertex_b_side_c_lhs q, on published_exact_vertex_b_side_c_rhs q)
  | vertex_c_radius => (on published_exact_vertex_c_radius_lhs q, on published_exact_vertex_c_radius_rhs q)
  | vertex_c_side_a => (on published_exact_vertex_c_side_a_lhs q, on published_exact_vertex_c_side_a_rhs q)
  | vertex_c_side_b => (on published_exact_vertex_c_side_b_lhs q, on published_exact_vertex_c_side_b_rhs q)
  | edge_ab_radius => (on published_exact_edge_ab_radius_lhs q, on published_exact_edge_ab_radius_rhs q)
  | edge_ab_side_c => (on published_exact_edge_ab_side_c_lhs q, on published_exact_edge_ab_side_c_rhs q)
  | edge_bc_radius => (on published_exact_edge_bc_radius_lhs q, on published_exact_edge_bc_radius_rhs q)
  | edge_bc_side_a => (on published_exact_edge_bc_side_a_lhs q, on published_exact_edge_bc_side_a_rhs q)
  | edge_ca_radius => (on published_exact_edge_ca_radius_lhs q, on published_exact_edge_ca_radius_rhs q)
  | edge_ca_side_b => (on published_exact_edge_ca_side_b_lhs q, on published_exact_edge_ca_side_b_rhs q)
  end.

Definition recorded_published_float (rnd : R -> R) (q : query) (K : comparison) : R * R :=
  match K with
  | plane_radius => (on (published_float_plane_radius_lhs rnd) q, on (published_float_plane_radius_rhs rnd) q)
  | vertex_a_radius => (on (published_float_vertex_a_radius_lhs rnd) q, on (published_float_vertex_a_radius_rhs rnd) q)
  | vertex_a_side_b => (on (published_float_vertex_a_side_b_lhs rnd) q, on (published_float_vertex_a_side_b_rhs rnd) q)
  | vertex_a_side_c => (on (published_float_vertex_a_side_c_lhs rnd) q, on (published_float_vertex_a_side_c_rhs rnd) q)
  | vertex_b_radius => (on (published_float_vertex_b_radius_lhs rnd) q, on (published_float_vertex_b_radius_rhs rnd) q)
  | vertex_b_side_a => (on (published_float_vertex_b_side_a_lhs rnd) q, on (published_float_vertex_b_side_a_rhs rnd) q)
  | vertex_b_side_c => (on (published_float_vertex_b_side_c_lhs rnd) q, on (published_float_vertex_b_side_c_rhs rnd) q)
  | vertex_c_radius => (on (published_float_vertex_c_radius_lhs rnd) q, on (published_float_vertex_c_radius_rhs rnd) q)
  | vertex_c_side_a => (on (published_float_vertex_c_side_a_lhs rnd) q, on (published_float_vertex_c_side_a_rhs rnd) q)
  | vertex_c_side_b => (on (published_float_vertex_c_side_b_lhs rnd) q, on (published_float_vertex_c_side_b_rhs rnd) q)
  | edge_ab_radius => (on (published_float_edge_ab_radius_lhs rnd) q, on (published_float_edge_ab_radius_rhs rnd) q)
  | edge_ab_side_c => (on (published_float_edge_ab_side_c_lhs rnd) q, on published_float_edge_ab_side_c_rhs q)
  | edge_bc_radius => (on (published_float_edge_bc_radius_lhs rnd) q, on (published_float_edge_bc_radius_rhs rnd) q)
  | edge_bc_side_a => (on (published_float_edge_bc_side_a_lhs rnd) q, on published_float_edge_bc_side_a_rhs q)
  | edge_ca_radius => (on (published_float_edge_ca_radius_lhs rnd) q, on (published_float_edge_ca_radius_rhs rnd) q)
  | edge_ca_side_b => (on (published_float_edge_ca_side_b_lhs rnd) q, on published_float_edge_ca_side_b_rhs q)
  end.

Definition recorded_published_fma (rnd : R -> R) (q : query) (K : comparison) : R * R :=
  match K with
  | plane_radius => (on (published_fma_plane_radius_lhs rnd) q, on (published_fma_plane_radius_rhs rnd) q)
  | vertex_a_radius => (on (published_fma_vertex_a_radius_lhs rnd) q, on (published_fma_vertex_a_radius_rhs rnd) q)
  | vertex_a_side_b => (on (published_fma_vertex_a_side_b_lhs rnd) q, on (published_fma_vertex_a_side_b_rhs rnd) q)
  | vertex_a_side_c => (on (published_fma_vertex_a_side_c_lhs rnd) q, on (published_fma_vertex_a_side_c_rhs rnd) q)
  | vertex_b_radius => (on (published_fma_vertex_b_radius_lhs rnd) q, on (published_fma_vertex_b_radius_rhs rnd) q)
  | vertex_b_side_a => (on (published_fma_vertex_b_side_a_lhs rnd) q, on (published_fma_vertex_b_side_a_rhs rnd) q)
  | vertex_b_side_c => (on (published_fma_vertex_b_side_c_lhs rnd) q, on (published_fma_vertex_b_side_c_rhs rnd) q)
  | vertex_c_radius => (on (published_fma_vertex_c_radius_lhs rnd) q, on (published_fma_vertex_c_radius_rhs rnd) q)
  | vertex_c_side_a => (on (published_fma_vertex_c_side_a_lhs rnd) q, on (published_fma_vertex_c_side_a_rhs rnd) q)
  | vertex_c_side_b => (on (published_fma_vertex_c_side_b_lhs rnd) q, on (published_fma_vertex_c_side_b_rhs rnd) q)
  | edge_ab_radius => (on (published_fma_edge_ab_radius_lhs rnd) q, on (published_fma_edge_ab_radius_rhs rnd) q)
  | edge_ab_side_c => (on (published_fma_edge_ab_side_c_lhs rnd) q, on published_fma_edge_ab_side_c_rhs q)
  | edge_bc_radius => (on (published_fma_edge_bc_radius_lhs rnd) q, on (published_fma_edge_bc_radius_rhs rnd) q)
  | edge_bc_side_a => (on (published_fma_edge_bc_side_a_lhs rnd) q, on published_fma_edge_bc_side_a_rhs q)
  | edge_ca_radius => (on (published_fma_edge_ca_radius_lhs rnd) q, on (published_fma_edge_ca_radius_rhs rnd) q)
  | edge_ca_side_b => (on (published_fma_edge_ca_side_b_lhs rnd) q, on published_fma_edge_ca_side_b_rhs q)
  end.

Definition recorded_reduced_exact (q : query) (K : comparison) : R * R :=
  match K with
  | plane_radius => (on reduced_exact_plane_radius_lhs q, on reduced_exact_plane_radius_rhs q)
  | vertex_a_radius => (on reduced_exact_vertex_a_radius_lhs q, on reduced_exact_vertex_a_radius_rhs q)
  | vertex_a_side_b => (on reduced_exact_vertex_a_side_b_lhs q, on reduced_exact_vertex_a_side_b_rhs q)
  | vertex_a_side_c => (on reduced_exact_vertex_a_side_c_lhs q, on reduced_exact_vertex_a_side_c_rhs q)
  | vertex_b_radius => (on reduced_exact_vertex_b_radius_lhs q, on reduced_exact_vertex_b_radius_rhs q)
  | vertex_b_side_a => (on reduced_exact_vertex_b_side_a_lhs q, on reduced_exact_vertex_b_side_a_rhs q)
  | vertex_b_side_c => (on reduced_exact_vertex_b_side_c_lhs q, on reduced_exact_vertex_b_side_c_rhs q)
  | vertex_c_radius => (on reduced_exact_vertex_c_radius_lhs q, on reduced_exact_vertex_c_radius_rhs q)
  | vertex_c_side_a => (on reduced_exact_vertex_c_side_a_lhs q, on reduced_exact_vertex_c_side_a_rhs q)
  | vertex_c_side_b => (on reduced_exact_vertex_c_side_b_lhs q, on reduced_exact_vertex_c_side_b_rhs q)
  | edge_ab_radius => (on reduced_exact_edge_ab_radius_lhs q, on reduced_exact_edge_ab_radius_rhs q)
  | edge_ab_side_c => (on reduced_exact_edge_ab_side_c_lhs q, on reduced_exact_edge_ab_side_c_rhs q)
  | edge_bc_radius => (on reduced_exact_edge_bc_radius_lhs q, on reduced_exact_edge_bc_radius_rhs q)
  | edge_bc_side_a => (on reduced_exact_edge_bc_side_a_lhs q, on reduced_exact_edge_bc_side_a_rhs q)
  | edge_ca_radius => (on reduced_exact_edge_ca_radius_lhs q, on reduced_exact_edge_ca_radius_rhs q)
  | edge_ca_side_b => (on reduced_exact_edge_ca_side_b_lhs q, on reduced_exact_edge_ca_side_b_rhs q)
  end.

Definition recorded_reduced_float (rnd : R -> R) (q : query) (K : comparison) : R * R :=
  match K with
  | plane_radius => (on (reduced_float_plane_radius_lhs rnd) q, on (reduced_float_plane_radius_rhs rnd) q)
  | vertex_a_radius => (on (reduced_float_vertex_a_radius_lhs rnd) q, on (reduced_float_vertex_a_radius_rhs rnd) q)
  | vertex_a_side_b => (on (reduced_float_vertex_a_side_b_lhs rnd) q, on (reduced_float_vertex_a_side_b_rhs rnd) q)
  | vertex_a_side_c => (on (reduced_float_vertex_a_side_c_lhs rnd) q, on (reduced_float_vertex_a_side_c_rhs rnd) q)
  | vertex_b_radius => (on (reduced_float_vertex_b_radius_lhs rnd) q, on (reduced_float_vertex_b_radius_rhs rnd) q)
  | vertex_b_side_a => (on (reduced_float_vertex_b_side_a_lhs rnd) q, on (reduced_float_vertex_b_side_a_rhs rnd) q)
  | vertex_b_side_c => (on (reduced_float_vertex_b_side_c_lhs rnd) q, on (reduced_float_vertex_b_side_c_rhs rnd) q)
  | vertex_c_radius => (on (reduced_float_vertex_c_radius_lhs rnd) q, on (reduced_float_vertex_c_radius_rhs rnd) q)
  | vertex_c_side_a => (on (reduced_float_vertex_c_side_a_lhs rnd) q, on (reduced_float_vertex_c_side_a_rhs rnd) q)
  | vertex_c_side_b => (on (reduced_float_vertex_c_side_b_lhs rnd) q, on (reduced_float_vertex_c_side_b_rhs rnd) q)
  | edge_ab_radius => (on (reduced_float_edge_ab_radius_lhs rnd) q, on (reduced_float_edge_ab_radius_rhs rnd) q)
  | edge_ab_side_c => (on reduced_float_edge_ab_side_c_lhs q, on (reduced_float_edge_ab_side_c_rhs rnd) q)
  | edge_bc_radius => (on (reduced_float_edge_bc_radius_lhs rnd) q, on (reduced_float_edge_bc_radius_rhs rnd) q)
  | edge_bc_side_a => (on reduced_float_edge_bc_side_a_lhs q, on (reduced_float_edge_bc_side_a_rhs rnd) q)
  | edge_ca_radius => (on (reduced_float_edge_ca_radius_lhs rnd) q, on (reduced_float_edge_ca_radius_rhs rnd) q)
  | edge_ca_side_b => (on reduced_float_edge_ca_side_b_lhs q, on (reduced_float_edge_ca_side_b_rhs rnd) q)
  end.

Definition recorded_reduced_fma (rnd : R -> R) (q : query) (K : comparison) : R * R :=
  match K with
  | plane_radius => (on (reduced_fma_plane_radius_lhs rnd) q, on (reduced_fma_plane_radius_rhs rnd) q)
  | vertex_a_radius => (on (reduced_fma_vertex_a_radius_lhs rnd) q, on (reduced_fma_vertex_a_radius_rhs rnd) q)
  | vertex_a_side_b => (on (reduced_fma_vertex_a_side_b_lhs rnd) q, on (reduced_fma_vertex_a_side_b_rhs rnd) q)
  | vertex_a_side_c => (on (reduced_fma_vertex_a_side_c_lhs rnd) q, on (reduced_fma_vertex_a_side_c_rhs rnd) q)
  | vertex_b_radius => (on (reduced_fma_vertex_b_radius_lhs rnd) q, on (reduced_fma_vertex_b_radius_rhs rnd) q)
  | vertex_b_side_a => (on (reduced_fma_vertex_b_side_a_lhs rnd) q, on (reduced_fma_vertex_b_side_a_rhs rnd) q)
  | vertex_b_side_c => (on (reduced_fma_vertex_b_side_c_lhs rnd) q, on (reduced_fma_vertex_b_side_c_rhs rnd) q)
  | vertex_c_radius => (on (reduced_fma_vertex_c_radius_lhs rnd) q, on (reduced_fma_vertex_c_radius_rhs rnd) q)
  | vertex_c_side_a => (on (reduced_fma_vertex_c_side_a_lhs rnd) q, on (reduced_fma_vertex_c_side_a_rhs rnd) q)
  | vertex_c_side_b => (on (reduced_fma_vertex_c_side_b_lhs rnd) q, on (reduced_fma_vertex_c_side_b_rhs rnd) q)
  | edge_ab_radius => (on (reduced_fma_edge_ab_radius_lhs rnd) q, on (reduced_fma_edge_ab_radius_rhs rnd) q)
  | edge_ab_side_c => (on reduced_fma_edge_ab_side_c_lhs q, on (reduced_fma_edge_ab_side_c_rhs rnd) q)
  | edge_bc_radius => (on (reduced_fma_edge_bc_radius_lhs rnd) q, on (reduced_fma_edge_bc_radius_rhs rnd) q)
  | edge_bc_side_a => (on reduced_fma_edge_bc_side_a_lhs q, on (reduced_fma_edge_bc_side_a_rhs rnd) q)
  | edge_ca_radius => (on (reduced_fma_edge_ca_radius_lhs rnd) q, on (reduced_fma_edge_ca_radius_rhs rnd) q)
  | edge_ca_side_b => (on reduced_fma_edge_ca_side_b_lhs q, on (reduced_fma_edge_ca_side_b_rhs rnd) q)
  end.
