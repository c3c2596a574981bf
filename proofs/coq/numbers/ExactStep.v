(* The exact step of the certified predicate, kernel/sphere_triangle/certified/exact_step.cpp, on a query of integers: its
   margins as recorded are those of the reduced form, every value fits in the words of its degree, and its verdict is right
   for either sphere, whatever it is told that earlier steps know. *)
From Coq Require Import ZArith List Lia Reals Bool Lra.
From Axiscert Require Import Vectors Sat7 Exact Reduced OpenSphere Known Scaled ExactProgram RecordedExact.
Import ListNotations.
Open Scope Z_scope.

Definition exact_program := map fst recorded_exact.
Definition exact_results {T} (run : list T -> list instruction -> list T) (zero : T) (query : list T) : list T :=
  map (fun i => nth i (run query exact_program) zero) recorded_exact_results.
Definition exact_margins (query : list Z) : list Z := exact_results run_Z 0 query.

(* Sizes. *)
Theorem exact_values_fit n query : 1 <= n -> length query = 13%nat -> Forall (fun x => Z.abs x < 2 ^ (n - 1)) query ->
  Forall2 (fun degree value => Z.abs value < 2 ^ (64 * words_of n (Z.of_nat degree) - 1))
    (map snd recorded_exact) (skipn 13 (run_Z query exact_program)).
Proof.
  intros n1 thirteen small.
  assert (1 <= 2 ^ (n - 1)) as H1 by (pose proof (Z.pow_pos_nonneg 2 (n - 1) ltac:(lia) ltac:(lia)); lia).
  assert (Forall2 (bounded (2 ^ (n - 1))) (repeat (1, 1) 13) query) as all.
  { rewrite <- thirteen. clear thirteen. induction small as [| x rest below _ IH]; [constructor |]. cbn [length repeat].
    constructor; [| exact IH]. unfold bounded. cbn [fst snd]. rewrite Z.pow_1_r. lia. }
  apply (all_fit_is_enough n n1 _ (skipn 13 (run_bound (repeat (1, 1) 13) exact_program))); [vm_compute; reflexivity |].
  apply Forall2_skipn, bounded_run; assumption.
Qed.

