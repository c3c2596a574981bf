(* A program of Expression.v over IEEE-754 numbers, to the bit, as Flocq defines them: where its bound exists and m is inside a
   window, nothing overflows, nothing is NaN, and the result is the rounded program's value. *)
From Coq Require Import Reals ZArith Bool Lra Lia Psatz.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Expression Format.
Open Scope R_scope.

Section Run.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation fexp := (FLT_exp (3 - emax - prec) prec).
  Definition nearest := round radix2 fexp ZnearestE.

  Fixpoint run (x : leaf -> float) (e : expression) : float :=
    match e with
    | Leaf l => x l
    | Zero _ => B754_zero false
    | Neg a => Bopp (run x a)
    | Add a b => Bplus mode_NE (run x a) (run x b)
    | Sub a b => Bminus mode_NE (run x a) (run x b)
    | Mul a b => Bmult mode_NE (run x a) (run x b)
    | Fma a b c => Bfma mode_NE (run x a) (run x b) (run x c)
    | Cap _ a => run x a
    end.

  Lemma plus_fits (a b : float) : is_finite a = true -> is_finite b = true ->
    Rabs (nearest (B2R a + B2R b)) < bpow radix2 emax ->
    is_finite (Bplus mode_NE a b) = true /\ B2R (Bplus mode_NE a b) = nearest (B2R a + B2R b).
  Proof using Type.
    intros Fa Fb small. pose proof (Bplus_correct prec emax _ _ mode_NE a b Fa Fb) as H.
    rewrite Rlt_bool_true in H by exact small. tauto.
  Qed.
  Lemma minus_fits (a b : float) : is_finite a = true -> is_finite b = true ->
    Rabs (nearest (B2R a - B2R b)) < bpow radix2 emax ->
    is_finite (Bminus mode_NE a b) = true /\ B2R (Bminus mode_NE a b) = nearest (B2R a - B2R b).
  Proof using Type.
    intros Fa Fb small. pose proof (Bminus_correct prec emax _ _ mode_NE a b Fa Fb) as H.
    rewrite Rlt_bool_true in H by exact small. tauto.
  Qed.
  Lemma mult_fits (a b : float) : is_finite a = true -> is_finite b = true ->
    Rabs (nearest (B2R a * B2R b)) < bpow radix2 emax ->
    is_finite (Bmult mode_NE a b) = true /\ B2R (Bmult mode_NE a b) = nearest (B2R a * B2R b).
  Proof using Type.
    intros Fa Fb small. pose proof (Bmult_correct prec emax _ _ mode_NE a b) as H.
    rewrite Rlt_bool_true in H by exact small. rewrite Fa, Fb in H. tauto.
  Qed.
  Lemma fma_fits (a b c : float) : is_finite a = true -> is_finite b = true -> is_finite c = true ->
    Rabs (nearest (B2R a * B2R b + B2R c)) < bpow radix2 emax ->
    is_finite (Bfma mode_NE a b c) = true /\ B2R (Bfma mode_NE a b c) = nearest (B2R a * B2R b + B2R c).
  Proof using Type.
    intros Fa Fb Fc small. pose proof (Bfma_correct prec emax _ _ mode_NE a b c Fa Fb Fc) as H. cbv zeta in H.
    rewrite Rlt_bool_true in H by exact small. tauto.
  Qed.

  (* If a difference is finite, its operands were finite, and it is the rounded difference. *)
  Lemma minus_finite (a b : float) : is_finite (Bminus mode_NE a b) = true ->
    is_finite a = true /\ is_finite b = true /\ B2R (Bminus mode_NE a b) = nearest (B2R a - B2R b).
  Proof using Type.
    intros F.
    assert (is_finite a = true /\ is_finite b = true) as [Fa Fb].
    { destruct a as [| [] | |], b as [| [] | |]; cbn in F; try discriminate; auto. }
    repeat split; try assumption. pose proof (Bminus_correct prec emax _ _ mode_NE a b Fa Fb) as H.
    destruct Rlt_bool; [tauto |]. destruct H as [H _]. exfalso. revert F H.
    destruct (Bminus mode_NE a b); cbn; discriminate.
  Qed.

  Section Correct.
    Variable m : R.
    Hypothesis m_positive : 0 < m.
    Hypothesis prec20 : (20 <= prec)%Z.
    Hypothesis window : forall k, (k <= greatest_degree)%nat -> half_least (3 - emax - prec) <= unit_of_error prec * m ^ k.
    Hypothesis fits : forall k, (k <= greatest_degree)%nat -> 2048 * m ^ k < bpow radix2 emax.
    Variables (x : leaf -> R) (floats : leaf -> float).
    Hypothesis leaf_size : forall l, Rabs (x l) <= m.
    Hypothesis leaf_finite : forall l, is_finite (floats l) = true.
    Hypothesis leaf_close : forall l, Rabs (B2R (floats l) - x l) <= IZR (leaf_error l) * unit_of_error prec * m.

    Let X := fun l => B2R (floats l).

    Lemma bound_limits e : forall cap b, bound prec cap e = Some b ->
      (size b <= greatest_size)%Z /\ (error b <= greatest_error)%Z.
    Proof using Type.
      assert (rounds : forall cap a b, round_bounds prec cap a = Some b ->
        (size b <= greatest_size)%Z /\ (error b <= greatest_error)%Z).
      { intros cap a b. unfold round_bounds. destruct andb eqn:H; [| discriminate]. intros [= <-].
        apply andb_prop in H as [H _]. apply andb_prop in H as [H He]. apply andb_prop in H as [_ Hs].
        apply Z.leb_le in He, Hs. split; [exact Hs | exact He]. }
      induction e; intros cap b'; cbn [bound].
      - intros [= <-]. destruct l; cbn; unfold greatest_size, greatest_error; lia.
      - destruct Nat.leb; [| discriminate]. intros [= <-]. cbn. unfold greatest_size, greatest_error; lia.
      - apply IHe.
      - destruct (bound prec None e1); [| discriminate]. destruct (bound prec None e2); [| discriminate].
        cbn [bind]. destruct sum_bounds; [| discriminate]. apply rounds.
      - destruct (bound prec None e1); [| discriminate]. destruct (bound prec None e2); [| discriminate].
        cbn [bind]. destruct sum_bounds; [| discriminate]. apply rounds.
      - destruct (bound prec None e1); [| discriminate]. destruct (bound prec None e2); [| discriminate]. apply rounds.
      - destruct (bound prec None e1); [| discriminate]. destruct (bound prec None e2); [| discriminate].
        destruct (bound prec None e3); [| discriminate]. cbn [bind]. destruct sum_bounds; [| discriminate]. apply rounds.
      - apply IHe.
    Qed.

    (* The bound implies this for the rounded value, and that it is below the overflow threshold. *)
    Lemma computed_within e cap b : bound prec cap e = Some b ->
      (match cap with Some z => Rabs (exact x e) <= IZR z * m ^ degree e | None => True end) ->
      caps_hold x m e -> within prec m b (exact x e) (rounded nearest X e).
    Proof using leaf_close leaf_size m_positive prec20 window.
      apply (bound_sound prec ltac:(lia) nearest (half_least (3 - emax - prec))); try assumption.
      intros y. apply rnd_error. lia.
    Qed.

    Lemma computed_fits e cap b : bound prec cap e = Some b ->
      (match cap with Some z => Rabs (exact x e) <= IZR z * m ^ degree e | None => True end) ->
      caps_hold x m e -> Rabs (rounded nearest X e) < bpow radix2 emax.
    Proof using fits leaf_close leaf_size m_positive prec20 window.
      intros H known caps. destruct (bound_limits _ _ _ H) as [s_max e_max].
      destruct (computed_within _ _ _ H known caps) as [_ _ small xs close].
      pose proof (pow_lt m (of_degree b) m_positive) as positive. pose proof (unit_positive prec) as v0.
      apply Rle_lt_trans with (2 := fits _ small).
      replace (rounded nearest X e) with (exact x e + (rounded nearest X e - exact x e)) by ring.
      eapply Rle_trans; [apply Rabs_triang |].
      apply IZR_le in s_max, e_max. change (IZR greatest_size) with 1024 in s_max.
      assert (IZR (error b) * unit_of_error prec <= 1) as one.
      { apply Rle_trans with (IZR greatest_error * unit_of_error prec); [apply Rmult_le_compat_r; lra |].
        change (IZR greatest_error) with (bpow radix2 30). unfold unit_of_error. rewrite <- bpow_plus.
        change 1 with (bpow radix2 0). apply bpow_le. lia. }
      assert (IZR (error b) * unit_of_error prec * m ^ of_degree b <= 1 * m ^ of_degree b) by (apply Rmult_le_compat_r; lra).
      assert (IZR (size b) * m ^ of_degree b <= 1024 * m ^ of_degree b) by (apply Rmult_le_compat_r; lra).
      lra.
    Qed.

    Theorem run_correct e : forall cap b, bound prec cap e = Some b ->
      (match cap with Some z => Rabs (exact x e) <= IZR z * m ^ degree e | None => True end) ->
      caps_hold x m e -> is_finite (run floats e) = true /\ B2R (run floats e) = rounded nearest X e.
    Proof using fits leaf_close leaf_finite leaf_size m_positive prec20 window.
      induction e; intros cap bs H known caps; pose proof (computed_fits _ _ _ H known caps) as small;
        cbn [bound rounded run caps_hold] in *.
      - split; [apply leaf_finite | reflexivity].
      - split; reflexivity.
      - destruct (IHe None _ H I caps) as [F E]. rewrite is_finite_Bopp, B2R_Bopp, E. auto.
      - destruct (bound prec None e1) eqn:H1; [| discriminate]. destruct (bound prec None e2) eqn:H2; [| discriminate].
        destruct caps as [c1 c2].
        destruct (IHe1 None _ H1 I c1) as [F1 E1]. destruct (IHe2 None _ H2 I c2) as [F2 E2].
        rewrite <- E1, <- E2 in *. apply plus_fits; assumption.
      - destruct (bound prec None e1) eqn:H1; [| discriminate]. destruct (bound prec None e2) eqn:H2; [| discriminate].
        destruct caps as [c1 c2].
        destruct (IHe1 None _ H1 I c1) as [F1 E1]. destruct (IHe2 None _ H2 I c2) as [F2 E2].
        rewrite <- E1, <- E2 in *. apply minus_fits; assumption.
      - destruct (bound prec None e1) eqn:H1; [| discriminate]. destruct (bound prec None e2) eqn:H2; [| discriminate].
        destruct caps as [c1 c2].
        destruct (IHe1 None _ H1 I c1) as [F1 E1]. destruct (IHe2 None _ H2 I c2) as [F2 E2].
        rewrite <- E1, <- E2 in *. apply mult_fits; assumption.
      - destruct (bound prec None e1) eqn:H1; [| discriminate]. destruct (bound prec None e2) eqn:H2; [| discriminate].
        destruct (bound prec None e3) eqn:H3; [| discriminate]. destruct caps as (c1 & c2 & c3).
        destruct (IHe1 None _ H1 I c1) as [F1 E1]. destruct (IHe2 None _ H2 I c2) as [F2 E2].
        destruct (IHe3 None _ H3 I c3) as [F3 E3].
        rewrite <- E1, <- E2, <- E3 in *. apply fma_fits; assumption.
      - destruct caps as [c1 c2]. apply (IHe (Some c) bs); assumption.
    Qed.
  End Correct.
End Run.
