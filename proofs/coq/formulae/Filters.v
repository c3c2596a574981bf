(* The filter theorem for binary32 and binary64, for the published and the reduced formulae, plain and fused: whatever
   the thirteen numbers of a query are, NaN and infinities included, the answer `separated` means that every point of
   the triangle is farther from P than r, `contact` that some point is not, and an answer other than `undecided` that
   every number compared was finite: nothing overflowed, nothing was NaN. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Sides RecordedIsSat7 Expression Programs Caps Format RecordedIsProgram Run Filter
  Thresholds.
Open Scope R_scope.

Definition never_lies {prec emax} (answer_to : float_query prec emax -> answer)
  (is_compared : float_query prec emax -> binary_float prec emax -> Prop) : Prop := forall q,
  (answer_to q = answer_separated -> query_separated (real_query prec emax q)) /\
  (answer_to q = answer_contact -> ~ query_separated (real_query prec emax q)) /\
  (answer_to q <> answer_undecided -> forall x, is_compared q x -> is_finite x = true).

Lemma bpow_pow e k : bpow radix2 e ^ k = bpow radix2 (e * Z.of_nat k).
Proof.
  induction k as [| k IH]; [rewrite Z.mul_0_r; reflexivity |].
  cbn [pow]. rewrite IH, <- bpow_plus. f_equal. lia.
Qed.

(* Windows of m in powers of two, in which no program of degree at most 6 over- or underflows. *)
Lemma low_window prec emax e k : (k <= greatest_degree)%nat -> (e <= 0)%Z ->
  (3 - emax - prec - 1 <= - (prec + 10) + e * 6)%Z ->
  half_least (3 - emax - prec) <= unit_of_error prec * bpow radix2 e ^ k.
Proof.
  intros small e0 room. unfold half_least, unit_of_error, greatest_degree in *. rewrite bpow_pow, <- bpow_plus.
  replace (/ 2) with (bpow radix2 (-1)) by reflexivity. rewrite <- bpow_plus. apply bpow_le. nia.
Qed.
Lemma high_window emax e k : (k <= greatest_degree)%nat -> (0 <= e)%Z -> (12 + e * 6 < emax)%Z ->
  4096 * bpow radix2 e ^ k < bpow radix2 emax.
Proof.
  intros small e0 room. unfold greatest_degree in *. rewrite bpow_pow.
  replace 4096 with (bpow radix2 12) by reflexivity. rewrite <- bpow_plus. apply bpow_lt. nia.
Qed.

Lemma published_right fused q m : 0 <= query_radius q ->
  (some_axis (fun K => nonstrict K (exact_sides (exact_leaves q m) (published_program fused K))) <-> query_separated q).
Proof.
  intros r0. rewrite <- recorded_published_exact_right by assumption.
  split; apply some_axis_mono; intros K; rewrite (published_exact_program fused q m K); auto.
Qed.
Lemma reduced_right fused q m : 0 <= query_radius q ->
  (some_axis (fun K => nonstrict K (exact_sides (exact_leaves q m) (reduced_program fused K))) <-> query_separated q).
Proof.
  intros r0. rewrite <- recorded_reduced_exact_right by assumption.
  split; apply some_axis_mono; intros K; rewrite (reduced_exact_program fused q m K); auto.
Qed.

Section Instance.
  Variables prec emax e : Z.  (* the window of m is 2^-e .. 2^e *)
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Hypothesis prec20 : (20 <= prec)%Z.
  Hypothesis e0 : (0 <= e)%Z.
  Hypothesis low_room : (3 - emax - prec - 1 <= - (prec + 10) + - e * 6)%Z.
  Hypothesis high_room : (12 + e * 6 < emax)%Z.
  Variables lo hi : binary_float prec emax.
  Hypothesis lo_finite : is_finite lo = true.
  Hypothesis hi_finite : is_finite hi = true.
  Hypothesis lo_value : B2R lo = bpow radix2 (- e).
  Hypothesis hi_value : B2R hi = bpow radix2 e.
  Variables (program : comparison -> expression * expression) (threshold : comparison -> Z).
  Hypothesis all_covered : forall K, covered prec (program K) (threshold K) = true.
  Hypothesis caps : forall x m K, 0 <= m -> (forall l, Rabs (x l) <= m) ->
    caps_hold x m (fst (program K)) /\ caps_hold x m (snd (program K)).
  Hypothesis exactly_right : forall q m, 0 <= query_radius q ->
    (some_axis (fun K => nonstrict K (exact_sides (exact_leaves q m) (program K))) <-> query_separated q).

  Theorem instance_never_lies :
    never_lies (filter prec emax _ _ program threshold lo hi) (compared prec emax _ _ program threshold).
  Proof using all_covered caps e0 exactly_right hi_finite hi_value high_room lo_finite lo_value low_room prec20.
    assert (0 < B2R lo) by (rewrite lo_value; apply bpow_gt_0).
    assert (forall k, (k <= greatest_degree)%nat ->
      half_least (3 - emax - prec) <= unit_of_error prec * B2R lo ^ k).
    { intros. rewrite lo_value. apply low_window; lia. }
    assert (forall k, (k <= greatest_degree)%nat -> 4096 * B2R hi ^ k < bpow radix2 emax).
    { intros. rewrite hi_value. apply high_window; lia. }
    repeat split; [apply filter_separated | apply filter_contact | apply filter_finite]; assumption.
  Qed.
End Instance.

(* binary32, 2^-19 <= m <= 2^19; binary64, 2^-168 <= m <= 2^168. *)
#[global] Instance prec_24 : Prec_gt_0 24 := eq_refl.
#[global] Instance prec_53 : Prec_gt_0 53 := eq_refl.
#[global] Instance emax_128 : Prec_lt_emax 24 128 := eq_refl.
#[global] Instance emax_1024 : Prec_lt_emax 53 1024 := eq_refl.
Definition least_binary32 : binary_float 24 128 := @B754_finite 24 128 false 8388608 (-42) eq_refl.
Definition greatest_binary32 : binary_float 24 128 := @B754_finite 24 128 false 8388608 (-4) eq_refl.
Definition least_binary64 : binary_float 53 1024 := @B754_finite 53 1024 false 4503599627370496 (-220) eq_refl.
Definition greatest_binary64 : binary_float 53 1024 := @B754_finite 53 1024 false 4503599627370496 116 eq_refl.

Lemma power_of_two m e f : IZR (Z.pos m) = bpow radix2 f -> F2R (Float radix2 (Z.pos m) e) = bpow radix2 (f + e).
Proof. intros H. unfold F2R; cbn [Fnum Fexp]. rewrite H, <- bpow_plus. reflexivity. Qed.

Definition published_filter32 (fused : bool) :=
  filter 24 128 _ _ (published_program fused) published_threshold least_binary32 greatest_binary32.
Definition published_filter64 (fused : bool) :=
  filter 53 1024 _ _ (published_program fused) published_threshold least_binary64 greatest_binary64.
Definition reduced_filter32 (fused : bool) :=
  filter 24 128 _ _ (reduced_program fused) reduced_threshold least_binary32 greatest_binary32.
Definition reduced_filter64 (fused : bool) :=
  filter 53 1024 _ _ (reduced_program fused) reduced_threshold least_binary64 greatest_binary64.

(* The numbers that each filter compares. *)
Definition published_compared32 (fused : bool) := compared 24 128 _ _ (published_program fused) published_threshold.
Definition published_compared64 (fused : bool) := compared 53 1024 _ _ (published_program fused) published_threshold.
Definition reduced_compared32 (fused : bool) := compared 24 128 _ _ (reduced_program fused) reduced_threshold.
Definition reduced_compared64 (fused : bool) := compared 53 1024 _ _ (reduced_program fused) reduced_threshold.

Lemma least_binary32_value : B2R least_binary32 = bpow radix2 (- (19)).
Proof. exact (power_of_two 8388608 (-42) 23 eq_refl). Qed.
Lemma greatest_binary32_value : B2R greatest_binary32 = bpow radix2 19.
Proof. exact (power_of_two 8388608 (-4) 23 eq_refl). Qed.
Lemma least_binary64_value : B2R least_binary64 = bpow radix2 (- (168)).
Proof. exact (power_of_two 4503599627370496 (-220) 52 eq_refl). Qed.
Lemma greatest_binary64_value : B2R greatest_binary64 = bpow radix2 168.
Proof. exact (power_of_two 4503599627370496 116 52 eq_refl). Qed.

Theorem published_filter32_never_lies fused : never_lies (published_filter32 fused) (published_compared32 fused).
Proof.
  apply (instance_never_lies 24 128 19); try lia; try reflexivity.
  - exact least_binary32_value.
  - exact greatest_binary32_value.
  - apply published_covered_binary32.
  - intros. apply published_caps; assumption.
  - apply published_right.
Qed.
Theorem published_filter64_never_lies fused : never_lies (published_filter64 fused) (published_compared64 fused).
Proof.
  apply (instance_never_lies 53 1024 168); try lia; try reflexivity.
  - exact least_binary64_value.
  - exact greatest_binary64_value.
  - apply published_covered_binary64.
  - intros. apply published_caps; assumption.
  - apply published_right.
Qed.
Theorem reduced_filter32_never_lies fused : never_lies (reduced_filter32 fused) (reduced_compared32 fused).
Proof.
  apply (instance_never_lies 24 128 19); try lia; try reflexivity.
  - exact least_binary32_value.
  - exact greatest_binary32_value.
  - apply reduced_covered_binary32.
  - intros. apply reduced_caps; assumption.
  - apply reduced_right.
Qed.
Theorem reduced_filter64_never_lies fused : never_lies (reduced_filter64 fused) (reduced_compared64 fused).
Proof.
  apply (instance_never_lies 53 1024 168); try lia; try reflexivity.
  - exact least_binary64_value.
  - exact greatest_binary64_value.
  - apply reduced_covered_binary64.
  - intros. apply reduced_caps; assumption.
  - apply reduced_right.
Qed.
