(* Certified is exact. Of a query whose thirteen numbers are whole multiples of a power of two, below 2^285 of it in magnitude,
   as all of binary32 are, the exact step gives the right verdict, for either sphere, whatever the steps in floating point have
   told it, provided that what they told is right. For AXISCERT_EXACT_ONLY they have told nothing.

   The exact step's program, what it makes of the signs of its values, and the integers that it takes are those recorded from
   the code (RecordedExact.v). That the code's integers have the values of Z where these fit in their words, and that the doubles
   are converted to them, is trusted here. *)
From Coq Require Import ZArith List Lia Reals Bool Lra.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Exact Reduced OpenSphere Known Scaled ExactProgram RecordedExact ExactStep ExactVerdict.
Import ListNotations.
Open Scope Z_scope.

Lemma scaled_difference v w k : sub (scale v k) (scale w k) = scale (sub v w) k.
Proof. vec_ring. Qed.

(* A query times a positive number has the same answers. *)
Section Scale.
  Open Scope R_scope.
  Lemma dot_scale u v k l : dot (scale u k) (scale v l) = dot u v * (k * l).
  Proof. vec_ring. Qed.
  Lemma cross_scale u v k l : cross (scale u k) (scale v l) = scale (cross u v) (k * l).
  Proof. vec_ring. Qed.
  Lemma normal_scale A B C k : normal (scale A k) (scale B k) (scale C k) = scale (normal A B C) (k * k).
  Proof. unfold normal. rewrite !scaled_difference, cross_scale. reflexivity. Qed.
  Lemma scale_zero v k : 0 < k -> scale v k = Vec 0 0 0 <-> v = Vec 0 0 0.
  Proof.
    intros k0. destruct v as [x y z]. unfold scale. cbn [cx cy cz]. split; intros [= X Y Z].
    - apply Rmult_integral in X, Y, Z. f_equal; lra.
    - subst. f_equal; ring.
  Qed.
  Lemma scaled_sides A B C rr k K : 0 < k -> exists e, 0 < e /\
    reduced (scale A k) (scale B k) (scale C k) (rr * (k * k)) K = (e * fst (reduced A B C rr K), e * snd (reduced A B C rr K)).
  Proof.
    intros k0. pose proof (Rmult_lt_0_compat k k k0 k0) as k2. pose proof (Rmult_lt_0_compat _ _ k2 k2) as k4.
    pose proof (Rmult_lt_0_compat _ _ k4 k2) as k6.
    assert (vertex : forall X, vertex_radius_sides (scale X k) (rr * (k * k)) = (k * k * dot X X, k * k * rr)).
    { intros X. unfold vertex_radius_sides. rewrite dot_scale. f_equal; ring. }
    assert (side : forall X Y, vertex_side_sides (scale X k) (scale Y k) = (k * k * dot X Y, k * k * dot X X)).
    { intros X Y. unfold vertex_side_sides. rewrite !dot_scale. f_equal; ring. }
    assert (edge : forall X Y, reduced_radius_sides (scale X k) (scale Y k) (rr * (k * k)) =
      (k * k * (k * k) * dot (cross X Y) (cross X Y), k * k * (k * k) * (rr * length2 X Y))).
    { intros X Y. unfold reduced_radius_sides, length2. rewrite scaled_difference, cross_scale, !dot_scale. f_equal; ring. }
    assert (edge_side : forall X Y Z, reduced_side_sides (scale X k) (scale Y k) (scale Z k) =
      (k * k * (k * k) * 0, k * k * (k * k) * dot (cross X Y) (normal X Y Z))).
    { intros X Y Z. unfold reduced_side_sides. rewrite normal_scale, cross_scale, dot_scale. f_equal; ring. }
    assert (plane : plane_sides (scale A k) (scale B k) (scale C k) (rr * (k * k)) =
      (k * k * (k * k) * (k * k) * (offset A B C * offset A B C), k * k * (k * k) * (k * k) * (rr * dot (normal A B C) (normal A B C)))).
    { unfold plane_sides, offset. rewrite normal_scale, !dot_scale. f_equal; ring. }
    destruct K; cbn [reduced published]; rewrite ?vertex, ?side, ?edge, ?edge_side, ?plane; eexists; (split; [| reflexivity]); assumption.
  Qed.
  Lemma scaled_normal A B C k K : 0 < k -> has_normal (scale A k) (scale B k) (scale C k) K <-> has_normal A B C K.
  Proof.
    intros k0. pose proof (Rmult_lt_0_compat k k k0 k0) as k2.
    destruct K; cbn [has_normal]; rewrite ?scaled_difference, ?normal_scale, ?(scale_zero _ k k0), ?(scale_zero _ _ k2); reflexivity.
  Qed.
  Lemma scaled_holds A B C rr k q K : 0 < k ->
    holds_for q (scale A k) (scale B k) (scale C k) (rr * (k * k)) K <-> holds_for q A B C rr K.
  Proof.
    intros k0. destruct (scaled_sides A B C rr k K k0) as (e & e0 & same).
    assert (more : forall x y, e * x > e * y <-> x > y)
      by (intros; split; intros; [apply Rmult_lt_reg_l with e | apply Rmult_lt_compat_l]; assumption).
    assert (most : forall x y, e * x >= e * y <-> x >= y).
    { intros; split; intros H; apply Rle_ge; apply Rge_le in H; [apply Rmult_le_reg_l with e | apply Rmult_le_compat_l]; lra. }
    unfold holds_for, nonstrict, open_holds, weak. rewrite same. cbn [fst snd]. destruct q.
    - destruct (is_side K); [apply most | apply more].
    - pose proof (scaled_normal A B C k K k0) as normal. pose proof (most (fst (reduced A B C rr K)) (snd (reduced A B C rr K))). tauto.
  Qed.
