(* The certified predicate's steps tell each other `KnownResults` of kernel/sphere_triangle/certified/exact_step.h, three bits
   for each axis. Where every bit that is set is right, so are the verdicts made of them, for the closed sphere and the open
   one, whichever steps set which bits and in whatever order; and the last step, which evaluates what is not known, decides. *)
From Coq Require Import Reals Bool List Lra.
From Axiscert Require Import Vectors Sat7 Exact Reduced OpenSphere.
Import ListNotations.
Open Scope R_scope.

Inductive axis := axis_a | axis_b | axis_c | axis_plane | axis_ab | axis_bc | axis_ca.
Definition all_axes := [axis_a; axis_b; axis_c; axis_plane; axis_ab; axis_bc; axis_ca].
Definition radius_of (i : axis) : comparison :=
  match i with
  | axis_a => vertex_a_radius | axis_b => vertex_b_radius | axis_c => vertex_c_radius
  | axis_plane => plane_radius
  | axis_ab => edge_ab_radius | axis_bc => edge_bc_radius | axis_ca => edge_ca_radius
  end.
Definition sides_hold (holds : comparison -> Prop) (i : axis) : Prop :=
  match i with
  | axis_a => holds vertex_a_side_b /\ holds vertex_a_side_c
  | axis_b => holds vertex_b_side_a /\ holds vertex_b_side_c
  | axis_c => holds vertex_c_side_a /\ holds vertex_c_side_b
  | axis_plane => True
  | axis_ab => holds edge_ab_side_c
  | axis_bc => holds edge_bc_side_a
  | axis_ca => holds edge_ca_side_b
  end.
Definition axis_holds (holds : comparison -> Prop) (i : axis) : Prop := holds (radius_of i) /\ sides_hold holds i.

Lemma some_axis_is holds : some_axis holds <-> exists i, axis_holds holds i.
Proof.
  unfold some_axis, axis_holds. split.
  - intros H. decompose [or] H; [exists axis_plane | exists axis_a | exists axis_b | exists axis_c | exists axis_ab | exists axis_bc |
      exists axis_ca]; cbn; tauto.
  - intros [[] H]; cbn in H; tauto.
Qed.
Lemma in_all_axes i : In i all_axes.
Proof. destruct i; cbn; tauto. Qed.

Inductive question := closed_sphere | open_sphere.
Definition holds_for (q : question) (A B C : vec) (rr : R) (K : comparison) : Prop :=
  match q with closed_sphere => nonstrict K (reduced A B C rr K) | open_sphere => open_holds A B C rr K end.
Definition apart (q : question) (A B C P : vec) (r : R) : Prop :=
  match q with closed_sphere => separated A B C P r | open_sphere => separated_open A B C P r end.

Theorem either_exact q A B C P r : 0 <= r ->
  (some_axis (holds_for q (sub A P) (sub B P) (sub C P) (r * r)) <-> apart q A B C P r).
Proof. intros r0. destruct q; [apply reduced_exact | apply open_exact]; assumption. Qed.

(* The sign of a margin, the left side less the right one, decides a comparison. *)
Theorem sign_decides q A B C rr K : 0 <= rr -> let s := reduced A B C rr K in
  (fst s > snd s -> holds_for q A B C rr K) /\ (fst s < snd s -> ~ holds_for q A B C rr K) /\
  (fst s = snd s -> (holds_for q A B C rr K <-> is_side K = true \/ q = open_sphere /\ has_normal A B C K)).
Proof.
  intros r0 s.
  assert (fst s > snd s -> has_normal A B C K) as normal.
  { unfold s. destruct (sides_shape A B C K) as [(_ & some & _) | (_ & f & n & f0 & n0 & some & flat & value)]; [auto |].
    rewrite value, some. cbn [fst snd]. intros greater. destruct (Rle_lt_or_eq_dec 0 n n0) as [| zero]; [assumption |].
    specialize (flat (eq_sym zero)). subst. lra. }
  assert (is_side K = true -> has_normal A B C K) as side by (destruct K; cbn; auto; discriminate).
  destruct q; cbn [holds_for]; unfold open_holds, weak, nonstrict; fold s; destruct (is_side K); repeat split; intros;
    first [tauto | lra | exfalso; lra | intuition (try discriminate; lra)].
Qed.

Record known := Known { known_fails : axis -> bool; known_radius : axis -> bool; known_sides : axis -> bool }.
Definition sound_known (holds : comparison -> Prop) (k : known) : Prop := forall i,
  (known_fails k i = true -> ~ axis_holds holds i) /\ (known_radius k i = true -> holds (radius_of i)) /\
  (known_sides k i = true -> sides_hold holds i).
Definition nothing_known := Known (fun _ => false) (fun _ => false) (fun _ => false).
Definition both_known (k l : known) :=
  Known (fun i => known_fails k i || known_fails l i) (fun i => known_radius k i || known_radius l i)
    (fun i => known_sides k i || known_sides l i).
Definition is_separated (k : known) : bool := existsb (fun i => known_radius k i && known_sides k i) all_axes.
Definition is_contact (k : known) : bool := forallb (known_fails k) all_axes.

Lemma nothing_is_sound holds : sound_known holds nothing_known.
Proof. intros i. cbn. repeat split; discriminate. Qed.
Theorem both_are_sound holds k l : sound_known holds k -> sound_known holds l -> sound_known holds (both_known k l).
Proof.
  intros H H' i. destruct (H i) as (? & ? & ?), (H' i) as (? & ? & ?). cbn [known_fails known_radius known_sides both_known].
  rewrite !orb_true_iff. tauto.
Qed.

Theorem known_is_right q A B C P r k : 0 <= r -> sound_known (holds_for q (sub A P) (sub B P) (sub C P) (r * r)) k ->
  (is_separated k = true -> apart q A B C P r) /\ (is_contact k = true -> ~ apart q A B C P r).
Proof.
  intros r0 right. rewrite <- (either_exact q A B C P r r0), some_axis_is. unfold is_separated, is_contact. split.
  - rewrite existsb_exists. intros (i & _ & set). apply andb_true_iff in set as [one two].
    exists i. split; apply (right i); assumption.
  - rewrite forallb_forall. intros all [i holds]. apply (right i) in holds; [assumption | apply all, in_all_axes].
Qed.

(* The last step: of an axis that is not known to fail, the comparisons that are not known are evaluated. *)
Theorem last_step_decides q A B C P r k : 0 <= r ->
  let holds := holds_for q (sub A P) (sub B P) (sub C P) (r * r) in
  sound_known holds k ->
  ((exists i, known_fails k i = false /\ (known_radius k i = true \/ holds (radius_of i)) /\
      (known_sides k i = true \/ sides_hold holds i)) <->
    apart q A B C P r).
Proof.
  intros r0 holds right. rewrite <- (either_exact q A B C P r r0), some_axis_is. fold holds. split.
  - intros (i & _ & one & two). exists i. destruct (right i) as (_ & first & second). unfold axis_holds. tauto.
  - intros [i [one two]]. exists i. split; [| tauto]. destruct (known_fails k i) eqn:set; [| reflexivity].
    exfalso. apply (right i) in set. apply set. split; assumption.
Qed.
