(* The expressions recorded from kernel/sphere_triangle/formulae.h and kernel/sphere_triangle/forms/reduced.h are those
   of Sat7.v: a changed formula breaks the proof. So the theorems hold for the recorded formulae. *)
From Coq Require Import Reals.
From Axiscert Require Import Vectors Sat7 Exact Reduced Recorded Sides.
Open Scope R_scope.

Ltac same_polynomials :=
  intros [[? ? ?] [? ? ?] [? ? ?] [? ? ?] ?] K; destruct K;
  cbv -[Rplus Rminus Rmult Ropp IZR]; apply f_equal2; ring.

Theorem recorded_published_is_sat7 : forall q K, recorded_published_exact q K =
  published (sub (vertex_a q) (centre q)) (sub (vertex_b q) (centre q)) (sub (vertex_c q) (centre q))
            (query_radius q * query_radius q) K.
Proof. same_polynomials. Qed.

Theorem recorded_reduced_is_sat7 : forall q K, recorded_reduced_exact q K =
  reduced (sub (vertex_a q) (centre q)) (sub (vertex_b q) (centre q)) (sub (vertex_c q) (centre q))
          (query_radius q * query_radius q) K.
Proof. same_polynomials. Qed.

(* The question of a query. *)
Definition query_separated (q : query) := separated (vertex_a q) (vertex_b q) (vertex_c q) (centre q) (query_radius q).

Theorem recorded_published_exact_right q : 0 <= query_radius q ->
  (some_axis (fun K => nonstrict K (recorded_published_exact q K)) <-> query_separated q).
Proof.
  intros r0. unfold query_separated. rewrite <- sat7_exact by assumption. unfold sat7.
  split; apply some_axis_mono; intros K; rewrite recorded_published_is_sat7; auto.
Qed.

Theorem recorded_reduced_exact_right q : 0 <= query_radius q ->
  (some_axis (fun K => nonstrict K (recorded_reduced_exact q K)) <-> query_separated q).
Proof.
  intros r0. unfold query_separated. rewrite <- reduced_exact by assumption.
  split; apply some_axis_mono; intros K; rewrite recorded_reduced_is_sat7; auto.
Qed.
