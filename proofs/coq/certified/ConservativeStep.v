(* The conservative test as a program, in binary32 and binary64: it never answers separated where there is a contact. *)
From Coq Require Import Reals ZArith Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Exact Expression Format Lanes Certified CertifiedStep Conservative.
Open Scope R_scope.

(* The program over any rounding, from a query's own numbers: the operations of
   kernel/sphere_triangle/certified/conservative_step-inl.h in the same order, never fused. *)
Section Program.
  Variable rnd : R -> R.
  Variables (u least_square : R) (a b c p : vec) (r : R).
  Let A := rounded_sub rnd a p.
  Let B := rounded_sub rnd b p.
  Let C := rounded_sub rnd c p.
  Let product := rounded_dot rnd false.
  Let aa := product A A.
  Let bb := product B B.
  Let cc := product C C.
  Let ab := product A B.
  Let bc := product B C.
  Let ca := product C A.
  Let rr := rnd (r * r).
  Definition conservative_W := Rmax (Rmax aa bb) (Rmax cc rr).
  Let error := rnd (conservative_error * u * conservative_W).
  Let square_error := rnd (conservative_square_error * u * conservative_W).
  Let passes (m square : R) := 0 < m /\ rnd (rnd (rr + square_error) * square) < rnd (m * m).
  (* The position, from X to Y along an edge as computed, of the point nearest to the centre. *)
  Definition conservative_share (X along : vec) :=
    let e := product along along in
    Rmin (Rmax (if Rlt_dec 0 e then rnd (- product X along / e) else 0) 0) 1.
  Let mix (s x y : R) := rnd (x + rnd (s * rnd (y - x))).
  Definition conservative_edge (X along : vec) (xx xy yy xz yz : R) :=
    let s := conservative_share X along in
    let at_x := mix s xx xy in
    let at_y := mix s xy yy in
    passes (rnd (Rmin (Rmin at_x at_y) (mix s xz yz) - error)) (rnd (mix s at_x at_y + square_error)).
  (* V scaled by the power of two below 1 / W. *)
  Definition conservative_normal :=
    let V := rounded_cross rnd false (rounded_sub rnd A C) (rounded_sub rnd B A) in
    let k := bpow radix2 (1 - mag radix2 conservative_W) in
    Vec (rnd (cx V * k)) (rnd (cy V * k)) (rnd (cz V * k)).
  Definition conservative_plane :=
    let n := conservative_normal in
    let side x := if Rlt_dec (product A n) 0 then - x else x in
    least_square <= product n n /\ passes (Rmin (Rmin (side (product A n)) (side (product B n))) (side (product C n))) (product n n).
  Definition conservative_separated :=
    conservative_edge A (rounded_sub rnd B A) aa ab bb ca bc \/
    conservative_edge B (rounded_sub rnd C B) bb bc cc ab ca \/
    conservative_edge C (rounded_sub rnd A C) cc ca aa bc ab \/
    conservative_plane.
End Program.

Lemma rounded_dot_swapped rnd X Y : rounded_dot rnd false X Y = rounded_dot rnd false Y X.
Proof. unfold rounded_dot. rewrite (Rmult_comm (cx X)), (Rmult_comm (cy X)), (Rmult_comm (cz X)). reflexivity. Qed.
Lemma least_of x y z : let m := Rmin (Rmin x y) z in (m <= x /\ m <= y /\ m <= z) /\ (m = x \/ m = y \/ m = z).
Proof. cbv zeta. unfold Rmin. repeat destruct Rle_dec; repeat split; lra. Qed.
Lemma share_range rnd X along : 0 <= conservative_share rnd X along <= 1.
Proof. unfold conservative_share. set (t := if Rlt_dec _ _ then _ else _). unfold Rmin, Rmax. repeat destruct Rle_dec; lra. Qed.

