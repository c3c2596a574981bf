(* A query times a positive number has the answers of the query: the certified predicate scales queries of extreme size by a
   power of two where that is exact (kernel/sphere_triangle/certified/block-inl.h), and takes the numbers as integers in units
   of a power of two in its last step. *)
From Coq Require Import Reals Lra.
From Axiscert Require Import Vectors OpenSphere Known.
Open Scope R_scope.

Lemma scaled_distance P X k : 0 <= k -> distance (scale P k) (scale X k) = distance P X * k.
Proof.
  intros k0. unfold distance.
  replace (dot (sub (scale P k) (scale X k)) (sub (scale P k) (scale X k))) with (dot (sub P X) (sub P X) * (k * k)) by vec_ring.
  rewrite sqrt_mult, sqrt_square; auto using dot_self_nonneg. apply Rmult_le_pos; assumption.
Qed.
Lemma scaled_triangle X A B C k : in_triangle X A B C -> in_triangle (scale X k) (scale A k) (scale B k) (scale C k).
Proof.
  intros (u & v & w & u0 & v0 & w0 & sum & ->). exists u, v, w. repeat split; try assumption. unfold combination. vec_ring.
Qed.
Lemma scaled_back v k : 0 < k -> scale (scale v k) (/ k) = v.
Proof. intros k0. destruct v as [x y z]. unfold scale. cbn [cx cy cz]. f_equal; field; lra. Qed.

Lemma scaled_apart q A B C P r k : 0 < k -> apart q A B C P r ->
  apart q (scale A k) (scale B k) (scale C k) (scale P k) (r * k).
Proof.
  intros k0 far. assert (each : forall X, in_triangle X (scale A k) (scale B k) (scale C k) -> exists Y, in_triangle Y A B C /\
    distance (scale P k) X = distance P Y * k).
  { intros X inside. exists (scale X (/ k)). split.
    - apply (scaled_triangle X _ _ _ (/ k)) in inside. rewrite !scaled_back in inside by assumption. exact inside.
    - rewrite <- scaled_distance by lra. f_equal. rewrite <- (scaled_back X (/ k)) at 1 by (apply Rinv_0_lt_compat; assumption).
      rewrite Rinv_inv. reflexivity. }
  destruct q; intros X inside; destruct (each X inside) as (Y & inside' & ->); specialize (far Y inside').
  - apply Rmult_lt_compat_r; assumption.
  - apply Rmult_le_compat_r; [lra | assumption].
Qed.
Theorem scaled_is_same q A B C P r k : 0 < k ->
  (apart q (scale A k) (scale B k) (scale C k) (scale P k) (r * k) <-> apart q A B C P r).
Proof.
  intros k0. split; [| apply scaled_apart; assumption]. intros far.
  apply (scaled_apart q _ _ _ _ _ (/ k)) in far; [| apply Rinv_0_lt_compat; assumption].
  rewrite !scaled_back in far by assumption. replace (r * k * / k) with r in far by (field; lra). exact far.
Qed.
