(* What the exact step makes of the signs of its margins, kernel/sphere_triangle/certified/exact_test.h, as recorded: the
   verdict of `exact_separates`. And the integers that it takes for numbers of a span, widths.h, as recorded: they hold
   these, and their values fit in the words that they have. *)
From Coq Require Import ZArith List Lia Bool.
From Axiscert Require Import Known ExactProgram RecordedExact ExactStep.
Import ListNotations.
Open Scope Z_scope.

(* The verdict. *)
Section Verdict.
  Variable q : question.
  Variable k : known.
  Variable values : list Z.
  Definition knows (group axis : nat) : bool :=
    let i := nth axis all_axes axis_a in
    match group with O => known_fails k i | S O => known_radius k i | _ => known_sides k i end.
  Definition says (x : asked) : bool :=
    match x with
    | Is_positive i => 0 <? nth i values 0 | Is_negative i => nth i values 0 <? 0 | Is_zero i => nth i values 0 =? 0
    | Is_at_least_zero i => 0 <=? nth i values 0 | Is_at_most_zero i => nth i values 0 <=? 0
    | Knows group axis => knows group axis
    | Separates _ => false
    end.
  Definition recorded_axes : list tree := match q with closed_sphere => recorded_closed_axes | open_sphere => recorded_open_axes end.
  Definition axis_says (axis : nat) : bool := answer_of says (nth axis recorded_axes (Answer false)).
  Definition recorded_separates : bool :=
    answer_of (fun x => match x with Separates axis => axis_says axis | _ => false end) recorded_verdict.
End Verdict.

(* Each sign is asked once, in the terms of the theorems, and decides on either side. *)
Ltac by_signs :=
  unfold axis_says, recorded_axes, vertex_separates, plane_separates, edge_separates, is_zero, radius_beyond, recorded_exact_results;
  cbn [map nth Nat.add];
  match goal with q : question |- _ => destruct q end;
  unfold recorded_closed_axes, recorded_open_axes; cbn [nth answer_of says knows all_axes]; rewrite ?Z.leb_antisym;
  repeat match goal with
  | |- context [known_fails ?k ?i] => destruct (known_fails k i)
  | |- context [known_radius ?k ?i] => destruct (known_radius k i)
  | |- context [known_sides ?k ?i] => destruct (known_sides k i)
  | |- context [?x =? 0] => destruct (x =? 0)
  | |- context [0 <? ?x] => destruct (0 <? x)
  | |- context [?x <? 0] => destruct (x <? 0)
  end; reflexivity.

Section Axes.
  Variables (q : question) (k : known) (values : list Z).
  Notation margins := (map (fun i => nth i values 0) recorded_exact_results).
  Lemma says_a : axis_says q k values 0 = vertex_separates q k margins axis_a 1. Proof using Type. by_signs. Qed.
  Lemma says_b : axis_says q k values 1 = vertex_separates q k margins axis_b 4. Proof using Type. by_signs. Qed.
  Lemma says_c : axis_says q k values 2 = vertex_separates q k margins axis_c 7. Proof using Type. by_signs. Qed.
  Lemma says_plane : axis_says q k values 3 = plane_separates q k margins. Proof using Type. by_signs. Qed.
  Lemma says_ab : axis_says q k values 4 = edge_separates q k margins axis_ab 19 10. Proof using Type. by_signs. Qed.
  Lemma says_bc : axis_says q k values 5 = edge_separates q k margins axis_bc 22 12. Proof using Type. by_signs. Qed.
  Lemma says_ca : axis_says q k values 6 = edge_separates q k margins axis_ca 25 14. Proof using Type. by_signs. Qed.

  Lemma recorded_separates_is : recorded_separates q k values = exact_separates q k margins.
  Proof using Type.
    unfold recorded_separates, recorded_verdict, exact_separates. cbn [answer_of].
    rewrite <- says_a, <- says_b, <- says_c, <- says_plane, <- says_ab, <- says_bc, <- says_ca.
    destruct (axis_says q k values 0), (axis_says q k values 1), (axis_says q k values 2), (axis_says q k values 3),
      (axis_says q k values 4), (axis_says q k values 5), (axis_says q k values 6); reflexivity.
  Qed.
End Axes.
Theorem recorded_verdict_is_exact_separates q k query :
  recorded_separates q k (run_Z query exact_program) = exact_separates q k (exact_margins query).
Proof. exact (recorded_separates_is q k (run_Z query exact_program)). Qed.

