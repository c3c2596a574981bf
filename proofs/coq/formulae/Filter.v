(* A filter over IEEE-754 numbers that is never wrong, for any format and any programs of the sixteen comparisons: it
   computes both sides as the kernel does, and takes lhs > rhs as certain where lhs - rhs, as computed, exceeds n u m^k,
   as computed. *)
From Coq Require Import Reals ZArith Bool List Lra Lia Psatz.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Recorded Sides RecordedIsSat7 Expression RecordedIsProgram Format Run.
Import ListNotations.
Open Scope R_scope.

Inductive answer := answer_separated | answer_contact | answer_undecided.

Definition some_axis_b (holds : comparison -> bool) : bool :=
  holds plane_radius ||
  (holds vertex_a_radius && holds vertex_a_side_b && holds vertex_a_side_c) ||
  (holds vertex_b_radius && holds vertex_b_side_a && holds vertex_b_side_c) ||
  (holds vertex_c_radius && holds vertex_c_side_a && holds vertex_c_side_b) ||
  (holds edge_ab_radius && holds edge_ab_side_c) ||
  (holds edge_bc_radius && holds edge_bc_side_a) ||
  (holds edge_ca_radius && holds edge_ca_side_b).

Lemma some_axis_b_spec f : some_axis_b f = true <-> some_axis (fun K => f K = true).
Proof. unfold some_axis_b, some_axis. rewrite !orb_true_iff, !andb_true_iff. tauto. Qed.

(* m^k for the degrees that occur. *)
Definition power (k : nat) : expression :=
  let m2 := Mul (Leaf magnitude) (Leaf magnitude) in
  match k with 2%nat => m2 | 4%nat => Mul m2 m2 | _ => Mul (Mul m2 m2) m2 end.

