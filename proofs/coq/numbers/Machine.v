(* The operations that a recorded step of the certified predicate (RecordedCertified.v) is made of, and two machines that
   have them: IEEE-754 numbers, and reals with a rounding. *)
From Coq Require Import ZArith Reals Bool Lra.
From Flocq Require Import Core BinarySingleNaN.

Record machine := Machine {
  m_number : Type;
  m_zero : m_number;
  m_infinity : m_number;
  m_constant : Z -> Z -> m_number;  (* n 2^e *)
  m_negate : m_number -> m_number;
  m_magnitude : m_number -> m_number;
  m_add : m_number -> m_number -> m_number;
  m_subtract : m_number -> m_number -> m_number;
  m_multiply : m_number -> m_number -> m_number;
  m_divide : m_number -> m_number -> m_number;
  m_fused : m_number -> m_number -> m_number -> m_number;  (* x y + z, rounded once *)
  m_least : m_number -> m_number -> m_number;
  m_greatest : m_number -> m_number -> m_number;
  m_with_sign : m_number -> m_number -> m_number;  (* the magnitude of the first, the sign of the second *)
  m_inverse_power : m_number -> m_number;  (* 2^-e for x in [2^e, 2^(e + 1)), from the bits of x *)
  m_less : m_number -> m_number -> bool;
  m_at_most : m_number -> m_number -> bool;
  m_equal : m_number -> m_number -> bool
}.

(* IEEE-754 numbers. Instruction sets differ in which zero, and which operand beside a NaN, is the least: so `least` and
   `greatest` are any functions, of which theorems assume what all have. So is `inverse_power`. *)
Section Float.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Variables (least greatest : float -> float -> float) (inverse_power : float -> float).
  Definition float_machine : machine := {|
    m_number := float;
    m_zero := B754_zero false;
    m_infinity := B754_infinity false;
    m_constant := fun n e => binary_normalize prec emax _ _ mode_NE n e false;
    m_negate := Bopp;
    m_magnitude := Babs;
    m_add := Bplus mode_NE;
    m_subtract := Bminus mode_NE;
    m_multiply := Bmult mode_NE;
    m_divide := Bdiv mode_NE;
    m_fused := Bfma mode_NE;
    m_least := least;
    m_greatest := greatest;
    m_with_sign := fun x y => if Bsign y then Bopp (Babs x) else Babs x;
    m_inverse_power := inverse_power;
    m_less := Bltb;
    m_at_most := Bleb;
    m_equal := Beqb
  |}.
  (* The least and the greatest of two numbers that are not NaN, infinities included; of NaNs instruction sets differ. *)
  Definition is_least : Prop := forall x y, is_nan x = false -> is_nan y = false ->
    (least x y = x /\ Bleb x y = true) \/ (least x y = y /\ Bleb y x = true).
  Definition is_greatest : Prop := forall x y, is_nan x = false -> is_nan y = false ->
    (greatest x y = x /\ Bleb y x = true) \/ (greatest x y = y /\ Bleb x y = true).
  (* 2^-e for x in [2^e, 2^(e + 1)) from the least normal number up to below half the greatest power of two. *)
  Definition is_inverse_power : Prop := forall x, (bpow radix2 (2 - emax) <= B2R x < bpow radix2 (emax - 1))%R ->
    is_finite (inverse_power x) = true /\ B2R (inverse_power x) = bpow radix2 (1 - mag radix2 (B2R x)).

  Lemma finite_not_nan (x : float) : is_finite x = true -> is_nan x = false.
  Proof using Type. destruct x; cbn; congruence. Qed.
  Lemma at_most_of_finite (x y : float) : is_finite x = true -> is_finite y = true -> Bleb x y = true -> (B2R x <= B2R y)%R.
  Proof using Type. intros Fx Fy. rewrite Bleb_correct by assumption. case Rle_bool_spec; [auto | discriminate]. Qed.
  Lemma least_of_finite : is_least -> forall x y, is_finite x = true -> is_finite y = true ->
    is_finite (least x y) = true /\ B2R (least x y) = Rmin (B2R x) (B2R y).
  Proof using Type.
    intros H x y Fx Fy. destruct (H x y (finite_not_nan x Fx) (finite_not_nan y Fy)) as [[-> le] | [-> le]];
      apply at_most_of_finite in le; try assumption; (split; [assumption |]); unfold Rmin; destruct Rle_dec; lra.
  Qed.
  Lemma greatest_of_finite : is_greatest -> forall x y, is_finite x = true -> is_finite y = true ->
    is_finite (greatest x y) = true /\ B2R (greatest x y) = Rmax (B2R x) (B2R y).
  Proof using Type.
    intros H x y Fx Fy. destruct (H x y (finite_not_nan x Fx) (finite_not_nan y Fy)) as [[-> le] | [-> le]];
      apply at_most_of_finite in le; try assumption; (split; [assumption |]); unfold Rmax; destruct Rle_dec; lra.
  Qed.
End Float.

Definition less_real (x y : R) : bool := if Rlt_dec x y then true else false.
Definition at_most_real (x y : R) : bool := if Rle_dec x y then true else false.
Definition equal_real (x y : R) : bool := if Req_EM_T x y then true else false.

(* Reals, every operation rounded. There is no infinity; no theorem over these numbers uses it. *)
Definition real_machine (rnd : R -> R) : machine := {|
  m_number := R;
  m_zero := 0%R;
  m_infinity := 0%R;
  m_constant := fun n e => (IZR n * bpow radix2 e)%R;
  m_negate := Ropp;
  m_magnitude := Rabs;
  m_add := fun x y => rnd (x + y)%R;
  m_subtract := fun x y => rnd (x - y)%R;
  m_multiply := fun x y => rnd (x * y)%R;
  m_divide := fun x y => rnd (x / y)%R;
  m_fused := fun x y z => rnd (x * y + z)%R;
  m_least := Rmin;
  m_greatest := Rmax;
  m_with_sign := fun x y => if Rlt_dec y 0 then (- Rabs x)%R else Rabs x;
  m_inverse_power := fun x => bpow radix2 (1 - mag radix2 x);
  m_less := less_real;
  m_at_most := at_most_real;
  m_equal := equal_real
|}.
