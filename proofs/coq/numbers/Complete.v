(* Completeness: where the triangle is clear of the sphere, some axis separates; hence the test is exact. The proof
   needs no topology and no minimiser: some feature of the triangle is `good`, by signs of polynomials alone, and a good
   feature gives a point of the triangle at which `clear` is the radius comparison. *)
From Coq Require Import Reals Lra Psatz.
From Axiscert Require Import Vectors Sat7 Sound.
Open Scope R_scope.

Definition s (X Y : vec) := dot X Y - dot X X.
Definition g (X Y Z : vec) := dot (sub Y X) (sub Z X).
(* The barycentric coordinate of Z, without normalisation, for the foot of the origin on the plane. *)
Definition lam (X Y Z : vec) := s X Y * g X Y Z - length2 X Y * s X Z.

Ltac expand := unfold lam, g, s, from_foot, foot, length2, offset, normal; vec_ring.

Lemma s_sum X Y : s X Y + s Y X = - length2 X Y. Proof. expand. Qed.
Lemma s_next X Y Z : s Z Y = g X Y Z + s X Y + s Z X. Proof. expand. Qed.
Lemma g_swap X Y Z : g X Z Y = g X Y Z. Proof. expand. Qed.
Lemma length2_swap X Y : length2 Y X = length2 X Y. Proof. expand. Qed.
Lemma lam_swap X Y Z : lam Y X Z = lam X Y Z. Proof. expand. Qed.
Lemma normal_square X Y Z :
  dot (normal X Y Z) (normal X Y Z) = length2 X Y * length2 X Z - g X Y Z * g X Y Z. Proof. expand. Qed.
Lemma lam_total A B C : lam B C A + lam C A B + lam A B C = dot (normal A B C) (normal A B C). Proof. expand. Qed.
Lemma lam_normal X Y Z : lam X Y Z = dot (cross X Y) (normal X Y Z). Proof. expand. Qed.
Lemma side_lam X Y Z : dot (foot X Y) (from_foot X Y Z) = - (length2 X Y * lam X Y Z). Proof. expand. Qed.
Lemma face_point A B C :
  combination (lam B C A) (lam C A B) (lam A B C) A B C = scale (normal A B C) (offset A B C).
Proof. unfold combination; expand. Qed.
Lemma edge_point A B C : combination (- s B A) (- s A B) 0 A B C = foot A B.
Proof. unfold combination; expand. Qed.
Lemma length2_nonneg X Y : 0 <= length2 X Y. Proof. apply dot_self_nonneg. Qed.

(* `clear` for barycentric coordinates that do not sum to 1. *)
Lemma clear_at A B C rr u v w : clear A B C rr -> 0 <= u -> 0 <= v -> 0 <= w -> 0 < u + v + w ->
  rr * (u + v + w) * (u + v + w) < dot (combination u v w A B C) (combination u v w A B C).
Proof.
  intros far u0 v0 w0 positive. set (n := u + v + w) in *.
  assert (parts : forall x, 0 <= x -> 0 <= x / n).
  { intros. apply Rmult_le_pos; [assumption | left; apply Rinv_0_lt_compat; assumption]. }
  assert (u / n + v / n + w / n = 1) as sum by (unfold n in *; field; lra).
  specialize (far _ _ _ (parts u u0) (parts v v0) (parts w w0) sum).
  replace (combination u v w A B C) with (scale (combination (u / n) (v / n) (w / n) A B C) n).
  2: { unfold combination, add, scale; cbn [cx cy cz]. f_equal; field; lra. }
  set (X := combination (u / n) (v / n) (w / n) A B C) in *.
  replace (dot (scale X n) (scale X n)) with (dot X X * n * n) by vec_ring.
  apply Rmult_lt_compat_r; [assumption |]. apply Rmult_lt_compat_r; assumption.
Qed.

Definition has_area (A B C : vec) := 0 < dot (normal A B C) (normal A B C).
Definition good_face A B C := 0 <= lam B C A /\ 0 <= lam C A B /\ 0 <= lam A B C.
Definition good_vertex A B C := 0 < s A B /\ 0 < s A C.
Definition good_edge A B C := s A B <= 0 /\ s B A <= 0 /\ lam A B C < 0.
Definition good_feature A B C :=
  good_face A B C \/ good_vertex A B C \/ good_vertex B C A \/ good_vertex C A B \/
  good_edge A B C \/ good_edge B C A \/ good_edge C A B.

