(* The subtraction of the certified predicate's pairs of doubles, operator- of
   kernel/sphere_triangle/certified/pairs-inl.h: over rounding to nearest with gradual underflow it meets the premise of
   Margins.v with u = 2^-102, and its leading double that of sign_of_leading. Two differences over IEEE-754 numbers show why
   these are the premises: an error relative to the operands, not to the difference, and a theorem of its own for the leading
   double. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core BinarySingleNaN Pff2Flocq.
From Axiscert Require Import Vectors Expression Format Filter Lanes Margins.
Open Scope R_scope.

(* Over reals: the leading number and the low one. *)
Section Rounded.
  Variable emin : Z.
  Hypothesis emin_negative : (emin <= 0)%Z.
  Notation format := (generic_format radix2 (FLT_exp emin 53)).
  Notation rnd := (round radix2 (FLT_exp emin 53) ZnearestE).
  Notation u := (u 53).
  Definition rounded_two_sum (x y : R) : R * R :=
    let sum := rnd (x + y) in let part := rnd (sum - x) in (sum, rnd (rnd (x - rnd (sum - part)) + rnd (y - part))).
  Definition rounded_pair_minus (x y : R * R) : R * R :=
    let s := rounded_two_sum (fst x) (- fst y) in rounded_two_sum (fst s) (rnd (rnd (snd x - snd y) + snd s)).
  (* As every operation on pairs leaves them. *)
  Definition is_pair (x : R * R) : Prop := format (fst x) /\ format (snd x) /\ Rabs (snd x) <= u * Rabs (fst x + snd x).

  Lemma u_value : u = / IZR (2 ^ 53).
  Proof using Type. reflexivity. Qed.
  Lemma rnd_format x : format (rnd x).
  Proof using Type. apply generic_format_round; [apply FLT_exp_valid; reflexivity | apply valid_rnd_N]. Qed.
  Lemma ties_to_even x : negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
  Proof using Type. rewrite Z.even_opp, Z.add_1_r, Z.even_succ, <- Z.negb_even. destruct (Z.even x); reflexivity. Qed.
  Lemma sum_error a b : format a -> format b -> Rabs (rnd (a + b) - (a + b)) <= u * Rabs (a + b).
  Proof using Type.
    intros Fa Fb. pose proof (generic_format_opp radix2 (FLT_exp emin 53) b Fb) as Fb'.
    pose proof (proj1 (Format.difference_error 53 emin ltac:(lia) a (- b) Fa Fb')) as off.
    replace (a - - b) with (a + b) in off by ring. exact off.
  Qed.

  (* The low number is what the sum's rounding loses. *)
  Lemma two_sum_exact x y : format x -> format y -> fst (rounded_two_sum x y) + snd (rounded_two_sum x y) = x + y.
  Proof using All.
    intros Fx Fy.
    exact (TwoSum_correct emin 53 (fun t => negb (Z.even t)) ltac:(lia) emin_negative ties_to_even x y Fx Fy).
  Qed.
  Lemma two_sum_is_pair x y : format x -> format y -> is_pair (rounded_two_sum x y).
  Proof using All.
    intros Fx Fy. pose proof (two_sum_exact x y Fx Fy) as exact. split; [apply rnd_format |]. split; [apply rnd_format |].
    rewrite exact. pose proof (sum_error x y Fx Fy) as off.
    replace (snd (rounded_two_sum x y)) with (- (rnd (x + y) - (x + y))) by (cbn [fst snd rounded_two_sum] in *; lra).
    rewrite Rabs_Ropp. exact off.
  Qed.

  Theorem pair_minus_near x y : is_pair x -> is_pair y -> let d := rounded_pair_minus x y in
    is_pair d /\ near_minus (/ IZR (2 ^ 102)) (fst x + snd x) (fst y + snd y) (fst d + snd d).
  Proof using All.
    destruct x as [X x], y as [Y y]. intros (FX & Fx & lx) (FY & Fy & ly). cbn [fst snd] in *.
    pose proof (generic_format_opp _ _ _ FY) as FY'. unfold rounded_pair_minus. cbn [fst snd].
    pose proof (two_sum_exact X (- Y) FX FY') as exact. destruct (two_sum_is_pair X (- Y) FX FY') as (Fs & Fl & ll).
    rewrite exact in ll. destruct (rounded_two_sum X (- Y)) as [s l]. cbn [fst snd] in *. cbv zeta.
    set (w := rnd (x - y)). set (v := rnd (w + l)). split; [apply two_sum_is_pair; [assumption | apply rnd_format] |].
    unfold near_minus. rewrite (two_sum_exact s v Fs (rnd_format (w + l))).
    pose proof (proj1 (Format.difference_error 53 emin ltac:(lia) x y Fx Fy)) as e1.
    change (Rabs (w - (x - y)) <= u * Rabs (x - y)) in e1.
    pose proof (sum_error w l (rnd_format _) Fl) as e2. fold v in e2.
    assert (0 < u <= / 1048576) as us by (rewrite u_value; cbn; lra).
    set (T := Rabs (X + x) + Rabs (Y + y)).
    pose proof (Rabs_pos (X + x)) as px. pose proof (Rabs_pos (Y + y)) as py.
    assert (uT : 0 <= u * T <= T / 1048576).
    { split; [apply Rmult_le_pos; unfold T; lra |]. assert (u * T <= / 1048576 * T) by (apply Rmult_le_compat_r; unfold T; lra). lra. }
    assert (Rabs (x - y) <= u * T) as b1.
    { unfold Rminus. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. unfold T. lra. }
    assert (Rabs (X + - Y) <= 1.00001 * T) as b2.
    { replace (X + - Y) with ((X + x) + - (Y + y) + (y - x)) by ring.
      eapply Rle_trans; [apply Rabs_triang |]. rewrite (Rabs_minus_sym y x).
      eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang |]. rewrite Rabs_Ropp. fold T. lra. }
    assert (u * Rabs (X + - Y) <= 1.00001 * (u * T)) as b3.
    { assert (u * Rabs (X + - Y) <= u * (1.00001 * T)) by (apply Rmult_le_compat_l; lra). lra. }
    assert (u * Rabs (x - y) <= u * (u * T)) as b4 by (apply Rmult_le_compat_l; lra).
    assert (u * (u * T) <= / 1048576 * (u * T)) as b5 by (apply Rmult_le_compat_r; lra).
    assert (Rabs (w + l) <= 2.001 * (u * T)) as b6.
    { replace (w + l) with ((w - (x - y)) + (x - y) + l) by ring. eapply Rle_trans; [apply Rabs_triang |].
      eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang |]. lra. }
    assert (u * Rabs (w + l) <= 2.001 * (u * (u * T))) as b7.
    { assert (u * Rabs (w + l) <= u * (2.001 * (u * T))) by (apply Rmult_le_compat_l; lra). lra. }
    assert (u * (u * T) * 16 = / IZR (2 ^ 102) * T) as unit.
    { rewrite u_value. cbn. field. }
    rewrite <- unit.
    replace (s + v - (X + x - (Y + y))) with ((v - (w + l)) + (w - (x - y)) + (s + l - (X + - Y))) by ring.
    replace (s + l - (X + - Y)) with 0 by lra. rewrite Rplus_0_r. eapply Rle_trans; [apply Rabs_triang |].
    lra.
  Qed.

  (* The premise of sign_of_leading. *)
  Theorem leading_near x : is_pair x -> Rabs (fst x - (fst x + snd x)) <= / 1048576 * Rabs (fst x + snd x).
  Proof using Type.
    intros (_ & _ & small). replace (fst x - (fst x + snd x)) with (- snd x) by ring. rewrite Rabs_Ropp.
    eapply Rle_trans; [exact small |]. apply Rmult_le_compat_r; [apply Rabs_pos |]. rewrite u_value. cbn. lra.
  Qed.
End Rounded.

Local Notation double := (binary_float 53 1024).
Local Notation plus := (Bplus (prec := 53) (emax := 1024) (prec_gt_0_ := eq_refl) (prec_lt_emax_ := eq_refl) mode_NE).
Local Notation minus := (Bminus (prec := 53) (emax := 1024) (prec_gt_0_ := eq_refl) (prec_lt_emax_ := eq_refl) mode_NE).

Record double_pair := DoublePair { pair_leading : double; pair_low : double }.
Definition pair_value (x : double_pair) := B2R (pair_leading x) + B2R (pair_low x).
Definition two_sum (x y : double) : double_pair :=
  let sum := plus x y in let part := minus sum x in DoublePair sum (plus (minus x (minus sum part)) (minus y part)).
Definition pair_minus (x y : double_pair) : double_pair :=
  let s := two_sum (pair_leading x) (Bopp (pair_leading y)) in
  two_sum (pair_leading s) (plus (minus (pair_low x) (pair_low y)) (pair_low s)).

(* The leading double is the one nearest to the pair. *)
Definition normalised (x : double_pair) : bool := Beqb (plus (pair_leading x) (pair_low x)) (pair_leading x).

(* A decision that a computation leaves small, whatever the number: it has no proof that a significand is bounded. *)
Definition is_zero (x : double) : bool := match x with B754_zero _ => true | _ => false end.
Lemma is_zero_value x : is_zero x = true -> B2R x = 0.
Proof. destruct x; (discriminate || reflexivity). Qed.

Definition at_exponent (n e : Z) : double := binary_normalize 53 1024 eq_refl eq_refl mode_NE n e false.

(* Two normalised pairs that differ by 2^-106, and whose difference is computed as zero: 1 + 2^-53 and 1 + 2^-53 + 2^-106.
   So the error of a difference is not a small multiple of the difference. *)
Theorem pair_minus_cancels : exists x y, normalised x = true /\ normalised y = true /\
  pair_value x - pair_value y = - / IZR (2 ^ 106) /\ pair_value (pair_minus x y) = 0 /\
  forall u, u < 1 -> ~ rounds u 0 (pair_value x - pair_value y) (pair_value (pair_minus x y)).
Proof.
  exists (DoublePair (at_exponent 1 0) (at_exponent 1 (-53))),
    (DoublePair (at_exponent (2 ^ 52 + 1) (-52)) (at_exponent (- (2 ^ 53 - 1)) (-106))).
  match goal with |- _ /\ _ /\ pair_value ?x - pair_value ?y = _ /\ _ => set (first := x); set (second := y) end.
  assert (pair_value first - pair_value second = - / IZR (2 ^ 106)) as differ.
  { unfold pair_value, first, second, pair_leading, pair_low. vm_compute B2R. unfold F2R. cbn [Fnum Fexp bpow]. vm_compute Z.pow_pos.
    vm_compute (2 ^ 106)%Z. lra. }
  assert (pair_value (pair_minus first second) = 0) as zero.
  { unfold pair_value. rewrite !is_zero_value by (vm_compute; reflexivity). lra. }
  split; [vm_compute; reflexivity |]. split; [vm_compute; reflexivity |]. split; [exact differ |].
  rewrite differ, zero. split; [reflexivity |].
  intros u small. unfold rounds.
  assert (0 < / IZR (2 ^ 106)) as positive by (apply Rinv_0_lt_compat, IZR_lt; reflexivity).
  rewrite Rabs_Ropp. replace (0 - - / IZR (2 ^ 106)) with (/ IZR (2 ^ 106)) by ring. rewrite Rabs_pos_eq by lra. nra.
Qed.

(* The leading double of a difference has the error of a double, whatever the pair's: 1 + 2^-60, the square of (1, 2^-30, 0),
   less 1/4. *)
Theorem leading_is_a_double : exists x y, normalised x = true /\ normalised y = true /\
  pair_value (pair_minus x y) = pair_value x - pair_value y /\
  ~ rounds (/ IZR (2 ^ 102)) 0 (pair_value x - pair_value y) (B2R (pair_leading (pair_minus x y))).
Proof.
  exists (DoublePair (at_exponent 1 0) (at_exponent 1 (-60))), (DoublePair (at_exponent 1 (-2)) (at_exponent 0 0)).
  match goal with |- _ /\ _ /\ pair_value (pair_minus ?x ?y) = _ /\ _ => set (first := x); set (second := y) end.
  assert (pair_value first - pair_value second = 3 / 4 + / IZR (2 ^ 60)) as differ.
  { unfold pair_value, first, second, pair_leading, pair_low. vm_compute B2R. unfold F2R. cbn [Fnum Fexp bpow]. vm_compute Z.pow_pos.
    vm_compute (2 ^ 60)%Z. lra. }
  assert (B2R (pair_leading (pair_minus first second)) = 3 / 4 /\ B2R (pair_low (pair_minus first second)) = / IZR (2 ^ 60)) as [head tail].
  { unfold first, second. split; vm_compute B2R; unfold F2R; cbn [Fnum Fexp bpow]; vm_compute Z.pow_pos; vm_compute (2 ^ 60)%Z; lra. }
  split; [vm_compute; reflexivity |]. split; [vm_compute; reflexivity |]. rewrite differ. unfold pair_value at 1. rewrite head, tail.
  split; [reflexivity |]. unfold rounds.
  assert (0 < / IZR (2 ^ 60)) as positive by (apply Rinv_0_lt_compat, IZR_lt; reflexivity).
  replace (3 / 4 - (3 / 4 + / IZR (2 ^ 60))) with (- / IZR (2 ^ 60)) by ring.
  rewrite Rabs_Ropp, !Rabs_pos_eq by lra. vm_compute (2 ^ 60)%Z. vm_compute (2 ^ 102)%Z. lra.
Qed.