(* Values. *)
Section Reals.
  Open Scope R_scope.
  Lemma moved_by p v w : sub w v = sub (sub w p) (sub v p). Proof. vec_ring. Qed.
  Lemma along_edge X Y : cross X (sub Y X) = cross X Y. Proof. vec_ring. Qed.
  Lemma turned_normal X Y Z : normal Y Z X = normal X Y Z. Proof. unfold normal. vec_ring. Qed.
  Lemma far_side X Y : dot X (sub Y X) = dot X Y - dot X X. Proof. vec_ring. Qed.

  Lemma vec_zero v : cx v = 0 /\ cy v = 0 /\ cz v = 0 <-> v = Vec 0 0 0.
  Proof. destruct v as [x y z]. cbn [cx cy cz]. split; [intros (-> & -> & ->) | intros [= -> -> ->]]; auto. Qed.

  Variables (a b c p : vec) (r : R).
  Let A := sub a p. Let B := sub b p. Let C := sub c p.
  Definition real_margins : list R :=
    let V := cross (sub b a) (sub c a) in
    let edge (from along : vec) := dot (cross from along) (cross from along) - r * r * dot along along in
    let side (from along : vec) := dot (cross from along) V in
    [dot A V * dot A V - r * r * dot V V;
     dot A A - r * r; dot A (sub b a); dot A (sub c a);
     dot B B - r * r; dot B (sub a b); dot B (sub c b);
     dot C C - r * r; dot C (sub a c); dot C (sub b c);
     edge A (sub b a); side A (sub b a); edge B (sub c b); side B (sub c b); edge C (sub a c); side C (sub a c);
     cx V; cy V; cz V; cx (sub b a); cy (sub b a); cz (sub b a); cx (sub c b); cy (sub c b); cz (sub c b);
     cx (sub a c); cy (sub a c); cz (sub a c)].
  Lemma recorded_margins :
    exact_results run_R 0 [cx a; cy a; cz a; cx b; cy b; cz b; cx c; cy c; cz c; cx p; cy p; cz p; r] = real_margins.
  Proof using Type. unfold real_margins, A, B, C. destruct a, b, c, p. reflexivity. Qed.

  (* The left side less the right one, of every comparison. *)
  Definition place_of (K : comparison) : nat :=
    match K with
    | plane_radius => 0 | vertex_a_radius => 1 | vertex_a_side_b => 2 | vertex_a_side_c => 3
    | vertex_b_radius => 4 | vertex_b_side_a => 5 | vertex_b_side_c => 6
    | vertex_c_radius => 7 | vertex_c_side_a => 8 | vertex_c_side_b => 9
    | edge_ab_radius => 10 | edge_ab_side_c => 11 | edge_bc_radius => 12 | edge_bc_side_a => 13
    | edge_ca_radius => 14 | edge_ca_side_b => 15
    end.
  Definition is_edge_side (K : comparison) : bool :=
    match K with edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => true | _ => false end.
  Lemma margins_are_reduced K :
    let s := reduced A B C (r * r) K in
    nth (place_of K) real_margins 0 = if is_edge_side K then snd s - fst s else fst s - snd s.
  Proof using Type.
    assert (cross (sub b a) (sub c a) = normal A B C) as V by (unfold normal, A, B, C; rewrite <- !(moved_by p); reflexivity).
    pose proof (moved_by p a b) as ab. pose proof (moved_by p b a) as ba. pose proof (moved_by p b c) as bc. pose proof (moved_by p c b) as cb.
    pose proof (moved_by p c a) as ca. pose proof (moved_by p a c) as ac. fold A B C in ab, ba, bc, cb, ca, ac.
    destruct K; cbv zeta; unfold real_margins; cbn [place_of nth is_edge_side reduced published];
      unfold plane_sides, vertex_radius_sides, vertex_side_sides, reduced_radius_sides, reduced_side_sides, offset, length2; cbn [fst snd];
      fold A B C.
    - rewrite V. reflexivity.
    - reflexivity.
    - rewrite ab. apply far_side.
    - rewrite ac. apply far_side.
    - reflexivity.
    - rewrite ba. apply far_side.
    - rewrite bc. apply far_side.
    - reflexivity.
    - rewrite ca. apply far_side.
    - rewrite cb. apply far_side.
    - rewrite ab, along_edge. reflexivity.
    - rewrite V, ab, along_edge. ring.
    - rewrite bc, along_edge. reflexivity.
    - rewrite V, bc, along_edge, (turned_normal A B C). ring.
    - rewrite ca, along_edge. reflexivity.
    - rewrite V, ca, along_edge, <- (turned_normal C A B). ring.
  Qed.
  Lemma normal_is :
    nth 16 real_margins 0 = 0 /\ nth 17 real_margins 0 = 0 /\ nth 18 real_margins 0 = 0 <-> normal A B C = Vec 0 0 0.
  Proof using Type. unfold real_margins, normal, A, B, C. cbn [nth]. rewrite <- !(moved_by p). apply vec_zero. Qed.
  Lemma ends_are : let zero k := nth k real_margins 0 = 0 /\ nth (k + 1) real_margins 0 = 0 /\ nth (k + 2) real_margins 0 = 0 in
    (zero 19%nat <-> sub B A = Vec 0 0 0) /\ (zero 22%nat <-> sub C B = Vec 0 0 0) /\ (zero 25%nat <-> sub A C = Vec 0 0 0).
  Proof using Type.
    cbv zeta. unfold real_margins, A, B, C. cbn [nth Nat.add]. rewrite <- !(moved_by p).
    split; [apply vec_zero | split; apply vec_zero].
  Qed.
End Reals.

