(* The steps of the certified predicate that pass triangles over by the faces of the sphere's box:
   kernel/sphere_triangle/certified/box_step-inl.h and outcodes-inl.h. The ends of the box are p - r and p + r, rounded or
   overflown; a vertex that is beyond such an end is beyond the exact one, because its coordinate is a number of the format. *)
From Coq Require Import Reals ZArith Bool List Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Filter OpenSphere.
Open Scope R_scope.

Inductive face := low_x | high_x | low_y | high_y | low_z | high_z.

(* Over the reals: the vertices beyond a face of the box about P with half the side r. *)
Definition beyond_exactly (P : vec) (r : R) (f : face) (X : vec) : Prop :=
  match f with
  | low_x => cx X < cx P - r | high_x => cx X > cx P + r
  | low_y => cy X < cy P - r | high_y => cy X > cy P + r
  | low_z => cz X < cz P - r | high_z => cz X > cz P + r
  end.

Theorem beyond_is_separated A B C P r f : 0 <= r ->
  beyond_exactly P r f A -> beyond_exactly P r f B -> beyond_exactly P r f C -> separated A B C P r.
Proof.
  intros r0 a b c X (u & v & w & u0 & v0 & w0 & sum & ->).
  assert (least : forall x y z t, x < t -> y < t -> z < t -> x * u + y * v + z * w < t).
  { intros x y z t xt yt zt. replace t with (t * u + t * v + t * w) by (replace w with (1 - u - v) by lra; ring).
    destruct (Rle_lt_or_eq_dec 0 u u0) as [u1 | <-]; [nra |]. destruct (Rle_lt_or_eq_dec 0 v v0) as [v1 | <-]; nra. }
  assert (greatest : forall x y z t, t < x -> t < y -> t < z -> t < x * u + y * v + z * w).
  { intros x y z t xt yt zt. pose proof (least (- x) (- y) (- z) (- t) ltac:(lra) ltac:(lra) ltac:(lra)). lra. }
  assert (far : forall d s, r < d \/ d < - r -> d * d <= s -> r < sqrt s).
  { intros d s away square. apply Rlt_le_trans with (Rabs d); [unfold Rabs; destruct Rcase_abs; lra |].
    rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. exact square. }
  destruct A as [a1 a2 a3], B as [b1 b2 b3], C as [c1 c2 c3], P as [p1 p2 p3].
  unfold distance, combination, add, sub, scale, dot; cbn [cx cy cz].
  set (d1 := p1 - (a1 * u + b1 * v + c1 * w)). set (d2 := p2 - (a2 * u + b2 * v + c2 * w)). set (d3 := p3 - (a3 * u + b3 * v + c3 * w)).
  pose proof (Rle_0_sqr d1). pose proof (Rle_0_sqr d2). pose proof (Rle_0_sqr d3). unfold Rsqr in *.
  destruct f; cbn [beyond_exactly cx cy cz] in *.
  - apply (far d1); [left; pose proof (least a1 b1 c1 (p1 - r) a b c); unfold d1; lra | lra].
  - apply (far d1); [right; pose proof (greatest a1 b1 c1 (p1 + r) a b c); unfold d1; lra | lra].
  - apply (far d2); [left; pose proof (least a2 b2 c2 (p2 - r) a b c); unfold d2; lra | lra].
  - apply (far d2); [right; pose proof (greatest a2 b2 c2 (p2 + r) a b c); unfold d2; lra | lra].
  - apply (far d3); [left; pose proof (least a3 b3 c3 (p3 - r) a b c); unfold d3; lra | lra].
  - apply (far d3); [right; pose proof (greatest a3 b3 c3 (p3 + r) a b c); unfold d3; lra | lra].
Qed.

