(* The point of an edge that is nearest to the origin: what it implies for the triangle's vertices, and how near to it
   the point is that the conservative test computes. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Complete Lanes Certified Conservative.
Open Scope R_scope.

Definition clamp (x : R) := Rmin (Rmax x 0) 1.
Lemma clamp_range x : 0 <= clamp x <= 1.
Proof. unfold clamp, Rmin, Rmax. repeat destruct Rle_dec; lra. Qed.
Lemma clamp_cases x : (clamp x = 0 /\ x <= 0) \/ (clamp x = 1 /\ 1 <= x) \/ clamp x = x.
Proof. unfold clamp, Rmin, Rmax. repeat destruct Rle_dec; lra. Qed.
(* A relative error matters at most as much as at 1. *)
Lemma clamp_near x a k e : 0 <= k <= 1 -> 0 <= e -> Rabs (x - a) <= k * Rabs a + e -> Rabs (clamp x - clamp a) <= k + e.
Proof.
  intros k0 e0 H. apply Rabs_le_inv in H. destruct (Rle_lt_dec a 0) as [a0 | a0];
    [rewrite Rabs_left1 in H by assumption | rewrite Rabs_pos_eq in H by lra].
  - assert (k * a <= 0) by nra. assert (a <= k * a) by nra. apply Rabs_le. unfold clamp, Rmin, Rmax. repeat destruct Rle_dec; lra.
  - destruct (Rle_lt_dec a 1) as [a1 | a1].
    + assert (k * a <= k) by nra. apply Rabs_le. unfold clamp, Rmin, Rmax. repeat destruct Rle_dec; lra.
    + assert ((a - 1) * (1 - k) >= 0) by nra. apply Rabs_le. unfold clamp, Rmin, Rmax. repeat destruct Rle_dec; lra.
Qed.

Definition best (X Y : vec) := if Rlt_dec 0 (dot (sub Y X) (sub Y X)) then clamp (- dot X (sub Y X) / dot (sub Y X) (sub Y X)) else 0.
Definition star (X Y : vec) := between X Y (best X Y).
Lemma best_range X Y : 0 <= best X Y <= 1.
Proof. unfold best. destruct Rlt_dec; [apply clamp_range | lra]. Qed.

Lemma dot_star X Y c Z : dot (between X Y c) Z = dot X Z + c * dot (sub Y X) Z. Proof. unfold between. vec_ring. Qed.
Lemma dot_along X Y c : dot (between X Y c) (sub Y X) = dot X (sub Y X) + c * dot (sub Y X) (sub Y X). Proof. unfold between. vec_ring. Qed.
Lemma star_first X Y c : dot (between X Y c) X = dot (between X Y c) (between X Y c) - c * dot (between X Y c) (sub Y X). Proof.
unfold between. vec_ring. Qed.
Lemma star_second X Y c : dot (between X Y c) Y = dot (between X Y c) (between X Y c) + (1 - c) * dot (between X Y c) (sub Y X).
Proof. unfold between. vec_ring. Qed.
Lemma same_points X Y Z : dot (sub Y X) (sub Y X) <= 0 -> dot Z (sub Y X) = 0.
Proof.
  intros zero. pose proof (cauchy_schwarz Z (sub Y X)) as H. pose proof (dot_self_nonneg (sub Y X)).
  replace (dot (sub Y X) (sub Y X)) with 0 in H by lra. nra.
Qed.
Lemma best_cases X Y : let e := dot (sub Y X) (sub Y X) in let f := dot (star X Y) (sub Y X) in
  (best X Y = 0 /\ 0 <= f) \/ (best X Y = 1 /\ f <= 0) \/ f = 0.
Proof.
  cbv zeta. unfold star. rewrite dot_along. unfold best. set (e := dot (sub Y X) (sub Y X)) in *. destruct Rlt_dec as [e0 | e0].
  - set (h := dot X (sub Y X)). set (x := - h / e). assert (x * e = - h) as back by (unfold x; field; lra).
    destruct (clamp_cases x) as [(-> & x0) | [(-> & x1) | ->]].
    + left. split; [reflexivity |]. assert (x * e <= 0 * e) by (apply Rmult_le_compat_r; lra). lra.
    + right; left. split; [reflexivity |]. assert (1 * e <= x * e) by (apply Rmult_le_compat_r; lra). lra.
    + right; right. lra.
  - right; right. rewrite (same_points X Y X) by (fold e; lra). lra.
Qed.
Lemma star_nearest X Y : dot (star X Y) (star X Y) <= dot (star X Y) X /\ dot (star X Y) (star X Y) <= dot (star X Y) Y.
Proof.
  pose proof (best_cases X Y) as cases. cbv zeta in cases. pose proof (best_range X Y). unfold star in *.
  rewrite star_first, star_second. set (f := dot _ (sub Y X)) in *. destruct cases as [(c & f0) | [(c & f0) | f0]]; nra.
Qed.

(* Along star, the third vertex is no nearer where the nearest feature is X or the edge, and not much nearer where the
   triangle is thin and XY is its longest edge. *)
Lemma star_vertex X Y Z : good_vertex X Y Z -> dot (star X Y) (star X Y) <= dot (star X Y) Z.
Proof.
  intros (sy & sz). unfold s in *. assert (dot X (sub Y X) = dot X Y - dot X X) as h by vec_ring.
  assert (best X Y = 0) as zero.
  { unfold best. destruct Rlt_dec as [e0 |]; [| reflexivity].
    assert (- dot X (sub Y X) / dot (sub Y X) (sub Y X) <= 0).
    { unfold Rdiv. rewrite Ropp_mult_distr_l_reverse. assert (0 < / dot (sub Y X) (sub Y X)) by (apply Rinv_0_lt_compat; assumption).
      assert (0 < dot X (sub Y X)) by lra. nra. }
    unfold clamp, Rmin, Rmax. repeat destruct Rle_dec; lra. }
  assert (star X Y = X) as same. { unfold star. rewrite zero. unfold between. clear. destruct X, Y. unfold add, scale. cbn. f_equal; ring. }
  rewrite same. lra.
Qed.
Lemma star_edge X Y Z : good_edge X Y Z -> dot (star X Y) (star X Y) <= dot (star X Y) Z.
Proof.
  intros (sx & sy & outside). pose proof (s_sum X Y) as sum. unfold lam, length2 in *.
  assert (s X Y = dot X (sub Y X)) as h by (unfold s; vec_ring).
  set (e := dot (sub Y X) (sub Y X)) in *. assert (0 <= e) as e0 by apply dot_self_nonneg.
  assert (0 < e) as e1.
  { destruct (Rlt_le_dec 0 e) as [| zero]; [assumption |]. pose proof (same_points X Y X zero) as none.
    assert (e = 0) as e2 by lra. rewrite h, none, e2 in outside. lra. }
  assert (best X Y = - s X Y / e) as c.
  { unfold best. fold e. destruct Rlt_dec; [| lra]. rewrite <- h.
    assert (0 <= - s X Y / e) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; assumption]).
    assert (- s X Y / e <= 1) by (apply Rmult_le_reg_r with e; [assumption |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra).
    unfold clamp, Rmin, Rmax. repeat destruct Rle_dec; lra. }
  assert (dot (star X Y) (sub Y X) = 0) as f0.
  { unfold star. rewrite dot_along. fold e. rewrite c, h. field. lra. }
  pose proof (star_first X Y (best X Y)) as first. fold (star X Y) in first. rewrite f0 in first.
  assert (dot (star X Y) Z - dot (star X Y) X = s X Z + best X Y * g X Y Z) as change by (unfold star, between, s, g; vec_ring).
  assert (e * (s X Z + best X Y * g X Y Z) = - (s X Y * g X Y Z - e * s X Z)) as scaled by (rewrite c; field; lra).
  assert (0 <= s X Z + best X Y * g X Y Z) by (apply Rmult_le_reg_l with e; lra). lra.
