(* The open sphere's question over the reals: whether a point of the triangle is nearer to the centre than r. The reduced
   test decides it with >= in every comparison, those of radii included, on the axes that have a normal: a triangle
   without area gives the plane's comparison 0 >= 0, and a repeated vertex an edge's.

   For r > 0 the sphere of radius r is the union of the closed ones of radius t < r, so that open_exact follows from
   reduced_exact: of finitely many axes one separates for every t < r. For r = 0 no point is nearer, and every triangle, a
   single point included, has an axis. *)
From Coq Require Import Reals Lra Psatz Classical.
From Axiscert Require Import Vectors Sat7 Complete Exact Reduced.
Open Scope R_scope.

Definition separated_open (A B C P : vec) (r : R) := forall X, in_triangle X A B C -> r <= distance P X.

(* Whether the axis of a comparison has a normal, as kernel/sphere_triangle/certified/exact_step.cpp asks: the plane where
   V is not zero, an edge where its ends differ. A vertex on the centre is excluded by r > 0. *)
Definition has_normal (A B C : vec) (K : comparison) : Prop :=
  match K with
  | plane_radius => normal A B C <> Vec 0 0 0
  | edge_ab_radius => sub B A <> Vec 0 0 0
  | edge_bc_radius => sub C B <> Vec 0 0 0
  | edge_ca_radius => sub A C <> Vec 0 0 0
  | _ => True
  end.
Definition weak (sides : R * R) := fst sides >= snd sides.
Definition open_holds (A B C : vec) (rr : R) (K : comparison) := weak (reduced A B C rr K) /\ has_normal A B C K.

Lemma dot_zero : dot (Vec 0 0 0) (Vec 0 0 0) = 0.
Proof. unfold dot. cbn [cx cy cz]. ring. Qed.
Lemma square_positive v : v <> Vec 0 0 0 -> 0 < dot v v.
Proof.
  intros some. destruct (Rle_lt_or_eq_dec 0 (dot v v) (dot_self_nonneg v)) as [| zero]; [assumption | exfalso; apply some].
  destruct v as [x y z]. unfold dot in zero. cbn [cx cy cz] in zero. f_equal; nra.
Qed.

(* The left side of a comparison does not depend on the radius, the right side of a radius comparison is rr times a
   square; the two vanish together where the axis has no normal. *)
Lemma sides_shape a b c K : (is_side K = true /\ has_normal a b c K /\ forall rr, reduced a b c rr K = reduced a b c 0 K) \/
  (is_side K = false /\ exists f n, 0 <= f /\ 0 <= n /\ (has_normal a b c K <-> 0 < n) /\ (n = 0 -> f = 0) /\
    forall rr, reduced a b c rr K = (f, rr * n)).
Proof.
  assert (vertex : forall x, exists f n, 0 <= f /\ 0 <= n /\ (True <-> 0 < n) /\ (n = 0 -> f = 0) /\
    forall rr, vertex_radius_sides x rr = (f, rr * n)).
  { intros x. exists (dot x x), 1. repeat split; try lra; [apply dot_self_nonneg |].
    intros rr. unfold vertex_radius_sides. f_equal. ring. }
  assert (positive : forall v, v <> Vec 0 0 0 <-> 0 < dot v v).
  { intros v. split; [apply square_positive |]. intros some ->. rewrite dot_zero in some. lra. }
  assert (edge : forall x y, exists f n, 0 <= f /\ 0 <= n /\ (sub y x <> Vec 0 0 0 <-> 0 < n) /\ (n = 0 -> f = 0) /\
    forall rr, reduced_radius_sides x y rr = (f, rr * n)).
  { intros x y. exists (dot (cross x y) (cross x y)), (length2 x y). unfold length2.
    repeat split; try apply dot_self_nonneg; try apply positive.
    intros zero. apply (reduced_zero_length x y x 0) in zero. apply zero. }
  destruct K; cbn [is_side reduced published has_normal];
    try (left; split; [reflexivity | split; [exact I | reflexivity]]);
    right; (split; [reflexivity |]); try apply vertex; try apply edge.
  unfold plane_sides. exists (offset a b c * offset a b c), (dot (normal a b c) (normal a b c)).
  split; [apply Rle_0_sqr |]. split; [apply dot_self_nonneg |]. split; [apply positive |]. split; [| reflexivity].
  intros zero. pose proof (cauchy_schwarz a (normal a b c)) as small. rewrite zero in small. unfold offset.
  pose proof (Rle_0_sqr (dot a (normal a b c))). unfold Rsqr in *. nra.
Qed.

