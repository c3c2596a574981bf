(* Soundness: where some axis separates, the triangle is clear of the sphere. One lemma for all axes, by Cauchy-Schwarz. *)
From Coq Require Import Reals Lra Psatz.
From Axiscert Require Import Vectors Sat7.
Open Scope R_scope.

(* The triangle lies beyond the plane n.X = m, and that plane is outside the sphere. *)
Lemma beyond_plane n m A B C rr :
  0 <= m -> m <= dot n A -> m <= dot n B -> m <= dot n C -> rr * dot n n < m * m -> clear A B C rr.
Proof.
  intros m0 mA mB mC outside u v w u0 v0 w0 sum.
  set (X := combination u v w A B C).
  assert (linear : dot n X = u * dot n A + v * dot n B + w * dot n C) by (unfold X, combination; vec_ring).
  assert (m <= dot n X).
  { rewrite linear. pose proof (Rmult_le_compat_l u _ _ u0 mA). pose proof (Rmult_le_compat_l v _ _ v0 mB).
    pose proof (Rmult_le_compat_l w _ _ w0 mC). replace m with (u * m + v * m + w * m); [lra |].
    replace u with (1 - v - w) by lra. ring. }
  assert (m * m <= dot n X * dot n X) by (apply Rmult_le_compat; assumption).
  pose proof (cauchy_schwarz n X). pose proof (dot_self_nonneg n) as nn.
  destruct (Rlt_le_dec rr (dot X X)) as [| close]; [assumption | exfalso].
  pose proof (Rmult_le_compat_l _ _ _ nn close). lra.
Qed.

Lemma plane_sound A B C rr : strict (plane_sides A B C rr) -> clear A B C rr.
Proof.
  unfold strict, plane_sides, offset; cbn [fst snd]. intros beyond.
  assert (dot (normal A B C) A = dot A (normal A B C)) by (unfold normal; vec_ring).
  assert (dot (normal A B C) B = dot A (normal A B C)) by (unfold normal; vec_ring).
  assert (dot (normal A B C) C = dot A (normal A B C)) by (unfold normal; vec_ring).
  set (N := normal A B C) in *. set (d := dot A N) in *.
  destruct (Rle_dec 0 d).
  - apply (beyond_plane N d); lra.
  - assert (flip : forall X, dot (scale N (-1)) X = - dot N X) by vec_ring.
    assert (dot (scale N (-1)) (scale N (-1)) = dot N N) as same by vec_ring.
    apply (beyond_plane (scale N (-1)) (- d)); rewrite ?flip; try lra.
    rewrite <- flip, same. lra.
Qed.

Lemma vertex_sound A B C rr : 0 <= rr ->
  dot A A > rr -> dot A B >= dot A A -> dot A C >= dot A A -> clear A B C rr.
Proof. intros. apply (beyond_plane A (dot A A)); try lra. apply Rmult_lt_compat_r; lra. Qed.

Lemma edge_sound A B C rr : 0 <= rr ->
  strict (edge_radius_sides A B rr) -> dot (foot A B) (from_foot A B C) >= 0 -> clear A B C rr.
Proof.
  unfold strict, edge_radius_sides; cbn [fst snd]. intros rr0 radius side.
  assert (QA : length2 A B * dot (foot A B) A = dot (foot A B) (foot A B)) by (unfold foot, length2; vec_ring).
  assert (QB : length2 A B * dot (foot A B) B = dot (foot A B) (foot A B)) by (unfold foot, length2; vec_ring).
  assert (QC : length2 A B * dot (foot A B) C =
               dot (foot A B) (foot A B) + dot (foot A B) (from_foot A B C)) by (unfold from_foot; vec_ring).
  set (Q := foot A B) in *. set (e := length2 A B) in *.
  assert (0 <= rr * e * e).
  { rewrite Rmult_assoc. apply Rmult_le_pos; [assumption | apply Rle_0_sqr]. }
  assert (scaled : forall X, dot (scale Q e) X = e * dot Q X) by vec_ring.
  apply (beyond_plane (scale Q e) (dot Q Q)); rewrite ?scaled; try lra.
  assert (dot Q (scale Q e) = e * dot Q Q) as -> by vec_ring.
  replace (rr * (e * (e * dot Q Q))) with (rr * e * e * dot Q Q) by ring. apply Rmult_lt_compat_r; lra.
Qed.

Lemma clear_rotate A B C rr : clear B C A rr -> clear A B C rr.
Proof.
  intros H u v w u0 v0 w0 sum. assert (v + w + u = 1) as sum' by lra. specialize (H v w u v0 w0 u0 sum').
  replace (combination u v w A B C) with (combination v w u B C A); [assumption | unfold combination; vec_ring].
Qed.

Lemma clear_swap A B C rr : clear A C B rr -> clear A B C rr.
Proof.
  intros H u v w u0 v0 w0 sum. assert (u + w + v = 1) as sum' by lra. specialize (H u w v u0 w0 v0 sum').
  replace (combination u v w A B C) with (combination u w v A C B); [assumption | unfold combination; vec_ring].
Qed.

Theorem sound A B C rr : 0 <= rr -> sat7 A B C rr -> clear A B C rr.
Proof.
  intros rr0. unfold sat7, some_axis, nonstrict; cbn.
  intros [H | [(? & ? & ?) | [(? & ? & ?) | [(? & ? & ?) | [(? & ?) | [(? & ?) | (? & ?)]]]]]].
  - apply plane_sound, H.
  - apply vertex_sound; assumption.
  - apply clear_rotate, vertex_sound; assumption.
  - apply clear_rotate, clear_rotate, vertex_sound; assumption.
  - apply edge_sound; assumption.
  - apply clear_rotate, edge_sound; assumption.
  - apply clear_rotate, clear_rotate, edge_sound; assumption.
Qed.

Lemma strict_nonstrict K sides : strict sides -> nonstrict K sides.
Proof. unfold strict, nonstrict. destruct (is_side K); lra. Qed.

Theorem sound_strict A B C rr : 0 <= rr -> sat7_strict A B C rr -> clear A B C rr.
Proof. intros rr0 H. apply sound; [assumption |]. revert H. apply some_axis_mono. intros K. apply strict_nonstrict. Qed.