(* V is left out only where no axis asks for it: the plane's and each edge's is known to fail, or an edge's sides to hold. *)
Definition asks_for_normal (plane ab bc ca sab sbc sca : bool) : bool :=
  negb plane || (negb ab && negb sab) || (negb bc && negb sbc) || (negb ca && negb sca).
Definition bit (n i : nat) : bool := Nat.testbit n i.
Theorem recorded_normal_is_there : forall fails sides, (fails < 16)%nat -> (sides < 8)%nat ->
  asks_for_normal (bit fails 0) (bit fails 1) (bit fails 2) (bit fails 3) (bit sides 0) (bit sides 1) (bit sides 2) = true ->
  nth (8 * fails + sides) recorded_needs_normal false = true.
Proof.
  intros fails sides f s. do 16 (destruct fails as [| fails]; [do 8 (destruct sides as [| sides]; [cbv; auto |]); exfalso; lia |]). exfalso; lia.
Qed.

(* The integers. *)
Definition size_for (bits : Z) : Z :=
  nth (Z.to_nat bits) (concat (map (fun run => repeat (snd run) (fst run)) recorded_size_runs)) 0.
(* The words of a value of this degree, in integers of this size; no number of them where it is none of theirs. *)
Definition recorded_words (size degree : Z) : Z :=
  match find (fun entry => fst (fst entry) =? size) recorded_sizes with
  | Some (_, words) =>
      nth (match degree with 1 => 0%nat | 2 => 1%nat | 3 => 2%nat | 4 => 3%nat | 6 => 4%nat | _ => 5%nat end) words 0
  | None => 0
  end.
Definition recorded_negligible (size : Z) : Z :=
  match find (fun entry => fst (fst entry) =? size) recorded_sizes with Some (_, exponent, _) => exponent | None => 0 end.

Definition holds_span (bits : Z) : bool :=
  let size := size_for bits in
  (bits <=? size) && forallb (fun degree => words_of size degree <=? recorded_words size degree) [1; 2; 3; 4; 6] &&
  (recorded_negligible size =? -2 * size - 2).
Lemma all_spans : forallb (fun i => holds_span (Z.of_nat i)) (seq 1 286) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma span_is_held bits : 1 <= bits <= 286 -> holds_span bits = true.
Proof.
  intros span. pose proof all_spans as all. rewrite forallb_forall in all. specialize (all (Z.to_nat bits)).
  rewrite Z2Nat.id in all by lia. apply all, in_seq. lia.
Qed.
(* The radius taken as zero is the one of `negligible_radius`. *)
Theorem recorded_negligible_is_proved bits : 1 <= bits <= 286 -> recorded_negligible (size_for bits) = -2 * size_for bits - 2.
Proof.
  intros span. pose proof (span_is_held bits span) as held. unfold holds_span in held. cbv zeta in held.
  rewrite !andb_true_iff, Z.eqb_eq in held. apply held.
Qed.
(* Never too short an integer, whatever the span. *)
Theorem recorded_size_is_great_enough bits : 0 <= bits -> size_for bits = 0 \/ bits <= size_for bits.
Proof.
  intros b0. destruct (Z_le_gt_dec bits 2199) as [below | beyond].
  - assert (forallb (fun i => (size_for (Z.of_nat i) =? 0) || (Z.of_nat i <=? size_for (Z.of_nat i))) (seq 0 2200) = true) as all
      by (vm_compute; reflexivity).
    rewrite forallb_forall in all. specialize (all (Z.to_nat bits)). rewrite Z2Nat.id in all by lia.
    rewrite orb_true_iff, Z.eqb_eq, Z.leb_le in all. apply all, in_seq. lia.
  - left. unfold size_for. apply nth_overflow. set (l := concat _). assert (length l = 2200%nat) as -> by (vm_compute; reflexivity). lia.
Qed.

(* The degrees that values have. *)
Lemma recorded_degrees : Forall (fun degree => In (Z.of_nat degree) [1; 2; 3; 4; 6]) (map snd recorded_exact).
Proof.
  assert (forallb (fun degree => existsb (Z.eqb (Z.of_nat degree)) [1; 2; 3; 4; 6]) (map snd recorded_exact) = true) as all
    by (vm_compute; reflexivity).
  rewrite forallb_forall in all. apply Forall_forall. intros d found. apply all in found. apply existsb_exists in found.
  destruct found as (e & is_in & same). apply Z.eqb_eq in same. rewrite same. exact is_in.
Qed.

Theorem recorded_values_fit bits query : 1 <= bits <= 286 -> length query = 13%nat -> Forall (fun x => Z.abs x < 2 ^ (bits - 1)) query ->
  Forall2 (fun degree value => Z.abs value < 2 ^ (64 * recorded_words (size_for bits) (Z.of_nat degree) - 1))
    (map snd recorded_exact) (skipn 13 (run_Z query exact_program)).
Proof.
  intros span thirteen small. pose proof (span_is_held bits span) as held. unfold holds_span in held. cbv zeta in held.
  rewrite !andb_true_iff, Z.leb_le, forallb_forall in held. destruct held as [[size words] _].
  assert (Forall (fun x => Z.abs x < 2 ^ (size_for bits - 1)) query) as smaller.
  { eapply Forall_impl; [| exact small]. intros x below. cbn beta in *. eapply Z.lt_le_trans; [exact below |].
    apply Z.pow_le_mono_r; lia. }
  pose proof (exact_values_fit (size_for bits) query ltac:(lia) thirteen smaller) as fit. pose proof recorded_degrees as degrees.
  revert fit degrees. generalize (map snd recorded_exact) (skipn 13 (run_Z query exact_program)). intros l l' fit.
  induction fit as [| d v l l' one _ IH]; intros degrees; [constructor |]. apply Forall_cons_iff in degrees as [first rest].
  constructor; [| apply IH, rest]. eapply Z.lt_le_trans; [exact one |]. apply Z.pow_le_mono_r; [lia |].
  specialize (words _ first). apply Z.leb_le in words. lia.
Qed.
