(* The coarse step and the single pair as recorded from the code that runs are the programs of CoarseFloat.v and PairStep.v,
   to the bit; so what is proved of these is proved of the code, for either sphere, plain and fused. *)
From Coq Require Import Reals ZArith Bool List Lra.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Expression Format Run Filter Certified CertifiedStep Sizes CoarseFloat OpenSphere
  OpenCoarse PairStep Machine RecordedCertified.
Import ListNotations.
Open Scope R_scope.

Definition recorded_order : list comparison :=
  [plane_radius; vertex_a_radius; vertex_a_side_b; vertex_a_side_c; vertex_b_radius; vertex_b_side_a; vertex_b_side_c;
   vertex_c_radius; vertex_c_side_a; vertex_c_side_b; edge_ab_radius; edge_ab_side_c; edge_bc_radius; edge_bc_side_a;
   edge_ca_radius; edge_ca_side_b].

(* A recorded definition asked about a query. *)
Notation of_query f prec emax M a b c p r :=
  (f M (fx prec emax a) (fy prec emax a) (fz prec emax a) (fx prec emax b) (fy prec emax b) (fz prec emax b)
     (fx prec emax c) (fy prec emax c) (fz prec emax c) (fx prec emax p) (fy prec emax p) (fz prec emax p) r).

Lemma swapped_and x y z : x && y && z = x && z && y. Proof. destruct x, y, z; reflexivity. Qed.
Lemma swapped_or x y z : x || y || z = x || z || y. Proof. destruct x, y, z; reflexivity. Qed.
(* An equation between the same comparisons, in which whole axes are joined: by `or` of what `and` joins, or the reverse. *)
Ltac by_comparisons := repeat match goal with |- context [Bltb ?x ?y] => let b := fresh "b" in set (b := Bltb x y); clearbody b end.
Ltac by_cases := repeat match goal with |- context [?b] => is_var b; match type of b with bool => destruct b end end; reflexivity.
Ltac by_axes_of_and := by_comparisons;
  repeat match goal with |- context [?x && ?y && ?z] => let b := fresh "axis" in set (b := x && y && z); clearbody b end;
  repeat match goal with |- context [?x && ?y] => let b := fresh "axis" in set (b := x && y); clearbody b end; by_cases.
Ltac by_axes_of_or := by_comparisons;
  repeat match goal with |- context [?x || ?y || ?z] => let b := fresh "axis" in set (b := x || y || z); clearbody b end;
  repeat match goal with |- context [?x || ?y] => let b := fresh "axis" in set (b := x || y); clearbody b end; by_cases.

