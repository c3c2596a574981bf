(* A radius so small that it decides nothing: the exact step of the certified predicate takes it as zero, and the open sphere
   as the closed one (negligible_radius in kernel/sphere_triangle/certified/exact_step.cpp). *)
From Coq Require Import ZArith List Lia Reals Bool Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Exact Reduced OpenSphere Known ExactProgram ExactStep.
Open Scope Z_scope.

Section Negligible.
  Variable n : Z.
  Hypothesis n1 : 1 <= n.
  Variables ax ay az bx by_ bz cx_ cy_ cz_ px py pz : Z.
  Let a := grid_point ax ay az. Let b := grid_point bx by_ bz. Let c := grid_point cx_ cy_ cz_. Let p := grid_point px py pz.
  Let A := sub a p. Let B := sub b p. Let C := sub c p.
  Hypothesis small : Forall (fun x => Z.abs x < 2 ^ (n - 1)) (ax :: ay :: az :: bx :: by_ :: bz :: cx_ :: cy_ :: cz_ :: px :: py :: pz :: nil).
  Variable r : R.
  Hypothesis r_small : (0 < r <= bpow radix2 (-2 * n - 2))%R.

  (* Differences, and the components of V. *)
  Definition edge_square (x y z : Z) := x * x + y * y + z * z.
  Lemma difference_small x y : Z.abs x < 2 ^ (n - 1) -> Z.abs y < 2 ^ (n - 1) -> Z.abs (x - y) < 2 ^ n.
  Proof using n1. intros. assert (2 ^ n = 2 * 2 ^ (n - 1)) by (rewrite <- Z.pow_succ_r by lia; f_equal; lia). lia. Qed.
  Lemma square_small H x y z : 0 < H -> Z.abs x < H -> Z.abs y < H -> Z.abs z < H -> 0 <= edge_square x y z < 4 * (H * H).
  Proof using Type. unfold edge_square. intros. split; nia. Qed.
  Lemma minor_small H x y z t : 0 < H -> Z.abs x < H -> Z.abs y < H -> Z.abs z < H -> Z.abs t < H -> Z.abs (x * y - z * t) < 2 * (H * H).
  Proof using Type. intros. nia. Qed.

  Lemma one_bound h : 0 < h -> 0 <= 1 < 4 * (h * h). Proof using Type. intros. nia. Qed.
  Lemma low_bound h m : 0 < h -> 0 <= m < 4 * (h * h) -> 0 <= m < 16 * (h * h * (h * h)).
  Proof using n1. intros. assert (1 <= h * h) by nia. assert (h * h <= h * h * (h * h)) by nia. lia. Qed.
  Lemma flat_bound h x y z : 0 < h -> Z.abs x < 2 * (h * h) -> Z.abs y < 2 * (h * h) -> Z.abs z < 2 * (h * h) ->
    0 <= edge_square x y z < 16 * (h * h * (h * h)).
  Proof using Type.
    intros h0 X Y Z. pose proof (square_small (2 * (h * h)) x y z ltac:(nia) X Y Z) as low.
    replace (4 * (2 * (h * h) * (2 * (h * h)))) with (16 * (h * h * (h * h))) in low by ring. exact low.
  Qed.

  (* The left side f and the factor m of the right side r^2 m, whole numbers, m below 2^(4 n + 4). *)
  Lemma sides_are_whole K : is_side K = false -> exists f m : Z, 0 <= m < 2 ^ (4 * n + 4) /\
    forall rr : R, reduced A B C rr K = (IZR f, (rr * IZR m)%R).
  Proof using a b c n1 p small.
    pose proof small as all. repeat (apply Forall_cons_iff in all as [? all]). clear all.
    assert (0 < 2 ^ n) as two_n by (apply Z.pow_pos_nonneg; lia).
    assert (2 ^ (4 * n + 4) = 16 * (2 ^ n * 2 ^ n * (2 ^ n * 2 ^ n))) as power.
    { replace (4 * n + 4) with (n + n + n + n + 4) by lia. rewrite !Z.pow_add_r by lia. change (2 ^ 4) with 16. ring. }
    assert (low : forall m, 0 <= m < 4 * (2 ^ n * 2 ^ n) -> 0 <= m < 2 ^ (4 * n + 4))
      by (intros m Hm; rewrite power; apply low_bound; assumption).
    assert (unit : 0 <= 1 < 2 ^ (4 * n + 4)) by (rewrite power; apply low_bound; [assumption |]; apply one_bound, two_n).
    assert (flat : forall x y z, Z.abs x < 2 * (2 ^ n * 2 ^ n) -> Z.abs y < 2 * (2 ^ n * 2 ^ n) -> Z.abs z < 2 * (2 ^ n * 2 ^ n) ->
      0 <= edge_square x y z < 2 ^ (4 * n + 4)).
    { intros x y z X Y Z. rewrite power. apply flat_bound; assumption. }
    pose proof difference_small as diff.
    destruct K; intros radius; try discriminate; cbn [reduced published];
      unfold plane_sides, vertex_radius_sides, reduced_radius_sides, offset, length2, A, B, C, a, b, c, p, normal, grid_point, sub, cross, dot;
      cbn [cx cy cz].
    - set (vx := (by_ - ay) * (cz_ - az) - (bz - az) * (cy_ - ay)). set (vy := (bz - az) * (cx_ - ax) - (bx - ax) * (cz_ - az)).
      set (vz := (bx - ax) * (cy_ - ay) - (by_ - ay) * (cx_ - ax)).
      exists (((ax - px) * vx + (ay - py) * vy + (az - pz) * vz) * ((ax - px) * vx + (ay - py) * vy + (az - pz) * vz)), (edge_square vx vy vz).
      split; [apply flat; apply minor_small; auto |].
      intros rr. unfold vx, vy, vz, edge_square. repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. f_equal; ring.
    - exists (edge_square (ax - px) (ay - py) (az - pz)), 1. split; [exact unit |].
      intros rr. unfold edge_square. repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. f_equal; ring.
    - exists (edge_square (bx - px) (by_ - py) (bz - pz)), 1. split; [exact unit |].
      intros rr. unfold edge_square. repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. f_equal; ring.
    - exists (edge_square (cx_ - px) (cy_ - py) (cz_ - pz)), 1. split; [exact unit |].
      intros rr. unfold edge_square. repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. f_equal; ring.
    - exists (edge_square ((ay - py) * (bz - pz) - (az - pz) * (by_ - py)) ((az - pz) * (bx - px) - (ax - px) * (bz - pz))
        ((ax - px) * (by_ - py) - (ay - py) * (bx - px))), (edge_square (bx - ax) (by_ - ay) (bz - az)).
      split; [apply low, square_small; auto |].
      intros rr. unfold edge_square. repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. f_equal; ring.
    - exists (edge_square ((by_ - py) * (cz_ - pz) - (bz - pz) * (cy_ - py)) ((bz - pz) * (cx_ - px) - (bx - px) * (cz_ - pz))
        ((bx - px) * (cy_ - py) - (by_ - py) * (cx_ - px))), (edge_square (cx_ - bx) (cy_ - by_) (cz_ - bz)).
      split; [apply low, square_small; auto |].
      intros rr. unfold edge_square. repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. f_equal; ring.
    - exists (edge_square ((cy_ - py) * (az - pz) - (cz_ - pz) * (ay - py)) ((cz_ - pz) * (ax - px) - (cx_ - px) * (az - pz))
        ((cx_ - px) * (ay - py) - (cy_ - py) * (ax - px))), (edge_square (ax - cx_) (ay - cy_) (az - cz_)).
      split; [apply low, square_small; auto |].
      intros rr. unfold edge_square. repeat rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR. f_equal; ring.
  Qed.

  Lemma product_below_one m : 0 <= m < 2 ^ (4 * n + 4) -> (0 <= r * r * IZR m < 1)%R.
  Proof using n1 r_small.
    intros [m0 below]. apply IZR_le in m0. apply IZR_lt in below. change 2 with (radix_val radix2) in below.
    rewrite IZR_Zpower in below by lia. destruct r_small as [r0 r1].
    assert (r * r <= bpow radix2 (-4 * n - 4))%R as square.
    { replace (-4 * n - 4) with ((-2 * n - 2) + (-2 * n - 2)) by lia. rewrite bpow_plus. apply Rmult_le_compat; lra. }
    pose proof (Rle_0_sqr r) as rr0. unfold Rsqr in rr0. pose proof (bpow_gt_0 radix2 (-4 * n - 4)).
    split; [apply Rmult_le_pos; assumption |].
    apply Rle_lt_trans with (bpow radix2 (-4 * n - 4) * IZR m)%R; [apply Rmult_le_compat_r; assumption |].
    apply Rlt_le_trans with (bpow radix2 (-4 * n - 4) * bpow radix2 (4 * n + 4))%R; [apply Rmult_lt_compat_l; assumption |].
    rewrite <- bpow_plus. replace (-4 * n - 4 + (4 * n + 4)) with 0 by lia. cbn. lra.
  Qed.

  Lemma holds_as_for_zero q K : holds_for q A B C (r * r) K <-> holds_for closed_sphere A B C (0 * 0) K.
  Proof using a b c n1 p r_small small.
    assert (has_normal A B C K -> True) by auto.
    destruct (sides_shape A B C K) as [(side & some & same) | (side & f & m & f0 & m0 & some & flat & same)].
    - unfold holds_for, nonstrict, open_holds, weak. rewrite (same (r * r)%R), (same (0 * 0)%R), side. destruct q; tauto.
    - destruct (sides_are_whole K side) as (f' & m' & bound & same'). pose proof (same 1%R) as one. rewrite (same' 1%R) in one.
      injection one as ff mm. rewrite !Rmult_1_l in mm. subst f m.
      pose proof (product_below_one m' bound) as product. destruct r_small as [r0 _].
      assert (forall z, (0 < IZR z)%R -> (1 <= IZR z)%R) as whole by (intros z H'; apply lt_IZR in H'; apply IZR_le; lia).
      pose proof (whole f') as f1. pose proof (Rle_lt_or_eq_dec 0 (IZR f') f0) as cases.
      unfold holds_for, nonstrict, open_holds, weak. rewrite side, (same (r * r)%R), (same (0 * 0)%R). cbn [fst snd].
      destruct q.
      + split; intros; destruct cases as [pos | zero]; try (specialize (f1 pos)); lra.
      + rewrite some. split.
        * intros [above normal]. destruct cases as [pos | zero]; [lra |]. exfalso.
          pose proof (Rmult_lt_0_compat (r * r) (IZR m') (Rmult_lt_0_compat _ _ r0 r0) normal). lra.
        * intros above. assert (0 < IZR f')%R as pos by lra. split; [specialize (f1 pos); lra |].
          destruct (Rle_lt_or_eq_dec 0 (IZR m') m0) as [| zero]; [assumption |]. rewrite (flat (eq_sym zero)) in pos. lra.
  Qed.

  Theorem negligible_radius q : apart q a b c p r <-> apart closed_sphere a b c p 0.
  Proof using All.
    rewrite <- (either_exact q a b c p r), <- (either_exact closed_sphere a b c p 0) by lra.
    split; apply some_axis_mono; intros K; apply holds_as_for_zero.
  Qed.
End Negligible.
