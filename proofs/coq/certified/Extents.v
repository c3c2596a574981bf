(* Over doubles as over reals without exponent limits: a recorded program as terms, and how great and how small their values may be.
   A rounded operation that ends on a grid no finer than 2^-1074, or at no number but 0 below 2^-1022, does not underflow. *)
From Coq Require Import Reals ZArith Bool List Lra Lia Psatz.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Run Window Sizes Machine.
Import ListNotations.
Open Scope R_scope.

Inductive term :=
| Input (i : nat) | Nought | Constant (n e : Z) | Opposite (x : term) | Magnitude (x : term) | Sum (x y : term) | Difference (x y : term)
| Product (x y : term) | FusedSum (x y z : term) | Greatest (x y : term).
Lemma same_term (s t : term) : {s = t} + {s <> t}.
Proof. decide equality; first [apply Nat.eq_dec | apply Z.eq_dec]. Defined.

(* A machine that writes down what it is asked. Two numbers are equal as `flag` says; it has no other comparison. *)
Definition term_machine (flag : bool) : machine := {|
  m_number := term; m_zero := Nought; m_infinity := Nought; m_constant := Constant; m_negate := Opposite; m_magnitude := Magnitude;
  m_add := Sum; m_subtract := Difference; m_multiply := Product; m_divide := fun x _ => x; m_fused := FusedSum;
  m_least := fun x _ => x; m_greatest := Greatest; m_with_sign := fun x _ => x; m_inverse_power := fun x => x;
  m_less := fun _ _ => flag; m_at_most := fun _ _ => flag; m_equal := fun _ _ => flag
|}.
Fixpoint eval (m : machine) (x : nat -> m_number m) (t : term) : m_number m :=
  match t with
  | Input i => x i
  | Nought => m_zero m
  | Constant n e => m_constant m n e
  | Opposite a => m_negate m (eval m x a)
  | Magnitude a => m_magnitude m (eval m x a)
  | Sum a b => m_add m (eval m x a) (eval m x b)
  | Difference a b => m_subtract m (eval m x a) (eval m x b)
  | Product a b => m_multiply m (eval m x a) (eval m x b)
  | FusedSum a b c => m_fused m (eval m x a) (eval m x b) (eval m x c)
  | Greatest a b => m_greatest m (eval m x a) (eval m x b)
  end.

(* A multiple of 2^grid, and 0 or between 2^low and 2^high in magnitude. *)
Record extent := Extent { grid : Z; low : Z; high : Z; nonnegative : bool }.
Definition has_extent (d : extent) (x : R) : Prop :=
  on_grid (grid d) x /\ (x = 0 \/ bpow radix2 (low d) <= Rabs x) /\ Rabs x <= bpow radix2 (high d) /\ (nonnegative d = true -> 0 <= x).

Definition sum_extent (d d' : extent) : extent :=
  let both := nonnegative d && nonnegative d' in let g := Z.min (grid d) (grid d') in
  Extent g (if both then Z.min (low d) (low d') else g) (Z.max (high d) (high d') + 1) both.
