(* What is still assumed of the steps, each under its name, and that certified is exact of every finite query of binary32 if these hold.
   Of what the steps tell, the bits of the coarse step, the fine step and balls are right by proof (CoarseKnown.v, FineKnown.v, Balls.v). *)
From Coq Require Import ZArith List Reals Bool.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 OpenSphere Known Filter Sizes CoarseFloat Machine RecordedIsCertified CoarseKnown FineKnown
  ExactProgram RecordedExact ExactStep ExactVerdict Balls CertifiedIsExact.
Import ListNotations.
Open Scope R_scope.

Section Remaining.
  Variable q : question.
  Variables (a b c p : float_vec 53 1024) (r : binary_float 53 1024).
  Let at_ := real_vec 53 1024.
  Notation holds := (holds_for q (sub (at_ a) (at_ p)) (sub (at_ b) (at_ p)) (sub (at_ c) (at_ p)) (B2R r * B2R r)).
  (* Bits that a step tells of a query are right. The deep step: in pairs and by residues. *)
  Definition deep_tells_right (told : known) : Prop := sound_known holds told.

  (* What the coarse step tells in its range, in doubles, to which binary32 is widened; else nothing. *)
  Definition coarse_told (low : binary_float 53 1024 -> binary_float 53 1024 -> binary_float 53 1024) (fused : bool) : known :=
    if float_in_range 53 1024 eq_refl eq_refl fused (-300) 150 a b c p r
    then coarse_known 53 1024 eq_refl eq_refl fused low a b c p r else nothing_known.
  Lemma coarse_told_is_right low fused : is_least 53 1024 low -> sound_known holds (coarse_told low fused).
  Proof using Type.
    intros low_is. unfold coarse_told. destruct float_in_range eqn:inside; [| apply nothing_is_sound].
    exact (coarse_known_is_sound64 low fused a b c p r low_is inside q).
  Qed.
  (* What the fine step tells, in doubles. *)
  Definition fine_told (low high : binary_float 53 1024 -> binary_float 53 1024 -> binary_float 53 1024)
    (other : binary_float 53 1024 -> binary_float 53 1024) (fused : bool) : known :=
    let m := machine64 low high other in
    fine_known m (fine_list m fused (fx _ _ a) (fy _ _ a) (fz _ _ a) (fx _ _ b) (fy _ _ b) (fz _ _ b) (fx _ _ c) (fy _ _ c) (fz _ _ c)
      (fx _ _ p) (fy _ _ p) (fz _ _ p) r) (is_open_sphere q).
End Remaining.

Definition certified_is_exact_if_these_hold : Prop :=
  forall low high other fused (q : question) (a b c p : float_vec 53 1024) (r : binary_float 53 1024) (deep : known) (balls : list ball),
  let v := real_vec 53 1024 in
  let query := [cx (v a); cy (v a); cz (v a); cx (v b); cy (v b); cz (v b); cx (v c); cy (v c); cz (v c); cx (v p); cy (v p); cz (v p); B2R r] in
  let truth := apart q (v a) (v b) (v c) (v p) (B2R r) in
  let k := both_known (coarse_told a b c p r low fused)
    (both_known (fine_told q a b c p r low high other fused) (both_known deep (both_known (balls_tell balls) nothing_known))) in
  let finite := finite_vec 53 1024 in
  is_least 53 1024 low -> is_greatest 53 1024 high -> finite a /\ finite b /\ finite c /\ finite p /\ is_finite r = true ->
  Forall in_binary32 query -> 0 <= B2R r ->
  deep_tells_right q a b c p r deep -> Forall2 is_ball_of balls query ->
  (is_separated k = true -> truth) /\ (is_contact k = true -> ~ truth) /\
  exists whole : list Z, map of_least whole = query /\ (recorded_separates q k (run_Z whole exact_program) = true <-> truth).
Theorem what_remains_assumed_binary32 : certified_is_exact_if_these_hold.
Proof.
  intros low high other fused q a b c p r deep balls. cbv zeta. intros low_is high_is finite format r0 deep_right of_query.
  pose proof (certified_is_exact_binary32 q _ _ _ _ _ _ _ _ _ _ _ _ (B2R r)
    [coarse_told a b c p r low fused; fine_told q a b c p r low high other fused; deep; balls_tell balls] format r0) as exact.
  cbn [fold_right] in exact. destruct exact as (separated & contact & whole & same & verdict & _).
  - pose proof (coarse_told_is_right q a b c p r low fused low_is) as coarse_right.
    pose proof (fine_tells_right32 low high other high_is fused a b c p r finite format r0 q) as fine_right.
    assert (forall l l', Forall2 is_ball_of l l' -> Forall2 in_ball l l') as held.
    { intros l l' all. induction all; constructor; auto using ball_of_holds. }
    pose proof (balls_tell_right q _ _ _ _ (B2R r) balls (held _ _ of_query)) as balls_right.
    repeat (apply Forall_cons; [first [exact coarse_right | exact fine_right | exact deep_right | exact balls_right] |]). apply Forall_nil.
  - split; [exact separated |]. split; [exact contact |]. exists whole. split; assumption.
Qed.
