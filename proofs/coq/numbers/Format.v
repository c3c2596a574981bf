(* Rounding to nearest, ties to even, in a format with gradual underflow satisfies the conditions of Expression.v on an
   arithmetic, and a filter's threshold, scaled by a power of m and computed in that format, is large enough. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core Relative Plus_error.
From Axiscert Require Import Expression.
Open Scope R_scope.

Section Format.
  Variables p emin : Z.
  Hypothesis p_positive : (0 < p)%Z.
  Let fexp := FLT_exp emin p.
  Let rnd := round radix2 fexp ZnearestE.
  Let u := u p.
  Definition half_least := / 2 * bpow radix2 emin.

  Lemma half_bpow : / 2 * bpow radix2 (- p + 1) = u.
  Proof using Type. unfold u, Expression.u. rewrite bpow_plus. change (bpow radix2 1) with 2. lra. Qed.

  Lemma rnd_error x : Rabs (rnd x - x) <= u * Rabs x + half_least.
  Proof using fexp p_positive.
    destruct (error_N_FLT radix2 emin p p_positive (fun t => negb (Z.even t)) x) as (eps & eta & small & tiny & _ & equal).
    unfold rnd, fexp. rewrite equal. rewrite half_bpow in small.
    replace (x * (1 + eps) + eta - x) with (eps * x + eta) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. apply Rplus_le_compat; [| exact tiny].
    rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos | assumption].
  Qed.

  Instance prec_positive : Prec_gt_0 p := p_positive.

  (* A difference of two numbers of the format has no underflow error. *)
  Lemma difference_error a b : generic_format radix2 fexp a -> generic_format radix2 fexp b ->
    Rabs (rnd (a - b) - (a - b)) <= u * Rabs (a - b) /\ Rabs (a - b) <= (1 + u) * Rabs (rnd (a - b)).
  Proof using emin p_positive.
    intros Fa Fb.
    assert (generic_format radix2 fexp (- b)) as Fb' by (apply generic_format_opp; assumption).
    destruct (FLT_plus_error_N_ex radix2 emin p (fun t => negb (Z.even t)) a (- b) Fa Fb') as (eps & small & equal).
    change (rnd (a - b) = (a - b) * (1 + eps)) in equal.
    assert (u_ro radix2 p = u) as uro by (unfold u_ro; apply half_bpow). rewrite uro in small.
    assert (0 < u) as u0 by apply bpow_gt_0.
    assert (u / (1 + u) <= u) as smaller.
    { apply Rmult_le_reg_r with (1 + u); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra. }
    rewrite equal. set (x := a - b). split.
    - replace (x * (1 + eps) - x) with (eps * x) by ring. rewrite Rabs_mult.
      apply Rmult_le_compat_r; [apply Rabs_pos | lra].
    - rewrite Rabs_mult.
      assert (1 - u / (1 + u) <= Rabs (1 + eps)) as below.
      { unfold Rabs in *. repeat destruct Rcase_abs; lra. }
      replace (1 - u / (1 + u)) with (/ (1 + u)) in below by (field; lra).
      pose proof (Rmult_le_compat_l (Rabs x) _ _ (Rabs_pos x) below) as scaled.
      pose proof (Rmult_le_compat_l (1 + u) _ _ ltac:(lra) scaled) as scaled'.
      replace ((1 + u) * (Rabs x * / (1 + u))) with (Rabs x) in scaled' by (field; lra). exact scaled'.
  Qed.

  Lemma rnd_monotone x y : x <= y -> rnd x <= rnd y.
  Proof using fexp p_positive. apply round_le; [apply FLT_exp_valid; exact p_positive | apply valid_rnd_N]. Qed.
  Lemma rnd_format x : generic_format radix2 fexp x -> rnd x = x.
  Proof using emin p. apply round_generic, valid_rnd_N. Qed.

  (* A rounded value beyond a number of the format was beyond it before rounding. *)
  Lemma beyond x t : generic_format radix2 fexp t -> t < rnd x -> t < x.
  Proof using emin p_positive. intros Ft more. destruct (Rlt_le_dec t x) as [| less]; [assumption |].
    apply rnd_monotone in less. rewrite (rnd_format t Ft) in less. lra. Qed.
  Lemma below x t : generic_format radix2 fexp t -> rnd x < t -> x < t.
  Proof using emin p_positive. intros Ft less. destruct (Rlt_le_dec x t) as [| more]; [assumption |].
    apply rnd_monotone in more. rewrite (rnd_format t Ft) in more. lra. Qed.
End Format.

(* The threshold for an error of E units is n u m^k, where the whole number n leaves room for the rounding of m^k and of
   the product, for m being a bound of the rounded coordinates instead of the exact ones, and for underflow. *)
Definition threshold_covers (n E : Z) : bool :=
  ((0 <=? E) && (0 <=? n) && (n * 2 ^ 10 + E + 2 ^ 15 <=? 2 ^ 15 * (n * 2 ^ 10 - E)))%Z%bool.

(* T = rnd (c mk), c = n u, |mk - m^k| <= power_error unit m^k; the error is at most E unit ((1 + u) m)^k. *)
Lemma threshold_enough p n E k m mk T eta power_error :
  (20 <= p)%Z -> (k <= 6)%nat -> 0 < m -> 0 <= eta -> (0 <= power_error <= 2 ^ 13)%Z ->
  eta <= unit_of_error p * m ^ k ->
  threshold_covers n E = true ->
  Rabs (mk - m ^ k) <= IZR power_error * unit_of_error p * m ^ k ->
  Rabs (T - IZR n * u p * mk) <= u p * Rabs (IZR n * u p * mk) + eta ->
  IZR E * unit_of_error p * ((1 + u p) * m) ^ k <= T.
Proof.
  intros p20 k6 m0 eta0 power underflow covers mk_close T_close.
  unfold threshold_covers in covers. apply andb_prop in covers as [covers enough]. apply andb_prop in covers as [E0 n0].
  apply Z.leb_le in E0, n0, enough.
  assert (IZR n * 1024 + IZR E + 32768 <= 32768 * (IZR n * 1024 - IZR E)) as enough'.
  { rewrite <- !mult_IZR, <- minus_IZR, <- mult_IZR, <- !plus_IZR. apply IZR_le. exact enough. }
  apply IZR_le in E0, n0. destruct power as [power0 power]. apply IZR_le in power0, power.
  change (IZR (2 ^ 13)) with 8192 in power.
  rewrite Rpow_mult_distr. pose proof (pow_lt m k m0) as mk0. set (M := m ^ k) in *.
  pose proof (unit_positive p) as v0. pose proof (u_units p) as uv.
  set (v := unit_of_error p) in *.
  assert (u p <= / 1048576) as u_small.
  { unfold u. apply Rle_trans with (bpow radix2 (-20)); [apply bpow_le; lia | cbn; lra]. }
  assert (0 < u p) as u0 by apply bpow_gt_0. set (w := u p) in *.
  assert ((1 + w) ^ k <= 1 + 8 * w) as grow.
  { assert (w ^ 2 <= w / 1000000) by nra.
    apply Rle_trans with ((1 + w) ^ 6); [apply Rle_pow; [lra | assumption] |].
    assert (0 <= w <= / 1048576) by lra.
    assert ((1 + w) ^ 2 <= 1 + 2.01 * w) as g2 by (cbn [pow]; nra).
    replace ((1 + w) ^ 6) with ((1 + w) ^ 2 * (1 + w) ^ 2 * (1 + w) ^ 2) by ring.
    assert (0 < (1 + w) ^ 2) by (apply pow_lt; lra). set (s := (1 + w) ^ 2) in *.
    assert (s * s <= (1 + 2.01 * w) * (1 + 2.01 * w)) by (apply Rmult_le_compat; lra).
    assert (s * s * s <= (1 + 2.01 * w) * (1 + 2.01 * w) * (1 + 2.01 * w)) by (apply Rmult_le_compat; nra).
    nra. }
  (* mk >= M (1 - 8 w) *)
  assert (M * (1 - 8 * w) <= mk) as low.
  { assert (IZR power_error * v * M <= 8 * w * M).
    { apply Rmult_le_compat_r; [lra |]. rewrite uv. nra. }
    apply Rabs_le_inv in mk_close. lra. }
  assert (0 <= mk) as mk_nonneg by nra.
  assert (0 <= IZR n * w * mk) as T0 by (repeat apply Rmult_le_pos; lra).
  rewrite (Rabs_pos_eq _ T0) in T_close. apply Rabs_le_inv in T_close.
  assert ((1 - w) * (IZR n * w * mk) - v * M <= T) as T_low by lra.
  apply Rle_trans with (2 := T_low).
  assert (IZR n * w * (M * (1 - 8 * w)) <= IZR n * w * mk) as step.
  { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | assumption]. }
  apply Rle_trans with ((1 - w) * (IZR n * w * (M * (1 - 8 * w))) - v * M).
  2: { apply Rplus_le_compat_r. apply Rmult_le_compat_l; lra. }
  apply Rle_trans with (IZR E * v * ((1 + 8 * w) * M)).
  { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra |]. apply Rmult_le_compat_r; lra. }
  replace (IZR E * v * ((1 + 8 * w) * M)) with (IZR E * (1 + 8 * w) * (v * M)) by ring.
  replace ((1 - w) * (IZR n * w * (M * (1 - 8 * w))) - v * M)
    with ((IZR n * 1024 * ((1 - w) * (1 - 8 * w)) - 1) * (v * M)) by
    (transitivity ((1 - w) * (IZR n * (1024 * v) * (M * (1 - 8 * w))) - v * M); [ring | rewrite <- uv; reflexivity]).
  apply Rmult_le_compat_r; [apply Rmult_le_pos; lra |].
  assert (1 - / 32768 <= (1 - w) * (1 - 8 * w)) as product by nra.
  assert (IZR n * 1024 * (1 - / 32768) <= IZR n * 1024 * ((1 - w) * (1 - 8 * w))).
  { apply Rmult_le_compat_l; lra. }
  assert (IZR E * (8 * w) <= IZR E * / 32768) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.
