(* The fine step tells the next steps bits of each axis. For every finite query of binary32, in doubles, nothing in it over- or
   underflows, and every bit is right, for either sphere; the bits are those recorded from the code that runs. *)
From Coq Require Import Reals ZArith Bool List Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Reduced OpenSphere Known Run Window Filter Lanes Margins CertifiedStep Sizes Machine RecordedCertified
  RecordedIsCertified CoarseKnown FineStep CertifiedIsExact Extents.
Import ListNotations.
Open Scope R_scope.

Section Program.
  Variable m : machine.
  Notation number := (m_number m).
  (* The greatest components of AB, BC and CA, the error of V's components, and the sum of their sizes. *)
  Section Lists.
    Variables (fused : bool) (ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : number).
    Let norm x y z := m_greatest m (m_greatest m (m_magnitude m x) (m_magnitude m y)) (m_magnitude m z).
    Let norm_of x y z x' y' z' := norm (m_subtract m x' x) (m_subtract m y' y) (m_subtract m z' z).
    Definition norm_ab := norm_of ax ay az bx by_ bz.
    Definition norm_bc := norm_of bx by_ bz cx_ cy_ cz_.
    Definition norm_ca := norm_of cx_ cy_ cz_ ax ay az.
    Definition same_bc : bool := m_equal m norm_bc (m_zero m).
    Let component x y x' y' :=
      if same_bc then m_zero m else
      if fused then m_fused m (m_negate m y) x' (m_multiply m x y') else m_subtract m (m_multiply m x y') (m_multiply m y x').
    Let u := m_subtract m ax cx_. Let v := m_subtract m ay cy_. Let w := m_subtract m az cz_.
    Let u' := m_subtract m bx ax. Let v' := m_subtract m by_ ay. Let w' := m_subtract m bz az.
    Definition fine_list : list number :=
      [norm_ab; norm_bc; norm_ca;
       if same_bc then m_zero m else m_multiply m (m_constant m 17 (-54)) (m_multiply m norm_ca norm_ab);
       m_add m (m_add m (m_magnitude m (component v w v' w')) (m_magnitude m (component w u w' u'))) (m_magnitude m (component u v u' v'))] ++
      recorded_fine_numbers fused m ax ay az bx by_ bz cx_ cy_ cz_ px py pz r.
  End Lists.

  Definition place (K : comparison) : nat :=
    match K with
    | plane_radius => 0 | vertex_a_radius => 1 | vertex_a_side_b => 2 | vertex_a_side_c => 3 | vertex_b_radius => 4 | vertex_b_side_a => 5
    | vertex_b_side_c => 6 | vertex_c_radius => 7 | vertex_c_side_a => 8 | vertex_c_side_b => 9 | edge_ab_radius => 10 | edge_ab_side_c => 11
    | edge_bc_radius => 12 | edge_bc_side_a => 13 | edge_ca_radius => 14 | edge_ca_side_b => 15
    end.
  Variables (list : list number) (open : bool).
  Definition is_nought (k : nat) : bool := m_equal m (nth k list (m_zero m)) (m_zero m).
  Definition fine_value (K : comparison) : number := nth (5 + 2 * place K) list (m_zero m).
  Definition fine_bound (K : comparison) : number := nth (6 + 2 * place K) list (m_zero m).
  (* The sides of an axis, in the order in which they are asked. *)
  Definition sides_of (i : axis) : Datatypes.list comparison :=
    match i with
    | axis_a => [vertex_a_side_b; vertex_a_side_c] | axis_b => [vertex_b_side_c; vertex_b_side_a] | axis_c => [vertex_c_side_a; vertex_c_side_b]
    | axis_plane => [] | axis_ab => [edge_ab_side_c] | axis_bc => [edge_bc_side_a] | axis_ca => [edge_ca_side_b]
    end.
  Definition fine_within (i : axis) : bool :=
    let K := radius_of i in let least := m_negate m (fine_bound K) in
    let within := if open then m_less m (fine_value K) least else m_at_most m (fine_value K) least in
    match i with
    | axis_plane => is_nought 3 && is_nought 4 || within
    | axis_ab => is_nought 0 || within | axis_bc => is_nought 1 || within | axis_ca => is_nought 2 || within
    | _ => within
    end.
  Definition side_fails (K : comparison) : bool := m_less m (fine_value K) (m_negate m (fine_bound K)).
  Definition side_holds (K : comparison) : bool := m_at_most m (fine_bound K) (fine_value K).
  Definition fine_known : known := Known
    (fun i => fold_left (fun b K => b || side_fails K) (sides_of i) (fine_within i))
    (fun i => m_less m (fine_bound (radius_of i)) (fine_value (radius_of i)))
    (fun i => match sides_of i with [] => true | K :: more => fold_left (fun b K => b && side_holds K) more (side_holds K) end).
