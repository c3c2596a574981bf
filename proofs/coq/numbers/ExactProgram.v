(* Straight-line programs over integers: a program of sums, differences and products, what it computes, and how great its
   values can be. The exact step of the certified predicate is recorded as one (RecordedExact.v). *)
From Coq Require Import ZArith List Lia Reals Bool.
Import ListNotations.
Open Scope Z_scope.

(* The operands are the places of earlier values. *)
Inductive instruction := Plus (i j : nat) | Minus (i j : nat) | Times (i j : nat).

Section Run.
  Variable T : Type.
  Variables (zero : T) (plus minus times : T -> T -> T).
  Definition computed (values : list T) (x : instruction) : T :=
    match x with
    | Plus i j => plus (nth i values zero) (nth j values zero)
    | Minus i j => minus (nth i values zero) (nth j values zero)
    | Times i j => times (nth i values zero) (nth j values zero)
    end.
  Fixpoint run_program (values : list T) (program : list instruction) : list T :=
    match program with
    | [] => values
    | x :: rest => run_program (values ++ [computed values x]) rest
    end.
End Run.
Definition run_Z := run_program Z 0 Z.add Z.sub Z.mul.
Definition run_R := run_program R 0%R Rplus Rminus Rmult.

Lemma run_Z_is_run_R program : forall values, map IZR (run_Z values program) = run_R (map IZR values) program.
Proof.
  unfold run_Z, run_R. induction program as [| x rest IH]; intros values; [reflexivity |]. cbn [run_program]. rewrite IH, map_app. cbn [map].
  replace (IZR (computed Z 0 Z.add Z.sub Z.mul values x)) with (computed R 0%R Rplus Rminus Rmult (map IZR values) x); [reflexivity |].
  destruct x; cbn [computed]; rewrite !(map_nth IZR values 0); [rewrite plus_IZR | rewrite minus_IZR | rewrite mult_IZR]; reflexivity.
Qed.

