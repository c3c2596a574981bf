(* The fine step of the certified predicate as a program, and what its margins and bounds are worth: over a rounding whose
   error is at most u of the exact result, so where nothing underflows, each margin as computed is within its bound as computed of
   the exact one. The program is the one recorded from the code that runs. *)
From Coq Require Import Reals ZArith Bool List Lra Psatz FunctionalExtensionality.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Reduced Lanes Margins Certified CertifiedStep ExactStep Machine RecordedCertified.
Import ListNotations.
Open Scope R_scope.

Section Program.
  Variable rnd : R -> R.
  Variable fused : bool.
  Let number n e := IZR n * bpow radix2 e.
  (* The constants as they are in the code: multiples of u = 2^-53 and a sixteenth of it, then factors. *)
  Definition fine_vertex_radius := number 51 (-56).
  Definition fine_vertex_side := number 255 (-57).
  Definition fine_normal := number 17 (-54).
  Definition fine_offset := number 17 (-55).
  Definition fine_plane_lhs := number 17 (-56).
  Definition fine_plane_rhs := number 51 (-56).
  Definition fine_edge_square := number 17 (-55).
  Definition fine_edge_rhs := number 17 (-54).
  Definition fine_edge_side := number 51 (-57).
  Definition fine_once := number 17 (-4).
  Definition fine_once_offset := number 9 (-3).
  Definition fine_twice := number 17 (-3).
  Definition fine_thrice_in_side := number 6980579422424269 (-51).
  Definition fine_thrice := number 3602879701896397 (-50).

  Definition mul_add (x y z : R) := if fused then rnd (x * y + z) else rnd (z + rnd (x * y)).
  Definition sum_of (v : vec) := rnd (rnd (Rabs (cx v) + Rabs (cy v)) + Rabs (cz v)).
  Definition error_of (x y : vec) := rnd (fine_normal * rnd (greatest_component x * greatest_component y)).

  Variables (a b c p : vec) (r : R).
  Let A := rounded_sub rnd a p. Let B := rounded_sub rnd b p. Let C := rounded_sub rnd c p.
  Let AB := rounded_sub rnd b a. Let BC := rounded_sub rnd c b. Let CA := rounded_sub rnd a c.
  Let rr := rnd (r * r).
  (* Dot and cross products. *)
  Variable product : vec -> vec -> R.
  Variable across : vec -> vec -> vec.
  (* V is taken as zero where B = C. *)
  Definition b_is_c : bool := equal_real (greatest_component BC) 0.
  Definition fine_V : vec := let n := across CA AB in
    Vec (if b_is_c then 0 else cx n) (if b_is_c then 0 else cy n) (if b_is_c then 0 else cz n).
  Definition fine_omega : R := if b_is_c then 0 else error_of CA AB.
  Let V := fine_V. Let omega := fine_omega.

  Definition fine_radius (X : vec) : R * R := let s := product X X in (rnd (s - rr), rnd (fine_vertex_radius * rnd (s + rr))).
  Definition fine_side (X Y : vec) : R * R :=
    (product X Y, rnd (rnd (fine_vertex_side * greatest_component X) * greatest_component Y)).
  Definition opposite (m : R * R) : R * R := (- fst m, snd m).
  Definition fine_plane : R * R :=
    let three_omega := rnd (fine_thrice * omega) in
    let D := product A V in
    let delta := rnd (greatest_component A * mul_add fine_offset (sum_of V) three_omega) in
    let lhs := rnd (D * D) in
    let rhs := rnd (rr * product V V) in
    let lhs_error := mul_add delta (mul_add fine_twice (Rabs D) (rnd (delta * fine_once_offset))) (rnd (fine_plane_lhs * lhs)) in
    let rhs_error := mul_add rr (rnd (omega * mul_add fine_twice (sum_of V) three_omega)) (rnd (fine_plane_rhs * rhs)) in
    (rnd (lhs - rhs), rnd (lhs_error + rhs_error)).
  Definition fine_edge_radius (X Y : vec) : R * R :=
    let N := across X Y in
    let nu := error_of X Y in
    let s := product N N in
    let rhs := rnd (rr * product Y Y) in
    (rnd (s - rhs), mul_add nu (mul_add fine_twice (sum_of N) (rnd (fine_thrice * nu)))
      (mul_add fine_edge_square s (rnd (fine_edge_rhs * rhs)))).
  Definition fine_edge_side_margin (X Y : vec) : R * R :=
    let N := across X Y in
    let nu := error_of X Y in
    (- product N V, mul_add (rnd (omega * fine_once)) (mul_add fine_thrice_in_side nu (sum_of N))
      (rnd (sum_of V * mul_add fine_edge_side (sum_of N) (rnd (nu * fine_once))))).

  (* The margin and its bound. *)
  Definition fine_margin (K : comparison) : R * R :=
    match K with
    | plane_radius => fine_plane
    | vertex_a_radius => fine_radius A
    | vertex_a_side_b => fine_side A AB
    | vertex_a_side_c => opposite (fine_side A CA)
    | vertex_b_radius => fine_radius B
    | vertex_b_side_a => opposite (fine_side B AB)
    | vertex_b_side_c => fine_side B BC
    | vertex_c_radius => fine_radius C
    | vertex_c_side_a => fine_side C CA
    | vertex_c_side_b => opposite (fine_side C BC)
    | edge_ab_radius => fine_edge_radius A AB
    | edge_ab_side_c => fine_edge_side_margin A AB
    | edge_bc_radius => fine_edge_radius B BC
    | edge_bc_side_a => fine_edge_side_margin B BC
    | edge_ca_radius => fine_edge_radius C CA
    | edge_ca_side_b => fine_edge_side_margin C CA
    end.
  Definition fine_numbers : list R :=
    flat_map (fun K => [fst (fine_margin K); snd (fine_margin K)])
      [plane_radius; vertex_a_radius; vertex_a_side_b; vertex_a_side_c; vertex_b_radius; vertex_b_side_a; vertex_b_side_c;
       vertex_c_radius; vertex_c_side_a; vertex_c_side_b; edge_ab_radius; edge_ab_side_c; edge_bc_radius; edge_bc_side_a;
       edge_ca_radius; edge_ca_side_b].
