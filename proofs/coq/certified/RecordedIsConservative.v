(* The conservative test as recorded from the code that runs is the program of ConservativeProgram.v, over any numbers; so what
   is proved of that program over IEEE-754 numbers is proved of the code, to the bit, for any thirteen numbers: it never misses a
   contact, and its phantoms are as shallow as certified.h promises. *)
From Coq Require Import Reals ZArith Bool List Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Expression Filter PhantomStep Machine ConservativeStep ConservativeProgram ConservativeFloat
  InversePower RecordedCertified RecordedIsCertified.
Open Scope R_scope.

Notation of_machine_query f m a b c p r :=
  (f m (mx a) (my a) (mz a) (mx b) (my b) (mz b) (mx c) (my c) (mz c) (mx p) (my p) (mz p) r).
Theorem recorded_conservative32 m (a b c p : machine_vec m) r : of_machine_query conservative_plain_binary32_answers m a b c p r =
  conservative_answers m 24 (-42) (-60) 60 a b c p r.
Proof. destruct a, b, c, p. reflexivity. Qed.
Theorem recorded_conservative64 m (a b c p : machine_vec m) r : of_machine_query conservative_plain_binary64_answers m a b c p r =
  conservative_answers m 53 (-400) (-120) 400 a b c p r.
Proof. destruct a, b, c, p. reflexivity. Qed.

(* The promised depth, n 2^e, is at least the proved one. *)
Definition promised (depth : Z * Z) : R := IZR (fst depth) * bpow radix2 (snd depth).
Lemma promised_is_enough prec depth : 0 <= promised depth -> phantom_depth * phantom_depth * u prec <= promised depth * promised depth ->
  phantom_depth * sqrt (u prec) <= promised depth.
Proof.
  intros positive enough. assert (0 <= u prec) as u0 by apply bpow_ge_0. assert (0 <= phantom_depth) as d0 by (unfold phantom_depth; lra).
  rewrite <- (sqrt_square _ positive), <- (sqrt_square phantom_depth d0), <- sqrt_mult by (try apply Rmult_le_pos; assumption).
  apply sqrt_le_1_alt. exact enough.
Qed.

Lemma right_if_same prec emax depth f g : (forall a b c p r, f a b c p r = g a b c p r) ->
  conservative_is_right prec emax depth g -> conservative_is_right prec emax depth f.
Proof. intros same right a b c p r. rewrite same. apply right. Qed.

Theorem recorded_conservative_is_right32 low high : is_least 24 128 low -> is_greatest 24 128 high ->
  conservative_is_right 24 128 (promised promised_phantom_depth_binary32)
    (fun a b c p r => of_query conservative_plain_binary32_answers 24 128 (machine32 low high inverse_power32) a b c p r).
Proof.
  intros low_is high_is. apply right_if_same with (float_answers 24 128 (-42) 30 (-60) eq_refl eq_refl low high inverse_power32).
  { intros. exact (recorded_conservative32 _ (on_floats 24 128 _ _ _ _ _ a) (on_floats 24 128 _ _ _ _ _ b)
      (on_floats 24 128 _ _ _ _ _ c) (on_floats 24 128 _ _ _ _ _ p) r). }
  apply float_instance; try assumption; [exact inverse_power_is32 | unfold conservative_fits; lia | exact conservative_never_misses32 |
    exact conservative_phantoms_shallow32 | apply promised_is_enough; unfold promised, phantom_depth; cbn; lra].
Qed.
Theorem recorded_conservative_is_right64 low high : is_least 53 1024 low -> is_greatest 53 1024 high ->
  conservative_is_right 53 1024 (promised promised_phantom_depth_binary64)
    (fun a b c p r => of_query conservative_plain_binary64_answers 53 1024 (machine64 low high inverse_power64) a b c p r).
Proof.
  intros low_is high_is. apply right_if_same with (float_answers 53 1024 (-400) 200 (-120) eq_refl eq_refl low high inverse_power64).
  { intros. exact (recorded_conservative64 _ (on_floats 53 1024 _ _ _ _ _ a) (on_floats 53 1024 _ _ _ _ _ b)
      (on_floats 53 1024 _ _ _ _ _ c) (on_floats 53 1024 _ _ _ _ _ p) r). }
  apply float_instance; try assumption; [exact inverse_power_is64 | unfold conservative_fits; lia | exact conservative_never_misses64 |
    exact conservative_phantoms_shallow64 | apply promised_is_enough; unfold promised, phantom_depth; cbn; lra].
Qed.
