(* The power of two that the conservative test scales V by comes from the bits of W: twice the bias of the exponents less W's
   exponent, in place. It is 2^-e for W in [2^e, 2^(e + 1)). *)
From Coq Require Import Reals ZArith Bool Lra Lia.
From Flocq Require Import Core Binary Bits BinarySingleNaN.
From Axiscert Require Import Machine.
Open Scope R_scope.

Section Bits.
  Variables mw ew : Z.  (* the widths of the mantissa, without its first bit, and of the exponent *)
  Let prec := (mw + 1)%Z.
  Let emax := (2 ^ (ew - 1))%Z.
  Hypothesis mw_positive : (0 < mw)%Z.
  Hypothesis ew_positive : (0 < ew)%Z.
  Hypothesis prec_emax : (prec < emax)%Z.
  Let one_more : (0 < prec)%Z. Proof using emax mw_positive. unfold prec. lia. Qed.
  Notation emin := (3 - emax - prec)%Z.
  Notation of_bits := (binary_float_of_bits mw ew mw_positive ew_positive prec_emax).
  Notation bits := (bits_of_binary_float mw ew).

  Lemma exponents : (2 ^ ew = 2 * emax)%Z.
  Proof using ew_positive prec. unfold emax. replace ew with (1 + (ew - 1))%Z at 1 by lia. rewrite Z.pow_add_r by lia. reflexivity. Qed.
  (* A number whose bits are those of an exponent alone is a power of two. *)
  Lemma power_from_bits e : (1 <= e <= 2 * emax - 2)%Z -> let x := of_bits (e * 2 ^ mw) in
    Binary.is_finite _ _ x = true /\ Binary.B2R _ _ x = bpow radix2 (e + mw + emin - 1).
  Proof using Type.
    intros range x. pose proof exponents as twice. assert (0 < 2 ^ mw)%Z as m0 by (apply Z.pow_pos_nonneg; lia).
    assert (split_bits mw ew (e * 2 ^ mw) = (false, 0%Z, e)) as split_up.
    { replace (e * 2 ^ mw)%Z with (join_bits mw ew false 0 e) by (unfold join_bits; rewrite Z.shiftl_mul_pow2 by lia; ring).
      apply split_join_bits; lia. }
    assert (B2FF _ _ x = F754_finite false (Z.to_pos (2 ^ mw)) (e + emin - 1)) as value.
    { unfold x, binary_float_of_bits. rewrite B2FF_FF2B. unfold binary_float_of_bits_aux. rewrite split_up.
      rewrite Zeq_bool_false, Zeq_bool_false by lia. rewrite Z.add_0_l. destruct (2 ^ mw)%Z; try lia. reflexivity. }
    clearbody x. assert (e + emin - 1 = e + mw + emin - 1 - mw)%Z as below by ring.
    rewrite below in value. set (sum := (e + mw + emin - 1)%Z) in *. clearbody sum.
    destruct x as [| | | s m e' inside]; cbn [B2FF] in value; try discriminate. injection value as -> -> ->.
    split; [reflexivity |]. cbn [Binary.B2R cond_Zopp]. unfold F2R. cbn [Fnum Fexp]. rewrite Z2Pos.id by assumption.
    change (2 ^ mw)%Z with (Zpower radix2 mw). rewrite IZR_Zpower by lia. rewrite <- bpow_plus. f_equal. ring.
  Qed.

  Variable nan : { x : Binary.binary_float prec emax | Binary.is_nan prec emax x = true }.
  Definition inverse_power_of_bits (twice_bias exponent : Z) (x : binary_float prec emax) : binary_float prec emax :=
    B2BSN prec emax (of_bits (twice_bias - Z.land (bits (BSN2B prec emax nan x)) exponent)).
  Theorem bits_give_inverse_power twice_bias exponent : twice_bias = ((2 * emax - 2) * 2 ^ mw)%Z ->
    exponent = ((2 * emax - 1) * 2 ^ mw)%Z ->
    is_inverse_power prec emax (inverse_power_of_bits twice_bias exponent).
  Proof using Type.
    intros -> -> x range. unfold inverse_power_of_bits. rewrite is_finite_B2BSN, B2R_B2BSN. rewrite <- (B2R_BSN2B _ _ nan x) in *.
    set (y := BSN2B prec emax nan x) in *. clearbody y. pose proof exponents as twice.
    assert (0 < 2 ^ mw)%Z as m0 by (apply Z.pow_pos_nonneg; lia).
    pose proof (bpow_gt_0 radix2 (2 - emax)) as low.
    destruct y as [s | s | s payload is_one | [|] m e inside]; try (cbn [Binary.B2R] in range; lra).
    { exfalso. cbn [Binary.B2R cond_Zopp Z.opp] in range. pose proof (F2R_le_0 radix2 (Float radix2 (Z.neg m) e) ltac:(cbn; lia)) as below.
      lra. }
    cbn [Binary.B2R cond_Zopp] in range |- *.
    assert (mag radix2 (F2R (Float radix2 (Z.pos m) e)) = Zdigits radix2 (Z.pos m) + e :> Z)%Z as size by (apply mag_F2R_Zdigits; lia).
    set (v := F2R (Float radix2 (Z.pos m) e)) in *.
    assert (2 - emax < mag radix2 v <= emax - 1)%Z as (least & greatest).
    { split; [apply mag_gt_bpow | apply mag_le_bpow; [lra |]]; rewrite Rabs_pos_eq by lra; lra. }
    pose proof inside as canonical. apply andb_prop in canonical as [canonical _]. apply Zeq_bool_eq in canonical.
    rewrite Zpos_digits2_pos in canonical.
    unfold SpecFloat.fexp, SpecFloat.emin in canonical.
    assert (Zdigits radix2 (Z.pos m) = prec) as digits by lia.
    assert (2 ^ mw <= Z.pos m < 2 * 2 ^ mw)%Z as (m_low & m_high).
    { pose proof (Zdigits_correct radix2 (Z.pos m)) as H. rewrite digits in H. unfold prec in H. replace (mw + 1 - 1)%Z with mw in H by lia.
      change (Zpower radix2 mw) with (2 ^ mw)%Z in H. change (Zpower radix2 (mw + 1)) with (2 ^ (mw + 1))%Z in H.
      rewrite Z.pow_add_r in H by lia. cbn [Z.abs] in H. lia. }
    assert (Z.land (bits (Binary.B754_finite prec emax false m e inside)) ((2 * emax - 1) * 2 ^ mw) = (e - emin + 1) * 2 ^ mw)%Z as masked.
    { cbn [bits_of_binary_float]. fold prec emax. unfold SpecFloat.emin. rewrite Zle_bool_true by lia.
      unfold join_bits. rewrite Z.shiftl_mul_pow2 by lia. rewrite Z.add_0_l.
      set (E := (e - emin + 1)%Z). assert (0 <= E < 2 ^ ew)%Z as E_range by (unfold E; lia).
      rewrite <- !Z.shiftl_mul_pow2 by lia. replace (2 * emax - 1)%Z with (Z.ones ew) by (rewrite Z.ones_equiv; lia).
      apply Z.bits_inj'. intros n n0. rewrite Z.land_spec. destruct (Z_lt_le_dec n mw) as [small | large].
      - rewrite !(Z.shiftl_spec_low _ _ n) by assumption. apply andb_false_r.
      - rewrite (Z.shiftl_spec (Z.ones ew)), (Z.shiftl_spec E) by assumption.
        replace (Z.testbit (Z.shiftl E mw + (Z.pos m - 2 ^ mw)) n) with (Z.testbit E (n - mw)).
        + destruct (Z_lt_le_dec (n - mw) ew) as [inner | outer].
          * rewrite Z.ones_spec_low by lia. apply andb_true_r.
          * rewrite Z.ones_spec_high by lia. rewrite andb_false_r. symmetry. destruct (Z.eq_dec E 0) as [-> | E0]; [apply Z.bits_0 |].
            apply Z.bits_above_log2; [lia |]. apply Z.log2_lt_pow2; [lia |]. eapply Z.lt_le_trans; [apply E_range |].
            apply Z.pow_le_mono_r; lia.
        + replace (Z.shiftl E mw + (Z.pos m - 2 ^ mw))%Z with (Z.pos m - 2 ^ mw + E * 2 ^ mw)%Z by (rewrite Z.shiftl_mul_pow2 by lia; ring).
          replace n with (n - mw + mw)%Z at 2 by lia. rewrite <- Z.shiftr_spec by lia.
          rewrite Z.shiftr_div_pow2, Z.div_add, Z.div_small by lia.
          rewrite Z.add_0_l. reflexivity. }
    rewrite masked, <- Z.mul_sub_distr_r. destruct (power_from_bits (2 * emax - 2 - (e - emin + 1))) as [finite value]; [lia |].
    split; [exact finite |]. eapply eq_trans; [exact value |]. f_equal. lia.
  Qed.
End Bits.

(* The constants of conservative_step-inl.h. *)
Definition inverse_power32 : binary_float 24 128 -> binary_float 24 128 :=
  inverse_power_of_bits 23 8 eq_refl eq_refl eq_refl default_nan_pl32 0x7f000000 0x7f800000.
Definition inverse_power64 : binary_float 53 1024 -> binary_float 53 1024 :=
  inverse_power_of_bits 52 11 eq_refl eq_refl eq_refl default_nan_pl64 0x7fe0000000000000 0x7ff0000000000000.
Theorem inverse_power_is32 : is_inverse_power 24 128 inverse_power32.
Proof. exact (bits_give_inverse_power 23 8 eq_refl eq_refl eq_refl default_nan_pl32 _ _ eq_refl eq_refl). Qed.
Theorem inverse_power_is64 : is_inverse_power 53 1024 inverse_power64.
Proof. exact (bits_give_inverse_power 52 11 eq_refl eq_refl eq_refl default_nan_pl64 _ _ eq_refl eq_refl). Qed.
