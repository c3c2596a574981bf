(* The conservative test in binary32 and binary64: its phantom contacts are at most 20 sqrt u M deep. *)
From Coq Require Import Reals ZArith Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Sat7 Complete Expression Format Lanes Certified CertifiedStep Conservative ConservativeStep Nearest
  Phantom PhantomPlane.
Open Scope R_scope.

Definition phantom_depth : R := 20.

(* The greatest distance of a vertex from the centre, or the radius. *)
Definition query_size (a b c p : vec) (r : R) := Rmax (Rmax (distance p a) (distance p b)) (Rmax (distance p c) r).

Lemma distance_norm p x : distance p x = norm (sub x p).
Proof. unfold distance, norm. f_equal. vec_ring. Qed.
Lemma combination_moved x y z a b c p : x + y + z = 1 ->
  sub (combination x y z a b c) p = combination x y z (sub a p) (sub b p) (sub c p).
Proof. intros sum. replace z with (1 - x - y) by lra. unfold combination. vec_ring. Qed.
Lemma combination_difference x y z a b c A B C :
  sub (combination x y z a b c) (combination x y z A B C) = combination x y z (sub a A) (sub b B) (sub c C).
Proof. unfold combination. vec_ring. Qed.
Lemma combination_scaled x y z a b c k : scale (combination x y z a b c) k = combination (x * k) (y * k) (z * k) a b c.
Proof. unfold combination. vec_ring. Qed.
Lemma edge_combination A B C s : between A B s = combination (1 - s) s 0 A B C /\ between B C s = combination 0 (1 - s) s A B C /\
  between C A s = combination s 0 (1 - s) A B C.
Proof. unfold between, combination. repeat split; vec_ring. Qed.