(* A bound: less than c H^k in magnitude. *)
Definition bounded (H : Z) (bound : Z * Z) (v : Z) := 1 <= fst bound /\ 0 <= snd bound /\ Z.abs v < fst bound * H ^ snd bound.
Definition sum_bound (b b' : Z * Z) := (fst b + fst b', Z.max (snd b) (snd b')).
Definition product_bound (b b' : Z * Z) := (fst b * fst b', snd b + snd b').
Definition run_bound := run_program (Z * Z) (1, 0) sum_bound sum_bound product_bound.

Lemma greater_power H c k l : 1 <= H -> 1 <= c -> 0 <= k <= l -> c * H ^ k <= c * H ^ l.
Proof. intros. apply Z.mul_le_mono_nonneg_l; [lia |]. apply Z.pow_le_mono_r; lia. Qed.
Lemma bounded_sum H b b' v v' w : 1 <= H -> bounded H b v -> bounded H b' v' -> Z.abs w <= Z.abs v + Z.abs v' -> bounded H (sum_bound b b') w.
Proof.
  intros H1 (c1 & k0 & small) (c1' & k0' & small') sum. unfold bounded, sum_bound. cbn [fst snd].
  pose proof (greater_power H (fst b) (snd b) (Z.max (snd b) (snd b')) H1 c1 ltac:(lia)).
  pose proof (greater_power H (fst b') (snd b') (Z.max (snd b) (snd b')) H1 c1' ltac:(lia)).
  repeat split; lia.
Qed.
Lemma bounded_product H b b' v v' : 1 <= H -> bounded H b v -> bounded H b' v' -> bounded H (product_bound b b') (v * v').
Proof.
  intros H1 (c1 & k0 & small) (c1' & k0' & small'). unfold bounded, product_bound. cbn [fst snd]. rewrite Z.abs_mul, Z.pow_add_r by assumption.
  repeat split; [lia | lia |].
  replace (fst b * fst b' * (H ^ snd b * H ^ snd b')) with ((fst b * H ^ snd b) * (fst b' * H ^ snd b')) by ring.
  apply Z.mul_lt_mono_nonneg; lia.
Qed.

Lemma Forall2_nth {A B} (P : A -> B -> Prop) d d' : P d d' -> forall l l', Forall2 P l l' -> forall i, P (nth i l d) (nth i l' d').
Proof. intros default l l' all. induction all; intros [| i]; cbn; auto. Qed.

Lemma bounded_run H program : 1 <= H -> forall bounds values, Forall2 (bounded H) bounds values ->
  Forall2 (bounded H) (run_bound bounds program) (run_Z values program).
Proof.
  intros H1. unfold run_bound, run_Z. induction program as [| x rest IH]; intros bounds values all; [exact all |]. cbn [run_program].
  apply IH, Forall2_app; [exact all |]. constructor; [| constructor].
  assert (forall i, bounded H (nth i bounds (1, 0)) (nth i values 0)) as each.
  { apply Forall2_nth; [| exact all]. unfold bounded. cbn [fst snd]. rewrite Z.pow_0_r. lia. }
  destruct x as [i j | i j | i j]; cbn [computed].
  - apply (bounded_sum H _ _ _ _ _ H1 (each i) (each j)). lia.
  - apply (bounded_sum H _ _ _ _ _ H1 (each i) (each j)). lia.
  - apply bounded_product; auto.
Qed.

(* The bits of a signed integer of each degree, for a query whose numbers are below 2^(n - 1): `Integers` of
   kernel/sphere_triangle/certified/exact_step.cpp, and the words of 64 bits that it takes. *)
Definition bits_of (n degree : Z) : Z := degree * n + (if degree =? 1 then 1 else degree + 2).
Definition words_of (n degree : Z) : Z := (bits_of n degree + 63) / 64.

(* Whether a bound is below 2^(bits - 1), for every n: in units of H^degree, H = 2^(n - 1). *)
Definition fits (degree : nat) (bound : Z * Z) : bool :=
  let d := Z.of_nat degree in
  (1 <=? d) && (snd bound =? d) && (fst bound <=? (if d =? 1 then 2 else 2 ^ (2 * d + 1))).
Fixpoint all_fit (degrees : list nat) (bounds : list (Z * Z)) : bool :=
  match degrees, bounds with
  | [], [] => true
  | d :: degrees, b :: bounds => fits d b && all_fit degrees bounds
  | _, _ => false
  end.

Lemma fits_is_enough n degree bound v : 1 <= n -> fits degree bound = true -> bounded (2 ^ (n - 1)) bound v ->
  Z.abs v < 2 ^ (64 * words_of n (Z.of_nat degree) - 1).
Proof.
  intros n1 ok (c1 & k0 & small). unfold fits in ok. cbv zeta in ok. rewrite !andb_true_iff, Z.leb_le, Z.eqb_eq, Z.leb_le in ok.
  destruct ok as ((d1 & degree_is) & coefficient). set (d := Z.of_nat degree) in *. rewrite degree_is, <- Z.pow_mul_r in small by lia.
  assert (bits_of n d <= 64 * words_of n d) as words.
  { unfold words_of. pose proof (Z.div_mod (bits_of n d + 63) 64 ltac:(lia)). pose proof (Z.mod_pos_bound (bits_of n d + 63) 64 ltac:(lia)). lia. }
  apply Z.lt_le_trans with (2 ^ (bits_of n d - 1)).
  - eapply Z.lt_le_trans; [exact small |]. unfold bits_of. destruct (Z.eqb_spec d 1) as [one | more].
    + rewrite one in *. replace (1 * n + 1 - 1) with (1 + (n - 1) * 1) by ring. rewrite Z.pow_add_r by lia. change (2 ^ 1) with 2.
      apply Z.mul_le_mono_nonneg_r; [apply Z.pow_nonneg; lia | lia].
    + replace (d * n + (d + 2) - 1) with ((2 * d + 1) + (n - 1) * d) by ring. rewrite Z.pow_add_r by nia.
      apply Z.mul_le_mono_nonneg_r; [apply Z.pow_nonneg; lia | lia].
  - apply Z.pow_le_mono_r; lia.
Qed.
Lemma all_fit_is_enough n : 1 <= n -> forall degrees bounds values, all_fit degrees bounds = true ->
  Forall2 (bounded (2 ^ (n - 1))) bounds values -> Forall2 (fun d v => Z.abs v < 2 ^ (64 * words_of n (Z.of_nat d) - 1)) degrees values.
Proof.
  intros n1 degrees. induction degrees as [| d degrees IH]; intros bounds values ok all.
  - destruct all; [constructor | discriminate].
  - destruct all as [| b v bounds values one all]; [discriminate |]. cbn in ok. apply andb_true_iff in ok as [first rest].
    constructor; [apply fits_is_enough with b; assumption | apply IH with bounds; assumption].
Qed.
Lemma Forall2_skipn {A B} (P : A -> B -> Prop) k : forall l l', Forall2 P l l' -> Forall2 P (skipn k l) (skipn k l').
Proof. induction k as [| k IH]; intros l l' all; [exact all |]. destruct all; cbn; [constructor | apply IH; assumption]. Qed.

(* What the exact step asks of the values before it answers: the sign of one, a bit of what is known (group 0: fails, 1: radius,
   2: sides; axes a, b, c, plane, ab, bc, ca), or whether an axis separates. *)
Inductive asked :=
  | Is_positive (i : nat) | Is_negative (i : nat) | Is_zero (i : nat) | Is_at_least_zero (i : nat) | Is_at_most_zero (i : nat)
  | Knows (group axis : nat) | Separates (axis : nat).
Inductive tree := Answer (b : bool) | Ask (x : asked) (yes no : tree).
Fixpoint answer_of (says : asked -> bool) (t : tree) : bool :=
  match t with Answer b => b | Ask x yes no => if says x then answer_of says yes else answer_of says no end.
