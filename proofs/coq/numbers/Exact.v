(* The main theorems over the reals, in the terms of a user: vertices A, B, C, centre P, radius r; and the triangles for
   which the strict test, as published, is wrong. *)
From Coq Require Import Reals Lra Psatz.
From Axiscert Require Import Vectors Sat7 Sound Complete.
Open Scope R_scope.

Lemma square_nonneg r : 0 <= r * r. Proof. apply Rle_0_sqr. Qed.

(* With >= in the side comparisons the test is right for every triangle, degenerate ones included, and every r >= 0. *)
Theorem sat7_exact A B C P r : 0 <= r ->
  (sat7 (sub A P) (sub B P) (sub C P) (r * r) <-> separated A B C P r).
Proof.
  intros r0. rewrite separated_iff_clear by assumption. split.
  - apply sound, square_nonneg.
  - apply complete.
Qed.

(* As published, with strict comparisons, it is right for every triangle with area. *)
Theorem sat7_exact_strict A B C P r : 0 <= r -> cross (sub B A) (sub C A) <> Vec 0 0 0 ->
  (sat7_strict (sub A P) (sub B P) (sub C P) (r * r) <-> separated A B C P r).
Proof.
  intros r0 area. rewrite separated_iff_clear by assumption. split.
  - apply sound_strict, square_nonneg.
  - apply complete_strict. unfold has_area.
    replace (normal (sub A P) (sub B P) (sub C P)) with (cross (sub B A) (sub C A)) by (unfold normal; vec_ring).
    destruct (cross (sub B A) (sub C A)) as [x y z]. unfold dot; cbn [cx cy cz].
    destruct (Rlt_le_dec 0 (x * x + y * y + z * z)) as [| zero]; [assumption | exfalso; apply area].
    f_equal; nra.
Qed.

(* Where the strict test answers `separated`, the triangle is separated, for every triangle. *)
Theorem sat7_strict_sound A B C P r : 0 <= r ->
  sat7_strict (sub A P) (sub B P) (sub C P) (r * r) -> separated A B C P r.
Proof. intros r0 H. apply separated_iff_clear; [assumption |]. revert H. apply sound_strict, square_nonneg. Qed.

Ltac is_clear :=
  intros u v w u0 v0 w0 sum; unfold combination, add, scale, dot; cbn [cx cy cz]; replace w with (1 - u - v) by lra; nra.
Ltac no_axis_separates :=
  unfold sat7_strict, some_axis, strict, published, plane_sides, vertex_radius_sides, vertex_side_sides,
    edge_radius_sides, edge_side_sides, offset, normal, from_foot, foot, length2, sub, scale, cross, dot;
  cbn [cx cy cz fst snd]; lra.

(* A repeated vertex, A = B = (2,0,0), C = (3,0,0), r = 1: a phantom contact. *)
Theorem strict_wrong_for_repeated_vertex :
  let A := Vec 2 0 0 in let C := Vec 3 0 0 in clear A A C 1 /\ ~ sat7_strict A A C 1.
Proof. cbv zeta. split; [is_clear | no_axis_separates]. Qed.

(* Three points on a line, (2,-1,0), (2,1,0), (2,2,0), r = 1: a phantom contact. *)
Theorem strict_wrong_for_collinear :
  let A := Vec 2 (-1) 0 in let B := Vec 2 1 0 in let C := Vec 2 2 0 in clear A B C 1 /\ ~ sat7_strict A B C 1.
Proof. cbv zeta. split; [is_clear | no_axis_separates]. Qed.