Section Format.
  Variables prec emin least least_normal : Z.
  Hypothesis prec20 : (20 <= prec)%Z.
  Hypothesis low_2 : (emin - 1 <= least - prec - 20)%Z.
  Hypothesis low_4 : (emin - 1 <= 2 * (least - prec) - 17)%Z.
  Hypothesis low_3 : (emin - 1 <= - 3 * prec - 20)%Z.
  Hypothesis low_5 : (emin - 1 <= least - 3 * prec - 20)%Z.
  Hypothesis normal_5 : (least_normal <= 5 - 2 * prec)%Z.
  Let rnd := round radix2 (FLT_exp emin prec) ZnearestE.
  Let u := Expression.u prec.
  Let eta := half_least emin.
  Notation in_format := (in_format prec emin).
  Variables (a b c p : vec) (r : R).
  Hypothesis formats : in_format a /\ in_format b /\ in_format c /\ in_format p.
  Hypothesis r_nonneg : 0 <= r.
  Let W := conservative_W rnd a b c p r.
  Hypothesis large_enough : bpow radix2 least <= W.
  Let A := rounded_sub rnd a p.
  Let B := rounded_sub rnd b p.
  Let C := rounded_sub rnd c p.
  Let w := sqrt W.
  Let t := sqrt (u * W).
  Let urange := u_range prec prec20.
  Let u_weak : 0 <= u <= / 1048576. Proof using urange. pose proof urange as H. fold u in H. lra. Qed.
  Let W0 := W_positive prec emin least a b c p r large_enough.
  Let eta0 := eta_positive emin.
  Let tiny_2 := underflow_2 prec emin least prec20 low_2 a b c p r large_enough.
  Let tiny_4 := underflow_4 prec emin least prec20 low_4 a b c p r large_enough.
  Let greatest := W_greatest prec emin a b c p r.
  Let dots X Y : computed_dot u eta X Y (rounded_dot rnd false X Y).
  Proof using emin prec20. apply dot_is_computed, (rounding prec emin prec20). Qed.
  Let rounds_to x : rounds u eta x (rnd x).
  Proof using emin prec20. apply (rounding prec emin prec20). Qed.
  Let leaf v : in_format v -> leaf_of u (sub v p) (rounded_sub rnd v p).
  Proof using formats prec20. intros fv. apply (leaf_difference prec emin prec20); [assumption | apply formats]. Qed.
  Lemma rounded_in_format v x : in_format (rounded_sub rnd v x).
  Proof using prec20.
    assert (Valid_exp (FLT_exp emin prec)) as valid by (apply FLT_exp_valid; unfold Prec_gt_0; lia).
    repeat split; apply generic_format_round; auto using valid_rnd_N.
  Qed.

  (* Underflow is far below powers of u. *)
  Lemma u3 : bpow radix2 (- 3 * prec) = u * u * u.
  Proof using Type. unfold u, Expression.u. rewrite <- !bpow_plus. f_equal. lia. Qed.
  Lemma small_factor x : 0 <= x -> bpow radix2 (-20) * x <= / 1000000 * x.
  Proof using Type. intros x0. apply Rmult_le_compat_r; [assumption | cbn; lra]. Qed.
  Lemma tiny_3 : eta <= / 1000000 * (u * u * u).
  Proof using low_3 urange.
    pose proof urange as [u0 _]. fold u in u0. rewrite <- u3. eapply Rle_trans; [| apply small_factor, bpow_ge_0].
    apply (eta_below emin) with (- 3 * prec)%Z; [lia | apply Rle_refl].
  Qed.
  Lemma tiny_5 : eta <= / 1000000 * (u * u * (u * W)).
  Proof using W0 low_5 urange.
    pose proof urange as [u0 _]. fold u in u0. pose proof W0 as W1. fold rnd W in W1.
    replace (u * u * (u * W)) with (u * u * u * W) by ring. rewrite <- u3.
    eapply Rle_trans; [| apply small_factor; apply Rmult_le_pos; [apply bpow_ge_0 | lra]].
    apply (eta_below emin) with (- 3 * prec + least)%Z; [lia |]. rewrite bpow_plus. apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption].
  Qed.
  Lemma tiny_1 : eta <= / 1000000 * u.
  Proof using low_3 u_weak.
    pose proof tiny_3 as H. pose proof urange as [u0 u1]. fold u in u0, u1. assert (u * u <= 1) as uu by nra.
    assert (u * u * u <= 1 * u) by (apply Rmult_le_compat_r; lra). lra.
  Qed.

  Let sizes_known X : vertex A B C X -> dot X X <= 1.00001 * W /\ norm X <= 1.00001 * sqrt W.
  Proof using W0 dots eta0 greatest tiny_2 urange. apply (vertex_size u eta urange eta0 A B C _ _ _ _ W (dots _ _) (dots _ _) (dots _ _) greatest W0 tiny_2). Qed.
  Let rr_near : r * r <= 1.00001 * W /\ Rabs (rnd (r * r) - r * r) <= 1.0001 * (u * W).
  Proof using W0 greatest r_nonneg rounds_to tiny_2 urange. apply (radius_size u eta urange r _ _ _ _ W r_nonneg (rounds_to _) greatest W0 tiny_2). Qed.

  (* Every point of the triangle as computed is at that distance or farther. *)
  Hypothesis far : forall x y z, 0 <= x -> 0 <= y -> 0 <= z -> x + y + z = 1 -> r + 19.9 * t <= norm (combination x y z A B C).

  Lemma edge_says X Y Z : vertex A B C X -> vertex A B C Y -> vertex A B C Z -> in_format X -> in_format Y ->
    r + 19.9 * t <= norm (star X Y) -> dot (star X Y) (star X Y) - 3 * (norm (star X Y) * t) <= dot (star X Y) Z ->
    let product := rounded_dot rnd false in
    conservative_edge rnd u a b c p r X (rounded_sub rnd Y X) (product X X) (product X Y) (product Y Y) (product X Z) (product Y Z).
  Proof using low_3 low_5 rr_near sizes_known tiny_4 u_weak.
    intros vX vY vZ fX fY away third product. destruct (star_nearest X Y) as [sX sY].
    destruct (t_facts u urange W W0) as (w0 & ww & _). fold w in w0, ww.
    assert (norm (sub (between X Y (conservative_share rnd X (rounded_sub rnd Y X))) (star X Y)) <= 30 * (u * w)) as close.
    { unfold conservative_share. fold product. set (at_ := if Rlt_dec _ _ then _ else _).
      apply (share_near u eta w urange eta0 w0 tiny_1) with (rounded_sub rnd Y X) (product (rounded_sub rnd Y X) (rounded_sub rnd Y X))
        (product X (rounded_sub rnd Y X)).
      - replace (u * (u * w) * (u * w)) with (u * u * (u * (w * w))) by ring. rewrite ww. exact tiny_5.
      - apply sizes_known. exact vX.
      - apply sizes_known. exact vY.
      - apply (leaf_difference prec emin prec20); assumption.
      - apply dots.
      - apply dots.
      - intros e0. unfold at_. destruct Rlt_dec; [apply rounds_to | lra].
      - intros e0. unfold at_. destruct Rlt_dec; [lra | reflexivity]. }
    unfold conservative_edge. fold product W. set (s := conservative_share rnd X (rounded_sub rnd Y X)) in *.
    match goal with |- 0 < rnd (Rmin (Rmin ?x ?y) ?z - ?e) /\ _ => destruct (least_of x y z) as [_ one] end.
    apply (edge_deep u eta urange eta0 A B C r _ W _ _ _ r_nonneg W0 tiny_2 tiny_4 sizes_known rr_near (rounds_to _) (rounds_to _)
      (rounds_to _) X Y Z
      _ _ _ _ _ s _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (star X Y) vX vY vZ (share_range rnd X _)
      (dots _ _) (dots _ _) (dots _ _) (dots _ _) (dots _ _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _)
        (rounds_to _)
      (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) (rounds_to _) one (rounds_to _) (rounds_to _)
        (rounds_to _)
      close away sX sY third).
  Qed.

  Lemma plane_says longest : dot (sub A C) (sub A C) <= longest -> dot (sub B A) (sub B A) <= longest ->
    9 * (t * t) * longest < dot (normal A B C) (normal A B C) -> good_face A B C ->
      conservative_plane rnd u (bpow radix2 least_normal) a b c p r.
  Proof using far low_3 low_5 normal_5 rr_near sizes_known u_weak.
    intros la lb thick (fa & fb & fc). rewrite <- (normal_cross A B C) in thick. set (V := cross (sub A C) (sub B A)) in *.
    destruct (t_facts u urange W W0) as (w0 & ww & t0 & tt & _). fold w t in w0, ww, t0, tt.
    pose proof (dot_self_nonneg (sub A C)) as L0.
    assert (0 < dot V V) as V0 by (assert (0 <= 9 * (t * t) * longest) by (repeat apply Rmult_le_pos; lra); lra).
    pose proof (lam_total A B C) as total. rewrite <- (normal_cross A B C) in total. fold V in total.
    pose proof (face_point A B C) as foot. rewrite <- (normal_cross A B C) in foot. fold V in foot.
    assert (offset A B C = dot A V) as od by (unfold offset; rewrite <- (normal_cross A B C); reflexivity). rewrite od in foot.
    assert ((r + 19.9 * t) * norm V <= Rabs (dot A V)) as high.
    { set (i := / dot V V). assert (0 < i) as i0 by (apply Rinv_0_lt_compat; assumption).
      pose proof (far (lam B C A * i) (lam C A B * i) (lam A B C * i) ltac:(apply Rmult_le_pos; lra) ltac:(apply Rmult_le_pos;
        lra) ltac:(apply Rmult_le_pos; lra)) as away.
      rewrite <- combination_scaled, foot in away. specialize (away ltac:(rewrite <- !Rmult_plus_distr_r, total; unfold i; field; lra)).
      rewrite norm_scaled in away by lra.
      assert (norm (scale V (dot A V)) = Rabs (dot A V) * norm V) as size.
      { destruct (Rle_lt_dec 0 (dot A V)) as [d0 | d0].
        - rewrite norm_scaled by assumption. rewrite Rabs_pos_eq by assumption. reflexivity.
        - rewrite Rabs_left by assumption. rewrite <- norm_scaled by lra. unfold norm. f_equal. generalize (dot A V). clear. intros.
        destruct V. unfold dot, scale. cbn. ring. }
      rewrite size in away. assert (0 < norm V) as n0 by (apply sqrt_lt_R0; assumption).
      assert (norm V * norm V = dot V V) as NN by apply norm_square.
      apply (Rmult_le_compat_r (norm V)) in away; [| lra].
      replace (i * (Rabs (dot A V) * norm V) * norm V) with (Rabs (dot A V) * (i * (norm V * norm V))) in away by ring.
      rewrite NN in away. unfold i in away. rewrite Rinv_l, Rmult_1_r in away by lra. exact away. }
    set (k := bpow radix2 (1 - mag radix2 W)).
    assert (1 <= k * W) as kW.
    { pose proof W0 as W1. fold rnd W in W1. pose proof (bpow_mag_le radix2 W ltac:(lra)) as low. rewrite Rabs_pos_eq in low by lra.
      apply Rle_trans with (k * bpow radix2 (mag radix2 W - 1)); [| apply Rmult_le_compat_l; [apply bpow_ge_0 | assumption]].
      unfold k. rewrite <- bpow_plus. change 1 with (bpow radix2 0). apply bpow_le. lia. }
    set (n := conservative_normal rnd a b c p r). pose proof (rounded_in_format a p) as formA. pose proof (rounded_in_format b p) as formB.
    pose proof (rounded_in_format c p) as formC.
    fold A in formA. fold B in formB. fold C in formC.
    set (at_a := rounded_dot rnd false A n). set (at_b := rounded_dot rnd false B n). set (at_c := rounded_dot rnd false C n).
    set (side := fun x => if Rlt_dec at_a 0 then - x else x). set (m := Rmin (Rmin (side at_a) (side at_b)) (side at_c)).
    destruct (plane_deep u eta urange eta0 A B C r W _ r_nonneg W0 tiny_3 tiny_5 sizes_known
      (Rc_range u eta urange eta0 r _ W _ _ r_nonneg W0 tiny_2 rr_near (rounds_to _) (rounds_to _)) longest _ _ _ k n at_a at_b at_c
        (rounded_dot rnd false n n) m _ _
      (r + 19.9 * t) (leaf_difference prec emin prec20 _ _ formA formC) (leaf_difference prec emin prec20 _ _ formB formA)
      (cross_is_computed u eta rnd rounds_to false _ _) kW (rounds_to _) (rounds_to _) (rounds_to _) (dots _ _) (dots _ _) (dots _ _) (dots
        _ _) la lb thick
      (Rle_refl _) high (rounds_to _) (rounds_to _)) as (long & positive & beyond).
    - intros neg. unfold m, side. destruct Rlt_dec; [apply least_of | lra].
    - intros pos. unfold m, side. destruct Rlt_dec; [lra | apply least_of].
    - split; [| split; [exact positive | exact beyond]]. eapply Rle_trans; [| exact long].
      apply Rle_trans with (bpow radix2 (5 + (- prec + - prec))); [apply bpow_le; lia |]. rewrite !bpow_plus. fold (Expression.u prec).
      fold u.
      change (bpow radix2 5) with 32. assert (0 <= u * u) by (apply Rmult_le_pos; lra). lra.
  Qed.

  Lemma says_separated : conservative_separated rnd u (bpow radix2 least_normal) a b c p r.
  Proof using far low_3 low_5 normal_5 rr_near sizes_known tiny_4 u_weak w.
    pose proof (or_introl eq_refl : vertex A B C A) as vA. pose proof (or_intror (or_introl eq_refl) : vertex A B C B) as vB.
    pose proof (or_intror (or_intror eq_refl) : vertex A B C C) as vC.
    pose proof (rounded_in_format a p) as fA. pose proof (rounded_in_format b p) as fB. pose proof (rounded_in_format c p) as fC.
    fold A in fA. fold B in fB. fold C in fC.
    assert (away : r + 19.9 * t <= norm (star A B) /\ r + 19.9 * t <= norm (star B C) /\ r + 19.9 * t <= norm (star C A)).
    { unfold star. pose proof (best_range A B). pose proof (best_range B C). pose proof (best_range C A).
      rewrite (proj1 (edge_combination A B C _)), (proj1 (proj2 (edge_combination A B C _))), (proj2 (proj2 (edge_combination A B C _))).
      repeat split; apply far; lra. }
    destruct away as (sAB & sBC & sCA). destruct (t_facts u urange W W0) as (w0 & ww & t0 & tt & _). fold w t in w0, ww, t0, tt.
    pose proof (norm_nonneg (star A B)) as n1. pose proof (norm_nonneg (star B C)) as n2. pose proof (norm_nonneg (star C A)) as n3.
    assert (edge_ab : dot (star A B) (star A B) - 3 * (norm (star A B) * t) <= dot (star A B) C ->
      conservative_separated rnd u (bpow radix2 least_normal) a b c p r).
    { intros H. left. pose proof (edge_says A B C vA vB vC fA fB sAB H) as E. cbv zeta in E. rewrite (rounded_dot_swapped rnd A C) in E.
    exact E. }
    assert (edge_bc : dot (star B C) (star B C) - 3 * (norm (star B C) * t) <= dot (star B C) A ->
      conservative_separated rnd u (bpow radix2 least_normal) a b c p r).
    { intros H. right; left. pose proof (edge_says B C A vB vC vA fB fC sBC H) as E. cbv zeta in E.
    rewrite (rounded_dot_swapped rnd B A) in E. exact E. }
    assert (edge_ca : dot (star C A) (star C A) - 3 * (norm (star C A) * t) <= dot (star C A) B ->
      conservative_separated rnd u (bpow radix2 least_normal) a b c p r).
    { intros H. right; right; left. pose proof (edge_says C A B vC vA vB fC fA sCA H) as E. cbv zeta in E.
    rewrite (rounded_dot_swapped rnd C B) in E. exact E. }
    pose proof (Rmult_le_pos _ t n1 ltac:(lra)). pose proof (Rmult_le_pos _ t n2 ltac:(lra)). pose proof (Rmult_le_pos _ t n3 ltac:(lra)).
    (* A thick triangle: by the nearest feature. *)
    assert (thick : forall longest, length2 A B <= longest -> length2 C A <= longest ->
      9 * (t * t) * longest < dot (normal A B C) (normal A B C) -> conservative_separated rnd u (bpow radix2 least_normal) a b c p r).
    { intros longest lab lca more. pose proof (length2_nonneg A B).
      assert (has_area A B C) as area by (unfold has_area; assert (0 <= 9 * (t * t) * longest) by (repeat apply Rmult_le_pos; lra); lra).
      destruct (covering A B C area) as [face | [v | [v | [v | [e | [e | e]]]]]].
      - right; right; right. apply (plane_says longest); assumption.
      - apply edge_ab. pose proof (star_vertex _ _ _ v). lra.
      - apply edge_bc. pose proof (star_vertex _ _ _ v). lra.
      - apply edge_ca. pose proof (star_vertex _ _ _ v). lra.
      - apply edge_ab. pose proof (star_edge _ _ _ e). lra.
      - apply edge_bc. pose proof (star_edge _ _ _ e). lra.
      - apply edge_ca. pose proof (star_edge _ _ _ e). lra. }
    pose proof (length2_swap A B) as ab. pose proof (length2_swap B C) as bc. pose proof (length2_swap C A) as ca.
    assert (normal B C A = normal A B C /\ normal C A B = normal A B C) as [nb nc] by (split; unfold normal; clear; destruct A, B, C;
      unfold cross, sub; cbn; f_equal; ring).
    (* A thin triangle: by the longest edge. *)
    assert (cases : forall X Y Z, length2 X Z <= length2 X Y -> length2 Y Z <= length2 X Y -> normal X Y Z = normal A B C ->
      length2 A B <= length2 X Y -> length2 C A <= length2 X Y ->
      (dot (star X Y) (star X Y) - 3 * (norm (star X Y) * t) <= dot (star X Y) Z ->
        conservative_separated rnd u (bpow radix2 least_normal) a b c p r) ->
      conservative_separated rnd u (bpow radix2 least_normal) a b c p r).
    { intros X Y Z xz yz same lab lca says. destruct (Rle_lt_dec (dot (normal A B C) (normal A B C)) (9 * (t * t) * length2 X Y)) as [thin
      | more].
      - apply says. apply star_thin; try assumption. rewrite same. exact thin.
      - apply (thick (length2 X Y)); assumption. }
    destruct (Rle_lt_dec (length2 A B) (length2 B C)) as [x | x], (Rle_lt_dec (length2 B C) (length2 C A)) as [y | y],
      (Rle_lt_dec (length2 A B) (length2 C A)) as [z | z];
      first [ apply (cases A B C); [lra | lra | reflexivity | lra | lra | exact edge_ab]
            | apply (cases B C A); [lra | lra | exact nb | lra | lra | exact edge_bc]
            | apply (cases C A B); [lra | lra | exact nc | lra | lra | exact edge_ca] ].
  Qed.