End Program.

(* Over the reals the terms of a fused sum may be exchanged. *)
Definition machine_dot (rnd : R -> R) (fused : bool) (v w : vec) : R :=
  if fused then rnd (cz v * cz w + rnd (cy v * cy w + rnd (cx v * cx w))) else rounded_dot rnd false v w.
Definition machine_minus_product (rnd : R -> R) (fused : bool) (x y z : R) : R := if fused then rnd (- y * z + x) else rnd (x - rnd (y * z)).
Definition machine_cross (rnd : R -> R) (fused : bool) (v w : vec) : vec := Vec
  (machine_minus_product rnd fused (rnd (cy v * cz w)) (cz v) (cy w)) (machine_minus_product rnd fused (rnd (cz v * cx w)) (cx v) (cz w))
  (machine_minus_product rnd fused (rnd (cx v * cy w)) (cy v) (cx w)).
Lemma machine_dot_is rnd fused : machine_dot rnd fused = rounded_dot rnd fused.
Proof.
  extensionality v. extensionality w. unfold machine_dot, rounded_dot. destruct fused; [| reflexivity].
  rewrite (Rplus_comm (cz v * cz w)), (Rplus_comm (cy v * cy w)). reflexivity.
Qed.
Lemma machine_cross_is rnd fused : machine_cross rnd fused = rounded_cross rnd fused.
Proof.
  extensionality v. extensionality w. unfold machine_cross, rounded_cross, machine_minus_product, rounded_minus_product.
  destruct fused; [| reflexivity]. assert (forall x y z, - y * z + x = x - y * z) as same by (intros; ring). rewrite !same. reflexivity.
Qed.

Definition recorded_fine_numbers (fused : bool) := if fused then fine_fma_binary64_numbers else fine_plain_binary64_numbers.
Theorem recorded_fine_margins rnd fused a b c p r :
  recorded_fine_numbers fused (real_machine rnd) (cx a) (cy a) (cz a) (cx b) (cy b) (cz b) (cx c) (cy c) (cz c) (cx p) (cy p) (cz p) r =
  fine_numbers rnd fused a b c p r (rounded_dot rnd fused) (rounded_cross rnd fused).
Proof. rewrite <- machine_dot_is, <- machine_cross_is. destruct fused, a, b, c, p; reflexivity. Qed.

Lemma near_side X Y : dot X (sub X Y) = dot X X - dot X Y. Proof. vec_ring. Qed.
Lemma normal_by_edges X Y Z : cross (sub X Z) (sub Y X) = normal X Y Z. Proof. unfold normal. vec_ring. Qed.

