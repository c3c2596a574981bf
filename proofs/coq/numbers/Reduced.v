(* The edge axes at degree 4 have the signs of the published pair, on every input: Q.Q = e |N|^2, Q.QC = -e (N.V). *)
From Coq Require Import Reals Lra Psatz.
From Axiscert Require Import Vectors Sat7 Sound Complete Exact.
Open Scope R_scope.

Lemma published_is_e_times_reduced A B C rr :
  fst (edge_radius_sides A B rr) = length2 A B * fst (reduced_radius_sides A B rr) /\
  snd (edge_radius_sides A B rr) = length2 A B * snd (reduced_radius_sides A B rr) /\
  fst (edge_side_sides A B C) = length2 A B * snd (reduced_side_sides A B C) * (-1).
Proof.
  unfold edge_radius_sides, reduced_radius_sides, edge_side_sides, reduced_side_sides; cbn [fst snd].
  repeat split; unfold from_foot, foot, length2, normal; vec_ring.
Qed.

(* A = B: both sides of both forms are zero. *)
Lemma reduced_zero_length A B C rr : length2 A B = 0 ->
  fst (reduced_radius_sides A B rr) = 0 /\ snd (reduced_radius_sides A B rr) = 0 /\ snd (reduced_side_sides A B C) = 0.
Proof.
  intros zero.
  assert (cross A B = Vec 0 0 0) as same.
  { destruct A as [a1 a2 a3], B as [b1 b2 b3]. unfold length2, dot, sub, cross in *; cbn [cx cy cz] in *.
    pose proof (Rle_0_sqr (b1 - a1)). pose proof (Rle_0_sqr (b2 - a2)). pose proof (Rle_0_sqr (b3 - a3)).
    unfold Rsqr in *.
    assert (equal : forall x y, (y - x) * (y - x) = 0 -> y = x) by (intros x y H'; apply Rmult_integral in H'; lra).
    rewrite (equal a1 b1), (equal a2 b2), (equal a3 b3) by lra. f_equal; ring. }
  unfold reduced_radius_sides, reduced_side_sides; cbn [fst snd]. rewrite zero, same.
  unfold dot; cbn [cx cy cz]. repeat split; ring.
Qed.

(* The sign of lhs - rhs is the same: greater, equal and less. *)
Definition same_sign (a b : R * R) :=
  (fst a > snd a <-> fst b > snd b) /\ (fst a >= snd a <-> fst b >= snd b) /\ (fst a = snd a <-> fst b = snd b).

Lemma scaled_same_sign e l r l' r' : 0 <= e -> l = e * l' -> r = e * r' -> (e = 0 -> l' = 0 /\ r' = 0) ->
  same_sign (l, r) (l', r').
Proof.
  intros e0 -> -> zero. unfold same_sign; cbn [fst snd].
  destruct (Rle_lt_or_eq_dec 0 e e0) as [positive | <-].
  - repeat split; intros H; try nra; apply Rmult_eq_reg_l with e; lra.
  - destruct (zero eq_refl) as [-> ->]. repeat split; intros; lra.
Qed.

Theorem reduced_equiv A B C rr K : same_sign (published A B C rr K) (reduced A B C rr K).
Proof.
  assert (radius : forall A B rr, same_sign (edge_radius_sides A B rr) (reduced_radius_sides A B rr)).
  { intros X Y s. pose proof (published_is_e_times_reduced X Y X s) as (l & r & _).
    rewrite (surjective_pairing (edge_radius_sides X Y s)), (surjective_pairing (reduced_radius_sides X Y s)).
    apply (scaled_same_sign (length2 X Y)); try assumption; [apply length2_nonneg |].
    intros zero. pose proof (reduced_zero_length X Y X s zero). tauto. }
  assert (side : forall A B C, same_sign (edge_side_sides A B C) (reduced_side_sides A B C)).
  { intros X Y Z. pose proof (published_is_e_times_reduced X Y Z 0) as (_ & _ & l).
    unfold edge_side_sides, reduced_side_sides in *; cbn [fst snd] in *.
    pose proof (length2_nonneg X Y) as e0.
    pose proof (reduced_zero_length X Y Z 0) as zero. unfold reduced_side_sides in zero; cbn [fst snd] in zero.
    assert (same_sign (dot (foot X Y) (from_foot X Y Z), 0) (- dot (cross X Y) (normal X Y Z), 0)) as H.
    { apply (scaled_same_sign (length2 X Y)); try lra. }
    unfold same_sign in *; cbn [fst snd] in *.
    destruct H as (g & ge & eq).
    split; [| split]; split; intros h;
      first [apply g in h | apply ge in h | apply eq in h | apply g | apply ge | apply eq]; lra. }
  destruct K; cbn; first [apply radius | apply side | unfold same_sign; tauto].
Qed.

(* So the reduced test, with >= in its side comparisons, is exact as well. *)
Lemma reduced_nonstrict A B C rr K : nonstrict K (published A B C rr K) <-> nonstrict K (reduced A B C rr K).
Proof. pose proof (reduced_equiv A B C rr K) as (g & ge & _). unfold nonstrict. destruct (is_side K); tauto. Qed.

Theorem reduced_exact A B C P r : 0 <= r ->
  (some_axis (fun K => nonstrict K (reduced (sub A P) (sub B P) (sub C P) (r * r) K)) <-> separated A B C P r).
Proof.
  intros r0. rewrite <- sat7_exact by assumption. split; apply some_axis_mono; intros K; apply reduced_nonstrict.
Qed.