Section Open.
  Variables A B C P : vec.
  Let a := sub A P. Let b := sub B P. Let c := sub C P.
  Let closed (t : R) (K : comparison) := nonstrict K (reduced a b c (t * t) K).

  (* A comparison that holds for a radius holds for every smaller one. *)
  Lemma closed_mono K s t : 0 <= s <= t -> closed t K -> closed s K.
  Proof using a b c.
    intros st. unfold closed, nonstrict. destruct (sides_shape a b c K) as [(-> & _ & same) | (-> & f & n & f0 & n0 & _ & _ & same)].
    - rewrite (same (t * t)), (same (s * s)). auto.
    - rewrite (same (t * t)), (same (s * s)). cbn [fst snd].
      assert (s * s * n <= t * t * n) by (apply Rmult_le_compat_r; [assumption | nra]). lra.
  Qed.

  Lemma open_of_all K r : 0 < r -> (forall t, 0 <= t < r -> closed t K) -> open_holds a b c (r * r) K.
  Proof using A B C P.
    intros r0 all. unfold closed, nonstrict, open_holds, weak in *.
    destruct (sides_shape a b c K) as [(side & some & same) | (side & f & n & f0 & n0 & some & flat & same)]; rewrite side in *.
    - specialize (all 0 ltac:(lra)). rewrite (same (0 * 0)) in all. rewrite (same (r * r)). split; assumption.
    - pose proof (all 0 ltac:(lra)) as at0. rewrite (same (0 * 0)) in at0. cbn [fst snd] in at0.
      assert (0 < n) as positive by (destruct (Rle_lt_or_eq_dec 0 n n0) as [| <-]; [assumption | lra]).
      rewrite (same (r * r)). cbn [fst snd]. split; [| apply some; assumption].
      apply Rle_ge. destruct (Rle_or_lt (r * r * n) f) as [| less]; [assumption | exfalso].
      assert (f / n < r * r) as q by (apply Rmult_lt_reg_r with n; [assumption | unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra]).
      assert (0 <= f / n) as q0 by (apply Rmult_le_pos; [assumption | apply Rlt_le, Rinv_0_lt_compat; assumption]).
      assert (sqrt (f / n) < r) as small by (rewrite <- (sqrt_square r) by lra; apply sqrt_lt_1; [assumption | nra | assumption]).
      specialize (all (sqrt (f / n)) (conj (sqrt_pos _) small)). rewrite same in all. cbn [fst snd] in all.
      rewrite sqrt_sqrt in all by assumption. unfold Rdiv in all. rewrite Rmult_assoc, Rinv_l in all; lra.
  Qed.
  Lemma all_of_open K r t : 0 <= t < r -> open_holds a b c (r * r) K -> closed t K.
  Proof using A B C P.
    intros tr [holds normal]. unfold closed, nonstrict, weak in *.
    destruct (sides_shape a b c K) as [(side & _ & same) | (side & f & n & f0 & n0 & some & _ & same)]; rewrite side in *.
    - rewrite (same (r * r)) in holds. rewrite (same (t * t)). exact holds.
    - rewrite same in holds. rewrite (same (t * t)). cbn [fst snd] in *. apply some in normal.
      assert (t * t * n < r * r * n) by (apply Rmult_lt_compat_r; [assumption | nra]). lra.
  Qed.

  (* Two properties of radii each hold for smaller ones too, and one of them for each t < r: then one of them holds for every
     t < r. *)
  Lemma one_of_two (r : R) (Q S : R -> Prop) : 0 < r ->
    (forall s t, 0 <= s <= t -> Q t -> Q s) -> (forall s t, 0 <= s <= t -> S t -> S s) ->
    (forall t, 0 <= t < r -> Q t \/ S t) -> (forall t, 0 <= t < r -> Q t) \/ (forall t, 0 <= t < r -> S t).
  Proof using Type.
    intros r0 mq ms cover. apply NNPP. intros no. apply not_or_and in no as [nq ns].
    apply not_all_ex_not in nq as [x nq]. apply imply_to_and in nq as [x0 nq].
    apply not_all_ex_not in ns as [y ns]. apply imply_to_and in ns as [y0 ns].
    destruct (cover (Rmax x y)) as [H | H].
    - split; [apply Rle_trans with x; [lra | apply Rmax_l] | apply Rmax_lub_lt; lra].
    - apply nq, (mq x (Rmax x y)); [split; [lra | apply Rmax_l] | assumption].
    - apply ns, (ms y (Rmax x y)); [split; [lra | apply Rmax_r] | assumption].
  Qed.

  Lemma open_exact_positive r : 0 < r -> (some_axis (open_holds a b c (r * r)) <-> separated_open A B C P r).
  Proof using Type.
    intros r0. split.
    - intros axis X inside. apply Rnot_lt_le. intros less.
      assert (0 <= distance P X) as d0 by apply sqrt_pos.
      assert (separated A B C P (distance P X)) as apart.
      { apply reduced_exact; [assumption |]. revert axis. apply some_axis_mono. intros K. apply all_of_open. lra. }
      specialize (apart X inside). lra.
    - intros far.
      assert (forall t, 0 <= t < r -> some_axis (closed t)) as all.
      { intros t tr. apply reduced_exact; [lra |]. intros X inside. specialize (far X inside). lra. }
      unfold some_axis in *.
      assert (mono : forall K s t, 0 <= s <= t -> closed t K -> closed s K) by (intros; eapply closed_mono; eauto).
      repeat (apply one_of_two in all; [destruct all as [all | all] | assumption | |];
        [| | intros s t st; pose proof (fun K => mono K s t st); intuition auto
           | intros s t st; pose proof (fun K => mono K s t st); intuition auto]).
      1: left. 2: right; left. 3: do 2 right; left. 4: do 3 right; left. 5: do 4 right; left. 6: do 5 right; left. 7: do 6 right.
      all: repeat match goal with |- _ /\ _ => split end; apply open_of_all; try assumption; intros t tr; specialize (all t tr);
        intuition auto.
  Qed.
