(* The certified predicate's coarse step asked about the open sphere: the same program, with the same thresholds, is right.
   Where it says separated, every point is farther than r. Where it says contact, some comparison of each axis is certain
   to be less, a radius comparison strictly so, and a point is nearer than r. *)
From Coq Require Import Reals ZArith Bool Lra.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Exact Reduced Expression Format Run Filter Lanes Certified CertifiedStep Sizes CoarseFloat
  OpenSphere.
Open Scope R_scope.

(* Over rounding to nearest with gradual underflow. *)
Theorem coarse_contact_is_open prec emin least : coarse_never_lies prec emin least -> forall fused a b c p r,
  in_format prec emin a -> in_format prec emin b -> in_format prec emin c -> in_format prec emin p -> 0 <= r ->
  let rnd := round radix2 (FLT_exp emin prec) ZnearestE in
  let margin := coarse_margin rnd fused a b c p r in
  let threshold := coarse_threshold rnd fused (u prec) a b c p r in
  bpow radix2 least <= coarse_S rnd fused a b c p r ->
  ~ some_axis (fun K => margin K >= - threshold K) -> ~ separated_open a b c p r.
Proof.
  intros never fused a b c p r fa fb fc fp r0 rnd margin threshold large none apart.
  destruct (never fused a b c p r fa fb fc fp r0 large) as (near & _ & _). fold rnd margin threshold in near.
  apply none.
  assert (back : forall K, weak (reduced (sub a p) (sub b p) (sub c p) (r * r) K) -> margin K >= - threshold K).
  { intros K holds. pose proof (near K) as off. apply Rabs_le_inv in off. pose proof (margin_sign a b c p r K) as [_ weakly].
    assert (0 <= exact_margin a b c p r K) by (apply weakly; exact holds). lra. }
  apply (open_exact a b c p r r0) in apart. revert apart. apply some_axis_mono. intros K [holds _]. apply back, holds.
Qed.

(* Over IEEE-754 numbers, for any thirteen of them. *)
Definition float_coarse_never_lies_open (prec emax least half : Z) (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax)
  : Prop :=
  forall fused (a b c p : float_vec prec emax) (r : binary_float prec emax),
  let apart := separated_open (real_vec prec emax a) (real_vec prec emax b) (real_vec prec emax c) (real_vec prec emax p) (B2R r) in
  (float_separated prec emax _ _ fused least half a b c p r = true -> apart) /\
  (float_contact prec emax _ _ fused least half a b c p r = true -> ~ apart).

Lemma float_instance_open prec emax least half prec_gt_0_ prec_lt_emax_ :
  step_fits prec emax least half -> coarse_never_lies prec (3 - emax - prec) least ->
  float_coarse_never_lies_open prec emax least half prec_gt_0_ prec_lt_emax_.
Proof.
  intros fits never fused a b c p r apart. split.
  - intros says. apply separated_is_open.
    apply (float_instance prec emax least half prec_gt_0_ prec_lt_emax_ fits never fused a b c p r), says.
  - destruct fits as (p20 & half0 & fits & deep & least_range & constants).
    unfold float_contact. rewrite andb_true_iff, negb_true_iff. intros [inside none].
    destruct (range_spec prec emax _ _ fused least half a b c p r p20 half0 deep least_range constants inside)
      as (_ & _ & _ & low & r0).
    destruct (answers_are_the_programs prec emax _ _ fused least half a b c p r p20 half0 fits deep least_range constants inside)
      as (_ & _ & program).
    apply (coarse_contact_is_open prec (3 - emax - prec) least never fused); try assumption; try apply in_format_real.
    apply program, none.
Qed.

Theorem float_coarse_never_lies_open32 : float_coarse_never_lies_open 24 128 (-21) 19 eq_refl eq_refl.
Proof. apply float_instance_open; [apply step_fits32 | apply coarse_never_lies32]. Qed.
Theorem float_coarse_never_lies_open64 : float_coarse_never_lies_open 53 1024 (-300) 150 eq_refl eq_refl.
Proof. apply float_instance_open; [apply step_fits64 | apply coarse_never_lies64]. Qed.