Section Sound.
  Variable rnd : R -> R.
  Let u := bpow radix2 (-53).
  Hypothesis rounds_to : forall x, Rabs (rnd x - x) <= u * Rabs x.
  Variable fused : bool.
  Variables (a b c p : vec) (r : R).
  Notation A := (rounded_sub rnd a p). Notation B := (rounded_sub rnd b p). Notation C := (rounded_sub rnd c p).
  Notation AB := (rounded_sub rnd b a). Notation BC := (rounded_sub rnd c b). Notation CA := (rounded_sub rnd a c).
  Notation rr := (rnd (r * r)).

  Lemma u_range : 0 < u <= / 1048576.
  Proof using Type. unfold u. split; [apply bpow_gt_0 | cbn; lra]. Qed.
  Lemma u_weak : 0 <= u <= / 1048576. Proof using Type. pose proof u_range. lra. Qed.
  Lemma rounds_0 x : rounds u 0 x (rnd x).
  Proof using Type*. unfold Lanes.rounds. rewrite Rplus_0_r. apply rounds_to. Qed.

  (* X, as computed, has lost at most k roundings of x, which is not negative. *)
  Definition lowered (k : R) (X x : R) : Prop := 0 <= x /\ (1 - k * u) * x <= X /\ 0 <= X.
  Lemma lowered_itself x : 0 <= x -> lowered 0 x x.
  Proof using Type. intros. unfold lowered. lra. Qed.
  Lemma rounded_lowered x : 0 <= x -> (1 - u) * x <= rnd x.
  Proof using Type*. intros x0. pose proof (rounds_to x) as off. rewrite (Rabs_pos_eq x x0) in off. apply Rabs_le_inv in off. lra. Qed.
  Lemma lowered_weaken k l X x : k <= l -> lowered k X x -> lowered l X x.
  Proof using Type.
    intros kl (x0 & low & X0). split; [assumption |]. split; [| assumption]. eapply Rle_trans; [| exact low].
    apply Rmult_le_compat_r; [assumption |]. pose proof u_range. assert (k * u <= l * u) by (apply Rmult_le_compat_r; lra). lra.
  Qed.
  Lemma lowered_rounded k X x : 0 <= k <= 1000 -> lowered k X x -> lowered (k + 1) (rnd X) x.
  Proof using Type*.
    intros k0 (x0 & low & X0). pose proof u_range as us. pose proof (rounded_lowered X X0) as one.
    assert (0 <= (1 - u) * X) by (apply Rmult_le_pos; lra). split; [assumption |]. split; [| lra].
    eapply Rle_trans; [| exact one]. assert ((1 - u) * ((1 - k * u) * x) <= (1 - u) * X) as step by (apply Rmult_le_compat_l; lra).
    eapply Rle_trans; [| exact step]. assert (0 <= k * u * u * x).
    { repeat apply Rmult_le_pos; lra. }
    lra.
  Qed.
  Lemma lowered_sum k X Y x y : lowered k X x -> lowered k Y y -> lowered k (X + Y) (x + y).
  Proof using Type. intros (? & ? & ?) (? & ? & ?). unfold lowered. lra. Qed.
  Lemma lowered_product k l X Y x y : 0 <= k <= 1000 -> 0 <= l <= 1000 -> lowered k X x -> lowered l Y y -> lowered (k + l) (X * Y) (x * y).
  Proof using Type.
    intros k0 l0 (x0 & lowX & X0) (y0 & lowY & Y0). pose proof u_range as us.
    assert (k * u <= 1000 * / 1048576) by (apply Rmult_le_compat; lra). assert (l * u <= 1000 * / 1048576) by (apply Rmult_le_compat; lra).
    assert (0 <= k * u) by (apply Rmult_le_pos; lra). assert (0 <= l * u) by (apply Rmult_le_pos; lra).
    split; [apply Rmult_le_pos; assumption |]. split; [| apply Rmult_le_pos; assumption].
    assert (((1 - k * u) * x) * ((1 - l * u) * y) <= X * Y) as both.
    { apply Rmult_le_compat; try assumption; apply Rmult_le_pos; lra. }
    eapply Rle_trans; [| exact both]. assert (0 <= (k * u) * (l * u) * (x * y)) by (repeat apply Rmult_le_pos; lra). lra.
  Qed.
  Lemma lowered_mul_add k l X Y Z x y z : 0 <= k <= 100 -> 0 <= l <= 100 -> lowered k X x -> lowered l Y y -> lowered (k + l + 1) Z z ->
    lowered (k + l + 2) (mul_add rnd fused X Y Z) (x * y + z).
  Proof using rounds_to.
    intros k0 l0 HX HY HZ. pose proof (lowered_product k l X Y x y ltac:(lra) ltac:(lra) HX HY) as product. unfold mul_add.
    replace (k + l + 2) with (k + l + 1 + 1) by ring. destruct fused.
    - apply lowered_rounded; [lra |]. apply lowered_sum; [| exact HZ]. apply (lowered_weaken (k + l)); [lra | exact product].
    - apply lowered_rounded; [lra |]. rewrite (Rplus_comm (x * y)). apply lowered_sum; [exact HZ |].
      apply lowered_rounded; [lra | exact product].
  Qed.
  Lemma lowered_times k l X Y x y : 0 <= k <= 100 -> 0 <= l <= 100 -> lowered k X x -> lowered l Y y ->
    lowered (k + l + 1) (rnd (X * Y)) (x * y).
  Proof using Type*. intros k0 l0 HX HY. apply lowered_rounded; [lra |]. apply lowered_product; [lra | lra | assumption | assumption]. Qed.
  (* A constant that is at least another. *)
  Lemma lowered_constant C' x : 0 <= x <= C' -> lowered 0 C' x.
  Proof using Type. unfold lowered. lra. Qed.
  Lemma lowered_sum_of v : lowered 2 (sum_of rnd v) (total v).
  Proof using Type*.
    unfold sum_of, total. pose proof (Rabs_pos (cx v)). pose proof (Rabs_pos (cy v)). pose proof (Rabs_pos (cz v)).
    replace 2 with (1 + 1) by ring. apply lowered_rounded; [lra |]. apply lowered_sum.
    - replace 1 with (0 + 1) by ring. apply lowered_rounded; [lra |]. apply lowered_itself. lra.
    - apply (lowered_weaken 0); [lra |]. apply lowered_itself. assumption.
  Qed.
  Lemma lowered_error X Y : lowered 2 (error_of rnd X Y) (component_error u X Y).
  Proof using Type*.
    unfold error_of, component_error. pose proof (greatest_nonneg X). pose proof (greatest_nonneg Y). pose proof u_range.
    replace 2 with (0 + 1 + 1) by ring. apply lowered_times; [lra | lra | |].
    - apply lowered_constant. unfold fine_normal, units, normal_units, unit_factor, u. cbn [bpow]. split; [apply Rmult_le_pos |]; cbn; lra.
    - replace 1 with (0 + 0 + 1) by ring. apply lowered_times; [lra | lra | |]; apply lowered_itself; assumption.
  Qed.
  (* A bound that has lost few roundings keeps enough. *)
  Lemma enough k X x m M : 0 <= k <= 1000 -> lowered k X x -> Rabs (M - m) <= kept * x -> Rabs (M - m) <= X.
  Proof using Type.
    intros k0 (x0 & low & _) near. pose proof u_range. eapply Rle_trans; [exact near |]. eapply Rle_trans; [| exact low].
    assert (k * u <= 1000 * / 1048576) by (apply Rmult_le_compat; lra). apply Rmult_le_compat_r; [assumption |]. unfold kept. lra.
  Qed.

  Lemma near_dots X Y : near_dot u X Y (rounded_dot rnd fused X Y).
  Proof using rounds_to. apply double_dot_near; [exact u_weak |]. apply dot_is_computed, rounds_0. Qed.
  Lemma near_crosses X Y : near_cross u X Y (rounded_cross rnd fused X Y).
  Proof using rounds_to. apply double_cross_near; [exact u_weak |]. apply cross_is_computed, rounds_0. Qed.
  Lemma near_differences x y : near_minus u x y (rnd (x - y)).
  Proof using Type*. apply double_minus_near; [exact u_weak |]. apply rounds_0. Qed.
  Lemma leaves v w : leaf_of u (sub v w) (rounded_sub rnd v w).
  Proof using Type*. repeat split; apply rounds_to. Qed.
  Lemma square_nonneg X : 0 <= rounded_dot rnd fused X X.
  Proof using rounds_to. apply (square_back u u_weak X), near_dots. Qed.
  Lemma rr_nonneg : 0 <= rr.
  Proof using rounds_to. apply (radius_back u u_weak r), rounds_0. Qed.
  Lemma product_nonneg x y : 0 <= x -> 0 <= y -> 0 <= rnd (x * y).
  Proof using Type*. intros. pose proof (rounded_lowered (x * y) ltac:(apply Rmult_le_pos; assumption)). pose proof u_range.
    assert (0 <= (1 - u) * (x * y)) by (repeat apply Rmult_le_pos; lra). lra. Qed.
  Ltac constants := unfold fine_vertex_radius, fine_vertex_side, fine_normal, fine_offset, fine_plane_lhs, fine_plane_rhs, fine_edge_square,
    fine_edge_rhs, fine_edge_side, fine_once, fine_once_offset, fine_twice, fine_thrice_in_side, fine_thrice, units, unit_factor,
    vertex_radius_units, vertex_side_units, normal_units, offset_units, plane_lhs_units, plane_rhs_units, edge_square_units, edge_rhs_units,
    edge_side_units, once, once_offset, twice, thrice_in_side, thrice, u; cbn; lra.

  Lemma radius_is_near v : let m := fine_radius rnd r (rounded_dot rnd fused) (rounded_sub rnd v p) in
    Rabs (fst m - (dot (sub v p) (sub v p) - r * r)) <= snd m.
  Proof using rounds_to.
    cbv zeta. unfold fine_radius. cbn [fst snd]. set (X := rounded_sub rnd v p).
    eapply (enough 2); [lra | | apply (vertex_radius_bound u u_weak _ _ _ _ _ _ (leaves v p) (near_dots X X) (rounds_0 _) (near_differences _ _))].
    replace 2 with (0 + 1 + 1) by ring. apply lowered_times; [lra | lra | apply lowered_constant; constants |].
    replace 1 with (0 + 1) by ring. apply lowered_rounded; [lra |]. apply lowered_itself.
    pose proof (square_nonneg X). pose proof rr_nonneg. lra.
  Qed.
  Lemma side_is_near v w x : let m := fine_side rnd (rounded_dot rnd fused) (rounded_sub rnd v p) (rounded_sub rnd w x) in
    Rabs (fst m - dot (sub v p) (sub w x)) <= snd m.
  Proof using rounds_to.
    cbv zeta. unfold fine_side. cbn [fst snd]. set (X := rounded_sub rnd v p). set (Y := rounded_sub rnd w x).
    eapply (enough 2); [lra | | apply (vertex_side_bound u u_weak _ _ _ _ _ (leaves v p) (leaves w x) (near_dots X Y))].
    rewrite <- Rmult_assoc. replace 2 with (1 + 0 + 1) by ring.
    apply lowered_times; [lra | lra | | apply lowered_itself, greatest_nonneg]. replace 1 with (0 + 0 + 1) by ring.
    apply lowered_times; [lra | lra | apply lowered_constant; constants | apply lowered_itself, greatest_nonneg].
  Qed.
  Lemma opposite_is_near (m : R * R) x : Rabs (fst m - x) <= snd m -> Rabs (fst (opposite m) - - x) <= snd (opposite m).
  Proof using Type. unfold opposite. cbn [fst snd]. intros. replace (- fst m - - x) with (- (fst m - x)) by ring. rewrite Rabs_Ropp. assumption. Qed.

  Notation V := (fine_V rnd a b c (rounded_cross rnd fused)).
  Definition exact_omega : R := if b_is_c rnd b c then 0 else component_error u CA AB.
  Lemma normal_is_computed : computed_normal u (sub a c) (sub b a) CA AB V exact_omega.
  Proof using rounds_to.
    split; [apply leaves |]. split; [apply leaves |]. unfold fine_V, exact_omega, b_is_c, equal_real. destruct Req_EM_T as [zero | some].
    - right. split; [reflexivity |]. split; [reflexivity |].
      assert (forall x, rnd x = 0 -> x = 0) as exact.
      { intros x at_zero. pose proof (rounds_to x) as off. rewrite at_zero in off. pose proof u_range as us. fold u in us.
        replace (0 - x) with (- x) in off by ring. rewrite Rabs_Ropp in off. pose proof (Rabs_pos x).
        assert (Rabs x <= / 1048576 * Rabs x) as low by (eapply Rle_trans; [exact off | apply Rmult_le_compat_r; lra]).
        destruct (Req_dec x 0) as [| nonzero]; [assumption |]. pose proof (Rabs_pos_lt x nonzero). lra. }
      destruct (at_most_greatest BC) as (zx & zy & zz). rewrite zero in zx, zy, zz.
      assert (forall x, Rabs (rnd x) <= 0 -> x = 0) as none.
      { intros x low. apply exact. pose proof (Rabs_pos (rnd x)). destruct (Req_dec (rnd x) 0) as [| nonzero]; [assumption |].
        pose proof (Rabs_pos_lt _ nonzero). lra. }
      unfold rounded_sub in zx, zy, zz. cbn [cx cy cz] in zx, zy, zz. apply none in zx, zy, zz.
      destruct a as [a1 a2 a3], b as [b1 b2 b3], c as [c1 c2 c3]. unfold sub, cross. cbn [cx cy cz] in *.
      replace c1 with b1 by lra. replace c2 with b2 by lra. replace c3 with b3 by lra. f_equal; ring.
    - left. split; [| reflexivity]. pose proof (near_crosses CA AB) as near. destruct (rounded_cross rnd fused CA AB). exact near.
  Qed.
  Lemma lowered_omega : lowered 2 (fine_omega rnd a b c) exact_omega.
  Proof using rounds_to.
    unfold fine_omega, exact_omega. destruct b_is_c; [| apply lowered_error]. apply (lowered_weaken 0); [lra |]. apply lowered_itself. lra.
  Qed.

  Lemma plane_is_near : let v := cross (sub a c) (sub b a) in let m := fine_plane rnd fused a b c p r (rounded_dot rnd fused) (rounded_cross rnd fused) in
    Rabs (fst m - (dot (sub a p) v * dot (sub a p) v - r * r * dot v v)) <= snd m.
  Proof using rounds_to.
    cbv zeta. unfold fine_plane. cbn [fst snd]. pose proof lowered_omega as omega. pose proof (lowered_sum_of V) as sum.
    set (w := fine_omega rnd a b c) in *. set (N := V) in *. set (D := rounded_dot rnd fused A N). set (E := rounded_dot rnd fused N N).
    pose proof (square_nonneg N : 0 <= E) as E0. pose proof rr_nonneg as rr0.
    assert (0 <= rnd (D * D)) as lhs0.
    { pose proof (rounded_lowered (D * D) (Rle_0_sqr D)) as low. pose proof u_range. assert (0 <= (1 - u) * (D * D)) by
        (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
    pose proof (product_nonneg rr E rr0 E0) as rhs0.
    eapply (enough 15); [lra | | apply (plane_radius_bound u u_weak _ A _ _ CA AB N exact_omega D E r rr (rnd (D * D)) (rnd (rr * E)) _
      (leaves a p) normal_is_computed (near_dots A N) (near_dots N N) (rounds_0 _) (rounds_0 _) (rounds_0 _) (near_differences _ _))].
    assert (lowered 3 (rnd (fine_thrice * w)) (thrice * exact_omega)) as three.
    { replace 3 with (0 + 2 + 1) by ring. apply lowered_times; [lra | lra | apply lowered_constant; constants | exact omega]. }
    assert (lowered 5 (rnd (greatest_component A * mul_add rnd fused fine_offset (sum_of rnd N) (rnd (fine_thrice * w))))
      (offset_error u A N exact_omega)) as delta.
    { unfold offset_error. replace 5 with (0 + 4 + 1) by ring. apply lowered_times; [lra | lra | apply lowered_itself, greatest_nonneg |].
      replace 4 with (0 + 2 + 2) by ring. apply lowered_mul_add; [lra | lra | apply lowered_constant; constants | exact sum |].
      replace (0 + 2 + 1) with 3 by ring. exact three. }
    unfold plane_bound. set (delta' := offset_error u A N exact_omega) in *. set (d := rnd (greatest_component A * _)) in *.
    replace 15 with (14 + 1) by ring. apply lowered_rounded; [lra |]. apply lowered_sum.
    - replace 14 with (5 + 7 + 2) by ring. apply lowered_mul_add; [lra | lra | exact delta | |].
      + replace 7 with (5 + 0 + 2) by ring. apply lowered_mul_add; [lra | lra | | apply lowered_itself, Rabs_pos |].
        * apply (lowered_weaken 0); [lra | apply lowered_constant; constants].
        * apply lowered_times; [lra | lra | exact delta | apply lowered_constant; constants].
      + apply (lowered_weaken (0 + 0 + 1)); [lra |]. apply lowered_times; [lra | lra | apply lowered_constant; constants |].
        apply lowered_itself, lhs0.
    - apply (lowered_weaken (0 + 7 + 2)); [lra |]. apply lowered_mul_add; [lra | lra | apply lowered_itself, rr0 | |].
      + replace 7 with (2 + 4 + 1) by ring. apply lowered_times; [lra | lra | exact omega |].
        replace 4 with (0 + 2 + 2) by ring. apply lowered_mul_add; [lra | lra | apply lowered_constant; constants | exact sum |].
        replace (0 + 2 + 1) with 3 by ring. exact three.
      + apply (lowered_weaken (0 + 0 + 1)); [lra |]. apply lowered_times; [lra | lra | apply lowered_constant; constants |].
        apply lowered_itself, rhs0.
  Qed.

  Lemma edge_radius_is_near v w x : let X := rounded_sub rnd v p in let Y := rounded_sub rnd w x in
    let m := fine_edge_radius rnd fused r (rounded_dot rnd fused) (rounded_cross rnd fused) X Y in let n := cross (sub v p) (sub w x) in
    Rabs (fst m - (dot n n - r * r * dot (sub w x) (sub w x))) <= snd m.
  Proof using rounds_to.
    cbv zeta. set (X := rounded_sub rnd v p). set (Y := rounded_sub rnd w x). unfold fine_edge_radius. cbn [fst snd].
    set (N := rounded_cross rnd fused X Y). pose proof (lowered_error X Y) as nu. pose proof (lowered_sum_of N) as sum.
    pose proof (square_nonneg N) as nn0. pose proof (square_nonneg Y) as e0. pose proof rr_nonneg as rr0.
    pose proof (product_nonneg _ _ rr0 e0) as rhs0. set (e := error_of rnd X Y) in *.
    eapply (enough 8); [lra | | apply (edge_radius_bound u u_weak _ _ X Y N _ _ r rr _ _ (leaves v p) (leaves w x) (near_crosses X Y)
      (near_dots N N) (near_dots Y Y) (rounds_0 _) (rounds_0 _) (near_differences _ _))].
    unfold edge_radius_limit. replace 8 with (2 + 4 + 2) by ring. apply lowered_mul_add; [lra | lra | exact nu | |].
    - replace 4 with (0 + 2 + 2) by ring. apply lowered_mul_add; [lra | lra | apply lowered_constant; constants | exact sum |].
      apply lowered_times; [lra | lra | apply lowered_constant; constants | exact nu].
    - apply (lowered_weaken (0 + 0 + 2)); [lra |]. apply lowered_mul_add; [lra | lra | apply lowered_constant; constants |
        apply lowered_itself, nn0 |].
      apply lowered_times; [lra | lra | apply lowered_constant; constants | apply lowered_itself, rhs0].
  Qed.
  Lemma edge_side_is_near v w x : let X := rounded_sub rnd v p in let Y := rounded_sub rnd w x in
    let m := fine_edge_side_margin rnd fused a b c (rounded_dot rnd fused) (rounded_cross rnd fused) X Y in
    Rabs (fst m - - dot (cross (sub v p) (sub w x)) (cross (sub a c) (sub b a))) <= snd m.
  Proof using rounds_to.
    cbv zeta. set (X := rounded_sub rnd v p). set (Y := rounded_sub rnd w x). unfold fine_edge_side_margin. cbn [fst snd].
    set (N := rounded_cross rnd fused X Y). pose proof (lowered_error X Y) as nu. pose proof (lowered_sum_of N) as sum.
    pose proof lowered_omega as omega. pose proof (lowered_sum_of V) as sum'. set (e := error_of rnd X Y) in *.
    eapply (enough 9); [lra | | apply (edge_side_bound u u_weak _ _ X Y N _ _ CA AB V exact_omega _ (leaves v p) (leaves w x) (near_crosses X Y)
      normal_is_computed (near_dots N V))].
    unfold edge_side_limit. replace 9 with (3 + 4 + 2) by ring. apply lowered_mul_add; [lra | lra | | |].
    - replace 3 with (2 + 0 + 1) by ring. apply lowered_times; [lra | lra | exact omega | apply lowered_constant; constants].
    - replace 4 with (0 + 2 + 2) by ring. apply lowered_mul_add; [lra | lra | apply lowered_constant; constants | exact nu |].
      apply (lowered_weaken 2); [lra | exact sum].
    - apply (lowered_weaken (2 + 4 + 1)); [lra |]. apply lowered_times; [lra | lra | exact sum' |].
      replace 4 with (0 + 2 + 2) by ring. apply lowered_mul_add; [lra | lra | apply lowered_constant; constants | exact sum |].
      apply (lowered_weaken (2 + 0 + 1)); [lra |]. apply lowered_times; [lra | lra | exact nu | apply lowered_constant; constants].
  Qed.

  (* The exact margin of each comparison: the left side less the right one. *)
  Definition margin_exactly (K : comparison) : R :=
    let s := reduced (sub a p) (sub b p) (sub c p) (r * r) K in fst s - snd s.
  Theorem fine_is_near K : Rabs (fst (fine_margin rnd fused a b c p r (rounded_dot rnd fused) (rounded_cross rnd fused) K) - margin_exactly K) <= snd (fine_margin rnd fused a b c p r (rounded_dot rnd fused) (rounded_cross rnd fused) K).
  Proof using rounds_to.
    pose proof (moved_by p) as edges. pose proof far_side as far. pose proof near_side as near. pose proof along_edge as along.
    pose proof turned_normal as turned.
    assert (normals : cross (sub a c) (sub b a) = normal (sub a p) (sub b p) (sub c p))
      by (rewrite (edges c a), (edges a b); apply normal_by_edges).
    unfold margin_exactly. destruct K; cbn [fine_margin reduced published]; unfold plane_sides, vertex_radius_sides, vertex_side_sides,
      reduced_radius_sides, reduced_side_sides, offset, length2; cbn [fst snd].
    - pose proof plane_is_near as H. cbv zeta in H. rewrite normals in H. exact H.
    - apply radius_is_near.
    - pose proof (side_is_near a b a) as H. cbv zeta in H. rewrite (edges a b), far in H. exact H.
    - pose proof (opposite_is_near _ _ (side_is_near a a c)) as H. rewrite (edges c a), near in H.
      replace (- (dot (sub a p) (sub a p) - dot (sub a p) (sub c p))) with (dot (sub a p) (sub c p) - dot (sub a p) (sub a p)) in H by ring. exact H.
    - apply radius_is_near.
    - pose proof (opposite_is_near _ _ (side_is_near b b a)) as H. rewrite (edges a b), near in H.
      replace (- (dot (sub b p) (sub b p) - dot (sub b p) (sub a p))) with (dot (sub b p) (sub a p) - dot (sub b p) (sub b p)) in H by ring.
      exact H.
    - pose proof (side_is_near b c b) as H. cbv zeta in H. rewrite (edges b c), far in H. exact H.
    - apply radius_is_near.
    - pose proof (side_is_near c a c) as H. cbv zeta in H. rewrite (edges c a), far in H. exact H.
    - pose proof (opposite_is_near _ _ (side_is_near c c b)) as H. rewrite (edges b c), near in H.
      replace (- (dot (sub c p) (sub c p) - dot (sub c p) (sub b p))) with (dot (sub c p) (sub b p) - dot (sub c p) (sub c p)) in H by ring.
      exact H.
    - pose proof (edge_radius_is_near a b a) as H. cbv zeta in H. rewrite (edges a b), along in H. exact H.
    - pose proof (edge_side_is_near a b a) as H. cbv zeta in H. rewrite normals, (edges a b), along in H.
      replace (0 - _) with (- dot (cross (sub a p) (sub b p)) (normal (sub a p) (sub b p) (sub c p))) by ring. exact H.
    - pose proof (edge_radius_is_near b c b) as H. cbv zeta in H. rewrite (edges b c), along in H. exact H.
    - pose proof (edge_side_is_near b c b) as H. cbv zeta in H. rewrite normals, (edges b c), along in H. rewrite (turned (sub a p) (sub b p) (sub c p)).
      replace (0 - _) with (- dot (cross (sub b p) (sub c p)) (normal (sub a p) (sub b p) (sub c p))) by ring. exact H.
    - pose proof (edge_radius_is_near c a c) as H. cbv zeta in H. rewrite (edges c a), along in H. exact H.
    - pose proof (edge_side_is_near c a c) as H. cbv zeta in H. rewrite normals, (edges c a), along in H. rewrite <- (turned (sub c p) (sub a p) (sub b p)).
      replace (0 - _) with (- dot (cross (sub c p) (sub a p)) (normal (sub a p) (sub b p) (sub c p))) by ring. exact H.
  Qed.
End Sound.