Qed.
Lemma split_along X Y Z q : dot (star X Y) Z =
  (1 - q) * dot (star X Y) X + q * dot (star X Y) Y + dot (star X Y) (sub (sub Z X) (scale (sub Y X) q)).
Proof. unfold star. generalize (best X Y). unfold between. vec_ring. Qed.
Lemma rest_square X Y Z p : let rest := sub (sub Z X) (scale (sub Y X) p) in
  dot rest rest = length2 X Z - 2 * p * g X Y Z + p * p * length2 X Y.
Proof. cbv zeta. unfold length2, g. vec_ring. Qed.
Lemma star_thin X Y Z t : 0 < t -> length2 X Z <= length2 X Y -> length2 Y Z <= length2 X Y ->
  dot (normal X Y Z) (normal X Y Z) <= 9 * (t * t) * length2 X Y ->
    dot (star X Y) (star X Y) - 3 * (norm (star X Y) * t) <= dot (star X Y) Z.
Proof.
  intros t0 xz yz thin. destruct (star_nearest X Y) as [sX sY]. rewrite normal_square in thin.
  assert (length2 Y Z = length2 X Y + length2 X Z - 2 * g X Y Z) as law by (unfold length2, g; vec_ring).
  pose proof (length2_nonneg X Z) as l1. pose proof (length2_nonneg Y Z) as l2. pose proof (norm_nonneg (star X Y)) as N0.
  set (e := length2 X Y) in *. set (q := g X Y Z) in *. assert (0 <= norm (star X Y) * t) by (apply Rmult_le_pos; lra).
  destruct (Rle_lt_dec e 0) as [zero | e0].
  - pose proof (same_points X Z (star X Y) ltac:(fold (length2 X Z); lra)) as same.
    assert (dot (star X Y) Z = dot (star X Y) X + dot (star X Y) (sub Z X)) as split_up by (generalize (star X Y); vec_ring). lra.
  - set (p := q / e). assert (p * e = q) as pe by (unfold p; field; lra).
    assert (0 <= p <= 1) as p01.
    { split; apply Rmult_le_reg_r with e; lra. }
    rewrite (split_along X Y Z p). set (rest := sub (sub Z X) (scale (sub Y X) p)).
    assert (dot rest rest = length2 X Z - 2 * p * q + p * p * e) as square by apply rest_square.
    assert (norm rest <= 3 * t) as short.
    { apply norm_at_most; [lra |]. rewrite square. apply Rmult_le_reg_r with e; [assumption |].
      replace ((length2 X Z - 2 * p * q + p * p * e) * e) with (e * length2 X Z - 2 * (p * e) * q + (p * e) * (p * e)) by ring. rewrite pe.
      lra. }
    pose proof (dot_norm (star X Y) rest) as part. apply Rabs_le_inv in part.
    assert (norm (star X Y) * norm rest <= norm (star X Y) * (3 * t)) by (apply Rmult_le_compat_l; assumption).
    assert ((1 - p) * dot (star X Y) (star X Y) <= (1 - p) * dot (star X Y) X) by (apply Rmult_le_compat_l; lra).
    assert (p * dot (star X Y) (star X Y) <= p * dot (star X Y) Y) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* The point as computed. *)
