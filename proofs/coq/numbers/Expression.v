(* A language of straight-line programs over + - * and fused multiply-add, and a bound of the rounding error of each of
   them, computed by integers and proved once, by induction, for every precision and every arithmetic that rounds with
   |rnd x - x| <= u |x| + eta.

   A value of degree k is compared with m^k, where m bounds the translated coordinates and the radius, so the bound does
   not depend on scale. Errors are counted in units of u / 1024, u = 2^-p, and rounded up to whole units. Underflow
   costs one unit per operation, inside a window of m in which eta <= unit m^k for each degree that occurs. *)
From Coq Require Import Reals ZArith List Lra Lia Psatz.
From Flocq Require Import Core.
Open Scope R_scope.

(* The inputs of a program: the nine translated coordinates, the radius, and m itself. *)
Inductive leaf := ax | ay | az | bx | by_ | bz | cx_ | cy_ | cz_ | radius | magnitude.

Inductive expression :=
  | Leaf (l : leaf)
  | Zero (k : nat)
  | Neg (a : expression)
  | Add (a b : expression)
  | Sub (a b : expression)
  | Mul (a b : expression)
  | Fma (a b c : expression)  (* a b + c, rounded once *)
  | Cap (c : Z) (a : expression).  (* a, whose exact value is known to satisfy |a| <= c m^degree *)

Fixpoint exact (x : leaf -> R) (e : expression) : R :=
  match e with
  | Leaf l => x l
  | Zero _ => 0
  | Neg a => - exact x a
  | Add a b => exact x a + exact x b
  | Sub a b => exact x a - exact x b
  | Mul a b => exact x a * exact x b
  | Fma a b c => exact x a * exact x b + exact x c
  | Cap _ a => exact x a
  end.

Fixpoint rounded (rnd : R -> R) (x : leaf -> R) (e : expression) : R :=
  match e with
  | Leaf l => x l
  | Zero _ => 0
  | Neg a => - rounded rnd x a
  | Add a b => rnd (rounded rnd x a + rounded rnd x b)
  | Sub a b => rnd (rounded rnd x a - rounded rnd x b)
  | Mul a b => rnd (rounded rnd x a * rounded rnd x b)
  | Fma a b c => rnd (rounded rnd x a * rounded rnd x b + rounded rnd x c)
  | Cap _ a => rounded rnd x a
  end.

Fixpoint degree (e : expression) : nat :=
  match e with
  | Leaf _ => 1
  | Zero k => k
  | Neg a | Add a _ | Sub a _ | Cap _ a => degree a
  | Mul a b | Fma a b _ => degree a + degree b
  end.

Open Scope Z_scope.
Definition greatest_degree : nat := 6.
Definition greatest_size : Z := 2 ^ 10.
Definition greatest_error : Z := 2 ^ 30.

(* exact: |x| <= size m^degree; computed: |X - x| <= error unit m^degree. *)
Record bounds := Bounds { size : Z; error : Z; of_degree : nat }.

(* The leaves other than coordinates are exact; each coordinate has the error of its subtraction. *)
Definition leaf_error (l : leaf) : Z := match l with radius | magnitude => 0 | _ => 1024 end.

Section Bound.
  Variable p : Z.  (* the precision in bits *)

  (* A value with these bounds, rounded; `cap` is a further bound of its size. *)
  Definition round_bounds (cap : option Z) (b : bounds) : option bounds :=
    let size := match cap with Some c => Z.min c (size b) | None => size b end in
    let error := error b + 1024 * size + (error b / 2 ^ p + 1) + 1 in
    if ((0 <=? size) && (size <=? greatest_size) && (error <=? greatest_error) && (of_degree b <=? greatest_degree)%nat)%bool
    then Some (Bounds size error (of_degree b)) else None.

  Definition sum_bounds (a b : bounds) : option bounds :=
    if (of_degree a =? of_degree b)%nat
    then Some (Bounds (size a + size b) (error a + error b) (of_degree a)) else None.

  Definition product_bounds (a b : bounds) : bounds :=
    Bounds (size a * size b)
           (error a * size b + size a * error b + (error a * error b / 2 ^ (p + 10) + 1))
           (of_degree a + of_degree b).

  Definition bind {A B} (x : option A) (f : A -> option B) : option B := match x with Some a => f a | None => None end.

  Fixpoint bound (cap : option Z) (e : expression) : option bounds :=
    match e with
    | Leaf l => Some (Bounds 1 (leaf_error l) 1)
    | Zero k => if (k <=? greatest_degree)%nat then Some (Bounds 0 0 k) else None
    | Neg a => bound None a
    | Add a b | Sub a b =>
      bind (bound None a) (fun x => bind (bound None b) (fun y => bind (sum_bounds x y) (round_bounds cap)))
    | Mul a b => bind (bound None a) (fun x => bind (bound None b) (fun y => round_bounds cap (product_bounds x y)))
    | Fma a b c =>
      bind (bound None a) (fun x => bind (bound None b) (fun y => bind (bound None c) (fun z =>
      bind (sum_bounds (product_bounds x y) z) (round_bounds cap))))
    | Cap c a => bound (Some c) a
    end.