Section Float.
  Variables prec emax least half : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Variable fused : bool.
  Variables low high : float -> float -> float.
  Notation margin := (float_margin prec emax _ _ fused).
  Notation threshold := (float_threshold prec emax _ _ fused).
  Notation constant := (constant prec emax _ _).

  (* The numbers that the coarse step computes, in the order of the recording. *)
  Definition coarse_numbers (a b c p : float_vec) (r : float) : list float :=
    map (margin a b c p r) recorded_order ++
    [float_S prec emax _ _ fused a b c p r; float_E prec emax _ _ fused a b c p r; threshold a b c p r vertex_a_radius;
     threshold a b c p r edge_ab_radius; threshold a b c p r plane_radius].

  (* The answer of a query, made as the code makes it: each axis is reduced to the least of its margins, the axes of a degree
     to the greatest of these. *)
  Section Answer.
    Variables (a b c p : float_vec) (r : float).
    Let m := margin a b c p r.
    Let in_range := float_in_range prec emax _ _ fused least half a b c p r.
    Let t2 := threshold a b c p r vertex_a_radius.
    Let t4 := threshold a b c p r edge_ab_radius.
    Let t6 := threshold a b c p r plane_radius.
    Definition some_beyond (vertices edges plane : float) : bool := Bltb t2 vertices || Bltb t4 edges || Bltb t6 plane.
    Definition all_within (vertices edges plane : float) : bool :=
      Bltb vertices (Bopp t2) && Bltb edges (Bopp t4) && Bltb plane (Bopp t6).
    Definition vertices_of := high (high (low (low (m vertex_a_radius) (m vertex_a_side_b)) (m vertex_a_side_c))
      (low (low (m vertex_b_radius) (m vertex_b_side_c)) (m vertex_b_side_a)))
      (low (low (m vertex_c_radius) (m vertex_c_side_a)) (m vertex_c_side_b)).
    Definition edges_of := high (high (low (m edge_ab_radius) (m edge_ab_side_c)) (low (m edge_bc_radius) (m edge_bc_side_a)))
      (low (m edge_ca_radius) (m edge_ca_side_b)).
    Definition says_separated : bool := in_range && some_beyond vertices_of edges_of (m plane_radius).
    Definition says_contact : bool := in_range && all_within vertices_of edges_of (m plane_radius).
    (* A lane of the single pair. *)
    Definition lane_vertex := low (low (m vertex_a_radius) (m vertex_a_side_b)) (m vertex_a_side_c).
    Definition lane_edge := low (m edge_ab_radius) (m edge_ab_side_c).
    Definition lane_says_separated : bool := in_range && some_beyond lane_vertex lane_edge (m plane_radius).
    Definition lane_says_contact : bool := in_range && all_within lane_vertex lane_edge (m plane_radius).
    Definition in_deep_range : bool :=
      let S := float_S prec emax _ _ fused a b c p r in
      Bleb (constant 1 (-100)) S && Bleb S (constant 1 198) && Bleb (B754_zero false) r.
  End Answer.
  Definition coarse_answers a b c p r : list bool := [says_separated a b c p r; says_contact a b c p r].
  Definition pair_answers a b c p r : list bool :=
    [lane_says_separated a b c p r || lane_says_separated b c a p r || lane_says_separated c a b p r;
     lane_says_contact a b c p r && lane_says_contact b c a p r && lane_says_contact c a b p r].

  (* The least and the greatest of finite numbers decide as the numbers do. *)
  Hypothesis low_is : is_least prec emax low.
  Hypothesis high_is : is_greatest prec emax high.
  Notation finite x := (is_finite x = true).
  Lemma less_low t x y : finite t -> finite x -> finite y ->
    finite (low x y) /\ Bltb t (low x y) = Bltb t x && Bltb t y /\ Bltb (low x y) t = Bltb x t || Bltb y t.
  Proof using low_is.
    intros Ft Fx Fy. destruct (least_of_finite prec emax low low_is x y Fx Fy) as [F value]. split; [exact F |]. rewrite !Bltb_correct, value by assumption.
    unfold Rmin. destruct Rle_dec; repeat case Rlt_bool_spec; intros; cbn; split; try reflexivity; exfalso; lra.
  Qed.
  Lemma less_high t x y : finite t -> finite x -> finite y ->
    finite (high x y) /\ Bltb t (high x y) = Bltb t x || Bltb t y /\ Bltb (high x y) t = Bltb x t && Bltb y t.
  Proof using high_is.
    intros Ft Fx Fy. destruct (greatest_of_finite prec emax high high_is x y Fx Fy) as [F value]. split; [exact F |]. rewrite !Bltb_correct, value by assumption.
    unfold Rmax. destruct Rle_dec; repeat case Rlt_bool_spec; intros; cbn; split; try reflexivity; exfalso; lra.
  Qed.

  Hypothesis fits : step_fits prec emax least half.
  Section Query.
    Variables (a b c p : float_vec) (r : float).
    Hypothesis inside : float_in_range prec emax _ _ fused least half a b c p r = true.
    Lemma all_finite K : finite (margin a b c p r K) /\ finite (threshold a b c p r K) /\ finite (Bopp (threshold a b c p r K)).
    Proof using fits inside.
      destruct fits as (p20 & half0 & fit & deep & least_range & constants).
      destruct (step_is_program prec emax _ _ fused least half a b c p r p20 half0 fit deep least_range constants inside K)
        as [(F & _) (F' & _)].
      rewrite is_finite_Bopp. auto.
    Qed.
    Notation m := (margin a b c p r).
    Lemma least_of_three t x y z : finite t -> finite x -> finite y -> finite z ->
      finite (low (low x y) z) /\ Bltb t (low (low x y) z) = Bltb t x && Bltb t y && Bltb t z /\
      Bltb (low (low x y) z) t = Bltb x t || Bltb y t || Bltb z t.
    Proof using low_is.
      intros Ft Fx Fy Fz. destruct (less_low t x y Ft Fx Fy) as (F & one & two). destruct (less_low t _ z Ft F Fz) as (F' & one' & two').
      rewrite one', two', one, two. auto.
    Qed.
    Lemma greatest_of_three t x y z : finite t -> finite x -> finite y -> finite z ->
      finite (high (high x y) z) /\ Bltb t (high (high x y) z) = Bltb t x || Bltb t y || Bltb t z /\
      Bltb (high (high x y) z) t = Bltb x t && Bltb y t && Bltb z t.
    Proof using high_is.
      intros Ft Fx Fy Fz. destruct (less_high t x y Ft Fx Fy) as (F & one & two). destruct (less_high t _ z Ft F Fz) as (F' & one' & two').
      rewrite one', two', one, two. auto.
    Qed.
    Notation t K := (threshold a b c p r K).
    Lemma beyond_is : some_beyond a b c p r (vertices_of a b c p r) (edges_of a b c p r) (m plane_radius) =
      some_axis_b (fun K => Bltb (t K) (m K)).
    Proof using All.
      unfold some_beyond, vertices_of, edges_of, some_axis_b. destruct (all_finite vertex_a_radius) as (_ & F2 & _).
      destruct (all_finite edge_ab_radius) as (_ & F4 & _). pose proof (fun K => proj1 (all_finite K)) as F.
      set (t2 := t vertex_a_radius) in *. set (t4 := t edge_ab_radius) in *.
      destruct (least_of_three t2 _ _ _ F2 (F vertex_a_radius) (F vertex_a_side_b) (F vertex_a_side_c)) as (Fa & la & _).
      destruct (least_of_three t2 _ _ _ F2 (F vertex_b_radius) (F vertex_b_side_c) (F vertex_b_side_a)) as (Fb & lb & _).
      destruct (least_of_three t2 _ _ _ F2 (F vertex_c_radius) (F vertex_c_side_a) (F vertex_c_side_b)) as (Fc & lc & _).
      destruct (less_low t4 _ _ F4 (F edge_ab_radius) (F edge_ab_side_c)) as (F1 & l1 & _).
      destruct (less_low t4 _ _ F4 (F edge_bc_radius) (F edge_bc_side_a)) as (F2' & l2 & _).
      destruct (less_low t4 _ _ F4 (F edge_ca_radius) (F edge_ca_side_b)) as (F3 & l3 & _).
      destruct (greatest_of_three t2 _ _ _ F2 Fa Fb Fc) as (_ & -> & _). destruct (greatest_of_three t4 _ _ _ F4 F1 F2' F3) as (_ & -> & _).
      rewrite la, lb, lc, l1, l2, l3.
      change (t vertex_a_side_b) with t2. change (t vertex_a_side_c) with t2. change (t vertex_b_radius) with t2.
      change (t vertex_b_side_a) with t2. change (t vertex_b_side_c) with t2. change (t vertex_c_radius) with t2.
      change (t vertex_c_side_a) with t2. change (t vertex_c_side_b) with t2. change (t edge_ab_side_c) with t4.
      change (t edge_bc_radius) with t4. change (t edge_bc_side_a) with t4. change (t edge_ca_radius) with t4.
      change (t edge_ca_side_b) with t4. rewrite (swapped_and (Bltb t2 (m vertex_b_radius))). by_axes_of_and.
    Qed.
    Lemma within_is : all_within a b c p r (vertices_of a b c p r) (edges_of a b c p r) (m plane_radius) =
      negb (some_axis_b (fun K => negb (Bltb (m K) (Bopp (t K))))).
    Proof using All.
      unfold all_within, vertices_of, edges_of, some_axis_b. destruct (all_finite vertex_a_radius) as (_ & _ & F2).
      destruct (all_finite edge_ab_radius) as (_ & _ & F4). pose proof (fun K => proj1 (all_finite K)) as F.
      set (t2 := Bopp (t vertex_a_radius)) in *. set (t4 := Bopp (t edge_ab_radius)) in *.
      destruct (least_of_three t2 _ _ _ F2 (F vertex_a_radius) (F vertex_a_side_b) (F vertex_a_side_c)) as (Fa & _ & la).
      destruct (least_of_three t2 _ _ _ F2 (F vertex_b_radius) (F vertex_b_side_c) (F vertex_b_side_a)) as (Fb & _ & lb).
      destruct (least_of_three t2 _ _ _ F2 (F vertex_c_radius) (F vertex_c_side_a) (F vertex_c_side_b)) as (Fc & _ & lc).
      destruct (less_low t4 _ _ F4 (F edge_ab_radius) (F edge_ab_side_c)) as (F1 & _ & l1).
      destruct (less_low t4 _ _ F4 (F edge_bc_radius) (F edge_bc_side_a)) as (F2' & _ & l2).
      destruct (less_low t4 _ _ F4 (F edge_ca_radius) (F edge_ca_side_b)) as (F3 & _ & l3).
      destruct (greatest_of_three t2 _ _ _ F2 Fa Fb Fc) as (_ & _ & ->). destruct (greatest_of_three t4 _ _ _ F4 F1 F2' F3) as (_ & _ & ->).
      rewrite la, lb, lc, l1, l2, l3.
      change (Bopp (t vertex_a_side_b)) with t2. change (Bopp (t vertex_a_side_c)) with t2. change (Bopp (t vertex_b_radius)) with t2.
      change (Bopp (t vertex_b_side_a)) with t2. change (Bopp (t vertex_b_side_c)) with t2. change (Bopp (t vertex_c_radius)) with t2.
      change (Bopp (t vertex_c_side_a)) with t2. change (Bopp (t vertex_c_side_b)) with t2. change (Bopp (t edge_ab_side_c)) with t4.
      change (Bopp (t edge_bc_radius)) with t4. change (Bopp (t edge_bc_side_a)) with t4. change (Bopp (t edge_ca_radius)) with t4.
      change (Bopp (t edge_ca_side_b)) with t4. rewrite !negb_orb, !negb_andb, !negb_involutive.
      rewrite (swapped_or (Bltb (m vertex_b_radius) t2)). by_axes_of_or.
    Qed.
    Lemma lane_beyond_is : some_beyond a b c p r (lane_vertex a b c p r) (lane_edge a b c p r) (m plane_radius) =
      lane_axis_b (fun K => Bltb (t K) (m K)).
    Proof using fits inside low_is.
      unfold some_beyond, lane_vertex, lane_edge, lane_axis_b. destruct (all_finite vertex_a_radius) as (_ & F2 & _).
      destruct (all_finite edge_ab_radius) as (_ & F4 & _). pose proof (fun K => proj1 (all_finite K)) as F.
      set (t2 := t vertex_a_radius) in *. set (t4 := t edge_ab_radius) in *.
      destruct (least_of_three t2 _ _ _ F2 (F vertex_a_radius) (F vertex_a_side_b) (F vertex_a_side_c)) as (_ & -> & _).
      destruct (less_low t4 _ _ F4 (F edge_ab_radius) (F edge_ab_side_c)) as (_ & -> & _).
      change (t vertex_a_side_b) with t2. change (t vertex_a_side_c) with t2. change (t edge_ab_side_c) with t4.
      by_comparisons. by_cases.
    Qed.
    Lemma lane_within_is : all_within a b c p r (lane_vertex a b c p r) (lane_edge a b c p r) (m plane_radius) =
      negb (lane_axis_b (fun K => negb (Bltb (m K) (Bopp (t K))))).
    Proof using fits inside low_is.
      unfold all_within, lane_vertex, lane_edge, lane_axis_b. destruct (all_finite vertex_a_radius) as (_ & _ & F2).
      destruct (all_finite edge_ab_radius) as (_ & _ & F4). pose proof (fun K => proj1 (all_finite K)) as F.
      set (t2 := Bopp (t vertex_a_radius)) in *. set (t4 := Bopp (t edge_ab_radius)) in *.
      destruct (least_of_three t2 _ _ _ F2 (F vertex_a_radius) (F vertex_a_side_b) (F vertex_a_side_c)) as (_ & _ & ->).
      destruct (less_low t4 _ _ F4 (F edge_ab_radius) (F edge_ab_side_c)) as (_ & _ & ->).
      change (Bopp (t vertex_a_side_b)) with t2. change (Bopp (t vertex_a_side_c)) with t2. change (Bopp (t edge_ab_side_c)) with t4.
      by_comparisons. by_cases.
    Qed.
  End Query.

  Lemma says_what_is_proved a b c p r :
    says_separated a b c p r = float_separated prec emax _ _ fused least half a b c p r /\
    says_contact a b c p r = float_contact prec emax _ _ fused least half a b c p r.
  Proof using fits high_is low_is.
    unfold says_separated, says_contact, float_separated, float_contact.
    destruct (float_in_range prec emax _ _ fused least half a b c p r) eqn:inside; [| auto]. cbn [andb].
    split; [apply beyond_is | apply within_is]; assumption.
  Qed.
  Lemma lane_says_what_is_proved a b c p r :
    lane_says_separated a b c p r = lane_separated prec emax least half _ _ fused a b c p r /\
    lane_says_contact a b c p r = lane_contact prec emax least half _ _ fused a b c p r.
  Proof using fits low_is.
    unfold lane_says_separated, lane_says_contact, lane_separated, lane_contact.
    destruct (float_in_range prec emax _ _ fused least half a b c p r) eqn:inside; [| auto]. cbn [andb].
    split; [apply lane_beyond_is | apply lane_within_is]; assumption.
  Qed.
  Theorem coarse_answers_are_proved a b c p r : coarse_answers a b c p r =
    [float_separated prec emax _ _ fused least half a b c p r; float_contact prec emax _ _ fused least half a b c p r].
  Proof using fits high_is low_is. unfold coarse_answers. destruct (says_what_is_proved a b c p r) as [-> ->]. reflexivity. Qed.
  Theorem pair_answers_are_proved a b c p r : pair_answers a b c p r =
    [pair_separated prec emax least half _ _ fused a b c p r; pair_contact prec emax least half _ _ fused a b c p r].
  Proof using fits low_is.
    unfold pair_answers, pair_separated, pair_contact. destruct (lane_says_what_is_proved a b c p r) as [-> ->].
    destruct (lane_says_what_is_proved b c a p r) as [-> ->]. destruct (lane_says_what_is_proved c a b p r) as [-> ->]. reflexivity.
  Qed.
End Float.

(* The recorded programs, by format and fusion. *)
Definition recorded_coarse_numbers32 (fused : bool) := if fused then coarse_fma_binary32_numbers else coarse_plain_binary32_numbers.
Definition recorded_coarse_numbers64 (fused : bool) := if fused then coarse_fma_binary64_numbers else coarse_plain_binary64_numbers.
Definition recorded_coarse_answers32 (fused : bool) := if fused then coarse_fma_binary32_answers else coarse_plain_binary32_answers.
Definition recorded_coarse_answers64 (fused : bool) := if fused then coarse_fma_binary64_answers else coarse_plain_binary64_answers.
Definition recorded_pair_answers32 (fused : bool) := if fused then pair_fma_binary32_answers else pair_plain_binary32_answers.
Definition recorded_pair_answers64 (fused : bool) := if fused then pair_fma_binary64_answers else pair_plain_binary64_answers.
Notation machine32 low high other := (float_machine 24 128 eq_refl eq_refl low high other).
Notation machine64 low high other := (float_machine 53 1024 eq_refl eq_refl low high other).

(* The least sizes are read before conversion compares the rest: where one differs, conversion unfolds the programs for hours. *)
Ltac has_least program least := let body := eval cbv delta [program] in program in
  lazymatch body with context [m_at_most _ (m_constant _ 1 least) _] => idtac end.
Goal True.
  has_least coarse_plain_binary32_answers (-21)%Z. has_least coarse_fma_binary32_answers (-21)%Z.
  has_least coarse_plain_binary64_answers (-300)%Z. has_least coarse_fma_binary64_answers (-300)%Z.
  has_least pair_plain_binary32_answers (-21)%Z. has_least pair_fma_binary32_answers (-21)%Z.
  has_least pair_plain_binary64_answers (-300)%Z. has_least pair_fma_binary64_answers (-300)%Z.
Abort.

(* Conversion leaves the operations alone: both sides have the same ones. *)
Local Strategy 1000 [Bplus Bminus Bmult Bfma Bopp binary_normalize Bltb Bleb].

Theorem recorded_coarse_margins32 low high other fused a b c p r :
  of_query (recorded_coarse_numbers32 fused) 24 128 (machine32 low high other) a b c p r =
  coarse_numbers 24 128 eq_refl eq_refl fused a b c p r.
Proof. destruct fused, a, b, c, p; reflexivity. Qed.
Theorem recorded_coarse_margins64 low high other fused a b c p r :
  of_query (recorded_coarse_numbers64 fused) 53 1024 (machine64 low high other) a b c p r =
  coarse_numbers 53 1024 eq_refl eq_refl fused a b c p r.
Proof. destruct fused, a, b, c, p; reflexivity. Qed.

(* The recorded answers are those of the step that never lies: separated, contact; and in doubles whether the deep step's
   range mostly holds, by which only the way of a query through the steps is chosen. *)
Theorem recorded_coarse_is_proved32 low high other : is_least 24 128 low -> is_greatest 24 128 high -> forall fused (a b c p : float_vec 24 128) r,
  of_query (recorded_coarse_answers32 fused) 24 128 (machine32 low high other) a b c p r =
  [float_separated 24 128 eq_refl eq_refl fused (-21) 19 a b c p r; float_contact 24 128 eq_refl eq_refl fused (-21) 19 a b c p r].
Proof.
  intros low_is high_is fused a b c p r.
  transitivity (coarse_answers 24 128 (-21) 19 eq_refl eq_refl fused low high a b c p r).
  - clear. destruct fused, a, b, c, p; reflexivity.
  - exact (coarse_answers_are_proved 24 128 (-21) 19 eq_refl eq_refl fused low high low_is high_is step_fits32 a b c p r).
Qed.
Theorem recorded_coarse_is_proved64 low high other : is_least 53 1024 low -> is_greatest 53 1024 high -> forall fused (a b c p : float_vec 53 1024) r,
  of_query (recorded_coarse_answers64 fused) 53 1024 (machine64 low high other) a b c p r =
  [float_separated 53 1024 eq_refl eq_refl fused (-300) 150 a b c p r; float_contact 53 1024 eq_refl eq_refl fused (-300) 150 a b c p r;
   in_deep_range 53 1024 eq_refl eq_refl fused a b c p r].
Proof.
  intros low_is high_is fused a b c p r.
  transitivity (coarse_answers 53 1024 (-300) 150 eq_refl eq_refl fused low high a b c p r ++ [in_deep_range 53 1024 eq_refl eq_refl fused a b c p r]).
  - clear. destruct fused, a, b, c, p; reflexivity.
  - exact (f_equal (fun l => l ++ [in_deep_range 53 1024 eq_refl eq_refl fused a b c p r]) (coarse_answers_are_proved 53 1024 (-300) 150 eq_refl eq_refl fused low high low_is high_is step_fits64 a b c p r)).
Qed.
Theorem recorded_pair_is_proved32 low high other : is_least 24 128 low -> forall fused (a b c p : float_vec 24 128) r,
  of_query (recorded_pair_answers32 fused) 24 128 (machine32 low high other) a b c p r =
  [pair_separated 24 128 (-21) 19 eq_refl eq_refl fused a b c p r; pair_contact 24 128 (-21) 19 eq_refl eq_refl fused a b c p r].
Proof.
  intros low_is fused a b c p r.
  transitivity (pair_answers 24 128 (-21) 19 eq_refl eq_refl fused low a b c p r).
  - clear. destruct fused, a, b, c, p; reflexivity.
  - exact (pair_answers_are_proved 24 128 (-21) 19 eq_refl eq_refl fused low low_is step_fits32 a b c p r).
Qed.
Theorem recorded_pair_is_proved64 low high other : is_least 53 1024 low -> forall fused (a b c p : float_vec 53 1024) r,
  of_query (recorded_pair_answers64 fused) 53 1024 (machine64 low high other) a b c p r =
  [pair_separated 53 1024 (-300) 150 eq_refl eq_refl fused a b c p r; pair_contact 53 1024 (-300) 150 eq_refl eq_refl fused a b c p r].
Proof.
  intros low_is fused a b c p r.
  transitivity (pair_answers 53 1024 (-300) 150 eq_refl eq_refl fused low a b c p r).
  - clear. destruct fused, a, b, c, p; reflexivity.
  - exact (pair_answers_are_proved 53 1024 (-300) 150 eq_refl eq_refl fused low low_is step_fits64 a b c p r).
Qed.