End Format.

(* The statement for a format, the least W and the least square of the scaled normal of the test's range: a triangle
   none of whose points is as near as r + 20 sqrt u M is answered separated. *)
Definition conservative_phantoms_shallow (prec emin least least_normal : Z) : Prop := forall a b c p r,
  in_format prec emin a -> in_format prec emin b -> in_format prec emin c -> in_format prec emin p -> 0 <= r ->
  let rnd := round radix2 (FLT_exp emin prec) ZnearestE in
  bpow radix2 least <= conservative_W rnd a b c p r ->
  (forall X, in_triangle X a b c -> r + phantom_depth * sqrt (u prec) * query_size a b c p r < distance p X) ->
  conservative_separated rnd (u prec) (bpow radix2 least_normal) a b c p r.

Lemma shallow_instance prec emin least least_normal : (20 <= prec)%Z -> (emin - 1 <= least - prec - 20)%Z ->
  (emin - 1 <= 2 * (least - prec) - 17)%Z ->
  (emin - 1 <= - 3 * prec - 20)%Z -> (emin - 1 <= least - 3 * prec - 20)%Z -> (least_normal <= 5 - 2 * prec)%Z ->
  conservative_phantoms_shallow prec emin least least_normal.
Proof.
  intros p20 low_2 low_4 low_3 low_5 normal_5 a b c p r fa fb fc fp r0 rnd large far.
  apply (says_separated prec emin least least_normal p20 low_2 low_4 low_3 low_5 normal_5 a b c p r r0 large).
  set (u := Expression.u prec) in *. set (W := conservative_W rnd a b c p r) in *. set (M := query_size a b c p r) in *.
  set (A := rounded_sub rnd a p). set (B := rounded_sub rnd b p). set (C := rounded_sub rnd c p).
  pose proof (u_range prec p20) as urange. fold u in urange. destruct urange as [u0 u1].
  pose proof (W_positive prec emin least a b c p r large) as W0. fold rnd W in W0.
  pose proof (eta_positive emin) as eta0. pose proof (underflow_2 prec emin least p20 low_2 a b c p r large) as tiny. fold rnd W u in tiny.
  pose proof (rounding prec emin p20) as rounds_to. fold rnd u in rounds_to. set (eta := half_least emin) in *.
  assert (dots : forall X Y, computed_dot u eta X Y (rounded_dot rnd false X Y)) by (intros; apply dot_is_computed, rounds_to).
  assert (leaf : forall v, in_format prec emin v -> leaf_of u (sub v p) (rounded_sub rnd v p)).
  { intros v fv. apply (leaf_difference prec emin p20); assumption. }
  destruct (t_facts u (conj u0 u1) W W0) as (w0 & ww & t0 & tt & uwt). set (w := sqrt W) in *. set (t := sqrt (u * W)) in *.
  assert (t = sqrt u * w) as Gw by (unfold t, w; apply sqrt_mult; lra). set (G := sqrt u) in *. assert (0 < G) as G0 by (apply sqrt_lt_R0;
    lra).
  pose proof (distance_norm p a) as da. pose proof (distance_norm p b) as db. pose proof (distance_norm p c) as dc.
  assert (norm (sub a p) <= M /\ norm (sub b p) <= M /\ norm (sub c p) <= M /\ r <= M) as (Ma & Mb & Mc & Mr).
  { unfold M, query_size. rewrite <- da, <- db, <- dc. repeat split.
    - eapply Rle_trans; [| apply Rmax_l]. apply Rmax_l.
    - eapply Rle_trans; [| apply Rmax_l]. apply Rmax_r.
    - eapply Rle_trans; [| apply Rmax_r]. apply Rmax_l.
    - eapply Rle_trans; [| apply Rmax_r]. apply Rmax_r. }
  assert (0 <= M) as M0 by lra. assert (0 <= M * M) as MM by (apply Rmult_le_pos; assumption).
  pose proof (small u ltac:(lra) _ MM) as uMM. pose proof (small u ltac:(lra) _ M0) as uM.
  (* W is at most M^2, except for roundings. *)
  assert (square : forall v, in_format prec emin v -> norm (sub v p) <= M ->
    rounded_dot rnd false (rounded_sub rnd v p) (rounded_sub rnd v p) <= 1.00001 * (M * M) + 6 * eta).
  { intros v fv long. pose proof (leaf_norm u _ _ ltac:(lra) (leaf v fv)) as off. set (X := rounded_sub rnd v p) in *.
  set (x := sub v p) in *.
    pose proof (norm_triangle x (sub X x)) as tri. rewrite add_difference in tri. pose proof (Rmult_le_compat_l u _ _ ltac:(lra) long).
    assert (norm X <= M + u * M) as XM by lra. assert (norm X * norm X <= (M + u * M) * (M + u * M)) as XX by (apply Rmult_le_compat;
      try apply norm_nonneg; assumption).
    rewrite norm_square in XX. pose proof (dot_error u eta ltac:(lra) eta0 _ _ _ (dots X X)) as off'. rewrite sizes_square in off'.
    apply Rabs_le_inv in off'.
    pose proof (smaller u ltac:(lra) _ MM). assert (dot X X <= 1.000003 * (M * M)) by lra.
    assert (u * dot X X <= u * (1.000003 * (M * M))) by (apply Rmult_le_compat_l; lra). lra. }
  assert (W <= 1.00001 * (M * M) + 6 * eta) as WM.
  { unfold W, conservative_W. repeat apply Rmax_lub; try (apply square; assumption).
    pose proof (rounds_to (r * r)) as H. unfold Lanes.rounds in H. assert (r * r <= M * M) as rM by (apply Rmult_le_compat; lra).
    rewrite (Rabs_pos_eq (r * r)) in H by (apply Rmult_le_pos; assumption). apply Rabs_le_inv in H.
    pose proof (Rmult_le_compat_l u _ _ ltac:(lra) rM). lra. }
  pose proof (small u ltac:(lra) W ltac:(lra)) as uW.
  assert (w <= 1.0001 * M) as wM.
  { apply Rsqr_incr_0_var; [| lra]. unfold Rsqr. rewrite ww. lra. }
  (* Every point was moved by at most 1.003 u w. *)
  assert (moved : forall v, in_format prec emin v -> vertex A B C (rounded_sub rnd v p) ->
    norm (sub (sub v p) (rounded_sub rnd v p)) <= 1.003 * (u * w)).
  { intros v fv HX. rewrite norm_turned. apply (leaf_off u (conj u0 u1) W W0 _ _ (leaf v fv)).
    apply (vertex_size u eta (conj u0 u1) eta0 A B C _ _ _ _ W (dots _ _) (dots _ _) (dots _ _) (W_greatest prec emin a b c p r) W0 tiny).
    exact HX. }
  intros x y z x0 y0 z0 sum. specialize (far (combination x y z a b c) (ex_intro _ x (ex_intro _ y (ex_intro _ z (conj x0 (conj y0 (conj z0
    (conj sum eq_refl)))))))).
  rewrite distance_norm, (combination_moved _ _ _ _ _ _ _ sum) in far. fold A B C.
  set (exact := combination x y z (sub a p) (sub b p) (sub c p)) in *. set (computed := combination x y z A B C).
  assert (norm (sub exact computed) <= 1.003 * (u * w)) as off.
  { unfold exact, computed. rewrite combination_difference. unfold combination. eapply Rle_trans; [apply norm_triangle |].
    eapply Rle_trans; [apply Rplus_le_compat_r, norm_triangle |]. rewrite !norm_scaled by assumption.
    pose proof (moved a fa (or_introl eq_refl)) as ha. pose proof (moved b fb (or_intror (or_introl eq_refl))) as hb.
    pose proof (moved c fc (or_intror (or_intror eq_refl))) as hc.
    fold A in ha. fold B in hb. fold C in hc. apply (Rmult_le_compat_l x) in ha; [| assumption]. apply (Rmult_le_compat_l y) in hb;
      [| assumption]. apply (Rmult_le_compat_l z) in hc; [| assumption].
    replace (1.003 * (u * w)) with (x * (1.003 * (u * w)) + y * (1.003 * (u * w)) + z * (1.003 * (u * w))); [lra |].
    replace z with (1 - x - y) by lra. ring. }
  pose proof (norm_triangle computed (sub exact computed)) as tri. rewrite add_difference in tri.
  apply (Rmult_le_compat_l G) in wM; [| lra]. rewrite <- Gw in wM. unfold phantom_depth in far.
  change (r + 19.9 * t <= norm computed). lra.
Qed.

Theorem conservative_phantoms_shallow32 : conservative_phantoms_shallow 24 (-149) (-42) (-60).
Proof. apply shallow_instance; lia. Qed.
Theorem conservative_phantoms_shallow64 : conservative_phantoms_shallow 53 (-1074) (-400) (-120).
Proof. apply shallow_instance; lia. Qed.
