(* The caps of Programs.v hold wherever the translated coordinates are at most m. *)
From Coq Require Import Reals ZArith Lra Psatz.
From Axiscert Require Import Vectors Expression Programs.
Open Scope R_scope.

Section Caps.
  Variable m : R.
  Hypothesis m0 : 0 <= m.

  Lemma abs_product a b c d : Rabs a <= c -> Rabs b <= d -> Rabs (a * b) <= c * d.
  Proof using Type. intros. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.

  (* The distances between three numbers of an interval of length 2 m sum to at most 4 m. *)
  Lemma around a1 a2 a3 b1 b2 b3 : Rabs a1 <= m -> Rabs a2 <= m -> Rabs a3 <= m ->
    Rabs b1 <= m -> Rabs b2 <= m -> Rabs b3 <= m ->
    Rabs (a1 * (b2 - b3) + a2 * (b3 - b1) + a3 * (b1 - b2)) <= 4 * (m * m).
  Proof using m0.
    intros H1 H2 H3 G1 G2 G3.
    assert (Rabs (b2 - b3) + Rabs (b3 - b1) + Rabs (b1 - b2) <= 4 * m) as perimeter.
    { unfold Rabs in *; repeat destruct Rcase_abs; lra. }
    pose proof (Rabs_triang (a1 * (b2 - b3) + a2 * (b3 - b1)) (a3 * (b1 - b2))).
    pose proof (Rabs_triang (a1 * (b2 - b3)) (a2 * (b3 - b1))).
    pose proof (abs_product _ _ _ _ H1 (Rle_refl (Rabs (b2 - b3)))).
    pose proof (abs_product _ _ _ _ H2 (Rle_refl (Rabs (b3 - b1)))).
    pose proof (abs_product _ _ _ _ H3 (Rle_refl (Rabs (b1 - b2)))).
    pose proof (Rmult_le_compat_l m _ _ m0 perimeter). lra.
  Qed.

  (* A bound of a component of V. *)
  Lemma normal_cap a1 a2 b1 b2 c1 c2 : Rabs a1 <= m -> Rabs a2 <= m -> Rabs b1 <= m -> Rabs b2 <= m ->
    Rabs c1 <= m -> Rabs c2 <= m ->
    Rabs ((b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)) <= 4 * (m * m).
  Proof using m0.
    intros. replace ((b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1))
      with (a1 * (b2 - c2) + b1 * (c2 - a2) + c1 * (a2 - b2)) by ring. apply around; assumption.
  Qed.

  (* The absolute values of the components of a cross product sum to at most 4 m^2. *)
  Lemma cross_sum b1 b2 b3 c1 c2 c3 : Rabs b1 <= m -> Rabs b2 <= m -> Rabs b3 <= m ->
    Rabs c1 <= m -> Rabs c2 <= m -> Rabs c3 <= m ->
    Rabs (b2 * c3 - b3 * c2) + Rabs (b3 * c1 - b1 * c3) + Rabs (b1 * c2 - b2 * c1) <= 4 * (m * m).
  Proof using m0.
    intros.
    assert (Rabs (- b2) <= m) by (rewrite Rabs_Ropp; assumption). assert (Rabs (- b3) <= m) by (rewrite Rabs_Ropp; assumption).
    assert (Rabs (- c2) <= m) by (rewrite Rabs_Ropp; assumption). assert (Rabs (- c3) <= m) by (rewrite Rabs_Ropp; assumption).
    assert (Rabs ((b2 * c3 - b3 * c2) + (b3 * c1 - b1 * c3) + (b1 * c2 - b2 * c1)) <= 4 * (m * m)) as h1.
    { replace (_ + _ + _) with (- (b1 * (c3 - c2) + b2 * (c1 - c3) + b3 * (c2 - c1))) by ring.
      replace (- _) with (b1 * (c2 - c3) + b2 * (c3 - c1) + b3 * (c1 - c2)) by ring. apply around; assumption. }
    assert (Rabs (- (b2 * c3 - b3 * c2) - (b3 * c1 - b1 * c3) + (b1 * c2 - b2 * c1)) <= 4 * (m * m)) as h2.
    { replace (- (b2 * c3 - b3 * c2) - (b3 * c1 - b1 * c3) + (b1 * c2 - b2 * c1))
        with (b1 * (c2 - - c3) + b2 * (- c3 - c1) + - b3 * (c1 - c2)) by ring. apply around; assumption. }
    assert (Rabs (- (b2 * c3 - b3 * c2) + (b3 * c1 - b1 * c3) - (b1 * c2 - b2 * c1)) <= 4 * (m * m)) as h3.
    { replace (- (b2 * c3 - b3 * c2) + (b3 * c1 - b1 * c3) - (b1 * c2 - b2 * c1))
        with (b1 * (- c2 - c3) + - b2 * (c3 - c1) + b3 * (c1 - - c2)) by ring. apply around; assumption. }
    assert (Rabs ((b2 * c3 - b3 * c2) - (b3 * c1 - b1 * c3) - (b1 * c2 - b2 * c1)) <= 4 * (m * m)) as h4.
    { replace ((b2 * c3 - b3 * c2) - (b3 * c1 - b1 * c3) - (b1 * c2 - b2 * c1))
        with (b1 * (- c2 - - c3) + - b2 * (- c3 - c1) + - b3 * (c1 - - c2)) by ring. apply around; assumption. }
    set (x := b2 * c3 - b3 * c2) in *. set (y := b3 * c1 - b1 * c3) in *. set (z := b1 * c2 - b2 * c1) in *.
    unfold Rabs in h1, h2, h3, h4 |- *; repeat destruct Rcase_abs; lra.
  Qed.

  Lemma determinant_cap a1 a2 a3 b1 b2 b3 c1 c2 c3 :
    Rabs a1 <= m -> Rabs a2 <= m -> Rabs a3 <= m -> Rabs b1 <= m -> Rabs b2 <= m -> Rabs b3 <= m ->
    Rabs c1 <= m -> Rabs c2 <= m -> Rabs c3 <= m ->
    Rabs (a1 * (b2 * c3 - b3 * c2) + a2 * (b3 * c1 - b1 * c3) + a3 * (b1 * c2 - b2 * c1)) <= 4 * (m * (m * m)).
  Proof using m0.
    intros H1 H2 H3 **. pose proof (cross_sum b1 b2 b3 c1 c2 c3 ltac:(assumption) ltac:(assumption) ltac:(assumption)
      ltac:(assumption) ltac:(assumption) ltac:(assumption)) as total.
    pose proof (abs_product _ _ _ _ H1 (Rle_refl (Rabs (b2 * c3 - b3 * c2)))).
    pose proof (abs_product _ _ _ _ H2 (Rle_refl (Rabs (b3 * c1 - b1 * c3)))).
    pose proof (abs_product _ _ _ _ H3 (Rle_refl (Rabs (b1 * c2 - b2 * c1)))).
    pose proof (Rabs_triang (a1 * (b2 * c3 - b3 * c2) + a2 * (b3 * c1 - b1 * c3)) (a3 * (b1 * c2 - b2 * c1))).
    pose proof (Rabs_triang (a1 * (b2 * c3 - b3 * c2)) (a2 * (b3 * c1 - b1 * c3))).
    pose proof (Rmult_le_compat_l m _ _ m0 total). lra.
  Qed.

  Lemma product_difference_cap a b c d : Rabs a <= m -> Rabs b <= m -> Rabs c <= m -> Rabs d <= m ->
    Rabs (a * b - c * d) <= 2 * (m * m).
  Proof using Type.
    intros. replace (2 * (m * m)) with (m * m + m * m) by ring. unfold Rminus.
    eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp.
    apply Rplus_le_compat; apply abs_product; assumption.
  Qed.

  (* A bound of a component of Q: u2 (a1 u2 - u1 a2) + u3 (a1 u3 - u1 a3), u = b - a, a x u = a x b. *)
  Lemma foot_cap a1 a2 a3 b1 b2 b3 : Rabs a1 <= m -> Rabs a2 <= m -> Rabs a3 <= m ->
    Rabs b1 <= m -> Rabs b2 <= m -> Rabs b3 <= m ->
    Rabs ((b2 - a2) * (a1 * b2 - b1 * a2) + (b3 - a3) * (a1 * b3 - b1 * a3)) <= 8 * (m * (m * m)).
  Proof using m0.
    intros. replace (8 * (m * (m * m))) with (2 * m * (2 * (m * m)) + 2 * m * (2 * (m * m))) by ring.
    eapply Rle_trans; [apply Rabs_triang |].
    assert (twice : forall s t, Rabs s <= m -> Rabs t <= m -> Rabs (s - t) <= 2 * m).
    { intros s t. unfold Rabs; repeat destruct Rcase_abs; lra. }
    apply Rplus_le_compat; apply abs_product; auto using product_difference_cap.
  Qed.
