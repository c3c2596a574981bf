(* Ball arithmetic, kernel/sphere_triangle/certified/ball.h: every ball holds its number, so the signs that are certain of the
   exact step's margins are right, and so are the bits that they tell, as recorded, for either sphere. *)
From Coq Require Import ZArith Reals Bool List Lia Lra.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Reduced OpenSphere Known ExactProgram RecordedExact ExactStep.
Import ListNotations.
Open Scope Z_scope.

(* A number between (middle - error) 2^exponent and (middle + error) 2^exponent. *)
Record ball := Ball { middle : Z; error : Z; exponent : Z }.
Definition ball_width (m k : Z) : Z := let any := Z.lor (Z.abs m) k in if any =? 0 then 0 else Z.log2 any + 1.
Definition lost (x power : Z) : Z := if x mod power =? 0 then 0 else 1.
Definition rounded_ball (m k e : Z) : ball :=
  let down := ball_width m k - 62 in let power := 2 ^ down in
  if down <=? 0 then Ball m k e else Ball (m / power) (k / power + lost m power + lost k power) (e + down).
(* x has the greater exponent. *)
Definition ball_sum (x y : ball) : ball :=
  let free := Z.max 0 (62 - ball_width (middle x) (error x)) in let apart := exponent x - exponent y in
  if apart <=? 62 + free
  then rounded_ball (middle x * 2 ^ apart + middle y) (error x * 2 ^ apart + error y) (exponent y)
  else rounded_ball (middle x * 2 ^ free) (error x * 2 ^ free + 2) (exponent x - free).
Definition is_zero_ball (x : ball) : bool := (middle x =? 0) && (error x =? 0).
Definition ball_plus (x y : ball) : ball :=
  if is_zero_ball x then y else if is_zero_ball y then x else if exponent y <=? exponent x then ball_sum x y else ball_sum y x.
Definition ball_minus (x y : ball) : ball := ball_plus x (Ball (- middle y) (error y) (exponent y)).
Definition ball_times (x y : ball) : ball :=
  rounded_ball (middle x * middle y) (Z.abs (middle x) * error y + error x * (Z.abs (middle y) + error y)) (exponent x + exponent y).
Definition run_balls := run_program ball (Ball 0 0 0) ball_plus ball_minus ball_times.

Definition in_ball (b : ball) (x : R) : Prop :=
  (Z.abs (middle b) <= 2 ^ 62 + 1 /\ 0 <= error b <= 2 ^ 62 + 1) /\
  (Rabs (x - IZR (middle b) * bpow radix2 (exponent b)) <= IZR (error b) * bpow radix2 (exponent b))%R.

Lemma width_spec m k : 0 <= k -> 0 <= ball_width m k /\ Z.abs m < 2 ^ ball_width m k /\ k < 2 ^ ball_width m k.
Proof.
  intros k0. unfold ball_width. cbv zeta. destruct (Z.eqb_spec (Z.lor (Z.abs m) k) 0) as [zero | some].
  - apply Z.lor_eq_0_iff in zero as [-> ->]. cbn. lia.
  - pose proof (Z.log2_nonneg (Z.lor (Z.abs m) k)) as log0. pose proof (Z.log2_lor (Z.abs m) k ltac:(lia) k0) as each.
    assert (forall x, 0 <= x -> Z.log2 x <= Z.log2 (Z.lor (Z.abs m) k) -> x < 2 ^ (Z.log2 (Z.lor (Z.abs m) k) + 1)) as below.
    { intros x x0 less. destruct (Z.eq_dec x 0) as [-> |]; [apply Z.pow_pos_nonneg; lia |].
      apply Z.log2_lt_pow2; lia. }
    split; [lia |]. split; apply below; lia.
Qed.
Open Scope R_scope.
Lemma rounded_holds m k e x : (0 <= k)%Z -> Rabs (x - IZR m * bpow radix2 e) <= IZR k * bpow radix2 e -> in_ball (rounded_ball m k e) x.
Proof.
  intros k0 near. destruct (width_spec m k k0) as (w0 & wm & wk). unfold rounded_ball. set (w := ball_width m k) in *. cbv zeta.
  destruct (Z.leb_spec (w - 62) 0) as [few | many].
  - split; [cbn [middle error] | exact near]. assert (2 ^ w <= 2 ^ 62)%Z by (apply Z.pow_le_mono_r; lia). lia.
  - set (power := (2 ^ (w - 62))%Z). assert (0 < power)%Z as p0 by (apply Z.pow_pos_nonneg; lia).
    assert (2 ^ w = 2 ^ 62 * power)%Z as whole by (unfold power; rewrite <- Z.pow_add_r by lia; f_equal; lia).
    pose proof (Z.div_mod m power ltac:(lia)) as dm. pose proof (Z.mod_pos_bound m power p0) as bm.
    pose proof (Z.div_mod k power ltac:(lia)) as dk. pose proof (Z.mod_pos_bound k power p0) as bk.
    assert (m mod power <= power * lost m power)%Z as lm by (unfold lost; destruct (Z.eqb_spec (m mod power) 0); lia).
    assert (k mod power <= power * lost k power)%Z as lk by (unfold lost; destruct (Z.eqb_spec (k mod power) 0); lia).
    assert (0 <= lost m power <= 1 /\ 0 <= lost k power <= 1)%Z as bits by (unfold lost; destruct (_ =? _)%Z, (_ =? _)%Z; lia).
    assert (0 <= k / power < 2 ^ 62)%Z as ek by (split; [apply Z.div_pos; lia | apply Z.div_lt_upper_bound; lia]).
    assert (- 2 ^ 62 <= m / power < 2 ^ 62)%Z as em by (split; [apply Z.div_le_lower_bound; lia | apply Z.div_lt_upper_bound; lia]).
    split; cbn [middle error exponent]; [lia |].
    assert (bpow radix2 (e + (w - 62)) = IZR power * bpow radix2 e) as scale.
    { rewrite Z.add_comm, bpow_plus. unfold power. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by lia. reflexivity. }
    rewrite scale. set (s := bpow radix2 e) in *. assert (0 < s) as s0 by apply bpow_gt_0.
    replace (x - IZR (m / power) * (IZR power * s)) with ((x - IZR m * s) + IZR (m mod power) * s)
      by (rewrite dm at 1; rewrite plus_IZR, mult_IZR; ring).
    eapply Rle_trans; [apply Rabs_triang |]. rewrite (Rabs_pos_eq (IZR (m mod power) * s)) by (apply Rmult_le_pos; [apply IZR_le; lia | lra]).
    apply Rle_trans with (IZR k * s + IZR (m mod power) * s); [lra |]. rewrite <- Rmult_plus_distr_r, <- plus_IZR, <- Rmult_assoc, <- mult_IZR.
    apply Rmult_le_compat_r; [lra |]. apply IZR_le. lia.
Qed.

Lemma minus_near x y m n k l s : Rabs (x - m * s) <= k * s -> Rabs (y - n * s) <= l * s -> Rabs (x + y - (m + n) * s) <= (k + l) * s.
Proof.
  intros. replace (x + y - (m + n) * s) with ((x - m * s) + (y - n * s)) by ring. eapply Rle_trans; [apply Rabs_triang | lra].
Qed.
Lemma rescaled x m k e d : (0 <= d)%Z -> Rabs (x - IZR m * bpow radix2 e) <= IZR k * bpow radix2 e ->
  Rabs (x - IZR (m * 2 ^ d) * bpow radix2 (e - d)) <= IZR (k * 2 ^ d) * bpow radix2 (e - d).
Proof.
  intros d0 near. assert (bpow radix2 e = IZR (2 ^ d) * bpow radix2 (e - d)) as scale.
  { change 2%Z with (radix_val radix2). rewrite IZR_Zpower, <- bpow_plus by lia. f_equal. lia. }
  rewrite !mult_IZR, !Rmult_assoc, <- scale. exact near.
Qed.
Lemma sum_holds x y b c : (exponent c <= exponent b)%Z -> in_ball b x -> in_ball c y -> in_ball (ball_sum b c) (x + y).
Proof.
  intros order ((mb & kb) & near) ((mc & kc) & near'). unfold ball_sum. cbv zeta. set (free := Z.max 0 _).
  assert (0 <= free)%Z as f0 by lia. destruct (Z.leb_spec (exponent b - exponent c) (62 + free)) as [close | far].
  - assert (0 < 2 ^ (exponent b - exponent c))%Z by (apply Z.pow_pos_nonneg; lia). apply rounded_holds; [nia |].
    rewrite !plus_IZR. apply minus_near; [| exact near'].
    replace (exponent c) with (exponent b - (exponent b - exponent c))%Z at 2 4 by lia. apply rescaled; [lia | exact near].
  - assert (0 < 2 ^ free)%Z by (apply Z.pow_pos_nonneg; lia). apply rounded_holds; [nia |].
    rewrite plus_IZR. rewrite <- (Rplus_0_r (IZR (middle b * 2 ^ free))). apply minus_near; [apply rescaled; assumption |].
    rewrite Rmult_0_l, Rminus_0_r. set (s := bpow radix2 (exponent b - free)) in *.
    assert (bpow radix2 (exponent c) <= bpow radix2 (-63) * s) as small by (unfold s; rewrite <- bpow_plus; apply bpow_le; lia).
    assert (Rabs y <= IZR (2 ^ 63 + 2) * bpow radix2 (exponent c)) as size.
    { replace y with ((y - IZR (middle c) * bpow radix2 (exponent c)) + IZR (middle c) * bpow radix2 (exponent c)) by ring.
      eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 (exponent c))), <- abs_IZR by apply bpow_ge_0.
      apply Rle_trans with (IZR (error c + Z.abs (middle c)) * bpow radix2 (exponent c)).
      - rewrite plus_IZR, Rmult_plus_distr_r. apply Rplus_le_compat_r. exact near'.
      - apply Rmult_le_compat_r; [apply bpow_ge_0 | apply IZR_le; lia]. }
    assert (0 < s) by apply bpow_gt_0. eapply Rle_trans; [exact size |].
    apply Rle_trans with (IZR (2 ^ 63 + 2) * (bpow radix2 (-63) * s)); [apply Rmult_le_compat_l; [apply IZR_le; lia | exact small] |].
    rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [lra |]. cbn. lra.
Qed.
Lemma zero_ball b x : is_zero_ball b = true -> in_ball b x -> x = 0.
Proof.
  unfold is_zero_ball. rewrite andb_true_iff, !Z.eqb_eq. intros [m k] (_ & near). rewrite m, k, !Rmult_0_l, Rminus_0_r in near.
  pose proof (Rabs_pos x). destruct (Req_dec x 0) as [| some]; [assumption |]. pose proof (Rabs_pos_lt x some). lra.
Qed.
Lemma plus_holds b c x y : in_ball b x -> in_ball c y -> in_ball (ball_plus b c) (x + y).
Proof.
  intros Hb Hc. unfold ball_plus. destruct (is_zero_ball b) eqn:zb; [rewrite (zero_ball b x zb Hb), Rplus_0_l; exact Hc |].
  destruct (is_zero_ball c) eqn:zc; [rewrite (zero_ball c y zc Hc), Rplus_0_r; exact Hb |].
  destruct (Z.leb_spec (exponent c) (exponent b)); [apply sum_holds; assumption |]. rewrite Rplus_comm. apply sum_holds; [lia | assumption | assumption].
Qed.
Lemma minus_holds b c x y : in_ball b x -> in_ball c y -> in_ball (ball_minus b c) (x - y).
Proof.
  intros Hb ((mc & kc) & near). apply plus_holds; [exact Hb |]. split; cbn [middle error exponent]; [lia |]. rewrite opp_IZR.
  replace (- y - - IZR (middle c) * bpow radix2 (exponent c)) with (- (y - IZR (middle c) * bpow radix2 (exponent c))) by ring.
  rewrite Rabs_Ropp. exact near.
Qed.
Lemma times_holds b c x y : in_ball b x -> in_ball c y -> in_ball (ball_times b c) (x * y).
Proof.
  intros ((mb & kb) & near) ((mc & kc) & near'). apply rounded_holds; [nia |]. rewrite bpow_plus.
  set (s := bpow radix2 (exponent b)) in *. set (t := bpow radix2 (exponent c)) in *.
  rewrite plus_IZR, !mult_IZR, plus_IZR, !abs_IZR. set (m := IZR (middle b)) in *. set (n := IZR (middle c)) in *.
  set (k := IZR (error b)) in *. set (l := IZR (error c)) in *. assert (0 < s) by apply bpow_gt_0. assert (0 < t) by apply bpow_gt_0.
  replace (x * y - m * n * (s * t)) with (m * s * (y - n * t) + (x - m * s) * (n * t + (y - n * t))) by ring.
  replace ((Rabs m * l + k * (Rabs n + l)) * (s * t)) with (Rabs m * s * (l * t) + (k * s) * (Rabs n * t + l * t)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite !Rabs_mult, (Rabs_pos_eq s) by lra.
  apply Rplus_le_compat; [apply Rmult_le_compat_l; [apply Rmult_le_pos; [apply Rabs_pos | lra] | exact near'] |].
  apply Rmult_le_compat; try apply Rabs_pos; [exact near |]. eapply Rle_trans; [apply Rabs_triang |].
  rewrite Rabs_mult, (Rabs_pos_eq t) by lra. apply Rplus_le_compat_l. exact near'.
Qed.
Lemma run_holds program : forall balls values, Forall2 in_ball balls values -> Forall2 in_ball (run_balls balls program) (run_R values program).
Proof.
  unfold run_balls, run_R. induction program as [| x rest IH]; intros balls values all; [exact all |]. cbn [run_program].
  apply IH, Forall2_app; [exact all |]. constructor; [| constructor].
  assert (forall i, in_ball (nth i balls (Ball 0 0 0)) (nth i values 0)) as each.
  { apply Forall2_nth; [| exact all]. split; cbn; [lia |]. rewrite !Rmult_0_l, Rminus_0_r, Rabs_R0. lra. }
  destruct x as [i j | i j | i j]; cbn [computed]; [apply plus_holds | apply minus_holds | apply times_holds]; apply each.
Qed.

(* The signs that are certain. *)
Definition ball_says (values : list ball) (x : asked) : bool :=
  let b i := nth i values (Ball 0 0 0) in
  match x with
  | Is_positive i => error (b i) <? middle (b i) | Is_negative i => middle (b i) <? - error (b i)
  | Is_at_least_zero i => error (b i) <=? middle (b i) | Is_at_most_zero i => middle (b i) <=? - error (b i)
  | _ => false
  end%Z.
(* What they tell of each axis: that it fails, its radius, its sides. *)
Definition axis_index (i : axis) : nat :=
  match i with axis_a => 0 | axis_b => 1 | axis_c => 2 | axis_plane => 3 | axis_ab => 4 | axis_bc => 5 | axis_ca => 6 end.
Definition told_of (says : asked -> bool) (group : nat) (i : axis) : bool :=
  answer_of says (nth group (nth (axis_index i) recorded_told []) (Answer false)).
Definition balls_tell (balls : list ball) : known :=
  let says := ball_says (run_balls balls exact_program) in Known (told_of says 0) (told_of says 1) (told_of says 2).

Definition value_place (K : comparison) : nat := nth (place_of K) recorded_exact_results 0%nat.
Section Told.
  Variable says : asked -> bool.
  Let positive K := says (Is_positive (value_place K)). Let negative K := says (Is_negative (value_place K)).
  Let at_least K := says (Is_at_least_zero (value_place K)). Let at_most K := says (Is_at_most_zero (value_place K)).
  Ltac by_cases := match goal with i : axis |- _ => destruct i end; cbv [told_of axis_index recorded_told nth value_place place_of
    recorded_exact_results answer_of positive negative at_least at_most radius_of]; repeat match goal with |- context [says ?x] => destruct (says x) end; (reflexivity || intros; congruence).
  Lemma told_fails i : told_of says 0 i = match i with
    | axis_a => negative vertex_a_radius || negative vertex_a_side_b || negative vertex_a_side_c
    | axis_b => negative vertex_b_radius || negative vertex_b_side_a || negative vertex_b_side_c
    | axis_c => negative vertex_c_radius || negative vertex_c_side_a || negative vertex_c_side_b
    | axis_plane => negative plane_radius
    | axis_ab => negative edge_ab_radius || positive edge_ab_side_c | axis_bc => negative edge_bc_radius || positive edge_bc_side_a
    | axis_ca => negative edge_ca_radius || positive edge_ca_side_b end.
  Proof using Type. by_cases. Qed.
  Lemma told_radius i : told_of says 1 i = true -> positive (radius_of i) = true.
  Proof using Type. by_cases. Qed.
  Lemma told_sides i : told_of says 2 i = true -> match i with
    | axis_a => at_least vertex_a_side_b && at_least vertex_a_side_c | axis_b => at_least vertex_b_side_a && at_least vertex_b_side_c
    | axis_c => at_least vertex_c_side_a && at_least vertex_c_side_b | axis_plane => true
    | axis_ab => at_most edge_ab_side_c | axis_bc => at_most edge_bc_side_a | axis_ca => at_most edge_ca_side_b end = true.
  Proof using Type. by_cases. Qed.
End Told.

(* The ball of a double. *)
Definition is_ball_of (b : ball) (x : R) : Prop :=
  error b = 0%Z /\ (Z.abs (middle b) < 2 ^ 53)%Z /\ x = IZR (middle b) * bpow radix2 (exponent b).
Lemma ball_of_holds b x : is_ball_of b x -> in_ball b x.
Proof. intros (none & small & ->). split; [lia |]. rewrite none, Rmult_0_l, Rminus_eq_0, Rabs_R0. lra. Qed.

Section Sound.
  Variable q : question.
  Variables (a b c p : vec) (r : R).
  Let query := [cx a; cy a; cz a; cx b; cy b; cz b; cx c; cy c; cz c; cx p; cy p; cz p; r].
  Variable balls : list ball.
  Hypothesis held : Forall2 in_ball balls query.
  Let A := sub a p. Let B := sub b p. Let C := sub c p.
  Notation holds := (holds_for q A B C (r * r)).
  Let says := ball_says (run_balls balls exact_program).

  Lemma value_is K : nth (value_place K) (run_R query exact_program) 0 = nth (place_of K) (real_margins a b c p r) 0.
  Proof using Type.
    rewrite <- recorded_margins. fold query. unfold exact_results. generalize (run_R query exact_program). intros values.
    destruct K; reflexivity.
  Qed.
  Lemma signs K : let x := nth (place_of K) (real_margins a b c p r) 0 in
    (says (Is_positive (value_place K)) = true -> 0 < x) /\ (says (Is_negative (value_place K)) = true -> x < 0) /\
    (says (Is_at_least_zero (value_place K)) = true -> 0 <= x) /\ (says (Is_at_most_zero (value_place K)) = true -> x <= 0).
  Proof using held.
    cbv zeta. rewrite <- value_is.
    assert (in_ball (nth (value_place K) (run_balls balls exact_program) (Ball 0 0 0)) (nth (value_place K) (run_R query exact_program) 0)) as there.
    { apply Forall2_nth; [| apply run_holds, held]. split; cbn; [lia |]. rewrite !Rmult_0_l, Rminus_0_r, Rabs_R0. lra. }
    unfold says, ball_says. set (ball_ := nth _ (run_balls _ _) _) in *. set (x := nth _ (run_R _ _) 0) in *. destruct there as (_ & near).
    apply Rabs_le_inv in near. pose proof (bpow_gt_0 radix2 (exponent ball_)) as s0. set (s := bpow radix2 (exponent ball_)) in *.
    rewrite !Z.ltb_lt, !Z.leb_le. split; [| split; [| split]]; intros less; first [apply IZR_lt in less | apply IZR_le in less];
      rewrite ?opp_IZR in less; nra.
  Qed.
  Lemma comparison_is K : let x := nth (place_of K) (real_margins a b c p r) 0 in let y := if is_edge_side K then - x else x in
    (0 < y -> holds K) /\ (y < 0 -> ~ holds K) /\ (is_side K = true -> 0 <= y -> holds K).
  Proof using Type.
    cbv zeta. pose proof (margins_are_reduced a b c p r K) as value. cbv zeta in value. fold A B C in value. rewrite value.
    pose proof (sign_decides q A B C (r * r) K (Rle_0_sqr r)) as (above & below & equal). set (s := reduced A B C (r * r) K) in *.
    assert (forall P : Prop, P -> P) as same by auto.
    destruct (is_edge_side K); (split; [intros; apply above; lra |]); (split; [intros; apply below; lra |]); intros side more;
      (destruct (Req_dec (fst s) (snd s)) as [tie | apart_]; [apply (equal tie); left; exact side | apply above; lra]).
  Qed.

  Theorem balls_tell_right : sound_known holds (balls_tell balls).
  Proof using held.
    assert (forall K, is_edge_side K = false -> (says (Is_positive (value_place K)) = true -> holds K) /\
      (says (Is_negative (value_place K)) = true -> ~ holds K) /\ (is_side K = true -> says (Is_at_least_zero (value_place K)) = true -> holds K)) as plain.
    { intros K no. destruct (signs K) as (? & ? & ? & _), (comparison_is K) as (? & ? & ?). rewrite no in *. auto. }
    assert (forall K, is_edge_side K = true -> (says (Is_positive (value_place K)) = true -> ~ holds K) /\
      (is_side K = true -> says (Is_at_most_zero (value_place K)) = true -> holds K)) as edge.
    { intros K yes. destruct (signs K) as (one & _ & _ & two), (comparison_is K) as (_ & below_ & least). rewrite yes in *.
      split; [intros s; apply below_; specialize (one s); lra | intros side s; apply (least side); specialize (two s); lra]. }
    intros i. cbn [balls_tell known_fails known_radius known_sides]. fold says. rewrite told_fails. unfold axis_holds.
    split; [| split].
    - destruct i; cbv beta zeta; rewrite ?orb_true_iff; cbn [radius_of sides_hold]; intros fails [one two];
        repeat (destruct fails as [fails | fails]);
        match type of fails with says (_ (value_place ?K)) = true =>
          first [apply (proj1 (proj2 (plain K eq_refl))) in fails | apply (proj1 (edge K eq_refl)) in fails] end; tauto.
    - intros told. apply told_radius in told. revert told. apply plain. destruct i; reflexivity.
    - intros told. apply told_sides in told. revert told. destruct i; rewrite ?andb_true_iff; cbn [sides_hold]; intros told; try exact I.
      1-3: destruct told; split; apply plain; first [reflexivity | assumption].
      all: apply edge; first [reflexivity | assumption].
  Qed.
End Sound.
