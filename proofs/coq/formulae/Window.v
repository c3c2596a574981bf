(* The window of exponents in which nothing over- or underflows, by comparison.

   A query lies on the grid g where every translated coordinate and the radius is a whole multiple of 2^g. Then a value
   of degree k is a multiple of 2^(k g), rounded or not, and where k g is no less than the least exponent emin of the
   format, no operation underflows: each gives the same number as with an unbounded exponent. Where all numbers are at
   most 2^h in magnitude, a value of degree k is at most size 2^(k h), and where that is below 2^emax, nothing
   overflows. *)
From Coq Require Import Reals ZArith Lra Lia Psatz.
From Flocq Require Import Core BinarySingleNaN Relative.
From Axiscert Require Import Vectors Expression Programs Caps Run.
Open Scope R_scope.

(* The degree is at most k at every step, and sums are of equal degrees. *)
Fixpoint even_degrees (k : nat) (e : expression) : bool :=
  (degree e <=? k)%nat &&
  match e with
  | Leaf _ | Zero _ => true
  | Neg a | Cap _ a => even_degrees k a
  | Add a b | Sub a b => (degree a =? degree b)%nat && even_degrees k a && even_degrees k b
  | Mul a b => even_degrees k a && even_degrees k b
  | Fma a b c => (degree a + degree b =? degree c)%nat && even_degrees k a && even_degrees k b && even_degrees k c
  end.

