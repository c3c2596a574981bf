(* The window of exponents of each comparison, in binary32 and binary64, plain and fused: the grid may be as fine as
   least_grid of its degree, the size as great as below. Inside it the kernel's sides are those of an unbounded exponent.
   One step beyond either end there are queries that over- or underflow (windows.jsonl), but for the published edge.side in
   binary32, whose 19 is what the caps of Programs.v reach, and 20 the end that searches find. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Expression Programs Caps Run Window.
Open Scope R_scope.

Definition prec_24 : Prec_gt_0 24 := eq_refl.
Definition prec_53 : Prec_gt_0 53 := eq_refl.
Definition emax_128 : Prec_lt_emax 24 128 := eq_refl.
Definition emax_1024 : Prec_lt_emax 53 1024 := eq_refl.

(* The least grids, by degree: 2^-24 for 6, 2^-37 for 4, 2^-74 for 2; in binary64 2^-179, 2^-268 and 2^-537. *)
Theorem least_grids :
  (least_grid 24 128 6, least_grid 24 128 4, least_grid 24 128 2) = (-24, -37, -74)%Z /\
  (least_grid 53 1024 6, least_grid 53 1024 4, least_grid 53 1024 2) = (-179, -268, -537)%Z.
Proof. split; reflexivity. Qed.

(* Sizes 2^h up to which everything stays finite. *)
Definition published_greatest32 (K : comparison) : Z :=
  match K with
  | plane_radius | edge_ab_radius | edge_bc_radius | edge_ca_radius => 20
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 19
  | _ => 63
  end.
Definition published_greatest64 (K : comparison) : Z :=
  match K with
  | plane_radius | edge_ab_radius | edge_bc_radius | edge_ca_radius => 169
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 169
  | _ => 511
  end.
Definition reduced_greatest32 (K : comparison) : Z :=
  match K with
  | edge_ab_radius | edge_bc_radius | edge_ca_radius => 31
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 30
  | _ => published_greatest32 K
  end.
Definition reduced_greatest64 (K : comparison) : Z :=
  match K with
  | edge_ab_radius | edge_bc_radius | edge_ca_radius => 255
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 254
  | _ => published_greatest64 K
  end.

Lemma window_size prec emax (floats : leaf -> binary_float prec emax) g h : in_window g h floats ->
  forall l, Rabs (B2R (floats l)) <= bpow radix2 h.
Proof. intros inside l. apply (inside l). Qed.

Theorem published_window32 fused K floats :
  in_window (least_grid 24 128 (window_degree (published_program fused K))) (published_greatest32 K) floats ->
  sides_as_unbounded prec_24 emax_128 floats (published_program fused K).
Proof.
  intros inside. apply (checked_window 24 128 prec_24 emax_128 (published_greatest32 K));
    [destruct fused, K; vm_compute; reflexivity | | exact inside].
  apply published_caps; [apply bpow_ge_0 | exact (window_size _ _ _ _ _ inside)].
Qed.
Theorem published_window64 fused K floats :
  in_window (least_grid 53 1024 (window_degree (published_program fused K))) (published_greatest64 K) floats ->
  sides_as_unbounded prec_53 emax_1024 floats (published_program fused K).
Proof.
  intros inside. apply (checked_window 53 1024 prec_53 emax_1024 (published_greatest64 K));
    [destruct fused, K; vm_compute; reflexivity | | exact inside].
  apply published_caps; [apply bpow_ge_0 | exact (window_size _ _ _ _ _ inside)].
Qed.
Theorem reduced_window32 fused K floats :
  in_window (least_grid 24 128 (window_degree (reduced_program fused K))) (reduced_greatest32 K) floats ->
  sides_as_unbounded prec_24 emax_128 floats (reduced_program fused K).
Proof.
  intros inside. apply (checked_window 24 128 prec_24 emax_128 (reduced_greatest32 K));
    [destruct fused, K; vm_compute; reflexivity | | exact inside].
  apply reduced_caps; [apply bpow_ge_0 | exact (window_size _ _ _ _ _ inside)].
Qed.
Theorem reduced_window64 fused K floats :
  in_window (least_grid 53 1024 (window_degree (reduced_program fused K))) (reduced_greatest64 K) floats ->
  sides_as_unbounded prec_53 emax_1024 floats (reduced_program fused K).
Proof.
  intros inside. apply (checked_window 53 1024 prec_53 emax_1024 (reduced_greatest64 K));
    [destruct fused, K; vm_compute; reflexivity | | exact inside].
  apply reduced_caps; [apply bpow_ge_0 | exact (window_size _ _ _ _ _ inside)].
Qed.
