(* What becomes of a query of a block: the steps say things of it, and the answer's bits are made of them. Where each step is right
   in what it said, and the answer is supported by something that was said of this query, the answer is right. *)
From Coq Require Import Reals ZArith Bool List Lra.
From Axiscert Require Import Vectors Sat7 OpenSphere Known.
Import ListNotations.
Open Scope Z_scope.

(* What a step said: a verdict; bits of `KnownResults` (exact_step.h); or, as the last step, a verdict after it was given bits. *)
Inductive said := said_apart | said_contact | said_bits (bits : Z) | said_last (bits : Z) (apart : bool).
(* Whether the query was invalid; the answer's bits; what was said. *)
Record taken := Taken { taken_invalid : bool; answered_contact : bool; answered_invalid : bool; what_was_said : list said }.

Definition place_of_axis (i : axis) : Z :=
  match i with axis_a => 0 | axis_b => 1 | axis_c => 2 | axis_plane => 3 | axis_ab => 4 | axis_bc => 5 | axis_ca => 6 end.
Definition known_of (bits : Z) : known :=
  Known (fun i => Z.testbit bits (place_of_axis i)) (fun i => Z.testbit bits (8 + place_of_axis i)) (fun i => Z.testbit bits (16 + place_of_axis i)).
Definition bits_said (l : list said) : Z := fold_right (fun e bits => match e with said_bits k => Z.lor k bits | _ => bits end) 0 l.
(* The last step is given no bit that was not told of this query. *)
Definition is_given_what_was_told (told : Z) (e : said) : bool := match e with said_last k _ => Z.land k (Z.lnot told) =? 0 | _ => true end.
Definition supports (apart : bool) (e : said) : bool :=
  match e with said_apart => apart | said_contact => negb apart | said_last _ a => Bool.eqb a apart | said_bits _ => false end.
Definition taken_is_right (t : taken) : bool :=
  let told := bits_said (what_was_said t) in
  if taken_invalid t then answered_invalid t && negb (answered_contact t)
  else negb (answered_invalid t) && forallb (is_given_what_was_told told) (what_was_said t) &&
    (existsb (supports (negb (answered_contact t))) (what_was_said t) ||
     (if answered_contact t then is_contact (known_of told) else is_separated (known_of told))).

Section Right.
  Variables (q : question) (A B C P : vec) (r : R).
  Hypothesis r0 : (0 <= r)%R.
  Notation holds := (holds_for q (sub A P) (sub B P) (sub C P) (r * r)).
  Notation truth := (apart q A B C P r).
  Definition said_is_right (e : said) : Prop :=
    match e with
    | said_apart => truth
    | said_contact => ~ truth
    | said_bits k => sound_known holds (known_of k)
    | said_last k a => sound_known holds (known_of k) -> (a = true <-> truth)
    end.

  Lemma bits_said_are_right l : Forall said_is_right l -> sound_known holds (known_of (bits_said l)).
  Proof using Type.
    induction 1 as [| e l right _ sound].
    - intros i. cbn. rewrite !Z.testbit_0_l. repeat split; discriminate.
    - destruct e; cbn [bits_said fold_right] in *; try exact sound. intros i. pose proof (both_are_sound _ _ _ right sound i) as both.
      cbn [both_known known_of known_fails known_radius known_sides] in *. rewrite !Z.lor_spec. exact both.
  Qed.
  Lemma fewer_bits k told : Z.land k (Z.lnot told) = 0 -> sound_known holds (known_of told) -> sound_known holds (known_of k).
  Proof using Type.
    intros none sound i. assert (forall n, Z.testbit k n = true -> Z.testbit told n = true) as more.
    { intros n set. destruct (Z.testbit told n) eqn:missing; [reflexivity |]. destruct (Z_lt_le_dec n 0).
      - rewrite Z.testbit_neg_r in set by assumption. discriminate.
      - assert (Z.testbit (Z.land k (Z.lnot told)) n = true) as there.
        { rewrite Z.land_spec, Z.lnot_spec, set, missing by assumption. reflexivity. }
        rewrite none, Z.testbit_0_l in there. discriminate. }
    destruct (sound i) as (fails & radius & sides). cbn [known_of known_fails known_radius known_sides] in *. repeat split; auto.
  Qed.

  Theorem answer_is_right t : taken_is_right t = true -> taken_invalid t = false -> Forall said_is_right (what_was_said t) ->
    answered_invalid t = false /\ (answered_contact t = true <-> ~ truth).
  Proof using r0.
    intros right valid sound. unfold taken_is_right in right. rewrite valid in right.
    apply andb_true_iff in right as [[invalid given]%andb_true_iff support]. apply negb_true_iff in invalid. split; [exact invalid |].
    pose proof (bits_said_are_right _ sound) as told. destruct (known_is_right q A B C P r _ r0 told) as [separated contact].
    assert (if answered_contact t then ~ truth else truth) as verdict; [| destruct (answered_contact t); intuition discriminate].
    apply orb_true_iff in support as [(e & inside & e_supports)%existsb_exists | known].
    - rewrite Forall_forall in sound. rewrite forallb_forall in given. specialize (sound e inside). specialize (given e inside).
      destruct e as [| | | k a]; cbn [supports said_is_right is_given_what_was_told] in *.
      + destruct (answered_contact t); [discriminate | exact sound].
      + destruct (answered_contact t); [exact sound | discriminate].
      + discriminate.
      + apply Z.eqb_eq in given. specialize (sound (fewer_bits _ _ given told)). apply Bool.eqb_prop in e_supports. subst a.
        destruct (answered_contact t); cbn in *; [intros H; apply sound in H; discriminate | apply sound; reflexivity].
    - destruct (answered_contact t); auto.
  Qed.
End Right.
