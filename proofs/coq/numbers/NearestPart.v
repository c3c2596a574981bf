(* Which part of a triangle is nearest to the origin: the rule of the contacts of the certified predicate
   (kernel/sphere_triangle/certified/contact_steps.h), for every triangle, those without area too. *)
From Coq Require Import Reals Lra Psatz.
From Axiscert Require Import Vectors.
Open Scope R_scope.

Inductive part := part_a | part_b | part_c | part_ab | part_bc | part_ca | part_face.

Definition at_vertex (A B C : vec) := 0 <= dot A (sub B A) /\ 0 <= dot A (sub C A).
(* N.V, with N = A x AB: on which side of the plane through the edge AB, at right angles to the face, C is. *)
Definition corner_beyond (A B C : vec) := dot (cross A (sub B A)) (cross (sub B A) (sub C A)).
Definition on_edge (A B C : vec) := dot A (sub B A) < 0 /\ 0 < dot B (sub B A) /\ corner_beyond A B C <= 0.
Definition on_border (A B C : vec) (X : part) :=
  match X with
  | part_a => at_vertex A B C | part_b => at_vertex B C A | part_c => at_vertex C A B
  | part_ab => on_edge A B C | part_bc => on_edge B C A | part_ca => on_edge C A B
  | part_face => False
  end.
Definition is_nearest (A B C : vec) (X : part) :=
  match X with part_face => forall Y, ~ on_border A B C Y | _ => on_border A B C X end.

Definition foot_on_edge (A B : vec) := add A (scale (sub B A) (- dot A (sub B A) / dot (sub B A) (sub B A))).
Definition foot_of_part (A B C : vec) (X : part) :=
  let V := cross (sub B A) (sub C A) in
  match X with
  | part_a => A | part_b => B | part_c => C
  | part_ab => foot_on_edge A B | part_bc => foot_on_edge B C | part_ca => foot_on_edge C A
  | part_face => scale V (dot A V / dot V V)
  end.

Definition nearest_point (F A B C : vec) := in_triangle F A B C /\ forall X, in_triangle X A B C -> dot F F <= dot X X.

