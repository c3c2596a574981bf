(* The arithmetic of one query per lane: computed values are any numbers within the bounds of their operations, so that
   an operation may be an IEEE-754 one, a fused one or one on pairs of floats. *)
From Coq Require Import Reals Lra Psatz.
From Axiscert Require Import Vectors.
Open Scope R_scope.

Section Lanes.
  Variables u eta : R.
  Hypothesis u_range : 0 <= u <= / 1048576.
  Hypothesis eta_nonneg : 0 <= eta.

  (* X is x rounded; eta bounds the error that underflow may add. *)
  Definition rounds (x X : R) := Rabs (X - x) <= u * Rabs x + eta.

  (* A leaf: a difference of two of the query's numbers, which does not underflow. *)
  Definition leaf_of (x X : vec) :=
    Rabs (cx X - cx x) <= u * Rabs (cx x) /\ Rabs (cy X - cy x) <= u * Rabs (cy x) /\ Rabs (cz X - cz x) <= u * Rabs (cz x).

  (* A dot product of computed vectors, each operation rounded, or fused. *)
  Definition computed_dot (X Y : vec) (D : R) : Prop := exists p s,
    rounds (cx X * cx Y) p /\
    (rounds (p + cy X * cy Y) s \/ exists q, rounds (cy X * cy Y) q /\ rounds (p + q) s) /\
    (rounds (s + cz X * cz Y) D \/ exists q, rounds (cz X * cz Y) q /\ rounds (s + q) D).

  (* a b - c d. *)
  Definition computed_difference (a b c d D : R) : Prop := exists p,
    rounds (a * b) p /\ (rounds (p - c * d) D \/ exists q, rounds (c * d) q /\ rounds (p - q) D).
  Definition computed_cross (X Y N : vec) : Prop :=
    computed_difference (cy X) (cz Y) (cz X) (cy Y) (cx N) /\ computed_difference (cz X) (cx Y) (cx X) (cz Y) (cy N) /\
    computed_difference (cx X) (cy Y) (cy X) (cx Y) (cz N).

  Definition sizes (X Y : vec) := Rabs (cx X * cx Y) + Rabs (cy X * cy Y) + Rabs (cz X * cz Y).

  (* The error of a sum x + y where x had the error e. *)
  Lemma rounds_off e y x Y : Rabs (y - x) <= e -> rounds y Y -> Rabs (Y - x) <= e * (1 + u) + u * Rabs x + eta.
  Proof using u_range.
    unfold rounds. intros off round.
    assert (Rabs y <= Rabs x + e) by (replace y with (x + (y - x)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]).
    replace (Y - x) with ((Y - y) + (y - x)) by ring. eapply Rle_trans; [apply Rabs_triang |].
    assert (u * Rabs y <= u * (Rabs x + e)) by (apply Rmult_le_compat_l; lra). lra.
  Qed.

  Lemma rounds_exactly x X : rounds x X -> Rabs (X - x) <= u * Rabs x + eta.
  Proof using Type. exact (fun H => H). Qed.

  Lemma plus_off a b a' b' ea eb : Rabs (a' - a) <= ea -> Rabs (b' - b) <= eb -> Rabs (a' + b' - (a + b)) <= ea + eb.
  Proof using Type. intros. replace (a' + b' - (a + b)) with ((a' - a) + (b' - b)) by ring. eapply Rle_trans; [apply Rabs_triang | lra]. Qed.
  Lemma minus_off a b a' b' ea eb : Rabs (a' - a) <= ea -> Rabs (b' - b) <= eb -> Rabs (a' - b' - (a - b)) <= ea + eb.
  Proof using Type.
    intros. replace (a' - b' - (a - b)) with ((a' - a) + - (b' - b)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra.
  Qed.
  Lemma times_off a b a' b' ea eb : Rabs (a' - a) <= ea -> Rabs (b' - b) <= eb ->
    Rabs (a' * b' - a * b) <= ea * Rabs b + Rabs a * eb + ea * eb.
  Proof using Type.
    intros Ha Hb. replace (a' * b' - a * b) with ((a' - a) * b + a * (b' - b) + (a' - a) * (b' - b)) by ring.
    pose proof (Rabs_triang ((a' - a) * b + a * (b' - b)) ((a' - a) * (b' - b))).
    pose proof (Rabs_triang ((a' - a) * b) (a * (b' - b))). rewrite !Rabs_mult in *.
    assert (Rabs (a' - a) * Rabs b <= ea * Rabs b) by (apply Rmult_le_compat_r; [apply Rabs_pos | assumption]).
    assert (Rabs a * Rabs (b' - b) <= Rabs a * eb) by (apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
    assert (Rabs (a' - a) * Rabs (b' - b) <= ea * eb) by (apply Rmult_le_compat; auto using Rabs_pos). lra.
  Qed.

  Lemma u_square : u * u <= u / 1048576. Proof using Type*. nra. Qed.
  Lemma small t : 0 <= t -> 0 <= u * t <= t / 1048576.
  Proof using Type*. intros. split; [apply Rmult_le_pos; lra | assert (u * t <= / 1048576 * t) by (apply Rmult_le_compat_r; lra); lra]. Qed.
  Lemma smaller t : 0 <= t -> 0 <= u * u * t <= u * t / 1048576.
  Proof using Type*. intros t0. pose proof (small t t0) as [a _]. pose proof (small _ a). lra. Qed.

  (* Three roundings for each product, and at most six underflows. *)
  Lemma dot_error X Y D : computed_dot X Y D -> Rabs (D - dot X Y) <= 3.001 * u * sizes X Y + 6 * eta.
  Proof using All.
    intros (p & s & Hp & Hs & HD). unfold dot, sizes.
    set (x := cx X * cx Y) in *. set (y := cy X * cy Y) in *. set (z := cz X * cz Y) in *.
    assert (step : forall a e a' b S, 0 <= e -> Rabs (a' - a) <= e ->
      rounds (a' + b) S \/ (exists q, rounds b q /\ rounds (a' + q) S) ->
      Rabs (S - (a + b)) <= (e + u * Rabs b + eta) * (1 + u) + u * (Rabs a + Rabs b) + eta).
    { intros a e a' b S e0 off H. pose proof (Rabs_pos b). assert (0 <= u * Rabs b) by (apply Rmult_le_pos; lra).
      assert (u * Rabs (a + b) <= u * (Rabs a + Rabs b)) by (apply Rmult_le_compat_l; [lra | apply Rabs_triang]).
      destruct H as [H | (q & Hq & H)].
      - assert (Rabs (a' + b - (a + b)) <= e) as o by (replace (a' + b - (a + b)) with (a' - a) by ring; assumption).
        pose proof (rounds_off _ _ _ _ o H). nra.
      - pose proof (plus_off _ _ _ _ _ _ off Hq) as o. pose proof (rounds_off _ _ _ _ o H). nra. }
    pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (Rabs_pos z).
    assert (0 <= u * Rabs x) by (apply Rmult_le_pos; lra).
    pose proof (step x (u * Rabs x + eta) p y s ltac:(lra) Hp Hs) as B1.
    set (e1 := (u * Rabs x + eta + u * Rabs y + eta) * (1 + u) + u * (Rabs x + Rabs y) + eta) in *.
    assert (0 <= e1) as e10 by (eapply Rle_trans; [apply Rabs_pos | exact B1]).
    pose proof (step (x + y) e1 s z D e10 B1 HD) as B2.
    pose proof (Rabs_triang x y) as T.
    assert (u * Rabs (x + y) <= u * (Rabs x + Rabs y)) by (apply Rmult_le_compat_l; lra).
    eapply Rle_trans; [exact B2 |]. unfold e1. pose proof u_square.
    assert (forall t, 0 <= t -> u * u * t <= u * t / 1048576) as second by (intros; nra).
    pose proof (second (Rabs x) ltac:(assumption)). pose proof (second (Rabs y) ltac:(assumption)). pose proof (second (Rabs z) ltac:(assumption)).
    pose proof (second eta ltac:(assumption)).
    assert (u * u * u * Rabs x <= u * Rabs x / 1048576) by nra.
    assert (u * u * u * Rabs y <= u * Rabs y / 1048576) by nra.
    assert (u * eta <= eta / 1048576) by nra. assert (u * u * eta <= eta / 1048576) by nra.
    nra.
  Qed.

  Lemma difference_error a b c d D : computed_difference a b c d D ->
    Rabs (D - (a * b - c * d)) <= 2.001 * u * (Rabs (a * b) + Rabs (c * d)) + 4 * eta.
  Proof using All.
    intros (p & Hp & H). set (x := a * b) in *. set (y := c * d) in *.
    pose proof (Rabs_pos x). pose proof (Rabs_pos y).
    assert (0 <= u * Rabs y) by (apply Rmult_le_pos; lra). assert (0 <= u * Rabs x) by (apply Rmult_le_pos; lra).
    assert (Rabs (x - y) <= Rabs x + Rabs y) as T.
    { unfold Rminus. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra. }
    assert (u * Rabs (x - y) <= u * (Rabs x + Rabs y)) by (apply Rmult_le_compat_l; lra).
    assert (u * u * Rabs x <= u * Rabs x / 1048576) by nra. assert (u * u * Rabs y <= u * Rabs y / 1048576) by nra.
    assert (u * eta <= eta / 1048576) by nra.
    assert (exists e, e <= u * Rabs x + eta + (u * Rabs y + eta) /\ Rabs (D - (x - y)) <= e * (1 + u) + u * Rabs (x - y) + eta)
      as (e & small & off).
    { destruct H as [H | (q & Hq & H)].
      - exists (u * Rabs x + eta). split; [lra |]. apply (rounds_off _ (p - y)); [| assumption].
        replace (p - y - (x - y)) with (p - x) by ring. exact Hp.
      - eexists. split; [apply Rle_refl |]. apply (rounds_off _ (p - q)); [| assumption]. apply minus_off; assumption. }
    nra.
  Qed.

  (* The product of two leaves. *)
  Lemma leaf_product a b A B : Rabs (A - a) <= u * Rabs a -> Rabs (B - b) <= u * Rabs b ->
    Rabs (A * B - a * b) <= 2.001 * u * Rabs (a * b) /\ Rabs (A * B) <= 1.001 * Rabs (a * b).
  Proof using Type*.
    intros Ha Hb. pose proof (times_off _ _ _ _ _ _ Ha Hb) as H. rewrite Rabs_mult.
    pose proof (Rabs_pos a). pose proof (Rabs_pos b). assert (0 <= Rabs a * Rabs b) by (apply Rmult_le_pos; lra).
    set (s := Rabs a * Rabs b) in *.
    replace (u * Rabs a * Rabs b + Rabs a * (u * Rabs b) + u * Rabs a * (u * Rabs b)) with (2 * u * s + u * u * s) in H
      by (unfold s; ring).
    pose proof (small s ltac:(assumption)). pose proof (smaller s ltac:(assumption)). split; [lra |].
    replace (A * B) with (a * b + (A * B - a * b)) by ring. eapply Rle_trans; [apply Rabs_triang |].
    rewrite (Rabs_mult a b). fold s. lra.
  Qed.
End Lanes.