(* The verdict of Test::separates, of what is known by earlier steps. *)
Section Verdict.
  Variable q : question.
  Variable k : known.
  Variable margins : list Z.
  Let at_ (i : nat) : Z := nth i margins 0.
  Definition radius_beyond (x : Z) : bool := match q with open_sphere => 0 <=? x | closed_sphere => 0 <? x end.
  Definition is_zero (i : nat) : bool := (at_ i =? 0) && (at_ (i + 1) =? 0) && (at_ (i + 2) =? 0).
  Definition vertex_separates (i : axis) (radius : nat) : bool :=
    negb (known_fails k i) && (known_radius k i || radius_beyond (at_ radius)) &&
    (known_sides k i || (0 <=? at_ (radius + 1)) && (0 <=? at_ (radius + 2))).
  Definition plane_separates : bool := negb (known_fails k axis_plane) && negb (is_zero 16) && radius_beyond (at_ 0).
  Definition edge_separates (i : axis) (along radius : nat) : bool :=
    negb (known_fails k i) && negb (is_zero along) && (known_sides k i || (at_ (radius + 1) <=? 0)) &&
    (known_radius k i || radius_beyond (at_ radius)).
  Definition exact_separates : bool :=
    vertex_separates axis_a 1 || vertex_separates axis_b 4 || vertex_separates axis_c 7 || plane_separates ||
    edge_separates axis_ab 19 10 || edge_separates axis_bc 22 12 || edge_separates axis_ca 25 14.
End Verdict.

Definition grid_point (x y z : Z) : vec := Vec (IZR x) (IZR y) (IZR z).

Lemma radius_is_no_edge_side K : is_side K = false -> is_edge_side K = false.
Proof. destruct K; (reflexivity || discriminate). Qed.
Lemma side_has_normal A B C K : is_side K = true -> has_normal A B C K.
Proof. destruct K; (discriminate || exact (fun _ => I)). Qed.

