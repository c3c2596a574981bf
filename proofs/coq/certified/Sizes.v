(* Vector operations over IEEE-754 numbers, to the bit: if a result is finite, its operands were finite; and a result of
   at most k h^n, with h a power of two and k h^6 far below the overflow threshold, does not overflow. *)
From Coq Require Import Reals ZArith Bool Lra Lia Psatz.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Expression Format Run Filter CertifiedStep.
Open Scope R_scope.

Section Sizes.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Notation emin := (3 - emax - prec)%Z.
  Notation nearest := (nearest prec emax).
  Notation real_vec := (real_vec prec emax).

  (* The operations in the order of CertifiedStep.v, fused or not. *)
  Variable fused : bool.
  Definition float_sub (v w : float_vec) := FloatVec prec emax
    (Bminus mode_NE (fx _ _ v) (fx _ _ w)) (Bminus mode_NE (fy _ _ v) (fy _ _ w)) (Bminus mode_NE (fz _ _ v) (fz _ _ w)).
  Definition float_add_product (s x y : float) : float := if fused then Bfma mode_NE x y s else Bplus mode_NE s (Bmult mode_NE x y).
  Definition float_dot (v w : float_vec) : float :=
    float_add_product (float_add_product (Bmult mode_NE (fx _ _ v) (fx _ _ w)) (fy _ _ v) (fy _ _ w)) (fz _ _ v) (fz _ _ w).
  Definition float_minus_product (x y z : float) : float :=
    if fused then Bfma mode_NE (Bopp y) z x else Bminus mode_NE x (Bmult mode_NE y z).
  Definition float_cross (v w : float_vec) := FloatVec prec emax
    (float_minus_product (Bmult mode_NE (fy _ _ v) (fz _ _ w)) (fz _ _ v) (fy _ _ w))
    (float_minus_product (Bmult mode_NE (fz _ _ v) (fx _ _ w)) (fx _ _ v) (fz _ _ w))
    (float_minus_product (Bmult mode_NE (fx _ _ v) (fy _ _ w)) (fy _ _ v) (fx _ _ w)).
  (* n 2^e. *)
  Definition constant (n e : Z) : float := binary_normalize prec emax _ _ mode_NE n e false.

  (* If a sum is finite, its operands were finite, and it is the rounded sum. *)
  Lemma plus_finite (x y : float) : is_finite (Bplus mode_NE x y) = true ->
    is_finite x = true /\ is_finite y = true /\ B2R (Bplus mode_NE x y) = nearest (B2R x + B2R y).
  Proof using Type.
    intros F. assert (is_finite x = true /\ is_finite y = true) as [Fx Fy].
    { destruct x as [| [] | |], y as [| [] | |]; cbn in F; try discriminate; auto. }
    repeat split; try assumption. pose proof (Bplus_correct prec emax _ _ mode_NE x y Fx Fy) as H.
    destruct Rlt_bool; [tauto |]. destruct H as [H _]. exfalso. revert F H. destruct (Bplus mode_NE x y); cbn; discriminate.
  Qed.
  Lemma mult_finite (x y : float) : is_finite (Bmult mode_NE x y) = true ->
    is_finite x = true /\ is_finite y = true /\ B2R (Bmult mode_NE x y) = nearest (B2R x * B2R y).
  Proof using Type.
    intros F. assert (is_finite x = true /\ is_finite y = true) as [Fx Fy].
    { destruct x as [| [] | |], y as [| [] | |]; cbn in F; try discriminate; auto. }
    repeat split; try assumption. pose proof (Bmult_correct prec emax _ _ mode_NE x y) as H.
    destruct Rlt_bool; [tauto |]. exfalso. revert F H. destruct (Bmult mode_NE x y); cbn; discriminate.
  Qed.
  Lemma fma_finite (x y s : float) : is_finite (Bfma mode_NE x y s) = true ->
    is_finite x = true /\ is_finite y = true /\ is_finite s = true /\ B2R (Bfma mode_NE x y s) = nearest (B2R x * B2R y + B2R s).
  Proof using Type.
    intros F. assert (is_finite x = true /\ is_finite y = true /\ is_finite s = true) as (Fx & Fy & Fs).
    { destruct x as [[] | [] | | []], y as [[] | [] | | []], s as [| [] | |]; cbn in F; try discriminate; auto. }
    repeat split; try assumption. pose proof (Bfma_correct prec emax _ _ mode_NE x y s Fx Fy Fs) as H. cbv zeta in H.
    destruct Rlt_bool; [tauto |]. exfalso. revert F H. destruct (Bfma mode_NE x y s); cbn; discriminate.
  Qed.
  Definition finite_vec (v : float_vec) := is_finite (fx _ _ v) = true /\ is_finite (fy _ _ v) = true /\ is_finite (fz _ _ v) = true.
  Lemma square_finite v : is_finite (float_dot v v) = true ->
    finite_vec v /\ B2R (float_dot v v) = rounded_dot nearest fused (real_vec v) (real_vec v).
  Proof using Type.
    unfold float_dot, rounded_dot, float_add_product, finite_vec. intros F. destruct fused; cbn [cx cy cz Filter.real_vec].
    - apply fma_finite in F as (Fz & _ & F & ->). apply fma_finite in F as (Fy & _ & F & ->). apply mult_finite in F as (Fx & _ & ->).
      split; [auto |]. f_equal. rewrite Rplus_comm. f_equal. f_equal. apply Rplus_comm.
    - apply plus_finite in F as (F & Fz & ->). apply mult_finite in Fz as (Fz & _ & ->). apply plus_finite in F as (F & Fy & ->).
      apply mult_finite in Fy as (Fy & _ & ->). apply mult_finite in F as (Fx & _ & ->). auto.
  Qed.
  Lemma sub_finite v w : finite_vec (float_sub v w) ->
    finite_vec v /\ finite_vec w /\ real_vec (float_sub v w) = rounded_sub nearest (real_vec v) (real_vec w).
  Proof using Type.
    intros (X & Y & Z). cbn [fx fy fz float_sub] in X, Y, Z. unfold finite_vec, Filter.real_vec, rounded_sub.
    cbn [cx cy cz fx fy fz float_sub].
    apply minus_finite in X as (? & ? & ->). apply minus_finite in Y as (? & ? & ->). apply minus_finite in Z as (? & ? & ->). auto 10.
  Qed.
  Variable half : Z.  (* h = 2^half *)
  Hypothesis prec20 : (20 <= prec)%Z.
  Hypothesis half_nonneg : (0 <= half)%Z.
  Hypothesis fits_emax : (6 * half + 13 <= emax)%Z.
  Hypothesis deep : (emin <= -30)%Z.

  Lemma constant_spec n e : (0 <= n < 2 ^ prec)%Z -> (emin <= e <= emax - prec)%Z ->
    is_finite (constant n e) = true /\ B2R (constant n e) = IZR n * bpow radix2 e.
  Proof using prec20.
    intros n_small e_range. unfold constant. pose proof (binary_normalize_correct prec emax _ _ mode_NE n e false) as H. cbv zeta in H.
    assert (F2R (Float radix2 n e) = IZR n * bpow radix2 e) as value by reflexivity.
    assert (generic_format radix2 (FLT_exp emin prec) (F2R (Float radix2 n e))) as format.
    { apply generic_format_FLT. apply (FLT_spec _ _ _ _ (Float radix2 n e)); [reflexivity | |]; cbn [Fnum Fexp]; [rewrite Z.abs_eq by lia;
      apply n_small | lia]. }
    assert (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE) (F2R (Float radix2 n e)) = F2R (Float radix2 n e)) as same
      by (apply round_generic; [apply valid_rnd_round_mode | exact format]).
    rewrite same, Rlt_bool_true in H; [rewrite <- value; tauto |].
    rewrite value, Rabs_pos_eq by (apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0]).
    apply Rlt_le_trans with (bpow radix2 prec * bpow radix2 e).
    - apply Rmult_lt_compat_r; [apply bpow_gt_0 |]. rewrite <- IZR_Zpower by lia. apply IZR_lt, n_small.
    - rewrite <- bpow_plus. apply bpow_le. lia.
  Qed.

  (* A finite number and its size: at most k h^n. *)
  Let h := bpow radix2 half.
  Definition sized (n : nat) (k : R) (X : float) (x : R) := is_finite X = true /\ B2R X = x /\ Rabs x <= k * h ^ n.
  Definition sized_vec (n : nat) (k : R) (X : float_vec) (x : vec) :=
    sized n k (fx _ _ X) (cx x) /\ sized n k (fy _ _ X) (cy x) /\ sized n k (fz _ _ X) (cz x).
  Lemma h_power n : 1 <= h ^ n.
  Proof using half_nonneg. apply pow_R1_Rle. unfold h. change 1 with (bpow radix2 0). apply bpow_le. assumption. Qed.
  Lemma rounded_size n k K z : (n <= 6)%nat -> Rabs z <= k * h ^ n -> 1.0001 * k + 0.0001 <= K <= 4096 ->
    Rabs (nearest z) <= K * h ^ n /\ Rabs (nearest z) < bpow radix2 emax.
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 size KK. pose proof (rnd_error prec emin ltac:(lia) z) as off. pose proof (u_small prec prec20) as us.
    change (Rabs (nearest z - z) <= Expression.u prec * Rabs z + half_least emin) in off.
    assert (half_least emin <= 0.0001) as tiny.
    { unfold half_least. assert (bpow radix2 emin <= bpow radix2 (-30)) by (apply bpow_le; lia). cbn in *. lra. }
    pose proof (h_power n). pose proof (Rabs_pos z). pose proof (Rmult_le_compat_r (Rabs z) _ _ ltac:(lra) (proj2 us)).
    assert (Rabs (nearest z) <= K * h ^ n) as bound.
    { replace (nearest z) with (z + (nearest z - z)) by ring. eapply Rle_trans; [apply Rabs_triang |].
      assert ((1.0001 * k + 0.0001) * h ^ n <= K * h ^ n) by (apply Rmult_le_compat_r; lra). lra. }
    split; [assumption |]. eapply Rle_lt_trans; [exact bound |].
    apply Rle_lt_trans with (bpow radix2 (12 + 6 * half)); [| apply bpow_lt; lia].
    replace (12 + 6 * half)%Z with (12 + (half + (half + (half + (half + (half + half))))))%Z by lia. rewrite !bpow_plus. fold h.
    assert (h ^ n <= h ^ 6) by (apply Rle_pow; [apply (h_power 1) || (pose proof (h_power 1); cbn in *; lra) | assumption]).
    apply Rle_trans with (4096 * h ^ 6); [apply Rmult_le_compat; try lra; pose proof (Rabs_pos (nearest z)); nra |]. cbn [pow].
    change (bpow radix2 12) with 4096. lra.
  Qed.
  Lemma size_nonneg n k X x : sized n k X x -> 0 <= k.
  Proof using half_nonneg. intros (_ & _ & size). pose proof (Rabs_pos x). pose proof (h_power n). destruct (Rle_lt_dec 0 k); [assumption |]. nra. Qed.
  Lemma product_bound n n' k k' x y : Rabs x <= k * h ^ n -> Rabs y <= k' * h ^ n' -> Rabs (x * y) <= k * k' * h ^ (n + n').
  Proof using half.
    intros hx hy. rewrite Rabs_mult, pow_add. replace (k * k' * (h ^ n * h ^ n')) with (k * h ^ n * (k' * h ^ n')) by ring.
    apply Rmult_le_compat; auto using Rabs_pos.
  Qed.
  Lemma plus_sized n k k' K X x Y y : (n <= 6)%nat -> sized n k X x -> sized n k' Y y -> 1.0001 * (k + k') + 0.0001 <= K <= 4096 ->
    sized n K (Bplus mode_NE X Y) (nearest (x + y)).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 (FX & <- & sx) (FY & <- & sy) KK.
    destruct (rounded_size n (k + k') K (B2R X + B2R Y) n6) as [size fit]; [eapply Rle_trans; [apply Rabs_triang | lra] | exact KK |].
    destruct (plus_fits prec emax _ _ X Y FX FY fit). repeat split; assumption.
  Qed.
  Lemma minus_sized n k k' K X x Y y : (n <= 6)%nat -> sized n k X x -> sized n k' Y y -> 1.0001 * (k + k') + 0.0001 <= K <= 4096 ->
    sized n K (Bminus mode_NE X Y) (nearest (x - y)).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 (FX & <- & sx) (FY & <- & sy) KK.
    destruct (rounded_size n (k + k') K (B2R X - B2R Y) n6) as [size fit]; [unfold Rminus; eapply Rle_trans; [apply Rabs_triang |];
      rewrite Rabs_Ropp; lra | exact KK |].
    destruct (minus_fits prec emax _ _ X Y FX FY fit). repeat split; assumption.
  Qed.
  Lemma mult_sized n n' k k' K X x Y y : (n + n' <= 6)%nat -> sized n k X x -> sized n' k' Y y -> 1.0001 * (k * k') + 0.0001 <= K <= 4096 ->
    sized (n + n') K (Bmult mode_NE X Y) (nearest (x * y)).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 (FX & <- & sx) (FY & <- & sy) KK.
    destruct (rounded_size (n + n') (k * k') K (B2R X * B2R Y) n6) as [size fit]; [apply product_bound; assumption | exact KK |].
    destruct (mult_fits prec emax _ _ X Y FX FY fit). repeat split; assumption.
  Qed.
  Lemma fma_sized n n' k k' k'' K X x Y y Z z : (n + n' <= 6)%nat -> sized n k X x -> sized n' k' Y y -> sized (n + n') k'' Z z ->
    1.0001 * (k * k' + k'') + 0.0001 <= K <= 4096 -> sized (n + n') K (Bfma mode_NE X Y Z) (nearest (x * y + z)).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 (FX & <- & sx) (FY & <- & sy) (FZ & <- & sz) KK. pose proof (product_bound _ _ _ _ _ _ sx sy) as sp.
    destruct (rounded_size (n + n') (k * k' + k'') K (B2R X * B2R Y + B2R Z) n6) as [size fit];
      [eapply Rle_trans; [apply Rabs_triang | lra] | exact KK |].
    destruct (fma_fits prec emax _ _ X Y Z FX FY FZ fit). repeat split; assumption.
  Qed.
  Lemma opp_sized n k X x : sized n k X x -> sized n k (Bopp X) (- x).
  Proof using Type. intros (F & <- & s). unfold sized. rewrite is_finite_Bopp, B2R_Bopp, Rabs_Ropp. auto. Qed.

  (* The operations of the step. *)
  Lemma add_product_sized n n' k k' k'' K X x Y y Z z : (n + n' <= 6)%nat -> sized (n + n') k'' X x -> sized n k Y y -> sized n' k' Z z ->
    1.0003 * (k * k' + k'') + 0.001 <= K <= 4096 ->
    sized (n + n') K (float_add_product X Y Z) (if fused then nearest (x + y * z) else nearest (x + nearest (y * z))).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 HX HY HZ KK. pose proof (size_nonneg _ _ _ _ HX). pose proof (size_nonneg _ _ _ _ HY). pose proof (size_nonneg _ _ _ _ HZ).
    assert (0 <= k * k') by (apply Rmult_le_pos; assumption). unfold float_add_product. destruct fused.
    - rewrite Rplus_comm. apply fma_sized with k k' k''; try assumption; lra.
    - apply plus_sized with k'' (1.0001 * (k * k') + 0.0001); try assumption; [| lra]. apply mult_sized with k k'; try assumption; lra.
  Qed.
  Lemma dot_sized n n' k k' K v x w y : (n + n' <= 6)%nat -> sized_vec n k v x -> sized_vec n' k' w y ->
    3.01 * (k * k') + 0.01 <= K <= 4096 -> sized (n + n') K (float_dot v w) (rounded_dot nearest fused x y).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 (vx & vy & vz) (wx & wy & wz) KK. assert (0 <= k * k') by (apply Rmult_le_pos; eapply size_nonneg; eassumption).
    pose proof (mult_sized n n' k k' (1.0001 * (k * k') + 0.0001) _ _ _ _ n6 vx wx ltac:(lra)) as first.
    pose proof (add_product_sized n n' k k' _ (2.002 * (k * k') + 0.003) _ _ _ _ _ _ n6 first vy wy ltac:(lra)) as second.
    pose proof (add_product_sized n n' k k' _ K _ _ _ _ _ _ n6 second vz wz ltac:(lra)) as third.
    unfold float_dot, rounded_dot. destruct fused; exact third.
  Qed.
  Lemma minus_product_sized n n' k k' k'' K X x Y y Z z : (n + n' <= 6)%nat -> sized (n + n') k'' X x -> sized n k Y y -> sized n' k' Z z ->
    1.0003 * (k * k' + k'') + 0.001 <= K <= 4096 ->
    sized (n + n') K (float_minus_product X Y Z) (rounded_minus_product nearest fused x y z).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 HX HY HZ KK. pose proof (size_nonneg _ _ _ _ HX). pose proof (size_nonneg _ _ _ _ HY). pose proof (size_nonneg _ _ _ _ HZ).
    assert (0 <= k * k') by (apply Rmult_le_pos; assumption). unfold float_minus_product, rounded_minus_product. destruct fused.
    - replace (x - y * z) with (- y * z + x) by ring. apply fma_sized with k k' k''; try assumption; [apply opp_sized; assumption | lra].
    - apply minus_sized with k'' (1.0001 * (k * k') + 0.0001); try assumption; [| lra]. apply mult_sized with k k'; try assumption; lra.
  Qed.
  Lemma cross_sized n n' k k' K v x w y : (n + n' <= 6)%nat -> sized_vec n k v x -> sized_vec n' k' w y ->
    2.01 * (k * k') + 0.01 <= K <= 4096 -> sized_vec (n + n') K (float_cross v w) (rounded_cross nearest fused x y).
  Proof using deep fits_emax half_nonneg prec20.
    intros n6 (vx & vy & vz) (wx & wy & wz) KK. assert (0 <= k * k') by (apply Rmult_le_pos; eapply size_nonneg; eassumption).
    split; [| split]; cbn [fx fy fz cx cy cz float_cross rounded_cross];
      (eapply minus_product_sized; [exact n6 | eapply mult_sized; [exact n6 | eassumption | eassumption | split;
        [apply Rle_refl | lra]] | eassumption | eassumption | lra]).
  Qed.

  (* Bounds that S implies for the numbers from which it is computed. *)
  Lemma rounded_format x : generic_format radix2 (FLT_exp emin prec) (nearest x).
  Proof using prec_gt_0_. apply generic_format_round; [apply FLT_exp_valid; exact prec_gt_0_ | apply valid_rnd_N]. Qed.
  Lemma step_above x y : generic_format radix2 (FLT_exp emin prec) x -> 0 <= y -> x <= nearest (x + y).
  Proof using prec20.
    intros F y0. rewrite <- (rnd_format prec emin x F) at 1. apply (Format.rnd_monotone prec emin ltac:(lia)). lra.
  Qed.
  Lemma rounded_nonneg x : 0 <= x -> 0 <= nearest x.
  Proof using prec20. intros x0. rewrite <- (rnd_format prec emin 0 (generic_format_0 _ _)). apply (Format.rnd_monotone prec emin ltac:(lia)). exact x0.
  Qed.
  Lemma square_above v : let D := rounded_dot nearest fused v v in
    (nearest (cx v * cx v) <= D /\ nearest (cy v * cy v) <= D /\ nearest (cz v * cz v) <= D) /\ 0 <= D /\
      generic_format radix2 (FLT_exp emin prec) D.
  Proof using prec20 prec_gt_0_.
    cbv zeta. pose proof (Rle_0_sqr (cx v)) as x0. pose proof (Rle_0_sqr (cy v)) as y0. pose proof (Rle_0_sqr (cz v)) as z0.
    unfold Rsqr in *.
    assert (step : forall t q, generic_format radix2 (FLT_exp emin prec) t -> 0 <= t -> 0 <= q ->
      let s := if fused then nearest (t + q) else nearest (t + nearest q) in
      generic_format radix2 (FLT_exp emin prec) s /\ t <= s /\ nearest q <= s).
    { intros t q F t0 q0. destruct fused; cbv zeta; (split; [apply rounded_format |]); split.
      - apply step_above; assumption.
      - apply (Format.rnd_monotone prec emin ltac:(lia)). lra.
      - apply step_above; [assumption | apply rounded_nonneg; assumption].
      - rewrite Rplus_comm. apply step_above; [apply rounded_format | assumption]. }
    pose proof (rounded_nonneg _ x0). pose proof (rounded_nonneg _ y0). pose proof (rounded_nonneg _ z0).
    destruct (step (nearest (cx v * cx v)) (cy v * cy v) (rounded_format _) ltac:(assumption) y0) as (F1 & a1 & b1).
    destruct (step _ (cz v * cz v) F1 ltac:(lra) z0) as (F2 & a2 & b2).
    unfold rounded_dot. destruct fused; repeat split; try exact F2; lra.
  Qed.
  Lemma sum_nonneg (X Y : float) : is_finite (Bplus mode_NE X Y) = true -> 0 <= B2R X -> 0 <= B2R Y ->
    B2R X <= B2R (Bplus mode_NE X Y) /\ B2R Y <= B2R (Bplus mode_NE X Y).
  Proof using prec20.
    intros F X0 Y0. destruct (plus_finite _ _ F) as (_ & _ & ->).
    split; [| rewrite Rplus_comm]; apply step_above; try assumption; apply generic_format_B2R.
  Qed.
  Lemma root_size x : nearest (x * x) <= h ^ 2 -> Rabs x <= 1.001 * h ^ 1.
  Proof using deep half_nonneg prec20.
    intros H. pose proof (rnd_error prec emin ltac:(lia) (x * x)) as off. pose proof (u_small prec prec20) as us.
    change (Rabs (nearest (x * x) - x * x) <= Expression.u prec * Rabs (x * x) + half_least emin) in off.
    assert (half_least emin <= 0.0001) as tiny.
    { unfold half_least. assert (bpow radix2 emin <= bpow radix2 (-30)) by (apply bpow_le; lia). cbn in *. lra. }
    pose proof (Rle_0_sqr x) as x0. unfold Rsqr in x0. rewrite (Rabs_pos_eq (x * x)) in off by assumption.
    pose proof (Rmult_le_compat_r (x * x) _ _ x0 (proj2 us)). apply Rabs_le_inv in off. pose proof (h_power 2). pose proof (h_power 1).
    apply Rsqr_incr_0_var; [| lra]. rewrite <- Rsqr_abs. unfold Rsqr.
    replace (1.001 * h ^ 1 * (1.001 * h ^ 1)) with (1.002001 * h ^ 2) by (cbn [pow]; lra). lra.
  Qed.
End Sizes.