End Scale.

Lemma sound_weaker (holds holds' : comparison -> Prop) k : (forall K, holds K <-> holds' K) -> sound_known holds k -> sound_known holds' k.
Proof.
  intros same sound i. destruct (sound i) as (fails & radius & sides). unfold axis_holds in *. rewrite <- (same (radius_of i)).
  assert (sides_hold holds' i <-> sides_hold holds i) as -> by (destruct i; cbn; rewrite ?same; tauto). auto.
Qed.

Lemma all_sound holds told : Forall (sound_known holds) told -> sound_known holds (fold_right both_known nothing_known told).
Proof. induction 1; [apply nothing_is_sound | cbn [fold_right]; apply both_are_sound; assumption]. Qed.

Section Exact.
  Variable q : question.
  (* The query: whole multiples of 2^unit, below 2^(bits - 1) of it. *)
  Variables unit bits ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : Z.
  Definition whole_query := [ax; ay; az; bx; by_; bz; cx_; cy_; cz_; px; py; pz; r].
  Hypothesis span : 1 <= bits <= 286.
  Hypothesis below : Forall (fun x => Z.abs x < 2 ^ (bits - 1)) whole_query.
  Hypothesis r_nonneg : 0 <= r.
  Let point x y z := scale (grid_point x y z) (bpow radix2 unit).
  Let a := point ax ay az. Let b := point bx by_ bz. Let c := point cx_ cy_ cz_. Let p := point px py pz.
  Let radius := (IZR r * bpow radix2 unit)%R.

  (* The steps in floating point have told bits that are right, in any order. *)
  Variable told : list known.
  Hypothesis told_is_right : Forall (sound_known (holds_for q (sub a p) (sub b p) (sub c p) (radius * radius))) told.
  Let k := fold_right both_known nothing_known told.

  Lemma all_told : sound_known (holds_for q (sub a p) (sub b p) (sub c p) (radius * radius)) k.
  Proof using told_is_right. apply all_sound, told_is_right. Qed.

  Theorem certified_is_exact_for_a_query :
    (* a verdict that the bits give is right *)
    (is_separated k = true -> apart q a b c p radius) /\ (is_contact k = true -> ~ apart q a b c p radius) /\
    (* else the exact step's is, and each of its values fits, with its sign, in the words of its degree in the integers taken *)
    (recorded_separates q k (run_Z whole_query exact_program) = true <-> apart q a b c p radius) /\
    Forall2 (fun degree value => Z.abs value < 2 ^ (64 * recorded_words (size_for bits) (Z.of_nat degree) - 1))
      (map snd recorded_exact) (skipn 13 (run_Z whole_query exact_program)).
  Proof using below r_nonneg span told_is_right.
    pose proof all_told as sound. pose proof (bpow_gt_0 radix2 unit) as u0.
    assert (0 <= radius)%R as radius0 by (unfold radius; apply Rmult_le_pos; [apply (IZR_le 0); assumption | lra]).
    destruct (known_is_right q a b c p radius k radius0 sound) as [one two]. split; [exact one |]. split; [exact two |]. split.
    - rewrite recorded_verdict_is_exact_separates. unfold a, b, c, p, radius, point. rewrite (scaled_is_same q _ _ _ _ _ _ u0). refine (exact_step_decides q ax ay az bx by_ bz cx_ cy_ cz_ px py pz r k r_nonneg _).
      eapply sound_weaker; [| exact sound]. intros K.
      pose proof (scaled_holds (sub (grid_point ax ay az) (grid_point px py pz)) (sub (grid_point bx by_ bz) (grid_point px py pz))
        (sub (grid_point cx_ cy_ cz_) (grid_point px py pz)) (IZR r * IZR r) (bpow radix2 unit) q K u0) as same.
      rewrite <- !scaled_difference in same.
      replace (radius * radius)%R with (IZR r * IZR r * (bpow radix2 unit * bpow radix2 unit))%R by (unfold radius; ring). exact same.
    - apply recorded_values_fit; [exact span | reflexivity | exact below].
  Qed.
End Exact.

(* The statement, in one place. *)
Definition certified_is_exact : Prop :=
  forall (q : question) (unit bits ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : Z) (told : list known),
  let query := [ax; ay; az; bx; by_; bz; cx_; cy_; cz_; px; py; pz; r] in
  let point x y z := scale (grid_point x y z) (bpow radix2 unit) in
  let radius := (IZR r * bpow radix2 unit)%R in
  let a := point ax ay az in let b := point bx by_ bz in let c := point cx_ cy_ cz_ in let p := point px py pz in
  let truth := apart q a b c p radius in
  let k := fold_right both_known nothing_known told in
  1 <= bits <= 286 -> Forall (fun x => Z.abs x < 2 ^ (bits - 1)) query -> 0 <= r ->
  Forall (sound_known (holds_for q (sub a p) (sub b p) (sub c p) (radius * radius))) told ->
  (is_separated k = true -> truth) /\ (is_contact k = true -> ~ truth) /\
  (recorded_separates q k (run_Z query exact_program) = true <-> truth) /\
  Forall2 (fun degree value => Z.abs value < 2 ^ (64 * recorded_words (size_for bits) (Z.of_nat degree) - 1))
    (map snd recorded_exact) (skipn 13 (run_Z query exact_program)).
Theorem certified_is_exact_within_286_bits : certified_is_exact.
Proof. intros q unit bits ax ay az bx by_ bz cx_ cy_ cz_ px py pz r told. cbv zeta. intros. apply certified_is_exact_for_a_query; assumption. Qed.

(* AXISCERT_EXACT_ONLY: nothing is told, so nothing is assumed of floating point. *)
Definition exact_only_is_exact : Prop :=
  forall (q : question) (unit bits ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : Z),
  let query := [ax; ay; az; bx; by_; bz; cx_; cy_; cz_; px; py; pz; r] in
  let point x y z := scale (grid_point x y z) (bpow radix2 unit) in
  1 <= bits <= 286 -> Forall (fun x => Z.abs x < 2 ^ (bits - 1)) query -> 0 <= r ->
  (recorded_separates q nothing_known (run_Z query exact_program) = true <->
    apart q (point ax ay az) (point bx by_ bz) (point cx_ cy_ cz_) (point px py pz) (IZR r * bpow radix2 unit)) /\
  Forall2 (fun degree value => Z.abs value < 2 ^ (64 * recorded_words (size_for bits) (Z.of_nat degree) - 1))
    (map snd recorded_exact) (skipn 13 (run_Z query exact_program)).
Theorem exact_only_is_exact_within_286_bits : exact_only_is_exact.
Proof.
  intros q unit bits ax ay az bx by_ bz cx_ cy_ cz_ px py pz r. cbv zeta. intros span below r0.
  exact (proj2 (proj2 (certified_is_exact_within_286_bits q unit bits ax ay az bx by_ bz cx_ cy_ cz_ px py pz r [] span below r0 (Forall_nil _)))).
Qed.

(* Of binary32 every query: its numbers are whole multiples of 2^-149 below 2^277 of it. *)
Definition in_binary32 (x : R) : Prop := generic_format radix2 (FLT_exp (-149) 24) x /\ (Rabs x < bpow radix2 128)%R.
Definition of_least (z : Z) : R := (IZR z * bpow radix2 (-149))%R.
Lemma binary32_is_whole x : in_binary32 x -> exists z, x = of_least z /\ Z.abs z < 2 ^ (278 - 1).
Proof.
  intros [format small]. apply FLT_format_generic in format; [| reflexivity]. destruct format as [[m e] value _ least].
  cbn [Fexp] in least. exists (m * 2 ^ (e + 149)). unfold of_least.
  assert (x = (IZR (m * 2 ^ (e + 149)) * bpow radix2 (-149))%R) as same.
  { rewrite value. unfold F2R. cbn [Fnum Fexp]. rewrite mult_IZR. change 2 with (radix_val radix2). rewrite IZR_Zpower by lia.
    rewrite Rmult_assoc, <- bpow_plus. do 2 f_equal. lia. }
  split; [exact same |]. apply lt_IZR. rewrite abs_IZR. change 2 with (radix_val radix2). rewrite IZR_Zpower by lia.
  rewrite same, Rabs_mult, (Rabs_pos_eq (bpow radix2 (-149))) in small by apply bpow_ge_0.
  apply Rmult_lt_reg_r with (bpow radix2 (-149)); [apply bpow_gt_0 |]. rewrite <- bpow_plus. exact small.
Qed.

Definition certified_is_exact_of_binary32 : Prop :=
  forall (q : question) (ax ay az bx by_ bz cx_ cy_ cz_ px py pz r : R) (told : list known),
  let query := [ax; ay; az; bx; by_; bz; cx_; cy_; cz_; px; py; pz; r] in
  let a := Vec ax ay az in let b := Vec bx by_ bz in let c := Vec cx_ cy_ cz_ in let p := Vec px py pz in
  let truth := apart q a b c p r in let k := fold_right both_known nothing_known told in
  Forall in_binary32 query -> (0 <= r)%R -> Forall (sound_known (holds_for q (sub a p) (sub b p) (sub c p) (r * r))) told ->
  (is_separated k = true -> truth) /\ (is_contact k = true -> ~ truth) /\
  exists whole : list Z, map of_least whole = query /\
    (recorded_separates q k (run_Z whole exact_program) = true <-> truth) /\
    Forall2 (fun degree value => Z.abs value < 2 ^ (64 * recorded_words (size_for 278) (Z.of_nat degree) - 1))
      (map snd recorded_exact) (skipn 13 (run_Z whole exact_program)).
Theorem certified_is_exact_binary32 : certified_is_exact_of_binary32.
Proof.
  intros q ax ay az bx by_ bz cx_ cy_ cz_ px py pz r told. cbv zeta. intros format r0 sound.
  assert (exists whole : list Z, map of_least whole = [ax; ay; az; bx; by_; bz; cx_; cy_; cz_; px; py; pz; r] /\
    Forall (fun z => Z.abs z < 2 ^ (278 - 1)) whole) as (whole & same & below).
  { clear r0 sound. induction format as [| x l one _ (w & same & below)]; [exists []; split; constructor |].
    destruct (binary32_is_whole x one) as (z & value & small). exists (z :: w). split; [| constructor; assumption].
    cbn [map]. f_equal; [symmetry; exact value | exact same]. }
  do 13 (destruct whole as [| ? whole]; [discriminate same |]). destruct whole; [| discriminate same].
  cbn [map] in same. injection same as <- <- <- <- <- <- <- <- <- <- <- <- <-.
  match type of below with Forall _ [?z1; ?z2; ?z3; ?z4; ?z5; ?z6; ?z7; ?z8; ?z9; ?z10; ?z11; ?z12; ?z13] =>
    pose proof (certified_is_exact_within_286_bits q (-149) 278 z1 z2 z3 z4 z5 z6 z7 z8 z9 z10 z11 z12 z13 told) as exact end.
  cbv zeta in exact. specialize (exact ltac:(lia) below). cbn [cx cy cz scale grid_point] in exact.
  destruct exact as (one & two & three & four); [| exact sound |].
  - unfold of_least in r0. apply le_IZR. apply Rmult_le_reg_r with (bpow radix2 (-149)); [apply bpow_gt_0 |]. rewrite Rmult_0_l. exact r0.
  - split; [exact one |]. split; [exact two |]. eexists. split; [| split; [exact three | exact four]]. reflexivity.
Qed.