End Bound.
Close Scope Z_scope.

(* The claims of a program's caps about the exact values. *)
Fixpoint caps_hold (x : leaf -> R) (m : R) (e : expression) : Prop :=
  match e with
  | Leaf _ | Zero _ => True
  | Neg a => caps_hold x m a
  | Add a b | Sub a b | Mul a b => caps_hold x m a /\ caps_hold x m b
  | Fma a b c => caps_hold x m a /\ caps_hold x m b /\ caps_hold x m c
  | Cap c a => Rabs (exact x a) <= IZR c * m ^ degree a /\ caps_hold x m a
  end.

(* Keeps sums and products of integers as they are written. *)
Local Arguments Z.mul : simpl never.
Local Arguments Z.add : simpl never.
Local Arguments Z.div : simpl never.
Local Arguments Z.pow : simpl never.

Section Sound.
  Variable p : Z.
  Hypothesis p_positive : (0 < p)%Z.
  Definition u := bpow radix2 (- p).
  Definition unit_of_error := bpow radix2 (- (p + 10)).

  Variable rnd : R -> R.
  Variable eta : R.
  Hypothesis rnd_error : forall x, Rabs (rnd x - x) <= u * Rabs x + eta.

  Variable m : R.
  Hypothesis m_positive : 0 < m.
  Hypothesis window : forall k, (k <= greatest_degree)%nat -> eta <= unit_of_error * m ^ k.

  (* The exact leaves and the computed ones. *)
  Variables x X : leaf -> R.
  Hypothesis leaf_size : forall l, Rabs (x l) <= m.
  Hypothesis leaf_close : forall l, Rabs (X l - x l) <= IZR (leaf_error l) * unit_of_error * m.

  Record within (b : bounds) (exact computed : R) : Prop := {
    size_nonneg : (0 <= size b)%Z;
    error_nonneg : (0 <= error b)%Z;
    degree_bound : (of_degree b <= greatest_degree)%nat;
    exact_size : Rabs exact <= IZR (size b) * m ^ of_degree b;
    close : Rabs (computed - exact) <= IZR (error b) * unit_of_error * m ^ of_degree b
  }.

  Lemma unit_positive : 0 < unit_of_error. Proof using Type. apply bpow_gt_0. Qed.
  Lemma u_units : u = 1024 * unit_of_error.
  Proof using Type.
    unfold u, unit_of_error. replace 1024 with (bpow radix2 10) by reflexivity. rewrite <- bpow_plus. f_equal; lia.
  Qed.

  (* A division by a power of two, rounded up. *)
  Lemma quotient_up a n : (0 <= a)%Z -> (0 <= n)%Z -> IZR a * bpow radix2 (- n) <= IZR (a / 2 ^ n + 1).
  Proof using Type.
    intros a0 n0. pose proof (Z.pow_pos_nonneg 2 n eq_refl n0) as positive.
    pose proof (Z.mul_succ_div_gt a (2 ^ n) positive).
    assert (IZR a <= IZR (a / 2 ^ n + 1) * bpow radix2 n) as H1.
    { rewrite <- (IZR_Zpower radix2) by assumption. rewrite <- mult_IZR. apply IZR_le.
      change (Zpower radix2 n) with (2 ^ n)%Z. lia. }
    apply Rmult_le_reg_r with (bpow radix2 n); [apply bpow_gt_0 |].
    rewrite Rmult_assoc, <- bpow_plus. replace (- n + n)%Z with 0%Z by lia. cbn [bpow]. lra.
  Qed.

  Lemma pow_positive k : 0 < m ^ k. Proof using m_positive. apply pow_lt, m_positive. Qed.

  Lemma sum_within a b c ea ca eb cb : sum_bounds a b = Some c -> within a ea ca -> within b eb cb ->
    within c (ea + eb) (ca + cb).
  Proof using Type.
    unfold sum_bounds. destruct (Nat.eqb_spec (of_degree a) (of_degree b)) as [same |]; [| discriminate].
    intros [= <-] [] []. constructor; cbn [size error of_degree]; try lia.
    - rewrite <- same in *. rewrite plus_IZR. eapply Rle_trans; [apply Rabs_triang |]. lra.
    - rewrite <- same in *. rewrite plus_IZR. replace (ca + cb - (ea + eb)) with ((ca - ea) + (cb - eb)) by ring.
      eapply Rle_trans; [apply Rabs_triang |]. lra.
  Qed.

  Lemma neg_within a e c : within a e c -> within a (- e) (- c).
  Proof using Type.
    intros []. constructor; try assumption; [rewrite Rabs_Ropp; assumption |].
    replace (- c - - e) with (- (c - e)) by ring. rewrite Rabs_Ropp. assumption.
  Qed.

  (* All of `within` except the bound of the degree, which has to be tested for a product. *)
  Lemma product_within a b ea ca eb cb : (of_degree a + of_degree b <= greatest_degree)%nat ->
    within a ea ca -> within b eb cb -> within (product_bounds p a b) (ea * eb) (ca * cb).
  Proof using m_positive p_positive.
    intros small [sa era _ xa la] [sb erb _ xb lb].
    assert (0 <= error a * error b / 2 ^ (p + 10))%Z as quotient by (apply Z.div_pos; [nia | apply Z.pow_pos_nonneg; lia]).
    constructor; cbn [size error of_degree product_bounds]; try nia.
    - rewrite Rabs_mult, mult_IZR, pow_add.
      replace (IZR (size a) * IZR (size b) * (m ^ of_degree a * m ^ of_degree b))
        with ((IZR (size a) * m ^ of_degree a) * (IZR (size b) * m ^ of_degree b)) by ring.
      apply Rmult_le_compat; auto using Rabs_pos.
    - rewrite pow_add. rewrite 2!plus_IZR, 2!mult_IZR.
      pose proof (quotient_up (error a * error b) (p + 10) ltac:(nia) ltac:(lia)) as up. rewrite mult_IZR in up.
      fold unit_of_error in up.
      pose proof (pow_positive (of_degree a)) as pa. pose proof (pow_positive (of_degree b)) as pb.
      set (ma := m ^ of_degree a) in *. set (mb := m ^ of_degree b) in *. pose proof unit_positive as up0.
      replace (ca * cb - ea * eb) with ((ca - ea) * eb + ea * (cb - eb) + (ca - ea) * (cb - eb)) by ring.
      assert (Rabs ((ca - ea) * eb) <= IZR (error a) * unit_of_error * ma * (IZR (size b) * mb)) as t1.
      { rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
      assert (Rabs (ea * (cb - eb)) <= IZR (size a) * ma * (IZR (error b) * unit_of_error * mb)) as t2.
      { rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
      assert (Rabs ((ca - ea) * (cb - eb)) <= IZR (error a) * unit_of_error * ma * (IZR (error b) * unit_of_error * mb)) as t3.
      { rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. }
      pose proof (Rabs_triang ((ca - ea) * eb + ea * (cb - eb)) ((ca - ea) * (cb - eb))).
      pose proof (Rabs_triang ((ca - ea) * eb) (ea * (cb - eb))).
      assert (IZR (error a) * unit_of_error * ma * (IZR (error b) * unit_of_error * mb) <=
              IZR (error a * error b / 2 ^ (p + 10) + 1) * unit_of_error * (ma * mb)) as t4.
      { replace (IZR (error a) * unit_of_error * ma * (IZR (error b) * unit_of_error * mb))
          with (IZR (error a) * IZR (error b) * unit_of_error * (unit_of_error * (ma * mb))) by ring.
        rewrite (Rmult_assoc (IZR (error a * error b / 2 ^ (p + 10) + 1))).
        apply Rmult_le_compat_r; [| assumption]. left. repeat apply Rmult_lt_0_compat; assumption. }
      lra.
  Qed.

  Lemma round_within cap b c e C :
    (match cap with Some z => Rabs e <= IZR z * m ^ of_degree b | None => True end) ->
    round_bounds p cap b = Some c ->
    ((of_degree b <= greatest_degree)%nat -> within b e C) -> within c e (rnd C).
  Proof using m_positive p_positive rnd_error window.
    intros known. unfold round_bounds.
    set (s := match cap with Some z => Z.min z (size b) | None => size b end).
    destruct (Z.leb_spec 0 s) as [s0 |]; [| discriminate].
    destruct (Z.leb_spec s greatest_size); [| discriminate]. destruct Z.leb; [| discriminate].
    destruct (Nat.leb_spec (of_degree b) greatest_degree) as [small |]; [| discriminate].
    cbn [andb]. intros [= <-] inside. destruct (inside small) as [sb eb _ xb cb]. clear inside.
    pose proof (pow_positive (of_degree b)) as pb. pose proof unit_positive as up.
    assert (0 <= error b / 2 ^ p)%Z as quotient by (apply Z.div_pos; [lia | apply Z.pow_pos_nonneg; lia]).
    assert (Rabs e <= IZR s * m ^ of_degree b) as xs.
    { unfold s. destruct cap; [| assumption]. destruct (Z.min_spec z (size b)) as [[_ ->] | [_ ->]]; assumption. }
    constructor; cbn [size error of_degree]; try lia; try assumption.
    rewrite !plus_IZR, mult_IZR. replace (rnd C - e) with ((rnd C - C) + (C - e)) by ring.
    eapply Rle_trans; [apply Rabs_triang |].
    pose proof (rnd_error C) as rounding. pose proof (window _ small) as underflow.
    assert (Rabs C <= (IZR s + IZR (error b) * unit_of_error) * m ^ of_degree b) as xC.
    { replace C with (e + (C - e)) by ring. eapply Rle_trans; [apply Rabs_triang |]. lra. }
    pose proof (quotient_up (error b) p ltac:(lia) ltac:(lia)) as q. fold u in q. rewrite plus_IZR in q.
    assert (u * Rabs C <= u * ((IZR s + IZR (error b) * unit_of_error) * m ^ of_degree b)) as step.
    { apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption]. }
    assert (IZR (error b) * u * (unit_of_error * m ^ of_degree b) <=
            (IZR (error b / 2 ^ p) + 1) * (unit_of_error * m ^ of_degree b)) as second.
    { apply Rmult_le_compat_r; [| assumption]. left. apply Rmult_lt_0_compat; assumption. }
    rewrite u_units in step at 2. pose proof u_units as uu. set (v := unit_of_error) in *. nra.
  Qed.

  Lemma bound_degree e : forall cap b, bound p cap e = Some b -> of_degree b = degree e.
  Proof using Type.
    assert (rounds : forall cap a b, round_bounds p cap a = Some b -> of_degree b = of_degree a).
    { intros cap a b. unfold round_bounds. destruct andb; [| discriminate]. intros [= <-]. reflexivity. }
    assert (sums : forall a b c, sum_bounds a b = Some c -> of_degree c = of_degree a).
    { intros a b c. unfold sum_bounds. destruct Nat.eqb; [| discriminate]. intros [= <-]. reflexivity. }
    induction e; intros cap bs; cbn [bound degree].
    - intros [= <-]. reflexivity.
    - destruct Nat.leb; [| discriminate]. intros [= <-]. reflexivity.
    - apply IHe.
    - destruct (bound p None e1) eqn:H1; [| discriminate]. destruct (bound p None e2) eqn:H2; [| discriminate].
      cbn [bind]. destruct sum_bounds eqn:S; [| discriminate]. intros H.
      rewrite (rounds _ _ _ H), (sums _ _ _ S). eapply IHe1, H1.
    - destruct (bound p None e1) eqn:H1; [| discriminate]. destruct (bound p None e2) eqn:H2; [| discriminate].
      cbn [bind]. destruct sum_bounds eqn:S; [| discriminate]. intros H.
      rewrite (rounds _ _ _ H), (sums _ _ _ S). eapply IHe1, H1.
    - destruct (bound p None e1) eqn:H1; [| discriminate]. destruct (bound p None e2) eqn:H2; [| discriminate].
      cbn [bind]. intros H. rewrite (rounds _ _ _ H). cbn [of_degree product_bounds].
      rewrite (IHe1 _ _ H1), (IHe2 _ _ H2). reflexivity.
    - destruct (bound p None e1) eqn:H1; [| discriminate]. destruct (bound p None e2) eqn:H2; [| discriminate].
      destruct (bound p None e3) eqn:H3; [| discriminate]. cbn [bind]. destruct sum_bounds eqn:S; [| discriminate].
      intros H. rewrite (rounds _ _ _ H), (sums _ _ _ S). cbn [of_degree product_bounds].
      rewrite (IHe1 _ _ H1), (IHe2 _ _ H2). reflexivity.
    - apply IHe.
  Qed.

  Theorem bound_sound e : forall cap b,
    bound p cap e = Some b ->
    (match cap with Some z => Rabs (exact x e) <= IZR z * m ^ degree e | None => True end) ->
    caps_hold x m e -> within b (exact x e) (rounded rnd X e).
  Proof using All.
    induction e; intros cap bs; cbn [bound degree exact rounded caps_hold].
    - intros [= <-] _ _. constructor; cbn [size error of_degree]; try lia.
      + destruct l; cbn; lia.
      + unfold greatest_degree; lia.
      + rewrite pow_1. pose proof (leaf_size l). lra.
      + rewrite pow_1. apply leaf_close.
    - destruct (Nat.leb_spec k greatest_degree); [| discriminate]. intros [= <-] _ _.
      pose proof (pow_positive k). constructor; cbn [size error of_degree]; try lia; try assumption.
      + rewrite Rabs_R0. lra.
      + rewrite Rminus_0_r, Rabs_R0. lra.
    - intros H _ caps. apply neg_within. apply (IHe None); auto.
    - destruct (bound p None e1) as [a |] eqn:H1; [| discriminate].
      destruct (bound p None e2) as [b |] eqn:H2; [| discriminate].
      cbn [bind]. destruct (sum_bounds a b) as [c |] eqn:S; [| discriminate]. cbn [bind]. intros H known [caps1 caps2].
      assert (of_degree c = degree e1) as dc.
      { unfold sum_bounds in S. destruct Nat.eqb; [| discriminate]. injection S as <-. apply (bound_degree _ None _ H1). }
      apply (round_within cap c); [rewrite dc; exact known | exact H |]. intros _.
      apply (sum_within a b); [assumption | apply (IHe1 None); auto | apply (IHe2 None); auto].
    - destruct (bound p None e1) as [a |] eqn:H1; [| discriminate].
      destruct (bound p None e2) as [b |] eqn:H2; [| discriminate].
      cbn [bind]. destruct (sum_bounds a b) as [c |] eqn:S; [| discriminate]. cbn [bind]. intros H known [caps1 caps2].
      assert (of_degree c = degree e1) as dc.
      { unfold sum_bounds in S. destruct Nat.eqb; [| discriminate]. injection S as <-. apply (bound_degree _ None _ H1). }
      apply (round_within cap c); [rewrite dc; exact known | exact H |]. intros _.
      apply (sum_within a b _ _ _ (- exact x e2) (- rounded rnd X e2));
        [assumption | apply (IHe1 None); auto | apply neg_within, (IHe2 None); auto].
    - destruct (bound p None e1) as [a |] eqn:H1; [| discriminate].
      destruct (bound p None e2) as [b |] eqn:H2; [| discriminate]. cbn [bind]. intros H known [caps1 caps2].
      pose proof (bound_degree _ _ _ H1) as d1. pose proof (bound_degree _ _ _ H2) as d2.
      apply (round_within cap (product_bounds p a b)); [cbn; rewrite d1, d2; exact known | exact H |]. intros small.
      apply product_within; [exact small | apply (IHe1 None); auto | apply (IHe2 None); auto].
    - destruct (bound p None e1) as [a |] eqn:H1; [| discriminate].
      destruct (bound p None e2) as [b |] eqn:H2; [| discriminate].
      destruct (bound p None e3) as [d |] eqn:H3; [| discriminate].
      cbn [bind]. destruct (sum_bounds (product_bounds p a b) d) as [c |] eqn:S; [| discriminate]. cbn [bind].
      intros H known (caps1 & caps2 & caps3).
      pose proof (bound_degree _ _ _ H1) as d1. pose proof (bound_degree _ _ _ H2) as d2.
      assert (of_degree c = (of_degree a + of_degree b)%nat) as dc.
      { unfold sum_bounds in S. destruct Nat.eqb; [| discriminate]. injection S as <-. reflexivity. }
      apply (round_within cap c); [rewrite dc, d1, d2; exact known | exact H |]. rewrite dc. intros small.
      apply (sum_within (product_bounds p a b) d); [assumption | | apply (IHe3 None); auto].
      apply product_within; [exact small | apply (IHe1 None); auto | apply (IHe2 None); auto].
    - intros H _ [known caps]. apply (IHe (Some c)); assumption.
  Qed.
End Sound.
