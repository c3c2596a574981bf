(* The conservative test over IEEE-754 numbers, to the bit: where W, as computed, is in its range, nothing overflows except the
   quotient of a very short edge, which is clamped, so that the test answers as over rounded reals without a greatest one; so
   it never misses a contact and its phantoms are shallow, whatever the thirteen numbers are. *)
From Coq Require Import Reals ZArith Bool List Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Exact Expression Format Run Filter Certified CertifiedStep Sizes ConservativeStep PhantomStep Machine
  ConservativeProgram.
Import ListNotations.
Open Scope R_scope.

(* Conversion leaves the operations alone. *)
Local Strategy 1000 [Bplus Bminus Bmult Bdiv Bopp Babs binary_normalize Bltb Bleb B2R round Rmin Rmax Rabs bpow].

Section Float.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Notation real_vec := (real_vec prec emax).
  Notation finite_vec := (finite_vec prec emax).
  Notation emin := (3 - emax - prec)%Z.
  Notation nearest := (nearest prec emax).
  Variables (low high : float -> float -> float) (inverse_power : float -> float).
  Hypothesis low_is : is_least prec emax low.
  Hypothesis high_is : is_greatest prec emax high.
  Hypothesis inverse_is : is_inverse_power prec emax inverse_power.
  Notation F := (float_machine prec emax prec_gt_0_ prec_lt_emax_ low high inverse_power).
  Notation N := (real_machine nearest).
  Definition on_floats (v : float_vec) : machine_vec F := @MachineVec F (fx _ _ v) (fy _ _ v) (fz _ _ v).
  Hypothesis prec20 : (20 <= prec)%Z.
  Hypothesis deep : (emin + prec <= -3 /\ 20 <= emax)%Z.
  Notation constant_spec := (Sizes.constant_spec prec emax _ _ prec20).

  Lemma nearest_0 : nearest 0 = 0.
  Proof using Type. apply round_0. apply valid_rnd_N. Qed.

  (* A number's size: finite, and at most a whole multiple of a power of h = 2^j, which is in the format, so that rounding does
     not go beyond it. *)
  Section Sizes.
    Variable j : Z.
    Hypothesis j_low : (emin + prec <= 4 * j)%Z.
    Hypothesis j_high : (4 * j + 8 <= emax)%Z.
    Definition room (n k : Z) : bool := ((0 <=? n) && (n <=? 4) && (0 <=? k) && (k <? 2 ^ (20 - 3 * n)))%Z.
    Definition bounded (n k : Z) (X : m_number F) (x : m_number N) : Prop :=
      is_finite (X : float) = true /\ B2R (X : float) = x /\ Rabs x <= IZR k * bpow radix2 (n * j).
    Definition bounded_vec (n k : Z) (V : machine_vec F) (v : machine_vec N) : Prop :=
      bounded n k (mx V) (mx v) /\ bounded n k (my V) (my v) /\ bounded n k (mz V) (mz v).

    Lemma room_spec n k : room n k = true -> (emin <= n * j)%Z /\ (0 <= k < 2 ^ prec)%Z /\ IZR k * bpow radix2 (n * j) < bpow radix2 emax.
    Proof using deep j_high j_low prec20.
      unfold room. rewrite !andb_true_iff, !Z.leb_le, Z.ltb_lt. intros (((n0 & n4) & k0) & few).
      assert (n = 0 \/ n = 1 \/ n = 2 \/ n = 3 \/ n = 4)%Z as cases by lia.
      split; [destruct cases as [-> | [-> | [-> | [-> | ->]]]]; lia |]. split.
      - split; [assumption |]. eapply Z.lt_le_trans; [exact few |]. apply Z.pow_le_mono_r; lia.
      - apply Rlt_le_trans with (bpow radix2 (20 - 3 * n) * bpow radix2 (n * j)).
        + apply Rmult_lt_compat_r; [apply bpow_gt_0 |]. rewrite <- IZR_Zpower by lia. apply IZR_lt. exact few.
        + rewrite <- bpow_plus. apply bpow_le. destruct cases as [-> | [-> | [-> | [-> | ->]]]]; lia.
    Qed.
    Lemma rounded_bound n k z : room n k = true -> Rabs z <= IZR k * bpow radix2 (n * j) ->
      Rabs (nearest z) <= IZR k * bpow radix2 (n * j) /\ Rabs (nearest z) < bpow radix2 emax.
    Proof using deep j_high j_low prec20 prec_gt_0_.
      intros fits size. destruct (room_spec n k fits) as (n_low & (k0 & k_few) & below).
      assert (Rabs (nearest z) <= IZR k * bpow radix2 (n * j)) as bound.
      { apply abs_round_le_generic; [apply FLT_exp_valid; exact prec_gt_0_ | apply valid_rnd_N | | exact size].
        apply generic_format_FLT. apply (FLT_spec _ _ _ _ (Float radix2 k (n * j))); [reflexivity | | exact n_low].
        cbn [Fnum]. rewrite Z.abs_eq by assumption. exact k_few. }
      split; [exact bound | eapply Rle_lt_trans; [exact bound | exact below]].
    Qed.
    Lemma weaken n k k' X x : (k <= k')%Z -> bounded n k X x -> bounded n k' X x.
    Proof using Type.
      intros more (FX & value & size). repeat split; try assumption. eapply Rle_trans; [exact size |].
      apply Rmult_le_compat_r; [apply bpow_ge_0 | apply IZR_le; exact more].
    Qed.
    Lemma add_bounded n k k' X x Y y : bounded n k X x -> bounded n k' Y y -> room n (k + k') = true ->
      bounded n (k + k') (m_add F X Y) (m_add N x y).
    Proof using deep j_high j_low prec20.
      intros (FX & <- & sx) (FY & <- & sy) fits. destruct (rounded_bound n (k + k') (B2R (X : float) + B2R (Y : float)) fits) as [size fit].
      { rewrite plus_IZR. eapply Rle_trans; [apply Rabs_triang | lra]. }
      destruct (plus_fits prec emax _ _ X Y FX FY fit). repeat split; assumption.
    Qed.
    Lemma subtract_bounded n k k' X x Y y : bounded n k X x -> bounded n k' Y y -> room n (k + k') = true ->
      bounded n (k + k') (m_subtract F X Y) (m_subtract N x y).
    Proof using deep j_high j_low prec20.
      intros (FX & <- & sx) (FY & <- & sy) fits. destruct (rounded_bound n (k + k') (B2R (X : float) - B2R (Y : float)) fits) as [size fit].
      { rewrite plus_IZR. unfold Rminus. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra. }
      destruct (minus_fits prec emax _ _ X Y FX FY fit). repeat split; assumption.
    Qed.
    Lemma multiply_bounded n n' k k' X x Y y : bounded n k X x -> bounded n' k' Y y -> room (n + n') (k * k') = true ->
      bounded (n + n') (k * k') (m_multiply F X Y) (m_multiply N x y).
    Proof using deep j_high j_low prec20.
      intros (FX & <- & sx) (FY & <- & sy) fits.
      destruct (rounded_bound (n + n') (k * k') (B2R (X : float) * B2R (Y : float)) fits) as [size fit].
      { rewrite Rabs_mult, mult_IZR, Z.mul_add_distr_r, bpow_plus.
        replace (IZR k * IZR k' * (bpow radix2 (n * j) * bpow radix2 (n' * j)))
          with (IZR k * bpow radix2 (n * j) * (IZR k' * bpow radix2 (n' * j))) by ring.
        apply Rmult_le_compat; auto using Rabs_pos. }
      destruct (mult_fits prec emax _ _ X Y FX FY fit). repeat split; assumption.
    Qed.
    Lemma negate_bounded n k X x : bounded n k X x -> bounded n k (m_negate F X) (m_negate N x).
    Proof using Type. intros (FX & <- & size). unfold bounded. cbn. rewrite is_finite_Bopp, B2R_Bopp, Rabs_Ropp. auto. Qed.
    Lemma least_bounded n k X x Y y : bounded n k X x -> bounded n k Y y -> bounded n k (m_least F X Y) (m_least N x y).
    Proof using low_is.
      intros (FX & <- & sx) (FY & <- & sy). destruct (least_of_finite prec emax low low_is X Y FX FY) as [FL value].
      repeat split; [exact FL | exact value |]. cbn. unfold Rmin. destruct Rle_dec; assumption.
    Qed.
    Lemma greatest_bounded n k X x Y y : bounded n k X x -> bounded n k Y y -> bounded n k (m_greatest F X Y) (m_greatest N x y).
    Proof using high_is.
      intros (FX & <- & sx) (FY & <- & sy). destruct (greatest_of_finite prec emax high high_is X Y FX FY) as [FL value].
      repeat split; [exact FL | exact value |]. cbn. unfold Rmax. destruct Rle_dec; assumption.
    Qed.
    Lemma constant_bounded n e : (0 <= n < 2 ^ 10)%Z -> (emin <= e <= emax - prec)%Z -> IZR n * bpow radix2 e <= 1 ->
      bounded 0 1 (m_constant F n e) (m_constant N n e).
    Proof using prec20.
      intros n0 e0 small. destruct (constant_spec n e) as [FC value]; [| exact e0 |].
      { split; [lia |]. apply Z.lt_le_trans with (2 ^ 10)%Z; [lia | apply Z.pow_le_mono_r; lia]. }
      repeat split; [exact FC | exact value |]. change (bpow radix2 (0 * j)) with 1. cbn [m_constant real_machine].
      rewrite Rabs_pos_eq; [lra |]. apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0].
    Qed.
    Lemma one_bounded : bounded 0 1 (m_constant F 1 0) (m_constant N 1 0).
    Proof using prec20. apply constant_bounded; [lia | | cbn; lra]. unfold Prec_gt_0, Prec_lt_emax in *. lia. Qed.
    Lemma zero_bounded n k : (0 <= k)%Z -> bounded n k (m_zero F) (m_zero N).
    Proof using Type.
      intros k0. repeat split. cbn. rewrite Rabs_R0. apply Rmult_le_pos; [apply IZR_le; exact k0 | apply bpow_ge_0].
    Qed.
    Lemma less_same n n' k k' X x Y y : bounded n k X x -> bounded n' k' Y y -> m_less F X Y = m_less N x y.
    Proof using Type.
      intros (FX & <- & _) (FY & <- & _). cbn. rewrite Bltb_correct by assumption. unfold less_real.
      case Rlt_bool_spec; intros; destruct Rlt_dec; reflexivity || lra.
    Qed.
    Lemma at_most_same n n' k k' X x Y y : bounded n k X x -> bounded n' k' Y y -> m_at_most F X Y = m_at_most N x y.
    Proof using Type.
      intros (FX & <- & _) (FY & <- & _). cbn. rewrite Bleb_correct by assumption. unfold at_most_real.
      case Rle_bool_spec; intros; destruct Rle_dec; reflexivity || lra.
    Qed.

    Lemma sub_bounded n k k' V v W w : bounded_vec n k V v -> bounded_vec n k' W w -> room n (k + k') = true ->
      bounded_vec n (k + k') (program_sub F V W) (program_sub N v w).
    Proof using deep j_high j_low prec20. intros (vx & vy & vz) (wx & wy & wz) fits. split; [| split]; apply subtract_bounded; assumption. Qed.
    Lemma product_bounded n n' k k' V v W w : bounded_vec n k V v -> bounded_vec n' k' W w ->
      room (n + n') (k * k') && room (n + n') (k * k' + k * k') && room (n + n') (k * k' + k * k' + k * k') = true ->
      bounded (n + n') (k * k' + k * k' + k * k') (program_product F V W) (program_product N v w).
    Proof using deep j_high j_low prec20.
      intros (vx & vy & vz) (wx & wy & wz) fits. rewrite !andb_true_iff in fits. destruct fits as ((one & two) & three).
      apply add_bounded; [apply add_bounded |  |]; try apply multiply_bounded; assumption.
    Qed.
    Lemma cross_bounded n n' k k' V v W w : bounded_vec n k V v -> bounded_vec n' k' W w ->
      room (n + n') (k * k') && room (n + n') (k * k' + k * k') = true ->
      bounded_vec (n + n') (k * k' + k * k') (program_cross F V W) (program_cross N v w).
    Proof using deep j_high j_low prec20.
      intros (vx & vy & vz) (wx & wy & wz) fits. rewrite andb_true_iff in fits. destruct fits as (one & two).
      split; [| split]; apply subtract_bounded; try apply multiply_bounded; assumption.
    Qed.
    Lemma three_bounded n k X x Y y Z z : bounded n k X x -> bounded n k Y y -> bounded n k Z z ->
      bounded n k (program_least F X Y Z) (program_least N x y z).
    Proof using low_is. intros hx hy hz. repeat apply least_bounded; assumption. Qed.

    (* The quotient may be infinite; clamped to [0, 1], it is not. *)
    Lemma sign_of_finite (X : float) : is_finite X = true -> if Bsign X then B2R X <= 0 else 0 <= B2R X.
    Proof using Type.
      destruct X as [s | s | | s mantissa e inside]; cbn; intros FX; try discriminate; [destruct s; lra |].
      destruct s; cbn; [apply F2R_le_0 | apply F2R_ge_0]; cbn; lia.
    Qed.
    Lemma divide_spec (X Y : float) : is_finite X = true -> is_finite Y = true -> 0 < B2R Y ->
      let q := nearest (B2R X / B2R Y) in
      (is_finite (Bdiv mode_NE X Y) = true /\ B2R (Bdiv mode_NE X Y) = q) \/
      (Bdiv mode_NE X Y = B754_infinity true /\ q <= 0) \/ (Bdiv mode_NE X Y = B754_infinity false /\ 1 <= q).
    Proof using deep prec20.
      intros FX FY Y0 q. pose proof (Bdiv_correct prec emax _ _ mode_NE X Y ltac:(lra)) as H. cbn [round_mode] in H.
      change (round radix2 (SpecFloat.fexp prec emax) ZnearestE (B2R X / B2R Y)) with q in H. revert H.
      case Rlt_bool_spec; [intros _ (value & finite & _); left; rewrite finite, value; auto | intros large infinite; right].
      pose proof (sign_of_finite X FX) as sX. pose proof (sign_of_finite Y FY) as sY.
      destruct (Bsign Y); [lra |]. rewrite xorb_false_r in infinite.
      assert (Bdiv mode_NE X Y = B754_infinity (Bsign X)) as ->.
      { revert infinite. destruct (Bdiv mode_NE X Y); cbn; congruence. }
      assert (forall x, 0 <= x -> 0 <= nearest x) as kept by (intros; apply (Sizes.rounded_nonneg prec emax prec20); assumption).
      assert (0 < / B2R Y) as Y1 by (apply Rinv_0_lt_compat; assumption).
      assert (1 <= bpow radix2 emax) as large_emax by (change 1 with (bpow radix2 0); apply bpow_le; lia).
      destruct (Bsign X); [left | right]; (split; [reflexivity |]).
      - assert (0 <= nearest (- (B2R X / B2R Y))) as H.
        { apply kept. replace (- (B2R X / B2R Y)) with (- B2R X * / B2R Y) by (unfold Rdiv; ring). apply Rmult_le_pos; lra. }
        unfold Run.nearest in H. rewrite round_NE_opp in H. unfold q, Run.nearest. lra.
      - assert (0 <= q) by (apply kept, Rmult_le_pos; lra). rewrite Rabs_pos_eq in large by assumption. lra.
    Qed.
    Lemma clamp_bounded (Q : float) q : (is_finite Q = true /\ B2R Q = q) \/ (Q = B754_infinity true /\ q <= 0) \/
      (Q = B754_infinity false /\ 1 <= q) ->
      bounded 0 1 (m_least F (m_greatest F Q (m_zero F)) (m_constant F 1 0)) (m_least N (m_greatest N q (m_zero N)) (m_constant N 1 0)).
    Proof using high_is low_is prec20.
      destruct one_bounded as (F1 & v1 & _). cbn [m_constant float_machine real_machine] in *.
      set (one := binary_normalize _ _ _ _ _ _ _ _) in *.
      assert (IZR 1 * bpow radix2 0 = 1) as is_1 by (cbn; ring). rewrite is_1 in *.
      intros cases. cbn [m_least m_greatest m_zero float_machine real_machine].
      assert (is_finite (low (high Q (B754_zero false)) one) = true /\
        B2R (low (high Q (B754_zero false)) one) = Rmin (Rmax q 0) 1) as [finite value].
      { destruct cases as [(FQ & <-) | [(-> & q0) | (-> & q1)]].
        - destruct (greatest_of_finite prec emax high high_is Q (B754_zero false) FQ eq_refl) as [FG vG].
          destruct (least_of_finite prec emax low low_is _ _ FG F1) as [FL vL]. rewrite vL, vG, v1. auto.
        - destruct (high_is (B754_infinity true) (B754_zero false) eq_refl eq_refl) as [(_ & no) | (-> & _)]; [discriminate no |].
          destruct (least_of_finite prec emax low low_is (B754_zero false) one eq_refl F1) as [FL vL]. rewrite vL, v1. split; [exact FL |].
          rewrite (Rmax_right q 0) by assumption. reflexivity.
        - assert (high (B754_infinity false) (B754_zero false) = B754_infinity false) as ->
            by (destruct (high_is (B754_infinity false) (B754_zero false) eq_refl eq_refl) as [(-> & _) | (_ & no)];
              [reflexivity | discriminate no]).
          assert (low (B754_infinity false) one = one) as ->.
          { destruct (low_is (B754_infinity false) one eq_refl (finite_not_nan _ _ one F1)) as [(_ & no) | (-> & _)]; [| reflexivity].
            exfalso. revert F1 no. clear. destruct one as [[] | [] | | []]; cbn; discriminate. }
          split; [exact F1 |]. rewrite v1, (Rmax_left q 0), Rmin_right by lra. reflexivity. }
      repeat split; [exact finite | exact value |]. change (bpow radix2 (0 * j)) with 1.
      rewrite Rabs_pos_eq; unfold Rmin, Rmax; repeat destruct Rle_dec; lra.
    Qed.

    (* The query, and what is known of its size: W from h^2 / 4 to h^2. *)
    Variables least_normal : Z.
    Variables (a b c p : machine_vec F) (r : m_number F) (a' b' c' p' : machine_vec N) (r' : m_number N).
    Hypothesis size_a : bounded_vec 1 1 (program_sub F a p) (program_sub N a' p').
    Hypothesis size_b : bounded_vec 1 1 (program_sub F b p) (program_sub N b' p').
    Hypothesis size_c : bounded_vec 1 1 (program_sub F c p) (program_sub N c' p').
    Hypothesis size_r : bounded 1 1 r r'.
    Hypothesis size_W : bounded 2 1 (program_W F a b c p r) (program_W N a' b' c' p' r').
    Hypothesis W_range : bpow radix2 (2 - emax) <= program_W N a' b' c' p' r' < bpow radix2 (emax - 1).
    Hypothesis W_large : (2 * j <= mag radix2 (program_W N a' b' c' p' r' : R) + 1)%Z.
    Hypothesis normal_range : (emin <= least_normal <= 0)%Z.

    Lemma unit_small n k e : (n <= 2 ^ k)%Z -> (0 <= k)%Z -> (k + e <= 0)%Z -> IZR n * bpow radix2 e <= 1.
    Proof using Type.
      intros small k0 sum. apply Rle_trans with (bpow radix2 k * bpow radix2 e).
      - apply Rmult_le_compat_r; [apply bpow_ge_0 |]. rewrite <- IZR_Zpower by assumption. apply IZR_le. exact small.
      - rewrite <- bpow_plus. change 1 with (bpow radix2 0). apply bpow_le. exact sum.
    Qed.
    Lemma error_bounded : bounded 2 1 (program_error F prec a b c p r) (program_error N prec a' b' c' p' r').
    Proof using deep j_high j_low prec20 size_W.
      apply (multiply_bounded 0 2 1 1); [| exact size_W | reflexivity].
      apply constant_bounded; [lia | unfold Prec_gt_0, Prec_lt_emax in *; lia | apply (unit_small 5 3); lia].
    Qed.
    Lemma square_error_bounded : bounded 2 1 (program_square_error F prec a b c p r) (program_square_error N prec a' b' c' p' r').
    Proof using deep j_high j_low prec20 size_W.
      apply (multiply_bounded 0 2 1 1); [| exact size_W | reflexivity].
      apply constant_bounded; [lia | unfold Prec_gt_0, Prec_lt_emax in *; lia | apply (unit_small 153 8); lia].
    Qed.
    Lemma passes_same n k n' k' X x S s : bounded n k X x -> bounded n' k' S s -> room (n + n) (k * k) && room (2 + n') (2 * k') = true ->
      program_passes F prec a b c p r X S = program_passes N prec a' b' c' p' r' x s.
    Proof using deep j_high j_low prec20 size_W size_r.
      intros hx hs fits. rewrite andb_true_iff in fits. destruct fits as (one & two). unfold program_passes.
      assert (bounded 2 2 (m_add F (m_multiply F r r) (program_square_error F prec a b c p r))
        (m_add N (m_multiply N r' r') (program_square_error N prec a' b' c' p' r'))) as hR.
      { apply (add_bounded 2 1 1); [apply (multiply_bounded 1 1 1 1); auto | exact square_error_bounded | reflexivity]. }
      f_equal.
      - apply (less_same n n k k); [| exact hx]. apply zero_bounded. destruct (room_spec _ _ one) as (_ & _ & _).
        destruct hx as (_ & _ & size). pose proof (Rabs_pos x). pose proof (bpow_gt_0 radix2 (n * j)). apply le_IZR. nra.
      - apply (less_same (2 + n') (n + n) (2 * k') (k * k)); apply multiply_bounded; assumption.
    Qed.

    Lemma share_bounded X along x al : bounded_vec 1 1 X x -> bounded_vec 1 2 along al ->
      bounded 0 1 (program_share F X along) (program_share N x al).
    Proof using deep high_is j_high j_low low_is prec20.
      intros hX ha. pose proof (product_bounded 1 1 2 2 _ _ _ _ ha ha eq_refl) as he.
      pose proof (product_bounded 1 1 1 2 _ _ _ _ hX ha eq_refl) as hd.
      unfold program_share. cbv zeta. pose proof (less_same 0 _ 1 _ _ _ _ _ (zero_bounded 0 1 ltac:(lia)) he) as same. rewrite same.
      apply clamp_bounded. destruct (m_less N (m_zero N) (program_product N al al)) eqn:positive; [| left; split; reflexivity].
      apply negate_bounded in hd. destruct he as (Fe & ve & _), hd as (Fd & vd & _).
      cbn [m_divide float_machine real_machine]. rewrite <- ve, <- vd. apply divide_spec; [exact Fd | exact Fe |].
      rewrite ve. apply less_real_is. exact positive.
    Qed.
    Lemma mix_bounded k S s X x Y y : bounded 0 1 S s -> bounded 2 k X x -> bounded 2 k Y y ->
      room 2 (k + k) && room 2 (1 * (k + k)) && room 2 (k + 1 * (k + k)) = true ->
      bounded 2 (k + 1 * (k + k)) (program_mix F S X Y) (program_mix N s x y).
    Proof using deep j_high j_low prec20.
      intros hs hx hy fits. rewrite !andb_true_iff in fits. destruct fits as ((one & two) & three).
      apply add_bounded; [exact hx | | exact three]. apply (multiply_bounded 0 2); [exact hs | | exact two].
      apply subtract_bounded; assumption.
    Qed.
    Lemma edge_same X along x al XX xx XY xy YY yy XZ xz YZ yz : bounded_vec 1 1 X x -> bounded_vec 1 2 along al ->
      bounded 2 3 XX xx -> bounded 2 3 XY xy -> bounded 2 3 YY yy -> bounded 2 3 XZ xz -> bounded 2 3 YZ yz ->
      program_edge F prec a b c p r X along XX XY YY XZ YZ = program_edge N prec a' b' c' p' r' x al xx xy yy xz yz.
    Proof using deep high_is j_high j_low low_is prec20 size_W size_r.
      intros hX ha hxx hxy hyy hxz hyz. pose proof (share_bounded _ _ _ _ hX ha) as hs. unfold program_edge. cbv zeta.
      pose proof (mix_bounded 3 _ _ _ _ _ _ hs hxx hxy eq_refl) as at_x. pose proof (mix_bounded 3 _ _ _ _ _ _ hs hxy hyy eq_refl) as at_y.
      pose proof (mix_bounded 3 _ _ _ _ _ _ hs hxz hyz eq_refl) as at_z.
      apply (passes_same 2 10 2 28); [| | reflexivity].
      - apply (subtract_bounded 2 9 1); [apply three_bounded; assumption | exact error_bounded | reflexivity].
      - apply (add_bounded 2 27 1); [| exact square_error_bounded | reflexivity].
        exact (mix_bounded 9 _ _ _ _ _ _ hs at_x at_y eq_refl).
    Qed.

    Lemma scaled_bounded X x : bounded 2 8 X x -> bounded 0 32 (m_multiply F X (m_inverse_power F (program_W F a b c p r)))
      (m_multiply N x (m_inverse_power N (program_W N a' b' c' p' r'))).
    Proof using W_large W_range deep inverse_is j_high j_low prec20 size_W.
      intros (FX & <- & size). destruct size_W as (FW & vW & _). cbn [m_inverse_power float_machine real_machine m_multiply].
      destruct (inverse_is (program_W F a b c p r) ltac:(rewrite vW; exact W_range)) as [FI vI]. rewrite vW in vI.
      rewrite <- vI. destruct (rounded_bound 0 32 (B2R (X : float) * B2R (inverse_power (program_W F a b c p r))) eq_refl) as [bound fit].
      - rewrite vI, Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0. change (bpow radix2 (0 * j)) with 1.
        apply Rle_trans with (8 * bpow radix2 (2 * j) * bpow radix2 (1 - mag radix2 (program_W N a' b' c' p' r' : R)));
          [apply Rmult_le_compat_r; [apply bpow_ge_0 | exact size] |].
        rewrite Rmult_assoc, <- bpow_plus.
        assert (bpow radix2 (2 * j + (1 - mag radix2 (program_W N a' b' c' p' r' : R))) <= bpow radix2 2) by (apply bpow_le; lia).
        change (bpow radix2 2) with 4 in *. lra.
      - destruct (mult_fits prec emax _ _ X _ FX FI fit). repeat split; assumption.
    Qed.
    (* The side of A; where the plane contains the centre, either. *)
    Lemma side_bounded n k X x : bounded n k X x -> exists s, bounded 0 1 (m_with_sign F (m_constant F 1 0) X) s /\
      (x <> 0 -> s = m_with_sign N (m_constant N 1 0) x).
    Proof using prec20.
      intros (FX & <- & _). destruct one_bounded as (F1 & v1 & s1). pose proof (sign_of_finite _ FX) as sign.
      cbn [m_with_sign float_machine real_machine]. set (one := m_constant F 1 0) in *. clearbody one. rewrite <- v1 in *. clear v1.
      exists (B2R (if Bsign (X : float) then Bopp (Babs (one : float)) else Babs (one : float))). split.
      - destruct (Bsign _); unfold bounded; rewrite ?is_finite_Bopp, ?B2R_Bopp, is_finite_Babs, B2R_Babs; repeat split; try exact F1;
          rewrite ?Rabs_Ropp, Rabs_Rabsolu; exact s1.
      - intros not_0. destruct (Bsign _), Rlt_dec; rewrite ?B2R_Bopp, B2R_Babs; try reflexivity; exfalso; lra.
    Qed.
    Lemma plane_passes_same n k n' k' X x Y y Z z S s : bounded n k X x -> bounded n k Y y -> bounded n k Z z -> bounded n' k' S s ->
      room n (1 * k) && (room (n + n) (1 * k * (1 * k)) && room (2 + n') (2 * k')) = true ->
      let side := m_with_sign F (m_constant F 1 0) X in let side' := m_with_sign N (m_constant N 1 0) x in
      program_passes F prec a b c p r (program_least F (m_multiply F side X) (m_multiply F side Y) (m_multiply F side Z)) S =
      program_passes N prec a' b' c' p' r' (program_least N (m_multiply N side' x) (m_multiply N side' y) (m_multiply N side' z)) s.
    Proof using deep j_high j_low low_is prec20 size_W size_r.
      intros hX hY hZ hS fits side side'. apply andb_true_iff in fits as (one & two).
      destruct (side_bounded _ _ _ _ hX) as (t & ht & same). fold side in ht. fold side' in same. clearbody side side'.
      pose proof (three_bounded _ _ _ _ _ _ _ _ (multiply_bounded 0 n 1 k _ _ _ _ ht hX one) (multiply_bounded 0 n 1 k _ _ _ _ ht hY one)
        (multiply_bounded 0 n 1 k _ _ _ _ ht hZ one)) as hm. change (0 + n)%Z with n in hm.
      destruct (Req_dec x 0) as [zero | not_0]; [| rewrite <- (same not_0); exact (passes_same _ _ _ _ _ _ _ _ hm hS two)].
      assert (forall t y z, m_less N (m_zero N) (program_least N (m_multiply N t x) y z) = false) as not_above.
      { intros t' y' z'. rewrite zero. apply not_true_iff_false. intros H. apply less_real_is in H. cbn in H.
        rewrite Rmult_0_r, nearest_0 in H. unfold Rmin in H. repeat destruct Rle_dec; lra. }
      transitivity false; [| symmetry]; unfold program_passes; apply andb_false_iff; left; [| apply not_above].
      rewrite (less_same n n 0 _ _ _ _ _ (zero_bounded n 0 ltac:(lia)) hm). apply not_above.
    Qed.
    Lemma plane_same : program_plane F prec least_normal a b c p r = program_plane N prec least_normal a' b' c' p' r'.
    Proof.
      pose proof (sub_bounded 1 1 1 _ _ _ _ size_a size_c eq_refl) as hCA.
      pose proof (sub_bounded 1 1 1 _ _ _ _ size_b size_a eq_refl) as hAB.
      destruct (cross_bounded 1 1 2 2 _ _ _ _ hCA hAB eq_refl) as (Vx & Vy & Vz).
      assert (bounded_vec 0 32 (program_normal F a b c p r) (program_normal N a' b' c' p' r')) as hn
        by (split; [| split]; apply scaled_bounded; assumption).
      clear Vx Vy Vz hCA hAB. unfold program_plane. cbv zeta. set (n := program_normal F a b c p r) in *.
      set (n' := program_normal N a' b' c' p' r') in *.
      clearbody n n'.
      pose proof (product_bounded 1 0 1 32 _ _ _ _ size_a hn eq_refl) as ha.
      pose proof (product_bounded 1 0 1 32 _ _ _ _ size_b hn eq_refl) as hb.
      pose proof (product_bounded 1 0 1 32 _ _ _ _ size_c hn eq_refl) as hc.
      pose proof (product_bounded 0 0 32 32 _ _ _ _ hn hn eq_refl) as hnn.
      f_equal.
      - apply (at_most_same 0 0 1 3072); [| exact hnn]. apply constant_bounded; [lia | unfold Prec_gt_0, Prec_lt_emax in *; lia |].
        rewrite Rmult_1_l. change 1 with (bpow radix2 0). apply bpow_le. lia.
      - exact (plane_passes_same 1 96 0 3072 _ _ _ _ _ _ _ _ ha hb hc hnn eq_refl).
    Qed.
    Theorem separated_same : program_separated F prec least_normal a b c p r = program_separated N prec least_normal a' b' c' p' r'.
    Proof using All.
      pose proof (sub_bounded 1 1 1 _ _ _ _ size_b size_a eq_refl) as hAB.
      pose proof (sub_bounded 1 1 1 _ _ _ _ size_c size_b eq_refl) as hBC.
      pose proof (sub_bounded 1 1 1 _ _ _ _ size_a size_c eq_refl) as hCA.
      pose proof (product_bounded 1 1 1 1 _ _ _ _ size_a size_a eq_refl) as haa.
      pose proof (product_bounded 1 1 1 1 _ _ _ _ size_b size_b eq_refl) as hbb.
      pose proof (product_bounded 1 1 1 1 _ _ _ _ size_c size_c eq_refl) as hcc.
      pose proof (product_bounded 1 1 1 1 _ _ _ _ size_a size_b eq_refl) as hab.
      pose proof (product_bounded 1 1 1 1 _ _ _ _ size_b size_c eq_refl) as hbc.
      pose proof (product_bounded 1 1 1 1 _ _ _ _ size_c size_a eq_refl) as hca.
      unfold program_separated. rewrite plane_same. f_equal. f_equal; [f_equal |]; apply edge_same; assumption.
    Qed.
  End Sizes.

  (* A sum of squares is not below zero: where it is at most a number, it is finite. *)
  Notation plus_finite := (Sizes.plus_finite prec emax _ _).
  Notation mult_finite := (Sizes.mult_finite prec emax _ _).
  Notation rounded_nonneg := (Sizes.rounded_nonneg prec emax prec20).
  Definition not_negative (x : float) : Prop := x <> B754_infinity true /\ 0 <= B2R x.
  Lemma square_not_negative (x : float) : not_negative (Bmult mode_NE x x).
  Proof using prec20.
    pose proof (Bmult_correct prec emax _ _ mode_NE x x) as H. rewrite xorb_nilpotent in H. revert H. case Rlt_bool_spec; intros _ H.
    - destruct H as (value & finite & _). split; [| rewrite value; apply rounded_nonneg, Rle_0_sqr].
      destruct (is_finite x) eqn:Fx; [| destruct x as [| [] | |]; discriminate].
      intros no. rewrite no in finite. discriminate.
    - destruct (Bmult mode_NE x x); cbn in H; try discriminate. injection H as ->. split; [discriminate | cbn; lra].
  Qed.
  Lemma sum_not_negative (x y : float) : not_negative x -> not_negative y -> not_negative (Bplus mode_NE x y).
  Proof using prec20.
    intros [notx x0] [noty y0]. destruct (is_finite x && is_finite y) eqn:finite.
    - apply andb_prop in finite as [Fx Fy]. pose proof (Bplus_correct prec emax _ _ mode_NE x y Fx Fy) as H. revert H.
      case Rlt_bool_spec; intros size H.
      + destruct H as (value & finite & _). split; [| rewrite value; apply rounded_nonneg; lra]. intros no. rewrite no in finite.
        discriminate.
      + destruct H as [infinite same]. pose proof (sign_of_finite x Fx) as sx. pose proof (sign_of_finite y Fy) as sy.
        rewrite <- same in sy.
        destruct (Bsign x).
        * exfalso. replace (B2R x + B2R y) with 0 in size by lra. cbn [round_mode] in size.
          change (round radix2 (SpecFloat.fexp prec emax) ZnearestE 0) with (nearest 0) in size. rewrite nearest_0, Rabs_R0 in size.
          pose proof (bpow_gt_0 radix2 emax). lra.
        * destruct (Bplus mode_NE x y); cbn in infinite; try discriminate. injection infinite as ->. split; [discriminate | cbn; lra].
    - destruct x as [| [] | |], y as [| [] | |]; cbn in finite; try discriminate; try congruence; (split; [discriminate | cbn; lra]).
  Qed.
  Lemma product_not_negative (V : machine_vec F) : not_negative (program_product F V V).
  Proof using prec20. apply sum_not_negative; [apply sum_not_negative |]; apply square_not_negative. Qed.
  Lemma at_most_finite (x t : float) : is_finite t = true -> not_negative x -> Bleb x t = true -> is_finite x = true.
  Proof using Type. destruct x as [| [] | |], t as [| [] | |]; cbn; try discriminate; try reflexivity; intros _ [no _]; congruence. Qed.

  (* A number whose square rounds to at most h^2 is at most h. *)
  Lemma root_bound j x : (emin + prec <= j)%Z -> (emin + prec <= 2 * j)%Z -> generic_format radix2 (FLT_exp emin prec) x ->
    nearest (x * x) <= bpow radix2 (2 * j) -> Rabs x <= bpow radix2 j.
  Proof using prec20 prec_gt_0_.
    intros j_low j_low2 format small. destruct (Rle_lt_dec (Rabs x) (bpow radix2 j)) as [| large]; [assumption | exfalso].
    pose proof (FLT_exp_valid emin prec) as valid.
    assert (generic_format radix2 (FLT_exp emin prec) (bpow radix2 j)) as power by (apply generic_format_bpow; unfold FLT_exp; lia).
    pose proof (succ_le_lt radix2 (FLT_exp emin prec) _ _ power (generic_format_abs _ _ _ format) large) as next.
    rewrite succ_eq_pos, ulp_bpow in next by apply bpow_ge_0.
    assert (bpow radix2 (j + 1 - prec) <= bpow radix2 (FLT_exp emin prec (j + 1))) as step by (apply bpow_le; unfold FLT_exp; lia).
    set (t := bpow radix2 (2 * j) + bpow radix2 (2 * j + 1 - prec)).
    assert (generic_format radix2 (FLT_exp emin prec) t) as above.
    { apply generic_format_FLT. apply (FLT_spec _ _ _ _ (Float radix2 (2 ^ (prec - 1) + 1) (2 * j + 1 - prec))); cbn [Fnum Fexp]; [| | lia].
      - unfold F2R, t. cbn [Fnum Fexp]. rewrite plus_IZR. change (2 ^ (prec - 1))%Z with (Zpower radix2 (prec - 1)).
        rewrite IZR_Zpower by lia. rewrite Rmult_plus_distr_r, <- bpow_plus, Rmult_1_l. f_equal; f_equal; lia.
      - assert (1 < 2 ^ (prec - 1))%Z by (apply Z.pow_gt_1; lia). rewrite Z.abs_eq by lia. change (2 ^ (prec - 1) + 1 < 2 ^ prec)%Z.
        replace (2 ^ prec)%Z with (2 ^ 1 * 2 ^ (prec - 1))%Z by (rewrite <- Z.pow_add_r by lia; f_equal; lia). lia. }
    assert (t <= x * x) as beyond.
    { assert (bpow radix2 j + bpow radix2 (j + 1 - prec) <= Rabs x) as size by lra. pose proof (bpow_ge_0 radix2 j).
      pose proof (bpow_ge_0 radix2 (j + 1 - prec)).
      replace (x * x) with (Rabs x * Rabs x) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
      apply Rle_trans with ((bpow radix2 j + bpow radix2 (j + 1 - prec)) * (bpow radix2 j + bpow radix2 (j + 1 - prec)));
        [| apply Rmult_le_compat; lra].
      unfold t. replace (2 * j)%Z with (j + j)%Z by lia. replace (j + j + 1 - prec)%Z with (j + (j + 1 - prec))%Z by lia.
      rewrite !bpow_plus.
      assert (0 <= bpow radix2 j * bpow radix2 (j + 1 - prec)) by (apply Rmult_le_pos; assumption).
      assert (0 <= bpow radix2 (j + 1 - prec) * bpow radix2 (j + 1 - prec)) by (apply Rmult_le_pos; assumption). lra. }
    apply (Format.rnd_monotone prec emin ltac:(lia)) in beyond. rewrite (rnd_format prec emin t above) in beyond.
    change (t <= nearest (x * x)) in beyond. pose proof (bpow_gt_0 radix2 (2 * j + 1 - prec)). unfold t in beyond. lra.
  Qed.

  Section Query.
    Variables least half least_normal : Z.
    Hypothesis fits : (0 <= half /\ 4 * half + 8 <= emax /\ 2 * half <= emax - prec)%Z.
    Hypothesis low_fits : (emin + prec <= 2 * least /\ 2 - emax <= least <= emax - prec)%Z.
    Hypothesis normal_fits : (emin <= least_normal <= 0)%Z.
    Variables (a b c p : float_vec) (r : float).
    Notation float_sub := (float_sub prec emax _ _).
    Notation float_dot := (float_dot prec emax _ _ false).
    Notation on_real v := (on_reals nearest (real_vec v)).

    Lemma vertex_known v : is_finite (float_dot (float_sub v p) (float_sub v p)) = true ->
      finite_vec v /\ finite_vec p /\
      B2R (float_dot (float_sub v p) (float_sub v p)) =
        program_product N (program_sub N (on_real v) (on_real p)) (program_sub N (on_real v) (on_real p)) /\
      forall j, (emin + prec <= j)%Z -> (emin + prec <= 2 * j)%Z ->
        B2R (float_dot (float_sub v p) (float_sub v p)) <= bpow radix2 (2 * j) ->
        bounded_vec j 1 1 (program_sub F (on_floats v) (on_floats p)) (program_sub N (on_real v) (on_real p)).
    Proof using prec20.
      intros finite. destruct (Sizes.square_finite prec emax _ _ false _ finite) as [FX value].
      destruct (Sizes.sub_finite prec emax _ _ _ _ FX) as (Fv & Fp & same).
      split; [exact Fv |]. split; [exact Fp |]. rewrite same in value. split; [exact value |]. intros j j_low j_low2 small.
      rewrite value in small.
      destruct FX as (Fx & Fy & Fz).
      pose proof (Sizes.square_above prec emax _ false prec20 (rounded_sub nearest (real_vec v) (real_vec p))) as ((bx & by_ & bz) & _).
      assert (each : forall x : float, nearest (B2R x * B2R x) <= bpow radix2 (2 * j) -> Rabs (B2R x) <= IZR 1 * bpow radix2 (1 * j)).
      { intros x square. rewrite Rmult_1_l, Z.mul_1_l. apply root_bound; try assumption. apply generic_format_B2R. }
      pose proof (f_equal cx same) as sx. pose proof (f_equal cy same) as sy. pose proof (f_equal cz same) as sz.
      cbn [cx cy cz Filter.real_vec rounded_sub] in *.
      split; [| split]; (split; [assumption |]); (split; [assumption |]).
      - change (Rabs (nearest (B2R (fx _ _ v) - B2R (fx _ _ p))) <= IZR 1 * bpow radix2 (1 * j)). rewrite <- sx in *. apply each. lra.
      - change (Rabs (nearest (B2R (fy _ _ v) - B2R (fy _ _ p))) <= IZR 1 * bpow radix2 (1 * j)). rewrite <- sy in *. apply each. lra.
      - change (Rabs (nearest (B2R (fz _ _ v) - B2R (fz _ _ p))) <= IZR 1 * bpow radix2 (1 * j)). rewrite <- sz in *. apply each. lra.
    Qed.

    Hypothesis known : program_known F least (2 * half) (on_floats a) (on_floats b) (on_floats c) (on_floats p) r = true.
    Theorem float_is_real :
      (finite_vec a /\ finite_vec b /\ finite_vec c /\ finite_vec p /\ is_finite r = true) /\
      program_known N least (2 * half) (on_real a) (on_real b) (on_real c) (on_real p) (B2R r) = true /\
      program_separated F prec least_normal (on_floats a) (on_floats b) (on_floats c) (on_floats p) r =
        program_separated N prec least_normal (on_real a) (on_real b) (on_real c) (on_real p) (B2R r).
    Proof using All.
      pose proof known as H. unfold program_known in H. rewrite !andb_true_iff in H. destruct H as (r0 & low_W & high_S).
      destruct (constant_spec 1 least) as [Fl vl]; [split; [lia | apply Z.pow_gt_1; lia] | lia |].
      destruct (constant_spec 1 (2 * half)) as [Fh vh]; [split; [lia | apply Z.pow_gt_1; lia] | unfold Prec_gt_0 in *; lia |].
      rewrite Rmult_1_l in vl, vh. unfold program_squares in high_S. cbn [m_add m_at_most m_constant m_multiply float_machine] in high_S.
      set (aa := program_product F _ _) in high_S at 1. set (bb := program_product F _ _) in high_S at 1.
      set (cc := program_product F _ _) in high_S at 1.
      set (rr := Bmult mode_NE r r) in high_S.
      assert (is_finite (Bplus mode_NE (Bplus mode_NE (Bplus mode_NE aa bb) cc) rr) = true) as FS.
      { apply (at_most_finite _ _ Fh); [| exact high_S].
        apply sum_not_negative; [| apply square_not_negative].
        apply sum_not_negative; [apply sum_not_negative |]; apply product_not_negative. }
      pose proof FS as FS'. apply (at_most_of_finite prec emax _ _ FS Fh) in high_S.
      match type of high_S with _ <= ?x => change x with (B2R (constant prec emax _ _ 1 (2 * half))) in high_S end. rewrite vh in high_S.
      destruct (plus_finite _ _ FS) as (F2 & Frr & v3). destruct (plus_finite _ _ F2) as (F1 & Fcc & v2).
      destruct (plus_finite _ _ F1) as (Faa & Fbb & v1).
      destruct (mult_finite _ _ Frr) as (Fr & _ & vrr). fold rr in vrr.
      pose proof (product_not_negative (program_sub F (on_floats a) (on_floats p))) as [_ a0].
      pose proof (product_not_negative (program_sub F (on_floats b) (on_floats p))) as [_ b0].
      pose proof (product_not_negative (program_sub F (on_floats c) (on_floats p))) as [_ c0].
      pose proof (square_not_negative r) as [_ rr0].
      change (0 <= B2R aa) in a0. change (0 <= B2R bb) in b0. change (0 <= B2R cc) in c0. change (0 <= B2R rr) in rr0.
      destruct (Sizes.sum_nonneg prec emax _ _ prec20 _ _ F1 a0 b0) as [a1 b1]. assert (0 <= B2R (Bplus mode_NE aa bb)) as s0 by lra.
      destruct (Sizes.sum_nonneg prec emax _ _ prec20 _ _ F2 s0 c0) as [s1 c1].
      assert (0 <= B2R (Bplus mode_NE (Bplus mode_NE aa bb) cc)) as s0' by lra.
      destruct (Sizes.sum_nonneg prec emax _ _ prec20 _ _ FS s0' rr0) as [s2 r2].
      destruct (vertex_known a Faa) as (fa & fp & va & ha). destruct (vertex_known b Fbb) as (fb & _ & vb & hb).
      destruct (vertex_known c Fcc) as (fc & _ & vc & hc).
      change (float_dot (float_sub a p) (float_sub a p)) with aa in va, ha.
      change (float_dot (float_sub b p) (float_sub b p)) with bb in vb, hb.
      change (float_dot (float_sub c p) (float_sub c p)) with cc in vc, hc.
      (* W. *)
      destruct (greatest_of_finite prec emax high high_is aa bb Faa Fbb) as [G1 w1].
      destruct (greatest_of_finite prec emax high high_is cc rr Fcc Frr) as [G2 w2].
      destruct (greatest_of_finite prec emax high high_is _ _ G1 G2) as [FW vW].
      change (high (high aa bb) (high cc rr)) with (program_W F (on_floats a) (on_floats b) (on_floats c) (on_floats p) r) in FW, vW.
      assert (B2R (program_W F (on_floats a) (on_floats b) (on_floats c) (on_floats p) r : float) =
        program_W N (on_real a) (on_real b) (on_real c) (on_real p) (B2R r)) as same_W by (rewrite vW, w1, w2, va, vb, vc, vrr;
          reflexivity).
      set (W := program_W F _ _ _ _ _) in *. set (w := program_W N _ _ _ _ _) in *.
      apply (at_most_of_finite prec emax _ _ Fl FW) in low_W.
      match type of low_W with ?x <= _ => change x with (B2R (constant prec emax _ _ 1 least)) in low_W end. rewrite vl, same_W in low_W.
      rewrite w1, w2 in vW. rewrite same_W in vW.
      assert (B2R aa <= w /\ B2R bb <= w /\ B2R cc <= w /\ B2R rr <= w /\ w <= bpow radix2 (2 * half)) as (aw & bw & cw & rw & w_high).
      { rewrite vW. unfold Rmax. repeat destruct Rle_dec; lra. }
      assert (0 < w) as w0 by (pose proof (bpow_gt_0 radix2 least); change (bpow radix2 least <= w) in low_W; lra).
      pose proof (bpow_mag_gt radix2 w) as w_below. pose proof (bpow_mag_le radix2 w ltac:(lra)) as w_above.
      rewrite Rabs_pos_eq in w_below, w_above by lra.
      set (j := Z.min half ((mag radix2 (w : R) + 1) / 2)).
      assert (least < mag radix2 (w : R))%Z as mag_low by (apply mag_gt_bpow; rewrite Rabs_pos_eq by lra; exact low_W).
      pose proof (Z.div_mod (mag radix2 (w : R) + 1) 2 ltac:(lia)) as split.
      pose proof (Z.mod_pos_bound (mag radix2 (w : R) + 1) 2 ltac:(lia)) as rest.
      assert (w <= bpow radix2 (2 * j)) as w_j.
      { unfold j. destruct (Z.min_spec half ((mag radix2 (w : R) + 1) / 2)) as [[_ ->] | [_ ->]]; [exact w_high |].
        apply Rle_trans with (bpow radix2 (mag radix2 (w : R))); [lra | apply bpow_le; lia]. }
      assert (emin + prec <= j /\ emin + prec <= 2 * j /\ emin + prec <= 4 * j /\ 4 * j + 8 <= emax /\ 2 * j <= mag radix2 (w : R) + 1)%Z
        as (j1 & j2 & j4 & j_high & j_mag) by (unfold j; lia).
      split; [auto 10 |]. split.
      - unfold program_known. rewrite !andb_true_iff. split; [| split]; apply at_most_real_is.
        + apply (at_most_of_finite prec emax (B754_zero false) r eq_refl Fr r0).
        + cbn [m_constant real_machine]. rewrite Rmult_1_l. exact low_W.
        + cbn [m_constant real_machine]. rewrite Rmult_1_l. unfold program_squares. cbn [m_add m_multiply real_machine].
          rewrite <- va, <- vb, <- vc. rewrite <- vrr, <- v1, <- v2, <- v3. exact high_S.
      - apply (separated_same j); try assumption; fold W w; try lia.
        + apply ha; try assumption. lra.
        + apply hb; try assumption. lra.
        + apply hc; try assumption. lra.
        + split; [exact Fr |]. split; [reflexivity |]. rewrite Rmult_1_l, Z.mul_1_l.
          apply root_bound; try assumption; [apply generic_format_B2R |].
          rewrite <- vrr. lra.
        + split; [exact FW |]. split; [exact same_W |]. rewrite Rmult_1_l, Rabs_pos_eq by lra. exact w_j.
        + split; [eapply Rle_trans; [| exact low_W]; apply bpow_le; lia | eapply Rle_lt_trans; [exact w_high |]; apply bpow_lt; lia].
    Qed.
  End Query.
End Float.

(* The statement for any thirteen numbers, including ones that are not finite: what is answered separated is; and where every
   point of the triangle is farther than that depth beyond the sphere, it is answered separated. Where the answer is known, all
   thirteen are finite. *)
Definition conservative_is_right (prec emax : Z) (depth : R)
  (answers : float_vec prec emax -> float_vec prec emax -> float_vec prec emax -> float_vec prec emax -> binary_float prec emax ->
    list bool) : Prop :=
  forall a b c p r,
  let says := nth 0 (answers a b c p r) false in
  let unknown := nth 1 (answers a b c p r) true in
  let a' := real_vec prec emax a in let b' := real_vec prec emax b in let c' := real_vec prec emax c in let p' := real_vec prec emax p in
  (unknown = false -> finite_vec prec emax a /\ finite_vec prec emax b /\ finite_vec prec emax c /\ finite_vec prec emax p /\
    is_finite r = true) /\
  (says = true -> unknown = false /\ separated a' b' c' p' (B2R r)) /\
  (unknown = false -> (forall X, in_triangle X a' b' c' -> B2R r + depth * query_size a' b' c' p' (B2R r) < distance p' X) -> says = true).

(* The formats and ranges for which the test is a program over rounded reals. *)
Definition conservative_fits (prec emax least half least_normal : Z) : Prop :=
  (20 <= prec /\ 3 - emax <= -3 /\ 20 <= emax /\ 0 <= half /\ 4 * half + 8 <= emax /\ 2 * half <= emax - prec /\
   3 - emax <= 2 * least /\ 2 - emax <= least <= emax - prec /\ 3 - emax - prec <= least_normal <= 0)%Z.

Section Instance.
  Variables prec emax least half least_normal : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation emin := (3 - emax - prec)%Z.
  Variables low high : binary_float prec emax -> binary_float prec emax -> binary_float prec emax.
  Variable inverse_power : binary_float prec emax -> binary_float prec emax.
  Notation F := (float_machine prec emax prec_gt_0_ prec_lt_emax_ low high inverse_power).
  Notation on_floats := (on_floats prec emax prec_gt_0_ prec_lt_emax_ low high inverse_power).
  Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
  Definition float_answers (a b c p : float_vec prec emax) (r : binary_float prec emax) : list bool :=
    conservative_answers F prec least least_normal (2 * half) (on_floats a) (on_floats b) (on_floats c) (on_floats p) r.

  Lemma rounded_is_itself x : rnd (rnd x) = rnd x.
  Proof using prec_gt_0_. apply round_generic; auto with typeclass_instances. apply generic_format_round; auto with typeclass_instances. Qed.
  Lemma float_instance depth : is_least prec emax low -> is_greatest prec emax high -> is_inverse_power prec emax inverse_power ->
    conservative_fits prec emax least half least_normal -> conservative_never_misses prec emin least least_normal ->
    conservative_phantoms_shallow prec emin least least_normal -> phantom_depth * sqrt (u prec) <= depth ->
    conservative_is_right prec emax depth float_answers.
  Proof using Type.
    intros low_is high_is inverse_is (prec20 & deep & emax20 & half0 & high4 & high2 & least2 & least_range & normal_range).
    intros never shallow enough.
    intros a b c p r. cbv zeta. unfold float_answers, conservative_answers. cbn [nth].
    pose proof (fun known => float_is_real prec emax _ _ low high inverse_power low_is high_is inverse_is prec20 ltac:(lia)
      least half least_normal
      ltac:(lia) ltac:(lia) ltac:(lia) a b c p r known) as same.
    pose proof (separated_on_reals rnd prec least_normal (real_vec prec emax a) (real_vec prec emax b) (real_vec prec emax c)
      (real_vec prec emax p) (B2R r)
      rounded_is_itself (round_NE_opp radix2 (FLT_exp emin prec))) as says.
    assert (formats : forall v, in_format prec emin (real_vec prec emax v)) by (intros v; repeat split; apply generic_format_B2R).
    destruct (program_known F least (2 * half) _ _ _ _ r); cbn [negb];
      [| split; [discriminate |]; split; [rewrite andb_false_r |]; discriminate].
    destruct (same eq_refl) as (finite & known & ->). rewrite andb_true_r. unfold program_known in known. rewrite !andb_true_iff in known.
    destruct known as (r0 & large & _). apply at_most_real_is in r0, large. cbn [m_constant real_machine] in large.
    rewrite Rmult_1_l in large.
    split; [auto |]. split.
    - intros apart. split; [reflexivity |]. apply (never _ _ _ _ _ (formats a) (formats b) (formats c) (formats p) r0 large), says, apart.
    - intros _ far. apply says, (shallow _ _ _ _ _ (formats a) (formats b) (formats c) (formats p) r0 large). intros X inside.
      eapply Rle_lt_trans; [| apply far, inside]. apply Rplus_le_compat_l, Rmult_le_compat_r; [| exact enough].
      unfold query_size. eapply Rle_trans; [exact r0 |]. eapply Rle_trans; [apply Rmax_r | apply Rmax_r].
  Qed.
End Instance.

Theorem float_conservative_is_right32 low high inverse_power : is_least 24 128 low -> is_greatest 24 128 high ->
  is_inverse_power 24 128 inverse_power ->
  conservative_is_right 24 128 (phantom_depth * sqrt (u 24))
    (float_answers 24 128 (-42) 30 (-60) eq_refl eq_refl low high inverse_power).
Proof.
  intros low_is high_is inverse_is.
  apply float_instance; try assumption; [unfold conservative_fits; lia | exact conservative_never_misses32 |
    exact conservative_phantoms_shallow32 | apply Rle_refl].
Qed.
Theorem float_conservative_is_right64 low high inverse_power : is_least 53 1024 low -> is_greatest 53 1024 high ->
  is_inverse_power 53 1024 inverse_power ->
  conservative_is_right 53 1024 (phantom_depth * sqrt (u 53))
    (float_answers 53 1024 (-400) 200 (-120) eq_refl eq_refl low high inverse_power).
Proof.
  intros low_is high_is inverse_is.
  apply float_instance; try assumption; [unfold conservative_fits; lia | exact conservative_never_misses64 |
    exact conservative_phantoms_shallow64 | apply Rle_refl].
Qed.