Section Window.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation emin := (3 - emax - prec)%Z.
  Notation nearest := (nearest prec emax).
  Definition unbounded := round radix2 (FLX_exp prec) ZnearestE.

  Definition on_grid (j : Z) (x : R) : Prop := exists n : Z, x = IZR n * bpow radix2 j.

  Lemma grid_sum j x y : on_grid j x -> on_grid j y -> on_grid j (x + y).
  Proof using Type. intros [n ->] [k ->]. exists (n + k)%Z. rewrite plus_IZR. ring. Qed.
  Lemma grid_opposite j x : on_grid j x -> on_grid j (- x).
  Proof using Type. intros [n ->]. exists (- n)%Z. rewrite opp_IZR. ring. Qed.
  Lemma grid_product i j x y : on_grid i x -> on_grid j y -> on_grid (i + j) (x * y).
  Proof using Type. intros [n ->] [k ->]. exists (n * k)%Z. rewrite mult_IZR, bpow_plus. ring. Qed.

  (* A multiple of 2^j whose last place is no coarser is a number of the format. *)
  Lemma grid_format j x : on_grid j x -> (FLX_exp prec (mag radix2 x) <= j)%Z -> generic_format radix2 (FLX_exp prec) x.
  Proof using Type.
    intros [n ->] fine. apply generic_format_F2R' with (f := Float radix2 n j); [reflexivity |].
    intros _. exact fine.
  Qed.

  Lemma grid_rounded j x : on_grid j x -> on_grid j (unbounded x).
  Proof using Type.
    intros grid. destruct (Z_le_gt_dec (FLX_exp prec (mag radix2 x)) j) as [fine | coarse].
    - unfold unbounded. rewrite round_generic; [assumption | apply valid_rnd_N | apply (grid_format j); assumption].
    - unfold unbounded, round, F2R; cbn [Fnum Fexp]. unfold cexp.
      set (c := FLX_exp prec (mag radix2 x)) in *. set (n := ZnearestE _).
      exists (n * 2 ^ (c - j))%Z. rewrite mult_IZR. replace (IZR (2 ^ (c - j))) with (bpow radix2 (c - j)).
      + rewrite Rmult_assoc, <- bpow_plus. f_equal. f_equal. lia.
      + symmetry. apply (IZR_Zpower radix2). lia.
  Qed.

  (* On a grid no finer than the least exponent, the format rounds as one without exponent limits. *)
  Lemma grid_no_underflow j x : (emin <= j)%Z -> on_grid j x -> nearest x = unbounded x.
  Proof using Type.
    intros least grid. unfold Run.nearest, unbounded.
    destruct (Rle_or_lt (bpow radix2 (emin + prec - 1)) (Rabs x)) as [normal | small].
    { apply round_FLT_FLX. exact normal. }
    destruct grid as [n ->]. destruct (Req_dec (IZR n * bpow radix2 j) 0) as [-> | nonzero].
    { rewrite !round_0 by (apply valid_rnd_N). reflexivity. }
    assert (mag radix2 (IZR n * bpow radix2 j) <= emin + prec - 1)%Z as below by (apply mag_le_bpow; assumption).
    rewrite !round_generic; try reflexivity; try apply valid_rnd_N;
      apply generic_format_F2R' with (f := Float radix2 n j); try reflexivity; intros _;
      unfold cexp, FLX_exp, FLT_exp; cbn [Fexp]; lia.
  Qed.

  Lemma unbounded_error x : Rabs (unbounded x - x) <= u prec * Rabs x + 0.
  Proof using prec_gt_0_.
    pose proof (relative_error_N_FLX radix2 prec prec_gt_0_ (fun t => negb (Z.even t)) x) as error.
    unfold u. replace (bpow radix2 (- prec)) with (/ 2 * bpow radix2 (- prec + 1)).
    - rewrite Rplus_0_r. exact error.
    - rewrite bpow_plus. change (bpow radix2 1) with 2. lra.
  Qed.

  (* The numbers of a query. *)
  Variables (k : nat) (g h : Z).
  Hypothesis least : (emin <= Z.of_nat k * g)%Z.
  Variable floats : leaf -> float.
  Hypothesis leaf_finite : forall l, is_finite (floats l) = true.
  Hypothesis leaf_grid : forall l, on_grid g (B2R (floats l)).
  Hypothesis leaf_size : forall l, Rabs (B2R (floats l)) <= bpow radix2 h.
  Let X := fun l => B2R (floats l).

  Lemma degree_room e : even_degrees k e = true -> (emin <= Z.of_nat (degree e) * g)%Z.
  Proof using least prec_gt_0_ prec_lt_emax_.
    intros even. assert (degree e <= k)%nat.
    { destruct e; cbn [even_degrees] in even; apply andb_prop in even as [d _]; apply Nat.leb_le, d. }
    pose proof prec_lt_emax_. pose proof prec_gt_0_. unfold Prec_lt_emax, Prec_gt_0 in *.
    destruct (Z.le_gt_cases 0 g).
    - assert (0 <= Z.of_nat (degree e) * g)%Z by nia. lia.
    - assert (Z.of_nat k * g <= Z.of_nat (degree e) * g)%Z by nia. lia.
  Qed.

  Lemma value_on_grid e : even_degrees k e = true -> on_grid (Z.of_nat (degree e) * g) (rounded unbounded X e).
  Proof using leaf_grid.
    induction e; cbn [even_degrees rounded degree]; intros even; apply andb_prop in even as [_ even].
    - replace (Z.of_nat 1 * g)%Z with g by lia. apply leaf_grid.
    - exists 0%Z. ring.
    - apply grid_opposite, IHe, even.
    - apply andb_prop in even as [even e2']. apply andb_prop in even as [same e1']. apply Nat.eqb_eq in same.
      apply grid_rounded, grid_sum; [auto | rewrite same; auto].
    - apply andb_prop in even as [even e2']. apply andb_prop in even as [same e1']. apply Nat.eqb_eq in same.
      apply grid_rounded. unfold Rminus. apply grid_sum; [auto | apply grid_opposite; rewrite same; auto].
    - apply andb_prop in even as [e1' e2']. apply grid_rounded.
      rewrite Nat2Z.inj_add, Z.mul_add_distr_r. apply grid_product; auto.
    - apply andb_prop in even as [even e3']. apply andb_prop in even as [even e2'].
      apply andb_prop in even as [same e1']. apply Nat.eqb_eq in same.
      apply grid_rounded, grid_sum; [| rewrite same; auto].
      rewrite Nat2Z.inj_add, Z.mul_add_distr_r. apply grid_product; auto.
    - apply IHe, even.
  Qed.

  (* |value| <= (size + error unit) 2^(h k) is below 2^emax; at every step. *)
  Definition room (b : bounds) : bool :=
    ((size b * 2 ^ (prec + 10) + error b) * 2 ^ (h * Z.of_nat (of_degree b)) <? 2 ^ (emax + prec + 10))%Z.
  Fixpoint fits (cap : option Z) (e : expression) : bool :=
    match bound prec cap e with Some b => room b | None => false end &&
    match e with
    | Leaf _ | Zero _ => true
    | Neg a => fits None a
    | Cap c a => fits (Some c) a
    | Add a b | Sub a b | Mul a b => fits None a && fits None b
    | Fma a b c => fits None a && fits None b && fits None c
    end.

  Hypothesis h0 : (0 <= h)%Z.

  Lemma value_fits e cap : fits cap e = true ->
    (match cap with Some z => Rabs (exact X e) <= IZR z * bpow radix2 h ^ degree e | None => True end) ->
    caps_hold X (bpow radix2 h) e -> Rabs (rounded unbounded X e) < bpow radix2 emax.
  Proof using h0 k leaf_size prec_gt_0_ prec_lt_emax_.
    intros fit known caps. assert (exists b, bound prec cap e = Some b /\ room b = true) as (b & H & enough).
    { destruct e; cbn [fits] in fit; apply andb_prop in fit as [fit _]; destruct bound; try discriminate; eauto. }
    assert (within prec (bpow radix2 h) b (exact X e) (rounded unbounded X e)) as [s0 e0 _ xs close].
    { apply (bound_sound prec prec_gt_0_ unbounded 0 unbounded_error (bpow radix2 h)) with (cap := cap);
        try assumption.
      - apply bpow_gt_0.
      - intros i _. apply Rmult_le_pos; [left; apply unit_positive | left; apply pow_lt, bpow_gt_0].
      - intros l. rewrite Rminus_eq_0, Rabs_R0. repeat apply Rmult_le_pos; try (left; apply bpow_gt_0).
        apply IZR_le. destruct l; cbn; lia. }
    apply Z.ltb_lt in enough. apply IZR_lt in enough. rewrite mult_IZR, plus_IZR, mult_IZR in enough.
    pose proof prec_gt_0_. pose proof prec_lt_emax_. unfold Prec_lt_emax, Prec_gt_0 in *.
    change (2 ^ (prec + 10))%Z with (Zpower radix2 (prec + 10)) in enough.
    change (2 ^ (emax + prec + 10))%Z with (Zpower radix2 (emax + prec + 10)) in enough.
    change (2 ^ (h * Z.of_nat (of_degree b)))%Z with (Zpower radix2 (h * Z.of_nat (of_degree b))) in enough.
    rewrite !IZR_Zpower in enough by nia.
    assert (bpow radix2 h ^ of_degree b = bpow radix2 (h * Z.of_nat (of_degree b))) as powers.
    { clear. induction (of_degree b) as [| i IH]; [rewrite Z.mul_0_r; reflexivity |].
      cbn [pow]. rewrite IH, <- bpow_plus. f_equal. lia. }
    rewrite powers in *. set (M := bpow radix2 (h * Z.of_nat (of_degree b))) in *.
    apply Rmult_lt_reg_r with (bpow radix2 (prec + 10)); [apply bpow_gt_0 |]. rewrite <- bpow_plus, Z.add_assoc.
    apply Rle_lt_trans with (2 := enough).
    replace (rounded unbounded X e) with (exact X e + (rounded unbounded X e - exact X e)) by ring.
    apply Rle_trans with ((IZR (size b) * M + IZR (error b) * unit_of_error prec * M) * bpow radix2 (prec + 10)).
    { apply Rmult_le_compat_r; [apply bpow_ge_0 |]. eapply Rle_trans; [apply Rabs_triang |]. lra. }
    assert (unit_of_error prec * bpow radix2 (prec + 10) = 1) as inverse.
    { unfold unit_of_error. rewrite <- bpow_plus. replace (- (prec + 10) + (prec + 10))%Z with 0%Z by lia. reflexivity. }
    right. replace ((IZR (size b) * M + IZR (error b) * unit_of_error prec * M) * bpow radix2 (prec + 10))
      with (IZR (size b) * M * bpow radix2 (prec + 10) +
            IZR (error b) * M * (unit_of_error prec * bpow radix2 (prec + 10))) by ring.
    rewrite inverse. ring.
  Qed.

  (* Every operation gives the finite number that it gives with an unbounded exponent. *)
  Theorem run_unbounded e : forall cap, even_degrees k e = true -> fits cap e = true ->
    (match cap with Some z => Rabs (exact X e) <= IZR z * bpow radix2 h ^ degree e | None => True end) ->
    caps_hold X (bpow radix2 h) e ->
    is_finite (run prec emax _ _ floats e) = true /\ B2R (run prec emax _ _ floats e) = rounded unbounded X e.
  Proof using h0 leaf_finite leaf_grid leaf_size least.
    induction e; intros cap even fit known caps;
      pose proof (value_fits _ _ fit known caps) as small; pose proof (degree_room _ even) as room_below;
      cbn [even_degrees fits rounded run caps_hold degree] in *;
      apply andb_prop in even as [_ even]; apply andb_prop in fit as [_ fit].
    - split; [apply leaf_finite | reflexivity].
    - split; reflexivity.
    - destruct (IHe None even fit I caps) as [F E]. rewrite is_finite_Bopp, B2R_Bopp, E. auto.
    - apply andb_prop in even as [even e2']. apply andb_prop in even as [same e1']. apply Nat.eqb_eq in same.
      apply andb_prop in fit as [fit1 fit2]. destruct caps as [c1 c2].
      destruct (IHe1 None e1' fit1 I c1) as [F1 E1]. destruct (IHe2 None e2' fit2 I c2) as [F2 E2].
      assert (on_grid (Z.of_nat (degree e1) * g) (rounded unbounded X e1 + rounded unbounded X e2)) as grid.
      { apply grid_sum; [| rewrite same]; apply value_on_grid; assumption. }
      rewrite <- (grid_no_underflow _ _ room_below grid) in *. rewrite <- E1, <- E2 in *. apply plus_fits; assumption.
    - apply andb_prop in even as [even e2']. apply andb_prop in even as [same e1']. apply Nat.eqb_eq in same.
      apply andb_prop in fit as [fit1 fit2]. destruct caps as [c1 c2].
      destruct (IHe1 None e1' fit1 I c1) as [F1 E1]. destruct (IHe2 None e2' fit2 I c2) as [F2 E2].
      assert (on_grid (Z.of_nat (degree e1) * g) (rounded unbounded X e1 - rounded unbounded X e2)) as grid.
      { apply grid_sum; [| apply grid_opposite; rewrite same]; apply value_on_grid; assumption. }
      rewrite <- (grid_no_underflow _ _ room_below grid) in *. rewrite <- E1, <- E2 in *. apply minus_fits; assumption.
    - apply andb_prop in even as [e1' e2']. apply andb_prop in fit as [fit1 fit2]. destruct caps as [c1 c2].
      destruct (IHe1 None e1' fit1 I c1) as [F1 E1]. destruct (IHe2 None e2' fit2 I c2) as [F2 E2].
      rewrite Nat2Z.inj_add, Z.mul_add_distr_r in room_below.
      pose proof (grid_product _ _ _ _ (value_on_grid _ e1') (value_on_grid _ e2')) as grid.
      rewrite <- (grid_no_underflow _ _ room_below grid) in *. rewrite <- E1, <- E2 in *. apply mult_fits; assumption.
    - apply andb_prop in even as [even e3']. apply andb_prop in even as [even e2'].
      apply andb_prop in even as [same e1']. apply Nat.eqb_eq in same.
      apply andb_prop in fit as [fit fit3]. apply andb_prop in fit as [fit1 fit2]. destruct caps as (c1 & c2 & c3).
      destruct (IHe1 None e1' fit1 I c1) as [F1 E1]. destruct (IHe2 None e2' fit2 I c2) as [F2 E2].
      destruct (IHe3 None e3' fit3 I c3) as [F3 E3].
      assert (on_grid (Z.of_nat (degree e1 + degree e2) * g)
        (rounded unbounded X e1 * rounded unbounded X e2 + rounded unbounded X e3)) as grid.
      { apply grid_sum; [| rewrite same; apply value_on_grid; assumption].
        rewrite Nat2Z.inj_add, Z.mul_add_distr_r. apply grid_product; apply value_on_grid; assumption. }
      rewrite <- (grid_no_underflow _ _ room_below grid) in *. rewrite <- E1, <- E2, <- E3 in *. apply fma_fits; assumption.
    - destruct caps as [c1 c2]. apply (IHe (Some c)); assumption.
  Qed.
End Window.

(* A window, for the thirteen numbers of a translated query. *)
Definition in_window {prec emax} (g h : Z) (floats : leaf -> binary_float prec emax) : Prop := forall l,
  is_finite (floats l) = true /\ on_grid g (B2R (floats l)) /\ Rabs (B2R (floats l)) <= bpow radix2 h.

(* No operation of an expression over- or underflows: each gives the same result as with an unbounded exponent. *)
Definition as_unbounded {prec emax} (Hp : Prec_gt_0 prec) (He : Prec_lt_emax prec emax)
  (floats : leaf -> binary_float prec emax) (e : expression) : Prop :=
  is_finite (run prec emax Hp He floats e) = true /\
  B2R (run prec emax Hp He floats e) = rounded (unbounded prec) (fun l => B2R (floats l)) e.

Definition sides_as_unbounded {prec emax} Hp He (floats : leaf -> binary_float prec emax)
  (sides : expression * expression) : Prop :=
  as_unbounded Hp He floats (fst sides) /\ as_unbounded Hp He floats (snd sides).

(* The least grid: 2^emin is the least number, so that k g >= emin. *)
Definition least_grid (prec emax : Z) (k : nat) : Z := (- ((emax + prec - 3) / Z.of_nat k))%Z.

Definition window_degree (sides : expression * expression) : nat := degree (fst sides).

Definition window_checked (prec emax h : Z) (sides : expression * expression) : bool :=
  let k := window_degree sides in
  (even_degrees k (fst sides) && even_degrees k (snd sides) && (0 <=? h)%Z && (0 <? k)%nat &&
   fits prec emax h None (fst sides) && fits prec emax h None (snd sides)).

Lemma checked_window prec emax (Hp : Prec_gt_0 prec) (He : Prec_lt_emax prec emax) h sides floats :
  window_checked prec emax h sides = true ->
  caps_hold (fun l => B2R (floats l)) (bpow radix2 h) (fst sides) /\
  caps_hold (fun l => B2R (floats l)) (bpow radix2 h) (snd sides) ->
  in_window (least_grid prec emax (window_degree sides)) h floats -> sides_as_unbounded Hp He floats sides.
Proof.
  unfold window_checked. set (k := window_degree sides). intros checked [caps_l caps_r] inside.
  repeat (apply andb_prop in checked as [checked ?]).
  assert (0 < k)%nat as k0 by (apply Nat.ltb_lt; assumption).
  assert (3 - emax - prec <= Z.of_nat k * least_grid prec emax k)%Z as least.
  { unfold least_grid. pose proof (Z.mul_div_le (emax + prec - 3) (Z.of_nat k) ltac:(lia)). lia. }
  assert (0 <= h)%Z by (apply Z.leb_le; assumption).
  split; apply (run_unbounded prec emax Hp He k (least_grid prec emax k) h least floats) with (cap := None);
    try assumption; try exact I; intros l; apply (inside l).
Qed.