Section Decides.
  Variable q : question.
  Variables ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : Z.
  Let a := grid_point ax ay az. Let b := grid_point bx by_ bz. Let c := grid_point cx_ cy_ cz_. Let p := grid_point px py pz.
  Let A := sub a p. Let B := sub b p. Let C := sub c p.
  (* The margins, of which only the values matter. *)
  Variable m : list Z.
  Hypothesis margin_at : forall i, IZR (nth i m 0) = nth i (real_margins a b c p (IZR r)) 0%R.
  Let holds := holds_for q A B C (IZR r * IZR r).

  Lemma zero_at i : is_zero m i = true <->
    (nth i (real_margins a b c p (IZR r)) 0 = 0 /\ nth (i + 1) (real_margins a b c p (IZR r)) 0 = 0 /\
     nth (i + 2) (real_margins a b c p (IZR r)) 0 = 0)%R.
  Proof using margin_at.
    unfold is_zero. rewrite !andb_true_iff, !Z.eqb_eq, <- !margin_at. rewrite and_assoc.
    assert (forall z, z = 0%Z <-> IZR z = 0%R) as each by (intros z; split; [intros -> | intros H; apply eq_IZR]; auto).
    rewrite !each. reflexivity.
  Qed.
  Lemma at_least z : (0 <=? z) = true <-> (0 <= IZR z)%R.
  Proof using Type. rewrite Z.leb_le. split; [apply (IZR_le 0) | apply (le_IZR 0)]. Qed.
  Lemma at_most z : (z <=? 0) = true <-> (IZR z <= 0)%R.
  Proof using Type. rewrite Z.leb_le. split; [apply (IZR_le z 0) | apply (le_IZR z 0)]. Qed.
  Lemma greater z : (0 <? z) = true <-> (0 < IZR z)%R.
  Proof using Type. rewrite Z.ltb_lt. split; [apply (IZR_lt 0) | apply (lt_IZR 0)]. Qed.

  (* A radius comparison of an axis that has a normal, and a side comparison. *)
  Lemma radius_decides K : is_side K = false ->
    (has_normal A B C K /\ radius_beyond q (nth (place_of K) m 0) = true <-> holds K).
  Proof using margin_at.
    intros radius. pose proof (margins_are_reduced a b c p (IZR r) K) as value. cbv zeta in value. fold A B C in value.
    rewrite <- margin_at, (radius_is_no_edge_side K radius) in value. unfold holds, holds_for, radius_beyond. destruct q.
    - rewrite greater, value. unfold nonstrict. rewrite radius. set (s := reduced A B C (IZR r * IZR r) K) in *.
      split; [intros [_ positive]; lra |]. intros positive. split; [| lra].
      destruct (sides_shape A B C K) as [(side & _) | (_ & f & n & f0 & n0 & some & flat & same)]; [congruence |].
      unfold s in positive. rewrite same in positive. cbn [fst snd] in positive. apply some.
      destruct (Rle_lt_or_eq_dec 0 n n0) as [| zero]; [assumption |]. rewrite (flat (eq_sym zero)), <- zero in positive. lra.
    - rewrite at_least, value. unfold open_holds, weak. split; intros [one two]; (split; [lra | assumption]) || (split; [assumption | lra]).
  Qed.
  Lemma side_decides K : is_side K = true ->
    ((if is_edge_side K then nth (place_of K) m 0 <=? 0 else 0 <=? nth (place_of K) m 0) = true <-> holds K).
  Proof using A B C margin_at q.
    intros side. pose proof (margins_are_reduced a b c p (IZR r) K) as value. cbv zeta in value. fold A B C in value.
    rewrite <- margin_at in value.
    pose proof (side_has_normal A B C K side) as normal.
    unfold holds, holds_for. destruct q; unfold nonstrict, open_holds, weak; rewrite ?side;
      destruct (is_edge_side K); rewrite ?at_most, ?at_least, value; intuition lra.
  Qed.
  (* A radius comparison that holds has a normal. *)
  Lemma holds_has_normal K : is_side K = false -> holds K -> has_normal A B C K.
  Proof using margin_at q. intros radius H. apply (radius_decides K radius) in H. apply H. Qed.

  Lemma margins_decide k : 0 <= r -> sound_known holds k ->
    (exact_separates q k m = true <-> apart q a b c p (IZR r)).
  Proof using A B C margin_at.
    intros r0 sound. pose proof (IZR_le 0 r r0) as r0'. rewrite <- (last_step_decides q a b c p (IZR r) k r0' sound). fold A B C. fold holds.
    destruct (ends_are a b c p (IZR r)) as (ends1 & ends2 & ends3). fold A B C in ends1, ends2, ends3.
    pose proof (normal_is a b c p (IZR r)) as flat. fold A B C in flat.
    rewrite <- zero_at in ends1, ends2, ends3, flat.
    assert (vertex : forall i radius K S S', radius_of i = K -> is_side K = false -> is_side S = true -> is_side S' = true ->
      is_edge_side S = false -> is_edge_side S' = false -> has_normal A B C K ->
      place_of K = radius -> place_of S = (radius + 1)%nat -> place_of S' = (radius + 2)%nat ->
      (sides_hold holds i <-> holds S /\ holds S') ->
      (vertex_separates q k m i radius = true <-> known_fails k i = false /\ (known_radius k i = true \/ holds (radius_of i)) /\
        (known_sides k i = true \/ sides_hold holds i))).
    { intros i radius K S S' name rad side side' no no' some place place1 place2 sides. unfold vertex_separates.
      rewrite !andb_true_iff, !orb_true_iff, negb_true_iff, andb_true_iff, name, sides.
      rewrite <- (radius_decides K rad), <- (side_decides S side), <- (side_decides S' side'), no, no', place, place1, place2. tauto. }
    assert (edge : forall i along radius K S, radius_of i = K -> is_side K = false -> is_side S = true -> is_edge_side S = true ->
      place_of K = radius -> place_of S = (radius + 1)%nat -> (sides_hold holds i <-> holds S) ->
      (is_zero m along = false <-> has_normal A B C K) ->
      (edge_separates q k m i along radius = true <-> known_fails k i = false /\ (known_radius k i = true \/ holds (radius_of i)) /\
        (known_sides k i = true \/ sides_hold holds i))).
    { intros i along radius K S name rad side yes place place1 sides some. unfold edge_separates.
      rewrite !andb_true_iff, !orb_true_iff, !negb_true_iff, name, sides, some.
      rewrite <- (radius_decides K rad), <- (side_decides S side), yes, place, place1.
      assert (known_radius k i = true -> has_normal A B C K) as told.
      { intros set. apply holds_has_normal; [assumption |]. rewrite <- name. apply (sound i), set. }
      tauto. }
    assert (not_zero : forall i v, (is_zero m i = true <-> v = Vec 0 0 0) -> (is_zero m i = false <-> v <> Vec 0 0 0)).
    { intros i v same. destruct (is_zero m i); split; intros H; try discriminate; try reflexivity.
      - exfalso. apply H, same. reflexivity.
      - intros zero. apply same in zero. discriminate. }
    pose proof (vertex axis_a 1%nat _ vertex_a_side_b vertex_a_side_c eq_refl eq_refl eq_refl eq_refl eq_refl eq_refl I eq_refl eq_refl eq_refl
      (iff_refl _)) as at_a.
    pose proof (vertex axis_b 4%nat _ vertex_b_side_a vertex_b_side_c eq_refl eq_refl eq_refl eq_refl eq_refl eq_refl I eq_refl eq_refl eq_refl
      (iff_refl _)) as at_b.
    pose proof (vertex axis_c 7%nat _ vertex_c_side_a vertex_c_side_b eq_refl eq_refl eq_refl eq_refl eq_refl eq_refl I eq_refl eq_refl eq_refl
      (iff_refl _)) as at_c.
    pose proof (edge axis_ab 19%nat 10%nat _ edge_ab_side_c eq_refl eq_refl eq_refl eq_refl eq_refl eq_refl (iff_refl _) (not_zero _ _ ends1)) as at_ab.
    pose proof (edge axis_bc 22%nat 12%nat _ edge_bc_side_a eq_refl eq_refl eq_refl eq_refl eq_refl eq_refl (iff_refl _) (not_zero _ _ ends2)) as at_bc.
    pose proof (edge axis_ca 25%nat 14%nat _ edge_ca_side_b eq_refl eq_refl eq_refl eq_refl eq_refl eq_refl (iff_refl _) (not_zero _ _ ends3)) as at_ca.
    assert (plane_separates q k m = true <-> known_fails k axis_plane = false /\ (known_radius k axis_plane = true \/ holds plane_radius) /\
      (known_sides k axis_plane = true \/ True)) as at_plane.
    { unfold plane_separates. rewrite !andb_true_iff, !negb_true_iff, (not_zero _ _ flat), <- (radius_decides plane_radius eq_refl).
      assert (known_radius k axis_plane = true -> holds plane_radius) as told by apply (sound axis_plane).
      rewrite <- (radius_decides plane_radius eq_refl) in told. cbn [has_normal place_of] in *. tauto. }
    unfold exact_separates. rewrite !orb_true_iff, at_a, at_b, at_c, at_plane, at_ab, at_bc, at_ca. split.
    - intros H. decompose [or] H; [exists axis_a | exists axis_b | exists axis_c | exists axis_plane | exists axis_ab | exists axis_bc |
        exists axis_ca]; assumption.
    - intros [i H]. destruct i; [do 6 left | do 5 left; right | do 4 left; right | do 3 left; right | do 2 left; right | left; right | right];
        exact H.
  Qed.
End Decides.

Theorem exact_step_decides q ax ay az bx by_ bz cx_ cy_ cz_ px py pz r k :
  let a := grid_point ax ay az in let b := grid_point bx by_ bz in let c := grid_point cx_ cy_ cz_ in let p := grid_point px py pz in
  0 <= r -> sound_known (holds_for q (sub a p) (sub b p) (sub c p) (IZR r * IZR r)) k ->
  (exact_separates q k (exact_margins [ax; ay; az; bx; by_; bz; cx_; cy_; cz_; px; py; pz; r]) = true <-> apart q a b c p (IZR r)).
Proof.
  cbv zeta. intros r0 sound. apply margins_decide; [| assumption | assumption]. intros i. rewrite <- recorded_margins. unfold exact_margins.
  rewrite <- (map_nth IZR). f_equal. unfold exact_results. rewrite map_map. apply map_ext. intros j.
  rewrite <- (map_nth IZR), run_Z_is_run_R. reflexivity.
Qed.