(* The hard step: the origin is outside AB, beyond A, and not in A's own region; then it is in the region of CA or of
   C. *)
Lemma beyond_an_end A B C : has_area A B C -> lam A B C < 0 -> 0 < s A B -> s A C <= 0 ->
  good_edge C A B \/ good_vertex C A B.
Proof.
  unfold has_area. rewrite normal_square. intros area outside x0 z0.
  pose proof (length2_nonneg A B) as e1. pose proof (length2_nonneg A C) as e3.
  pose proof (s_sum A C) as sums. pose proof (s_next A B C) as next.
  assert (other : lam C A B = s A C * g A B C - length2 A C * s A B) by expand.
  unfold good_edge, good_vertex. rewrite other. unfold lam in outside. clear other.
  set (x := s A B) in *. set (z' := s A C) in *. set (z := s C A) in *. set (q := g A B C) in *.
  set (l1 := length2 A B) in *. set (l3 := length2 A C) in *.
  assert (0 < l1) by nra.
  assert (q < 0) by nra.
  destruct (Rle_dec z 0).
  - left. repeat split; try lra.
    assert (x * q * q > l1 * z' * q) by nra.
    assert (x * (q * q) < x * (l1 * l3)) by (apply Rmult_lt_compat_l; lra).
    assert (l1 * (z' * q) < l1 * (x * l3)) by lra.
    assert (z' * q < x * l3) by (apply Rmult_lt_reg_l with l1; assumption). lra.
  - right. split; [lra |]. rewrite next.
    destruct (Rlt_dec 0 (q + x + z)); [assumption | exfalso].
    assert (x * q >= (- q - z) * q) by nra.
    assert (z' = - l3 - z) by lra. subst z'.
    assert (z * (q - l1) < 0) by nra. nra.
Qed.

Lemma beyond_a_line A B C : has_area A B C -> lam A B C < 0 -> good_feature A B C.
Proof.
  intros area outside. unfold good_feature.
  destruct (Rlt_le_dec 0 (s A B)) as [ab | ab].
  - destruct (Rlt_le_dec 0 (s A C)) as [ac | ac]; [unfold good_vertex; tauto |].
    destruct (beyond_an_end A B C area outside ab ac); tauto.
  - destruct (Rlt_le_dec 0 (s B A)) as [ba | ba]; [| unfold good_edge; tauto].
    destruct (Rlt_le_dec 0 (s B C)) as [bc | bc]; [unfold good_vertex; tauto |].
    assert (has_area B A C) as area'.
    { unfold has_area in *. replace (dot (normal B A C) (normal B A C)) with (dot (normal A B C) (normal A B C));
      [assumption | expand]. }
    rewrite <- lam_swap in outside.
    destruct (beyond_an_end B A C area' outside ba bc) as [(? & ? & ?) | (? & ?)];
      unfold good_edge, good_vertex; [rewrite <- (lam_swap B C A) | ]; tauto.
Qed.

Lemma has_area_rotate A B C : has_area A B C -> has_area B C A.
Proof.
  unfold has_area. intros. replace (dot (normal B C A) (normal B C A)) with (dot (normal A B C) (normal A B C));
  [assumption | expand].
Qed.

Lemma covering A B C : has_area A B C -> good_feature A B C.
Proof.
  intros area.
  destruct (Rlt_le_dec (lam A B C) 0) as [c | c]; [exact (beyond_a_line _ _ _ area c) |].
  pose proof (has_area_rotate _ _ _ area) as area'. pose proof (has_area_rotate _ _ _ area') as area''.
  destruct (Rlt_le_dec (lam B C A) 0) as [a | a].
  { destruct (beyond_a_line _ _ _ area' a); unfold good_feature, good_face in *; tauto. }
  destruct (Rlt_le_dec (lam C A B) 0) as [b | b].
  { destruct (beyond_a_line _ _ _ area'' b); unfold good_feature, good_face in *; tauto. }
  left. unfold good_face. tauto.
Qed.

(* Without area, no coordinate lam is negative; but then some vertex or some edge of positive length is weakly good. *)
Definition weakly_good_edge A B := s A B <= 0 /\ s B A <= 0 /\ 0 < length2 A B.
Definition weakly_good_vertex A B C := 0 <= s A B /\ 0 <= s A C.

Lemma covering_without_area A B C :
  weakly_good_vertex A B C \/ weakly_good_vertex B C A \/ weakly_good_vertex C A B \/
  weakly_good_edge A B \/ weakly_good_edge B C \/ weakly_good_edge C A.
Proof.
  unfold weakly_good_edge, weakly_good_vertex.
  pose proof (length2_nonneg A B). pose proof (length2_nonneg B C). pose proof (length2_nonneg C A).
  pose proof (s_sum A B). pose proof (s_sum B C). pose proof (s_sum C A).
  assert (no_cycle : 2 * (s A B + s B C + s C A) = - (length2 A B + length2 B C + length2 C A)) by expand.
  assert (no_cycle' : 2 * (s B A + s C B + s A C) = - (length2 A B + length2 B C + length2 C A)) by expand.
  assert (same_point : forall X Y, length2 X Y = 0 -> s X Y = 0).
  { intros X Y. unfold length2, s. intros zero. pose proof (cauchy_schwarz X (sub Y X)) as bound.
    rewrite zero, Rmult_0_r in bound. replace (dot X Y - dot X X) with (dot X (sub Y X)) by vec_ring. nra. }
  pose proof (same_point A B). pose proof (same_point B C). pose proof (same_point C A).
  destruct (Rlt_le_dec 0 (s A B)), (Rlt_le_dec 0 (s B A)), (Rlt_le_dec 0 (s B C)), (Rlt_le_dec 0 (s C B)),
    (Rlt_le_dec 0 (s C A)), (Rlt_le_dec 0 (s A C)); try (exfalso; lra);
  destruct (Rlt_le_dec 0 (length2 A B)), (Rlt_le_dec 0 (length2 B C)), (Rlt_le_dec 0 (length2 C A));
  repeat match goal with
  | H : length2 ?X ?Y <= 0, H' : length2 ?X ?Y = 0 -> _ |- _ => specialize (H' ltac:(lra))
  end; try tauto; try (exfalso; lra);
  first [ left; lra | right; left; lra | right; right; left; lra ].
Qed.

(* The comparisons of the axis of a good feature hold. *)
Lemma face_complete A B C rr : has_area A B C -> good_face A B C -> clear A B C rr -> strict (plane_sides A B C rr).
Proof.
  intros area (a & b & c) far. pose proof (lam_total A B C) as total. unfold has_area in area.
  pose proof (clear_at A B C rr _ _ _ far a b c ltac:(lra)) as radius. rewrite face_point, total in radius.
  unfold strict, plane_sides; cbn [fst snd].
  replace (dot (scale (normal A B C) (offset A B C)) (scale (normal A B C) (offset A B C)))
    with (offset A B C * offset A B C * dot (normal A B C) (normal A B C)) in radius by (generalize (offset A B C); vec_ring).
  apply Rmult_lt_reg_r in radius; [lra | assumption].
Qed.

Lemma vertex_complete A B C rr : clear A B C rr -> dot A A > rr.
Proof.
  intros far. specialize (far 1 0 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  replace (combination 1 0 0 A B C) with A in far; [exact far |].
  unfold combination; vec_ring.
Qed.

Lemma edge_complete A B C rr : s A B <= 0 -> s B A <= 0 -> 0 < length2 A B -> clear A B C rr ->
  strict (edge_radius_sides A B rr).
Proof.
  intros ab ba e far. pose proof (s_sum A B) as sum.
  pose proof (clear_at A B C rr (- s B A) (- s A B) 0 far ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as radius.
  rewrite edge_point in radius. replace (- s B A + - s A B + 0) with (length2 A B) in radius by lra.
  exact radius.
Qed.

Lemma good_edge_length A B C : has_area A B C -> 0 < length2 A B.
Proof.
  unfold has_area. rewrite normal_square. intros area. pose proof (length2_nonneg A B). pose proof (length2_nonneg A C).
  destruct (Rle_lt_or_eq_dec 0 (length2 A B)) as [| zero]; [assumption | assumption |]. rewrite <- zero in area. nra.
Qed.

Lemma good_edge_separates A B C rr : has_area A B C -> good_edge A B C -> clear A B C rr ->
  strict (edge_radius_sides A B rr) /\ strict (edge_side_sides A B C).
Proof.
  intros area (ab & ba & outside) far. pose proof (good_edge_length _ _ _ area) as e. split.
  - apply (edge_complete A B C); assumption.
  - unfold strict, edge_side_sides; cbn [fst snd]. rewrite side_lam. nra.
Qed.

Lemma good_vertex_separates A B C rr : good_vertex A B C -> clear A B C rr ->
  strict (vertex_radius_sides A rr) /\ strict (vertex_side_sides A B) /\ strict (vertex_side_sides A C).
Proof.
  unfold good_vertex, s, strict, vertex_radius_sides, vertex_side_sides; cbn [fst snd]. intros (b & c) far.
  pose proof (vertex_complete _ _ _ _ far). lra.
Qed.

Theorem complete_strict A B C rr : has_area A B C -> clear A B C rr -> sat7_strict A B C rr.
Proof.
  intros area far. pose proof (has_area_rotate _ _ _ area) as area'. pose proof (has_area_rotate _ _ _ area') as area''.
  assert (clear B C A rr) as far' by (apply clear_rotate, clear_rotate; assumption).
  assert (clear C A B rr) as far'' by (apply clear_rotate; assumption).
  unfold sat7_strict, some_axis; cbn.
  destruct (covering _ _ _ area) as [H | [H | [H | [H | [H | [H | H]]]]]].
  - left. apply face_complete; assumption.
  - right; left. apply (good_vertex_separates A B C); assumption.
  - right; right; left. pose proof (good_vertex_separates B C A rr H far'). tauto.
  - do 3 right; left. apply (good_vertex_separates C A B); assumption.
  - do 4 right; left. apply good_edge_separates; assumption.
  - do 5 right; left. apply good_edge_separates; assumption.
  - do 6 right. apply good_edge_separates; assumption.
Qed.

Lemma weak_edge_separates A B C rr : ~ has_area A B C -> weakly_good_edge A B -> clear A B C rr ->
  strict (edge_radius_sides A B rr) /\ fst (edge_side_sides A B C) >= 0.
Proof.
  intros flat (ab & ba & e) far. split; [apply (edge_complete A B C); assumption |].
  unfold edge_side_sides; cbn [fst]. rewrite side_lam.
  enough (lam A B C = 0) as -> by lra. rewrite lam_normal.
  unfold has_area in flat. pose proof (dot_self_nonneg (normal A B C)).
  pose proof (cauchy_schwarz (cross A B) (normal A B C)) as bound.
  replace (dot (normal A B C) (normal A B C)) with 0 in bound by lra. rewrite Rmult_0_r in bound. nra.
Qed.

Theorem complete A B C rr : clear A B C rr -> sat7 A B C rr.
Proof.
  intros far. destruct (Rlt_le_dec 0 (dot (normal A B C) (normal A B C))) as [area | flat].
  { apply (some_axis_mono (fun K => strict (published A B C rr K))).
    - intros K. apply strict_nonstrict.
    - apply complete_strict; assumption. }
  assert (clear B C A rr) as far' by (apply clear_rotate, clear_rotate; assumption).
  assert (clear C A B rr) as far'' by (apply clear_rotate; assumption).
  assert (~ has_area A B C) as flatA by (unfold has_area; lra).
  assert (~ has_area B C A) as flatB by (intros H; apply flatA, has_area_rotate, has_area_rotate, H).
  assert (~ has_area C A B) as flatC by (intros H; apply flatA, has_area_rotate, H).
  pose proof (vertex_complete _ _ _ _ far). pose proof (vertex_complete _ _ _ _ far').
  pose proof (vertex_complete _ _ _ _ far'').
  unfold sat7, some_axis, nonstrict; cbn.
  destruct (covering_without_area A B C) as [H2 | [H2 | [H2 | [H2 | [H2 | H2]]]]];
    unfold weakly_good_vertex, s in H2.
  - right; left. lra.
  - do 2 right; left. lra.
  - do 3 right; left. lra.
  - do 4 right; left. apply weak_edge_separates; assumption.
  - do 5 right; left. apply weak_edge_separates; assumption.
  - do 6 right. apply weak_edge_separates; assumption.
Qed.