End Program.

Definition recorded_fine_known (fused open : bool) :=
  match fused, open with
  | true, false => fine_fma_binary64_known_closed | true, true => fine_fma_binary64_known_open
  | false, false => fine_plain_binary64_known_closed | false, true => fine_plain_binary64_known_open
  end.
Theorem recorded_fine_known_is_program m fused open ax ay az bx by_ bz cx_ cy_ cz_ px py pz r :
  recorded_fine_known fused open m ax ay az bx by_ bz cx_ cy_ cz_ px py pz r =
  known_list (fine_known m (fine_list m fused ax ay az bx by_ bz cx_ cy_ cz_ px py pz r) open).
Proof. destruct fused, open; reflexivity. Qed.

(* The step's own verdicts are those of its bits. *)
Lemma decided_by_bits k : known_sides k axis_plane = true ->
  is_separated k = known_radius k axis_a && known_sides k axis_a || known_radius k axis_b && known_sides k axis_b ||
    known_radius k axis_c && known_sides k axis_c || known_radius k axis_plane || known_radius k axis_ab && known_sides k axis_ab ||
    known_radius k axis_bc && known_sides k axis_bc || known_radius k axis_ca && known_sides k axis_ca /\
  is_contact k = known_fails k axis_a && known_fails k axis_b && known_fails k axis_c && known_fails k axis_plane && known_fails k axis_ab &&
    known_fails k axis_bc && known_fails k axis_ca.
Proof.
  intros plane. unfold is_separated, is_contact, all_axes. cbn [existsb forallb]. rewrite plane, andb_true_r, orb_false_r, andb_true_r.
  rewrite !orb_assoc, !andb_assoc. split; reflexivity.
Qed.
Definition recorded_fine_answers (fused : bool) := if fused then fine_fma_binary64_answers else fine_plain_binary64_answers.
Theorem recorded_fine_decides m fused ax ay az bx by_ bz cx_ cy_ cz_ px py pz r :
  let known := fine_known m (fine_list m fused ax ay az bx by_ bz cx_ cy_ cz_ px py pz r) in
  skipn 2 (recorded_fine_answers fused m ax ay az bx by_ bz cx_ cy_ cz_ px py pz r) =
  [is_separated (known false); is_contact (known false); is_separated (known true); is_contact (known true)].
Proof.
  intros known. destruct (decided_by_bits (known false) eq_refl) as [-> ->], (decided_by_bits (known true) eq_refl) as [-> ->].
  unfold known. destruct fused; reflexivity.
Qed.

(* Over the reals, with roundings that do not underflow. *)
Section Sound.
  Variable rnd : R -> R.
  Hypothesis rounds_to : forall x, Rabs (rnd x - x) <= bpow radix2 (-53) * Rabs x.
  Variables (fused : bool) (a b c p : vec) (r : R).
  Notation M := (real_machine rnd).
  Let A := sub a p. Let B := sub b p. Let C := sub c p.
  Let list : list R := fine_list M fused (cx a) (cy a) (cz a) (cx b) (cy b) (cz b) (cx c) (cy c) (cz c) (cx p) (cy p) (cz p) r.

  Lemma rounds_to_nought x : rnd x = 0 -> x = 0.
  Proof using rounds_to.
    intros zero. pose proof (rounds_to x) as off. rewrite zero in off. replace (0 - x) with (- x) in off by ring. rewrite Rabs_Ropp in off.
    assert (bpow radix2 (-53) * Rabs x <= / 2 * Rabs x) by (apply Rmult_le_compat_r; [apply Rabs_pos | cbn; lra]).
    destruct (Req_dec x 0) as [| some]; [assumption |]. pose proof (Rabs_pos_lt x some). lra.
  Qed.
  Lemma near_edge v w : greatest_component (rounded_sub rnd v w) = 0 -> sub v w = Vec 0 0 0.
  Proof using rounds_to.
    intros zero. destruct (at_most_greatest (rounded_sub rnd v w)) as (x & y & z). rewrite zero in x, y, z.
    assert (forall t, Rabs (rnd t) <= 0 -> t = 0) as none.
    { intros t low. apply rounds_to_nought. pose proof (Rabs_pos (rnd t)). destruct (Req_dec (rnd t) 0) as [| some]; [assumption |].
      pose proof (Rabs_pos_lt _ some). lra. }
    unfold rounded_sub in x, y, z. cbn [cx cy cz] in x, y, z. unfold sub. rewrite (none _ x), (none _ y), (none _ z). reflexivity.
  Qed.
  Lemma margin_is K : Rabs (fine_value M list K - margin_exactly a b c p r K) <= fine_bound M list K.
  Proof using rounds_to.
    pose proof (fine_is_near rnd rounds_to fused a b c p r K) as near. unfold fine_value, fine_bound, list, fine_list.
    rewrite recorded_fine_margins. destruct K; exact near.
  Qed.

  Variable q : question.
  Notation holds := (holds_for q A B C (r * r)).
  Let is_open := match q with open_sphere => true | closed_sphere => false end.
  Lemma nought_is_zero k : is_nought M list k = true -> nth k list 0 = 0.
  Proof using Type. unfold is_nought. cbn [m_equal real_machine m_zero]. unfold equal_real. destruct Req_EM_T; [auto | discriminate]. Qed.
  Lemma exact_sign K : let m := margin_exactly a b c p r K in
    (0 < m -> holds K) /\ (m < 0 -> ~ holds K) /\ (m = 0 -> (holds K <-> is_side K = true \/ q = open_sphere /\ has_normal A B C K)).
  Proof using Type.
    cbv zeta. pose proof (sign_decides q A B C (r * r) K (Rle_0_sqr r)) as (positive & negative & zero). unfold margin_exactly. fold A B C.
    split; [intros; apply positive; lra |]. split; [intros; apply negative; lra |]. intros; apply zero; lra.
  Qed.
  Lemma no_normal K : ~ has_normal A B C K -> ~ holds K.
  Proof using Type.
    intros flat. unfold holds_for. destruct q; [| intros [_ some]; exact (flat some)]. unfold nonstrict.
    destruct (sides_shape A B C K) as [(_ & some & _) | (-> & f & n & f0 & n0 & some & at_zero & value)]; [contradiction |].
    rewrite value. cbn [fst snd]. destruct (Rle_lt_or_eq_dec 0 n n0) as [more | <-]; [tauto |]. rewrite (at_zero eq_refl). lra.
  Qed.
  Lemma across_nought v : cross v (Vec 0 0 0) = Vec 0 0 0 /\ cross (Vec 0 0 0) v = Vec 0 0 0.
  Proof using Type. unfold cross. cbn [cx cy cz]. split; f_equal; ring. Qed.
  Lemma within_fails i : fine_within M list is_open i = true -> ~ axis_holds holds i.
  Proof using rounds_to.
    assert (forall K, (if is_open then less_real (fine_value M list K) (- fine_bound M list K)
      else at_most_real (fine_value M list K) (- fine_bound M list K)) = true -> is_side K = false -> ~ holds K) as compared.
    { intros K less radius. pose proof (margin_is K) as near. apply Rabs_le_inv in near. destruct (exact_sign K) as (_ & negative & zero).
      unfold is_open, less_real, at_most_real in less. destruct q; [destruct Rle_dec | destruct Rlt_dec]; try discriminate.
      - destruct (Rlt_dec (margin_exactly a b c p r K) 0) as [below | not]; [exact (negative below) |].
        rewrite zero by lra. rewrite radius. intros [| [? _]]; discriminate.
      - apply negative. lra. }
    assert (forall v w x, sub v w = Vec 0 0 0 -> sub (sub v x) (sub w x) = Vec 0 0 0) as moved.
    { intros [v1 v2 v3] [w1 w2 w3] [x1 x2 x3]. unfold sub. cbn [cx cy cz]. intros [= ? ? ?]. f_equal; lra. }
    unfold fine_within, axis_holds. intros fails [H _]. revert H. destruct i; cbn [radius_of] in *.
    1-3: apply compared; [exact fails | reflexivity].
    all: apply orb_true_iff in fails as [flat | fails]; [apply no_normal; cbn [has_normal] | apply compared; [exact fails | reflexivity]].
    all: intros some; apply some.
    - apply andb_true_iff in flat as [flat _]. apply nought_is_zero in flat.
      assert (sub a c = Vec 0 0 0 \/ sub b a = Vec 0 0 0 \/ sub c b = Vec 0 0 0) as [zero | [zero | zero]].
      { change (nth 3 list 0) with (if equal_real (greatest_component (rounded_sub rnd c b)) 0 then 0
          else rnd (IZR 17 * bpow radix2 (-54) * rnd (greatest_component (rounded_sub rnd a c) * greatest_component (rounded_sub rnd b a)))) in flat.
        unfold equal_real in flat. destruct Req_EM_T as [zero | _]; [right; right; apply near_edge, zero |].
        apply rounds_to_nought, Rmult_integral in flat as [flat | flat]; [cbn in flat; lra |].
        apply rounds_to_nought, Rmult_integral in flat as [flat | flat]; [left | right; left]; apply near_edge, flat. }
      + apply (moved _ _ p) in zero. fold A C in zero. unfold normal. replace (sub C A) with (Vec 0 0 0); [apply across_nought |].
        revert zero. generalize A C. intros [a1 a2 a3] [c1 c2 c3]. unfold sub. cbn [cx cy cz]. intros [= ? ? ?]. f_equal; lra.
      + apply (moved _ _ p) in zero. fold A B in zero. unfold normal. rewrite zero. apply across_nought.
      + apply (moved _ _ p) in zero. fold B C in zero. revert zero. unfold normal. generalize A B C.
        intros [a1 a2 a3] [b1 b2 b3] [c1 c2 c3]. unfold sub, cross. cbn [cx cy cz]. intros [= ? ? ?].
        replace c1 with b1 by lra. replace c2 with b2 by lra. replace c3 with b3 by lra. f_equal; ring.
    - apply (moved b a p), near_edge. exact (nought_is_zero 0 flat).
    - apply (moved c b p), near_edge. exact (nought_is_zero 1 flat).
    - apply (moved a c p), near_edge. exact (nought_is_zero 2 flat).
  Qed.
  Lemma side_tells K : is_side K = true -> (side_holds M list K = true -> holds K) /\ (side_fails M list K = true -> ~ holds K).
  Proof using rounds_to.
    intros side. pose proof (margin_is K) as near. apply Rabs_le_inv in near. destruct (exact_sign K) as (positive & negative & zero).
    unfold side_holds, side_fails. cbn [m_at_most m_less m_negate real_machine]. split.
    - unfold at_most_real. destruct Rle_dec; [intros _ | discriminate].
      destruct (Rle_lt_or_eq_dec 0 (margin_exactly a b c p r K) ltac:(lra)) as [more | equal]; [exact (positive more) | apply zero; [lra | auto]].
    - unfold less_real. destruct Rlt_dec; [intros _; apply negative; lra | discriminate].
  Qed.
  Theorem fine_known_is_sound : sound_known holds (fine_known M list is_open).
  Proof using rounds_to.
    intros i. cbn [fine_known known_fails known_radius known_sides]. split; [| split].
    - assert (forall K, is_side K = true -> side_fails M list K = true -> ~ holds K) as side by (intros K s; apply (side_tells K s)).
      destruct i; cbn [sides_of fold_left]; rewrite ?orb_true_iff; intros fails.
      1-3: destruct fails as [[fails | fails] | fails]; [apply within_fails, fails | |]; apply side in fails; try reflexivity;
        unfold axis_holds; cbn [sides_hold]; tauto.
      1: apply within_fails, fails.
      all: destruct fails as [fails | fails]; [apply within_fails, fails |]; apply side in fails; try reflexivity;
        unfold axis_holds; cbn [sides_hold]; tauto.
    - pose proof (margin_is (radius_of i)) as near. apply Rabs_le_inv in near. destruct (exact_sign (radius_of i)) as (positive & _).
      cbn [m_less real_machine]. unfold less_real. destruct Rlt_dec; [intros _; apply positive; lra | discriminate].
    - assert (forall K, is_side K = true -> side_holds M list K = true -> holds K) as side by (intros K s; apply (side_tells K s)).
      destruct i; cbn [sides_of fold_left sides_hold]; rewrite ?andb_true_iff; intros H.
      1-3: destruct H as [H H']; split; apply side; first [reflexivity | assumption].
      1: exact I.
      all: apply side; [reflexivity | exact H].
  Qed.
End Sound.

(* Binary32, widened. *)
Definition leaf_extent (i : nat) : extent := Extent (-149) (-149) 128 (i =? 12)%nat.
Definition all_fit (terms : list term) : bool := forallb (fun t => match extent_of leaf_extent t with Some _ => true | None => false end) terms.
Definition inputs {T : Type} (ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : T) (i : nat) : T :=
  nth i [ax; ay; az; bx; by_; bz; cx_; cy_; cz_; px; py; pz] r.
Definition fine_terms (fused flag : bool) : list term :=
  fine_list (term_machine flag) fused (Input 0) (Input 1) (Input 2) (Input 3) (Input 4) (Input 5) (Input 6) (Input 7) (Input 8) (Input 9) (Input 10)
    (Input 11) (Input 12).
Lemma fine_terms_fit fused flag : all_fit (fine_terms fused flag) = true.
Proof. destruct fused, flag; vm_compute; reflexivity. Qed.

(* The program asks only whether B = C. *)
Definition with_equal (m : machine) (flag : bool) : machine := {|
  m_number := m_number m; m_zero := m_zero m; m_infinity := m_infinity m; m_constant := m_constant m; m_negate := m_negate m;
  m_magnitude := m_magnitude m; m_add := m_add m; m_subtract := m_subtract m; m_multiply := m_multiply m; m_divide := m_divide m;
  m_fused := m_fused m; m_least := m_least m; m_greatest := m_greatest m; m_with_sign := m_with_sign m;
  m_inverse_power := m_inverse_power m; m_less := m_less m; m_at_most := m_at_most m; m_equal := fun _ _ => flag
|}.
Lemma fine_list_is m fused ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : let flag := same_bc m bx by_ bz cx_ cy_ cz_ in
  fine_list m fused ax ay az bx by_ bz cx_ cy_ cz_ px py pz r =
  map (eval m (inputs ax ay az bx by_ bz cx_ cy_ cz_ px py pz r)) (fine_terms fused flag).
Proof.
  intros flag. transitivity (fine_list (with_equal m flag) fused ax ay az bx by_ bz cx_ cy_ cz_ px py pz r).
  - destruct fused; reflexivity.
  - generalize flag. clear flag. intros flag. destruct fused, flag; reflexivity.
Qed.

Section Binary32.
  Variables (least greatest : binary_float 53 1024 -> binary_float 53 1024 -> binary_float 53 1024) (other : binary_float 53 1024 -> binary_float 53 1024).
  Hypothesis greatest_is : is_greatest 53 1024 greatest.
  Notation F := (machine64 least greatest other).
  Notation N := (real_machine (unbounded 53)).
  Notation fits := (fits least greatest other).
  Variables (fused : bool) (a b c p : float_vec 53 1024) (r : binary_float 53 1024).
  Notation finite := (finite_vec 53 1024).
  Hypothesis finite_query : finite a /\ finite b /\ finite c /\ finite p /\ is_finite r = true.
  Let at_ := real_vec 53 1024.
  Hypothesis format : Forall in_binary32 [cx (at_ a); cy (at_ a); cz (at_ a); cx (at_ b); cy (at_ b); cz (at_ b); cx (at_ c); cy (at_ c); cz (at_ c);
    cx (at_ p); cy (at_ p); cz (at_ p); B2R r].
  Hypothesis r0 : 0 <= B2R r.
  Notation of_floats f := (f F fused (fx _ _ a) (fy _ _ a) (fz _ _ a) (fx _ _ b) (fy _ _ b) (fz _ _ b) (fx _ _ c) (fy _ _ c) (fz _ _ c)
    (fx _ _ p) (fy _ _ p) (fz _ _ p) r).
  Let floats : list (binary_float 53 1024) := of_floats fine_list.
  Let reals : list R := fine_list N fused (cx (at_ a)) (cy (at_ a)) (cz (at_ a)) (cx (at_ b)) (cy (at_ b)) (cz (at_ b)) (cx (at_ c)) (cy (at_ c))
    (cz (at_ c)) (cx (at_ p)) (cy (at_ p)) (cz (at_ p)) (B2R r).
  Let X : nat -> binary_float 53 1024 := inputs (fx _ _ a) (fy _ _ a) (fz _ _ a) (fx _ _ b) (fy _ _ b) (fz _ _ b) (fx _ _ c) (fy _ _ c) (fz _ _ c)
    (fx _ _ p) (fy _ _ p) (fz _ _ p) r.
  Let x : nat -> R := inputs (cx (at_ a)) (cy (at_ a)) (cz (at_ a)) (cx (at_ b)) (cy (at_ b)) (cz (at_ b)) (cx (at_ c)) (cy (at_ c))
    (cz (at_ c)) (cx (at_ p)) (cy (at_ p)) (cz (at_ p)) (B2R r).

  Lemma leaf_fits (k : nat) (y : binary_float 53 1024) : is_finite y = true -> in_binary32 (B2R y) -> ((k =? 12)%nat = true -> 0 <= B2R y) ->
    fits (leaf_extent k) y (B2R y).
  Proof using Type.
    intros FY [in_format small] positive. split; [exact FY |]. split; [reflexivity |]. unfold has_extent, leaf_extent. cbn [grid Extents.low high nonnegative].
    destruct (binary32_is_whole (B2R y) (conj in_format small)) as (z & value & _).
    assert (on_grid (-149) (B2R y)) as whole by (exists z; exact value).
    split; [exact whole |]. split; [apply grid_least, whole |]. split; [left; exact small | exact positive].
  Qed.
  Lemma all_leaves_fit i : fits (leaf_extent i) (X i) (x i).
  Proof using finite_query format r0.
    destruct finite_query as ((? & ? & ?) & (? & ? & ?) & (? & ? & ?) & (? & ? & ?) & ?).
    pose proof format as each. repeat (apply Forall_cons_iff in each as [? each]).
    do 12 (destruct i as [| i]; [apply leaf_fits; [assumption | assumption | discriminate] |]).
    assert (forall k, X (12 + k)%nat = r /\ x (12 + k)%nat = B2R r) as same by (intros [| [| k]]; split; reflexivity).
    destruct (same i) as [one two]. change (fits (leaf_extent (12 + i)) (X (12 + i)%nat) (x (12 + i)%nat)). rewrite one, two.
    apply leaf_fits; [assumption | assumption | intros _; exact r0].
  Qed.
  Lemma terms_fit t : match extent_of leaf_extent t with Some _ => true | None => false end = true ->
    exists d, fits d (eval F X t) (eval N x t).
  Proof using finite_query format greatest_is r0.
    destruct (extent_of leaf_extent t) as [d |] eqn:found; [intros _ | discriminate]. exists d.
    apply (extent_is_right least greatest other greatest_is leaf_extent X x all_leaves_fit t d found).
  Qed.
  Lemma flags_same : same_bc F (fx _ _ b) (fy _ _ b) (fz _ _ b) (fx _ _ c) (fy _ _ c) (fz _ _ c) =
    same_bc N (cx (at_ b)) (cy (at_ b)) (cz (at_ b)) (cx (at_ c)) (cy (at_ c)) (cz (at_ c)).
  Proof using finite_query format greatest_is r0.
    pose (t := nth 1 (fine_terms true true) Nought).
    destruct (terms_fit t eq_refl) as [d norm]. destruct (terms_fit Nought eq_refl) as [e nought].
    exact (equal_same least greatest other d e _ _ _ _ norm nought).
  Qed.
  Lemma numbers_fit k : exists d, fits d (nth k floats (m_zero F)) (nth k reals (m_zero N)).
  Proof using finite_query format greatest_is r0.
    unfold floats, reals. rewrite !fine_list_is. cbv zeta. rewrite flags_same.
    set (flag := same_bc N _ _ _ _ _ _). change (m_zero F) with (eval F X Nought). change (m_zero N) with (eval N x Nought).
    rewrite !map_nth. apply terms_fit. pose proof (fine_terms_fit fused flag) as all. unfold all_fit in all. rewrite forallb_forall in all.
    destruct (nth_in_or_default k (fine_terms fused flag) Nought) as [there | ->]; [exact (all _ there) | reflexivity].
  Qed.

  Variable q : question.
  Definition is_open_sphere := match q with open_sphere => true | closed_sphere => false end.
  Lemma known_is_same i : let f := fine_known F floats is_open_sphere in let n := fine_known N reals is_open_sphere in
    known_fails f i = known_fails n i /\ known_radius f i = known_radius n i /\ known_sides f i = known_sides n i.
  Proof using finite_query format greatest_is r0.
    assert (forall K, m_less F (fine_value F floats K) (m_negate F (fine_bound F floats K)) =
      m_less N (fine_value N reals K) (m_negate N (fine_bound N reals K))) as less.
    { intros K. destruct (numbers_fit (5 + 2 * place K)) as [d value], (numbers_fit (6 + 2 * place K)) as [e bound].
      exact (less_same _ _ _ _ _ _ _ _ _ value (negate_fits _ _ _ _ _ _ bound)). }
    assert (forall K, m_at_most F (fine_value F floats K) (m_negate F (fine_bound F floats K)) =
      m_at_most N (fine_value N reals K) (m_negate N (fine_bound N reals K))) as at_most.
    { intros K. destruct (numbers_fit (5 + 2 * place K)) as [d value], (numbers_fit (6 + 2 * place K)) as [e bound].
      exact (at_most_same _ _ _ _ _ _ _ _ _ value (negate_fits _ _ _ _ _ _ bound)). }
    assert (forall k, is_nought F floats k = is_nought N reals k) as nought.
    { intros k. destruct (numbers_fit k) as [d value]. destruct (terms_fit Nought eq_refl) as [e zero].
      exact (equal_same _ _ _ _ _ _ _ _ _ value zero). }
    assert (forall K, m_less F (fine_bound F floats K) (fine_value F floats K) = m_less N (fine_bound N reals K) (fine_value N reals K)) as beyond.
    { intros K. destruct (numbers_fit (5 + 2 * place K)) as [d value], (numbers_fit (6 + 2 * place K)) as [e bound].
      exact (less_same _ _ _ _ _ _ _ _ _ bound value). }
    assert (forall K, side_holds F floats K = side_holds N reals K) as holds.
    { intros K. destruct (numbers_fit (5 + 2 * place K)) as [d value], (numbers_fit (6 + 2 * place K)) as [e bound].
      exact (at_most_same _ _ _ _ _ _ _ _ _ bound value). }
    assert (forall K, side_fails F floats K = side_fails N reals K) as fails by exact less.
    cbv zeta. cbn [fine_known known_fails known_radius known_sides]. split; [| split; [apply beyond |]].
    - unfold fine_within. rewrite !less, !at_most, !nought. destruct i; cbn [sides_of fold_left]; rewrite ?fails; reflexivity.
    - destruct i; cbn [sides_of fold_left]; rewrite ?holds; reflexivity.
  Qed.

  Theorem fine_tells_right32 : let A := sub (at_ a) (at_ p) in let B := sub (at_ b) (at_ p) in let C := sub (at_ c) (at_ p) in
    sound_known (holds_for q A B C (B2R r * B2R r)) (fine_known F floats is_open_sphere).
  Proof using finite_query format greatest_is r0.
    cbv zeta. assert (forall y, Rabs (unbounded 53 y - y) <= bpow radix2 (-53) * Rabs y) as rounds_to.
    { intros y. pose proof (unbounded_error 53 eq_refl y) as off. rewrite Rplus_0_r in off. exact off. }
    intros i. destruct (known_is_same i) as (-> & -> & ->).
    exact (fine_known_is_sound (unbounded 53) rounds_to fused (at_ a) (at_ b) (at_ c) (at_ p) (B2R r) q i).
  Qed.
End Binary32.
