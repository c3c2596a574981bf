(* The subtraction of the certified predicate's pairs of doubles, operator- of
   kernel/sphere_triangle/certified/numbers/pairs-inl.h, over IEEE-754 numbers, and two queries of it that show why the
   theorems of Margins.v have the premises that they have: an error relative to the operands, not to the difference, and a
   theorem of its own for the leading double that is compared (sign_of_leading). *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Filter Lanes Margins.
Open Scope R_scope.

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
  assert (pair_minus first second = DoublePair (B754_zero false) (B754_zero false)) as zero by (vm_compute; reflexivity).
  split; [vm_compute; reflexivity |]. split; [vm_compute; reflexivity |]. split; [exact differ |].
  rewrite differ, zero. unfold pair_value. cbn [pair_leading pair_low B2R]. split; [lra |].
  intros u small. unfold rounds.
  assert (0 < / IZR (2 ^ 106)) as positive by (apply Rinv_0_lt_compat, IZR_lt; reflexivity).
  rewrite Rabs_Ropp. replace (0 + 0 - - / IZR (2 ^ 106)) with (/ IZR (2 ^ 106)) by ring. rewrite Rabs_pos_eq by lra. nra.
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
