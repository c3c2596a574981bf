From Coq Require Import Reals Lra Psatz.
Open Scope R_scope.

(* The ranges that the Gappa scripts take as hypotheses: exact quantities of a triangle in a cube, and how much they
   change where every coordinate moves by at most h within it.

   A, B, C are (x1, y1, z1), (x2, y2, z2), (x3, y3, z3). The theorems are about first components and the edge AB; the
   others follow by renaming, and RangesClaimed.v, which write_proofs makes, states which theorem applies to each
   quantity of the program. *)

Definition unit (x : R) : Prop := -1 <= x <= 1.
Definition near (h x x' : R) : Prop := -h <= x' - x <= h.

(* A function that is affine in a variable is greatest at an end of the variable's interval; so is a convex square. *)
Lemma at_an_end : forall (f : R -> R) (M x : R),
  (forall t, 2 * f t = (f 1 + f (-1)) + (f 1 - f (-1)) * t) ->
  unit x -> f 1 <= M -> f (-1) <= M -> f x <= M.
Proof. unfold unit. intros f M x E H H1 H2. specialize (E x). nra. Qed.

Lemma convex_at_an_end : forall (f : R -> R) (M x : R),
  (forall t, 2 * f t = 2 * f 0 + (f 1 - f (-1)) * t + (f 1 + f (-1) - 2 * f 0) * (t * t)) ->
  0 <= f 1 + f (-1) - 2 * f 0 ->
  unit x -> f 1 <= M -> f (-1) <= M -> f x <= M.
Proof.
  unfold unit. intros f M x E P H H1 H2. specialize (E x).
  assert (x * x <= 1) by nra.
  assert ((f 1 + f (-1) - 2 * f 0) * (x * x) <= (f 1 + f (-1) - 2 * f 0) * 1) by (apply Rmult_le_compat_l; lra).
  nra.
Qed.

Ltac at_ends v :=
  match goal with
  | |- ?e <= ?M => match eval pattern v in e with ?f v => refine (at_an_end f M v _ _ _ _) end
  end; [intro; cbv beta; ring | assumption | cbv beta | cbv beta].

Lemma product : forall m n x y, 0 <= m -> 0 <= n -> -m <= x <= m -> -n <= y <= n -> -(m * n) <= x * y <= m * n.
Proof.
  intros m n x y Hm Hn Hx Hy. split; nra.
Qed.

(* x y where x moves by dx, |x| <= m, and y by dy, |y'| <= n. *)
Lemma product_change : forall m n x y x' y' dx dy,
  0 <= m -> 0 <= n -> 0 <= dx -> 0 <= dy ->
  -m <= x <= m -> -n <= y' <= n -> near dx x x' -> near dy y y' -> near (m * dy + n * dx) (x * y) (x' * y').
Proof.
  unfold near. intros m n x y x' y' dx dy Hm Hn Hdx Hdy Hx Hy Dx Dy.
  replace (x' * y' - x * y) with (x * (y' - y) + (x' - x) * y') by ring.
  pose proof (product m dy x (y' - y) Hm Hdy Hx Dy). pose proof (product dx n (x' - x) y' Hdx Hn Dx Hy). lra.
Qed.

(* N = A x B *)
Lemma N_range : forall y1 z1 y2 z2, unit y1 -> unit z1 -> unit y2 -> unit z2 -> -2 <= y1 * z2 - z1 * y2 <= 2.
Proof.
  unfold unit. intros.
  pose proof (product 1 1 y1 z2). pose proof (product 1 1 z1 y2). lra.
Qed.

Lemma N_change : forall h y1 z1 y2 z2 y1' z1' y2' z2', 0 <= h ->
  unit y1 -> unit z1 -> unit y2 -> unit z2 -> unit y1' -> unit z1' -> unit y2' -> unit z2' ->
  near h y1 y1' -> near h z1 z1' -> near h y2 y2' -> near h z2 z2' ->
  near (4 * h) (y1 * z2 - z1 * y2) (y1' * z2' - z1' * y2').
Proof.
  unfold unit. intros.
  assert (near (2 * h) (y1 * z2) (y1' * z2')) by (replace (2 * h) with (1 * h + 1 * h) by ring; apply product_change; assumption || lra).
  assert (near (2 * h) (z1 * y2) (z1' * y2')) by (replace (2 * h) with (1 * h + 1 * h) by ring; apply product_change; assumption || lra).
  unfold near in *. lra.
Qed.

(* V = (B - A) x (C - A): affine in each coordinate, so greatest at vertices of the cube. *)
Lemma V_range : forall y1 z1 y2 z2 y3 z3, unit y1 -> unit z1 -> unit y2 -> unit z2 -> unit y3 -> unit z3 ->
  -4 <= (y2 - y1) * (z3 - z1) - (z2 - z1) * (y3 - y1) <= 4.
Proof.
  intros. split.
  - enough (- ((y2 - y1) * (z3 - z1) - (z2 - z1) * (y3 - y1)) <= 4) by lra.
    at_ends y1; at_ends z1; at_ends y2; at_ends z2; at_ends y3; at_ends z3; lra.
  - at_ends y1; at_ends z1; at_ends y2; at_ends z2; at_ends y3; at_ends z3; lra.
Qed.

Lemma V_change : forall h y1 z1 y2 z2 y3 z3 y1' z1' y2' z2' y3' z3', 0 <= h ->
  unit y1 -> unit z1 -> unit y2 -> unit z2 -> unit y3 -> unit z3 ->
  unit y1' -> unit z1' -> unit y2' -> unit z2' -> unit y3' -> unit z3' ->
  near h y1 y1' -> near h z1 z1' -> near h y2 y2' -> near h z2 z2' -> near h y3 y3' -> near h z3 z3' ->
  near (12 * h) ((y2 - y1) * (z3 - z1) - (z2 - z1) * (y3 - y1))
    ((y2' - y1') * (z3' - z1') - (z2' - z1') * (y3' - y1')).
Proof.
  intros.
  assert (P := N_change h y1 z1 y2 z2 y1' z1' y2' z2'). assert (Q := N_change h y2 z2 y3 z3 y2' z2' y3' z3').
  assert (S := N_change h y3 z3 y1 z1 y3' z3' y1' z1'). unfold near in *.
  destruct P; try assumption. destruct Q; try assumption. destruct S; try assumption. split; lra.
Qed.

(* det(A, B, C), affine in each coordinate *)
Lemma det_at_most : forall x1 y1 z1 x2 y2 z2 x3 y3 z3,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 -> unit x3 -> unit y3 -> unit z3 ->
  x1 * (y2 * z3 - z2 * y3) + y1 * (z2 * x3 - x2 * z3) + z1 * (x2 * y3 - y2 * x3) <= 4.
Proof.
  intros. at_ends x1; at_ends y1; at_ends z1; at_ends x2; at_ends y2; at_ends z2; at_ends x3; at_ends y3; at_ends z3; lra.
Qed.

Lemma opposite_unit : forall x, unit x -> unit (- x).
Proof. unfold unit. intros. lra. Qed.

Lemma d_range : forall x1 y1 z1 x2 y2 z2 x3 y3 z3,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 -> unit x3 -> unit y3 -> unit z3 ->
  -4 <= x1 * (y2 * z3 - z2 * y3) + y1 * (z2 * x3 - x2 * z3) + z1 * (x2 * y3 - y2 * x3) <= 4.
Proof.
  intros. pose proof (det_at_most x1 y1 z1 x2 y2 z2 x3 y3 z3).
  pose proof (det_at_most (-x1) (-y1) (-z1) x2 y2 z2 x3 y3 z3).
  pose proof (opposite_unit x1). pose proof (opposite_unit y1). pose proof (opposite_unit z1).
  split; [| tauto]. assert (L : - x1 * (y2 * z3 - z2 * y3) + - y1 * (z2 * x3 - x2 * z3) + - z1 * (x2 * y3 - y2 * x3) <= 4) by tauto.
  lra.
Qed.

(* The components of a cross product multiplied by signs form a determinant. *)
Lemma N_sum : forall x1 y1 z1 x2 y2 z2,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 ->
  Rabs (y1 * z2 - z1 * y2) + Rabs (z1 * x2 - x1 * z2) + Rabs (x1 * y2 - y1 * x2) <= 400 / 100.
Proof.
  intros. assert (P : unit 1) by (unfold unit; lra). assert (M : unit (-1)) by (unfold unit; lra).
  unfold Rabs. destruct (Rcase_abs (y1 * z2 - z1 * y2)), (Rcase_abs (z1 * x2 - x1 * z2)), (Rcase_abs (x1 * y2 - y1 * x2));
  [ pose proof (det_at_most (-1) (-1) (-1) x1 y1 z1 x2 y2 z2) | pose proof (det_at_most (-1) (-1) 1 x1 y1 z1 x2 y2 z2)
  | pose proof (det_at_most (-1) 1 (-1) x1 y1 z1 x2 y2 z2) | pose proof (det_at_most (-1) 1 1 x1 y1 z1 x2 y2 z2)
  | pose proof (det_at_most 1 (-1) (-1) x1 y1 z1 x2 y2 z2) | pose proof (det_at_most 1 (-1) 1 x1 y1 z1 x2 y2 z2)
  | pose proof (det_at_most 1 1 (-1) x1 y1 z1 x2 y2 z2) | pose proof (det_at_most 1 1 1 x1 y1 z1 x2 y2 z2) ]; unfold unit in *; lra.
Qed.

Lemma d_change : forall h x1 y1 z1 x2 y2 z2 x3 y3 z3 x1' y1' z1' x2' y2' z2' x3' y3' z3', 0 <= h ->
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 -> unit x3 -> unit y3 -> unit z3 ->
  unit x1' -> unit y1' -> unit z1' -> unit x2' -> unit y2' -> unit z2' -> unit x3' -> unit y3' -> unit z3' ->
  near h x1 x1' -> near h y1 y1' -> near h z1 z1' -> near h x2 x2' -> near h y2 y2' -> near h z2 z2' ->
  near h x3 x3' -> near h y3 y3' -> near h z3 z3' ->
  near (18 * h) (x1 * (y2 * z3 - z2 * y3) + y1 * (z2 * x3 - x2 * z3) + z1 * (x2 * y3 - y2 * x3))
    (x1' * (y2' * z3' - z2' * y3') + y1' * (z2' * x3' - x2' * z3') + z1' * (x2' * y3' - y2' * x3')).
Proof.
  intros. assert (T : forall x y z y' z' x', unit x -> unit y -> unit z -> unit x' -> unit y' -> unit z' ->
    near h x x' -> near h y y' -> near h z z' -> near (3 * h) (x * (y * z)) (x' * (y' * z'))).
  { unfold unit. intros.
    assert (near (2 * h) (y * z) (y' * z')) by (replace (2 * h) with (1 * h + 1 * h) by ring; apply product_change; assumption || lra).
    replace (3 * h) with (1 * (2 * h) + 1 * h) by ring. pose proof (product 1 1 y' z').
    apply product_change; assumption || lra. }
  assert (T1 := T x1 y2 z3 y2' z3' x1'). assert (T2 := T x1 z2 y3 z2' y3' x1').
  assert (T3 := T y1 z2 x3 z2' x3' y1'). assert (T4 := T y1 x2 z3 x2' z3' y1').
  assert (T5 := T z1 x2 y3 x2' y3' z1'). assert (T6 := T z1 y2 x3 y2' x3' z1').
  clear T. unfold near in *.
  destruct T1; try assumption. destruct T2; try assumption. destruct T3; try assumption.
  destruct T4; try assumption. destruct T5; try assumption. destruct T6; try assumption. split; lra.
Qed.

(* A.B - A.A, by coordinates *)
Lemma d1_range : forall x1 y1 z1 x2 y2 z2,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 ->
  -6 <= (x1 * x2 + y1 * y2 + z1 * z2) - (x1 * x1 + y1 * y1 + z1 * z1) <= 3 / 4.
Proof.
  assert (T : forall s t, unit s -> unit t -> -2 <= s * t - s * s <= 1 / 4).
  { unfold unit. intros. split; [nra |]. assert (0 <= (s - t / 2) * (s - t / 2)) by apply Rle_0_sqr. nra. }
  intros. pose proof (T x1 x2). pose proof (T y1 y2). pose proof (T z1 z2). unfold unit in *; lra.
Qed.

(* Q = A |AB|^2 - AB (AB.A) = AB x (A x B), the foot of the origin on the line AB, scaled. *)
Definition Q x1 y1 z1 x2 y2 z2 : R :=
  x1 * ((x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1) + (z2 - z1) * (z2 - z1)) -
  (x2 - x1) * ((x1 * x2 + y1 * y2 + z1 * z2) - (x1 * x1 + y1 * y1 + z1 * z1)).

Lemma Q_cross : forall x1 y1 z1 x2 y2 z2,
  Q x1 y1 z1 x2 y2 z2 = (y2 - y1) * (x1 * y2 - y1 * x2) - (z2 - z1) * (z1 * x2 - x1 * z2).
Proof. unfold Q. intros. ring. Qed.

Lemma Q_range : forall x1 y1 z1 x2 y2 z2,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 -> -8 <= Q x1 y1 z1 x2 y2 z2 <= 8.
Proof.
  intros. rewrite Q_cross.
  pose proof (N_range x1 y1 x2 y2). pose proof (N_range z1 x1 z2 x2).
  assert (-2 <= y2 - y1 <= 2) by (unfold unit in *; lra). assert (-2 <= z2 - z1 <= 2) by (unfold unit in *; lra).
  pose proof (product 2 2 (y2 - y1) (x1 * y2 - y1 * x2)). pose proof (product 2 2 (z2 - z1) (z1 * x2 - x1 * z2)).
  unfold unit in *; lra.
Qed.

Lemma Q_change : forall h x1 y1 z1 x2 y2 z2 x1' y1' z1' x2' y2' z2', 0 <= h ->
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 ->
  unit x1' -> unit y1' -> unit z1' -> unit x2' -> unit y2' -> unit z2' ->
  near h x1 x1' -> near h y1 y1' -> near h z1 z1' -> near h x2 x2' -> near h y2 y2' -> near h z2 z2' ->
  near (24 * h) (Q x1 y1 z1 x2 y2 z2) (Q x1' y1' z1' x2' y2' z2').
Proof.
  intros. rewrite !Q_cross.
  assert (NZ := N_change h x1 y1 x2 y2 x1' y1' x2' y2'). assert (NY := N_change h z1 x1 z2 x2 z1' x1' z2' x2').
  assert (RZ := N_range x1' y1' x2' y2'). assert (RY := N_range z1' x1' z2' x2').
  assert (P1 : near (12 * h) ((y2 - y1) * (x1 * y2 - y1 * x2)) ((y2' - y1') * (x1' * y2' - y1' * x2'))).
  { replace (12 * h) with (2 * (4 * h) + 2 * (2 * h)) by ring.
    apply product_change; try lra; try tauto; unfold unit, near in *; lra. }
  assert (P2 : near (12 * h) ((z2 - z1) * (z1 * x2 - x1 * z2)) ((z2' - z1') * (z1' * x2' - x1' * z2'))).
  { replace (12 * h) with (2 * (4 * h) + 2 * (2 * h)) by ring.
    apply product_change; try lra; try tauto; unfold unit, near in *; lra. }
  unfold near in *. lra.
Qed.

(* Q.Q = |AB|^2 |A x B|^2 = (p + q - 2 s) (p q - s^2), with p = A.A <= 3, q = B.B <= 3, s = A.B; increasing in p and q;
   at 3 and 3 it is 64 - 2 (s + 1)^2 (5 - s). *)
Lemma foot_at_most : forall p q s, 0 <= p <= 3 -> 0 <= q <= 3 -> s * s <= p * q -> 0 <= p + q - 2 * s ->
  (p + q - 2 * s) * (p * q - s * s) <= 64.
Proof.
  intros p q s Hp Hq Hs He.
  assert (S9 : s * s <= 9) by nra. assert (S3 : -3 <= s <= 3) by nra.
  assert (A1 : (p + q - 2 * s) * (p * q - s * s) <= (3 + q - 2 * s) * (3 * q - s * s)).
  { apply Rmult_le_compat; try lra; nra. }
  assert (E2 : 0 <= 3 + q - 2 * s) by lra.
  assert (A2 : (3 + q - 2 * s) * (3 * q - s * s) <= (3 + 3 - 2 * s) * (3 * 3 - s * s)).
  { apply Rmult_le_compat; try lra; nra. }
  assert (A3 : 0 <= (s + 1) * (s + 1) * (5 - s)) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
  nra.
Qed.

Lemma Q_square : forall x1 y1 z1 x2 y2 z2,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 ->
  Q x1 y1 z1 x2 y2 z2 * Q x1 y1 z1 x2 y2 z2 + Q y1 z1 x1 y2 z2 x2 * Q y1 z1 x1 y2 z2 x2 +
  Q z1 x1 y1 z2 x2 y2 * Q z1 x1 y1 z2 x2 y2 <= 64.
Proof.
  intros. set (p := x1 * x1 + y1 * y1 + z1 * z1). set (q := x2 * x2 + y2 * y2 + z2 * z2).
  set (s := x1 * x2 + y1 * y2 + z1 * z2).
  replace (_ + _ + _) with ((p + q - 2 * s) * (p * q - s * s)) by (unfold Q, p, q, s; ring).
  assert (T : forall t, unit t -> 0 <= t * t <= 1) by (unfold unit; intros; nra).
  pose proof (T x1). pose proof (T y1). pose proof (T z1). pose proof (T x2). pose proof (T y2). pose proof (T z2).
  apply foot_at_most.
  - unfold p, unit in *. lra.
  - unfold q, unit in *. lra.
  - assert (L : 0 <= (y1 * z2 - z1 * y2) * (y1 * z2 - z1 * y2) + (z1 * x2 - x1 * z2) * (z1 * x2 - x1 * z2) +
      (x1 * y2 - y1 * x2) * (x1 * y2 - y1 * x2)).
    { pose proof (Rle_0_sqr (y1 * z2 - z1 * y2)). pose proof (Rle_0_sqr (z1 * x2 - x1 * z2)).
      pose proof (Rle_0_sqr (x1 * y2 - y1 * x2)). unfold Rsqr in *. lra. }
    unfold p, q, s. lra.
  - pose proof (Rle_0_sqr (x2 - x1)). pose proof (Rle_0_sqr (y2 - y1)). pose proof (Rle_0_sqr (z2 - z1)).
    unfold Rsqr, p, q, s in *. lra.
Qed.

Lemma sum_of_square : forall x y z, x * x + y * y + z * z <= 64 -> Rabs x + Rabs y + Rabs z <= 1386 / 100.
Proof.
  intros x y z H. assert (T : forall t, Rabs t * Rabs t = t * t).
  { intro t. rewrite <- Rabs_mult. apply Rabs_pos_eq. apply Rle_0_sqr. }
  pose proof (T x). pose proof (T y). pose proof (T z).
  pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (Rabs_pos z).
  set (u := Rabs x) in *. set (v := Rabs y) in *. set (w := Rabs z) in *.
  assert ((u + v + w) * (u + v + w) <= 192).
  { pose proof (Rle_0_sqr (u - v)). pose proof (Rle_0_sqr (v - w)). pose proof (Rle_0_sqr (w - u)). unfold Rsqr in *. lra. }
  apply Rsqr_incr_0_var; [unfold Rsqr; lra | lra].
Qed.

Lemma Q_sum : forall x1 y1 z1 x2 y2 z2,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 ->
  Rabs (Q x1 y1 z1 x2 y2 z2) + Rabs (Q y1 z1 x1 y2 z2 x2) + Rabs (Q z1 x1 y1 z2 x2 y2) <= 1386 / 100.
Proof. intros. apply sum_of_square. apply Q_square; assumption. Qed.

(* Hoelder's inequality, which is the `cut` of a script. *)
Lemma hoelder : forall D S x y z dx dy dz, 0 <= D -> Rabs x + Rabs y + Rabs z <= S ->
  Rabs dx <= D -> Rabs dy <= D -> Rabs dz <= D -> Rabs (x * dx + y * dy + z * dz) <= S * D.
Proof.
  intros. assert (T : forall s t, Rabs t <= D -> Rabs (s * t) <= Rabs s * D).
  { intros. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | assumption]. }
  pose proof (T x dx). pose proof (T y dy). pose proof (T z dz).
  pose proof (Rabs_triang (x * dx + y * dy) (z * dz)). pose proof (Rabs_triang (x * dx) (y * dy)).
  assert ((Rabs x + Rabs y + Rabs z) * D <= S * D) by (apply Rmult_le_compat_r; assumption).
  lra.
Qed.

Ltac convex v :=
  match goal with
  | |- ?e <= ?M => match eval pattern v in e with ?f v => refine (convex_at_an_end f M v _ _ _ _ _) end
  end; [intro; cbv beta; ring | cbv beta | assumption | cbv beta | cbv beta].

(* C |AB|^2 - Q. *)
Definition QC x1 y1 z1 x2 y2 z2 x3 : R :=
  x3 * ((x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1) + (z2 - z1) * (z2 - z1)) - Q x1 y1 z1 x2 y2 z2.

(* With C's coordinate at 1, the part of QC from another coordinate is convex in both its variables. *)
Lemma QC_part : forall x1 x2 s t, unit x1 -> unit x2 -> unit s -> unit t ->
  -4 <= (1 - x1) * ((t - s) * (t - s)) + (x2 - x1) * ((t - s) * s) <= 2 * (2 - x1 - x2).
Proof.
  intros x1 x2 s t H1 H2 Us Ut. assert (B1 := H1). assert (B2 := H2). assert (B3 := Us). assert (B4 := Ut).
  unfold unit in B1, B2, B3, B4.
  split.
  - assert (A : -2 <= (t - s) * s <= 2).
    { split; [nra |]. assert (0 <= (s - t / 2) * (s - t / 2)) by apply Rle_0_sqr. nra. }
    assert (0 <= (t - s) * (t - s)) by apply Rle_0_sqr.
    assert (0 <= (1 - x1) * ((t - s) * (t - s))) by (apply Rmult_le_pos; lra).
    pose proof (product 2 2 (x2 - x1) ((t - s) * s)). lra.
  - convex s; [lra | convex t; lra | convex t; lra].
Qed.

Lemma QC_at_1 : forall x1 y1 z1 x2 y2 z2,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 -> -16 <= QC x1 y1 z1 x2 y2 z2 1 <= 16.
Proof.
  intros x1 y1 z1 x2 y2 z2 H1 H2 H3 H4 H5 H6.
  destruct (QC_part x1 x2 y1 y2 H1 H4 H2 H5) as [L1 U1]. destruct (QC_part x1 x2 z1 z2 H1 H4 H3 H6) as [L2 U2].
  assert (E : QC x1 y1 z1 x2 y2 z2 1 = (x2 - x1) * (x2 - x1) +
    ((1 - x1) * ((y2 - y1) * (y2 - y1)) + (x2 - x1) * ((y2 - y1) * y1)) +
    ((1 - x1) * ((z2 - z1) * (z2 - z1)) + (x2 - x1) * ((z2 - z1) * z1))) by (unfold QC, Q; ring).
  rewrite E. pose proof (Rle_0_sqr (x2 - x1)) as S. unfold Rsqr in S.
  assert ((x2 - x1) * (x2 - x1) + 4 * (2 - x1 - x2) <= 16) by (convex x1; [lra | convex x2; lra | convex x2; lra]).
  split; lra.
Qed.

Lemma QC_range : forall x1 y1 z1 x2 y2 z2 x3,
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 -> unit x3 -> -16 <= QC x1 y1 z1 x2 y2 z2 x3 <= 16.
Proof.
  assert (P : forall x1 y1 z1 x2 y2 z2 x3, unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 ->
    unit x3 -> QC x1 y1 z1 x2 y2 z2 x3 <= 16).
  { intros x1 y1 z1 x2 y2 z2 x3 H1 H2 H3 H4 H5 H6 H7.
    apply (at_an_end (fun t => QC x1 y1 z1 x2 y2 z2 t) 16 x3); [intro; unfold QC; ring | assumption | |].
    - apply QC_at_1; assumption.
    - replace (QC x1 y1 z1 x2 y2 z2 (-1)) with (- QC (-x1) (-y1) (-z1) (-x2) (-y2) (-z2) 1) by (unfold QC, Q; ring).
      assert (L := QC_at_1 (-x1) (-y1) (-z1) (-x2) (-y2) (-z2)).
      destruct L; try (apply opposite_unit; assumption). lra. }
  intros. split; [| apply P; assumption].
  assert (E : QC (-x1) (-y1) (-z1) (-x2) (-y2) (-z2) (-x3) = - QC x1 y1 z1 x2 y2 z2 x3) by (unfold QC, Q; ring).
  assert (L : QC (-x1) (-y1) (-z1) (-x2) (-y2) (-z2) (-x3) <= 16) by (apply P; apply opposite_unit; assumption).
  lra.
Qed.

Lemma QC_change : forall h x1 y1 z1 x2 y2 z2 x3 x1' y1' z1' x2' y2' z2' x3', 0 <= h ->
  unit x1 -> unit y1 -> unit z1 -> unit x2 -> unit y2 -> unit z2 -> unit x3 ->
  unit x1' -> unit y1' -> unit z1' -> unit x2' -> unit y2' -> unit z2' -> unit x3' ->
  near h x1 x1' -> near h y1 y1' -> near h z1 z1' -> near h x2 x2' -> near h y2 y2' -> near h z2 z2' -> near h x3 x3' ->
  near (60 * h) (QC x1 y1 z1 x2 y2 z2 x3) (QC x1' y1' z1' x2' y2' z2' x3').
Proof.
  intros. assert (D := Q_change h x1 y1 z1 x2 y2 z2 x1' y1' z1' x2' y2' z2').
  assert (S : forall s t s' t', unit s -> unit t -> unit s' -> unit t' -> near h s s' -> near h t t' ->
    near (8 * h) ((t - s) * (t - s)) ((t' - s') * (t' - s')) /\ 0 <= (t' - s') * (t' - s') <= 4).
  { unfold unit. intros. split.
    - replace (8 * h) with (2 * (2 * h) + 2 * (2 * h)) by ring. apply product_change; unfold near in *; lra.
    - split; [apply Rle_0_sqr | nra]. }
  destruct (S x1 x2 x1' x2') as [S1 B1]; try assumption. destruct (S y1 y2 y1' y2') as [S2 B2]; try assumption.
  destruct (S z1 z2 z1' z2') as [S3 B3]; try assumption. clear S.
  unfold QC. set (e := (x2 - x1) * (x2 - x1) + _ + _). set (e' := (x2' - x1') * (x2' - x1') + _ + _).
  assert (E : near (24 * h) e e') by (unfold near, e, e' in *; lra).
  assert (P : near (36 * h) (x3 * e) (x3' * e')).
  { replace (36 * h) with (1 * (24 * h) + 12 * h) by ring. apply product_change; try assumption; try lra; unfold unit, e' in *; lra. }
  assert (N : near (24 * h) (Q x1 y1 z1 x2 y2 z2) (Q x1' y1' z1' x2' y2' z2')) by (apply D; assumption).
  unfold near in *. lra.
Qed.
