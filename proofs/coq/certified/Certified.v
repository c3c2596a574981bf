(* The thresholds of the certified predicate's coarse step (kernel/sphere_triangle/certified): the difference of each
   margin, as computed, and the exact margin is within the computed threshold of its degree. This holds for any rounding
   with |rnd x - x| <= u |x| + eta, with fused multiply-add or without.

   S = |A|^2 + |B|^2 + |C|^2 + r^2 and E = |AB|^2 + |BC|^2 + |CA|^2. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Lanes.
Open Scope R_scope.

(* The exported constants, as multiples of u. *)
Definition coarse_degree_2 : R := 20.1875.
Definition coarse_degree_4 : R := 11.15625.
Definition coarse_degree_6 : R := 5.84375.

(* Lengths. *)
Definition norm (v : vec) := sqrt (dot v v).
Lemma norm_nonneg v : 0 <= norm v. Proof. apply sqrt_pos. Qed.
Lemma norm_square v : norm v * norm v = dot v v. Proof. apply sqrt_sqrt, dot_self_nonneg. Qed.
Lemma norm_at_most v t : 0 <= t -> dot v v <= t * t -> norm v <= t.
Proof. intros t0 H. rewrite <- norm_square in H. apply Rsqr_incr_0_var; assumption. Qed.
Lemma square_monotone s t : 0 <= s -> s <= t -> s * s <= t * t. Proof. intros. apply Rmult_le_compat; assumption. Qed.
Lemma dot_norm v w : Rabs (dot v w) <= norm v * norm w.
Proof.
  pose proof (norm_nonneg v). pose proof (norm_nonneg w).
  apply Rsqr_incr_0_var; [| apply Rmult_le_pos; assumption]. rewrite <- Rsqr_abs. unfold Rsqr.
  replace (norm v * norm w * (norm v * norm w)) with (norm v * norm v * (norm w * norm w)) by ring.
  rewrite !norm_square. apply cauchy_schwarz.
Qed.
Lemma norm_triangle v w : norm (add v w) <= norm v + norm w.
Proof.
  pose proof (norm_nonneg v). pose proof (norm_nonneg w). apply norm_at_most; [lra |].
  pose proof (dot_norm v w) as mixed. apply Rabs_le_inv in mixed. pose proof (norm_square v). pose proof (norm_square w).
  replace (dot (add v w) (add v w)) with (dot v v + dot w w + 2 * dot v w) by (unfold dot, add; cbn [cx cy cz]; ring). lra.
Qed.
Definition magnitudes (v : vec) := Vec (Rabs (cx v)) (Rabs (cy v)) (Rabs (cz v)).
Lemma norm_magnitudes v : norm (magnitudes v) = norm v.
Proof.
  unfold norm. f_equal. unfold dot, magnitudes. cbn [cx cy cz].
  rewrite <- !Rabs_mult, !Rabs_pos_eq by (apply Rle_0_sqr). reflexivity.
Qed.
Lemma sizes_norm v w : sizes v w <= norm v * norm w.
Proof.
  rewrite <- (norm_magnitudes v), <- (norm_magnitudes w). eapply Rle_trans; [| apply dot_norm].
  unfold sizes, dot, magnitudes. cbn [cx cy cz]. rewrite !Rabs_mult. apply Rle_abs.
Qed.
Lemma sizes_square v : sizes v v = dot v v.
Proof. unfold sizes, dot. rewrite !Rabs_pos_eq by (apply Rle_0_sqr). reflexivity. Qed.
Lemma norm_monotone v w : Rabs (cx v) <= cx w -> Rabs (cy v) <= cy w -> Rabs (cz v) <= cz w -> norm v <= norm w.
Proof.
  intros x y z. apply norm_at_most; [apply norm_nonneg |]. rewrite norm_square, <- sizes_square. unfold sizes, dot. rewrite !Rabs_mult.
  pose proof (square_monotone _ _ (Rabs_pos _) x). pose proof (square_monotone _ _ (Rabs_pos _) y).
  pose proof (square_monotone _ _ (Rabs_pos _) z). lra.
Qed.
Lemma cross_norm v w : norm (cross v w) <= norm v * norm w.
Proof.
  pose proof (norm_nonneg v). pose proof (norm_nonneg w). apply norm_at_most; [apply Rmult_le_pos; assumption |].
  replace (norm v * norm w * (norm v * norm w)) with (norm v * norm v * (norm w * norm w)) by ring.
  rewrite !norm_square, <- lagrange. pose proof (Rle_0_sqr (dot v w)). unfold Rsqr in *. lra.
Qed.

(* The sizes of a cross product's terms: a vector of length at most sqrt 2 |v| |w|. *)
Definition cross_sizes (v w : vec) := Vec
  (Rabs (cy v * cz w) + Rabs (cz v * cy w)) (Rabs (cz v * cx w) + Rabs (cx v * cz w)) (Rabs (cx v * cy w) + Rabs (cy v * cx w)).
Lemma cross_sizes_norm v w : norm (cross_sizes v w) <= 1.4143 * (norm v * norm w).
Proof.
  pose proof (norm_nonneg v). pose proof (norm_nonneg w). assert (0 <= norm v * norm w) by (apply Rmult_le_pos; assumption).
  apply norm_at_most; [lra |].
  assert (dot (cross_sizes v w) (cross_sizes v w) <= 2 * (dot v v * dot w w)) as total_square.
  { unfold cross_sizes. rewrite !Rabs_mult. rewrite <- (sizes_square v), <- (sizes_square w). unfold sizes, dot. rewrite !Rabs_mult.
    cbn [cx cy cz].
    set (a := Rabs (cx v)). set (b := Rabs (cy v)). set (c := Rabs (cz v)).
    set (x := Rabs (cx w)). set (y := Rabs (cy w)). set (z := Rabs (cz w)).
    pose proof (Rle_0_sqr (a * x - b * y)). pose proof (Rle_0_sqr (b * y - c * z)). pose proof (Rle_0_sqr (c * z - a * x)).
    pose proof (Rle_0_sqr (a * y - b * x)). pose proof (Rle_0_sqr (b * z - c * y)). pose proof (Rle_0_sqr (c * x - a * z)).
    pose proof (Rle_0_sqr (a * x)). pose proof (Rle_0_sqr (b * y)). pose proof (Rle_0_sqr (c * z)).
    unfold Rsqr in *. lra. }
  replace (1.4143 * (norm v * norm w) * (1.4143 * (norm v * norm w)))
    with (1.4143 * 1.4143 * (norm v * norm v * (norm w * norm w))) by lra.
  rewrite !norm_square. pose proof (Rmult_le_pos _ _ (dot_self_nonneg v) (dot_self_nonneg w)). lra.
Qed.

Section Coarse.
  Variables u eta : R.
  Hypothesis u_range : 0 <= u <= / 1048576.
  Hypothesis eta_nonneg : 0 <= eta.
  Notation rounds := (rounds u eta).
  Notation computed_dot := (computed_dot u eta).
  Notation computed_cross := (computed_cross u eta).
  Notation leaf_of := (leaf_of u).
  Local Notation small := (small u u_range).
  Local Notation smaller := (smaller u u_range).

  (* s = sqrt S gives the scale of each degree. Underflow adds less than kappa of that scale. *)
  Variable s : R.
  Hypothesis s0 : 0 < s.
  Definition kappa := u / 1000000000000000000.
  Hypothesis underflow_2 : eta <= kappa * s ^ 2.
  Hypothesis underflow_6 : eta <= kappa * s ^ 6.

  Lemma kappa_range : 0 <= kappa <= / 1000000000000000000.
  Proof using u_range. unfold kappa. lra. Qed.
  Lemma underflow k : (2 <= k <= 6)%nat -> eta <= kappa * s ^ k.
  Proof using s0 u_range underflow_2 underflow_6.
    intros range. pose proof kappa_range. destruct (Rle_or_lt 1 s) as [more | less].
    - eapply Rle_trans; [exact underflow_2 |]. apply Rmult_le_compat_l; [lra |]. apply Rle_pow; [assumption | lia].
    - eapply Rle_trans; [exact underflow_6 |]. apply Rmult_le_compat_l; [lra |].
      replace 6%nat with (k + (6 - k))%nat by lia. rewrite pow_add.
      assert (0 <= s ^ k) by (apply pow_le; lra).
      assert (s ^ (6 - k) <= 1) by (rewrite <- (pow1 (6 - k)); apply pow_incr; lra).
      pose proof (Rmult_le_compat_l _ _ _ ltac:(eassumption) ltac:(eassumption) : s ^ k * s ^ (6 - k) <= s ^ k * 1). lra.
  Qed.

  (* A value of degree n, exact x, computed X, |x| <= z: the error is at most k u z, plus c kappa s^n of underflow. *)
  Definition approx (k c : R) (n : nat) (z x X : R) :=
    0 <= k <= 32 /\ 0 <= c <= 1000 /\ 0 <= z <= 4 * s ^ n /\ Rabs x <= z /\ Rabs (X - x) <= k * u * z + c * kappa * s ^ n.
  Definition approx_vec (k c : R) (n : nat) (z : R) (x X : vec) :=
    0 <= k <= 32 /\ 0 <= c <= 1000 /\ 0 <= z <= 4 * s ^ n /\ norm x <= z /\ norm (sub X x) <= k * u * z + c * kappa * s ^ n.

  Lemma power_nonneg n : 0 <= s ^ n. Proof using s0. apply pow_le. lra. Qed.

  (* The error of a product of two numbers or two vectors. *)
  Lemma product_size k c n z k' c' n' z' :
    0 <= k <= 32 -> 0 <= c <= 1000 -> 0 <= z <= 4 * s ^ n -> 0 <= k' <= 32 -> 0 <= c' <= 1000 -> 0 <= z' <= 4 * s ^ n' ->
    (k * u * z + c * kappa * s ^ n) * z' + z * (k' * u * z' + c' * kappa * s ^ n') +
    (k * u * z + c * kappa * s ^ n) * (k' * u * z' + c' * kappa * s ^ n') <=
    (k + k' + 0.001) * u * (z * z') + (4 * (c + c') + 1) * kappa * s ^ (n + n').
  Proof using s0 u_range.
    intros. rewrite pow_add. pose proof (power_nonneg n) as y0. pose proof (power_nonneg n') as y0'.
    set (y := s ^ n) in *. set (y' := s ^ n') in *. pose proof kappa_range as k0. set (h := kappa) in *.
    assert (0 <= h * (y * y')) as hy by (repeat apply Rmult_le_pos; lra).
    assert (0 <= u * (z * z')) as uz by (repeat apply Rmult_le_pos; lra).
    assert (z' * y <= 4 * (y * y')) as m1 by (apply Rle_trans with (4 * y' * y); [apply Rmult_le_compat_r; lra | lra]).
    assert (z * y' <= 4 * (y * y')) as m2 by (apply Rle_trans with (4 * y * y'); [apply Rmult_le_compat_r; lra | lra]).
    assert (0 <= z' * y) by (apply Rmult_le_pos; lra). assert (0 <= z * y') by (apply Rmult_le_pos; lra).
    assert (c * h * (z' * y) <= c * h * (4 * (y * y'))) as t1 by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | assumption]).
    assert (c' * h * (z * y') <= c' * h * (4 * (y * y'))) as t2 by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | assumption]).
    assert (k * k' <= 1024) as kk by (apply Rle_trans with (32 * 32); [apply Rmult_le_compat; lra | lra]).
    assert (k * k' * (u * (u * (z * z'))) <= 1024 * (u * (u * (z * z')))) as t3.
    { apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | assumption]. }
    pose proof (small _ uz) as t3'.
    assert (k * c' <= 32000) as kc by (apply Rle_trans with (32 * 1000); [apply Rmult_le_compat; lra | lra]).
    assert (c * k' <= 32000) as ck by (apply Rle_trans with (1000 * 32); [apply Rmult_le_compat; lra | lra]).
    assert (c * c' <= 1000000) as cc by (apply Rle_trans with (1000 * 1000); [apply Rmult_le_compat; lra | lra]).
    assert (0 <= k * c') by (apply Rmult_le_pos; lra). assert (0 <= c * k') by (apply Rmult_le_pos; lra).
    assert (0 <= c * c') by (apply Rmult_le_pos; lra).
    assert (k * c' * (u * (h * (z * y'))) <= 32000 * (u * (h * (4 * (y * y'))))) as t4.
    { apply Rmult_le_compat; try lra; [repeat apply Rmult_le_pos; lra |]. repeat (apply Rmult_le_compat_l; [lra |]). assumption. }
    assert (c * k' * (u * (h * (z' * y))) <= 32000 * (u * (h * (4 * (y * y'))))) as t5.
    { apply Rmult_le_compat; try lra; [repeat apply Rmult_le_pos; lra |]. repeat (apply Rmult_le_compat_l; [lra |]). assumption. }
    pose proof (small _ hy) as t4'.
    assert (c * c' * (h * (h * (y * y'))) <= 1000000 * (h * (h * (y * y')))) as t6.
    { apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | assumption]. }
    assert (h * (h * (y * y')) <= / 1000000000000000000 * (h * (y * y'))) as t6' by (apply Rmult_le_compat_r; lra).
    lra.
  Qed.

  Lemma approx_product k c n z x X k' c' n' z' x' X' : (2 <= n + n' <= 6)%nat -> approx k c n z x X -> approx k' c' n' z' x' X' ->
    Rabs (x * x') <= z * z' /\
    Rabs (X * X' - x * x') <= (k + k' + 0.001) * u * (z * z') + (4 * (c + c') + 1) * kappa * s ^ (n + n').
  Proof using s0 u_range.
    intros _ (k0 & c0 & z0 & xz & off) (k0' & c0' & z0' & xz' & off'). split.
    - rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos.
    - eapply Rle_trans; [| apply product_size; assumption]. pose proof (times_off _ _ _ _ _ _ off off') as H.
      eapply Rle_trans; [exact H |]. apply Rplus_le_compat_r, Rplus_le_compat.
      + apply Rmult_le_compat_l; [eapply Rle_trans; [apply Rabs_pos | exact off] | assumption].
      + apply Rmult_le_compat_r; [eapply Rle_trans; [apply Rabs_pos | exact off'] | assumption].
  Qed.

  (* An approximation after rounding. *)
  Lemma approx_rounded k c n z x Y X : (2 <= n <= 6)%nat -> 0 <= k <= 30 -> 0 <= c <= 990 -> 0 <= z <= 4 * s ^ n ->
    Rabs x <= z -> Rabs (Y - x) <= k * u * z + c * kappa * s ^ n -> rounds Y X -> approx (k + 1.001) (c + 2) n z x X.
  Proof using All.
    intros range k0 c0 z0 xz off H. pose proof (rounds_off u eta u_range _ _ _ _ off H) as total.
    pose proof (underflow n range) as tiny. pose proof (power_nonneg n) as y0. pose proof kappa_range as k00.
    set (y := s ^ n) in *. assert (0 <= kappa * y) as hy by (apply Rmult_le_pos; lra).
    assert (u * Rabs x <= u * z) by (apply Rmult_le_compat_l; lra). pose proof (smaller z ltac:(lra)).
    pose proof (small _ hy).
    assert (k * (u * u * z) <= 30 * (u * u * z)) by (apply Rmult_le_compat_r; lra).
    assert (c * (u * (kappa * y)) <= 990 * (u * (kappa * y))) by (apply Rmult_le_compat_r; lra).
    unfold approx. fold y. repeat split; lra.
  Qed.

  Lemma approx_vec_product k c n z x X k' c' n' z' x' X' D : (2 <= n + n' <= 6)%nat -> k + k' <= 28 -> 4 * (c + c') <= 900 ->
    z * z' <= 4 * s ^ (n + n') ->
    approx_vec k c n z x X -> approx_vec k' c' n' z' x' X' -> computed_dot X X' D ->
    approx (k + k' + 3.005) (4 * (c + c') + 8) (n + n') (z * z') (dot x x') D.
  Proof using All.
    intros range kk cc zz (k0 & c0 & z0 & xz & off) (k0' & c0' & z0' & xz' & off') HD.
    pose proof (product_size k c n z k' c' n' z' k0 c0 z0 k0' c0' z0') as size.
    set (e := k * u * z + c * kappa * s ^ n) in *. set (e' := k' * u * z' + c' * kappa * s ^ n') in *.
    assert (0 <= e) as e0 by (eapply Rle_trans; [apply norm_nonneg | exact off]).
    assert (0 <= e') as e0' by (eapply Rle_trans; [apply norm_nonneg | exact off']).
    assert (0 <= z * z') as zz0 by (apply Rmult_le_pos; lra).
    pose proof (underflow _ range) as tiny. pose proof (power_nonneg (n + n')) as y0. set (y := s ^ (n + n')) in *.
    pose proof kappa_range as k00. assert (0 <= kappa * y) as hy by (apply Rmult_le_pos; lra).
    assert (Rabs (dot X X' - dot x x') <= e * z' + z * e' + e * e') as change.
    { replace (dot X X' - dot x x') with (dot (sub X x) x' + dot x (sub X' x') + dot (sub X x) (sub X' x'))
        by (unfold dot, sub; cbn [cx cy cz]; ring).
      pose proof (dot_norm (sub X x) x'). pose proof (dot_norm x (sub X' x')). pose proof (dot_norm (sub X x) (sub X' x')).
      pose proof (norm_nonneg x). pose proof (norm_nonneg x'). pose proof (norm_nonneg (sub X x)). pose proof (norm_nonneg (sub X' x')).
      assert (norm (sub X x) * norm x' <= e * z') by (apply Rmult_le_compat; assumption).
      assert (norm x * norm (sub X' x') <= z * e') by (apply Rmult_le_compat; assumption).
      assert (norm (sub X x) * norm (sub X' x') <= e * e') by (apply Rmult_le_compat; assumption).
      eapply Rle_trans; [apply Rabs_triang |]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang |]. lra. }
    assert (longer : forall v V z e, norm v <= z -> norm (sub V v) <= e -> norm V <= z + e).
    { intros v V a b va vb. replace V with (add v (sub V v)) by (destruct v, V; unfold add, sub; cbn; f_equal; ring).
      eapply Rle_trans; [apply norm_triangle | lra]. }
    pose proof (longer _ _ _ _ xz off) as l1. pose proof (longer _ _ _ _ xz' off') as l2.
    apply dot_error in HD; [| assumption | assumption]. pose proof (sizes_norm X X') as sn.
    assert (norm X * norm X' <= (z + e) * (z' + e')) as sn' by (apply Rmult_le_compat; auto using norm_nonneg).
    assert (u * sizes X X' <= u * ((z + e) * (z' + e'))) as us by (apply Rmult_le_compat_l; lra).
    assert (u * (e * z' + z * e' + e * e') <= u * ((k + k' + 0.001) * u * (z * z') + (4 * (c + c') + 1) * kappa * y)) as ue
      by (apply Rmult_le_compat_l; lra).
    pose proof (smaller _ zz0). pose proof (small _ hy).
    assert ((k + k') * (u * u * (z * z')) <= 28 * (u * u * (z * z'))) by (apply Rmult_le_compat_r; lra).
    assert ((c + c') * (u * (kappa * y)) <= 225 * (u * (kappa * y))) by (apply Rmult_le_compat_r; lra).
    unfold approx. fold y. repeat split; try lra.
    - eapply Rle_trans; [apply dot_norm |]. apply Rmult_le_compat; auto using norm_nonneg.
    - replace (D - dot x x') with ((D - dot X X') + (dot X X' - dot x x')) by ring. eapply Rle_trans; [apply Rabs_triang |].
      lra.
  Qed.

  Lemma approx_opposite k c n z x X : approx k c n z x X -> approx k c n z (- x) (- X).
  Proof using u_range.
    intros (k0 & c0 & z0 & xz & off). unfold approx. rewrite Rabs_Ropp. replace (- X - - x) with (- (X - x)) by ring.
    rewrite Rabs_Ropp. repeat split; tauto.
  Qed.

  Lemma leaf_approx x X : leaf_of x X -> norm x <= 4 * s ^ 1 -> approx_vec 1 0 1 (norm x) x X.
  Proof using u_range.
    intros (hx & hy & hz) long. pose proof (norm_nonneg x). unfold approx_vec. repeat split; try lra.
    assert (norm (sub X x) <= norm (Vec (u * Rabs (cx x)) (u * Rabs (cy x)) (u * Rabs (cz x)))) as step
      by (apply norm_monotone; assumption).
    eapply Rle_trans; [exact step |]. replace (1 * u * norm x + 0 * kappa * s ^ 1) with (u * norm x) by ring.
    apply norm_at_most; [apply Rmult_le_pos; lra |].
    replace (u * norm x * (u * norm x)) with (u * u * (norm x * norm x)) by ring. rewrite norm_square, <- (sizes_square x).
    unfold sizes, dot. rewrite !Rabs_mult. cbn [cx cy cz]. right. ring.
  Qed.

  Lemma leaf_difference a b c d A B C D E : Rabs (A - a) <= u * Rabs a -> Rabs (B - b) <= u * Rabs b ->
    Rabs (C - c) <= u * Rabs c -> Rabs (D - d) <= u * Rabs d -> computed_difference u eta A B C D E ->
    Rabs (E - (a * b - c * d)) <= 4.005 * u * (Rabs (a * b) + Rabs (c * d)) + 4 * eta.
  Proof using eta_nonneg u_range.
    intros Ha Hb Hc Hd HE. destruct (leaf_product u u_range _ _ _ _ Ha Hb) as [off size].
    destruct (leaf_product u u_range _ _ _ _ Hc Hd) as [off' size'].
    apply difference_error in HE; [| assumption | assumption].
    replace (E - (a * b - c * d)) with ((E - (A * B - C * D)) + ((A * B - C * D) - (a * b - c * d))) by ring.
    pose proof (minus_off _ _ _ _ _ _ off off') as change. eapply Rle_trans; [apply Rabs_triang |].
    apply (Rmult_le_compat_l u) in size, size'; try lra.
    pose proof (small _ (Rabs_pos (a * b))). pose proof (small _ (Rabs_pos (c * d))). lra.
  Qed.

  Lemma cross_approx x y X Y N : leaf_of x X -> leaf_of y Y -> computed_cross X Y N -> norm x * norm y <= 4 * s ^ 2 ->
    approx_vec 5.665 7 2 (norm x * norm y) (cross x y) N.
  Proof using All.
    intros (xx & xy & xz) (yx & yy & yz) (HX & HY & HZ) long.
    pose proof (norm_nonneg x). pose proof (norm_nonneg y). assert (0 <= norm x * norm y) as p0 by (apply Rmult_le_pos; assumption).
    unfold approx_vec. repeat split; try lra; [apply cross_norm |].
    pose proof (leaf_difference _ _ _ _ _ _ _ _ _ xy yz xz yy HX) as dx.
    pose proof (leaf_difference _ _ _ _ _ _ _ _ _ xz yx xx yz HY) as dy.
    pose proof (leaf_difference _ _ _ _ _ _ _ _ _ xx yy xy yx HZ) as dz.
    assert (norm (sub N (cross x y)) <= norm (add (scale (cross_sizes x y) (4.005 * u)) (Vec (4 * eta) (4 * eta) (4 * eta)))) as step.
    { apply norm_monotone; unfold sub, cross, add, scale, cross_sizes; cbn [cx cy cz]; lra. }
    eapply Rle_trans; [exact step |]. eapply Rle_trans; [apply norm_triangle |].
    assert (norm (scale (cross_sizes x y) (4.005 * u)) <= 5.665 * u * (norm x * norm y)) as part.
    { pose proof (cross_sizes_norm x y) as size. apply Rle_trans with (4.005 * u * norm (cross_sizes x y)).
      - assert (0 <= u * norm (cross_sizes x y)) by (apply Rmult_le_pos; [lra | apply norm_nonneg]).
        apply norm_at_most; [lra |].
        replace (4.005 * u * norm (cross_sizes x y) * (4.005 * u * norm (cross_sizes x y)))
          with (4.005 * u * (4.005 * u) * (norm (cross_sizes x y) * norm (cross_sizes x y))) by lra.
        rewrite norm_square. unfold dot, scale. cbn [cx cy cz]. right. lra.
      - apply (Rmult_le_compat_l u) in size; [| lra]. pose proof (small _ p0). lra. }
    assert (norm (Vec (4 * eta) (4 * eta) (4 * eta)) <= 7 * eta) as rest.
    { apply norm_at_most; [lra |]. unfold dot. cbn [cx cy cz]. pose proof (Rmult_le_pos _ _ eta_nonneg eta_nonneg). lra. }
    pose proof (underflow 2 ltac:(lia)). lra.
  Qed.

  (* The rounded difference of two values, and of a value and a product that may be fused with it. *)
  Lemma difference_within k c k' c' n z x X z' x' X' M : (2 <= n <= 6)%nat -> approx k c n z x X -> approx k' c' n z' x' X' ->
    rounds (X - X') M ->
    Rabs (M - (x - x')) <= (k + 1.001) * u * z + (k' + 1.001) * u * z' + (c + c' + 2) * kappa * s ^ n.
  Proof using All.
    intros range (k0 & c0 & z0 & xz & off) (k0' & c0' & z0' & xz' & off') H.
    pose proof (rounds_off u eta u_range _ _ _ _ (minus_off _ _ _ _ _ _ off off') H) as total.
    pose proof (underflow n range) as tiny. pose proof (power_nonneg n) as y0. pose proof kappa_range as k00. set (y := s ^ n) in *.
    assert (0 <= kappa * y) as hy by (apply Rmult_le_pos; lra). pose proof (small _ hy).
    assert (Rabs (x - x') <= z + z') as size.
    { unfold Rminus. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra. }
    apply (Rmult_le_compat_l u) in size; [| lra]. pose proof (smaller z ltac:(lra)). pose proof (smaller z' ltac:(lra)).
    assert (k * (u * u * z) <= 32 * (u * u * z)) by (apply Rmult_le_compat_r; lra).
    assert (k' * (u * u * z') <= 32 * (u * u * z')) by (apply Rmult_le_compat_r; lra).
    assert ((c + c') * (u * (kappa * y)) <= 2000 * (u * (kappa * y))) by (apply Rmult_le_compat_r; lra). lra.
  Qed.

  Definition computed_minus_product (X Y Z M : R) : Prop :=
    rounds (X - Y * Z) M \/ exists p, rounds (Y * Z) p /\ rounds (X - p) M.
  Lemma minus_product_within k c n z x X k1 c1 n1 z1 x1 X1 k2 c2 n2 z2 x2 X2 M :
    n = (n1 + n2)%nat -> (2 <= n <= 6)%nat -> k1 + k2 <= 28 -> 4 * (c1 + c2) <= 900 -> z1 * z2 <= 4 * s ^ n ->
    approx k c n z x X -> approx k1 c1 n1 z1 x1 X1 -> approx k2 c2 n2 z2 x2 X2 -> computed_minus_product X X1 X2 M ->
    Rabs (M - (x - x1 * x2)) <=
      (k + 1.001) * u * z + (k1 + k2 + 2.003) * u * (z1 * z2) + (c + 4 * (c1 + c2) + 5) * kappa * s ^ n.
  Proof using All.
    intros same range kk cc zz HX H1 H2 H. subst n. destruct (approx_product _ _ _ _ _ _ _ _ _ _ _ _ range H1 H2) as [size off].
    pose proof H1 as (k10 & c10 & z10 & _). pose proof H2 as (k20 & c20 & z20 & _).
    assert (0 <= z1 * z2) as zz0 by (apply Rmult_le_pos; lra).
    pose proof (power_nonneg (n1 + n2)) as y0. pose proof kappa_range as k00.
    assert (0 <= kappa * s ^ (n1 + n2)) as hy by (apply Rmult_le_pos; lra). pose proof (small _ zz0).
    assert (approx (k1 + k2 + 0.001) (4 * (c1 + c2) + 1) (n1 + n2) (z1 * z2) (x1 * x2) (X1 * X2)) as product
      by (unfold approx; repeat split; lra).
    destruct H as [H | (p & Hp & H)].
    - pose proof (difference_within _ _ _ _ _ _ _ _ _ _ _ _ range HX product H) as total. lra.
    - assert (approx (k1 + k2 + 0.001 + 1.001) (4 * (c1 + c2) + 1 + 2) (n1 + n2) (z1 * z2) (x1 * x2) p) as rounded
        by (apply approx_rounded with (Y := X1 * X2); try assumption; lra).
      pose proof (difference_within _ _ _ _ _ _ _ _ _ _ _ _ range HX rounded H) as total. lra.
  Qed.

  (* A query: the vertices, with the sphere's centre at the origin. *)
  Variables (a b c : vec) (r : R).
  Let ab := sub b a.
  Let bc := sub c b.
  Let ca := sub a c.
  Let S := dot a a + dot b b + dot c c + r * r.
  Let E := dot ab ab + dot bc bc + dot ca ca.
  Hypothesis S_square : s ^ 2 = S.

  Lemma edge_twice x y : dot (sub y x) (sub y x) <= 2 * (dot x x + dot y y).
  Proof using Type.
    pose proof (dot_self_nonneg (add x y)) as H.
    replace (dot (add x y) (add x y)) with (2 * (dot x x + dot y y) - dot (sub y x) (sub y x)) in H
      by (unfold dot, add, sub; cbn [cx cy cz]; ring). lra.
  Qed.
  Lemma E_at_most : E <= 3 * S.
  Proof using ab bc ca r.
    pose proof (dot_self_nonneg (add (add a b) c)) as H. pose proof (Rle_0_sqr r). unfold Rsqr in *.
    replace (dot (add (add a b) c) (add (add a b) c)) with (3 * (dot a a + dot b b + dot c c) - E) in H
      by (unfold E, ab, bc, ca, dot, add, sub; cbn [cx cy cz]; ring). unfold S. lra.
  Qed.
  (* An edge is at most two thirds of E. *)
  Lemma edge_share x y z : dot (sub y x) (sub y x) <= 2 * (dot (sub z y) (sub z y) + dot (sub x z) (sub x z)).
  Proof using Type.
    pose proof (edge_twice (sub z y) (sub z x)) as H.
    replace (dot (sub (sub z x) (sub z y)) (sub (sub z x) (sub z y))) with (dot (sub y x) (sub y x)) in H
      by (unfold dot, sub; cbn [cx cy cz]; ring).
    replace (dot (sub z x) (sub z x)) with (dot (sub x z) (sub x z)) in H by (unfold dot, sub; cbn [cx cy cz]; ring). lra.
  Qed.

  Lemma parts_nonneg : 0 <= dot a a /\ 0 <= dot b b /\ 0 <= dot c c /\ 0 <= r * r /\ 0 <= dot ab ab /\ 0 <= dot bc bc /\ 0 <= dot ca ca.
  Proof using Type. repeat split; try apply dot_self_nonneg. apply Rle_0_sqr. Qed.

  Lemma norm_root x k : 0 <= k -> dot x x <= k * k * S -> norm x <= k * s ^ 1.
  Proof using S_square s0 underflow_2 underflow_6.
    intros k0 H. rewrite <- S_square in H. apply norm_at_most; [apply Rmult_le_pos; [assumption | apply power_nonneg] |].
    cbn [pow] in *. rewrite !Rmult_1_r in *. lra.
  Qed.

  (* The values computed first. *)
  Variables A B C AB BC CA : vec.
  Variables aa bb cc rr e1 e2 e3 : R.
  Hypothesis leaf_a : leaf_of a A.
  Hypothesis leaf_b : leaf_of b B.
  Hypothesis leaf_c : leaf_of c C.
  Hypothesis leaf_ab : leaf_of ab AB.
  Hypothesis leaf_bc : leaf_of bc BC.
  Hypothesis leaf_ca : leaf_of ca CA.
  Hypothesis computed_aa : computed_dot A A aa.
  Hypothesis computed_bb : computed_dot B B bb.
  Hypothesis computed_cc : computed_dot C C cc.
  Hypothesis computed_rr : rounds (r * r) rr.
  Hypothesis computed_e1 : computed_dot AB AB e1.
  Hypothesis computed_e2 : computed_dot BC BC e2.
  Hypothesis computed_e3 : computed_dot CA CA e3.

  Lemma leaf_square x X xx : leaf_of x X -> computed_dot X X xx -> dot x x <= 2 * S ->
    approx 5.005 8 2 (dot x x) (dot x x) xx.
  Proof using S_square ab bc ca eta_nonneg s0 u_range underflow_2 underflow_6.
    intros leaf H size. pose proof (dot_self_nonneg x) as x0. pose proof parts_nonneg as (? & ? & ? & ? & _).
    assert (0 <= S) by (unfold S; lra).
    assert (norm x <= 4 * s ^ 1) as long by (apply norm_root; lra).
    pose proof (leaf_approx x X leaf long) as near.
    rewrite <- (norm_square x) at 1.
    pose proof (approx_vec_product 1 0 1 (norm x) x X 1 0 1 (norm x) x X xx ltac:(lia) ltac:(lra) ltac:(lra)) as product.
    cbn [Nat.add] in product. destruct product as (k0 & c0 & z0 & xz & off); try assumption.
    { rewrite norm_square, S_square. lra. }
    unfold approx. repeat split; lra.
  Qed.
  Lemma approx_aa : approx 5.005 8 2 (dot a a) (dot a a) aa.
  Proof using S_square ab bc ca computed_aa eta_nonneg leaf_a s0 u_range underflow_2 underflow_6. apply leaf_square with A; try assumption. pose proof parts_nonneg. unfold S. lra. Qed.
  Lemma approx_bb : approx 5.005 8 2 (dot b b) (dot b b) bb.
  Proof using S_square ab bc ca computed_bb eta_nonneg leaf_b s0 u_range underflow_2 underflow_6. apply leaf_square with B; try assumption. pose proof parts_nonneg. unfold S. lra. Qed.
  Lemma approx_cc : approx 5.005 8 2 (dot c c) (dot c c) cc.
  Proof using S_square ab bc ca computed_cc eta_nonneg leaf_c s0 u_range underflow_2 underflow_6. apply leaf_square with C; try assumption. pose proof parts_nonneg. unfold S. lra. Qed.
  Lemma approx_e1 : approx 5.005 8 2 (dot ab ab) (dot ab ab) e1.
  Proof using S_square bc ca computed_e1 eta_nonneg leaf_ab s0 u_range underflow_2 underflow_6. apply leaf_square with AB; try assumption. pose proof parts_nonneg. pose proof (edge_twice a b). unfold S, ab. lra. Qed.
  Lemma approx_e2 : approx 5.005 8 2 (dot bc bc) (dot bc bc) e2.
  Proof using S_square ab ca computed_e2 eta_nonneg leaf_bc s0 u_range underflow_2 underflow_6. apply leaf_square with BC; try assumption. pose proof parts_nonneg. pose proof (edge_twice b c). unfold S, bc. lra. Qed.
  Lemma approx_e3 : approx 5.005 8 2 (dot ca ca) (dot ca ca) e3.
  Proof using S_square ab bc computed_e3 eta_nonneg leaf_ca s0 u_range underflow_2 underflow_6. apply leaf_square with CA; try assumption. pose proof parts_nonneg. pose proof (edge_twice c a). unfold S, ca. lra. Qed.
  Lemma approx_rr : approx 1.001 2 2 (r * r) (r * r) rr.
  Proof using S_square ab bc ca computed_rr eta_nonneg s0 u_range underflow_2 underflow_6.
    pose proof parts_nonneg as (? & ? & ? & ? & _).
    destruct (approx_rounded 0 0 2 (r * r) (r * r) (r * r) rr) as (k0 & c0 & z0 & xz & off);
      try assumption; try lra; try lia; try (rewrite S_square; unfold S; lra).
    - rewrite Rabs_pos_eq by assumption. lra.
    - rewrite Rminus_eq_0, Rabs_R0. lra.
    - unfold approx. repeat split; lra.
  Qed.

  (* S and E as the step computes them, and the thresholds. *)
  Variables s1 s2 Sc f1 f2 f3 Ec : R.
  Hypothesis sum_1 : rounds (aa + bb) s1.
  Hypothesis sum_2 : rounds (s1 + cc) s2.
  Hypothesis sum_S : rounds (s2 + rr) Sc.
  Hypothesis edges_1 : rounds (e1 + e2) f1.
  Hypothesis edges_2 : rounds (f1 + e3) f2.
  Hypothesis floor_E : rounds (/ 1048576 * Sc) f3.
  Hypothesis sum_E : rounds (f2 + f3) Ec.
  Let floored := E + / 1048576 * S.

  Lemma approx_sum k c0 k' c0' z x X z' x' X' Y K : approx k c0 2 z x X -> approx k' c0' 2 z' x' X' -> rounds (X + X') Y ->
    k <= K -> k' <= K -> K <= 20 -> c0 + c0' <= 900 -> z + z' <= 4 * S ->
    approx (K + 1.001) (c0 + c0' + 2) 2 (z + z') (x + x') Y.
  Proof using S_square eta_nonneg s0 u_range underflow_2 underflow_6.
    intros (k0 & cc0 & z0 & xz & off) (k0' & cc0' & z0' & xz' & off') H kK kK' K20 c900 size.
    apply approx_rounded with (Y := X + X'); try assumption; try lra; try lia.
    - eapply Rle_trans; [apply Rabs_triang | lra].
    - eapply Rle_trans; [apply (plus_off _ _ _ _ _ _ off off') |].
      assert (k * (u * z) <= K * (u * z)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | assumption]).
      assert (k' * (u * z') <= K * (u * z')) by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | assumption]). lra.
  Qed.

  Lemma approx_S : approx 8.008 32 2 S S Sc.
  Proof.
    pose proof parts_nonneg as (? & ? & ? & ? & _).
    pose proof (approx_sum _ _ _ _ _ _ _ _ _ _ _ 5.005 approx_aa approx_bb sum_1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(unfold S; lra)) as h1.
    pose proof (approx_sum _ _ _ _ _ _ _ _ _ _ _ 6.006 h1 approx_cc sum_2 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(unfold S; lra)) as h2.
    pose proof (approx_sum _ _ _ _ _ _ _ _ _ _ _ 7.007 h2 approx_rr sum_S ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(unfold S; lra)) as (k0 & c0 & z0 & xz & off).
    unfold approx. unfold S in *. repeat split; lra.
  Qed.
  Lemma S_nonneg : 0 < S. Proof using S_square s0. rewrite <- S_square. apply pow_lt, s0. Qed.

  Lemma approx_E : approx 12 200 2 floored floored Ec.
  Proof.
    pose proof parts_nonneg as (? & ? & ? & ? & ? & ? & ?). pose proof E_at_most as E3. pose proof S_nonneg.
    unfold E in E3.
    pose proof (approx_sum _ _ _ _ _ _ _ _ _ _ _ 5.005 approx_e1 approx_e2 edges_1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as h1.
    pose proof (approx_sum _ _ _ _ _ _ _ _ _ _ _ 6.006 h1 approx_e3 edges_2 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as h2.
    assert (approx 10 34 2 (/ 1048576 * S) (/ 1048576 * S) f3) as h3.
    { destruct approx_S as (_ & _ & _ & xz & off).
      destruct (approx_rounded 8.008 32 2 (/ 1048576 * S) (/ 1048576 * S) (/ 1048576 * Sc) f3) as (k0 & c0 & z0 & xz' & off');
        try assumption; try lra; try lia.
        - rewrite Rabs_pos_eq by lra. lra.
      - replace (/ 1048576 * Sc - / 1048576 * S) with (/ 1048576 * (Sc - S)) by ring. rewrite Rabs_mult, (Rabs_pos_eq (/ 1048576)) by lra.
        pose proof kappa_range. pose proof (power_nonneg 2). assert (0 <= kappa * s ^ 2) by (apply Rmult_le_pos; lra). lra.
      - assert (0 <= u * (/ 1048576 * S)) by (apply Rmult_le_pos; lra). unfold approx. repeat split; lra. }
    pose proof (approx_sum _ _ _ _ _ _ _ _ _ _ _ 10 h2 h3 sum_E ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as (k0 & c0 & z0 & xz & off).
    pose proof kappa_range. pose proof (power_nonneg 2). assert (0 <= kappa * s ^ 2) by (apply Rmult_le_pos; lra).
    assert (0 <= floored) as fl by (unfold floored, E; lra). pose proof (small _ fl). unfold approx. unfold floored, E in *. repeat split; lra.
  Qed.

  (* The thresholds, bounded from below. *)
  Variables T2 SE T4 SEE T6 : R.
  Hypothesis threshold_2 : rounds (coarse_degree_2 * u * Sc) T2.
  Hypothesis product_4 : rounds (Sc * Ec) SE.
  Hypothesis threshold_4 : rounds (coarse_degree_4 * u * SE) T4.
  Hypothesis product_6 : rounds (SE * Ec) SEE.
  Hypothesis threshold_6 : rounds (coarse_degree_6 * u * SEE) T6.

  Lemma rounds_from_below x X y k n : 0 <= y -> y <= x -> 0 <= k -> rounds x X -> (2 <= n <= 6)%nat -> s ^ n <= k ->
    0.999 * y - kappa * k <= X.
  Proof using s0 u_range underflow_2 underflow_6.
    intros y0 yx k0 H range small_n. unfold Lanes.rounds in H. rewrite (Rabs_pos_eq x) in H by lra. apply Rabs_le_inv in H.
    pose proof (underflow n range). pose proof kappa_range. pose proof (small x ltac:(lra)).
    assert (kappa * s ^ n <= kappa * k) by (apply Rmult_le_compat_l; lra). lra.
  Qed.

  Lemma S_from_below : 0.9999 * S <= Sc.
  Proof.
    destruct approx_S as (_ & _ & _ & _ & off). apply Rabs_le_inv in off. pose proof S_nonneg. pose proof kappa_range.
    rewrite S_square in off. pose proof (small S ltac:(lra)).
    assert (kappa * S <= / 1000000000000000000 * S) by (apply Rmult_le_compat_r; lra). lra.
  Qed.
  Lemma floored_nonneg : / 1048576 * S <= floored.
  Proof using E r. pose proof parts_nonneg. unfold floored, E. lra. Qed.
  Lemma E_from_below : 0.9998 * floored <= Ec.
  Proof.
    destruct approx_E as (_ & _ & _ & _ & off). apply Rabs_le_inv in off. pose proof S_nonneg. pose proof kappa_range.
    pose proof floored_nonneg. rewrite S_square in off. pose proof (small floored ltac:(lra)).
    assert (kappa * S <= / 1000000000000000000 * S) by (apply Rmult_le_compat_r; lra). lra.
  Qed.

  Lemma u_kappa : kappa * 1000000000000000000 = u. Proof using Type. unfold kappa. lra. Qed.

  Lemma T2_from_below : 20.1 * u * S <= T2.
  Proof.
    pose proof S_nonneg. pose proof S_from_below as low. apply (Rmult_le_compat_l u) in low; [| lra].
    pose proof (small S ltac:(lra)) as uS.
    pose proof (rounds_from_below (coarse_degree_2 * u * Sc) T2 (20.185 * (u * S)) S 2 ltac:(lra) ltac:(unfold coarse_degree_2; lra) ltac:(lra) threshold_2 ltac:(lia)
      ltac:(rewrite S_square; lra)) as H0. pose proof u_kappa. assert (kappa * S * 1000000000000000000 = u * S) by (rewrite <- u_kappa; ring). lra.
  Qed.

  Lemma SE_from_below : 0.998 * (S * floored) <= SE.
  Proof.
    pose proof S_nonneg. pose proof S_from_below as low. pose proof E_from_below as low'. pose proof floored_nonneg. pose proof kappa_range.
    assert (0.9999 * S * (0.9998 * floored) <= Sc * Ec) as product by (apply Rmult_le_compat; lra).
    assert (0 <= S * S) as SS by (apply Rmult_le_pos; lra). assert (/ 1048576 * (S * S) <= S * floored) as SF.
    { replace (/ 1048576 * (S * S)) with (S * (/ 1048576 * S)) by ring. apply Rmult_le_compat_l; lra. }
    assert (s ^ 4 = S * S) as s4 by (rewrite <- S_square; ring).
    pose proof (rounds_from_below (Sc * Ec) SE (0.9997 * (S * floored)) (S * S) 4 ltac:(lra) ltac:(lra) SS product_4 ltac:(lia) ltac:(lra)).
    assert (kappa * (S * S) <= / 1000000000000000000 * (S * S)) by (apply Rmult_le_compat_r; lra). lra.
  Qed.

  Lemma T4_from_below : 11 * u * (S * E) + 1000 * kappa * s ^ 4 <= T4.
  Proof.
    pose proof S_nonneg. pose proof SE_from_below as low. pose proof floored_nonneg.
    apply (Rmult_le_compat_l u) in low; [| lra].
    assert (s ^ 4 = S * S) as s4 by (rewrite <- S_square; ring). rewrite s4.
    assert (0 <= S * S) as SS by (apply Rmult_le_pos; lra). assert (0 <= S * floored) as SF by (apply Rmult_le_pos; lra).
    pose proof (small _ SF). pose proof (small _ SS).
    pose proof (rounds_from_below (coarse_degree_4 * u * SE) T4 (11.13 * (u * (S * floored))) (S * S) 4 ltac:(lra) ltac:(unfold coarse_degree_4; lra) SS threshold_4
      ltac:(lia) ltac:(lra)).
    assert (kappa * (S * S) * 1000000000000000000 = u * (S * S)) by (rewrite <- u_kappa; ring).
    assert (u * (S * floored) = u * (S * E) + / 1048576 * (u * (S * S))) by (unfold floored; ring).
    pose proof parts_nonneg. assert (0 <= u * (S * E)) by (repeat apply Rmult_le_pos; unfold E; lra). lra.
  Qed.

  Lemma T6_from_below : 5.8 * u * (S * (E * E)) + 1000 * kappa * s ^ 6 <= T6.
  Proof.
    pose proof S_nonneg. pose proof SE_from_below as low. pose proof E_from_below as low'. pose proof floored_nonneg as fl.
    pose proof kappa_range. pose proof parts_nonneg. assert (0 <= E) as E0 by (unfold E; lra).
    assert (s ^ 6 = S * S * S) as s6 by (rewrite <- S_square; ring). rewrite s6.
    assert (0 <= S * S) as SS by (apply Rmult_le_pos; lra). assert (0 <= S * S * S) as SSS by (apply Rmult_le_pos; lra).
    assert (0 <= S * floored) as SF by (apply Rmult_le_pos; lra).
    assert (0 <= S * floored * floored) as SFF by (apply Rmult_le_pos; lra).
    assert (0.998 * (S * floored) * (0.9998 * floored) <= SE * Ec) as product by (apply Rmult_le_compat; lra).
    assert (/ 1048576 * / 1048576 * (S * S * S) <= S * floored * floored) as SFF_low.
    { replace (/ 1048576 * / 1048576 * (S * S * S)) with (S * (/ 1048576 * S) * (/ 1048576 * S)) by ring.
      apply Rmult_le_compat; try lra. apply Rmult_le_compat_l; lra. }
    pose proof (rounds_from_below (SE * Ec) SEE (0.9977 * (S * floored * floored)) (S * S * S) 6 ltac:(lra) ltac:(lra) SSS product_6 ltac:(lia) ltac:(lra)) as SEE_low.
    assert (kappa * (S * S * S) <= / 1000000000000000000 * (S * S * S)) by (apply Rmult_le_compat_r; lra).
    assert (0.9966 * (S * floored * floored) <= SEE) as low6 by lra. apply (Rmult_le_compat_l u) in low6; [| lra].
    pose proof (small _ SFF). pose proof (small _ SSS).
    pose proof (rounds_from_below (coarse_degree_6 * u * SEE) T6 (5.8235 * (u * (S * floored * floored))) (S * S * S) 6 ltac:(lra) ltac:(unfold coarse_degree_6; lra) SSS
      threshold_6 ltac:(lia) ltac:(lra)).
    assert (kappa * (S * S * S) * 1000000000000000000 = u * (S * S * S)) by (rewrite <- u_kappa; ring).
    assert (u * (S * floored * floored) = u * (S * (E * E)) + 2 * / 1048576 * (u * (S * S * E)) + / 1048576 * / 1048576 * (u * (S * S * S)))
      by (unfold floored; ring).
    assert (0 <= u * (S * (E * E))) by (repeat apply Rmult_le_pos; lra). assert (0 <= u * (S * S * E)) by (repeat apply Rmult_le_pos; lra). lra.
  Qed.

  (* Degree 2: |X|^2 - r^2, and |Y|^2 - |X|^2 - |XY|^2 = 2 X.(Y - X). *)
  Lemma radius_2 x xx M : dot x x <= S - r * r -> approx 5.005 8 2 (dot x x) (dot x x) xx -> rounds (xx - rr) M ->
    Rabs (M - (dot x x - r * r)) <= T2.
  Proof.
    intros size H HM. pose proof (difference_within _ _ _ _ 2 _ _ _ _ _ _ _ ltac:(lia) H approx_rr HM) as total.
    pose proof T2_from_below. pose proof S_nonneg. pose proof (small S ltac:(lra)) as uS. rewrite S_square in total.
    assert (kappa * S * 1000000000000000000 = u * S) by (rewrite <- u_kappa; ring). pose proof (dot_self_nonneg x).
    pose proof (Rle_0_sqr r). unfold Rsqr in *.
    assert (u * (dot x x + r * r) <= u * S) by (apply Rmult_le_compat_l; lra).
    assert (0 <= u * (r * r)) by (apply Rmult_le_pos; lra). lra.
  Qed.
  Lemma side_2 x y xx yy e D M : dot x x + dot y y <= S -> dot (sub y x) (sub y x) <= 2 * S ->
    approx 5.005 8 2 (dot x x) (dot x x) xx -> approx 5.005 8 2 (dot y y) (dot y y) yy ->
    approx 5.005 8 2 (dot (sub y x) (sub y x)) (dot (sub y x) (sub y x)) e ->
    rounds (yy - xx) D \/ (exists D', D = - D' /\ rounds (xx - yy) D') -> rounds (D - e) M ->
    Rabs (M - 2 * dot x (sub y x)) <= T2.
  Proof.
    intros size size_e Hx Hy He HD HM. pose proof S_nonneg. pose proof (dot_self_nonneg x). pose proof (dot_self_nonneg y).
    assert (approx 6.006 18 2 (dot x x + dot y y) (dot y y - dot x x) D) as difference.
    { assert (within : forall p q P Q D, approx 5.005 8 2 p p P -> approx 5.005 8 2 q q Q -> 0 <= p -> 0 <= q -> p + q <= S -> rounds (P - Q) D ->
        approx 6.006 18 2 (p + q) (p - q) D).
      { intros p q P Q F Hp Hq p0 q0 pq HF. pose proof (difference_within _ _ _ _ 2 _ _ _ _ _ _ _ ltac:(lia) Hp Hq HF) as total.
        unfold approx. rewrite S_square in *. repeat split; try lra. unfold Rabs. destruct Rcase_abs; lra. }
      destruct HD as [HD | (D' & -> & HD)].
      - rewrite Rplus_comm. apply within with yy xx; try assumption; lra.
      - replace (dot y y - dot x x) with (- (dot x x - dot y y)) by ring. apply approx_opposite. apply within with xx yy; assumption. }
    pose proof (difference_within _ _ _ _ 2 _ _ _ _ _ _ _ ltac:(lia) difference He HM) as total.
    replace (2 * dot x (sub y x)) with (dot y y - dot x x - dot (sub y x) (sub y x)) by (unfold dot, sub; cbn [cx cy cz]; ring).
    pose proof T2_from_below. rewrite S_square in total. pose proof (edge_twice x y) as twice.
    assert (kappa * S * 1000000000000000000 = u * S) by (rewrite <- u_kappa; ring).
    apply (Rmult_le_compat_l u) in size, twice; try lra. pose proof (small S ltac:(lra)). lra.
  Qed.

  (* Degree 4. x is a vertex, y the edge that begins there. *)
  Lemma lengths x y : dot x x + dot (add x y) (add x y) <= S -> 0 <= norm x * norm y <= 1.21 * s ^ 2.
  Proof using S_square.
    intros size. pose proof (norm_nonneg x) as x0. pose proof (norm_nonneg y). pose proof (norm_nonneg (add x y)) as t0.
    split; [apply Rmult_le_pos; assumption |].
    assert (norm y <= norm x + norm (add x y)) as longer.
    { pose proof (norm_triangle (scale x (-1)) (add x y)) as triangle.
      assert (norm (scale x (-1)) = norm x) as same
        by (unfold norm; f_equal; unfold dot, scale; cbn [cx cy cz]; ring).
      rewrite same in triangle. replace (add (scale x (-1)) (add x y)) with y in triangle by (destruct x, y; unfold add, scale; cbn; f_equal; ring).
      exact triangle. }
    rewrite S_square. rewrite <- !norm_square in size. apply (Rmult_le_compat_l (norm x)) in longer; [| assumption].
    set (p := norm x) in *. set (q := norm (add x y)) in *. pose proof (Rle_0_sqr (p - 2.4 * q)) as squares. pose proof (Rle_0_sqr q).
    unfold Rsqr in *. nra.
  Qed.

  Variable V : vec.
  Hypothesis computed_V : computed_cross CA AB V.
  Let w := norm ca * norm ab.
  Lemma w_range : 0 <= w <= E / 2 /\ w <= 1.5 * s ^ 2.
  Proof using S_square ab bc ca.
    pose proof (norm_nonneg ca). pose proof (norm_nonneg ab). pose proof E_at_most as E3. pose proof (dot_self_nonneg bc).
    assert (0 <= w) by (apply Rmult_le_pos; assumption). rewrite S_square.
    assert (2 * w <= dot ca ca + dot ab ab).
    { rewrite <- (norm_square ca), <- (norm_square ab). pose proof (Rle_0_sqr (norm ca - norm ab)). unfold Rsqr, w in *. lra. }
    unfold E in *. repeat split; lra.
  Qed.
  Lemma approx_V : approx_vec 5.665 7 2 w (cross ca ab) V.
  Proof using E S_square computed_V eta_nonneg leaf_ab leaf_ca s0 u_range underflow_2 underflow_6. pose proof w_range. pose proof (power_nonneg 2). apply cross_approx with CA AB; try assumption. fold w. lra. Qed.

  Lemma edge_radius_4 x y X Y N nn e M : leaf_of x X -> leaf_of y Y -> computed_cross X Y N -> computed_dot N N nn ->
    dot x x + dot (add x y) (add x y) <= S - r * r -> 3 * dot y y <= 2 * E -> approx 5.005 8 2 (dot y y) (dot y y) e ->
    computed_minus_product nn rr e M ->
    Rabs (M - (dot (cross x y) (cross x y) - r * r * dot y y)) <= T4.
  Proof.
    intros lx ly HN Hnn size share He HM. pose proof S_nonneg. pose proof parts_nonneg. pose proof (Rle_0_sqr r) as r0. unfold Rsqr in r0.
    pose proof (lengths x y ltac:(lra)) as long. pose proof (power_nonneg 2) as p2.
    assert (approx_vec 5.665 7 2 (norm x * norm y) (cross x y) N) as near by (apply cross_approx with X Y; try assumption; lra).
    assert (s ^ 4 = s ^ 2 * s ^ 2) as s4 by ring.
    assert (norm x * norm y * (norm x * norm y) <= 1.21 * s ^ 2 * (1.21 * s ^ 2)) as square by (apply Rmult_le_compat; lra).
    assert (0 <= s ^ 2 * s ^ 2) by (apply Rmult_le_pos; lra).
    assert (approx (5.665 + 5.665 + 3.005) (4 * (7 + 7) + 8) 4 (norm x * norm y * (norm x * norm y)) (dot (cross x y) (cross x y)) nn) as near_nn.
    { apply (approx_vec_product 5.665 7 2 _ _ N 5.665 7 2 _ _ N nn); try assumption; try lra; try lia. cbn [Nat.add]. lra. }
    pose proof (dot_self_nonneg y) as y0. pose proof He as (_ & _ & e4 & _).
    assert (r * r * dot y y <= 4 * s ^ 4) as ry.
    { pose proof (dot_self_nonneg x). pose proof (dot_self_nonneg (add x y)). rewrite s4.
      apply Rle_trans with (s ^ 2 * (4 * s ^ 2)); [apply Rmult_le_compat; rewrite ?S_square in *; lra | lra]. }
    pose proof (minus_product_within _ _ 4 _ _ _ 1.001 2 2 _ _ _ 5.005 8 2 _ _ _ _ eq_refl ltac:(lia) ltac:(lra) ltac:(lra) ry near_nn approx_rr He HM) as total.
    eapply Rle_trans; [exact total |]. pose proof T4_from_below.
    replace (norm x * norm y * (norm x * norm y)) with (norm x * norm x * (norm y * norm y)) by ring. rewrite !norm_square.
    assert (0 <= u * (r * r * dot y y)) as ury by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
    assert (0 <= dot (add x y) (add x y)) by apply dot_self_nonneg.
    assert ((dot x x + r * r) * dot y y <= S * (2 / 3 * E)) as bound.
    { pose proof (dot_self_nonneg x). apply Rmult_le_compat; lra. }
    apply (Rmult_le_compat_l u) in bound; [| lra].
    assert (0 <= u * (S * E)) by (repeat apply Rmult_le_pos; unfold E; lra).
    pose proof kappa_range. assert (0 <= kappa * s ^ 4) by (apply Rmult_le_pos; [lra | apply power_nonneg]). lra.
  Qed.

  Lemma edge_side_4 x y X Y N M : leaf_of x X -> leaf_of y Y -> computed_cross X Y N -> computed_dot N V M ->
    dot x x + dot (add x y) (add x y) <= S ->
    Rabs (- M - - dot (cross x y) (cross ca ab)) <= T4.
  Proof.
    intros lx ly HN HM size. pose proof S_nonneg. pose proof parts_nonneg. pose proof (lengths x y size) as long.
    pose proof (power_nonneg 2) as p2. pose proof w_range as (w0 & w1).
    assert (approx_vec 5.665 7 2 (norm x * norm y) (cross x y) N) as near by (apply cross_approx with X Y; try assumption; lra).
    assert (s ^ 4 = s ^ 2 * s ^ 2) as s4 by ring. assert (0 <= s ^ 2 * s ^ 2) by (apply Rmult_le_pos; lra).
    assert (norm x * norm y * w <= 1.21 * s ^ 2 * (1.5 * s ^ 2)) as product by (apply Rmult_le_compat; lra).
    assert (approx (5.665 + 5.665 + 3.005) (4 * (7 + 7) + 8) 4 (norm x * norm y * w) (dot (cross x y) (cross ca ab)) M) as (_ & _ & _ & _ & off).
    { apply (approx_vec_product 5.665 7 2 _ _ N 5.665 7 2 _ _ V M); try assumption; try lra; try lia; [cbn [Nat.add]; lra | apply approx_V]. }
    replace (- M - - dot (cross x y) (cross ca ab)) with (- (M - dot (cross x y) (cross ca ab))) by ring. rewrite Rabs_Ropp.
    eapply Rle_trans; [exact off |]. pose proof T4_from_below. rewrite S_square in long.
    assert (norm x * norm y * w <= 1.21 * S * (E / 2)) as bound by (apply Rmult_le_compat; lra).
    apply (Rmult_le_compat_l u) in bound; [| lra]. assert (0 <= u * (S * E)) by (repeat apply Rmult_le_pos; unfold E; lra).
    pose proof kappa_range. assert (0 <= kappa * s ^ 4) by (apply Rmult_le_pos; [lra | apply power_nonneg]). lra.
  Qed.

  (* Degree 6. *)
  Lemma plane_6 D lhs vv M : computed_dot A V D -> rounds (D * D) lhs -> computed_dot V V vv -> computed_minus_product lhs rr vv M ->
    let v := cross ca ab in
    Rabs (M - (dot a v * dot a v - r * r * dot v v)) <= T6.
  Proof.
    intros HD Hl Hv HM v. pose proof S_nonneg. pose proof parts_nonneg. pose proof (power_nonneg 2) as p2. pose proof w_range as (w0 & w1).
    pose proof (norm_nonneg a) as a0. assert (norm a <= 1 * s ^ 1) as a1 by (apply norm_root; [lra | unfold S; lra]).
    pose proof (power_nonneg 1) as p1. pose proof (power_nonneg 3) as p3. pose proof (power_nonneg 6) as p6. pose proof (power_nonneg 4) as p4.
    assert (s ^ 3 = s ^ 1 * s ^ 2) as s3 by ring. assert (s ^ 4 = s ^ 2 * s ^ 2) as s4 by ring. assert (s ^ 6 = s ^ 3 * s ^ 3) as s6 by ring.
    pose proof (leaf_approx a A leaf_a ltac:(lra)) as near_a.
    assert (norm a * w <= 1 * s ^ 1 * (1.5 * s ^ 2)) as aw by (apply Rmult_le_compat; lra).
    assert (0 <= norm a * w) as aw0 by (apply Rmult_le_pos; lra).
    assert (approx (1 + 5.665 + 3.005) (4 * (0 + 7) + 8) 3 (norm a * w) (dot a v) D) as near_D.
    { apply (approx_vec_product 1 0 1 _ _ A 5.665 7 2 _ _ V D); try assumption; try lra; try lia; [cbn [Nat.add]; lra | apply approx_V]. }
    destruct (approx_product _ _ 3 _ _ _ _ _ 3 _ _ _ ltac:(lia) near_D near_D) as [size off]. cbn [Nat.add] in off.
    assert (norm a * w * (norm a * w) <= 1.5 * s ^ 3 * (1.5 * s ^ 3)) as awaw by (apply Rmult_le_compat; lra).
    assert (0 <= norm a * w * (norm a * w)) by (apply Rmult_le_pos; assumption).
    assert (approx (1 + 5.665 + 3.005 + (1 + 5.665 + 3.005) + 0.001 + 1.001) (4 * (4 * (0 + 7) + 8 + (4 * (0 + 7) + 8)) + 1 + 2) 6
      (norm a * w * (norm a * w)) (dot a v * dot a v) lhs) as near_l
      by (apply approx_rounded with (Y := D * D); try assumption; try lia; lra).
    assert (w * w <= 1.5 * s ^ 2 * (1.5 * s ^ 2)) as ww by (apply Rmult_le_compat; lra). assert (0 <= w * w) as ww0 by (apply Rmult_le_pos; lra).
    assert (approx (5.665 + 5.665 + 3.005) (4 * (7 + 7) + 8) 4 (w * w) (dot v v) vv) as near_v.
    { apply (approx_vec_product 5.665 7 2 _ _ V 5.665 7 2 _ _ V vv); try assumption; try lra; try lia; [cbn [Nat.add]; lra | apply approx_V ..]. }
    assert (r * r * (w * w) <= 4 * s ^ 6) as rw.
    { apply Rle_trans with (s ^ 2 * (2.25 * (s ^ 2 * s ^ 2))); [apply Rmult_le_compat; try lra; rewrite S_square; unfold S; lra |].
      replace (s ^ 6) with (s ^ 2 * (s ^ 2 * s ^ 2)) in * by ring. lra. }
    pose proof (minus_product_within _ _ 6 _ _ _ 1.001 2 2 _ _ _ (5.665 + 5.665 + 3.005) (4 * (7 + 7) + 8) 4 _ _ _ _ eq_refl ltac:(lia) ltac:(lra) ltac:(lra) rw near_l approx_rr near_v HM) as total.
    eapply Rle_trans; [exact total |]. pose proof T6_from_below.
    replace (norm a * w * (norm a * w)) with (norm a * norm a * (w * w)) by ring. rewrite norm_square.
    assert (w * w <= E / 2 * (E / 2)) as we by (apply Rmult_le_compat; lra).
    assert ((dot a a + r * r) * (w * w) <= S * (E / 2 * (E / 2))) as bound by (apply Rmult_le_compat; unfold S in *; lra).
    apply (Rmult_le_compat_l u) in bound; [| lra].
    assert (0 <= u * (r * r * (w * w))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]).
    assert (0 <= u * (S * (E * E))) by (repeat apply Rmult_le_pos; unfold E; lra).
    pose proof kappa_range. assert (0 <= kappa * s ^ 6) by (apply Rmult_le_pos; lra). lra.
  Qed.
End Coarse.
