(* The filters and the certified predicate's coarse step do decide some queries: two queries, evaluated to the bit; and
   their answers at the edges of their domain. *)
From Coq Require Import ZArith.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Filter Filters CoarseFloat.
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
    f two = far /\ f four = near /\ f three = neither /\ f B754_nan = neither /\ f (B754_infinity false) = neither /\ f minus_two = neither in
  answers step32 (whole 24 128 _ _ 2) (whole 24 128 _ _ 4) (whole 24 128 _ _ 3) (whole 24 128 _ _ (-2)) /\
  answers step64 (whole 53 1024 _ _ 2) (whole 53 1024 _ _ 4) (whole 53 1024 _ _ 3) (whole 53 1024 _ _ (-2)).

Theorem coarse_step_decides : coarse_steps (true, false) (false, true) (false, false).
Proof. intros fused; destruct fused; vm_compute; repeat split. Qed.