Section Format.
  Variables prec emin least least_normal : Z.
  Hypothesis prec20 : (20 <= prec)%Z.
  Hypothesis low_2 : (emin - 1 <= least - prec - 20)%Z.
  Hypothesis low_4 : (emin - 1 <= 2 * (least - prec) - 17)%Z.
  Hypothesis low_normal : (emin - 1 <= least_normal - prec - 21)%Z.
  Hypothesis low_product : (emin - 1 <= least_normal + least - prec - 21)%Z.
  Let rnd := round radix2 (FLT_exp emin prec) ZnearestE.
  Let u := Expression.u prec.
  Let eta := half_least emin.
  Notation in_format := (in_format prec emin).
  Variables (a b c p : vec) (r : R).
  Hypothesis formats : in_format a /\ in_format b /\ in_format c /\ in_format p.
  Hypothesis r_nonneg : 0 <= r.
  Let W := conservative_W rnd a b c p r.
  Hypothesis large_enough : bpow radix2 least <= W.

  Lemma eta_power : eta = bpow radix2 (emin - 1).
  Proof using Type. unfold eta, half_least. replace (emin - 1)%Z with (emin + -1)%Z by lia. rewrite bpow_plus. change (bpow radix2 (-1)) with (/ 2).
  ring. Qed.
  Lemma u_range : 0 < u <= / 1048576.
  Proof using prec20. split; [apply bpow_gt_0 | apply (u_small prec prec20)]. Qed.
  Lemma W_positive : 0 < W.
  Proof using large_enough. pose proof (bpow_gt_0 radix2 least). lra. Qed.
  (* eta is below the least power of two that a product can reach. *)
  Lemma eta_below k e x : (emin - 1 <= k + e)%Z -> bpow radix2 e <= x -> eta <= bpow radix2 k * x.
  Proof using Type.
    intros low large. rewrite eta_power. apply Rle_trans with (bpow radix2 (k + e)); [apply bpow_le; assumption |].
    rewrite bpow_plus. apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption].
  Qed.
  Lemma uW_large : bpow radix2 (least - prec) <= u * W.
  Proof using large_enough.
    replace (least - prec)%Z with (- prec + least)%Z by lia. rewrite bpow_plus.
    apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption].
  Qed.
  Lemma underflow_2 : eta <= / 1000000 * (u * W).
  Proof using large_enough low_2 prec20.
    apply Rle_trans with (bpow radix2 (-20) * (u * W)); [apply eta_below with (least - prec)%Z; [lia | apply uW_large] |].
    pose proof (Rmult_lt_0_compat _ _ (proj1 u_range) W_positive). apply Rmult_le_compat_r; [lra | cbn; lra].
  Qed.
  Lemma underflow_4 : eta <= / 100000 * (u * W * (u * W)).
  Proof using large_enough low_4 prec20.
    pose proof (Rmult_lt_0_compat _ _ (proj1 u_range) W_positive) as v0. pose proof uW_large as large.
    apply Rle_trans with (bpow radix2 (-17) * (u * W * (u * W))).
    - apply eta_below with (2 * (least - prec))%Z; [lia |]. replace (2 * (least - prec))%Z with (least - prec + (least - prec))%Z by lia.
      rewrite bpow_plus. apply Rmult_le_compat; try assumption; apply bpow_ge_0.
    - apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | cbn; lra].
  Qed.

  Lemma W_greatest : let product := rounded_dot rnd false in let A := rounded_sub rnd a p in let B := rounded_sub rnd b p in
    let C := rounded_sub rnd c p in product A A <= W /\ product B B <= W /\ product C C <= W /\ rnd (r * r) <= W.
  Proof using emin prec.
    cbv zeta. unfold W, conservative_W. repeat split.
    - eapply Rle_trans; [| apply Rmax_l]. apply Rmax_l.
    - eapply Rle_trans; [| apply Rmax_l]. apply Rmax_r.
    - eapply Rle_trans; [| apply Rmax_r]. apply Rmax_l.
    - eapply Rle_trans; [| apply Rmax_r]. apply Rmax_r.
  Qed.
  Let dots X Y : computed_dot u eta X Y (rounded_dot rnd false X Y).
  Proof using emin prec20. apply dot_is_computed, (rounding prec emin prec20). Qed.
  Let leaf v : in_format v -> leaf_of u (sub v p) (rounded_sub rnd v p).
  Proof using formats prec20. intros fv. apply (leaf_difference prec emin prec20); [assumption | apply formats]. Qed.

  (* The axes of an edge and of the plane, for any order of the vertices. *)
  Lemma edge_passes X Y Z along : let product := rounded_dot rnd false in let A := rounded_sub rnd a p in
    let B := rounded_sub rnd b p in let C := rounded_sub rnd c p in vertex A B C X -> vertex A B C Y -> vertex A B C Z ->
    (forall T, vertex A B C T -> T = X \/ T = Y \/ T = Z) ->
    conservative_edge rnd u a b c p r X along (product X X) (product X Y) (product Y Y) (product X Z) (product Y Z) ->
    separated a b c p r.
  Proof using dots large_enough leaf low_2 low_4 r_nonneg.
    cbv zeta. intros vX vY vZ all [positive beyond]. apply separated_iff_clear; [assumption |].
    destruct formats as (fa & fb & fc & _). pose proof (rounding prec emin prec20) as rounds_to. fold rnd u eta in rounds_to.
    destruct (least_of (rnd (rounded_dot rnd false X X + rnd (conservative_share rnd X along * rnd (rounded_dot rnd false X Y - rounded_dot
      rnd false X X))))
      (rnd (rounded_dot rnd false X Y + rnd (conservative_share rnd X along * rnd (rounded_dot rnd false Y Y - rounded_dot rnd false X Y))))
      (rnd (rounded_dot rnd false X Z + rnd (conservative_share rnd X along * rnd (rounded_dot rnd false Y Z - rounded_dot rnd false X
        Z)))))
      as [(lx & ly & lz) one].
    apply (edge_axis u eta u_range (eta_positive emin) (sub a p) (sub b p) (sub c p) (rounded_sub rnd a p) (rounded_sub rnd b p)
      (rounded_sub rnd c p) r _ _ _ _ W r_nonneg (leaf a fa) (leaf b fb) (leaf c fc) (dots _ _) (dots _ _) (dots _ _) (rounds_to _)
      W_greatest W_positive underflow_2 _ _ (rounds_to _) (rounds_to _) _ (rounds_to _) underflow_4 X Y Z _ _ _ _ _
      (conservative_share rnd X along) _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ vX vY vZ all (share_range rnd X along)
      (dots _ _) (dots _ _) (dots _ _) (dots _ _) (dots _ _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _)
        (rounds_to _)
      (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) lx ly lz one
      (rounds_to _) (rounds_to _) (rounds_to _) positive beyond).
  Qed.
  Lemma plane_passes : conservative_plane rnd u (bpow radix2 least_normal) a b c p r -> separated a b c p r.
  Proof using dots large_enough leaf low_2 low_normal low_product r_nonneg.
    intros (long & positive & beyond). apply separated_iff_clear; [assumption |].
    destruct formats as (fa & fb & fc & _). pose proof (rounding prec emin prec20) as rounds_to. fold rnd u eta in rounds_to.
    set (n := conservative_normal rnd a b c p r) in *.
    assert (bpow radix2 (least_normal - 1) <= dot n n) as normal_long.
    { pose proof (dot_error u eta ltac:(pose proof u_range; lra) (eta_positive emin) _ _ _ (dots n n)) as off. rewrite sizes_square in off.
      apply Rabs_le_inv in off. pose proof (small u ltac:(pose proof u_range; lra) _ (dot_self_nonneg n)).
      assert (bpow radix2 least_normal = 2 * bpow radix2 (least_normal - 1)) as twice.
      { replace least_normal with (1 + (least_normal - 1))%Z at 1 by lia. rewrite bpow_plus. reflexivity. }
      pose proof (eta_below (-20) least_normal (bpow radix2 least_normal) ltac:(lia) ltac:(lra)) as tiny.
      pose proof (bpow_gt_0 radix2 (least_normal - 1)). cbn in tiny. unfold eta in *. lra. }
    pose proof u_range as [u0 _]. pose proof W_positive as W0. pose proof (Rmult_lt_0_compat _ _ u0 W0) as v0.
    pose proof (dot_self_nonneg n) as n0.
    assert (eta <= / 1000000 * (u * dot n n)) as tiny.
    { apply Rle_trans with (bpow radix2 (-20) * (u * dot n n)).
      - apply eta_below with (- prec + (least_normal - 1))%Z; [lia |]. rewrite bpow_plus. apply Rmult_le_compat_l;
        [apply bpow_ge_0 | assumption].
      - apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | cbn; lra]. }
    assert (eta <= / 1000000 * (u * W * dot n n)) as tiny'.
    { apply Rle_trans with (bpow radix2 (-20) * (u * W * dot n n)).
      - apply eta_below with (least - prec + (least_normal - 1))%Z; [lia |]. rewrite bpow_plus.
        apply Rmult_le_compat; try apply bpow_ge_0; [apply uW_large | assumption].
      - apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | cbn; lra]. }
    eapply (plane_axis u eta u_range (eta_positive emin) (sub a p) (sub b p) (sub c p) (rounded_sub rnd a p) (rounded_sub rnd b p)
      (rounded_sub rnd c p) r _ _ _ _ W r_nonneg (leaf a fa) (leaf b fb) (leaf c fc) (dots _ _) (dots _ _) (dots _ _) (rounds_to _)
      W_greatest W_positive underflow_2 _ _ (rounds_to _) (rounds_to _) n _ _ _ _ _ _ _ (dots _ _) (dots _ _) (dots _ _) (dots _ _));
      [| exact tiny | exact tiny' | apply rounds_to | apply rounds_to | exact positive | exact beyond].
    destruct Rlt_dec; [right | left]; apply least_of.
  Qed.
  Lemma conservative_sound : conservative_separated rnd u (bpow radix2 least_normal) a b c p r -> separated a b c p r.
  Proof using All.
    set (A := rounded_sub rnd a p). set (B := rounded_sub rnd b p). set (C := rounded_sub rnd c p).
    pose proof (or_introl eq_refl : vertex A B C A) as vA. pose proof (or_intror (or_introl eq_refl) : vertex A B C B) as vB.
    pose proof (or_intror (or_intror eq_refl) : vertex A B C C) as vC.
    intros [H | [H | [H | H]]]; [| | | apply plane_passes; exact H].
    - apply (edge_passes A B C (rounded_sub rnd B A) vA vB vC); [unfold vertex; tauto |]. rewrite (rounded_dot_swapped rnd A C). exact H.
    - apply (edge_passes B C A (rounded_sub rnd C B) vB vC vA); [unfold vertex; tauto |]. rewrite (rounded_dot_swapped rnd B A). exact H.
    - apply (edge_passes C A B (rounded_sub rnd A C) vC vA vB); [unfold vertex; tauto |]. rewrite (rounded_dot_swapped rnd C B). exact H.
  Qed.
End Format.

(* The statement for a format, the least W and the least square of the scaled normal of the test's range. *)
Definition conservative_never_misses (prec emin least least_normal : Z) : Prop := forall a b c p r,
  in_format prec emin a -> in_format prec emin b -> in_format prec emin c -> in_format prec emin p -> 0 <= r ->
  let rnd := round radix2 (FLT_exp emin prec) ZnearestE in
  bpow radix2 least <= conservative_W rnd a b c p r ->
  conservative_separated rnd (u prec) (bpow radix2 least_normal) a b c p r -> separated a b c p r.

(* binary32 and binary64, over numbers without a greatest one; ConservativeFloat.v has overflow. *)
Theorem conservative_never_misses32 : conservative_never_misses 24 (-149) (-42) (-60).
Proof. intros a b c p r fa fb fc fp r0 rnd large says. apply (conservative_sound 24 (-149) (-42) (-60)); try lia; try tauto; lra. Qed.
Theorem conservative_never_misses64 : conservative_never_misses 53 (-1074) (-400) (-120).
Proof. intros a b c p r fa fb fc fp r0 rnd large says. apply (conservative_sound 53 (-1074) (-400) (-120)); try lia; try tauto; lra. Qed.
