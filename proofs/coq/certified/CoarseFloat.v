(* The certified predicate's coarse step over IEEE-754 numbers, to the bit: where S, as computed, is in its range,
   nothing overflows, so that the step is the program of CertifiedStep.v, and its answers are right, whatever the
   thirteen numbers are. *)
From Coq Require Import Reals ZArith Bool List Lra Lia Psatz.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Expression Format Run Filter Certified CertifiedStep Sizes.
Open Scope R_scope.

Section Float.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Notation emin := (3 - emax - prec)%Z.
  Notation nearest := (nearest prec emax).
  Notation real_vec := (real_vec prec emax).
  Variable fused : bool.
  Notation float_sub := (float_sub prec emax _ _).
  Notation float_dot := (float_dot prec emax _ _ fused).
  Notation float_minus_product := (float_minus_product prec emax _ _ fused).
  Notation float_cross := (float_cross prec emax _ _ fused).
  Notation constant := (constant prec emax _ _).

  (* The program. *)
  Variables least half : Z.  (* S from 2^least to 2^(2 half) *)
  Variables (a b c p : float_vec) (r : float).
  Let square v := float_dot v v.
  Let aa := square (float_sub a p).
  Let bb := square (float_sub b p).
  Let cc := square (float_sub c p).
  Let rr := Bmult mode_NE r r.
  Let e1 := square (float_sub b a).
  Let e2 := square (float_sub c b).
  Let e3 := square (float_sub a c).
  Definition float_S := Bplus mode_NE (Bplus mode_NE (Bplus mode_NE aa bb) cc) rr.
  Definition float_E := Bplus mode_NE (Bplus mode_NE (Bplus mode_NE e1 e2) e3) (Bmult mode_NE (constant 1 (-20)) float_S).
  Definition float_threshold (K : comparison) : float :=
    let SE := Bmult mode_NE float_S float_E in
    match K with
    | plane_radius => Bmult mode_NE (constant 187 (-5 - prec)) (Bmult mode_NE SE float_E)
    | edge_ab_radius | edge_ab_side_c | edge_bc_radius | edge_bc_side_a | edge_ca_radius | edge_ca_side_b =>
      Bmult mode_NE (constant 357 (-5 - prec)) SE
    | _ => Bmult mode_NE (constant 323 (-4 - prec)) float_S
    end.
  Let V := float_cross (float_sub a c) (float_sub b a).
  Let normal_of (from to : float_vec) := float_cross (float_sub from p) (float_sub to from).
  Let edge_radius_of (from to : float_vec) (e : float) := float_minus_product (square (normal_of from to)) rr e.
  Let edge_side_of (from to : float_vec) := Bopp (float_dot (normal_of from to) V).
  Let less := Bminus (prec := prec) (emax := emax) mode_NE.
  Definition float_margin (K : comparison) : float :=
    match K with
    | plane_radius => let D := float_dot (float_sub a p) V in float_minus_product (Bmult mode_NE D D) rr (square V)
    | vertex_a_radius => less aa rr
    | vertex_a_side_b => less (less bb aa) e1
    | vertex_a_side_c => less (less cc aa) e3
    | vertex_b_radius => less bb rr
    | vertex_b_side_a => less (Bopp (less bb aa)) e1
    | vertex_b_side_c => less (less cc bb) e2
    | vertex_c_radius => less cc rr
    | vertex_c_side_a => less (Bopp (less cc aa)) e3
    | vertex_c_side_b => less (Bopp (less cc bb)) e2
    | edge_ab_radius => edge_radius_of a b e1
    | edge_ab_side_c => edge_side_of a b
    | edge_bc_radius => edge_radius_of b c e2
    | edge_bc_side_a => edge_side_of b c
    | edge_ca_radius => edge_radius_of c a e3
    | edge_ca_side_b => edge_side_of c a
    end.
  Definition float_in_range : bool :=
    Bleb (constant 1 least) float_S && Bleb float_S (constant 1 (2 * half)) && Bleb (B754_zero false) r.
  Definition float_separated : bool := float_in_range && some_axis_b (fun K => Bltb (float_threshold K) (float_margin K)).
  Definition float_contact : bool :=
    float_in_range && negb (some_axis_b (fun K => negb (Bltb (float_margin K) (Bopp (float_threshold K))))).

  Hypothesis prec20 : (20 <= prec)%Z.
  Hypothesis half_nonneg : (0 <= half)%Z.
  Hypothesis fits_emax : (6 * half + 13 <= emax)%Z.
  Hypothesis deep : (emin <= -30)%Z.
  Notation in_format := (in_format prec emin).
  Notation h := (bpow radix2 half).
  Notation finite_vec := (finite_vec prec emax).
  Notation sized := (sized prec emax half).
  Notation sized_vec := (sized_vec prec emax half).
  Notation plus_finite := (Sizes.plus_finite prec emax _ _).
  Notation mult_finite := (Sizes.mult_finite prec emax _ _).
  Notation square_finite := (Sizes.square_finite prec emax _ _ fused).
  Notation sub_finite := (Sizes.sub_finite prec emax _ _).
  Notation constant_spec := (Sizes.constant_spec prec emax _ _ prec20).
  Notation h_power := (Sizes.h_power half half_nonneg).
  Notation rounded_size := (Sizes.rounded_size prec emax half prec20 half_nonneg fits_emax deep).
  Notation plus_sized := (Sizes.plus_sized prec emax _ _ half prec20 half_nonneg fits_emax deep).
  Notation minus_sized := (Sizes.minus_sized prec emax _ _ half prec20 half_nonneg fits_emax deep).
  Notation mult_sized := (Sizes.mult_sized prec emax _ _ half prec20 half_nonneg fits_emax deep).
  Notation opp_sized := (Sizes.opp_sized prec emax half).
  Notation dot_sized := (Sizes.dot_sized prec emax _ _ fused half prec20 half_nonneg fits_emax deep).
  Notation minus_product_sized := (Sizes.minus_product_sized prec emax _ _ fused half prec20 half_nonneg fits_emax deep).
  Notation cross_sized := (Sizes.cross_sized prec emax _ _ fused half prec20 half_nonneg fits_emax deep).
  Notation step_above := (Sizes.step_above prec emax prec20).
  Notation rounded_nonneg := (Sizes.rounded_nonneg prec emax prec20).
  Notation square_above := (Sizes.square_above prec emax _ fused prec20).
  Notation sum_nonneg := (Sizes.sum_nonneg prec emax _ _ prec20).
  Notation root_size := (Sizes.root_size prec emax half prec20 half_nonneg deep).
  Lemma vertex_sized v : is_finite (float_dot (float_sub v p) (float_sub v p)) = true ->
    B2R (float_dot (float_sub v p) (float_sub v p)) <= h ^ 2 ->
    finite_vec v /\ finite_vec p /\ sized_vec 1 1.001 (float_sub v p) (rounded_sub nearest (real_vec v) (real_vec p)) /\
    B2R (float_dot (float_sub v p) (float_sub v p)) =
      rounded_dot nearest fused (rounded_sub nearest (real_vec v) (real_vec p)) (rounded_sub nearest (real_vec v) (real_vec p)).
  Proof using deep half_nonneg prec20.
    intros F small. destruct (square_finite _ F) as [FX value]. destruct (sub_finite _ _ FX) as (Fv & Fp & same). rewrite same in value.
    split; [exact Fv |]. split; [exact Fp |]. split; [| exact value]. rewrite value in small. destruct FX as (Fx & Fy & Fz).
    pose proof (square_above (rounded_sub nearest (real_vec v) (real_vec p))) as ((bx & by_ & bz) & _).
    split; [| split]; (split; [assumption |]).
    - split; [exact (f_equal cx same) |]. apply root_size. lra.
    - split; [exact (f_equal cy same) |]. apply root_size. lra.
    - split; [exact (f_equal cz same) |]. apply root_size. lra.
  Qed.
  Lemma in_format_real v : in_format (real_vec v).
  Proof using Type. repeat split; apply generic_format_B2R. Qed.
  (* An edge is at most twice as long. *)
  Lemma edge_sized v w : finite_vec v -> finite_vec w ->
    sized_vec 1 1.001 (float_sub v p) (rounded_sub nearest (real_vec v) (real_vec p)) ->
    sized_vec 1 1.001 (float_sub w p) (rounded_sub nearest (real_vec w) (real_vec p)) ->
    sized_vec 1 2.01 (float_sub v w) (rounded_sub nearest (real_vec v) (real_vec w)).
  Proof using deep fits_emax half_nonneg prec20.
    intros (vx & vy & vz) (wx & wy & wz) ((_ & _ & sx) & (_ & _ & sy) & (_ & _ & sz)) ((_ & _ & tx) & (_ & _ & ty) & (_ & _ & tz)).
    destruct (in_format_real v) as (gx & gy & gz), (in_format_real w) as (kx & ky & kz), (in_format_real p) as (qx & qy & qz).
    assert (each : forall (X Y : float) x y z, is_finite X = true -> is_finite Y = true -> B2R X = x -> B2R Y = y ->
      generic_format radix2 (FLT_exp emin prec) x -> generic_format radix2 (FLT_exp emin prec) y ->
        generic_format radix2 (FLT_exp emin prec) z ->
      Rabs (nearest (x - z)) <= 1.001 * h ^ 1 -> Rabs (nearest (y - z)) <= 1.001 * h ^ 1 ->
        sized 1 2.01 (Bminus mode_NE X Y) (nearest (x - y))).
    { intros X Y x y z FX FY <- <- gX gY gz' sX sY. pose proof (u_small prec prec20) as us. pose proof (h_power 1).
      pose proof (proj2 (Format.difference_error prec emin ltac:(lia) _ _ gX gz')) as dX.
      pose proof (proj2 (Format.difference_error prec emin ltac:(lia) _ _ gY gz')) as dY.
      change (Rabs (B2R X - z) <= (1 + Expression.u prec) * Rabs (nearest (B2R X - z))) in dX.
      change (Rabs (B2R Y - z) <= (1 + Expression.u prec) * Rabs (nearest (B2R Y - z))) in dY.
      assert (forall t, Rabs t <= 1.001 * h ^ 1 -> (1 + Expression.u prec) * Rabs t <= 1.00101 * h ^ 1) as grow.
      { intros t st. pose proof (Rmult_le_compat_r (Rabs t) _ _ (Rabs_pos t) (proj2 us)). lra. }
      apply grow in sX, sY.
      destruct (rounded_size 1 2.00202 2.01 (B2R X - B2R Y) ltac:(lia)) as [size fit]; [| lra |].
      - replace (B2R X - B2R Y) with ((B2R X - z) + - (B2R Y - z)) by ring. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra.
      - destruct (minus_fits prec emax _ _ X Y FX FY fit). repeat split; assumption. }
    split; [| split].
    - apply (each _ _ _ _ _ vx wx eq_refl eq_refl gx kx qx sx tx).
    - apply (each _ _ _ _ _ vy wy eq_refl eq_refl gy ky qy sy ty).
    - apply (each _ _ _ _ _ vz wz eq_refl eq_refl gz kz qz sz tz).
  Qed.

  Lemma at_most (x : float) n e : is_finite (constant n e) = true -> B2R (constant n e) = IZR n * bpow radix2 e ->
    Bleb x (constant n e) = true ->
    Bleb (constant 1 least) x = true -> is_finite (constant 1 least) = true -> is_finite x = true /\ B2R x <= IZR n * bpow radix2 e.
  Proof using Type.
    intros F value below above F'. assert (is_finite x = true) as Fx.
    { revert F F' below above. clear. destruct x as [| [] | |], (constant n e) as [| | |], (constant 1 least) as [| | |]; cbn;
      try discriminate; auto. }
    split; [assumption |]. rewrite Bleb_correct in below by assumption. revert below. case Rle_bool_spec; [lra | discriminate].
  Qed.

  Hypothesis least_range : (emin <= least <= emax - prec)%Z.
  Hypothesis constants_range : (emin + 5 + prec <= 0 /\ prec + 2 * half <= emax)%Z.
  Let A := rounded_sub nearest (real_vec a) (real_vec p).
  Let B := rounded_sub nearest (real_vec b) (real_vec p).
  Let C := rounded_sub nearest (real_vec c) (real_vec p).
  Hypothesis in_range : float_in_range = true.

  Lemma range_spec : (finite_vec a /\ finite_vec b /\ finite_vec c) /\
    (sized_vec 1 1.001 (float_sub a p) A /\ sized_vec 1 1.001 (float_sub b p) B /\ sized_vec 1 1.001 (float_sub c p) C /\
      sized 1 1.001 r (B2R r)) /\
    sized 2 1 float_S (coarse_S nearest fused (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r)) /\
    bpow radix2 least <= coarse_S nearest fused (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) /\ 0 <= B2R r.
  Proof using constants_range deep half_nonneg in_range least_range prec20.
    pose proof in_range as H. unfold float_in_range in H. rewrite !andb_true_iff in H. destruct H as ((low & high) & r0).
    destruct (constant_spec 1 least) as [Fl vl]; [split; [lia | apply Z.pow_gt_1; lia] | lia |].
    destruct (constant_spec 1 (2 * half)) as [Fh vh]; [split; [lia | apply Z.pow_gt_1; lia] | lia |].
    destruct (at_most float_S _ _ Fh vh high low Fl) as [FS highS].
    rewrite Bleb_correct in low by assumption. rewrite vl in low. revert low. case Rle_bool_spec; intros low; [intros _ | discriminate].
    rewrite Rmult_1_l in low, highS. replace (2 * half)%Z with (half + half)%Z in highS by lia. rewrite bpow_plus in highS.
    unfold float_S in FS, low, highS |- *. destruct (plus_finite _ _ FS) as (F2 & Fr2 & v3).
    destruct (plus_finite _ _ F2) as (F1 & Fc & v2).
    destruct (plus_finite _ _ F1) as (Fa & Fb & v1). destruct (mult_finite _ _ Fr2) as (Fr & _ & vr).
    assert (square_nonneg : forall v, is_finite (square v) = true -> 0 <= B2R (square v)).
    { intros v F. destruct (square_finite _ F) as [_ value]. unfold square. rewrite value. apply square_above. }
    pose proof (square_nonneg _ Fa : 0 <= B2R aa) as a0. pose proof (square_nonneg _ Fb : 0 <= B2R bb) as b0.
    pose proof (square_nonneg _ Fc : 0 <= B2R cc) as c0.
    assert (0 <= B2R rr) as rr0 by (unfold rr; rewrite vr; apply rounded_nonneg, Rle_0_sqr).
    destruct (sum_nonneg _ _ F1 a0 b0) as [a1 b1]. assert (0 <= B2R (Bplus mode_NE aa bb)) as s0 by lra.
    destruct (sum_nonneg _ _ F2 s0 c0) as [s1 c1].
    assert (0 <= B2R (Bplus mode_NE (Bplus mode_NE aa bb) cc)) as s0' by lra.
    destruct (sum_nonneg _ _ FS s0' rr0) as [s2 r2].
    assert (h ^ 2 = h * h) as h2 by ring.
    destruct (vertex_sized a Fa ltac:(fold (square (float_sub a p)); fold aa; lra)) as (fa & _ & sa & va).
    destruct (vertex_sized b Fb ltac:(fold (square (float_sub b p)); fold bb; lra)) as (fb & _ & sb & vb).
    destruct (vertex_sized c Fc ltac:(fold (square (float_sub c p)); fold cc; lra)) as (fc & _ & sc & vc).
    assert (B2R (Bplus mode_NE (Bplus mode_NE (Bplus mode_NE aa bb) cc) rr) =
      coarse_S nearest fused (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r)) as value.
    { rewrite v3, v2, v1. unfold aa, bb, cc, rr, square, coarse_S. rewrite va, vb, vc, vr. reflexivity. }
    split; [auto |]. split; [split; [exact sa |]; split; [exact sb |]; split; [exact sc |] |].
    - split; [exact Fr |]. split; [reflexivity |]. apply root_size. rewrite <- vr. fold rr. lra.
    - rewrite <- value. split; [split; [exact FS |]; split; [reflexivity |]; rewrite Rabs_pos_eq; lra |]. split; [exact low |].
      rewrite Bleb_correct in r0 by auto. revert r0. case Rle_bool_spec; [intros; assumption | discriminate].
  Qed.

  (* So every number of the step is the same as with exponents that have no upper limit. *)
  Theorem step_is_program K :
    let margin := coarse_margin nearest fused (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) K in
    let threshold := coarse_threshold nearest fused (Expression.u prec) (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) K in
    sized 6 4096 (float_margin K) margin /\ sized 6 4096 (float_threshold K) threshold.
  Proof using constants_range deep fits_emax half_nonneg in_range least_range prec20.
    destruct range_spec as ((fa & fb & fc) & (sa & sb & sc & sr) & sS & _).
    pose proof (edge_sized b a fb fa sb sa) as sab. pose proof (edge_sized c b fc fb sc sb) as sbc.
    pose proof (edge_sized a c fa fc sa sc) as sca.
    pose proof (dot_sized 1 1 _ _ 3.1 _ _ _ _ ltac:(lia) sa sa ltac:(lra)) as saa.
    pose proof (dot_sized 1 1 _ _ 3.1 _ _ _ _ ltac:(lia) sb sb ltac:(lra)) as sbb.
    pose proof (dot_sized 1 1 _ _ 3.1 _ _ _ _ ltac:(lia) sc sc ltac:(lra)) as scc.
    pose proof (mult_sized 1 1 _ _ 1.1 _ _ _ _ ltac:(lia) sr sr ltac:(lra)) as srr.
    pose proof (dot_sized 1 1 _ _ 12.2 _ _ _ _ ltac:(lia) sab sab ltac:(lra)) as s1.
    pose proof (dot_sized 1 1 _ _ 12.2 _ _ _ _ ltac:(lia) sbc sbc ltac:(lra)) as s2.
    pose proof (dot_sized 1 1 _ _ 12.2 _ _ _ _ ltac:(lia) sca sca ltac:(lra)) as s3.
    assert (weaker : forall n k X x, (n <= 6)%nat -> 0 <= k <= 4096 -> sized n k X x -> sized 6 4096 X x).
    { intros n k X x n6 k4 (F & value & size). repeat split; try assumption. eapply Rle_trans; [exact size |].
      apply Rmult_le_compat; try lra; [pose proof (h_power n); lra | apply Rle_pow; [pose proof (h_power 1); cbn in *; lra | assumption]]. }
    assert (coefficient : forall n e, (0 <= n < 2 ^ prec)%Z -> (emin <= e <= 0)%Z -> IZR n * bpow radix2 e <= 1 ->
      sized 0 1 (constant n e) (IZR n * bpow radix2 e)).
    { intros n e n0 e0 small. destruct (constant_spec n e n0 ltac:(lia)) as [F value]. repeat split; try assumption.
      cbn [pow]. rewrite Rabs_pos_eq; [lra |]. apply Rmult_le_pos; [apply IZR_le; lia | apply bpow_ge_0]. }
    cbv zeta. split.
    - assert (side : forall x X y Y z Z, sized 2 3.1 X x -> sized 2 3.1 Y y -> sized 2 12.2 Z z ->
        sized 6 4096 (less (less X Y) Z) (nearest (nearest (x - y) - z)) /\
          sized 6 4096 (less (Bopp (less X Y)) Z) (nearest (- nearest (x - y) - z))).
      { intros x X y Y z Z HX HY HZ. pose proof (minus_sized 2 _ _ 6.3 _ _ _ _ ltac:(lia) HX HY ltac:(lra)) as first. split.
        - apply (weaker 2%nat 20); [lia | lra |]. eapply minus_sized; [lia | exact first | exact HZ | lra].
        - apply (weaker 2%nat 20); [lia | lra |]. eapply minus_sized; [lia | apply opp_sized, first | exact HZ | lra]. }
      assert (radius : forall x X, sized 2 3.1 X x -> sized 6 4096 (less X rr) (nearest (x - nearest (B2R r * B2R r)))).
      { intros x X HX. apply (weaker 2%nat 20); [lia | lra |]. eapply minus_sized; [lia | exact HX | exact srr | lra]. }
      pose proof (cross_sized 1 1 _ _ 8.2 _ _ _ _ ltac:(lia) sca sab ltac:(lra)) as sV.
      assert (edge : forall v x w y e E, sized_vec 1 1.001 v x -> sized_vec 1 2.01 w y -> sized 2 12.2 E e ->
        sized 6 4096 (float_minus_product (float_dot (float_cross v w) (float_cross v w)) rr E)
          (rounded_minus_product nearest fused (rounded_dot nearest fused (rounded_cross nearest fused x y) (rounded_cross nearest fused x
            y)) (nearest (B2R r * B2R r)) e) /\
        sized 6 4096 (Bopp (float_dot (float_cross v w) V)) (- rounded_dot nearest fused (rounded_cross nearest fused x y)
          (rounded_cross nearest fused (rounded_sub nearest (real_vec a) (real_vec c)) (rounded_sub nearest (real_vec b) (real_vec a))))).
      { intros v x w y e E Hv Hw HE. pose proof (cross_sized 1 1 _ _ 4.2 _ _ _ _ ltac:(lia) Hv Hw ltac:(lra)) as HN.
        pose proof (dot_sized 2 2 _ _ 60 _ _ _ _ ltac:(lia) HN HN ltac:(lra)) as HNN.
        pose proof (dot_sized 2 2 _ _ 110 _ _ _ _ ltac:(lia) HN sV ltac:(lra)) as HNV. split.
        - apply (weaker 4%nat 80); [lia | lra |]. apply (minus_product_sized 2 2 1.1 12.2 60); try assumption; [lia | lra].
        - apply (weaker 4%nat 110); [lia | lra |]. apply opp_sized. exact HNV. }
      destruct K; unfold float_margin, coarse_margin; try (apply radius; assumption); try (apply side; assumption); try (eapply edge;
        eassumption).
      pose proof (dot_sized 1 2 _ _ 25 _ _ _ _ ltac:(lia) sa sV ltac:(lra)) as sD.
      pose proof (dot_sized 2 2 _ _ 210 _ _ _ _ ltac:(lia) sV sV ltac:(lra)) as sVV.
      pose proof (mult_sized 3 3 _ _ 630 _ _ _ _ ltac:(lia) sD sD ltac:(lra)) as sDD.
      apply (weaker 6%nat 900); [lia | lra |]. apply (minus_product_sized 2 4 1.1 210 630); try assumption; [lia | lra].
    - pose proof (plus_sized 2 _ _ 25 _ _ _ _ ltac:(lia) s1 s2 ltac:(lra)) as t1.
    pose proof (plus_sized 2 _ _ 38 _ _ _ _ ltac:(lia) t1 s3 ltac:(lra)) as t2.
      pose proof (coefficient 1%Z (-20)%Z ltac:(split; [lia | apply Z.pow_gt_1; lia]) ltac:(lia) ltac:(cbn; lra)) as c20.
      pose proof (mult_sized 0 2 _ _ 1.1 _ _ _ _ ltac:(lia) c20 sS ltac:(lra)) as t3.
      pose proof (plus_sized 2 _ _ 40 _ _ _ _ ltac:(lia) t2 t3 ltac:(lra)) as sE.
      pose proof (mult_sized 2 2 _ _ 41 _ _ _ _ ltac:(lia) sS sE ltac:(lra)) as sSE.
      pose proof (mult_sized 4 2 _ _ 1700 _ _ _ _ ltac:(lia) sSE sE ltac:(lra)) as sSEE.
      replace (IZR 1 * bpow radix2 (-20)) with (/ 1048576) in sE, sSE, sSEE by (cbn; lra).
      assert (few : forall n, (0 <= n < 2 ^ 10)%Z -> (0 <= n < 2 ^ prec)%Z).
      { intros n n0. split; [lia |]. apply Z.lt_le_trans with (2 ^ 10)%Z; [lia | apply Z.pow_le_mono_r; lia]. }
      assert (unit_small : forall n e, (0 <= n < 2 ^ 10)%Z -> (e <= -10)%Z -> IZR n * bpow radix2 e <= 1).
      { intros n e n0 e0. apply Rle_trans with (bpow radix2 10 * bpow radix2 (-10)); [| rewrite <- bpow_plus; cbn; lra].
        apply Rmult_le_compat; [apply IZR_le; lia | apply bpow_ge_0 | | apply bpow_le; assumption].
        change (bpow radix2 10) with (IZR (2 ^ 10)). apply IZR_le. lia. }
      pose proof (coefficient 323%Z (-4 - prec)%Z (few 323%Z ltac:(lia)) ltac:(lia) (unit_small 323%Z (-4 - prec)%Z ltac:(lia) ltac:(lia)))
        as k2.
      pose proof (coefficient 357%Z (-5 - prec)%Z (few 357%Z ltac:(lia)) ltac:(lia) (unit_small 357%Z (-5 - prec)%Z ltac:(lia) ltac:(lia)))
        as k4.
      pose proof (coefficient 187%Z (-5 - prec)%Z (few 187%Z ltac:(lia)) ltac:(lia) (unit_small 187%Z (-5 - prec)%Z ltac:(lia) ltac:(lia)))
        as k6.
      replace (IZR 323 * bpow radix2 (-4 - prec)) with (coarse_degree_2 * Expression.u prec) in k2
        by (unfold coarse_degree_2, Expression.u, Zminus; rewrite bpow_plus; change (bpow radix2 (-4)) with (/ 16); lra).
      replace (IZR 357 * bpow radix2 (-5 - prec)) with (coarse_degree_4 * Expression.u prec) in k4
        by (unfold coarse_degree_4, Expression.u, Zminus; rewrite bpow_plus; change (bpow radix2 (-5)) with (/ 32); lra).
      replace (IZR 187 * bpow radix2 (-5 - prec)) with (coarse_degree_6 * Expression.u prec) in k6
        by (unfold coarse_degree_6, Expression.u, Zminus; rewrite bpow_plus; change (bpow radix2 (-5)) with (/ 32); lra).
      pose proof (weaker 2%nat 2 _ _ ltac:(lia) ltac:(lra) (mult_sized 0 2 _ _ 2 _ _ _ _ ltac:(lia) k2 sS ltac:(lra))) as T2.
      pose proof (weaker 4%nat 50 _ _ ltac:(lia) ltac:(lra) (mult_sized 0 4 _ _ 50 _ _ _ _ ltac:(lia) k4 sSE ltac:(lra))) as T4.
      pose proof (weaker 6%nat 2000 _ _ ltac:(lia) ltac:(lra) (mult_sized 0 6 _ _ 2000 _ _ _ _ ltac:(lia) k6 sSEE ltac:(lra))) as T6.
      destruct K; unfold float_threshold, coarse_threshold; (exact T2 || exact T4 || exact T6).
  Qed.

  (* So its answers are those of the program over rounded reals. *)
  Lemma answers_are_the_programs :
    let margin := coarse_margin nearest fused (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) in
    let threshold := coarse_threshold nearest fused (Expression.u prec) (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) in
    (forall K, is_finite (float_margin K) = true /\ is_finite (float_threshold K) = true) /\
    (some_axis_b (fun K => Bltb (float_threshold K) (float_margin K)) = true -> some_axis (fun K => margin K > threshold K)) /\
    (some_axis_b (fun K => negb (Bltb (float_margin K) (Bopp (float_threshold K)))) = false ->
      ~ some_axis (fun K => margin K >= - threshold K)).
  Proof using constants_range deep fits_emax half_nonneg in_range least_range prec20.
    cbv zeta. split; [| split].
    - intros K. destruct (step_is_program K) as [(F & _) (F' & _)]. auto.
    - rewrite some_axis_b_spec. apply some_axis_mono. intros K.
      destruct (step_is_program K) as [(F & value & _) (F' & value' & _)]. rewrite Bltb_correct, value, value' by assumption.
      case Rlt_bool_spec; [intros beyond _; exact beyond | discriminate].
    - intros none some. apply not_true_iff_false in none. apply none, some_axis_b_spec. revert some.
      apply some_axis_mono. intros K.
      destruct (step_is_program K) as [(F & value & _) (F' & value' & _)].
      rewrite Bltb_correct, B2R_Bopp, value, value' by (rewrite ?is_finite_Bopp; assumption).
      case Rlt_bool_spec; [intros below above; exfalso; unfold Run.nearest in *; lra | reflexivity].
  Qed.
End Float.

(* The statement for any thirteen numbers, including ones that are not finite; S from 2^least to 2^(2 half). There is no
   division, so a finite result means that nothing overflowed on the way to it. *)
Definition float_coarse_never_lies (prec emax least half : Z) (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax) : Prop
  :=
  forall fused (a b c p : float_vec prec emax) (r : binary_float prec emax),
  let apart := separated (real_vec prec emax a) (real_vec prec emax b) (real_vec prec emax c) (real_vec prec emax p) (B2R r) in
  (float_in_range prec emax _ _ fused least half a b c p r = true -> forall K,
    is_finite (float_margin prec emax _ _ fused a b c p r K) = true /\
      is_finite (float_threshold prec emax _ _ fused a b c p r K) = true) /\
  (float_separated prec emax _ _ fused least half a b c p r = true -> apart) /\
  (float_contact prec emax _ _ fused least half a b c p r = true -> ~ apart).

(* The formats and ranges for which the step is a program over rounded reals. *)
Definition step_fits (prec emax least half : Z) : Prop :=
  (20 <= prec)%Z /\ (0 <= half)%Z /\ (6 * half + 13 <= emax)%Z /\ (3 - emax - prec <= -30)%Z /\
  (3 - emax - prec <= least <= emax - prec)%Z /\ (3 - emax - prec + 5 + prec <= 0 /\ prec + 2 * half <= emax)%Z.

Lemma float_instance prec emax least half prec_gt_0_ prec_lt_emax_ :
  step_fits prec emax least half -> coarse_never_lies prec (3 - emax - prec) least ->
  float_coarse_never_lies prec emax least half prec_gt_0_ prec_lt_emax_.
Proof.
  intros (p20 & half0 & fits & deep & least_range & constants) never fused a b c p r; intros.
  assert (formats : forall v, in_format prec (3 - emax - prec) (real_vec prec emax v)) by apply in_format_real.
  pose proof (fun inside => answers_are_the_programs prec emax _ _ fused least half a b c p r p20 half0 fits deep least_range constants
    inside) as program.
  pose proof (fun inside => range_spec prec emax _ _ fused least half a b c p r p20 half0 deep least_range constants inside) as spec.
  assert (right : float_in_range prec emax _ _ fused least half a b c p r = true -> _) by
    (intros inside; destruct (spec inside) as (_ & _ & _ & low & r0);
     exact (never fused _ _ _ _ _ (formats a) (formats b) (formats c) (formats p) r0 low)).
  unfold float_separated, float_contact. split; [| split].
  - intros inside. apply (program inside).
  - rewrite andb_true_iff. intros [inside some]. apply (right inside). apply (program inside). exact some.
  - rewrite andb_true_iff, negb_true_iff. intros [inside none]. apply (right inside). apply (program inside). exact none.
Qed.

Lemma step_fits32 : step_fits 24 128 (-21) 19.
Proof. unfold step_fits. lia. Qed.
Lemma step_fits64 : step_fits 53 1024 (-300) 150.
Proof. unfold step_fits. lia. Qed.

Theorem float_coarse_never_lies32 : float_coarse_never_lies 24 128 (-21) 19 eq_refl eq_refl.
Proof. apply float_instance; [apply step_fits32 | apply coarse_never_lies32]. Qed.
Theorem float_coarse_never_lies64 : float_coarse_never_lies 53 1024 (-300) 150 eq_refl eq_refl.
Proof. apply float_instance; [apply step_fits64 | apply coarse_never_lies64]. Qed.