(* Over IEEE-754 numbers. *)
Section Float.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Notation real_vec := (real_vec prec emax).

  Definition is_finite_vec (v : float_vec) : bool := is_finite (fx _ _ v) && is_finite (fy _ _ v) && is_finite (fz _ _ v).
  (* A sphere that is not valid has a box with no outside. *)
  Definition is_sphere (p : float_vec) (r : float) : bool := is_finite_vec p && is_finite r && Bleb (B754_zero false) r.
  Definition box_low (valid : bool) (p r : float) : float := if valid then Bminus mode_NE p r else B754_infinity true.
  Definition box_high (valid : bool) (p r : float) : float := if valid then Bplus mode_NE p r else B754_infinity false.
  (* The bit of a vertex's outcode for a face. *)
  Definition beyond (p : float_vec) (r : float) (f : face) (v : float_vec) : bool :=
    is_finite_vec v &&
    let low x q := Bltb x (box_low (is_sphere p r) q r) in let high x q := Bltb (box_high (is_sphere p r) q r) x in
    match f with
    | low_x => low (fx _ _ v) (fx _ _ p) | high_x => high (fx _ _ v) (fx _ _ p)
    | low_y => low (fy _ _ v) (fy _ _ p) | high_y => high (fy _ _ v) (fy _ _ p)
    | low_z => low (fz _ _ v) (fz _ _ p) | high_z => high (fz _ _ v) (fz _ _ p)
    end.

  Lemma not_below_minus_infinity (x : float) : Bltb x (B754_infinity true) = false.
  Proof using Type. destruct x as [[] | [] | | []]; reflexivity. Qed.
  Lemma not_above_infinity (x : float) : Bltb (B754_infinity false) x = false.
  Proof using Type. destruct x as [[] | [] | | []]; reflexivity. Qed.

  Lemma infinity_of (x : float) s : B2SF x = SpecFloat.S754_infinity s -> x = B754_infinity s.
  Proof using Type. destruct x; cbn; congruence. Qed.
  Lemma negative_zero (r : float) : is_finite r = true -> 0 <= B2R r -> Bsign r = true -> B2R r = 0.
  Proof using Type.
    destruct r as [| | | s m e bounds]; cbn; try reflexivity; try discriminate. intros _ r0 ->. exfalso.
    assert (F2R (Float radix2 (Zneg m) e) < 0) by (apply F2R_lt_0; reflexivity). cbn in *. lra.
  Qed.
  Lemma number_fits (x : float) : is_finite x = true ->
    Rlt_bool (Rabs (round radix2 (SpecFloat.fexp prec emax) ZnearestE (B2R x))) (bpow radix2 emax) = true.
  Proof using Type.
    intros F. rewrite round_generic; [apply Rlt_bool_true, abs_B2R_lt_emax | apply valid_rnd_N | apply generic_format_B2R].
  Qed.

  Lemma below_the_box (x p r : float) : is_finite x = true -> is_finite p = true -> is_finite r = true -> 0 <= B2R r ->
    Bltb x (Bminus mode_NE p r) = true -> B2R x < B2R p - B2R r.
  Proof using Type.
    intros Fx Fp Fr r0 less. pose proof (Bminus_correct prec emax _ _ mode_NE p r Fp Fr) as correct.
    destruct Rlt_bool eqn:fits.
    - destruct correct as (value & F & _). rewrite Bltb_correct, value in less by assumption. revert less.
      case Rlt_bool_spec; [intros less _ | discriminate]. apply Rnot_le_lt. intros above.
      apply (round_le radix2 (SpecFloat.fexp prec emax) ZnearestE) in above.
      rewrite (round_generic _ _ _ (B2R x)) in above by apply generic_format_B2R. cbn [round_mode] in less. lra.
    - destruct correct as [overflow sign]. exfalso.
      destruct (Bsign r) eqn:negative.
      + rewrite (negative_zero r Fr r0 negative), Rminus_0_r in fits. cbn [round_mode] in fits.
        rewrite number_fits in fits; [discriminate | assumption].
      + rewrite sign in overflow. apply infinity_of in overflow. rewrite overflow, not_below_minus_infinity in less. discriminate.
  Qed.
  Lemma above_the_box (x p r : float) : is_finite x = true -> is_finite p = true -> is_finite r = true -> 0 <= B2R r ->
    Bltb (Bplus mode_NE p r) x = true -> B2R x > B2R p + B2R r.
  Proof using Type.
    intros Fx Fp Fr r0 less. pose proof (Bplus_correct prec emax _ _ mode_NE p r Fp Fr) as correct.
    destruct Rlt_bool eqn:fits.
    - destruct correct as (value & F & _). rewrite Bltb_correct, value in less by assumption. revert less.
      case Rlt_bool_spec; [intros less _ | discriminate]. apply Rnot_le_lt. intros above.
      apply (round_le radix2 (SpecFloat.fexp prec emax) ZnearestE) in above.
      rewrite (round_generic _ _ _ (B2R x)) in above by apply generic_format_B2R. cbn [round_mode] in less. lra.
    - destruct correct as [overflow sign]. exfalso.
      destruct (Bsign r) eqn:negative.
      + rewrite (negative_zero r Fr r0 negative), Rplus_0_r in fits. cbn [round_mode] in fits.
        rewrite number_fits in fits; [discriminate | assumption].
      + rewrite sign in overflow. apply infinity_of in overflow. rewrite overflow, not_above_infinity in less. discriminate.
  Qed.

  Lemma beyond_spec p r f v : beyond p r f v = true ->
    is_finite_vec v = true /\ is_sphere p r = true /\ 0 <= B2R r /\ beyond_exactly (real_vec p) (B2R r) f (real_vec v).
  Proof using Type.
    unfold beyond. rewrite andb_true_iff. intros [Fv is_beyond]. split; [assumption |].
    destruct (is_sphere p r) eqn:valid; cbn [box_low box_high] in is_beyond.
    2: { exfalso. destruct f; rewrite ?not_below_minus_infinity, ?not_above_infinity in is_beyond; discriminate. }
    split; [reflexivity |]. pose proof valid as parts.
    unfold is_sphere, is_finite_vec in parts, Fv. rewrite !andb_true_iff in parts. rewrite !andb_true_iff in Fv.
    destruct parts as ((((Fpx & Fpy) & Fpz) & Fr) & nonneg), Fv as ((Fx & Fy) & Fz).
    assert (0 <= B2R r) as r0.
    { rewrite Bleb_correct in nonneg by auto. revert nonneg. case Rle_bool_spec; [intros; assumption | discriminate]. }
    split; [assumption |].
    destruct f; cbn [beyond_exactly Filter.real_vec cx cy cz]; first [apply below_the_box | apply above_the_box]; assumption.
  Qed.

  (* A triangle is passed over where all vertices of a set that contains its own are beyond some face: its own three, or those
     between the least and the greatest of a chunk. *)
  Theorem passed_over_is_separated p r f vertices a b c : forallb (beyond p r f) vertices = true ->
    In a vertices -> In b vertices -> In c vertices ->
    is_sphere p r = true /\ is_finite_vec a = true /\ is_finite_vec b = true /\ is_finite_vec c = true /\
    separated (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) /\
    separated_open (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r).
  Proof using Type.
    intros all ina inb inc. rewrite forallb_forall in all.
    destruct (beyond_spec _ _ _ _ (all a ina)) as (Fa & valid & r0 & A).
    destruct (beyond_spec _ _ _ _ (all b inb)) as (Fb & _ & _ & B), (beyond_spec _ _ _ _ (all c inc)) as (Fc & _ & _ & C).
    assert (separated (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r)) as apart
      by exact (beyond_is_separated _ _ _ _ _ f r0 A B C).
    repeat (split; [assumption |]). apply separated_is_open, apart.
  Qed.
End Float.
