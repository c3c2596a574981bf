(* The filter's thresholds, which are exported: a comparison lhs > rhs is certain where |lhs - rhs|, as computed,
   exceeds n u m^degree, as computed; u = 2^-24 or 2^-53, m the greatest magnitude of a translated coordinate or the
   radius. The same whole numbers n serve both precisions, with fused multiply-adds or without. `covered` decides by
   computation that they are large enough. *)
From Coq Require Import ZArith List.
From Axiscert Require Import Vectors Expression Programs Filter.
Import ListNotations.
Open Scope Z_scope.

Definition published_threshold (K : comparison) : Z :=
  match K with
  | plane_radius => 2642
  | vertex_a_radius | vertex_b_radius | vertex_c_radius => 16
  | vertex_a_side_b | vertex_a_side_c | vertex_b_side_a | vertex_b_side_c | vertex_c_side_a | vertex_c_side_b => 29
  | edge_ab_radius | edge_bc_radius | edge_ca_radius => 13240
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 22412
  end.

Definition reduced_threshold (K : comparison) : Z :=
  match K with
  | edge_ab_radius | edge_bc_radius | edge_ca_radius => 233
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 425
  | _ => published_threshold K
  end.

Theorem published_covered_binary32 fused K : covered 24 (published_program fused K) (published_threshold K) = true.
Proof. destruct fused, K; vm_compute; reflexivity. Qed.
Theorem published_covered_binary64 fused K : covered 53 (published_program fused K) (published_threshold K) = true.
Proof. destruct fused, K; vm_compute; reflexivity. Qed.
Theorem reduced_covered_binary32 fused K : covered 24 (reduced_program fused K) (reduced_threshold K) = true.
Proof. destruct fused, K; vm_compute; reflexivity. Qed.
Theorem reduced_covered_binary64 fused K : covered 53 (reduced_program fused K) (reduced_threshold K) = true.
Proof. destruct fused, K; vm_compute; reflexivity. Qed.

(* For the plain programs in binary32 they are the least that `covered` accepts. *)
Theorem published_threshold_least K : covered 24 (published_program false K) (published_threshold K - 1) = false.
Proof. destruct K; vm_compute; reflexivity. Qed.
Theorem reduced_threshold_least K : covered 24 (reduced_program false K) (reduced_threshold K - 1) = false.
Proof. destruct K; vm_compute; reflexivity. Qed.

(* The bounds themselves, in binary32, for one comparison of each kind: the error of lhs - rhs before the last
   subtraction in units of u / 1024, and the degree. *)
Definition one_of_each := [plane_radius; vertex_a_radius; vertex_a_side_b; edge_ab_radius; edge_ab_side_c].
Definition errors (program : comparison -> expression * expression) := map (fun K => margin_error 24 (program K)) one_of_each.
Theorem published_errors :
  errors (published_program false) =
    [Some (2704780, 6%nat); Some (15376, 2%nat); Some (28698, 2%nat); Some (13556370, 6%nat); Some (22948126, 6%nat)] /\
  errors (published_program true) =
    [Some (2409736, 6%nat); Some (13324, 2%nat); Some (24594, 2%nat); Some (12441198, 6%nat); Some (21045799, 6%nat)].
Proof. split; vm_compute; reflexivity. Qed.
Theorem reduced_errors :
  errors (reduced_program false) =
    [Some (2704780, 6%nat); Some (15376, 2%nat); Some (28698, 2%nat); Some (237753, 4%nat); Some (434429, 4%nat)] /\
  errors (reduced_program true) =
    [Some (2409736, 6%nat); Some (13324, 2%nat); Some (24594, 2%nat); Some (209049, 4%nat); Some (381141, 4%nat)].
Proof. split; vm_compute; reflexivity. Qed.