(* n u m^k covers the error of a comparison's sides; this is decided by computation. *)
Definition covered (p : Z) (sides : expression * expression) (n : Z) : bool :=
  let (l, r) := sides in
  let k := degree l in
  match bound p None l, bound p None r, bound p None (Sub l r), bound p None (power k) with
  | Some bl, Some br, Some _, Some bp =>
    (Nat.eqb (of_degree bl) (of_degree br) && Nat.eqb (of_degree bp) k &&
     (Nat.eqb k 2 || Nat.eqb k 4 || Nat.eqb k 6) &&
     threshold_covers n (error bl + error br) && (error bp <=? 2 ^ 13)%Z && (n <? 2 ^ p)%Z)%bool
  | _, _, _, _ => false
  end.

Section Filter.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Hypothesis prec20 : (20 <= prec)%Z.
  Notation float := (binary_float prec emax).
  Notation nearest := (nearest prec emax).
  Notation u := (u prec).

  Record float_vec := FloatVec { fx : float; fy : float; fz : float }.
  Record float_query := FloatQuery { fa : float_vec; fb : float_vec; fc : float_vec; fp : float_vec; fr : float }.

  Definition real_vec (v : float_vec) := Vec (B2R (fx v)) (B2R (fy v)) (B2R (fz v)).
  Definition real_query (q : float_query) :=
    Query (real_vec (fa q)) (real_vec (fb q)) (real_vec (fc q)) (real_vec (fp q)) (B2R (fr q)).

  Variable program : comparison -> expression * expression.
  Variable threshold : comparison -> Z.  (* n *)
  Variables lo hi : float.               (* the window of m *)

  (* The program of the filter. *)
  Definition coordinates := [ax; ay; az; bx; by_; bz; cx_; cy_; cz_].
  Definition float_leaf (q : float_query) (m : float) (l : leaf) : float :=
    match l with
    | ax => Bminus mode_NE (fx (fa q)) (fx (fp q))
    | ay => Bminus mode_NE (fy (fa q)) (fy (fp q))
    | az => Bminus mode_NE (fz (fa q)) (fz (fp q))
    | bx => Bminus mode_NE (fx (fb q)) (fx (fp q))
    | by_ => Bminus mode_NE (fy (fb q)) (fy (fp q))
    | bz => Bminus mode_NE (fz (fb q)) (fz (fp q))
    | cx_ => Bminus mode_NE (fx (fc q)) (fx (fp q))
    | cy_ => Bminus mode_NE (fy (fc q)) (fy (fp q))
    | cz_ => Bminus mode_NE (fz (fc q)) (fz (fp q))
    | radius => fr q
    | magnitude => m
    end.
  Definition greater (x y : float) := if Bltb x y then y else x.
  (* The greatest of the translated coordinates' magnitudes and the radius. *)
  Definition greatest (q : float_query) : float :=
    fold_left (fun m l => greater m (Babs (float_leaf q (fr q) l))) coordinates (fr q).
  Definition inside (q : float_query) : bool :=
    (Bleb (B754_zero false) (fr q) && Bleb (fr q) hi &&
     forallb (fun l => Bleb (Babs (float_leaf q (fr q) l)) hi) coordinates && Bleb lo (greatest q))%bool.

  Definition coefficient (K : comparison) : float := binary_normalize prec emax _ _ mode_NE (threshold K) (- prec) false.
  Definition values (q : float_query) := run prec emax _ _ (float_leaf q (greatest q)).
  Definition limit (q : float_query) (K : comparison) : float :=
    Bmult mode_NE (coefficient K) (values q (power (degree (fst (program K))))).
  Definition margin (q : float_query) (K : comparison) : float :=
    Bminus mode_NE (values q (fst (program K))) (values q (snd (program K))).
  (* The numbers that are compared. Without division an infinity or a NaN stays one, so where they are finite, every
     number computed on the way to them is finite. *)
  Definition compared_at (q : float_query) (K : comparison) : list float :=
    [values q (fst (program K)); values q (snd (program K)); margin q K; limit q K].
  Definition compared (q : float_query) (x : float) : Prop := exists K, In x (compared_at q K).
  Definition certainly_greater q K : bool := Bltb (limit q K) (margin q K).
  Definition certainly_less q K : bool := Bltb (margin q K) (Bopp (limit q K)).

  Definition filter (q : float_query) : answer :=
    if negb (inside q) then answer_undecided
    else if some_axis_b (certainly_greater q) then answer_separated
    else if negb (some_axis_b (fun K => negb (certainly_less q K))) then answer_contact
    else answer_undecided.

  (* The conditions on the programs, the thresholds and the window. *)
  Hypothesis all_covered : forall K, covered prec (program K) (threshold K) = true.
  Hypothesis caps : forall x m K, 0 <= m -> (forall l, Rabs (x l) <= m) ->
    caps_hold x m (fst (program K)) /\ caps_hold x m (snd (program K)).
  Hypothesis exactly_right : forall q m, 0 <= query_radius q ->
    (some_axis (fun K => nonstrict K (exact_sides (exact_leaves q m) (program K))) <-> query_separated q).
  Hypothesis lo_finite : is_finite lo = true.
  Hypothesis hi_finite : is_finite hi = true.
  Hypothesis lo_positive : 0 < B2R lo.
  Hypothesis lo_window : forall k, (k <= greatest_degree)%nat ->
    half_least (3 - emax - prec) <= unit_of_error prec * B2R lo ^ k.
  Hypothesis hi_window : forall k, (k <= greatest_degree)%nat -> 4096 * B2R hi ^ k < bpow radix2 emax.

  Lemma bounded_finite (x : float) : Bleb (Babs x) hi = true -> is_finite x = true /\ Rabs (B2R x) <= B2R hi.
  Proof using hi_finite.
    intros H. assert (is_finite x = true) as F.
    { revert H. clear -hi_finite. destruct x as [| s | |], hi as [| | |]; cbn in *; try discriminate; auto. }
    split; [assumption |]. rewrite Bleb_correct in H by (rewrite ?is_finite_Babs; assumption).
    rewrite B2R_Babs in H. revert H. case Rle_bool_spec; intros; [assumption | discriminate].
  Qed.

  Lemma radius_finite (x : float) : Bleb (B754_zero false) x = true -> Bleb x hi = true ->
    is_finite x = true /\ 0 <= B2R x <= B2R hi.
  Proof using hi_finite.
    intros H0 H1. assert (is_finite x = true) as F.
    { revert H0 H1. clear -hi_finite. destruct x as [| [] | |], hi as [| | |]; cbn in *; try discriminate; auto. }
    split; [assumption |]. rewrite Bleb_correct in H0, H1 by auto. revert H0 H1.
    do 2 case Rle_bool_spec; intros; try discriminate. cbn [B2R] in *. lra.
  Qed.

  Lemma greater_spec x y : is_finite x = true -> is_finite y = true ->
    is_finite (greater x y) = true /\ B2R x <= B2R (greater x y) /\ B2R y <= B2R (greater x y) /\
    (forall h, B2R x <= h -> B2R y <= h -> B2R (greater x y) <= h).
  Proof using Type.
    intros Fx Fy. unfold greater. rewrite Bltb_correct by assumption.
    case Rlt_bool_spec; intros; repeat split; auto; lra.
  Qed.

  Lemma fold_spec (value : leaf -> float) h : forall ls start, is_finite start = true -> B2R start <= h ->
    (forall l, In l ls -> is_finite (value l) = true /\ Rabs (B2R (value l)) <= h) ->
    let m := fold_left (fun m l => greater m (Babs (value l))) ls start in
    is_finite m = true /\ B2R start <= B2R m <= h /\ (forall l, In l ls -> Rabs (B2R (value l)) <= B2R m).
  Proof using Type.
    induction ls as [| l ls IH]; intros start F start_h good; cbn [fold_left].
    - cbv zeta. repeat split; auto; try lra. intros l [].
    - destruct (good l (or_introl eq_refl)) as [Fl lh].
      destruct (greater_spec start (Babs (value l)) F) as (F' & g1 & g2 & g3); [rewrite is_finite_Babs; assumption |].
      rewrite B2R_Babs in g2, g3.
      destruct (IH (greater start (Babs (value l))) F' (g3 _ start_h lh)) as (Fm & [a b] & c).
      { intros l' inl. apply good. right. assumption. }
      cbv zeta. repeat split; auto; try lra. intros l' [<- | inl]; [lra | apply c, inl].
  Qed.

  (* The meaning of `inside`. *)
  Lemma inside_spec q : inside q = true ->
    is_finite (greatest q) = true /\ B2R lo <= B2R (greatest q) <= B2R hi /\ 0 <= B2R (fr q) <= B2R (greatest q) /\
    (forall l, is_finite (float_leaf q (greatest q) l) = true) /\
    (forall l, Rabs (B2R (float_leaf q (greatest q) l)) <= B2R (greatest q)).
  Proof using hi_finite lo_finite.
    unfold inside. rewrite !andb_true_iff. intros (((r0 & r1) & coords) & low).
    destruct (radius_finite _ r0 r1) as [Fr [r_low r_high]]. rewrite forallb_forall in coords.
    destruct (fold_spec (float_leaf q (fr q)) (B2R hi) coordinates (fr q) Fr r_high) as (Fm & [m1 m2] & each).
    { intros l inl. apply bounded_finite, coords, inl. }
    fold (greatest q) in Fm, m1, m2, each.
    rewrite Bleb_correct in low by assumption. revert low. case Rle_bool_spec; intros low; [intros _ | discriminate].
    repeat split; auto.
    - intros l. destruct l; try exact Fr; try exact Fm;
      match goal with |- is_finite (float_leaf _ _ ?l) = _ => apply (bounded_finite (float_leaf q (fr q) l)), coords end; cbn; tauto.
    - intros l. destruct l;
        try (match goal with |- Rabs (B2R (float_leaf _ _ ?l)) <= _ => apply (each l) end; cbn; tauto);
        cbn [float_leaf]; rewrite Rabs_pos_eq; lra.
  Qed.

  (* Each leaf and its exact value. *)
  Lemma leaf_spec q : inside q = true -> forall l,
    let x := exact_leaves (real_query q) (B2R (greatest q)) l in
    let m' := (1 + u) * B2R (greatest q) in
    Rabs x <= m' /\ Rabs (B2R (float_leaf q (greatest q) l) - x) <= IZR (leaf_error l) * unit_of_error prec * m'.
  Proof using hi_finite lo_finite prec20.
    intros ins. destruct (inside_spec q ins) as (Fm & [lo_m m_hi] & [r0 r_m] & finite & small).
    assert (0 < u) as u0 by apply bpow_gt_0. pose proof (u_units prec) as uu. pose proof (unit_positive prec) as v0.
    assert (B2R (greatest q) <= (1 + u) * B2R (greatest q)) as grow by nra.
    assert (coordinate : forall a b X, X = Bminus mode_NE a b -> is_finite X = true -> Rabs (B2R X) <= B2R (greatest q) ->
      Rabs (B2R a - B2R b) <= (1 + u) * B2R (greatest q) /\
      Rabs (B2R X - (B2R a - B2R b)) <= 1024 * unit_of_error prec * ((1 + u) * B2R (greatest q))).
    { intros a b X -> FX X_m. destruct (minus_finite prec emax _ _ a b FX) as (Fa & Fb & E). rewrite E in *.
      destruct (difference_error prec (3 - emax - prec) ltac:(lia) (B2R a) (B2R b)) as [d1 d2];
        try apply generic_format_B2R.
      change (Rabs (nearest (B2R a - B2R b) - (B2R a - B2R b)) <= u * Rabs (B2R a - B2R b)) in d1.
      change (Rabs (B2R a - B2R b) <= (1 + u) * Rabs (nearest (B2R a - B2R b))) in d2.
      assert (Rabs (B2R a - B2R b) <= (1 + u) * B2R (greatest q)) as sz.
      { apply Rle_trans with (1 := d2). apply Rmult_le_compat_l; lra. }
      split; [assumption |]. rewrite <- uu. apply Rle_trans with (1 := d1). apply Rmult_le_compat_l; lra. }
    intros l. specialize (finite l). specialize (small l).
    destruct l; cbv zeta; cbn [leaf_error];
      try (apply (coordinate _ _ _ eq_refl); assumption);
      cbn [exact_leaves leaves real_query query_radius float_leaf] in *; rewrite Rminus_diag_eq by reflexivity;
      rewrite Rabs_R0; split; try lra.
  Qed.

  Lemma window_at m : B2R lo <= m -> forall k, (k <= greatest_degree)%nat ->
    half_least (3 - emax - prec) <= unit_of_error prec * m ^ k.
  Proof using lo_positive lo_window.
    intros lo_m k kk. apply Rle_trans with (1 := lo_window k kk). apply Rmult_le_compat_l; [apply bpow_ge_0 |].
    apply pow_incr. lra.
  Qed.

  Lemma u_small : 0 < u <= / 1048576.
  Proof using prec20.
    split; [apply bpow_gt_0 |]. unfold Expression.u. apply Rle_trans with (bpow radix2 (-20)); [apply bpow_le; lia | cbn; lra].
  Qed.

  Lemma fits_at m : 0 < m <= B2R hi -> forall k, (k <= greatest_degree)%nat -> 2048 * ((1 + u) * m) ^ k < bpow radix2 emax.
  Proof using hi_window prec20.
    intros [m0 m_hi] k kk. apply Rle_lt_trans with (2 := hi_window k kk). rewrite Rpow_mult_distr. pose proof u_small.
    assert ((1 + u) ^ k <= 2).
    { apply Rle_trans with ((1 + u) ^ 6); [apply Rle_pow; [lra | exact kk] |].
      apply Rle_trans with (1.1 ^ 6); [apply pow_incr; lra | cbn; lra]. }
    assert (m ^ k <= B2R hi ^ k) by (apply pow_incr; lra).
    assert (0 < m ^ k) by (apply pow_lt; assumption). assert (0 < (1 + u) ^ k) by (apply pow_lt; lra).
    nra.
  Qed.

  Lemma coefficient_spec K : (0 <= threshold K < 2 ^ prec)%Z ->
    is_finite (coefficient K) = true /\ B2R (coefficient K) = IZR (threshold K) * u.
  Proof using prec20.
    intros n_small. unfold coefficient.
    pose proof (binary_normalize_correct prec emax _ _ mode_NE (threshold K) (- prec) false) as H. cbv zeta in H.
    assert (F2R (Float radix2 (threshold K) (- prec)) = IZR (threshold K) * u) as value by reflexivity.
    assert (generic_format radix2 (FLT_exp (3 - emax - prec) prec) (F2R (Float radix2 (threshold K) (- prec)))) as format.
    { apply generic_format_FLT. apply (FLT_spec _ _ _ _ (Float radix2 (threshold K) (- prec))); [reflexivity | |].
      - cbn [Fnum]. rewrite Z.abs_eq by lia. apply n_small.
      - cbn [Fexp]. pose proof prec_lt_emax_ as e. unfold Prec_lt_emax in e. lia. }
    assert (round radix2 (SpecFloat.fexp prec emax) (round_mode mode_NE) (F2R (Float radix2 (threshold K) (- prec))) =
            F2R (Float radix2 (threshold K) (- prec))) as same.
    { apply round_generic; [apply valid_rnd_round_mode | exact format]. }
    rewrite same in H. rewrite Rlt_bool_true in H.
    - rewrite <- value. tauto.
    - rewrite value. rewrite Rabs_pos_eq.
      2: { apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0]. }
      apply Rlt_le_trans with (bpow radix2 prec * u).
      + apply Rmult_lt_compat_r; [apply bpow_gt_0 |]. rewrite <- IZR_Zpower by lia. apply IZR_lt, n_small.
      + unfold Expression.u. rewrite <- bpow_plus. apply bpow_le. pose proof prec_lt_emax_ as e. unfold Prec_lt_emax in e. lia.
  Qed.

  Lemma power_exact x k : (k = 2 \/ k = 4 \/ k = 6)%nat -> exact x (power k) = x magnitude ^ k.
  Proof using Type. intros [-> | [-> | ->]]; cbn; ring. Qed.
  Lemma power_caps x m k : caps_hold x m (power k).
  Proof using Type. unfold power. repeat (destruct k as [| k]; cbn; try tauto). Qed.
  Lemma power_rounded rnd x k : rounded rnd x (power k) = rounded rnd (fun _ => x magnitude) (power k).
  Proof using Type. unfold power. repeat (destruct k as [| k]; try reflexivity). Qed.

  (* The main step: the compared numbers are finite, and a computed margin beyond the limit has the sign of the exact
     one. *)
  Theorem certain q K : inside q = true ->
    let sides := exact_sides (exact_leaves (real_query q) (B2R (greatest q))) (program K) in
    (forall x, In x (compared_at q K) -> is_finite x = true) /\
    (certainly_greater q K = true -> fst sides > snd sides) /\ (certainly_less q K = true -> fst sides < snd sides).
  Proof using all_covered caps hi_finite hi_window lo_finite lo_positive lo_window prec20.
    intros ins. destruct (inside_spec q ins) as (Fm & [lo_m m_hi] & [r0 r_m] & finite & small).
    pose proof (leaf_spec q ins) as leaves_close. cbv zeta in leaves_close.
    set (m := B2R (greatest q)) in *. set (x := exact_leaves (real_query q) m) in *.
    pose proof u_small as us. assert (0 < m) as m0 by lra. assert (0 < (1 + u) * m) as m'0 by nra.
    assert (m <= (1 + u) * m) as grow by nra.
    pose proof (window_at m lo_m) as window. pose proof (window_at _ (Rle_trans _ _ _ lo_m grow)) as window'.
    pose proof (fits_at m (conj m0 m_hi)) as fits.
    assert (sizes : forall l, Rabs (x l) <= (1 + u) * m) by (intros l; apply leaves_close).
    assert (closes : forall l, Rabs (B2R (float_leaf q (greatest q) l) - x l) <=
                          IZR (leaf_error l) * unit_of_error prec * ((1 + u) * m)) by (intros l; apply leaves_close).
    destruct (caps x _ K (Rlt_le _ _ m'0) sizes) as [caps_l caps_r].
    pose proof (all_covered K) as cover. unfold covered in cover.
    unfold certainly_greater, certainly_less, compared_at, limit, margin, exact_sides.
    destruct (program K) as [l r]. cbn [fst snd] in *. set (k := degree l) in *.
    destruct (bound prec None l) as [bl |] eqn:Hl; [| discriminate].
    destruct (bound prec None r) as [br |] eqn:Hr; [| discriminate].
    destruct (bound prec None (Sub l r)) as [bs |] eqn:Hs; [| discriminate].
    destruct (bound prec None (power k)) as [bp |] eqn:Hp; [| discriminate].
    rewrite !andb_true_iff, !orb_true_iff, !Nat.eqb_eq, Z.leb_le, Z.ltb_lt in cover.
    destruct cover as (((((same & kp) & k_is) & covers) & ep) & n_small).
    assert (0 <= threshold K)%Z as n0.
    { unfold threshold_covers in covers. rewrite !andb_true_iff, !Z.leb_le in covers. lia. }
    pose proof (run_correct prec emax _ _ _ m'0 prec20 window' fits x (float_leaf q (greatest q)) sizes finite closes) as runs.
    destruct (runs l None bl Hl I caps_l) as [Fl El]. destruct (runs r None br Hr I caps_r) as [Fr' Er].
    destruct (runs (Sub l r) None bs Hs I (conj caps_l caps_r)) as [Ft Et].
    destruct (runs (power k) None bp Hp I (power_caps _ _ _)) as [Fp Ep]. clear runs.
    pose proof (computed_within prec emax _ m'0 prec20 window' x (float_leaf q (greatest q)) sizes closes) as computed.
    destruct (computed l None bl Hl I caps_l) as [_ el0 small_l _ cl].
    destruct (computed r None br Hr I caps_r) as [_ er0 _ _ cr]. clear computed.
    assert (of_degree bl = k) as kl by apply (bound_degree _ _ _ _ Hl).
    fold (values q) in Fl, El, Fr', Er, Ft, Et, Fp, Ep.
    rewrite <- same, kl in cr. rewrite kl in cl, small_l.
    (* the power of m *)
    set (X := fun l => B2R (float_leaf q (greatest q) l)) in *.
    rewrite power_rounded in Ep. change (X magnitude) with m in Ep.
    assert (Rabs (B2R (values q (power k)) - m ^ k) <= IZR (error bp) * unit_of_error prec * m ^ k /\ (0 <= error bp)%Z) as [cp ep0].
    { rewrite Ep. rewrite <- (power_exact (fun _ => m) k) at 1 by tauto.
      destruct (bound_sound prec ltac:(lia) nearest (half_least (3 - emax - prec))
                  (fun y => rnd_error prec (3 - emax - prec) ltac:(lia) y) m m0 window (fun _ => m) (fun _ => m)
                  ltac:(intros; rewrite Rabs_pos_eq; lra)
                  ltac:(intros l'; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; apply Rmult_le_pos; [apply Rmult_le_pos; [destruct l'; cbn; lra | apply bpow_ge_0] | lra])
                  (power k) None bp Hp I (power_caps _ _ _)) as [_ e0 _ _ c].
      rewrite kp in c. split; assumption. }
    (* the limit *)
    destruct (coefficient_spec K (conj n0 n_small)) as [Fc Ec].
    set (mk := values q (power k)) in *. set (c := coefficient K) in *.
    assert (0 <= B2R c <= 1) as c01.
    { rewrite Ec. split; [apply Rmult_le_pos; [apply IZR_le, n0 | lra] |].
      replace 1 with (bpow radix2 prec * u) by (unfold Expression.u; rewrite <- bpow_plus, Z.add_opp_diag_r; reflexivity).
      apply Rmult_le_compat_r; [lra |]. rewrite <- IZR_Zpower by lia. apply IZR_le. cbn [radix_val radix2]. lia. }
    destruct (mult_fits prec emax _ _ c mk Fc Fp) as [FT ET].
    { apply Rle_lt_trans with (Rabs (B2R mk)); [| apply abs_B2R_lt_emax].
      apply abs_round_le_generic; [apply FLT_exp_valid; exact prec_gt_0_ | apply valid_rnd_N | |].
      - apply generic_format_abs, generic_format_B2R.
      - rewrite Rabs_mult, (Rabs_pos_eq (B2R c)) by lra. pose proof (Rabs_pos (B2R mk)). nra. }
    pose proof (rnd_error prec (3 - emax - prec) ltac:(lia) (B2R c * B2R mk)) as T_close.
    change (round radix2 (FLT_exp (3 - emax - prec) prec) ZnearestE (B2R c * B2R mk)) with (nearest (B2R c * B2R mk)) in T_close.
    rewrite <- ET, Ec in T_close.
    set (T := Bmult mode_NE c mk) in *.
    assert (0 <= half_least (3 - emax - prec)) as eta0.
    { unfold half_least. pose proof (bpow_ge_0 radix2 (3 - emax - prec)). lra. }
    pose proof (threshold_enough prec (threshold K) (error bl + error br) k m (B2R mk) (B2R T) _ (error bp) prec20
      small_l m0 eta0 (conj ep0 ep) (window k small_l) covers cp T_close) as enough.
    (* the margin *)
    change (values q (Sub l r)) with (Bminus mode_NE (values q l) (values q r)) in Ft, Et.
    cbn [rounded] in Et. rewrite <- El, <- Er in *.
    set (t := Bminus mode_NE (values q l) (values q r)) in *.
    rewrite plus_IZR in enough.
    set (M := ((1 + u) * m) ^ k) in *.
    apply Rabs_le_inv in cl, cr.
    split; [| split; intros certain].
    - cbn [In]. intros v [<- | [<- | [<- | [<- | []]]]]; assumption.
    - rewrite Bltb_correct in certain by assumption. revert certain. case Rlt_bool_spec; [intros more _ | discriminate].
      rewrite Et in more.
      apply (beyond prec (3 - emax - prec) ltac:(lia)) in more; [| apply generic_format_B2R]. lra.
    - rewrite Bltb_correct in certain by (rewrite ?is_finite_Bopp; assumption). revert certain.
      case Rlt_bool_spec; [intros less _ | discriminate]. rewrite Et in less.
      apply (below prec (3 - emax - prec) ltac:(lia)) in less; [| apply generic_format_B2R]. rewrite B2R_Bopp in less. lra.
  Qed.

  Theorem filter_finite q : filter q <> answer_undecided -> forall x, compared q x -> is_finite x = true.
  Proof using all_covered caps hi_finite hi_window lo_finite lo_positive lo_window prec20.
    unfold filter. destruct (inside q) eqn:ins; [intros _ | cbn [negb]; congruence].
    intros x [K is_compared]. exact (proj1 (certain q K ins) x is_compared).
  Qed.

  Theorem filter_separated q : filter q = answer_separated -> query_separated (real_query q).
  Proof using all_covered caps exactly_right hi_finite hi_window lo_finite lo_positive lo_window prec20.
    unfold filter. destruct (inside q) eqn:ins; [cbn [negb] | discriminate].
    destruct some_axis_b eqn:axis; [intros _ | destruct negb; discriminate].
    destruct (inside_spec q ins) as (_ & _ & [r0 _] & _).
    apply (exactly_right _ (B2R (greatest q))); [exact r0 |].
    apply some_axis_b_spec in axis. revert axis. apply some_axis_mono. intros K greater.
    apply (certain q K ins) in greater. unfold nonstrict. destruct is_side; lra.
  Qed.

  Theorem filter_contact q : filter q = answer_contact -> ~ query_separated (real_query q).
  Proof using all_covered caps exactly_right hi_finite hi_window lo_finite lo_positive lo_window prec20.
    unfold filter. destruct (inside q) eqn:ins; [cbn [negb] | discriminate].
    destruct some_axis_b; [discriminate |].
    destruct (some_axis_b (fun K => negb (certainly_less q K))) eqn:axis; [discriminate |]. intros _ separated.
    destruct (inside_spec q ins) as (_ & _ & [r0 _] & _).
    apply (exactly_right _ (B2R (greatest q))) in separated; [| exact r0].
    enough (some_axis_b (fun K => negb (certainly_less q K)) = true) by congruence.
    apply some_axis_b_spec. revert separated. apply some_axis_mono. intros K holds.
    destruct (certainly_less q K) eqn:less; [exfalso | reflexivity].
    apply (certain q K ins) in less. unfold nonstrict in holds. destruct is_side; lra.
  Qed.
End Filter.