(* A point of a convex set is the nearest where no corner is on the origin's side of it. *)
Lemma optimal F A B C : in_triangle F A B C ->
  dot F F <= dot F A -> dot F F <= dot F B -> dot F F <= dot F C -> nearest_point F A B C.
Proof.
  intros inside a b c. split; [exact inside |]. intros X (u & v & w & u0 & v0 & w0 & sum & ->).
  assert (towards : dot F (combination u v w A B C) = u * dot F A + v * dot F B + w * dot F C)
    by (unfold combination; vec_ring).
  pose proof (dot_self_nonneg (sub (combination u v w A B C) F)) as square.
  assert (expanded : forall X Y, dot (sub X Y) (sub X Y) = dot X X - 2 * dot Y X + dot Y Y) by vec_ring.
  rewrite expanded in square. assert (dot F F <= dot F (combination u v w A B C)).
  { rewrite towards. replace (dot F F) with (u * dot F F + v * dot F F + w * dot F F) at 1 by (rewrite <- !Rmult_plus_distr_r, sum; ring).
    repeat apply Rplus_le_compat; apply Rmult_le_compat_l; assumption. }
  lra.
Qed.

Lemma turned X A B C : in_triangle X B C A -> in_triangle X A B C.
Proof. intros (u & v & w & u0 & v0 & w0 & sum & ->). exists w, u, v. repeat split; try lra.
  unfold combination. vec_ring. Qed.
Lemma nearest_turned F A B C : nearest_point F B C A -> nearest_point F A B C.
Proof. intros [inside least]. split; [apply turned; exact inside |].
  intros X X_in. apply least. do 2 apply turned. exact X_in. Qed.

Lemma dot_sub u v w : dot u (sub v w) = dot u v - dot u w.
Proof. vec_ring. Qed.

Lemma vertex_is_nearest A B C : at_vertex A B C -> nearest_point A A B C.
Proof.
  intros [b c]. rewrite dot_sub in b, c. apply optimal; try lra.
  exists 1, 0, 0. repeat split; try lra. unfold combination. vec_ring.
Qed.

Lemma edge_is_nearest A B C : on_edge A B C -> nearest_point (foot_on_edge A B) A B C.
Proof.
  intros (before & after & side). set (e := dot (sub B A) (sub B A)). set (g := dot A (sub B A)) in *.
  assert (split_after : dot B (sub B A) = g + e) by (unfold g, e; vec_ring).
  assert (e_pos : 0 < e) by lra. set (t := - g / e). unfold foot_on_edge. fold g e. fold t.
  assert (te : t * e = - g) by (unfold t; field; lra).
  assert (t0 : 0 <= t) by nra. assert (t1 : t <= 1) by nra.
  set (F := add A (scale (sub B A) t)).
  assert (along : dot F (sub B A) = 0).
  { transitivity (g + t * e); [unfold F, g, e; vec_ring | lra]. }
  assert (across : e * dot F (sub C A) = - corner_beyond A B C).
  { transitivity (e * dot A (sub C A) + (t * e) * dot (sub B A) (sub C A)).
    - unfold F. clear. vec_ring.
    - rewrite te. unfold corner_beyond, e, g. vec_ring. }
  assert (0 <= dot F (sub C A)) by nra.
  assert (own : dot F F = dot F A + t * dot F (sub B A)) by (unfold F; clear; vec_ring).
  rewrite dot_sub in *. apply optimal; try lra.
  - exists (1 - t), t, 0. repeat split; try lra. unfold F, combination. clear. vec_ring.
  - rewrite own. nra.
  - rewrite own. nra.
  - rewrite own. nra.
Qed.

(* Where C is beyond AB and the foot on the line of AB is before A, the border at A and C is nearest. *)
Lemma beyond_before A B C : corner_beyond A B C <= 0 -> 0 <= dot A (sub B A) ->
  at_vertex A B C \/ at_vertex C A B \/ on_edge C A B.
Proof.
  intros side before. unfold at_vertex, on_edge.
  set (g1 := dot A (sub B A)) in *. set (g2 := dot A (sub C A)). set (f := dot (sub B A) (sub C A)).
  set (e1 := dot (sub B A) (sub B A)). set (e3 := dot (sub C A) (sub C A)).
  assert (cs : f * f <= e1 * e3) by apply cauchy_schwarz.
  assert (e1_nn : 0 <= e1) by apply dot_self_nonneg. assert (e3_nn : 0 <= e3) by apply dot_self_nonneg.
  replace (corner_beyond A B C) with (g1 * f - e1 * g2) in side by (unfold corner_beyond, g1, g2, f, e1; vec_ring).
  replace (dot C (sub A C)) with (- (g2 + e3)) by (unfold g2, e3; vec_ring).
  replace (dot C (sub B C)) with ((g1 + f) - (g2 + e3)) by (unfold g1, f, g2, e3; vec_ring).
  replace (dot A (sub A C)) with (- g2) by (unfold g2; vec_ring).
  replace (corner_beyond C A B) with (f * g2 - g1 * e3) by (unfold corner_beyond, f, g1, g2, e3; vec_ring).
  destruct (Rle_or_lt 0 g2) as [|g2_neg]; [left; lra |]. right.
  assert (other_side : f * g2 - g1 * e3 <= 0).
  { destruct (Rle_or_lt 0 f) as [f_nn | f_neg]; [nra |].
    assert (e1_pos : 0 < e1) by (destruct (Req_dec e1 0) as [zero |]; [rewrite zero in cs; nra | lra]).
    apply Rmult_le_reg_l with e1; [exact e1_pos |]. rewrite Rmult_0_r. nra. }
  destruct (Rlt_or_le 0 (g2 + e3)) as [inside | past]; [right; lra |]. left. split; [lra |].
  destruct (Rle_or_lt 0 f) as [f_nn | f_neg]; [lra |].
  assert (enough : - f <= g1).
  { assert (e1_pos : 0 < e1) by (destruct (Req_dec e1 0) as [zero |]; [rewrite zero in cs; nra | lra]).
    assert (f * f <= g1 * - f) by nra. nra. }
  lra.
Qed.

Lemma edge_turned_round A B C : on_edge A B C -> on_edge B A C.
Proof.
  unfold on_edge. replace (corner_beyond B A C) with (corner_beyond A B C) by (unfold corner_beyond; vec_ring).
  replace (dot B (sub A B)) with (- dot B (sub B A)) by vec_ring.
  replace (dot A (sub A B)) with (- dot A (sub B A)) by vec_ring. lra.
Qed.

(* Beyond an edge, some part of the border is nearest. *)
Lemma beyond_is_on_border A B C : corner_beyond A B C <= 0 -> exists X, on_border A B C X.
Proof.
  intros side. destruct (Rle_or_lt 0 (dot A (sub B A))) as [before | not_before].
  { destruct (beyond_before A B C side before) as [a | [c | ca]].
    - exists part_a; exact a.
    - exists part_c; exact c.
    - exists part_ca; exact ca. }
  destruct (Rlt_or_le 0 (dot B (sub B A))) as [inside | after]; [exists part_ab; split; auto |].
  assert (other : corner_beyond B A C <= 0) by (replace (corner_beyond B A C) with (corner_beyond A B C) by (unfold corner_beyond; vec_ring); lra).
  assert (start : 0 <= dot B (sub A B)) by (replace (dot B (sub A B)) with (- dot B (sub B A)) by vec_ring; lra).
  destruct (beyond_before B A C other start) as [b | [c | cb]].
  - exists part_b. destruct b; split; assumption.
  - exists part_c. destruct c; split; assumption.
  - exists part_bc. apply edge_turned_round. exact cb.
Qed.

Lemma face_is_nearest A B C : (forall Y, ~ on_border A B C Y) -> nearest_point (foot_of_part A B C part_face) A B C.
Proof.
  intros inside. set (V := cross (sub B A) (sub C A)).
  assert (ab : 0 < corner_beyond A B C).
  { destruct (Rlt_or_le 0 (corner_beyond A B C)) as [| side]; [assumption |].
    destruct (beyond_is_on_border A B C side) as [X on]. destruct (inside X on). }
  assert (bc : 0 < corner_beyond B C A).
  { destruct (Rlt_or_le 0 (corner_beyond B C A)) as [| side]; [assumption |].
    destruct (beyond_is_on_border B C A side) as [X on]. destruct X; cbn in on.
    - destruct (inside part_b on). - destruct (inside part_c on). - destruct (inside part_a on).
    - destruct (inside part_bc on). - destruct (inside part_ca on). - destruct (inside part_ab on). - destruct on. }
  assert (ca : 0 < corner_beyond C A B).
  { destruct (Rlt_or_le 0 (corner_beyond C A B)) as [| side]; [assumption |].
    destruct (beyond_is_on_border C A B side) as [X on]. destruct X; cbn in on.
    - destruct (inside part_c on). - destruct (inside part_a on). - destruct (inside part_b on).
    - destruct (inside part_ca on). - destruct (inside part_ab on). - destruct (inside part_bc on). - destruct on. }
  assert (sum : corner_beyond A B C + corner_beyond B C A + corner_beyond C A B = dot V V) by (unfold corner_beyond, V; vec_ring).
  assert (VV : 0 < dot V V) by lra.
  assert (weights : scale V (dot A V) = combination (corner_beyond B C A) (corner_beyond C A B) (corner_beyond A B C) A B C)
    by (unfold combination, corner_beyond, V; vec_ring).
  change (foot_of_part A B C part_face) with (scale V (dot A V / dot V V)).
  assert (B_too : dot B V = dot A V) by (unfold V; vec_ring). assert (C_too : dot C V = dot A V) by (unfold V; vec_ring).
  set (k := dot A V / dot V V). assert (kVV : k * dot V V = dot A V) by (unfold k; field; lra).
  assert (own : dot (scale V k) (scale V k) = k * (k * dot V V)) by vec_ring.
  assert (with_corner : forall X, dot (scale V k) X = k * dot X V) by (intros; vec_ring).
  apply optimal; rewrite ?own, ?with_corner, ?B_too, ?C_too, ?kVV; try lra.
  exists (corner_beyond B C A / dot V V), (corner_beyond C A B / dot V V), (corner_beyond A B C / dot V V).
  repeat split; try (apply Rlt_le, Rdiv_lt_0_compat; assumption).
  - rewrite <- sum. field. lra.
  - transitivity (scale (scale V (dot A V)) (/ dot V V)).
    + unfold k, Rdiv. vec_ring.
    + rewrite weights. unfold combination, Rdiv. vec_ring.
Qed.

Theorem part_is_nearest A B C X : is_nearest A B C X -> nearest_point (foot_of_part A B C X) A B C.
Proof.
  destruct X; cbn [is_nearest on_border foot_of_part]; intros on.
  - apply vertex_is_nearest; exact on.
  - apply nearest_turned, vertex_is_nearest; exact on.
  - do 2 apply nearest_turned. apply vertex_is_nearest; exact on.
  - apply edge_is_nearest; exact on.
  - apply nearest_turned, edge_is_nearest; exact on.
  - do 2 apply nearest_turned. apply edge_is_nearest; exact on.
  - apply face_is_nearest; exact on.
Qed.
