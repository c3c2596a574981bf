(* The filters, the certified predicate's coarse step and the conservative test do decide some queries: two queries, evaluated to
   the bit; and their answers at the edges of their domain. *)
From Coq Require Import ZArith Reals Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Filter Filters CoarseFloat Machine ConservativeProgram ConservativeFloat InversePower.
Import ListNotations.
Open Scope Z_scope.

Section Queries.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Definition whole (n : Z) : binary_float prec emax := binary_normalize prec emax _ _ mode_NE n 0 false.
  Definition at_point (x y z : Z) := FloatVec prec emax (whole x) (whole y) (whole z).
  (* The triangle (1,1,4) (3,1,4) (1,3,4), and a sphere about (1,1,1). *)
  Definition above (r : binary_float prec emax) :=
    FloatQuery prec emax (at_point 1 1 4) (at_point 3 1 4) (at_point 1 3 4) (at_point 1 1 1) r.
End Queries.

Definition all_filters (far near touching nan infinite negative : answer) : Prop :=
  forall fused,
  let on32 filter r := filter (above 24 128 _ _ r) in
  let on64 filter r := filter (above 53 1024 _ _ r) in
  let answers {prec emax} (f : binary_float prec emax -> answer) (two four three minus_one : binary_float prec emax) :=
    f two = far /\ f four = near /\ f three = touching /\ f B754_nan = nan /\ f (B754_infinity false) = infinite /\
    f minus_one = negative in
  let numbers32 f := answers f (whole 24 128 _ _ 2) (whole 24 128 _ _ 4) (whole 24 128 _ _ 3) (whole 24 128 _ _ (-1)) in
  let numbers64 f := answers f (whole 53 1024 _ _ 2) (whole 53 1024 _ _ 4) (whole 53 1024 _ _ 3) (whole 53 1024 _ _ (-1)) in
  numbers32 (on32 (published_filter32 fused)) /\ numbers32 (on32 (reduced_filter32 fused)) /\
  numbers64 (on64 (published_filter64 fused)) /\ numbers64 (on64 (reduced_filter64 fused)).

Theorem filters_decide :
  all_filters answer_separated answer_contact answer_undecided answer_undecided answer_undecided answer_undecided.
Proof. intros fused; destruct fused; vm_compute; repeat split. Qed.

(* The answers for separated and contact; then for the tangent sphere and for invalid radii. *)
Definition coarse_steps (far near neither : bool * bool) : Prop :=
  forall fused,
  let step32 r := let q := above 24 128 _ _ r in
    (float_separated 24 128 _ _ fused (-21) 19 (fa _ _ q) (fb _ _ q) (fc _ _ q) (fp _ _ q) r,
     float_contact 24 128 _ _ fused (-21) 19 (fa _ _ q) (fb _ _ q) (fc _ _ q) (fp _ _ q) r) in
  let step64 r := let q := above 53 1024 _ _ r in
    (float_separated 53 1024 _ _ fused (-300) 150 (fa _ _ q) (fb _ _ q) (fc _ _ q) (fp _ _ q) r,
     float_contact 53 1024 _ _ fused (-300) 150 (fa _ _ q) (fb _ _ q) (fc _ _ q) (fp _ _ q) r) in
  let answers {prec emax} f (two four three minus_two : binary_float prec emax) :=
    f two = far /\ f four = near /\ f three = neither /\ f B754_nan = neither /\ f (B754_infinity false) = neither /\
      f minus_two = neither in
  answers step32 (whole 24 128 _ _ 2) (whole 24 128 _ _ 4) (whole 24 128 _ _ 3) (whole 24 128 _ _ (-2)) /\
  answers step64 (whole 53 1024 _ _ 2) (whole 53 1024 _ _ 4) (whole 53 1024 _ _ 3) (whole 53 1024 _ _ (-2)).

Theorem coarse_step_decides : coarse_steps (true, false) (false, true) (false, false).
Proof. intros fused; destruct fused; vm_compute; repeat split. Qed.

(* The least and the greatest by their order, which are what the theorems of recorded steps ask for. *)
Section Order.
  Variables prec emax : Z.
  Notation float := (binary_float prec emax).
  Definition least_by_order (x y : float) : float := if Bleb x y then x else y.
  Definition greatest_by_order (x y : float) : float := if Bleb x y then y else x.
  Lemma order_is_total (x y : float) : is_nan x = false -> is_nan y = false -> Bleb x y = false -> Bleb y x = true.
  Proof using Type.
    intros nx ny. destruct (is_finite x && is_finite y) eqn:finite.
    - apply andb_prop in finite as [Fx Fy]. rewrite !Bleb_correct by assumption. intros beyond. apply Rle_bool_true. revert beyond.
      case Rle_bool_spec; [discriminate |]. intros H _. apply Rlt_le, H.
    - destruct x as [| [] | |], y as [| [] | |]; cbn in *; congruence.
  Qed.
  Lemma order_gives_least : is_least prec emax least_by_order /\ is_greatest prec emax greatest_by_order.
  Proof using Type.
    split; intros x y nx ny; [unfold least_by_order | unfold greatest_by_order]; pose proof (order_is_total x y nx ny);
      destruct (Bleb x y) eqn:H'; auto.
  Qed.
End Order.

(* The conservative test's two answers, separated and unknown: for separated, for contact and for the tangent sphere, and for invalid
   radii. *)
Definition conservative_steps (far near unknown : list bool) : Prop :=
  let step32 r := let q := above 24 128 _ _ r in float_answers 24 128 (-42) 30 (-60) _ _ (least_by_order 24 128) (greatest_by_order 24 128)
    inverse_power32 (fa _ _ q) (fb _ _ q) (fc _ _ q) (fp _ _ q) r in
  let step64 r := let q := above 53 1024 _ _ r in float_answers 53 1024 (-400) 200 (-120) _ _ (least_by_order 53 1024)
    (greatest_by_order 53 1024)
    inverse_power64 (fa _ _ q) (fb _ _ q) (fc _ _ q) (fp _ _ q) r in
  let answers {prec emax} f (two four three minus_two : binary_float prec emax) :=
    f two = far /\ f four = near /\ f three = near /\ f B754_nan = unknown /\ f (B754_infinity false) = unknown /\ f minus_two = unknown in
  answers step32 (whole 24 128 _ _ 2) (whole 24 128 _ _ 4) (whole 24 128 _ _ 3) (whole 24 128 _ _ (-2)) /\
  answers step64 (whole 53 1024 _ _ 2) (whole 53 1024 _ _ 4) (whole 53 1024 _ _ 3) (whole 53 1024 _ _ (-2)).
Theorem conservative_step_decides : conservative_steps [true; false] [false; false] [false; true].
Proof. vm_compute; repeat split. Qed.
