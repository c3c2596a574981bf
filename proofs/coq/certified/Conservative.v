(* The conservative test of the certified predicate (kernel/sphere_triangle/certified/conservative_step-inl.h) never
   misses a contact: where one of its four axes passes, the triangle is separated. This holds for any rounding with |rnd
   x - x| <= u |x| + eta.

   A, B, C are the translated vertices as computed, a, b, c the exact ones; W is the greatest of A.A, B.B, C.C, r r, as
   computed. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Lanes Certified.
Open Scope R_scope.

(* The constants, as multiples of u W. *)
Definition conservative_error : R := 10.
Definition conservative_square_error : R := 19.125.

Lemma dot_moved n q Q : dot n Q = dot n q + dot n (sub Q q). Proof. vec_ring. Qed.
Lemma dot_combination n x y z a b c : dot n (combination x y z a b c) = x * dot n a + y * dot n b + z * dot n c.
Proof. unfold combination. vec_ring. Qed.
Lemma dot_swapped v w : dot v w = dot w v. Proof. vec_ring. Qed.
Lemma dot_opposite v w : dot (scale v (-1)) w = - dot v w. Proof. vec_ring. Qed.
Lemma norm_opposite v : norm (scale v (-1)) = norm v. Proof. unfold norm. f_equal. vec_ring. Qed.
Lemma norm_turned v w : norm (sub v w) = norm (sub w v). Proof. unfold norm. f_equal. vec_ring. Qed.
Lemma add_difference v w : add w (sub v w) = v. Proof. vec_ring. Qed.
(* A point of an edge. *)
Definition between (X Y : vec) (s : R) := add (scale X (1 - s)) (scale Y s).
Lemma dot_between X Y s Z : dot (between X Y s) Z = dot X Z + s * (dot Y Z - dot X Z).
Proof. unfold between. vec_ring. Qed.
Lemma dot_between_first X Y s : dot (between X Y s) X = dot X X + s * (dot X Y - dot X X).
Proof. unfold between. vec_ring. Qed.
Lemma dot_between_itself X Y s :
  dot (between X Y s) (between X Y s) = dot (between X Y s) X + s * (dot (between X Y s) Y - dot (between X Y s) X).
Proof. unfold between. vec_ring. Qed.

Lemma difference_of_norms x X k : norm (sub X x) <= k * norm x -> 0 <= k <= / 1000 -> norm (sub X x) <= 1.002 * k * norm X.
Proof.
  intros off small_k. pose proof (norm_nonneg x). pose proof (norm_nonneg X).
  assert (norm x <= norm X + norm (sub X x)) as longer.
  { rewrite (norm_turned X x). rewrite <- (add_difference x X) at 1. apply norm_triangle. }
  assert (k * norm x <= k * (norm X + norm (sub X x))) by (apply Rmult_le_compat_l; lra).
  pose proof (norm_nonneg (sub X x)).
  assert (k * norm (sub X x) <= / 1000 * norm (sub X x)) by (apply Rmult_le_compat_r; lra).
  assert (0 <= k * norm X) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma leaf_norm u x X : 0 <= u <= / 1048576 -> leaf_of u x X -> norm (sub X x) <= u * norm x.
Proof.
  intros u0 (hx & hy & hz). pose proof (norm_nonneg x).
  eapply Rle_trans; [apply (norm_monotone _ (Vec (u * Rabs (cx x)) (u * Rabs (cy x)) (u * Rabs (cz x)))); assumption |].
  apply norm_at_most; [apply Rmult_le_pos; lra |].
  replace (u * norm x * (u * norm x)) with (u * u * (norm x * norm x)) by ring. rewrite norm_square, <- (sizes_square x).
  unfold sizes, dot. rewrite !Rabs_mult. cbn [cx cy cz]. right. ring.
Qed.

Section Conservative.
  Variables u eta : R.
  Hypothesis u_range : 0 < u <= / 1048576.
  Hypothesis eta_nonneg : 0 <= eta.
  Notation rounds := (rounds u eta).
  Notation computed_dot := (computed_dot u eta).
  Notation leaf_of := (leaf_of u).
  Let u_weak : 0 <= u <= / 1048576. Proof using u_range. lra. Qed.
  Local Notation small := (small u u_weak).

  Variables (a b c A B C : vec) (r aa bb cc rr W : R).
  Hypothesis r_nonneg : 0 <= r.
  Hypothesis leaf_a : leaf_of a A.
  Hypothesis leaf_b : leaf_of b B.
  Hypothesis leaf_c : leaf_of c C.
  Hypothesis computed_aa : computed_dot A A aa.
  Hypothesis computed_bb : computed_dot B B bb.
  Hypothesis computed_cc : computed_dot C C cc.
  Hypothesis computed_rr : rounds (r * r) rr.
  Hypothesis W_greatest : aa <= W /\ bb <= W /\ cc <= W /\ rr <= W.
  Hypothesis W_positive : 0 < W.
  Hypothesis underflow_2 : eta <= / 1000000 * (u * W).
  Let w := sqrt W.

  Lemma w_facts : 0 < w /\ w * w = W.
  Proof using W_positive. unfold w. split; [apply sqrt_lt_R0; assumption | apply sqrt_sqrt; lra]. Qed.
  Lemma uW : 0 < u * W /\ u * W <= W / 1048576 /\ 0 <= u * (u * W) <= u * W / 1048576.
  Proof using W_positive u_weak.
    pose proof (small W ltac:(lra)). assert (0 < u * W) by (apply Rmult_lt_0_compat; lra). pose proof (small (u * W) ltac:(lra)). lra.
  Qed.

  Lemma square_size X xx : computed_dot X X xx -> xx <= W -> dot X X <= 1.00001 * W.
  Proof using W_positive eta_nonneg u_weak underflow_2.
    intros H least. apply dot_error in H; [| exact u_weak | assumption]. rewrite sizes_square in H. apply Rabs_le_inv in H.
    pose proof (dot_self_nonneg X) as x0. pose proof (small _ x0). pose proof uW. lra.
  Qed.
  Definition vertex X := X = A \/ X = B \/ X = C.
  Lemma vertex_size X : vertex X -> dot X X <= 1.00001 * W /\ norm X <= 1.00001 * w.
  Proof using W_greatest W_positive computed_aa computed_bb computed_cc eta_nonneg u_weak underflow_2.
    pose proof w_facts as [w0 ww].
    assert (dot X X <= 1.00001 * W -> dot X X <= 1.00001 * W /\ norm X <= 1.00001 * w) as enough.
    { intros H. split; [assumption |]. apply norm_at_most; [lra |].
    replace (1.00001 * w * (1.00001 * w)) with (1.00001 * 1.00001 * (w * w)) by ring. lra. }
    intros [-> | [-> | ->]]; apply enough; eapply square_size; try eassumption; tauto.
  Qed.
  Lemma vertices_dot X Y : vertex X -> vertex Y -> norm X * norm Y <= 1.00001 * W /\ Rabs (dot X Y) <= 1.00001 * W.
  Proof using W_greatest W_positive computed_aa computed_bb computed_cc eta_nonneg u_weak underflow_2.
    intros HX HY. apply vertex_size in HX, HY. pose proof (dot_norm X Y).
    pose proof (norm_square X). pose proof (norm_square Y). pose proof (Rle_0_sqr (norm X - norm Y)). unfold Rsqr in *. lra.
  Qed.
  Lemma radius_size : r * r <= 1.00001 * W /\ Rabs (rr - r * r) <= 1.0001 * (u * W).
  Proof using W_greatest W_positive computed_rr r_nonneg u_weak underflow_2.
    pose proof computed_rr as H. unfold Lanes.rounds in H. pose proof (Rmult_le_pos _ _ r_nonneg r_nonneg) as r0.
    rewrite (Rabs_pos_eq (r * r)) in H by assumption. pose proof H as H'. apply Rabs_le_inv in H'. pose proof (small _ r0). pose proof uW.
    assert (r * r <= 1.00001 * W) as size by lra. split; [assumption |].
    apply (Rmult_le_compat_l u) in size; lra.
  Qed.

  (* A vector beyond which all computed vertices lie, by more than the radius and the error of the translation. *)
  Lemma leaf_off x X : leaf_of x X -> norm X <= 1.00001 * w -> norm (sub X x) <= 1.003 * (u * w).
  Proof using W_positive u_weak.
    intros leaf size. pose proof (norm_nonneg x) as x0.
    pose proof (leaf_norm u x X u_weak leaf) as off.
    pose proof (difference_of_norms x X u off ltac:(lra)). pose proof w_facts as [w0 _]. assert (0 <= u * w) by (apply Rmult_le_pos; lra).
    apply (Rmult_le_compat_l u) in size; lra.
  Qed.
  Lemma separates n t : (forall X, vertex X -> t <= dot n X) -> (r + 1.003 * (u * w)) * norm n < t -> clear a b c (r * r).
  Proof.
    intros beyond more x y z x0 y0 z0 sum. pose proof (norm_nonneg n) as n0. pose proof w_facts as [w0 ww].
    assert (each : forall q Q, leaf_of q Q -> vertex Q -> t - 1.003 * (u * w) * norm n <= dot n q).
    { intros q Q leaf HQ. pose proof (leaf_off q Q leaf (proj2 (vertex_size Q HQ))) as off. pose proof (beyond Q HQ).
      pose proof (dot_norm n (sub Q q)) as change. apply Rabs_le_inv in change.
      assert (norm n * norm (sub Q q) <= norm n * (1.003 * (u * w))) by (apply Rmult_le_compat_l; assumption).
      pose proof (dot_moved n q Q). lra. }
    pose proof (each a A leaf_a (or_introl eq_refl)) as ha. pose proof (each b B leaf_b (or_intror (or_introl eq_refl))) as hb.
    pose proof (each c C leaf_c (or_intror (or_intror eq_refl))) as hc.
    set (q := combination x y z a b c).
    assert (dot n q = x * dot n a + y * dot n b + z * dot n c) as split_up by apply dot_combination.
    set (k := t - 1.003 * (u * w) * norm n) in *.
    assert (k <= dot n q) as far.
    { rewrite split_up. apply Rmult_le_compat_l with (r := x) in ha; [| assumption]. apply Rmult_le_compat_l with (r := y) in hb;
      [| assumption].
      apply Rmult_le_compat_l with (r := z) in hc; [| assumption].
      assert (x * k + y * k + z * k = k) by (replace (x * k + y * k + z * k) with ((x + y + z) * k) by ring; rewrite sum; ring). lra. }
    assert (r * norm n < k) as rn by (unfold k; lra).
    pose proof (dot_norm n q) as long. pose proof (Rle_abs (dot n q)). pose proof (norm_nonneg q) as q0.
    assert (r < norm q) as longer.
    { destruct (Rlt_le_dec r (norm q)) as [| less]; [assumption |]. apply (Rmult_le_compat_l (norm n)) in less; lra. }
    rewrite <- norm_square. apply Rmult_le_0_lt_compat; assumption.
  Qed.

  (* The square of the radius with the error that is added to it. *)
  Variables square_error Rc : R.
  Hypothesis computed_square_error : rounds (conservative_square_error * u * W) square_error.
  Hypothesis computed_R : rounds (rr + square_error) Rc.
  Lemma square_error_near : Rabs (square_error - conservative_square_error * (u * W)) <= 0.001 * (u * W).
  Proof using W_positive computed_square_error eta_nonneg u_weak underflow_2.
    pose proof computed_square_error as H. unfold conservative_square_error in *. unfold Lanes.rounds in H. pose proof uW.
    rewrite (Rabs_pos_eq (_ * u * W)) in H by lra. apply Rabs_le_inv in H. apply Rabs_le. lra.
  Qed.
  Lemma R_from_below : r * r + 17 * (u * W) <= Rc.
  Proof.
    pose proof square_error_near as near. unfold conservative_square_error in near. pose proof radius_size as [size off].
    pose proof computed_R as H. unfold Lanes.rounds in H. pose proof uW.
    pose proof (Rmult_le_pos _ _ r_nonneg r_nonneg). apply Rabs_le_inv in near, off, H.
    assert (Rabs (rr + square_error) <= 1.0001 * W) as total by (apply Rabs_le; lra). apply (Rmult_le_compat_l u) in total; [| lra]. lra.
  Qed.

  (* p + s (q - p) as computed. *)
  Lemma mixed k s p q P Q D F T : 0 <= k <= 14 -> 0 <= s <= 1 -> Rabs p <= 1.00001 * W -> Rabs q <= 1.00001 * W ->
    Rabs (P - p) <= k * (u * W) -> Rabs (Q - q) <= k * (u * W) -> rounds (Q - P) D -> rounds (s * D) F -> rounds (P + F) T ->
    Rabs (p + s * (q - p)) <= 1.00001 * W /\ Rabs (T - (p + s * (q - p))) <= (k + 5.01) * (u * W).
  Proof using W_positive u_weak underflow_2.
    intros k0 s0 hp hq offP offQ HD HF HT. pose proof uW as (u0 & uW1 & uW2 & uW3). unfold Lanes.rounds in HD, HF, HT.
    assert (inside : forall x y t, Rabs x <= t -> Rabs y <= t -> Rabs (x + s * (y - x)) <= t).
    { intros x y t hx hy. apply Rabs_le_inv in hx, hy. apply Rabs_le. split; nra. }
    pose proof (inside p q _ hp hq) as whole. split; [assumption |].
    assert (k * (u * W) <= 14 * (u * W)) as kuW by (apply Rmult_le_compat_r; lra).
    assert (Rabs (Q - P) <= 2.001 * W) as change.
    { apply Rabs_le_inv in hp, hq, offP, offQ. apply Rabs_le. lra. }
    apply (Rmult_le_compat_l u) in change; [| lra].
    assert (Rabs (D - (Q - P)) <= 2.0011 * (u * W)) as offD by lra.
    assert (Rabs (s * (D - (Q - P))) <= 2.0011 * (u * W)) as soffD.
    { rewrite Rabs_mult, (Rabs_pos_eq s) by lra. pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos (D - (Q - P))) (proj2 s0)). lra. }
    assert (Rabs (s * D) <= 2.002 * W) as sizeD.
    { rewrite Rabs_mult, (Rabs_pos_eq s) by lra. pose proof (Rmult_le_compat_r _ _ _ (Rabs_pos D) (proj2 s0)).
      apply Rabs_le_inv in offD, hp, hq, offP, offQ. assert (Rabs D <= 2.002 * W) by (apply Rabs_le; lra). lra. }
    apply (Rmult_le_compat_l u) in sizeD; [| lra].
    assert (Rabs (F - s * D) <= 2.003 * (u * W)) as offF by lra.
    pose proof (inside (P - p) (Q - q) _ offP offQ) as moved.
    assert (P + F - (p + s * (q - p)) = (P - p + s * (Q - q - (P - p))) + s * (D - (Q - P)) + (F - s * D)) as parts by ring.
    assert (Rabs (P + F - (p + s * (q - p))) <= (k + 4.005) * (u * W)) as offS.
    { rewrite parts. eapply Rle_trans; [apply Rabs_triang |]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang |]. lra. }
    assert (Rabs (P + F) <= 1.0001 * W) as sizeS.
    { apply Rabs_le_inv in offS, whole. apply Rabs_le. lra. }
    apply (Rmult_le_compat_l u) in sizeS; [| lra].
    replace (T - (p + s * (q - p))) with ((T - (P + F)) + (P + F - (p + s * (q - p)))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. lra.
  Qed.

  (* The axis of the edge from X to Y, for any s between 0 and 1: n = (1 - s) X + s Y. *)
  Variable error : R.
  Hypothesis computed_error : rounds (conservative_error * u * W) error.
  Hypothesis underflow_4 : eta <= / 100000 * (u * W * (u * W)).
  Lemma edge_axis X Y Z xx xy yy xz yz s d1 f1 at_x d2 f2 at_y d3 f3 at_z d4 f4 nn least m square mm rs :
    vertex X -> vertex Y -> vertex Z -> (forall T, vertex T -> T = X \/ T = Y \/ T = Z) -> 0 <= s <= 1 ->
    computed_dot X X xx -> computed_dot X Y xy -> computed_dot Y Y yy -> computed_dot X Z xz -> computed_dot Y Z yz ->
    rounds (xy - xx) d1 -> rounds (s * d1) f1 -> rounds (xx + f1) at_x ->
    rounds (yy - xy) d2 -> rounds (s * d2) f2 -> rounds (xy + f2) at_y ->
    rounds (yz - xz) d3 -> rounds (s * d3) f3 -> rounds (xz + f3) at_z ->
    rounds (at_y - at_x) d4 -> rounds (s * d4) f4 -> rounds (at_x + f4) nn -> rounds (nn + square_error) square ->
    least <= at_x -> least <= at_y -> least <= at_z -> least = at_x \/ least = at_y \/ least = at_z -> rounds (least - error) m ->
      rounds (m * m) mm -> rounds (Rc * square) rs ->
    0 < m -> rs < mm -> clear a b c (r * r).
  Proof using All.
    intros vX vY vZ all s01 Hxx Hxy Hyy Hxz Hyz Hd1 Hf1 Hx Hd2 Hf2 Hy Hd3 Hf3 Hz Hd4 Hf4 Hn Hs lx ly lz one Hm Hmm Hrs m0 passes.
    pose proof uW as (u0 & uW1 & uW2 & uW3). pose proof w_facts as [w0 ww].
    assert (product : forall P Q d, vertex P -> vertex Q -> computed_dot P Q d ->
      Rabs (dot P Q) <= 1.00001 * W /\ Rabs (d - dot P Q) <= 3.002 * (u * W)).
    { intros P Q d HP HQ H. destruct (vertices_dot P Q HP HQ) as [long size]. split; [assumption |].
      apply dot_error in H; [| exact u_weak | assumption]. pose proof (sizes_norm P Q) as sn.
      assert (u * sizes P Q <= u * (1.00001 * W)) by (apply Rmult_le_compat_l; lra). lra. }
    destruct (product _ _ _ vX vX Hxx) as [sxx oxx]. destruct (product _ _ _ vX vY Hxy) as [sxy oxy].
    destruct (product _ _ _ vY vY Hyy) as [syy oyy].
    destruct (product _ _ _ vX vZ Hxz) as [sxz oxz]. destruct (product _ _ _ vY vZ Hyz) as [syz oyz].
    set (n := between X Y s).
    destruct (mixed 3.002 s _ _ _ _ _ _ _ ltac:(lra) s01 sxx sxy oxx oxy Hd1 Hf1 Hx) as [sx ox].
    destruct (mixed 3.002 s _ _ _ _ _ _ _ ltac:(lra) s01 sxy syy oxy oyy Hd2 Hf2 Hy) as [sy oy].
    destruct (mixed 3.002 s _ _ _ _ _ _ _ ltac:(lra) s01 sxz syz oxz oyz Hd3 Hf3 Hz) as [sz oz].
    destruct (mixed 8.012 s _ _ at_x at_y _ _ _ ltac:(lra) s01 sx sy ltac:(lra) ltac:(lra) Hd4 Hf4 Hn) as [sn on].
    rewrite <- dot_between_first in ox, sx. rewrite <- dot_between in oy, sy, oz, sz.
    rewrite <- dot_between_first, <- dot_between, <- dot_between_itself in on, sn. fold n in ox, sx, oy, sy, oz, sz, on, sn.
    (* m is at most the least n.X. *)
    pose proof computed_error as He. unfold Lanes.rounds, conservative_error in He. rewrite (Rabs_pos_eq (_ * u * W)) in He by lra.
    apply Rabs_le_inv in He, sx, sy, sz, ox, oy, oz.
    assert (Rabs (least - error) <= 1.02 * W) as sm by (apply Rabs_le; destruct one as [-> | [-> | ->]]; lra).
    pose proof Hm as offm. unfold Lanes.rounds in offm. apply Rabs_le_inv in offm. apply (Rmult_le_compat_l u) in sm; [| lra].
    assert (forall T, vertex T -> m <= dot n T) as beyond.
    { intros T HT. destruct (all T HT) as [-> | [-> | ->]]; lra. }
    apply (separates n m beyond).
    (* The squares. *)
    pose proof (dot_self_nonneg n) as n0. pose proof square_error_near as near. unfold conservative_square_error in near.
    pose proof R_from_below as Rlow. apply Rabs_le_inv in near, on, sn.
    pose proof Hs as offs. unfold Lanes.rounds in offs. assert (Rabs (nn + square_error) <= 1.001 * W) as ss by (apply Rabs_le; lra).
    apply (Rmult_le_compat_l u) in ss; [| lra]. apply Rabs_le_inv in offs.
    assert (dot n n + 5 * (u * W) <= square) as slow by lra.
    pose proof (Rmult_le_pos _ _ r_nonneg r_nonneg) as r0. destruct radius_size as [rs1 _].
    set (rho := r * r) in *. set (n2 := dot n n) in *. set (v := u * W) in *.
    assert ((rho + 17 * v) * (n2 + 5 * v) <= Rc * square) as product_low by (apply Rmult_le_compat; lra).
    assert (0 <= m * m) as mm0 by (apply Rmult_le_pos; lra).
    unfold Lanes.rounds in Hmm, Hrs. rewrite (Rabs_pos_eq (m * m)) in Hmm by assumption.
    assert (0 <= (rho + 17 * v) * (n2 + 5 * v)) as pl0 by (apply Rmult_le_pos; lra).
    rewrite (Rabs_pos_eq (Rc * square)) in Hrs by lra. apply Rabs_le_inv in Hmm, Hrs.
    set (q := (rho + 17 * v) * (n2 + 5 * v)) in *.
    assert (q * (1 - u) - 2 * eta < m * m * (1 + u)) as first.
    { assert (q * (1 - u) <= Rc * square * (1 - u)) by (apply Rmult_le_compat_r; lra). lra. }
    assert (q * (1 - 2 * u) - 2 * eta < m * m) as second.
    { apply (Rmult_lt_compat_r (1 - u)) in first; [| lra]. assert (0 <= u * u * (m * m)) by (apply Rmult_le_pos; [apply Rmult_le_pos;
      lra | assumption]).
      assert (0 <= u * u * q) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | assumption]).
      assert (0 <= eta * u) by (apply Rmult_le_pos; lra). lra. }
    assert (0 <= v * v) as vv by (apply Rmult_le_pos; lra).
    assert (0 < v * v) as vv' by (apply Rmult_lt_0_compat; lra).
    assert (rho * n2 + 14.9 * (v * n2) + 39 * (v * v) <= q * (1 - 2 * u)) as third.
    { assert (0 <= v * rho) as vr by (apply Rmult_le_pos; lra). assert (0 <= v * n2) as vn by (apply Rmult_le_pos; lra).
      assert (u * (rho * n2) <= 1.00001 * (v * n2)) as t1.
      { replace (u * (rho * n2)) with (u * n2 * rho) by ring. replace (1.00001 * (v * n2)) with (u * n2 * (1.00001 * W)) by (unfold v;
        ring).
        apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]. }
      assert (u * (v * rho) <= 1.00001 * (v * v)) as t2.
      { replace (u * (v * rho)) with (u * v * rho) by ring. replace (1.00001 * (v * v)) with (u * v * (1.00001 * W)) by (unfold v; ring).
        apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]. }
      assert (u * (v * n2) <= 1.00001 * (v * v)) as t3.
      { replace (u * (v * n2)) with (u * v * n2) by ring. replace (1.00001 * (v * v)) with (u * v * (1.00001 * W)) by (unfold v; ring).
        apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]. }
      pose proof (small (v * v) vv). unfold q. lra. }
    (* (r + 1.003 u w) |n| *)
    set (h := 1.003 * (u * w)). assert (0 <= u * w) as uw0 by (apply Rmult_le_pos; lra).
    assert (r * w <= 1.00001 * W) as rw by (pose proof (Rle_0_sqr (r - w)); unfold Rsqr, rho in *; lra).
    assert ((r + h) * (r + h) <= rho + 2.1 * v) as grown.
    { apply (Rmult_le_compat_l u) in rw; [| lra]. assert (u * w * (u * w) = u * v) as uwuw by (unfold v; rewrite <- ww; ring).
      replace ((r + h) * (r + h)) with (r * r + 2.006 * (u * (r * w)) + 1.006009 * (u * w * (u * w))) by (unfold h; lra).
      rewrite uwuw. unfold rho, v in *. lra. }
    assert ((r + h) * norm n * ((r + h) * norm n) < m * m) as squares.
    { replace ((r + h) * norm n * ((r + h) * norm n)) with ((r + h) * (r + h) * (norm n * norm n)) by ring. rewrite norm_square. fold n2.
      apply (Rmult_le_compat_r n2) in grown; [| assumption]. assert (0 <= v * n2) by (apply Rmult_le_pos; lra). lra. }
    apply Rsqr_incrst_0; [exact squares | | lra]. apply Rmult_le_pos; [unfold h; lra | apply norm_nonneg].
  Qed.

  (* The plane's axis, for any stored vector that is not too short. *)
  Lemma plane_axis n at_a at_b at_c square m mm rs :
    computed_dot A n at_a -> computed_dot B n at_b -> computed_dot C n at_c -> computed_dot n n square ->
    (m <= at_a /\ m <= at_b /\ m <= at_c \/ m <= - at_a /\ m <= - at_b /\ m <= - at_c) ->
    eta <= / 1000000 * (u * dot n n) -> eta <= / 1000000 * (u * W * dot n n) ->
    rounds (m * m) mm -> rounds (Rc * square) rs -> 0 < m -> rs < mm -> clear a b c (r * r).
  Proof.
    intros Ha Hb Hc Hs least tiny tiny' Hmm Hrs m0 passes.
    pose proof uW as (u0 & uW1 & uW2 & uW3). pose proof w_facts as [w0 ww]. pose proof (norm_nonneg n) as N0.
    set (N := norm n) in *. assert (N * N = dot n n) as NN by apply norm_square.
    assert (0 <= u * (w * N)) as uwN by (repeat apply Rmult_le_pos; lra).
    assert (eta <= / 1000000 * (u * (w * N))) as tiny1.
    { apply Rsqr_incr_0_var; [| lra]. unfold Rsqr.
      replace (/ 1000000 * (u * (w * N)) * (/ 1000000 * (u * (w * N)))) with (/ 1000000 * (u * W) * (/ 1000000 * (u * dot n n)))
        by (rewrite <- ww, <- NN; ring).
      apply Rmult_le_compat; assumption. }
    assert (each : forall X d, vertex X -> computed_dot X n d -> Rabs (d - dot n X) <= 3.002 * (u * (w * N))).
    { intros X d HX H. destruct (vertex_size X HX) as [_ size]. apply dot_error in H; [| exact u_weak | assumption].
      rewrite (dot_swapped n X). pose proof (sizes_norm X n) as sn. fold N in sn.
      assert (norm X * N <= 1.00001 * w * N) as long by (apply Rmult_le_compat_r; assumption).
      assert (u * sizes X n <= u * (1.00001 * w * N)) by (apply Rmult_le_compat_l; lra). lra. }
    pose proof (each A _ (or_introl eq_refl) Ha) as oa. pose proof (each B _ (or_intror (or_introl eq_refl)) Hb) as ob.
    pose proof (each C _ (or_intror (or_intror eq_refl)) Hc) as oc. apply Rabs_le_inv in oa, ob, oc.
    (* m^2 exceeds (r^2 + 11 u W) |n|^2. *)
    apply dot_error in Hs; [| exact u_weak | assumption]. rewrite sizes_square in Hs. apply Rabs_le_inv in Hs.
    pose proof (dot_self_nonneg n) as n0. pose proof R_from_below as Rlow.
    pose proof (Rmult_le_pos _ _ r_nonneg r_nonneg) as r0. destruct radius_size as [rs1 _].
    set (rho := r * r) in *. set (n2 := dot n n) in *. set (v := u * W) in *.
    pose proof (small n2 n0) as un2.
    assert (0 <= m * m) as mm0 by (apply Rmult_le_pos; lra).
    assert (n2 * (1 - 3.002 * u) <= square) as slow by lra.
    assert (0 <= n2 * (1 - 3.002 * u)) as slow0 by (apply Rmult_le_pos; lra).
    assert ((rho + 17 * v) * (n2 * (1 - 3.002 * u)) <= Rc * square) as product_low by (apply Rmult_le_compat; lra).
    unfold Lanes.rounds in Hmm, Hrs. rewrite (Rabs_pos_eq (m * m)) in Hmm by assumption.
    assert (0 <= (rho + 17 * v) * (n2 * (1 - 3.002 * u))) as pl0 by (apply Rmult_le_pos; lra).
    rewrite (Rabs_pos_eq (Rc * square)) in Hrs by lra. apply Rabs_le_inv in Hmm, Hrs.
    set (q := (rho + 17 * v) * (n2 * (1 - 3.002 * u))) in *.
    assert (q * (1 - u) - 2 * eta < m * m * (1 + u)) as first.
    { assert (q * (1 - u) <= Rc * square * (1 - u)) by (apply Rmult_le_compat_r; lra). lra. }
    assert (q * (1 - 2 * u) - 2 * eta < m * m) as second.
    { apply (Rmult_lt_compat_r (1 - u)) in first; [| lra]. assert (0 <= u * u * (m * m)) by (apply Rmult_le_pos; [apply Rmult_le_pos;
      lra | assumption]).
      assert (0 <= u * u * q) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | assumption]).
      assert (0 <= eta * u) by (apply Rmult_le_pos; lra). lra. }
    assert (0 <= v * n2) as vn by (apply Rmult_le_pos; lra).
    assert ((rho + 11.9 * v) * n2 <= q * (1 - 2 * u)) as third.
    { assert (0 <= rho * n2) as rn by (apply Rmult_le_pos; lra).
      assert (u * (rho * n2) <= 1.00001 * (v * n2)) as t1.
      { replace (u * (rho * n2)) with (u * n2 * rho) by ring. replace (1.00001 * (v * n2)) with (u * n2 * (1.00001 * W)) by (unfold v;
        ring).
        apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]. }
      pose proof (small (v * n2) vn). assert (0 <= u * u * (rho * n2)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | assumption]).
      assert (0 <= u * u * (v * n2)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | assumption]). unfold q. lra. }
    assert ((rho + 11.8 * v) * n2 < m * m) as fourth by lra.
    assert (0 <= u * w) as uw0 by (apply Rmult_le_pos; lra).
    assert (r * w <= 1.00001 * W) as rw by (pose proof (Rle_0_sqr (r - w)); unfold Rsqr, rho in *; lra).
    set (h := 4.02 * (u * w)).
    assert ((r + h) * (r + h) <= rho + 8.1 * v) as grown.
    { apply (Rmult_le_compat_l u) in rw; [| lra]. assert (u * w * (u * w) = u * v) as uwuw by (unfold v; rewrite <- ww; ring).
      replace ((r + h) * (r + h)) with (r * r + 8.04 * (u * (r * w)) + 16.1604 * (u * w * (u * w))) by (unfold h; lra).
      rewrite uwuw. unfold rho, v in *. lra. }
    assert ((r + h) * N * ((r + h) * N) < m * m) as squares.
    { replace ((r + h) * N * ((r + h) * N)) with ((r + h) * (r + h) * (N * N)) by ring. rewrite NN.
      apply (Rmult_le_compat_r n2) in grown; [| assumption]. lra. }
    assert ((r + h) * N < m) as longer.
    { apply Rsqr_incrst_0; [exact squares | | lra]. apply Rmult_le_pos; [unfold h; lra | assumption]. }
    unfold h in longer.
    destruct least as [(la & lb & lc) | (la & lb & lc)].
    - apply (separates n (m - 3.002 * (u * (w * N)))); [| fold N; lra]. intros X [-> | [-> | ->]]; lra.
    - pose proof (norm_opposite n) as same. fold N in same. apply (separates (scale n (-1)) (m - 3.002 * (u * (w * N)))); [| rewrite same;
      lra].
      intros X [-> | [-> | ->]]; rewrite dot_opposite; lra.
  Qed.
End Conservative.