Section Computed.
  Variables u eta w : R.
  Hypothesis u_range : 0 < u <= / 1048576.
  Hypothesis eta_nonneg : 0 <= eta.
  Hypothesis w0 : 0 < w.
  Hypothesis underflow_1 : eta <= / 1000000 * u.
  Hypothesis underflow_5 : eta <= / 1000000 * (u * (u * w) * (u * w)).
  Let u_weak : 0 <= u <= / 1048576. Proof using u_range. lra. Qed.
  Local Notation small := (small u u_weak).

  Lemma share_near X Y along e d at_ : norm X <= 1.00001 * w -> norm Y <= 1.00001 * w -> leaf_of u (sub Y X) along ->
    computed_dot u eta along along e -> computed_dot u eta X along d -> (0 < e -> rounds u eta (- d / e) at_) -> (e <= 0 -> at_ = 0) ->
    norm (sub (between X Y (clamp at_)) (star X Y)) <= 30 * (u * w).
  Proof using All.
    intros sX sY leaf He Hd Hat Hzero. set (a := sub Y X) in *. set (l := norm a).
    pose proof (norm_nonneg a) as l0. fold l in l0. assert (l * l = dot a a) as ll by apply norm_square.
    assert (l <= 2.0001 * w) as lsize.
    { unfold l, a. pose proof (norm_triangle Y (scale X (-1))) as tri. rewrite norm_opposite in tri.
      replace (add Y (scale X (-1))) with (sub Y X) in tri by (clear; destruct X, Y; unfold add, sub, scale; cbn; f_equal; ring). lra. }
    pose proof (small w ltac:(lra)) as uw. assert (0 < u * w) as uw0 by (apply Rmult_lt_0_compat; lra).
    assert (between X Y (clamp at_) = add (star X Y) (scale a (clamp at_ - best X Y))) as moved.
    { unfold star, between, a. generalize (clamp at_), (best X Y). clear. intros. destruct X, Y; unfold add, sub, scale; cbn; f_equal;
      ring. }
    assert (norm (sub (between X Y (clamp at_)) (star X Y)) = Rabs (clamp at_ - best X Y) * l) as size.
    { rewrite moved. set (k := clamp at_ - best X Y). replace (sub (add (star X Y) (scale a k)) (star X Y)) with (scale a k)
        by (generalize (star X Y); clear; intros; destruct a; unfold add, sub, scale; cbn; f_equal; ring).
      unfold norm at 1. replace (dot (scale a k) (scale a k)) with (k * k * (l * l)) by (rewrite ll; generalize k; clear; intros;
        destruct a; unfold dot, scale; cbn; ring).
      rewrite <- (Rabs_pos_eq (l * l)) by (apply Rmult_le_pos; assumption).
      replace (k * k * Rabs (l * l)) with ((Rabs k * l) * (Rabs k * l)).
      - apply sqrt_square. apply Rmult_le_pos; [apply Rabs_pos | assumption].
      - rewrite (Rabs_pos_eq (l * l)) by (apply Rmult_le_pos; assumption).
        replace (Rabs k * l * (Rabs k * l)) with (Rabs k * Rabs k * (l * l)) by ring.
        rewrite <- Rabs_mult, (Rabs_pos_eq (k * k)) by apply Rle_0_sqr. ring. }
    rewrite size. destruct (Rle_lt_dec l (20 * (u * w))) as [short | long].
    { pose proof (clamp_range at_). pose proof (best_range X Y). assert (Rabs (clamp at_ - best X Y) <= 1) by (apply Rabs_le; lra).
      apply Rle_trans with (1 * l); [apply Rmult_le_compat_r; assumption | lra]. }
    (* Bounds of e, l^2 and d. *)
    assert (0 < l) as l1 by lra. assert (0 < l * l) as ll0 by (apply Rmult_lt_0_compat; assumption).
    assert (400 * (u * w * (u * w)) <= l * l) as ee.
    { replace (400 * (u * w * (u * w))) with (20 * (u * w) * (20 * (u * w))) by ring. apply Rmult_le_compat; lra. }
    assert (eta <= / 1000000 * (u * (l * l))) as tiny_e.
    { eapply Rle_trans; [exact underflow_5 |]. replace (u * (u * w) * (u * w)) with (u * (u * w * (u * w))) by ring.
      assert (0 <= u * w * (u * w)) by (apply Rmult_le_pos; lra).
      assert (u * (u * w * (u * w)) <= u * (l * l)) by (apply Rmult_le_compat_l; lra). lra. }
    assert (0 <= u * w * l) as uwl by (apply Rmult_le_pos; lra).
    assert (eta <= / 1000000 * (u * w * l)) as tiny_d.
    { eapply Rle_trans; [exact underflow_5 |]. assert (u * w <= l) by lra. pose proof (small (u * w) ltac:(lra)).
      assert (u * (u * w) * (u * w) <= u * w * l) by (apply Rmult_le_compat; lra). lra. }
    pose proof (leaf_norm u a along u_weak leaf) as loff. fold l in loff.
    pose proof (small l ltac:(lra)) as ul.
    assert (norm along <= 1.000001 * l) as alen.
    { pose proof (norm_triangle a (sub along a)) as tri. rewrite add_difference in tri. fold l in tri. lra. }
    assert (Rabs (e - l * l) <= 5.1 * (u * (l * l))) as oe.
    { apply dot_error in He; [| exact u_weak | assumption]. rewrite sizes_square in He.
      assert (l - u * l <= norm along) as alow.
      { pose proof (norm_triangle along (sub a along)) as tri. rewrite add_difference, norm_turned in tri. fold l in tri. lra. }
      assert (dot along along <= (l + u * l) * (l + u * l)) as up.
      { rewrite <- norm_square. apply Rmult_le_compat; try apply norm_nonneg; pose proof (norm_triangle a (sub along a)) as tri;
        rewrite add_difference in tri; fold l in tri; lra. }
      assert ((l - u * l) * (l - u * l) <= dot along along) as down by (rewrite <- norm_square; apply Rmult_le_compat; lra).
      pose proof (small (l * l) ltac:(lra)). pose proof (smaller u u_weak (l * l) ltac:(lra)).
      assert (u * dot along along <= u * ((l + u * l) * (l + u * l))) by (apply Rmult_le_compat_l; lra).
      assert (0 <= u * (u * u * (l * l)) <= u * u * (l * l) / 1048576) by (apply small; lra).
      apply Rabs_le_inv in He. apply Rabs_le. lra. }
    assert (Rabs (d - dot X a) <= 4.02 * (u * w * l)) as od.
    { apply dot_error in Hd; [| exact u_weak | assumption]. pose proof (sizes_norm X along) as sn.
      assert (norm X * norm along <= 1.00001 * w * (1.000001 * l)) as big by (apply Rmult_le_compat; try apply norm_nonneg; assumption).
      assert (u * sizes X along <= u * (1.00001 * w * (1.000001 * l))) by (apply Rmult_le_compat_l; lra).
      pose proof (dot_norm X (sub along a)) as change.
      assert (norm X * norm (sub along a) <= 1.00001 * w * (u * l)) by (apply Rmult_le_compat; try apply norm_nonneg; assumption).
      replace (d - dot X a) with ((d - dot X along) + dot X (sub along a)) by (rewrite (dot_moved X a along); ring).
      eapply Rle_trans; [apply Rabs_triang |]. lra. }
    pose proof (small (l * l) ltac:(lra)) as ull. apply Rabs_le_inv in oe. assert (0 < e) as e0 by lra. specialize (Hat e0).
    unfold best. fold a. rewrite <- ll. destruct Rlt_dec as [_ |]; [| lra].
    (* The error of `at` compared with g / l^2. *)
    set (x := - dot X a / (l * l)). set (z := u * w / l). assert (0 < z) as z0 by (apply Rmult_lt_0_compat;
      [assumption | apply Rinv_0_lt_compat; assumption]).
    assert (z * l = u * w) as zl by (unfold z; field; lra).
    assert (u <= 2.0001 * z) as uz.
    { apply Rmult_le_reg_r with l; [assumption |]. replace (2.0001 * z * l) with (2.0001 * (z * l)) by ring. rewrite zl.
      assert (u * l <= u * (2.0001 * w)) by (apply Rmult_le_compat_l; lra). lra. }
    set (k := l * l / e). assert (k * e = l * l) as ke by (unfold k; field; lra).
    assert (Rabs (k - 1) <= 5.2 * u) as k1.
    { apply Rabs_le. assert (0 <= u * (u * (l * l)) <= u * (l * l) / 1048576) by (apply small; lra). split; apply Rmult_le_reg_r with e;
      try assumption.
      - replace ((k - 1) * e) with (k * e - e) by ring. rewrite ke.
      assert (u * (l * l - 5.1 * (u * (l * l))) <= u * e) by (apply Rmult_le_compat_l; lra). lra.
      - replace ((k - 1) * e) with (k * e - e) by ring. rewrite ke.
      assert (u * (l * l - 5.1 * (u * (l * l))) <= u * e) by (apply Rmult_le_compat_l; lra). lra. }
    set (y := (dot X a - d) / (l * l)).
    assert (Rabs y <= 4.02 * z) as yz.
    { unfold y, Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ (l * l))) by (left; apply Rinv_0_lt_compat; assumption).
      rewrite <- Rabs_Ropp. replace (- (dot X a - d)) with (d - dot X a) by ring.
      replace (4.02 * z) with (4.02 * (u * w * l) * / (l * l)) by (unfold z; field; lra).
      apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; assumption | assumption]. }
    assert (- d / e = (x + y) * k) as quotient by (unfold x, y, k; field; lra).
    unfold Lanes.rounds in Hat. rewrite quotient in Hat.
    assert (Rabs ((x + y) * k) <= 1.00001 * (Rabs x + 4.02 * z)) as qsize.
    { rewrite Rabs_mult, Rmult_comm. pose proof (Rabs_triang x y). apply Rabs_le_inv in k1.
      apply Rmult_le_compat; auto using Rabs_pos; [rewrite Rabs_pos_eq; lra | lra]. }
    apply (Rmult_le_compat_l u) in qsize; [| lra]. pose proof (small (Rabs x) (Rabs_pos x)). pose proof (small z ltac:(lra)).
    assert (Rabs (at_ - x) <= 6.3 * u * Rabs x + 4.1 * z) as close.
    { replace (at_ - x) with ((at_ - (x + y) * k) + x * (k - 1) + y * k) by ring.
      eapply Rle_trans; [apply Rabs_triang |]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang |].
      rewrite (Rabs_mult x), (Rabs_mult y).
      assert (Rabs x * Rabs (k - 1) <= Rabs x * (5.2 * u)) by (apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
      apply Rabs_le_inv in k1. assert (Rabs y * Rabs k <= 4.02 * z * 1.00001) by (apply Rmult_le_compat; auto using Rabs_pos;
        rewrite Rabs_pos_eq; lra). lra. }
    pose proof (clamp_near at_ x (6.3 * u) (4.1 * z) ltac:(lra) ltac:(lra) close) as final.
    apply Rle_trans with ((6.3 * u + 4.1 * z) * l); [apply Rmult_le_compat_r; assumption |].
    replace ((6.3 * u + 4.1 * z) * l) with (6.3 * (u * l) + 4.1 * (z * l)) by ring. rewrite zl.
    assert (u * l <= u * (2.0001 * w)) by (apply Rmult_le_compat_l; lra). lra.
  Qed.
End Computed.
