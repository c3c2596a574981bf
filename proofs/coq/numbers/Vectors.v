(* Vectors of three reals, and the names of the test: the sixteen comparisons, the seven axes that they form, and the
   user's question, whether the sphere and the triangle have a point in common. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

Record vec := Vec { cx : R; cy : R; cz : R }.

Definition add (u v : vec) := Vec (cx u + cx v) (cy u + cy v) (cz u + cz v).
Definition sub (u v : vec) := Vec (cx u - cx v) (cy u - cy v) (cz u - cz v).
Definition scale (u : vec) (k : R) := Vec (cx u * k) (cy u * k) (cz u * k).
Definition dot (u v : vec) := cx u * cx v + cy u * cy v + cz u * cz v.
Definition cross (u v : vec) :=
  Vec (cy u * cz v - cz u * cy v) (cz u * cx v - cx u * cz v) (cx u * cy v - cy u * cx v).
Definition distance (u v : vec) := sqrt (dot (sub u v) (sub u v)).

(* Proves an equation between polynomials in the coordinates. *)
Ltac vec_ring :=
  intros; repeat match goal with u : vec |- _ => destruct u end;
  unfold add, sub, scale, dot, cross; cbn [cx cy cz];
  match goal with |- @eq vec _ _ => f_equal | _ => idtac end; ring.

Lemma dot_self_nonneg u : 0 <= dot u u.
Proof. destruct u as [x y z]; unfold dot; cbn [cx cy cz]. pose proof (Rle_0_sqr x); pose proof (Rle_0_sqr y).
  pose proof (Rle_0_sqr z). unfold Rsqr in *. lra. Qed.

Lemma lagrange u v : dot u u * dot v v - dot u v * dot u v = dot (cross u v) (cross u v).
Proof. vec_ring. Qed.

Lemma cauchy_schwarz u v : dot u v * dot u v <= dot u u * dot v v.
Proof. pose proof (lagrange u v); pose proof (dot_self_nonneg (cross u v)); lra. Qed.

(* The point with barycentric coordinates u, v, w. *)
Definition combination (u v w : R) (A B C : vec) := add (add (scale A u) (scale B v)) (scale C w).
Definition in_triangle (X A B C : vec) :=
  exists u v w, 0 <= u /\ 0 <= v /\ 0 <= w /\ u + v + w = 1 /\ X = combination u v w A B C.

(* The user's question: every point of the closed triangle is farther from P than r. *)
Definition separated (A B C P : vec) (r : R) := forall X, in_triangle X A B C -> r < distance P X.

(* The same with P at the origin and the radius squared. *)
Definition clear (A B C : vec) (rr : R) :=
  forall u v w, 0 <= u -> 0 <= v -> 0 <= w -> u + v + w = 1 ->
  rr < dot (combination u v w A B C) (combination u v w A B C).

Lemma separated_iff_clear A B C P r : 0 <= r ->
  (separated A B C P r <-> clear (sub A P) (sub B P) (sub C P) (r * r)).
Proof.
  intros r_nonneg.
  assert (moved : forall u v w, u + v + w = 1 ->
    dot (sub P (combination u v w A B C)) (sub P (combination u v w A B C)) =
    dot (combination u v w (sub A P) (sub B P) (sub C P)) (combination u v w (sub A P) (sub B P) (sub C P))).
  { intros u v w sum. replace w with (1 - u - v) by lra. unfold combination. vec_ring. }
  split.
  - intros far u v w u0 v0 w0 sum.
    specialize (far (combination u v w A B C)). unfold distance in far. rewrite moved in far by assumption.
    pose proof (dot_self_nonneg (combination u v w (sub A P) (sub B P) (sub C P))) as square.
    rewrite <- (sqrt_sqrt _ square). apply Rmult_le_0_lt_compat; try assumption.
    all: apply far; exists u, v, w; auto.
  - intros far X (u & v & w & u0 & v0 & w0 & sum & ->). unfold distance. rewrite moved by assumption.
    rewrite <- (sqrt_square r) by assumption. apply sqrt_lt_1.
    + apply Rmult_le_pos; assumption.
    + apply dot_self_nonneg.
    + apply far; assumption.
Qed.

(* The comparisons in the order of the kernels' bits. *)
Inductive comparison :=
  | plane_radius
  | vertex_a_radius | vertex_a_side_b | vertex_a_side_c
  | vertex_b_radius | vertex_b_side_a | vertex_b_side_c
  | vertex_c_radius | vertex_c_side_a | vertex_c_side_b
  | edge_ab_radius | edge_ab_side_c
  | edge_bc_radius | edge_bc_side_a
  | edge_ca_radius | edge_ca_side_b.

Definition is_side (K : comparison) : bool :=
  match K with
  | plane_radius | vertex_a_radius | vertex_b_radius | vertex_c_radius
  | edge_ab_radius | edge_bc_radius | edge_ca_radius => false
  | _ => true
  end.

(* Some axis separates: all of its comparisons hold. *)
Definition some_axis (holds : comparison -> Prop) : Prop :=
  holds plane_radius \/
  (holds vertex_a_radius /\ holds vertex_a_side_b /\ holds vertex_a_side_c) \/
  (holds vertex_b_radius /\ holds vertex_b_side_a /\ holds vertex_b_side_c) \/
  (holds vertex_c_radius /\ holds vertex_c_side_a /\ holds vertex_c_side_b) \/
  (holds edge_ab_radius /\ holds edge_ab_side_c) \/
  (holds edge_bc_radius /\ holds edge_bc_side_a) \/
  (holds edge_ca_radius /\ holds edge_ca_side_b).

Lemma some_axis_mono (H H' : comparison -> Prop) : (forall K, H K -> H' K) -> some_axis H -> some_axis H'.
Proof. intros imp. unfold some_axis. intuition auto. Qed.
