(* The certified predicate's coarse step as a program, in binary32 and binary64: its answers are right. *)
From Coq Require Import Reals ZArith Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Exact Reduced Expression Format Lanes Certified.
Open Scope R_scope.

(* The program over any rounding, from a query's own numbers: the operations of
   kernel/sphere_triangle/certified/coarse_step-inl.h in the same order. *)
Section Program.
  Variable rnd : R -> R.
  Variable fused : bool.
  Definition rounded_sub (v w : vec) := Vec (rnd (cx v - cx w)) (rnd (cy v - cy w)) (rnd (cz v - cz w)).
  Definition rounded_dot (v w : vec) :=
    if fused then rnd (rnd (rnd (cx v * cx w) + cy v * cy w) + cz v * cz w)
    else rnd (rnd (rnd (cx v * cx w) + rnd (cy v * cy w)) + rnd (cz v * cz w)).
  Definition rounded_minus_product (x y z : R) := if fused then rnd (x - y * z) else rnd (x - rnd (y * z)).
  Definition rounded_cross (v w : vec) := Vec
    (rounded_minus_product (rnd (cy v * cz w)) (cz v) (cy w)) (rounded_minus_product (rnd (cz v * cx w)) (cx v) (cz w))
    (rounded_minus_product (rnd (cx v * cy w)) (cy v) (cx w)).

  Variables (u : R) (a b c p : vec) (r : R).
  Let square v := rounded_dot v v.
  Let aa := square (rounded_sub a p).
  Let bb := square (rounded_sub b p).
  Let cc := square (rounded_sub c p).
  Let rr := rnd (r * r).
  Let e1 := square (rounded_sub b a).
  Let e2 := square (rounded_sub c b).
  Let e3 := square (rounded_sub a c).
  Definition coarse_S := rnd (rnd (rnd (aa + bb) + cc) + rr).
  Definition coarse_E := rnd (rnd (rnd (e1 + e2) + e3) + rnd (/ 1048576 * coarse_S)).
  Definition coarse_threshold (K : comparison) : R :=
    let SE := rnd (coarse_S * coarse_E) in
    match K with
    | plane_radius => rnd (coarse_degree_6 * u * rnd (SE * coarse_E))
    | edge_ab_radius | edge_ab_side_c | edge_bc_radius | edge_bc_side_a | edge_ca_radius | edge_ca_side_b =>
      rnd (coarse_degree_4 * u * SE)
    | _ => rnd (coarse_degree_2 * u * coarse_S)
    end.
  Let V := rounded_cross (rounded_sub a c) (rounded_sub b a).
  Let normal_of (from to : vec) := rounded_cross (rounded_sub from p) (rounded_sub to from).
  Let edge_radius_of (from to : vec) (e : R) := rounded_minus_product (square (normal_of from to)) rr e.
  Let edge_side_of (from to : vec) := - rounded_dot (normal_of from to) V.
  Definition coarse_margin (K : comparison) : R :=
    match K with
    | plane_radius => let D := rounded_dot (rounded_sub a p) V in rounded_minus_product (rnd (D * D)) rr (square V)
    | vertex_a_radius => rnd (aa - rr)
    | vertex_a_side_b => rnd (rnd (bb - aa) - e1)
    | vertex_a_side_c => rnd (rnd (cc - aa) - e3)
    | vertex_b_radius => rnd (bb - rr)
    | vertex_b_side_a => rnd (- rnd (bb - aa) - e1)
    | vertex_b_side_c => rnd (rnd (cc - bb) - e2)
    | vertex_c_radius => rnd (cc - rr)
    | vertex_c_side_a => rnd (- rnd (cc - aa) - e3)
    | vertex_c_side_b => rnd (- rnd (cc - bb) - e2)
    | edge_ab_radius => edge_radius_of a b e1
    | edge_ab_side_c => edge_side_of a b
    | edge_bc_radius => edge_radius_of b c e2
    | edge_bc_side_a => edge_side_of b c
    | edge_ca_radius => edge_radius_of c a e3
    | edge_ca_side_b => edge_side_of c a
    end.
End Program.

(* The exact margins of the reduced form; those of the vertices' sides are doubled. *)
Definition exact_margin (a b c p : vec) (r : R) (K : comparison) : R :=
  let sides := reduced (sub a p) (sub b p) (sub c p) (r * r) K in
  match K with
  | vertex_a_side_b | vertex_a_side_c | vertex_b_side_a | vertex_b_side_c | vertex_c_side_a | vertex_c_side_b => 2 * (fst sides - snd sides)
  | _ => fst sides - snd sides
  end.

Lemma dot_is_computed u eta rnd (rounding : forall x, rounds u eta x (rnd x)) fused X Y :
  computed_dot u eta X Y (rounded_dot rnd fused X Y).
Proof.
  unfold rounded_dot, computed_dot. destruct fused.
  - exists (rnd (cx X * cx Y)), (rnd (rnd (cx X * cx Y) + cy X * cy Y)). split; [apply rounding | split; left; apply rounding].
  - exists (rnd (cx X * cx Y)), (rnd (rnd (cx X * cx Y) + rnd (cy X * cy Y))).
    split; [apply rounding |]. split; right; eexists; split; apply rounding.
Qed.
Lemma minus_product_is_computed u eta rnd (rounding : forall x, rounds u eta x (rnd x)) fused x y z :
  computed_minus_product u eta x y z (rounded_minus_product rnd fused x y z).
Proof.
  unfold rounded_minus_product, computed_minus_product. destruct fused; [left; apply rounding |].
  right. eexists; split; apply rounding.
Qed.
Lemma cross_is_computed u eta rnd (rounding : forall x, rounds u eta x (rnd x)) fused X Y :
  computed_cross u eta X Y (rounded_cross rnd fused X Y).
Proof.
  unfold rounded_cross, computed_cross, computed_difference. cbn [cx cy cz].
  pose proof (minus_product_is_computed u eta rnd rounding fused) as H. unfold computed_minus_product in H.
  repeat split; eexists; (split; [apply rounding | apply H]).
Qed.

Lemma normal_cross A B C : cross (sub A C) (sub B A) = normal A B C. Proof. unfold normal. vec_ring. Qed.
Lemma normal_turned A B C : normal B C A = normal A B C. Proof. unfold normal. vec_ring. Qed.
Lemma cross_edge A B : cross A (sub B A) = cross A B. Proof. vec_ring. Qed.
Lemma add_edge A B : add A (sub B A) = B. Proof. vec_ring. Qed.
Lemma dot_turned A B : dot (sub A B) (sub A B) = dot (sub B A) (sub B A). Proof. vec_ring. Qed.
Lemma dot_edge A B : dot A (sub B A) = dot A B - dot A A. Proof. vec_ring. Qed.

(* Vectors of numbers of a format. *)
Definition in_format (prec emin : Z) (v : vec) :=
  generic_format radix2 (FLT_exp emin prec) (cx v) /\ generic_format radix2 (FLT_exp emin prec) (cy v) /\
  generic_format radix2 (FLT_exp emin prec) (cz v).

Section Format.
  Variables prec emin : Z.
  Hypothesis prec20 : (20 <= prec)%Z.
  Let rnd := round radix2 (FLT_exp emin prec) ZnearestE.
  Let u := Expression.u prec.
  Let eta := half_least emin.
  Notation in_format := (in_format prec emin).
  Variable least : R.
  Hypothesis least_positive : 0 < least.
  Hypothesis tiny_2 : eta <= u / 1000000000000000000 * (0.9 * least).
  Hypothesis tiny_6 : eta <= u / 1000000000000000000 * (0.9 * least) ^ 3.
  Variables (fused : bool) (a b c p : vec) (r : R).
  Hypothesis formats : in_format a /\ in_format b /\ in_format c /\ in_format p.
  Hypothesis large_enough : least <= coarse_S rnd fused a b c p r.

  Lemma u_small : 0 <= u <= / 1048576.
  Proof using prec20.
    unfold u, Expression.u. split; [apply bpow_ge_0 |]. apply Rle_trans with (bpow radix2 (-20)); [apply bpow_le; lia | cbn; lra].
  Qed.
  Lemma eta_positive : 0 <= eta.
  Proof using emin. unfold eta, half_least. pose proof (bpow_ge_0 radix2 emin). lra. Qed.
  Lemma rounding x : rounds u eta x (rnd x).
  Proof using emin prec20. apply rnd_error. lia. Qed.
  Lemma leaf_difference v w : in_format v -> in_format w -> leaf_of u (sub v w) (rounded_sub rnd v w).
  Proof using prec20.
    intros (vx & vy & vz) (wx & wy & wz). repeat split.
    - exact (proj1 (Format.difference_error prec emin ltac:(lia) _ _ vx wx)).
    - exact (proj1 (Format.difference_error prec emin ltac:(lia) _ _ vy wy)).
    - exact (proj1 (Format.difference_error prec emin ltac:(lia) _ _ vz wz)).
  Qed.
  Lemma same_edge v w : sub w v = sub (sub w p) (sub v p).
  Proof using Type. destruct v as [v1 v2 v3], w as [w1 w2 w3]. unfold sub. cbn [cx cy cz]. f_equal; ring. Qed.
  Lemma moved v w : in_format v -> in_format w -> leaf_of u (sub (sub w p) (sub v p)) (rounded_sub rnd w v).
  Proof using prec20. intros. rewrite <- same_edge. apply leaf_difference; assumption. Qed.

  Let S := dot (sub a p) (sub a p) + dot (sub b p) (sub b p) + dot (sub c p) (sub c p) + r * r.

  Lemma square_at_most v : in_format v ->
    Rabs (rounded_dot rnd fused (rounded_sub rnd v p) (rounded_sub rnd v p)) <= 1.01 * dot (sub v p) (sub v p) + 6 * eta.
  Proof using formats prec20.
    intros fv. pose proof u_small as us. pose proof eta_positive as e0. destruct (leaf_difference v p fv ltac:(tauto)) as (lx & ly & lz).
    destruct (leaf_product u us _ _ _ _ lx lx) as [_ x]. destruct (leaf_product u us _ _ _ _ ly ly) as [_ y].
    destruct (leaf_product u us _ _ _ _ lz lz) as [_ z].
    pose proof (dot_error u eta us e0 _ _ _ (dot_is_computed u eta rnd rounding fused (rounded_sub rnd v p) (rounded_sub rnd v p))) as off.
    rewrite sizes_square in off. set (X := rounded_sub rnd v p) in *.
    assert (dot X X <= 1.001 * dot (sub v p) (sub v p)) as grown.
    { rewrite <- !sizes_square. unfold sizes. lra. }
    pose proof (dot_self_nonneg X) as X0. pose proof (small u us _ X0). pose proof (dot_self_nonneg (sub v p)). apply Rabs_le_inv in off. apply Rabs_le. lra.
  Qed.
  Lemma sum_at_most x y : Rabs x <= y -> Rabs (rnd x) <= 1.00001 * y + eta.
  Proof using emin prec20 u.
    intros H. pose proof (rounding x) as off. unfold Lanes.rounds in off. pose proof u_small as us. pose proof (small u us _ (Rabs_pos x)).
    replace (rnd x) with (x + (rnd x - x)) by ring. eapply Rle_trans; [apply Rabs_triang |]. lra.
  Qed.

  Lemma S_large : 0.9 * least <= S.
  Proof using formats large_enough least_positive prec20 tiny_2.
    destruct formats as (fa & fb & fc & _). pose proof (square_at_most a fa) as ha. pose proof (square_at_most b fb) as hb. pose proof (square_at_most c fc) as hc.
    pose proof (sum_at_most (r * r) (r * r) ltac:(rewrite Rabs_pos_eq by apply Rle_0_sqr; lra)) as hr.
    unfold coarse_S in large_enough. pose proof eta_positive.
    match type of large_enough with _ <= rnd (rnd (rnd (?x + ?y) + ?z) + ?t) =>
      pose proof (sum_at_most (x + y) _ ltac:(eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat; [exact ha | exact hb]])) as h1;
      pose proof (sum_at_most (rnd (x + y) + z) _ ltac:(eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat; [exact h1 | exact hc]])) as h2;
      pose proof (sum_at_most (rnd (rnd (x + y) + z) + t) _ ltac:(eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat; [exact h2 | exact hr]])) as h3
    end.
    pose proof (Rle_trans _ _ _ large_enough (Rle_trans _ _ _ (Rle_abs _) h3)) as bound.
    pose proof (dot_self_nonneg (sub a p)). pose proof (dot_self_nonneg (sub b p)). pose proof (dot_self_nonneg (sub c p)). pose proof (Rle_0_sqr r).
    unfold Rsqr in *. pose proof u_small.
    assert (u / 1000000000000000000 * (0.9 * least) <= 0.0001 * least) by nra. unfold S. lra.
  Qed.

  Let s := sqrt S.
  Lemma s_facts : 0 < s /\ s ^ 2 = S /\ eta <= kappa u * s ^ 2 /\ eta <= kappa u * s ^ 6.
  Proof using formats large_enough least_positive prec20 tiny_2 tiny_6.
    pose proof S_large as large. assert (0 < S) as S0 by lra. assert (s ^ 2 = S) as square.
    { unfold s. cbn [pow]. rewrite Rmult_1_r. apply sqrt_sqrt. lra. }
    assert (s ^ 6 = S ^ 3) as sixth by (rewrite <- square; ring). rewrite sixth, square. pose proof u_small.
    assert (0 <= u / 1000000000000000000) by lra. unfold kappa.
    repeat split; [apply sqrt_lt_R0; assumption | |].
    - eapply Rle_trans; [exact tiny_2 |]. apply Rmult_le_compat_l; assumption.
    - eapply Rle_trans; [exact tiny_6 |]. apply Rmult_le_compat_l; [assumption |]. apply pow_incr. lra.
  Qed.

  (* Each margin is within its threshold. *)
  Theorem coarse_within K : Rabs (coarse_margin rnd fused a b c p r K - exact_margin a b c p r K) <= coarse_threshold rnd fused u a b c p r K.
  Proof using formats large_enough least_positive prec20 tiny_2 tiny_6.
    destruct s_facts as (s0 & square & tiny & tiny'). destruct formats as (fa & fb & fc & fp).
    pose proof u_small as us. pose proof eta_positive as e0.
    pose proof (leaf_difference a p fa fp) as la. pose proof (leaf_difference b p fb fp) as lb. pose proof (leaf_difference c p fc fp) as lc.
    pose proof (moved a b fa fb) as lab. pose proof (moved b c fb fc) as lbc. pose proof (moved c a fc fa) as lca.
    pose proof (fun X Y => dot_is_computed u eta rnd rounding fused X Y) as dots.
    pose proof (fun X Y => cross_is_computed u eta rnd rounding fused X Y) as crosses.
    pose proof (fun x y z => minus_product_is_computed u eta rnd rounding fused x y z) as products.
    pose proof rounding as rounds_to.
    pose proof (fun x X => radius_2 u eta us e0 s s0 tiny tiny' (sub a p) (sub b p) (sub c p) r square _ _ _ _ _ _ _ la lb lc
      (dots _ _) (dots _ _) (dots _ _) (rounds_to _) _ _ _ (rounds_to _) (rounds_to _) (rounds_to _) _ (rounds_to _) x X) as radius.
    pose proof (fun x y X Y e D M => side_2 u eta us e0 s s0 tiny tiny' (sub a p) (sub b p) (sub c p) r square _ _ _ _ _ _ _ la lb lc
      (dots _ _) (dots _ _) (dots _ _) (rounds_to _) _ _ _ (rounds_to _) (rounds_to _) (rounds_to _) _ (rounds_to _) x y X Y e D M) as side.
    pose proof (fun x y X Y N nn e M => edge_radius_4 u eta us e0 s s0 tiny tiny' (sub a p) (sub b p) (sub c p) r square _ _ _ _ _ _ _ _ _ _ _ _ _
      la lb lc lab lbc lca (dots _ _) (dots _ _) (dots _ _) (rounds_to _) (dots _ _) (dots _ _) (dots _ _)
      _ _ _ _ _ _ _ (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _)
      _ _ (rounds_to _) (rounds_to _) x y X Y N nn e M) as edge.
    pose proof (fun x y X Y N M => edge_side_4 u eta us e0 s s0 tiny tiny' (sub a p) (sub b p) (sub c p) r square _ _ _ _ _ _ _ _ _ _ _ _ _
      la lb lc lab lbc lca (dots _ _) (dots _ _) (dots _ _) (rounds_to _) (dots _ _) (dots _ _) (dots _ _)
      _ _ _ _ _ _ _ (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _)
      _ _ (rounds_to _) (rounds_to _) _ (crosses _ _) x y X Y N M) as edge_side.
    pose proof (fun D lhs vv M => plane_6 u eta us e0 s s0 tiny tiny' (sub a p) (sub b p) (sub c p) r square _ _ _ _ _ _ _ _ _ _ _ _ _
      la lb lc lab lbc lca (dots _ _) (dots _ _) (dots _ _) (rounds_to _) (dots _ _) (dots _ _) (dots _ _)
      _ _ _ _ _ _ _ (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _)
      _ _ _ (rounds_to _) (rounds_to _) (rounds_to _) _ (crosses _ _) D lhs vv M) as plane.
    pose proof (fun x X leaf => leaf_square u eta us e0 s s0 tiny tiny' (sub a p) (sub b p) (sub c p) r square x X _ leaf (dots X X)) as squares.
    unfold exact_margin, reduced, published, plane_sides, vertex_radius_sides, vertex_side_sides, reduced_radius_sides, reduced_side_sides,
      offset, length2; cbn [fst snd].
    unfold coarse_margin, coarse_threshold.
    rewrite !normal_cross in plane.
    set (A := sub a p) in *. set (B := sub b p) in *. set (C := sub c p) in *.
    pose proof (dot_self_nonneg A) as A0. pose proof (dot_self_nonneg B) as B0. pose proof (dot_self_nonneg C) as C0.
    pose proof (Rle_0_sqr r) as r0. unfold Rsqr in r0.
    pose proof (edge_twice A B) as tab. pose proof (edge_twice B C) as tbc. pose proof (edge_twice C A) as tca.
    pose proof (edge_share A B C) as sab. pose proof (edge_share B C A) as sbc. pose proof (edge_share C A B) as sca.
    pose proof (squares _ _ la ltac:(lra)) as qa. pose proof (squares _ _ lb ltac:(lra)) as qb. pose proof (squares _ _ lc ltac:(lra)) as qc.
    pose proof (squares _ _ lab ltac:(lra)) as qab. pose proof (squares _ _ lbc ltac:(lra)) as qbc. pose proof (squares _ _ lca ltac:(lra)) as qca.
    destruct K; cbn [fst snd].
    - exact (plane _ _ _ _ (dots _ _) (rounds_to _) (dots _ _) (products _ _ _)).
    - apply (radius A _ _ ltac:(lra) qa (rounds_to _)).
    - rewrite <- dot_edge. apply (side A B _ _ _ _ _ ltac:(lra) ltac:(lra) qa qb qab (or_introl (rounds_to _)) (rounds_to _)).
    - rewrite <- dot_edge. rewrite dot_turned in qca.
      apply (side A C _ _ _ _ _ ltac:(lra) ltac:(rewrite dot_turned; lra) qa qc qca (or_introl (rounds_to _)) (rounds_to _)).
    - apply (radius B _ _ ltac:(lra) qb (rounds_to _)).
    - rewrite <- dot_edge. rewrite dot_turned in qab.
      apply (side B A _ _ _ _ _ ltac:(lra) ltac:(rewrite dot_turned; lra) qb qa qab
        (or_intror (ex_intro _ _ (conj eq_refl (rounds_to _)))) (rounds_to _)).
    - rewrite <- dot_edge. apply (side B C _ _ _ _ _ ltac:(lra) ltac:(lra) qb qc qbc (or_introl (rounds_to _)) (rounds_to _)).
    - apply (radius C _ _ ltac:(lra) qc (rounds_to _)).
    - rewrite <- dot_edge.
      apply (side C A _ _ _ _ _ ltac:(lra) ltac:(lra) qc qa qca (or_intror (ex_intro _ _ (conj eq_refl (rounds_to _)))) (rounds_to _)).
    - rewrite <- dot_edge. rewrite dot_turned in qbc.
      apply (side C B _ _ _ _ _ ltac:(lra) ltac:(rewrite dot_turned; lra) qc qb qbc
        (or_intror (ex_intro _ _ (conj eq_refl (rounds_to _)))) (rounds_to _)).
    - rewrite <- cross_edge.
      apply (edge A (sub B A) _ _ _ _ _ _ la lab (crosses _ _) (dots _ _) ltac:(rewrite add_edge; lra) ltac:(lra) qab (products _ _ _)).
    - rewrite Rminus_0_l, <- cross_edge, <- normal_cross. apply (edge_side A (sub B A) _ _ _ _ la lab (crosses _ _) (dots _ _) ltac:(rewrite add_edge; lra)).
    - rewrite <- cross_edge.
      apply (edge B (sub C B) _ _ _ _ _ _ lb lbc (crosses _ _) (dots _ _) ltac:(rewrite add_edge; lra) ltac:(lra) qbc (products _ _ _)).
    - rewrite Rminus_0_l, <- cross_edge, normal_turned, <- normal_cross.
      apply (edge_side B (sub C B) _ _ _ _ lb lbc (crosses _ _) (dots _ _) ltac:(rewrite add_edge; lra)).
    - rewrite <- cross_edge.
      apply (edge C (sub A C) _ _ _ _ _ _ lc lca (crosses _ _) (dots _ _) ltac:(rewrite add_edge; lra) ltac:(lra) qca (products _ _ _)).
    - rewrite Rminus_0_l, <- cross_edge, (normal_turned B C A), (normal_turned A B C), <- normal_cross.
      apply (edge_side C (sub A C) _ _ _ _ lc lca (crosses _ _) (dots _ _) ltac:(rewrite add_edge; lra)).
  Qed.

  Lemma margin_sign K : (0 < exact_margin a b c p r K <-> fst (reduced (sub a p) (sub b p) (sub c p) (r * r) K) > snd (reduced (sub a p) (sub b p) (sub c p) (r * r) K)) /\
    (0 <= exact_margin a b c p r K <-> fst (reduced (sub a p) (sub b p) (sub c p) (r * r) K) >= snd (reduced (sub a p) (sub b p) (sub c p) (r * r) K)).
  Proof using Type. unfold exact_margin. set (sides := reduced _ _ _ _ _). destruct K; split; split; lra. Qed.

  Hypothesis r_nonneg : 0 <= r.
  Notation margin := (coarse_margin rnd fused a b c p r).
  Notation threshold := (coarse_threshold rnd fused u a b c p r).
  Theorem coarse_separated : some_axis (fun K => margin K > threshold K) -> separated a b c p r.
  Proof using formats large_enough least_positive prec20 r_nonneg tiny_2 tiny_6.
    intros H. apply reduced_exact; [assumption |]. revert H. apply some_axis_mono. intros K beyond.
    pose proof (coarse_within K) as near. apply Rabs_le_inv in near. pose proof (margin_sign K) as [strictly _].
    assert (0 < exact_margin a b c p r K) as positive by lra. apply strictly in positive. unfold nonstrict. destruct is_side; lra.
  Qed.
  Theorem coarse_contact : ~ some_axis (fun K => margin K >= - threshold K) -> ~ separated a b c p r.
  Proof using formats large_enough least_positive prec20 r_nonneg tiny_2 tiny_6.
    intros none apart. apply none. apply reduced_exact in apart; [| assumption]. revert apart. apply some_axis_mono. intros K holds.
    pose proof (coarse_within K) as near. apply Rabs_le_inv in near. pose proof (margin_sign K) as [_ weakly].
    assert (0 <= exact_margin a b c p r K) by (apply weakly; unfold nonstrict in holds; destruct is_side; lra). lra.
  Qed.
End Format.

(* The statement for a format and the least S of the step's range. *)
Definition coarse_never_lies (prec emin least : Z) : Prop := forall fused a b c p r,
  in_format prec emin a -> in_format prec emin b -> in_format prec emin c -> in_format prec emin p -> 0 <= r ->
  let rnd := round radix2 (FLT_exp emin prec) ZnearestE in
  let margin := coarse_margin rnd fused a b c p r in
  let threshold := coarse_threshold rnd fused (u prec) a b c p r in
  bpow radix2 least <= coarse_S rnd fused a b c p r ->
  (forall K, Rabs (margin K - exact_margin a b c p r K) <= threshold K) /\
  (some_axis (fun K => margin K > threshold K) -> separated a b c p r) /\
  (~ some_axis (fun K => margin K >= - threshold K) -> ~ separated a b c p r).

Lemma coarse_instance prec emin least : (20 <= prec)%Z -> (emin - 1 <= least - 61 - prec)%Z -> (emin - 1 <= 3 * least - 63 - prec)%Z ->
  coarse_never_lies prec emin least.
Proof.
  intros p20 low2 low6 fused a b c p r fa fb fc fp r0 rnd margin threshold large.
  assert (bpow radix2 (- prec) / 1000000000000000000 >= bpow radix2 (- prec) * bpow radix2 (-60)) as scale.
  { apply Rle_ge, Rmult_le_compat_l; [apply bpow_ge_0 |]. cbn. lra. }
  assert (half_least emin = bpow radix2 (emin - 1)) as half.
  { unfold half_least. replace (emin - 1)%Z with (emin + -1)%Z by lia. rewrite bpow_plus. change (bpow radix2 (-1)) with (/ 2). ring. }
  pose proof (bpow_gt_0 radix2 least) as l0. pose proof (bpow_gt_0 radix2 (- prec)) as u0.
  assert (bpow radix2 (-1) * bpow radix2 least <= 0.9 * bpow radix2 least) as nine by (apply Rmult_le_compat_r; [lra | cbn; lra]).
  pose proof (bpow_gt_0 radix2 (-1)) as b1. pose proof (bpow_gt_0 radix2 (-60)) as b60.
  assert (half_least emin <= u prec / 1000000000000000000 * (0.9 * bpow radix2 least)) as tiny_2.
  { rewrite half. unfold u. apply Rle_trans with (bpow radix2 (- prec) * bpow radix2 (-60) * (bpow radix2 (-1) * bpow radix2 least)).
    - rewrite <- !bpow_plus. apply bpow_le. lia.
    - apply Rmult_le_compat; try lra; apply Rmult_le_pos; lra. }
  assert (half_least emin <= u prec / 1000000000000000000 * (0.9 * bpow radix2 least) ^ 3) as tiny_6.
  { rewrite half. unfold u. apply Rle_trans with (bpow radix2 (- prec) * bpow radix2 (-60) * (bpow radix2 (-1) * bpow radix2 least) ^ 3).
    - cbn [pow]. rewrite Rmult_1_r, <- !bpow_plus. apply bpow_le. lia.
    - apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply pow_le, Rmult_le_pos; lra |].
      apply pow_incr. split; [apply Rmult_le_pos; lra | assumption]. }
  repeat split.
  - intros K. apply (coarse_within prec emin p20 (bpow radix2 least) l0 tiny_2 tiny_6 fused a b c p r (conj fa (conj fb (conj fc fp))) large).
  - apply (coarse_separated prec emin p20 (bpow radix2 least) l0 tiny_2 tiny_6 fused a b c p r (conj fa (conj fb (conj fc fp))) large r0).
  - apply (coarse_contact prec emin p20 (bpow radix2 least) l0 tiny_2 tiny_6 fused a b c p r (conj fa (conj fb (conj fc fp))) large r0).
Qed.

(* binary32 and binary64; overflow is not covered here. *)
Theorem coarse_never_lies32 : coarse_never_lies 24 (-149) (-21).
Proof. apply coarse_instance; lia. Qed.
Theorem coarse_never_lies64 : coarse_never_lies 53 (-1074) (-300).
Proof. apply coarse_instance; lia. Qed.
