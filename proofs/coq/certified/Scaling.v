(* A number that is scaled by a power of two and back, each time rounded, and is then what it was, lost no bit on the way: how
   kernel/sphere_triangle/certified/range_step-inl.h sees that scaling is exact. What it does not give back it may still not have
   lost; then the step leaves the query alone. *)
From Coq Require Import Reals ZArith Lia.
From Flocq Require Import Core Mult_error.
Open Scope R_scope.

Section Scaling.
  Variables emin prec : Z.
  Context {prec_gt_0_ : Prec_gt_0 prec}.
  Notation format := (generic_format radix2 (FLT_exp emin prec)).
  Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).

  Theorem scaled_back_is_exact x e : format x -> rnd (rnd (x * bpow radix2 e) * bpow radix2 (- e)) = x ->
    rnd (x * bpow radix2 e) = x * bpow radix2 e.
  Proof using prec_gt_0_.
    intros in_format back. destruct (Z_le_gt_dec 0 e) as [up | down].
    - apply round_generic; [apply valid_rnd_N |]. apply mult_bpow_pos_exact_FLT; assumption.
    - rewrite (round_generic _ _ _ (rnd (x * bpow radix2 e) * bpow radix2 (- e))) in back.
      + rewrite <- back at 2. rewrite Rmult_assoc, <- bpow_plus. replace (- e + e)%Z with 0%Z by lia. rewrite Rmult_1_r. reflexivity.
      + apply mult_bpow_pos_exact_FLT; [| lia]. apply generic_format_round; [apply FLT_exp_valid; assumption | apply valid_rnd_N].
  Qed.
End Scaling.