Definition opposite_extent (d : extent) : extent := Extent (grid d) (low d) (high d) false.
Definition product_extent (square : bool) (d d' : extent) : extent :=
  Extent (grid d + grid d') (low d + low d') (high d + high d') (square || nonnegative d && nonnegative d').
Definition greatest_extent (d d' : extent) : extent :=
  Extent (Z.min (grid d) (grid d')) (Z.min (low d) (low d')) (Z.max (high d) (high d')) (nonnegative d || nonnegative d').

Definition is_rounded_well (d : extent) : bool := (((-1074 <=? grid d) || (-1022 <=? low d)) && (high d <? 1024))%Z.
Definition rounded_extent (d : extent) : option extent := if is_rounded_well d then Some d else None.
Definition bind (d : option extent) (f : extent -> option extent) : option extent := match d with Some d => f d | None => None end.
Fixpoint extent_of (leaf : nat -> extent) (t : term) : option extent :=
  let square (x y : term) := if same_term x y then true else false in
  match t with
  | Input i => Some (leaf i)
  | Nought => Some (Extent 0 0 0 true)
  | Constant n e =>
    if ((0 <? n) && (n <? 2 ^ 53) && (-1074 <=? e) && (e <=? 900))%Z then Some (Extent e (e + Z.log2 n) (e + Z.log2 n + 1) true) else None
  | Opposite a => bind (extent_of leaf a) (fun d => Some (opposite_extent d))
  | Magnitude a => bind (extent_of leaf a) (fun d => Some (Extent (grid d) (low d) (high d) true))
  | Sum a b => bind (extent_of leaf a) (fun d => bind (extent_of leaf b) (fun d' => rounded_extent (sum_extent d d')))
  | Difference a b =>
    bind (extent_of leaf a) (fun d => bind (extent_of leaf b) (fun d' => rounded_extent (sum_extent d (opposite_extent d'))))
  | Product a b => bind (extent_of leaf a) (fun d => bind (extent_of leaf b) (fun d' => rounded_extent (product_extent (square a b) d d')))
  | FusedSum a b c => bind (extent_of leaf a) (fun d => bind (extent_of leaf b) (fun d' => bind (extent_of leaf c) (fun d'' =>
      rounded_extent (sum_extent (product_extent (square a b) d d') d''))))
  | Greatest a b => bind (extent_of leaf a) (fun d => bind (extent_of leaf b) (fun d' => Some (greatest_extent d d')))
  end.

Lemma on_coarser_grid i j x : (i <= j)%Z -> on_grid j x -> on_grid i x.
Proof.
  intros coarser [n ->]. exists (n * 2 ^ (j - i))%Z. rewrite mult_IZR. change 2%Z with (radix_val radix2).
  rewrite IZR_Zpower, Rmult_assoc, <- bpow_plus by lia. do 2 f_equal. lia.
Qed.
Lemma grid_least j x : on_grid j x -> x = 0 \/ bpow radix2 j <= Rabs x.
Proof.
  intros [n ->]. destruct (Z.eq_dec n 0) as [-> | some]; [left; ring | right].
  rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 j)), <- abs_IZR by apply bpow_ge_0.
  rewrite <- (Rmult_1_l (bpow radix2 j)) at 1. apply Rmult_le_compat_r; [apply bpow_ge_0 |]. apply IZR_le. lia.
Qed.
Lemma below i j x : (i <= j)%Z -> Rabs x <= bpow radix2 i -> Rabs x <= bpow radix2 j.
Proof. intros. eapply Rle_trans; [eassumption | apply bpow_le; assumption]. Qed.
Lemma above i j x : (i <= j)%Z -> x = 0 \/ bpow radix2 j <= Rabs x -> x = 0 \/ bpow radix2 i <= Rabs x.
Proof. intros less [zero | more]; [left; exact zero | right]. eapply Rle_trans; [apply bpow_le; exact less | exact more]. Qed.

Lemma sum_within d d' x y : has_extent d x -> has_extent d' y -> has_extent (sum_extent d d') (x + y).
Proof.
  intros (gx & lx & hx & px) (gy & ly & hy & py). unfold sum_extent, has_extent. cbn [grid low high nonnegative].
  assert (on_grid (Z.min (grid d) (grid d')) (x + y)) as sum.
  { apply grid_sum; [apply (on_coarser_grid _ (grid d)) | apply (on_coarser_grid _ (grid d'))]; assumption || lia. }
  split; [exact sum |]. split; [| split].
  - destruct (nonnegative d), (nonnegative d'); cbn [andb]; try (apply grid_least; exact sum).
    specialize (px eq_refl). specialize (py eq_refl). rewrite (Rabs_pos_eq x px) in lx. rewrite (Rabs_pos_eq y py) in ly.
    rewrite (Rabs_pos_eq (x + y)) by lra.
    pose proof (bpow_le radix2 (Z.min (low d) (low d')) (low d) ltac:(lia)). pose proof (bpow_le radix2 (Z.min (low d) (low d')) (low d') ltac:(lia)).
    destruct lx as [-> | lx]; [destruct ly as [-> | ly]; [left; ring | right; lra] | right; lra].
  - rewrite bpow_plus. change (bpow radix2 1) with 2. pose proof (below (high d) (Z.max (high d) (high d')) x ltac:(lia) hx).
    pose proof (below (high d') (Z.max (high d) (high d')) y ltac:(lia) hy). eapply Rle_trans; [apply Rabs_triang | lra].
  - rewrite andb_true_iff. intros [p p']. specialize (px p). specialize (py p'). lra.
Qed.
Lemma opposite_within d x : has_extent d x -> has_extent (opposite_extent d) (- x).
Proof.
  intros (gx & lx & hx & _). unfold has_extent, opposite_extent. cbn [grid low high nonnegative]. rewrite Rabs_Ropp.
  split; [apply grid_opposite, gx |]. split; [destruct lx as [-> | lx]; [left; ring | right; exact lx] |]. split; [exact hx | discriminate].
Qed.
Lemma product_within (square : bool) d d' x y : (square = true -> x = y) -> has_extent d x -> has_extent d' y ->
  has_extent (product_extent square d d') (x * y).
Proof.
  intros same (gx & lx & hx & px) (gy & ly & hy & py). unfold has_extent, product_extent. cbn [grid low high nonnegative].
  rewrite Rabs_mult, !bpow_plus. split; [apply grid_product; assumption |]. split; [| split].
  - destruct lx as [-> | lx]; [left; ring |]. destruct ly as [-> | ly]; [left; ring | right].
    apply Rmult_le_compat; try assumption; apply bpow_ge_0.
  - apply Rmult_le_compat; try assumption; apply Rabs_pos.
  - destruct square; cbn [orb]; [intros _; rewrite (same eq_refl); apply Rle_0_sqr |].
    rewrite andb_true_iff. intros [p p']. apply Rmult_le_pos; auto.
Qed.

Section Doubles.
  Notation float := (binary_float 53 1024).
  Notation nearest := (nearest 53 1024).
  Notation unbounded := (unbounded 53).
  Local Instance doubles_have_bits : Prec_gt_0 53 := eq_refl.
  Variables (least greatest : float -> float -> float) (other : float -> float).
  Hypothesis greatest_is : is_greatest 53 1024 greatest.
  Notation F := (float_machine 53 1024 eq_refl eq_refl least greatest other).
  Notation N := (real_machine unbounded).

  Lemma rounded_within d x : has_extent d x -> has_extent d (unbounded x).
  Proof using Type.
    intros (gx & lx & hx & px). assert (forall e, generic_format radix2 (FLX_exp 53) (bpow radix2 e)) as power.
    { intros e. apply generic_format_bpow. unfold FLX_exp. lia. }
    split; [apply grid_rounded, gx |]. split; [| split].
    - destruct lx as [-> | lx]; [left; apply round_0, valid_rnd_N | right]. apply abs_round_ge_generic; auto using valid_rnd_N.
      apply FLX_exp_valid. exact doubles_have_bits.
    - apply abs_round_le_generic; auto using valid_rnd_N. apply FLX_exp_valid. exact doubles_have_bits.
    - intros p. apply round_ge_generic; auto using valid_rnd_N, generic_format_0. apply FLX_exp_valid. exact doubles_have_bits.
  Qed.
  Lemma nearest_is_unbounded d x : is_rounded_well d = true -> has_extent d x ->
    nearest x = unbounded x /\ Rabs (nearest x) < bpow radix2 1024.
  Proof using Type.
    unfold is_rounded_well. rewrite andb_true_iff, orb_true_iff, !Z.leb_le, Z.ltb_lt. intros (small & great) inside.
    assert (nearest x = unbounded x) as same.
    { destruct inside as (gx & lx & _ & _). destruct small as [g | l]; [apply (grid_no_underflow 53 1024 (grid d)); [exact g | exact gx] |].
      unfold Run.nearest, Window.unbounded. destruct lx as [-> | lx]; [rewrite !round_0 by apply valid_rnd_N; reflexivity |].
      apply round_FLT_FLX. eapply Rle_trans; [| exact lx]. apply bpow_le. exact l. }
    split; [exact same |]. rewrite same. destruct (rounded_within d x inside) as (_ & _ & hx & _).
    eapply Rle_lt_trans; [exact hx | apply bpow_lt; exact great].
  Qed.

  Definition fits (d : extent) (X : m_number F) (x : m_number N) : Prop := is_finite (X : float) = true /\ B2R (X : float) = x /\ has_extent d x.
  Variables (leaf : nat -> extent) (X : nat -> m_number F) (x : nat -> m_number N).
  Hypothesis leaves : forall i, fits (leaf i) (X i) (x i).

  (* A rounded operation. *)
  Lemma fits_rounded d e (Y : m_number F) z : rounded_extent d = Some e -> has_extent d z ->
    (Rabs (nearest z) < bpow radix2 1024 -> is_finite (Y : float) = true /\ B2R (Y : float) = nearest z) -> fits e Y (unbounded z).
  Proof using Type.
    unfold rounded_extent. destruct is_rounded_well eqn:well; [| discriminate]. intros [= <-] inside operation.
    destruct (nearest_is_unbounded d z well inside) as (same & fit). destruct (operation fit) as (FY & value).
    split; [exact FY |]. split; [rewrite value; exact same | apply rounded_within; exact inside].
  Qed.
  Lemma square_spec a b : (if same_term a b then true else false) = true -> eval N x a = eval N x b.
  Proof using Type. destruct same_term as [-> |]; [reflexivity | discriminate]. Qed.

  Theorem extent_is_right t : forall d, extent_of leaf t = Some d -> fits d (eval F X t) (eval N x t).
  Proof using greatest_is leaves.
    assert (pair : forall a b f d, bind (extent_of leaf a) (fun e => bind (extent_of leaf b) (f e)) = Some d ->
      exists e e', extent_of leaf a = Some e /\ extent_of leaf b = Some e' /\ f e e' = Some d).
    { intros a b f d. destruct (extent_of leaf a) as [e |]; [| discriminate]. destruct (extent_of leaf b) as [e' |]; [| discriminate].
      cbn [bind]. intros H. exists e, e'. auto. }
    induction t; intros d; cbn [extent_of eval].
    - intros [= <-]. apply leaves.
    - intros [= <-]. split; [reflexivity |]. split; [reflexivity |]. split; [exists 0%Z; cbn; ring |]. split; [left; reflexivity |].
      split; [change (Rabs 0 <= 1); rewrite Rabs_R0; lra | intros _; apply Rle_refl].
    - destruct andb eqn:range; [| discriminate]. intros [= <-]. rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le in range.
      destruct range as (((n0 & few) & e0) & e1).
      destruct (constant_spec 53 1024 eq_refl eq_refl ltac:(lia) n e ltac:(lia) ltac:(lia)) as (FC & value).
      destruct (Z.log2_spec n n0) as (least_power & next_power). split; [exact FC |]. split; [exact value |].
      cbn [m_constant real_machine]. unfold has_extent. cbn [grid Extents.low high nonnegative].
      assert (0 < IZR n) as positive by (apply IZR_lt; exact n0).
      rewrite (Rabs_pos_eq (IZR n * bpow radix2 e)) by (apply Rmult_le_pos; [lra | apply bpow_ge_0]).
      change 2%Z with (radix_val radix2) in least_power, next_power. pose proof (Z.log2_nonneg n) as log0.
      apply IZR_le in least_power. apply IZR_lt in next_power. rewrite IZR_Zpower in least_power, next_power by lia.
      split; [exists n; reflexivity |]. split; [right | split].
      + rewrite Z.add_comm, bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | exact least_power].
      + replace (e + Z.log2 n + 1)%Z with (Z.succ (Z.log2 n) + e)%Z by lia. rewrite bpow_plus.
        apply Rmult_le_compat_r; [apply bpow_ge_0 | lra].
      + intros _. apply Rmult_le_pos; [lra | apply bpow_ge_0].
    - destruct (extent_of leaf t) as [e |]; [| discriminate]. cbn [bind]. intros [= <-]. destruct (IHt e eq_refl) as (FX & value & inside).
      unfold fits. cbn [m_negate float_machine real_machine]. rewrite is_finite_Bopp, B2R_Bopp, value.
      split; [exact FX |]. split; [reflexivity | apply opposite_within, inside].
    - destruct (extent_of leaf t) as [e |]; [| discriminate]. cbn [bind]. intros [= <-].
      destruct (IHt e eq_refl) as (FX & value & (gx & lx & hx & px)).
      unfold fits. cbn [m_magnitude float_machine real_machine]. rewrite is_finite_Babs, B2R_Babs, value.
      split; [exact FX |]. split; [reflexivity |]. unfold has_extent. cbn [grid Extents.low high nonnegative]. rewrite Rabs_Rabsolu.
      split; [unfold Rabs; destruct Rcase_abs; [apply grid_opposite |]; exact gx |].
      split; [destruct lx as [-> | lx]; [left; apply Rabs_R0 | right; exact lx] |]. split; [exact hx | intros _; apply Rabs_pos].
    - intros H. apply pair in H as (e & e' & H1 & H2 & H). destruct (IHt1 e H1) as (F1 & <- & in1), (IHt2 e' H2) as (F2 & <- & in2).
      apply (fits_rounded _ _ _ _ H); [apply sum_within; assumption |]. intros fit. apply (plus_fits 53 1024); assumption.
    - intros H. apply pair in H as (e & e' & H1 & H2 & H). destruct (IHt1 e H1) as (F1 & <- & in1), (IHt2 e' H2) as (F2 & <- & in2).
      apply (fits_rounded _ _ _ _ H); [apply sum_within; [| apply opposite_within]; assumption |]. intros fit. apply (minus_fits 53 1024); assumption.
    - intros H. apply pair in H as (e & e' & H1 & H2 & H). pose proof (square_spec t1 t2) as same.
      destruct (IHt1 e H1) as (F1 & v1 & in1), (IHt2 e' H2) as (F2 & v2 & in2).
      apply (fits_rounded _ _ _ _ H); [apply product_within; assumption |]. rewrite <- v1, <- v2. intros fit. apply (mult_fits 53 1024); assumption.
    - destruct (extent_of leaf t1) as [e |] eqn:H1; [| discriminate]. destruct (extent_of leaf t2) as [e' |] eqn:H2; [| discriminate].
      destruct (extent_of leaf t3) as [e'' |] eqn:H3; [| discriminate]. cbn [bind]. intros H. pose proof (square_spec t1 t2) as same.
      destruct (IHt1 e eq_refl) as (F1 & v1 & in1), (IHt2 e' eq_refl) as (F2 & v2 & in2), (IHt3 e'' eq_refl) as (F3 & v3 & in3).
      apply (fits_rounded _ _ _ _ H); [apply sum_within; [apply product_within |]; assumption |].
      rewrite <- v1, <- v2, <- v3. intros fit. apply (fma_fits 53 1024); assumption.
    - intros H. apply pair in H as (e & e' & H1 & H2 & H). injection H as <-.
      destruct (IHt1 e H1) as (F1 & v1 & (g1 & l1 & h1 & p1)), (IHt2 e' H2) as (F2 & v2 & (g2 & l2 & h2 & p2)).
      destruct (greatest_of_finite 53 1024 greatest greatest_is _ _ F1 F2) as (FG & value). split; [exact FG |].
      split; [cbn [m_greatest float_machine real_machine]; rewrite value, v1, v2; reflexivity |].
      cbn [m_greatest real_machine]. unfold has_extent, greatest_extent. cbn [grid Extents.low high nonnegative].
      assert (forall z, 0 <= eval N x t1 \/ 0 <= eval N x t2 -> z = Rmax (eval N x t1) (eval N x t2) -> 0 <= z) as more.
      { intros z [a | b] ->; [eapply Rle_trans; [exact a | apply Rmax_l] | eapply Rle_trans; [exact b | apply Rmax_r]]. }
      split; [| split; [| split]].
      + unfold Rmax. destruct Rle_dec; [apply (on_coarser_grid _ (grid e')) | apply (on_coarser_grid _ (grid e))]; assumption || lia.
      + unfold Rmax. destruct Rle_dec; [apply (above _ (Extents.low e')) | apply (above _ (Extents.low e))]; assumption || lia.
      + unfold Rmax. destruct Rle_dec; [apply (below (high e')) | apply (below (high e))]; assumption || lia.
      + rewrite orb_true_iff. intros some. apply (more _ ltac:(tauto) eq_refl).
  Qed.

  Lemma less_same d e Y y Z z : fits d Y y -> fits e Z z -> m_less F Y Z = m_less N y z.
  Proof using Type.
    intros (FY & <- & _) (FZ & <- & _). cbn [m_less float_machine real_machine]. rewrite Bltb_correct by assumption. unfold less_real.
    destruct Rlt_dec; [apply Rlt_bool_true | apply Rlt_bool_false]; lra.
  Qed.
  Lemma at_most_same d e Y y Z z : fits d Y y -> fits e Z z -> m_at_most F Y Z = m_at_most N y z.
  Proof using Type.
    intros (FY & <- & _) (FZ & <- & _). cbn [m_at_most float_machine real_machine]. rewrite Bleb_correct by assumption. unfold at_most_real.
    destruct Rle_dec; [apply Rle_bool_true | apply Rle_bool_false]; lra.
  Qed.
  Lemma equal_same d e Y y Z z : fits d Y y -> fits e Z z -> m_equal F Y Z = m_equal N y z.
  Proof using Type.
    intros (FY & <- & _) (FZ & <- & _). cbn [m_equal float_machine real_machine]. rewrite Beqb_correct by assumption. unfold equal_real.
    destruct Req_EM_T; [apply Req_bool_true | apply Req_bool_false]; assumption.
  Qed.
  Lemma negate_fits d Y y : fits d Y y -> fits (opposite_extent d) (m_negate F Y) (m_negate N y).
  Proof using Type.
    intros (FY & <- & inside). unfold fits. cbn [m_negate float_machine real_machine]. rewrite is_finite_Bopp, B2R_Bopp.
    split; [exact FY |]. split; [reflexivity | apply opposite_within, inside].
  Qed.
End Doubles.
