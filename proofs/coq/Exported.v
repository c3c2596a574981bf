(* The numbers of thresholds.h in kernel/sphere_triangle/certified_filter, proved of the filters that never lie, and those of
   margin_bounds.h beside it. Written by write_thresholds.py: do not edit. *)
From Coq Require Import Reals ZArith List.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Expression Programs Filter Thresholds Filters Margins Certified Conservative.
Import ListNotations.

Definition in_order :=
  [plane_radius; vertex_a_radius; vertex_a_side_b; vertex_a_side_c; vertex_b_radius; vertex_b_side_a;
     vertex_b_side_c; vertex_c_radius; vertex_c_side_a; vertex_c_side_b; edge_ab_radius; edge_ab_side_c;
     edge_bc_radius; edge_bc_side_a; edge_ca_radius; edge_ca_side_b].

(* n and the degree, by comparison. *)
Theorem exported_published_thresholds fused :
  map (fun K => (published_threshold K, degree (fst (published_program fused K)))) in_order =
    [(2642, 6%nat); (16, 2%nat); (29, 2%nat); (29, 2%nat); (16, 2%nat); (29, 2%nat); (29, 2%nat); (16, 2%nat);
     (29, 2%nat); (29, 2%nat); (13240, 6%nat); (22412, 6%nat); (13240, 6%nat); (22412, 6%nat); (13240, 6%nat);
     (22412, 6%nat)]%Z.
Proof. destruct fused; vm_compute; reflexivity. Qed.

(* n and the degree, by comparison. *)
Theorem exported_reduced_thresholds fused :
  map (fun K => (reduced_threshold K, degree (fst (reduced_program fused K)))) in_order =
    [(2642, 6%nat); (16, 2%nat); (29, 2%nat); (29, 2%nat); (16, 2%nat); (29, 2%nat); (29, 2%nat); (16, 2%nat);
     (29, 2%nat); (29, 2%nat); (233, 4%nat); (425, 4%nat); (233, 4%nat); (425, 4%nat); (233, 4%nat);
     (425, 4%nat)]%Z.
Proof. destruct fused; vm_compute; reflexivity. Qed.

(* The window of m in binary32, and that the filters are those of these thresholds in it. *)
Theorem exported_window_binary32 :
  B2R least_binary32 = bpow radix2 (-19) /\ B2R greatest_binary32 = bpow radix2 19.
Proof. split; [apply least_binary32_value | apply greatest_binary32_value]. Qed.
Theorem exported_filters_binary32 fused :
  published_filter32 fused =
    filter 24 128 _ _ (published_program fused) published_threshold least_binary32 greatest_binary32 /\
  reduced_filter32 fused =
    filter 24 128 _ _ (reduced_program fused) reduced_threshold least_binary32 greatest_binary32.
Proof. split; reflexivity. Qed.

(* The window of m in binary64, and that the filters are those of these thresholds in it. *)
Theorem exported_window_binary64 :
  B2R least_binary64 = bpow radix2 (-168) /\ B2R greatest_binary64 = bpow radix2 168.
Proof. split; [apply least_binary64_value | apply greatest_binary64_value]. Qed.
Theorem exported_filters_binary64 fused :
  published_filter64 fused =
    filter 53 1024 _ _ (published_program fused) published_threshold least_binary64 greatest_binary64 /\
  reduced_filter64 fused =
    filter 53 1024 _ _ (reduced_program fused) reduced_threshold least_binary64 greatest_binary64.
Proof. split; reflexivity. Qed.

(* The constants of the theorems about margins. *)
Theorem exported_margin_bounds :
  [unit_factor; vertex_radius_units; vertex_side_units; normal_units; offset_units; plane_lhs_units;
     plane_rhs_units; edge_square_units; edge_rhs_units; edge_side_units; edge_length_units; once; once_offset;
     twice; thrice_in_side; thrice] =
    [1.0625; 6; 15; 8; 4; 2; 6; 4; 8; 3; 6; 1.0625; 1.125; 2.125; 3.1; 3.2]%R.
Proof. reflexivity. Qed.

(* The constants of the certified predicate's coarse step. *)
Theorem exported_coarse_bounds :
  [coarse_degree_2; coarse_degree_4; coarse_degree_6] =
    [20.1875; 11.15625; 5.84375]%R.
Proof. reflexivity. Qed.

(* The constants of its conservative test. *)
Theorem exported_conservative_bounds :
  [conservative_error; conservative_square_error] =
    [10; 19.125]%R.
Proof. reflexivity. Qed.