End Open.

(* An open sphere of radius 0 is empty: the plane separates it, or an edge of a triangle without area, or a vertex of one that
   is a point. *)
Lemma open_empty A B C : some_axis (open_holds A B C 0).
Proof.
  unfold some_axis, open_holds, weak. cbn [has_normal reduced published].
  unfold plane_sides, vertex_radius_sides, vertex_side_sides, reduced_radius_sides, reduced_side_sides. cbn [fst snd].
  rewrite !Rmult_0_l.
  destruct (classic (normal A B C = Vec 0 0 0)) as [flat |].
  2: { left. split; [apply Rle_ge, Rle_0_sqr | assumption]. }
  right. assert (turned : normal B C A = normal A B C) by (unfold normal; vec_ring).
  assert (zero : forall v, dot v (Vec 0 0 0) = 0) by (intros; unfold dot; cbn [cx cy cz]; ring).
  destruct (classic (sub B A = Vec 0 0 0)) as [same |].
  2: { right; right; right; left. rewrite flat, zero. repeat split; try assumption; try lra. apply Rle_ge, dot_self_nonneg. }
  destruct (classic (sub C B = Vec 0 0 0)) as [same' |].
  2: { do 4 right; left. rewrite turned, flat, zero. repeat split; try assumption; try lra. apply Rle_ge, dot_self_nonneg. }
  left. assert (B = A /\ C = A) as [-> ->].
  { destruct A as [a1 a2 a3], B as [b1 b2 b3], C as [c1 c2 c3]. unfold sub in same, same'. cbn [cx cy cz] in same, same'.
    injection same as x y z. injection same' as x' y' z'.
    split; f_equal; lra. }
  pose proof (dot_self_nonneg A). repeat split; lra.
Qed.

Theorem open_exact A B C P r : 0 <= r ->
  (some_axis (open_holds (sub A P) (sub B P) (sub C P) (r * r)) <-> separated_open A B C P r).
Proof.
  intros r0. destruct (Rle_lt_or_eq_dec 0 r r0) as [positive | <-]; [apply open_exact_positive; assumption |].
  split; intros _; [intros X _; apply sqrt_pos | rewrite Rmult_0_l; apply open_empty].
Qed.

Theorem open_contact A B C P r : ~ separated_open A B C P r <-> exists X, in_triangle X A B C /\ distance P X < r.
Proof.
  split.
  - intros near. apply NNPP. intros none. apply near. intros X inside. apply Rnot_lt_le. intros less. apply none. eauto.
  - intros (X & inside & less) far. specialize (far X inside). lra.
Qed.

(* A triangle that is separated from the closed sphere is separated from the open one. *)
Lemma separated_is_open A B C P r : separated A B C P r -> separated_open A B C P r.
Proof. intros far X inside. apply Rlt_le, far, inside. Qed.

(* With r > 0 a radius comparison with >= has a left side that is not zero exactly where its axis has a normal: so a step
   may exclude an axis by either. *)
Theorem open_left_side A B C rr K : 0 < rr -> is_side K = false -> weak (reduced A B C rr K) ->
  (0 < fst (reduced A B C rr K) <-> has_normal A B C K).
Proof.
  intros r0 radius. unfold weak.
  destruct (sides_shape A B C K) as [(side & _) | (_ & f & n & f0 & n0 & some & flat & value)]; [congruence |].
  rewrite value, some. cbn [fst snd]. intros holds. split; intros positive.
  - destruct (Rle_lt_or_eq_dec 0 n n0) as [| zero]; [assumption |]. specialize (flat (eq_sym zero)). lra.
  - assert (0 < rr * n) by (apply Rmult_lt_0_compat; assumption). lra.
Qed.
