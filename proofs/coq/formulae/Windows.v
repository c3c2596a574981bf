(* The window of exponents of each comparison, in binary32 and binary64, plain and fused: the grid may be as fine as
   least_grid of its degree, the size as great as stated below. Inside it the kernel's sides are those of an unbounded
   exponent. One step beyond either end there are queries that over- or underflow (windows.jsonl). *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Expression Programs Caps Run Window.
From Axiscert Require Ranges.
Open Scope R_scope.

Definition prec_24 : Prec_gt_0 24 := eq_refl.
Definition prec_53 : Prec_gt_0 53 := eq_refl.
Definition emax_128 : Prec_lt_emax 24 128 := eq_refl.
Definition emax_1024 : Prec_lt_emax 53 1024 := eq_refl.

(* The least grids, by degree: 2^-24 for 6, 2^-37 for 4, 2^-74 for 2; in binary64 2^-179, 2^-268 and 2^-537. *)
Theorem least_grids :
  (least_grid 24 128 6, least_grid 24 128 4, least_grid 24 128 2) = (-24, -37, -74)%Z /\
  (least_grid 53 1024 6, least_grid 53 1024 4, least_grid 53 1024 2) = (-179, -268, -537)%Z.
Proof. split; reflexivity. Qed.

(* Sizes 2^h up to which everything stays finite. *)
Definition published_greatest32 (K : comparison) : Z :=
  match K with
  | plane_radius | edge_ab_radius | edge_bc_radius | edge_ca_radius => 20
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 20
  | _ => 63
  end.
Definition published_greatest64 (K : comparison) : Z :=
  match K with
  | plane_radius | edge_ab_radius | edge_bc_radius | edge_ca_radius => 169
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 169
  | _ => 511
  end.
Definition reduced_greatest32 (K : comparison) : Z :=
  match K with
  | edge_ab_radius | edge_bc_radius | edge_ca_radius => 31
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 30
  | _ => published_greatest32 K
  end.
Definition reduced_greatest64 (K : comparison) : Z :=
  match K with
  | edge_ab_radius | edge_bc_radius | edge_ca_radius => 255
  | edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 254
  | _ => published_greatest64 K
  end.

(* The published edge.side, Q.QC: by the sizes of its terms it is a sum of 480 m^6, and binary32 ends at 256 m^6 for
   2^20. But by the Cauchy-Schwarz inequality no part of the sum exceeds |Q| |QC|, which is at most 8 (12 sqrt 3 + 8)
   m^6. *)
Section Side.
  Variables a1 a2 a3 b1 b2 b3 c1 c2 c3 : R.
  Definition side_e := (b1 - a1) * (b1 - a1) + (b2 - a2) * (b2 - a2) + (b3 - a3) * (b3 - a3).
  Definition side_x := Ranges.Q a1 a2 a3 b1 b2 b3 * (c1 * side_e - Ranges.Q a1 a2 a3 b1 b2 b3).
  Definition side_y := Ranges.Q a2 a3 a1 b2 b3 b1 * (c2 * side_e - Ranges.Q a2 a3 a1 b2 b3 b1).
  Definition side_z := Ranges.Q a3 a1 a2 b3 b1 b2 * (c3 * side_e - Ranges.Q a3 a1 a2 b3 b1 b2).
End Side.

Lemma square_at_most x y : 0 <= y -> x * x <= y * y -> Rabs x <= y.
Proof. intros y0 H. apply Rsqr_le_abs_0 in H. rewrite (Rabs_pos_eq y y0) in H. exact H. Qed.

Lemma parts_at_most a1 a2 a3 b1 b2 b3 c1 c2 c3 :
  Ranges.unit a1 -> Ranges.unit a2 -> Ranges.unit a3 -> Ranges.unit b1 -> Ranges.unit b2 -> Ranges.unit b3 ->
  Ranges.unit c1 -> Ranges.unit c2 -> Ranges.unit c3 ->
  Rabs (side_x a1 a2 a3 b1 b2 b3 c1 + side_y a1 a2 a3 b1 b2 b3 c2) <= 231 /\
  Rabs (side_x a1 a2 a3 b1 b2 b3 c1 + side_y a1 a2 a3 b1 b2 b3 c2 + side_z a1 a2 a3 b1 b2 b3 c3) <= 231.
Proof.
  intros A1 A2 A3 B1 B2 B3 C1 C2 C3. pose proof (Ranges.Q_square _ _ _ _ _ _ A1 A2 A3 B1 B2 B3) as square.
  assert (0 <= side_e a1 a2 a3 b1 b2 b3 <= 12) as e12.
  { unfold side_e. assert (T : forall s t, Ranges.unit s -> Ranges.unit t -> 0 <= (t - s) * (t - s) <= 4) by (unfold Ranges.unit; intros; split; [apply Rle_0_sqr | nra]).
    pose proof (T a1 b1 A1 B1). pose proof (T a2 b2 A2 B2). pose proof (T a3 b3 A3 B3). lra. }
  assert (c1 * c1 + c2 * c2 + c3 * c3 <= 3) as c3_max.
  { assert (T : forall s, Ranges.unit s -> s * s <= 1) by (unfold Ranges.unit; intros; nra).
    pose proof (T c1 C1). pose proof (T c2 C2). pose proof (T c3 C3). lra. }
  unfold side_x, side_y, side_z. set (e := side_e a1 a2 a3 b1 b2 b3) in *. clearbody e.
  set (x := Ranges.Q a1 a2 a3 b1 b2 b3) in *. set (y := Ranges.Q a2 a3 a1 b2 b3 b1) in *. set (z := Ranges.Q a3 a1 a2 b3 b1 b2) in *.
  clearbody x y z. clear A1 A2 A3 B1 B2 B3 C1 C2 C3.
  assert (Rabs (c1 * x + c2 * y + c3 * z) <= 13.86) as mixed.
  { apply square_at_most; [lra |].
    assert ((c1 * x + c2 * y + c3 * z) * (c1 * x + c2 * y + c3 * z) <= (c1 * c1 + c2 * c2 + c3 * c3) * (x * x + y * y + z * z)) as cs.
    { pose proof (Rle_0_sqr (c1 * y - c2 * x)). pose proof (Rle_0_sqr (c2 * z - c3 * y)). pose proof (Rle_0_sqr (c3 * x - c1 * z)). unfold Rsqr in *. lra. }
    assert ((c1 * c1 + c2 * c2 + c3 * c3) * (x * x + y * y + z * z) <= 3 * 64).
    { pose proof (Rle_0_sqr c1). pose proof (Rle_0_sqr c2). pose proof (Rle_0_sqr c3). pose proof (Rle_0_sqr x). pose proof (Rle_0_sqr y).
      pose proof (Rle_0_sqr z). unfold Rsqr in *. apply Rmult_le_compat; lra. }
    lra. }
  set (p := c1 * e - x). set (q := c2 * e - y). set (r := c3 * e - z).
  assert (p * p + q * q + r * r <= 829) as far.
  { replace (p * p + q * q + r * r) with (e * e * (c1 * c1 + c2 * c2 + c3 * c3) - 2 * (e * (c1 * x + c2 * y + c3 * z)) + (x * x + y * y + z * z))
      by (unfold p, q, r; ring).
    assert (e * e <= 12 * 12) by (apply Rmult_le_compat; lra).
    assert (e * e * (c1 * c1 + c2 * c2 + c3 * c3) <= 12 * 12 * 3).
    { pose proof (Rle_0_sqr c1). pose proof (Rle_0_sqr c2). pose proof (Rle_0_sqr c3). unfold Rsqr in *. apply Rmult_le_compat; try lra. apply Rmult_le_pos; lra. }
    assert (Rabs (e * (c1 * x + c2 * y + c3 * z)) <= 12 * 13.86) as term.
    { rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [rewrite Rabs_pos_eq; lra | assumption]. }
    apply Rabs_le_inv in term. lra. }
  assert (product : forall s t, 0 <= s -> 0 <= t -> s <= 64 -> t <= 829 -> s * t <= 231 * 231).
  { intros. apply Rle_trans with (64 * 829); [apply Rmult_le_compat; assumption | lra]. }
  pose proof (Rle_0_sqr x). pose proof (Rle_0_sqr y). pose proof (Rle_0_sqr z). pose proof (Rle_0_sqr p). pose proof (Rle_0_sqr q). pose proof (Rle_0_sqr r).
  pose proof (Rle_0_sqr (x * q - y * p)). pose proof (Rle_0_sqr (y * r - z * q)). pose proof (Rle_0_sqr (z * p - x * r)). unfold Rsqr in *.
  split; (apply square_at_most; [lra |]).
  - apply Rle_trans with ((x * x + y * y) * (p * p + q * q)); [lra | apply product; lra].
  - apply Rle_trans with ((x * x + y * y + z * z) * (p * p + q * q + r * r)); [lra | apply product; lra].
Qed.

(* The same where the coordinates are at most m. *)
Lemma side_parts m a1 a2 a3 b1 b2 b3 c1 c2 c3 : 0 < m ->
  Rabs a1 <= m -> Rabs a2 <= m -> Rabs a3 <= m -> Rabs b1 <= m -> Rabs b2 <= m -> Rabs b3 <= m ->
  Rabs c1 <= m -> Rabs c2 <= m -> Rabs c3 <= m ->
  Rabs (side_x a1 a2 a3 b1 b2 b3 c1 + side_y a1 a2 a3 b1 b2 b3 c2) <= 231 * m ^ 6 /\
  Rabs (side_x a1 a2 a3 b1 b2 b3 c1 + side_y a1 a2 a3 b1 b2 b3 c2 + side_z a1 a2 a3 b1 b2 b3 c3) <= 231 * m ^ 6.
Proof.
  intros m0 A1 A2 A3 B1 B2 B3 C1 C2 C3.
  assert (scaled : forall t, Rabs t <= m -> Ranges.unit (t / m) /\ t = m * (t / m)).
  { intros t H. apply Rabs_le_inv in H. split; [| field; lra]. unfold Ranges.unit, Rdiv.
    assert (0 < / m) as i0 by (apply Rinv_0_lt_compat; assumption).
    pose proof (Rmult_le_compat_r (/ m) _ _ ltac:(lra) (proj1 H)) as low. pose proof (Rmult_le_compat_r (/ m) _ _ ltac:(lra) (proj2 H)) as high.
    rewrite Ropp_mult_distr_l_reverse in low. rewrite Rinv_r in low, high by lra. lra. }
  destruct (scaled _ A1) as [U1 E1], (scaled _ A2) as [U2 E2], (scaled _ A3) as [U3 E3], (scaled _ B1) as [U4 E4], (scaled _ B2) as [U5 E5],
    (scaled _ B3) as [U6 E6], (scaled _ C1) as [U7 E7], (scaled _ C2) as [U8 E8], (scaled _ C3) as [U9 E9].
  destruct (parts_at_most _ _ _ _ _ _ _ _ _ U1 U2 U3 U4 U5 U6 U7 U8 U9) as [two three].
  rewrite E1, E2, E3, E4, E5, E6, E7, E8, E9.
  set (x1 := a1 / m) in *. set (x2 := a2 / m) in *. set (x3 := a3 / m) in *. set (y1 := b1 / m) in *. set (y2 := b2 / m) in *.
  set (y3 := b3 / m) in *. set (z1 := c1 / m) in *. set (z2 := c2 / m) in *. set (z3 := c3 / m) in *.
  clearbody x1 x2 x3 y1 y2 y3 z1 z2 z3.
  assert (cube : forall s t v s' t' v', Ranges.Q (m * s) (m * t) (m * v) (m * s') (m * t') (m * v') = m ^ 3 * Ranges.Q s t v s' t' v')
    by (intros; unfold Ranges.Q; ring).
  assert (square : side_e (m * x1) (m * x2) (m * x3) (m * y1) (m * y2) (m * y3) = m ^ 2 * side_e x1 x2 x3 y1 y2 y3) by (unfold side_e; ring).
  assert (0 <= m ^ 6) as m6 by (apply pow_le; lra).
  unfold side_x, side_y, side_z in *. rewrite !cube, !square. split.
  - match type of two with Rabs ?e <= _ => match goal with |- Rabs ?g <= _ => replace g with (m ^ 6 * e) by ring end end.
    rewrite Rabs_mult, (Rabs_pos_eq _ m6). pose proof (Rmult_le_compat_l _ _ _ m6 two). lra.
  - match type of three with Rabs ?e <= _ => match goal with |- Rabs ?g <= _ => replace g with (m ^ 6 * e) by ring end end.
    rewrite Rabs_mult, (Rabs_pos_eq _ m6). pose proof (Rmult_le_compat_l _ _ _ m6 three). lra.
Qed.

(* The sides with these caps: the programs are the same, and their operations and values do not depend on caps. *)
Definition capped_sum (fused : bool) (v w : triple) :=
  if fused then Cap 231 (Fma (ez v) (ez w) (Cap 231 (Fma (ey v) (ey w) (Mul (ex v) (ex w)))))
  else Cap 231 (Add (Cap 231 (Add (Mul (ex v) (ex w)) (Mul (ey v) (ey w)))) (Mul (ez v) (ez w))).
Definition capped_side (fused : bool) (v w z : triple) (products : expression) :=
  let e := sum_of_products fused (minus w v) (minus w v) in
  (capped_sum fused (Q fused v w products) (minus (times z e) (Q fused v w products)), Zero 6).
Definition windowed_program (fused : bool) (K : comparison) : expression * expression :=
  match K with
  | edge_ab_side_c => capped_side fused A B C (sum_of_products fused A B)
  | edge_bc_side_a => capped_side fused B C A (sum_of_products fused B C)
  | edge_ca_side_b => capped_side fused C A B (sum_of_products fused A C)
  | _ => published_program fused K
  end.

Lemma windowed_as_published {prec emax} Hp He (floats : leaf -> binary_float prec emax) fused K :
  sides_as_unbounded Hp He floats (windowed_program fused K) -> sides_as_unbounded Hp He floats (published_program fused K).
Proof. destruct fused, K; exact (fun H => H). Qed.

Lemma windowed_caps x m fused K : 0 < m -> (forall l, Rabs (x l) <= m) ->
  caps_hold x m (fst (windowed_program fused K)) /\ caps_hold x m (snd (windowed_program fused K)).
Proof.
  intros m0 sizes. pose proof (published_caps x m (Rlt_le _ _ m0) sizes fused K) as published.
  assert (side : forall v w z a1 a2 a3 b1 b2 b3 c1 c2 c3 products,
    v = Triple (Leaf a1) (Leaf a2) (Leaf a3) -> w = Triple (Leaf b1) (Leaf b2) (Leaf b3) -> z = Triple (Leaf c1) (Leaf c2) (Leaf c3) ->
    exact x products = x a1 * x b1 + x a2 * x b2 + x a3 * x b3 -> degree products = 2%nat ->
    caps_hold x m (fst (edge_side_program fused v w z products)) -> caps_hold x m (fst (capped_side fused v w z products))).
  { intros v w z a1 a2 a3 b1 b2 b3 c1 c2 c3 products -> -> -> same two caps.
    destruct (side_parts m (x a1) (x a2) (x a3) (x b1) (x b2) (x b3) (x c1) (x c2) (x c3) m0) as [part whole]; try apply sizes.
    unfold side_x, side_y, side_z, side_e, Ranges.Q in part, whole.
    unfold capped_side, edge_side_program, capped_sum, sum_of_products in *. cbn [fst] in *. destruct fused; cbn in *;
      rewrite ?same, ?two in *; cbn [Nat.add] in *.
    - split; [by_lemma whole | ]. split; [tauto |]. split; [tauto |]. split; [by_lemma part |]. tauto.
    - split; [by_lemma whole | ]. split; [| tauto]. split; [by_lemma part |]. tauto. }
  split; [| destruct K; cbn [windowed_program capped_side snd caps_hold]; try exact I; apply published].
  destruct K; try apply published; cbn [windowed_program]; destruct published as [caps _]; cbn [published_program] in caps;
    (eapply side; [reflexivity | reflexivity | reflexivity | | | exact caps]); destruct fused; cbn; try reflexivity; ring.
Qed.

Lemma window_size prec emax (floats : leaf -> binary_float prec emax) g h : in_window g h floats ->
  forall l, Rabs (B2R (floats l)) <= bpow radix2 h.
Proof. intros inside l. apply (inside l). Qed.

Theorem published_window32 fused K floats :
  in_window (least_grid 24 128 (window_degree (published_program fused K))) (published_greatest32 K) floats ->
  sides_as_unbounded prec_24 emax_128 floats (published_program fused K).
Proof.
  intros inside. apply windowed_as_published. apply (checked_window 24 128 prec_24 emax_128 (published_greatest32 K)).
  - destruct fused, K; vm_compute; reflexivity.
  - apply windowed_caps; [apply bpow_gt_0 | exact (window_size _ _ _ _ _ inside)].
  - destruct fused, K; exact inside.
Qed.
Theorem published_window64 fused K floats :
  in_window (least_grid 53 1024 (window_degree (published_program fused K))) (published_greatest64 K) floats ->
  sides_as_unbounded prec_53 emax_1024 floats (published_program fused K).
Proof.
  intros inside. apply (checked_window 53 1024 prec_53 emax_1024 (published_greatest64 K));
    [destruct fused, K; vm_compute; reflexivity | | exact inside].
  apply published_caps; [apply bpow_ge_0 | exact (window_size _ _ _ _ _ inside)].
Qed.
Theorem reduced_window32 fused K floats :
  in_window (least_grid 24 128 (window_degree (reduced_program fused K))) (reduced_greatest32 K) floats ->
  sides_as_unbounded prec_24 emax_128 floats (reduced_program fused K).
Proof.
  intros inside. apply (checked_window 24 128 prec_24 emax_128 (reduced_greatest32 K));
    [destruct fused, K; vm_compute; reflexivity | | exact inside].
  apply reduced_caps; [apply bpow_ge_0 | exact (window_size _ _ _ _ _ inside)].
Qed.
Theorem reduced_window64 fused K floats :
  in_window (least_grid 53 1024 (window_degree (reduced_program fused K))) (reduced_greatest64 K) floats ->
  sides_as_unbounded prec_53 emax_1024 floats (reduced_program fused K).
Proof.
  intros inside. apply (checked_window 53 1024 prec_53 emax_1024 (reduced_greatest64 K));
    [destruct fused, K; vm_compute; reflexivity | | exact inside].
  apply reduced_caps; [apply bpow_ge_0 | exact (window_size _ _ _ _ _ inside)].
Qed.