End Caps.

Ltac by_lemma lemma :=
  match goal with |- Rabs ?e <= ?b =>
    let claim := type of lemma in
    match claim with Rabs ?e' <= ?b' => replace e with e' by ring; replace b with b' by ring; exact lemma end
  end.

Section CapsHold.
  Variables (x : leaf -> R) (m : R).
  Hypothesis m0 : 0 <= m.
  Hypothesis leaf_size : forall l, Rabs (x l) <= m.

  Lemma V_caps fused : caps_hold x m (ex (V fused)) /\ caps_hold x m (ey (V fused)) /\ caps_hold x m (ez (V fused)).
  Proof using All.
    destruct fused; cbn; repeat split.
    all: first
      [ by_lemma (normal_cap m m0 (x ay) (x az) (x by_) (x bz) (x cy_) (x cz_) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto))
      | by_lemma (normal_cap m m0 (x az) (x ax) (x bz) (x bx) (x cz_) (x cx_) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto))
      | by_lemma (normal_cap m m0 (x ax) (x ay) (x bx) (x by_) (x cx_) (x cy_) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto)) ].
  Qed.

  Lemma d_caps fused : caps_hold x m (d fused).
  Proof using All.
    pose proof (V_caps fused) as (? & ? & ?). unfold d. cbn [caps_hold]. split.
    - destruct fused; cbn;
      by_lemma (determinant_cap m m0 (x ax) (x ay) (x az) (x bx) (x by_) (x bz) (x cx_) (x cy_) (x cz_) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto)).
    - destruct fused; cbn -[V]; cbn [ex ey ez A caps_hold]; tauto.
  Qed.

  Ltac foot_component v1 v2 v3 w1 w2 w3 :=
    by_lemma (foot_cap m m0 (x v1) (x v2) (x v3) (x w1) (x w2) (x w3) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto) ltac:(auto)).
  Ltac foot_caps v1 v2 v3 w1 w2 w3 :=
    intros fused; destruct fused; repeat split; cbn;
    first [foot_component v1 v2 v3 w1 w2 w3 | foot_component v2 v3 v1 w2 w3 w1 | foot_component v3 v1 v2 w3 w1 w2].
  Definition caps_of (v : triple) := caps_hold x m (ex v) /\ caps_hold x m (ey v) /\ caps_hold x m (ez v).

  Lemma Q1_caps : forall fused, caps_of (Q fused A B (sum_of_products fused A B)).
  Proof using All. foot_caps ax ay az bx by_ bz. Qed.
  Lemma Q2_caps : forall fused, caps_of (Q fused B C (sum_of_products fused B C)).
  Proof using All. foot_caps bx by_ bz cx_ cy_ cz_. Qed.
  Lemma Q3_caps : forall fused, caps_of (Q fused C A (sum_of_products fused A C)).
  Proof using All. foot_caps cx_ cy_ cz_ ax ay az. Qed.

  Lemma sum_caps fused v w : caps_of v -> caps_of w -> caps_hold x m (sum_of_products fused v w).
  Proof using Type. unfold caps_of. destruct fused; cbn; tauto. Qed.
  Lemma minus_caps v w : caps_of v -> caps_of w -> caps_of (minus v w).
  Proof using Type. unfold caps_of. cbn. tauto. Qed.
  Lemma times_caps v s : caps_of v -> caps_hold x m s -> caps_of (times v s).
  Proof using Type. unfold caps_of. cbn. tauto. Qed.
  Lemma product_caps fused v w : caps_of v -> caps_of w -> caps_of (vector_product fused v w).
  Proof using Type. unfold caps_of. destruct fused; cbn; tauto. Qed.
  Lemma vertices_caps : caps_of A /\ caps_of B /\ caps_of C.
  Proof using Type. unfold caps_of. cbn. tauto. Qed.

  Lemma reduced_caps fused K :
    caps_hold x m (fst (reduced_program fused K)) /\ caps_hold x m (snd (reduced_program fused K)).
  Proof using All.
    pose proof vertices_caps as (? & ? & ?). pose proof (V_caps fused : caps_of (V fused)). pose proof (d_caps fused) as d_good.
    pose proof (Q1_caps fused). pose proof (Q2_caps fused). pose proof (Q3_caps fused).
    destruct K; cbn [reduced_program published_program fst snd plane_radius_program reduced_radius_program
      reduced_side_program rr caps_hold]; repeat split; auto 10 using sum_caps, minus_caps, product_caps; try apply d_good.
  Qed.

  Lemma published_caps fused K :
    caps_hold x m (fst (published_program fused K)) /\ caps_hold x m (snd (published_program fused K)).
  Proof using All.
    pose proof vertices_caps as (? & ? & ?). pose proof (V_caps fused : caps_of (V fused)). pose proof (d_caps fused) as d_good.
    pose proof (Q1_caps fused). pose proof (Q2_caps fused). pose proof (Q3_caps fused).
    destruct K; cbn [published_program fst snd plane_radius_program edge_radius_program edge_side_program rr caps_hold];
      repeat split; auto 10 using sum_caps, minus_caps, times_caps; try apply d_good.
  Qed.
End CapsHold.
