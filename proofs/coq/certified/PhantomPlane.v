(* The plane's axis of the conservative test: it passes where the triangle is not thin and its plane is farther from the
   centre than r by 19.9 sqrt u L. The other axes and the names are in Phantom.v. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Lanes Certified Conservative Phantom.
Open Scope R_scope.

Lemma dot_plane A B C : let V := cross (sub A C) (sub B A) in dot B V = dot A V /\ dot C V = dot A V.
Proof. cbv zeta. split; vec_ring. Qed.
Lemma norm_scaled v k : 0 <= k -> norm (scale v k) = k * norm v.
Proof.
  intros k0. pose proof (norm_nonneg v). unfold norm at 1. replace (dot (scale v k) (scale v k)) with (k * norm v * (k * norm v)).
  - apply sqrt_square. apply Rmult_le_pos; assumption.
  - replace (k * norm v * (k * norm v)) with (k * k * (norm v * norm v)) by ring. rewrite norm_square. vec_ring.
Qed.
Lemma sub_scaled v w k : sub (scale v k) (scale w k) = scale (sub v w) k. Proof. vec_ring. Qed.
Lemma sub_between x y z : sub x z = add (sub x y) (sub y z). Proof. vec_ring. Qed.
Lemma dot_scaled v x k : dot x (scale v k) = k * dot x v. Proof. vec_ring. Qed.

Section Plane.
  Variables u eta : R.
  Hypothesis u_range : 0 < u <= / 1048576.
  Hypothesis eta_nonneg : 0 <= eta.
  Notation rounds := (rounds u eta).
  Notation computed_dot := (computed_dot u eta).
  Notation computed_cross := (computed_cross u eta).
  Notation leaf_of := (leaf_of u).
  Let u_weak : 0 <= u <= / 1048576. Proof using u_range. lra. Qed.
  Local Notation small := (small u u_weak).

  Lemma cross_near x y X Y N : leaf_of x X -> leaf_of y Y -> computed_cross X Y N ->
    norm (sub N (cross x y)) <= 5.665 * u * (norm x * norm y) + 7 * eta.
  Proof using All.
    intros (xx & xy & xz) (yx & yy & yz) (HX & HY & HZ).
    pose proof (norm_nonneg x). pose proof (norm_nonneg y). assert (0 <= norm x * norm y) as p0 by (apply Rmult_le_pos; assumption).
    pose proof (leaf_difference u eta u_weak eta_nonneg _ _ _ _ _ _ _ _ _ xy yz xz yy HX) as dx.
    pose proof (leaf_difference u eta u_weak eta_nonneg _ _ _ _ _ _ _ _ _ xz yx xx yz HY) as dy.
    pose proof (leaf_difference u eta u_weak eta_nonneg _ _ _ _ _ _ _ _ _ xx yy xy yx HZ) as dz.
    assert (norm (sub N (cross x y)) <= norm (add (scale (cross_sizes x y) (4.005 * u)) (Vec (4 * eta) (4 * eta) (4 * eta)))) as step.
    { apply norm_monotone; unfold sub, cross, add, scale, cross_sizes; cbn [cx cy cz]; lra. }
    eapply Rle_trans; [exact step |]. eapply Rle_trans; [apply norm_triangle |]. rewrite norm_scaled by lra.
    pose proof (cross_sizes_norm x y) as size. apply (Rmult_le_compat_l u) in size; [| lra].
    assert (norm (Vec (4 * eta) (4 * eta) (4 * eta)) <= 7 * eta) as rest.
    { apply norm_at_most; [lra |]. unfold dot. cbn [cx cy cz]. pose proof (Rmult_le_pos _ _ eta_nonneg eta_nonneg). lra. }
    pose proof (small _ p0). lra.
  Qed.

  Variables (A B C : vec) (r W Rc : R).
  Hypothesis r_nonneg : 0 <= r.
  Hypothesis W_positive : 0 < W.
  Hypothesis underflow_3 : eta <= / 1000000 * (u * u * u).
  Hypothesis underflow_5 : eta <= / 1000000 * (u * u * (u * W)).
  Hypothesis sizes_known : forall X, vertex A B C X -> dot X X <= 1.00001 * W /\ norm X <= 1.00001 * sqrt W.
  Let w := sqrt W.
  Let t := sqrt (u * W).
  Hypothesis Rc_range : 0 <= Rc <= r * r + 22 * (t * t).
  Let V := cross (sub A C) (sub B A).

  Lemma plane_deep longest CA AB N k n at_a at_b at_c square m mm rs rho :
    leaf_of (sub A C) CA -> leaf_of (sub B A) AB -> computed_cross CA AB N ->
    1 <= k * W -> rounds (cx N * k) (cx n) -> rounds (cy N * k) (cy n) -> rounds (cz N * k) (cz n) ->
    computed_dot A n at_a -> computed_dot B n at_b -> computed_dot C n at_c -> computed_dot n n square ->
    dot (sub A C) (sub A C) <= longest -> dot (sub B A) (sub B A) <= longest -> 9 * (t * t) * longest < dot V V ->
    r + 19.9 * t <= rho -> rho * norm V <= Rabs (dot A V) ->
    rounds (m * m) mm -> rounds (Rc * square) rs ->
    (at_a < 0 -> m = - at_a \/ m = - at_b \/ m = - at_c) -> (0 <= at_a -> m = at_a \/ m = at_b \/ m = at_c) ->
    50 * (u * u) <= square /\ 0 < m /\ rs < mm.
  Proof using Rc_range W_positive eta_nonneg r_nonneg sizes_known u_weak underflow_3 underflow_5.
    intros lCA lAB HN kW nx ny nz Ha Hb Hc Hs la lb thick far high Hmm Hrs below above.
    destruct (t_facts u u_range W W_positive) as (w0 & ww & t0 & tt & uwt). fold w t in w0, ww, t0, tt, uwt.
    set (ca := norm (sub A C)). set (ab := norm (sub B A)). set (q := ca * ab). set (Vn := norm V).
    pose proof (norm_nonneg (sub A C)) as ca0. pose proof (norm_nonneg (sub B A)) as ab0. fold ca in ca0. fold ab in ab0.
    assert (0 <= q) as q0 by (apply Rmult_le_pos; assumption). pose proof (norm_nonneg V) as Vn0. fold Vn in Vn0.
    assert (Vn <= q) as Vq by apply cross_norm. assert (Vn * Vn = dot V V) as VV by apply norm_square. rewrite <- VV in thick.
    rewrite <- norm_square in la, lb. fold ca in la. fold ab in lb.
    assert (0 <= longest) as L0 by (pose proof (Rle_0_sqr ca); unfold Rsqr in *; lra).
    assert (q <= longest) as qL by (unfold q; pose proof (Rle_0_sqr (ca - ab)); unfold Rsqr in *; lra).
    assert (9 * (t * t) < Vn) as Vbig.
    { assert (0 < t * t) by (apply Rmult_lt_0_compat; assumption). destruct (Rlt_le_dec (9 * (t * t)) Vn) as [| less]; [assumption |].
      assert (Vn * Vn <= 9 * (t * t) * longest) by (apply Rmult_le_compat; lra). lra. }
    assert (0 < t * t) as tt0 by (apply Rmult_lt_0_compat; assumption). assert (0 < Vn) as V0 by lra.
    (* G = sqrt u. *)
    set (G := sqrt u). assert (0 < G) as G0 by (apply sqrt_lt_R0; lra). assert (G * G = u) as GG by (apply sqrt_sqrt; lra).
    assert (G <= / 1000) as Gs.
    { apply Rsqr_incr_0_var; [| lra]. unfold Rsqr. rewrite GG. lra. }
    assert (G * w = t) as Gw.
    { apply Rsqr_inj; [apply Rmult_le_pos; lra | lra |]. unfold Rsqr. rewrite tt. replace (G * w * (G * w)) with (G * G * (w * w)) by ring.
    rewrite GG, ww. reflexivity. }
    pose proof (sizes_known A (or_introl eq_refl)) as [_ sA]. pose proof (sizes_known C (or_intror (or_intror eq_refl))) as [_ sC].
    fold w in sA, sC.
    assert (ca <= 2.0001 * w) as caw.
    { unfold ca. replace (sub A C) with (add A (scale C (-1))) by (clear; destruct A, C; unfold add, sub, scale; cbn; f_equal; ring).
      pose proof (norm_triangle A (scale C (-1))) as tri. rewrite norm_opposite in tri. lra. }
    assert (G * q <= 0.6668 * Vn) as Gq.
    { apply Rsqr_incr_0_var; [| lra]. unfold Rsqr. replace (G * q * (G * q)) with (G * G * (ca * ca * (ab * ab))) by (unfold q; ring).
    rewrite GG.
      assert (ca * ca <= 2.0001 * w * (2.0001 * w)) as c2 by (apply Rmult_le_compat; lra).
      assert (ca * ca * (ab * ab) <= 4.0005 * W * longest) as c3.
      { apply Rmult_le_compat; try (apply Rle_0_sqr); [| assumption].
      replace (2.0001 * w * (2.0001 * w)) with (2.0001 * 2.0001 * (w * w)) in c2 by ring. rewrite ww in c2. lra. }
      apply (Rmult_le_compat_l u) in c3; [| lra]. rewrite tt in thick.
      assert (0 <= Vn * Vn) by (apply Rmult_le_pos; lra). lra. }
    assert (u * q <= 0.6668 * (G * Vn)) as uq.
    { rewrite <- GG. replace (G * G * q) with (G * (G * q)) by ring. apply (Rmult_le_compat_l G) in Gq; lra. }
    (* n is near k V. *)
    assert (0 < k) as k0 by (destruct (Rlt_le_dec 0 k) as [| neg]; [assumption |]; pose proof (Rmult_le_compat_r W _ _ ltac:(lra) neg);
      lra).
    set (K := k * Vn). assert (9 * u <= K) as Ku.
    { unfold K. apply Rle_trans with (k * (9 * (t * t))); [rewrite tt; replace (k * (9 * (u * W))) with (9 * u * (k * W)) by ring |].
      - pose proof (Rmult_le_compat_l (9 * u) _ _ ltac:(lra) kW). lra.
      - apply Rmult_le_compat_l; lra. }
    assert (0 < K) as K0 by lra. assert (0 <= G * K) as GK by (apply Rmult_le_pos; lra).
    assert (u <= G) as uG by (rewrite <- GG; pose proof (Rmult_le_compat_r G _ _ ltac:(lra) Gs); lra).
    assert (u * u <= G / 1000) as uuG by (pose proof (Rmult_le_compat u G u (/ 1000) ltac:(lra) ltac:(lra) uG ltac:(lra)); lra).
    assert (k * eta <= / 1000000 * (G * K)) as keta.
    { apply Rle_trans with (k * (/ 1000000 * (u * u * Vn))).
      - apply Rmult_le_compat_l; [lra |]. eapply Rle_trans; [exact underflow_5 |]. apply Rmult_le_compat_l; [lra |].
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | rewrite <- tt; lra].
      - unfold K. replace (k * (/ 1000000 * (u * u * Vn))) with (/ 1000000 * (u * u * (k * Vn))) by ring. fold K.
        assert (u * u * K <= G / 1000 * K) by (apply Rmult_le_compat_r; lra). lra. }
    assert (eta <= / 1000000 * (G * K)) as etaK.
    { eapply Rle_trans; [exact underflow_3 |]. assert (u * u * u <= G / 1000 * K) by (apply Rmult_le_compat; try lra; apply Rmult_le_pos;
      lra). lra. }
    pose proof (cross_near _ _ _ _ _ lCA lAB HN) as Noff. fold V ca ab q in Noff.
    assert (norm N <= Vn + (5.665 * u * q + 7 * eta)) as Nlen.
    { pose proof (norm_triangle V (sub N V)) as tri. rewrite add_difference in tri. fold Vn in tri. lra. }
    assert (norm (sub n (scale N k)) <= u * (k * norm N) + 2 * eta) as noff.
    { eapply Rle_trans; [apply (norm_monotone _ (add (scale (magnitudes (scale N k)) u) (Vec eta eta eta))) |].
      1-3: unfold Lanes.rounds in *; unfold sub, add, scale, magnitudes; cbn [cx cy cz]; lra.
      eapply Rle_trans; [apply norm_triangle |]. rewrite norm_scaled, norm_magnitudes, norm_scaled by lra.
      assert (norm (Vec eta eta eta) <= 2 * eta).
      { apply norm_at_most; [lra |]. unfold dot. cbn [cx cy cz]. pose proof (Rmult_le_pos _ _ eta_nonneg eta_nonneg). lra. }
      lra. }
    assert (norm (sub n (scale V k)) <= 4.46 * (G * K)) as near.
    { rewrite (sub_between n (scale N k) (scale V k)). eapply Rle_trans; [apply norm_triangle |]. rewrite sub_scaled, norm_scaled by lra.
      apply (Rmult_le_compat_l k) in Noff, Nlen, uq; try lra. assert (k * (G * Vn) = G * K) as GKV by (unfold K; ring).
      apply (Rmult_le_compat_l u) in Nlen; [| lra]. fold K in Nlen.
      assert (u * (k * Vn) <= k * (u * q)) by (replace (k * (u * q)) with (u * (k * q)) by ring; apply Rmult_le_compat_l; [lra |];
        apply Rmult_le_compat_l; lra).
      assert (0 <= k * (u * q)) as kuq by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; lra]). pose proof (small _ kuq).
      assert (0 <= k * eta) as ke0 by (apply Rmult_le_pos; lra). pose proof (small _ ke0). lra. }
    set (N0 := norm n). assert (N0 <= K + 4.46 * (G * K) /\ K - 4.46 * (G * K) <= N0) as [Nup Ndown].
    { pose proof (norm_triangle (scale V k) (sub n (scale V k))) as tri. rewrite add_difference, norm_scaled in tri by lra.
    fold Vn K N0 in tri.
      pose proof (norm_triangle n (sub (scale V k) n)) as tri'. rewrite add_difference, norm_turned, norm_scaled in tri' by lra.
      fold Vn K N0 in tri'. lra. }
    assert (G * K <= / 1000 * K) as GKs by (apply Rmult_le_compat_r; lra).
    assert (8.9 * u <= N0) as N0u by lra. assert (0 < N0) as N00 by lra.
    (* rho is at most w. *)
    assert (rho <= 1.00001 * w) as rhow.
    { pose proof (dot_norm A V) as long. fold Vn in long, high. apply Rmult_le_reg_r with Vn; [assumption |].
      assert (norm A * Vn <= 1.00001 * w * Vn) by (apply Rmult_le_compat_r; lra). lra. }
    (* Every product, as computed. *)
    assert (0 <= u * w) as uw0 by (apply Rmult_le_pos; lra).
    assert (eta <= / 1000000 * (t * N0)) as etat.
    { assert (eta <= / 1000000 * (u * u * (u * w))) as e1.
      { apply Rsqr_incr_0_var; [| repeat apply Rmult_le_pos; lra]. unfold Rsqr.
        replace (/ 1000000 * (u * u * (u * w)) * (/ 1000000 * (u * u * (u * w)))) with (/ 1000000 * (u * u * u) * (/ 1000000 * (u * u * (u
          * (w * w))))) by ring.
        rewrite ww. apply Rmult_le_compat; assumption. }
      eapply Rle_trans; [exact e1 |]. apply Rmult_le_compat_l; [lra |]. replace (u * u * (u * w)) with (u * w * (u * u)) by ring.
      apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra |]. pose proof (small u ltac:(lra)). lra. }
    assert (each : forall X d, vertex A B C X -> computed_dot X n d -> Rabs (d - dot X n) <= 0.0031 * (t * N0)).
    { intros X d HX H. destruct (sizes_known X HX) as [_ size]. fold w in size. apply dot_error in H; [| exact u_weak | assumption].
      pose proof (sizes_norm X n) as sn. fold N0 in sn. assert (norm X * N0 <= 1.00001 * w * N0) as long by (apply Rmult_le_compat_r; lra).
      assert (u * sizes X n <= u * (1.00001 * w * N0)) by (apply Rmult_le_compat_l; lra).
      assert (u * w * N0 <= t / 1000 * N0) by (apply Rmult_le_compat_r; lra). lra. }
    assert (apart : forall X, vertex A B C X -> Rabs (dot X n - k * dot A V) <= 4.4601 * (t * K)).
    { intros X HX. destruct (sizes_known X HX) as [_ size]. fold w in size.
      assert (dot X V = dot A V) as same by (destruct (dot_plane A B C), HX as [-> | [-> | ->]]; auto).
      rewrite (dot_moved X (scale V k) n), dot_scaled, same.
      replace (k * dot A V + dot X (sub n (scale V k)) - k * dot A V) with (dot X (sub n (scale V k))) by ring.
      eapply Rle_trans; [apply dot_norm |].
      assert (norm X * norm (sub n (scale V k)) <= 1.00001 * w * (4.46 * (G * K))) as part by (apply Rmult_le_compat;
        try apply norm_nonneg; assumption).
      replace (1.00001 * w * (4.46 * (G * K))) with (4.4600446 * (G * w * K)) in part by lra. rewrite Gw in part.
      assert (0 <= t * K) by (apply Rmult_le_pos; lra). lra. }
    set (d := dot A V) in *. fold Vn in high.
    assert (k * (rho * Vn) <= k * Rabs d) as kd by (apply Rmult_le_compat_l; lra).
    replace (k * (rho * Vn)) with (rho * K) in kd by (unfold K; ring).
    assert (N0 * (r + 10.9 * t) <= rho * K - 4.4601 * (t * K) - 0.0031 * (t * N0)) as enough.
    { assert (N0 * (1 - 4.46 * G) <= K) as NK.
      { assert (0 <= G * (G * K)) by (apply Rmult_le_pos; lra).
      assert (N0 * (1 - 4.46 * G) <= (K + 4.46 * (G * K)) * (1 - 4.46 * G)) by (apply Rmult_le_compat_r; lra). lra. }
      assert (N0 * (1 - 4.46 * G) * (rho - 4.4601 * t) <= K * (rho - 4.4601 * t)) as step by (apply Rmult_le_compat_r; lra).
      assert (G * rho <= 1.00001 * t) as Grho by (rewrite <- Gw; apply (Rmult_le_compat_l G) in rhow; lra).
      assert (N0 * (G * rho) <= N0 * (1.00001 * t)) by (apply Rmult_le_compat_l; lra).
      assert (N0 * (r + 19.9 * t) <= N0 * rho) by (apply Rmult_le_compat_l; lra).
      assert (0 <= N0 * G * t) by (repeat apply Rmult_le_pos; lra). assert (0 <= N0 * t) by (apply Rmult_le_pos; lra). lra. }
    set (y := r + 4.7 * t). assert (0 <= y) as y0 by (unfold y; lra).
    assert (0 < N0 * (r + 10.9 * t)) as least0 by (apply Rmult_lt_0_compat; lra).
    assert (N0 * (y + 6.2 * t) <= m) as mlow.
    { pose proof (each A _ (or_introl eq_refl) Ha) as oa. pose proof (each B _ (or_intror (or_introl eq_refl)) Hb) as ob.
      pose proof (each C _ (or_intror (or_intror eq_refl)) Hc) as oc. pose proof (apart A (or_introl eq_refl)) as pa.
      pose proof (apart B (or_intror (or_introl eq_refl))) as pb. pose proof (apart C (or_intror (or_intror eq_refl))) as pc.
      apply Rabs_le_inv in oa, ob, oc, pa, pb, pc. replace (y + 6.2 * t) with (r + 10.9 * t) by (unfold y; lra).
      destruct (Rle_lt_dec 0 d) as [d0 | d0].
      - rewrite (Rabs_pos_eq d) in kd by assumption. destruct (above ltac:(lra)) as [-> | [-> | ->]]; lra.
      - rewrite (Rabs_left d) in kd by assumption. destruct (below ltac:(lra)) as [-> | [-> | ->]]; lra. }
    (* The squares. *)
    apply dot_error in Hs; [| exact u_weak | assumption]. rewrite sizes_square in Hs. apply Rabs_le_inv in Hs.
    assert (N0 * N0 = dot n n) as NN by apply norm_square. rewrite <- NN in Hs.
    assert (8.9 * u * (8.9 * u) <= N0 * N0) as NNu by (apply Rmult_le_compat; lra).
    assert (0 < N0 * N0) as NN0 by (apply Rmult_lt_0_compat; assumption).
    assert (eta <= / 1000000 * (u * (N0 * N0))) as etaN.
    { eapply Rle_trans; [exact underflow_3 |]. replace (u * u * u) with (u * (u * u)) by ring. apply Rmult_le_compat_l; [lra |].
    apply Rmult_le_compat_l; lra. }
    pose proof (small (N0 * N0) ltac:(lra)) as uNN. assert (0 < m) as m0.
    { replace (y + 6.2 * t) with (r + 10.9 * t) in mlow by (unfold y; lra). lra. }
    split; [lra |]. split; [assumption |].
    assert (Rc <= y * y) as Ry by (unfold y; assert (0 <= r * t) by (apply Rmult_le_pos; lra); lra).
    assert (0 <= square <= N0 * N0 * (1 + 3.1 * u)) as srange by lra.
    assert (Rc * square <= y * y * (N0 * N0 * (1 + 3.1 * u))) as top by (apply Rmult_le_compat; lra).
    assert (N0 * (y + 6.2 * t) * (N0 * (y + 6.2 * t)) <= m * m) as bottom.
    { apply Rmult_le_compat; try assumption; (apply Rmult_le_pos; lra). }
    assert (0 <= y * t) as yt by (apply Rmult_le_pos; lra).
    assert (u * (y * y) <= 0.0011 * (y * t)) as uyy.
    { assert (y <= 1.01 * w) as yw by (unfold y; lra). assert (u * y <= u * (1.01 * w)) by (apply Rmult_le_compat_l; lra).
      replace (u * (y * y)) with (u * y * y) by ring. apply Rle_trans with (0.00101 * t * y); [apply Rmult_le_compat_r; lra | lra]. }
    assert (0 <= Rc * square) as Rs0 by (apply Rmult_le_pos; lra). assert (0 <= m * m) as mm0 by apply Rle_0_sqr.
    unfold Lanes.rounds in Hmm, Hrs. rewrite (Rabs_pos_eq (m * m)) in Hmm by assumption.
    rewrite (Rabs_pos_eq (Rc * square)) in Hrs by assumption.
    apply Rabs_le_inv in Hmm, Hrs.
    assert (Rc * square * (1 + u) <= y * y * (N0 * N0 * (1 + 3.1 * u)) * (1 + u)) as top' by (apply Rmult_le_compat_r; lra).
    assert (N0 * (y + 6.2 * t) * (N0 * (y + 6.2 * t)) * (1 - u) <= m * m * (1 - u)) as bottom' by (apply Rmult_le_compat_r; lra).
    set (M := N0 * N0) in *.
    assert (2 * eta <= 0.1 * (M * (t * t))) as room.
    { assert (u * u * (u * W) <= M * (t * t)) as big.
      { rewrite tt. apply Rmult_le_compat_r; [rewrite <- tt; lra |]. assert (0 <= u * u) by (apply Rmult_le_pos; lra). lra. }
      lra. }
    assert (y * y * (1 + 3.1 * u) * (1 + u) <= y * y + 0.01 * (y * t)) as t1.
    { assert (0 <= u * (y * y)) as p by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). pose proof (small _ p). lra. }
    assert (y * y + 12 * (y * t) + 38 * (t * t) <= (y + 6.2 * t) * (y + 6.2 * t) * (1 - u)) as t2.
    { pose proof (small _ yt). pose proof (small (t * t) ltac:(lra)). lra. }
    apply (Rmult_le_compat_l M) in t1, t2; try lra.
    assert (0 < M * (t * t)) by (apply Rmult_lt_0_compat; lra). assert (0 <= M * (y * t)) by (apply Rmult_le_pos; lra).
    replace (y * y * (M * (1 + 3.1 * u)) * (1 + u)) with (M * (y * y * (1 + 3.1 * u) * (1 + u))) in top' by ring.
    replace (N0 * (y + 6.2 * t) * (N0 * (y + 6.2 * t)) * (1 - u)) with (M * ((y + 6.2 * t) * (y + 6.2 * t) * (1 - u))) in bottom' by
      (unfold M; ring). lra.
  Qed.
End Plane.
