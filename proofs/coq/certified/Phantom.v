(* A bound of the depth of phantom contacts of the conservative test
   (kernel/sphere_triangle/certified/conservative_step-inl.h): where every point of the triangle is farther from the
   centre than r by 19.9 sqrt u L, some axis passes. This holds for any rounding with |rnd x - x| <= u |x| + eta.

   A, B, C are the translated vertices as computed; t^2 = u W. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Lanes Certified Conservative.
Open Scope R_scope.

(* m^2 > R q with room for the roundings, where m is about nu^2, R about r^2 and q about nu^2, nu > r + 19.9 t. *)
Lemma deep_edge u t nu r m Rc q : 0 < u -> 0 < t -> 0 <= r -> r + 19.9 * t <= nu -> u * (nu * nu) <= 1.01 * (t * t) ->
  nu * nu - 3 * (nu * t) - 50 * (t * t) <= m -> 0 <= Rc <= r * r + 22 * (t * t) -> 0 <= q <= nu * nu + 94 * (t * t) ->
  0 < m /\ Rc * q * (1 + 3 * u) + t * t * (t * t) <= m * m.
Proof.
  intros u0 t0 r0 far un hm hR hq.
  assert (0 < nu) as nu0 by lra. assert (19.9 * (t * t) <= nu * t) as nt.
  { replace (19.9 * (t * t)) with (19.9 * t * t) by ring. apply Rmult_le_compat_r; lra. }
  assert (0 < t * t) as tt by (apply Rmult_lt_0_compat; assumption).
  set (P := (r + 4.7 * t) * (nu + 2.37 * t)).
  assert (0 <= P) as P0 by (apply Rmult_le_pos; lra).
  assert (0 <= r * t) as rt by (apply Rmult_le_pos; lra).
  assert (Rc * q <= P * P) as top.
  { replace (P * P) with ((r + 4.7 * t) * (r + 4.7 * t) * ((nu + 2.37 * t) * (nu + 2.37 * t))) by (unfold P; ring).
    apply Rmult_le_compat; lra. }
  assert (P <= nu * nu - 12.8 * (nu * t)) as PP.
  { apply Rle_trans with ((nu - 15.2 * t) * (nu + 2.37 * t)); [apply Rmult_le_compat_r; lra |]. lra. }
  assert (nu * nu - 5.52 * (nu * t) <= m) as mm by lra.
  assert (P + 7.28 * (nu * t) <= m) as gap by lra.
  assert (396 * (t * t) <= nu * nu) as nn.
  { apply Rle_trans with (19.9 * t * (19.9 * t)); [lra |]. apply Rmult_le_compat; lra. }
  assert (19.9 * (nu * t) <= nu * nu) as nn'.
  { replace (19.9 * (nu * t)) with (nu * (19.9 * t)) by ring. apply Rmult_le_compat_l; lra. }
  assert (0 < m) as m0 by lra. split; [assumption |].
  assert (u * P <= 0.051 * (nu * t)) as uP.
  { apply Rle_trans with (u * (nu * nu)); [apply Rmult_le_compat_l; lra | lra]. }
  assert (Rc * q * (1 + 3 * u) <= P * P * (1 + 3 * u)) as s1 by (apply Rmult_le_compat_r; lra).
  assert (u * P * P <= 0.051 * (nu * t) * m) as s2.
  { apply Rmult_le_compat; try lra; try (apply Rmult_le_pos; lra). }
  assert (0 <= nu * t) as nt0 by (apply Rmult_le_pos; lra).
  assert (P * P <= m * m - 7.28 * (nu * t) * m) as s3.
  { assert (P * P <= (m - 7.28 * (nu * t)) * P) by (apply Rmult_le_compat_r; lra).
    assert ((m - 7.28 * (nu * t)) * P <= (m - 7.28 * (nu * t)) * m) by (apply Rmult_le_compat_l; lra). lra. }
  assert (t * t * (t * t) <= nu * t * m) as s4 by (apply Rmult_le_compat; lra).
  assert (0 <= nu * t * m) by (apply Rmult_le_pos; lra). lra.
Qed.

Section Phantom.
  Variables u eta : R.
  Hypothesis u_range : 0 < u <= / 1048576.
  Hypothesis eta_nonneg : 0 <= eta.
  Notation rounds := (rounds u eta).
  Notation computed_dot := (computed_dot u eta).
  Let u_weak : 0 <= u <= / 1048576. Proof using u_range. lra. Qed.
  Local Notation small := (small u u_weak).

  Variables (A B C : vec) (r rr W square_error Rc error : R).
  Hypothesis r_nonneg : 0 <= r.
  Hypothesis W_positive : 0 < W.
  Hypothesis underflow_2 : eta <= / 1000000 * (u * W).
  Hypothesis underflow_4 : eta <= / 100000 * (u * W * (u * W)).
  Hypothesis sizes_known : forall X, vertex A B C X -> dot X X <= 1.00001 * W /\ norm X <= 1.00001 * sqrt W.
  Hypothesis rr_near : r * r <= 1.00001 * W /\ Rabs (rr - r * r) <= 1.0001 * (u * W).
  Hypothesis computed_square_error : rounds (conservative_square_error * u * W) square_error.
  Hypothesis computed_error : rounds (conservative_error * u * W) error.
  Hypothesis computed_R : rounds (rr + square_error) Rc.
  Let w := sqrt W.
  Let t := sqrt (u * W).
  Local Notation uW := (uW u u_range W W_positive).

  Lemma t_facts : 0 < w /\ w * w = W /\ 0 < t /\ t * t = u * W /\ u * w <= t / 1000.
  Proof using W_positive u_range.
    pose proof uW as (v0 & v1 & _). destruct (w_facts W W_positive) as [w0 ww]. fold w in w0, ww.
    assert (0 < t) as t0 by (apply sqrt_lt_R0; assumption). assert (t * t = u * W) as tt by (apply sqrt_sqrt; lra).
    repeat split; try assumption. apply Rsqr_incr_0_var; [| lra]. unfold Rsqr.
    replace (u * w * (u * w)) with (u * (u * (w * w))) by ring. replace (t / 1000 * (t / 1000)) with (t * t / 1000000) by field.
    rewrite ww, tt. pose proof (Rmult_le_compat_r (u * W) _ _ ltac:(lra) (proj2 u_range)). lra.
  Qed.
  Lemma Rc_range : 0 <= Rc <= r * r + 22 * (t * t).
  Proof using W_positive computed_R computed_square_error eta_nonneg r_nonneg rr_near u_range underflow_2 w.
    destruct t_facts as (_ & _ & _ & -> & _). destruct rr_near as [size off]. pose proof uW as (v0 & v1 & _).
    pose proof (Rmult_le_pos _ _ r_nonneg r_nonneg).
    pose proof (square_error_near u eta u_range eta_nonneg W W_positive underflow_2 square_error computed_square_error) as near.
    pose proof computed_R as H'. unfold conservative_square_error in near. unfold Lanes.rounds in H'. apply Rabs_le_inv in off, near.
    assert (Rabs (rr + square_error) <= 1.001 * W) as whole by (apply Rabs_le; lra). apply (Rmult_le_compat_l u) in whole; [| lra].
    apply Rabs_le_inv in H'. lra.
  Qed.
  (* After the rounding of m^2 and R q, m^2 is still beyond. *)
  Lemma passes_rounded m q mm rs : 0 <= q -> Rc * q * (1 + 3 * u) + t * t * (t * t) <= m * m ->
    rounds (m * m) mm -> rounds (Rc * q) rs -> rs < mm.
  Proof.
    intros q0 beyond Hm Hr. destruct t_facts as (_ & _ & _ & tt & _). rewrite tt in beyond. pose proof uW as (v0 & _).
    pose proof (proj1 Rc_range) as R0. assert (0 <= Rc * q) as Rq by (apply Rmult_le_pos; lra).
    assert (0 < u * W * (u * W)) as vv by (apply Rmult_lt_0_compat; assumption).
    assert (0 <= m * m) as m0 by apply Rle_0_sqr. unfold Lanes.rounds in Hm, Hr.
    rewrite (Rabs_pos_eq (m * m)) in Hm by assumption. rewrite (Rabs_pos_eq (Rc * q)) in Hr by assumption. apply Rabs_le_inv in Hm, Hr.
    assert ((Rc * q * (1 + 3 * u) + u * W * (u * W)) * (1 - u) <= m * m * (1 - u)) as less by (apply Rmult_le_compat_r; lra).
    pose proof (small _ Rq). pose proof (smaller u u_weak _ Rq). pose proof (small (u * W * (u * W)) ltac:(lra)). lra.
  Qed.

  (* An edge from X to Y whose nearest point, star, was found to within 30 u W: it passes where the third vertex is not
     nearer than star along star, or nearer by at most 3 t. *)
  Lemma edge_deep X Y Z xx xy yy xz yz s d1 f1 at_x d2 f2 at_y d3 f3 at_z d4 f4 nn least m square mm rs star :
    vertex A B C X -> vertex A B C Y -> vertex A B C Z -> 0 <= s <= 1 ->
    computed_dot X X xx -> computed_dot X Y xy -> computed_dot Y Y yy -> computed_dot X Z xz -> computed_dot Y Z yz ->
    rounds (xy - xx) d1 -> rounds (s * d1) f1 -> rounds (xx + f1) at_x ->
    rounds (yy - xy) d2 -> rounds (s * d2) f2 -> rounds (xy + f2) at_y ->
    rounds (yz - xz) d3 -> rounds (s * d3) f3 -> rounds (xz + f3) at_z ->
    rounds (at_y - at_x) d4 -> rounds (s * d4) f4 -> rounds (at_x + f4) nn -> rounds (nn + square_error) square ->
    least = at_x \/ least = at_y \/ least = at_z -> rounds (least - error) m -> rounds (m * m) mm -> rounds (Rc * square) rs ->
    norm (sub (between X Y s) star) <= 30 * (u * w) -> r + 19.9 * t <= norm star ->
    dot star star <= dot star X -> dot star star <= dot star Y -> dot star star - 3 * (norm star * t) <= dot star Z ->
    0 < m /\ rs < mm.
  Proof.
    intros vX vY vZ s01 Hxx Hxy Hyy Hxz Hyz Hd1 Hf1 Hx Hd2 Hf2 Hy Hd3 Hf3 Hz Hd4 Hf4 Hn Hs one Hm Hmm Hrs close far sX sY sZ.
    pose proof uW as (u0 & uW1 & uW2 & uW3). destruct t_facts as (w0 & ww & t0 & tt & uwt).
    assert (product : forall P Q d, vertex A B C P -> vertex A B C Q -> computed_dot P Q d ->
      Rabs (dot P Q) <= 1.00001 * W /\ Rabs (d - dot P Q) <= 3.002 * (u * W)).
    { intros P Q d HP HQ H. apply sizes_known in HP, HQ. pose proof (dot_norm P Q). pose proof (norm_square P). pose proof (norm_square Q).
      pose proof (Rle_0_sqr (norm P - norm Q)) as sq. unfold Rsqr in sq. split; [lra |].
      apply dot_error in H; [| exact u_weak | assumption]. pose proof (sizes_norm P Q) as sn.
      assert (u * sizes P Q <= u * (1.00001 * W)) by (apply Rmult_le_compat_l; lra). lra. }
    destruct (product _ _ _ vX vX Hxx) as [sxx oxx]. destruct (product _ _ _ vX vY Hxy) as [sxy oxy].
    destruct (product _ _ _ vY vY Hyy) as [syy oyy].
    destruct (product _ _ _ vX vZ Hxz) as [sxz oxz]. destruct (product _ _ _ vY vZ Hyz) as [syz oyz].
    set (n := between X Y s) in *.
    destruct (mixed u eta u_range W W_positive underflow_2 3.002 s _ _ _ _ _ _ _ ltac:(lra) s01 sxx sxy oxx oxy Hd1 Hf1 Hx) as [sx ox].
    destruct (mixed u eta u_range W W_positive underflow_2 3.002 s _ _ _ _ _ _ _ ltac:(lra) s01 sxy syy oxy oyy Hd2 Hf2 Hy) as [sy oy].
    destruct (mixed u eta u_range W W_positive underflow_2 3.002 s _ _ _ _ _ _ _ ltac:(lra) s01 sxz syz oxz oyz Hd3 Hf3 Hz) as [sz oz].
    destruct (mixed u eta u_range W W_positive underflow_2 8.012 s _ _ at_x at_y _ _ _ ltac:(lra) s01 sx sy ltac:(lra) ltac:(lra) Hd4 Hf4
      Hn) as [sn on].
    rewrite <- dot_between_first in ox, sx. rewrite <- dot_between in oy, sy, oz, sz.
    rewrite <- dot_between_first, <- dot_between, <- dot_between_itself in on, sn. fold n in ox, sx, oy, sy, oz, sz, on, sn.
    set (nu := norm star) in *. assert (nu * nu = dot star star) as nn2 by apply norm_square. rewrite <- nn2 in sX, sY, sZ.
    (* The products with n in terms of those with star. *)
    assert (near : forall T, vertex A B C T -> dot star T - 30.001 * (u * W) <= dot n T).
    { intros T HT. apply sizes_known in HT as [_ HT]. fold w in HT. pose proof (dot_norm T (sub n star)) as change.
    apply Rabs_le_inv in change.
      assert (norm T * norm (sub n star) <= 1.00001 * w * (30 * (u * w))) as part by (apply Rmult_le_compat; try assumption;
        apply norm_nonneg).
      replace (1.00001 * w * (30 * (u * w))) with (30.0003 * (u * (w * w))) in part by lra. rewrite ww in part.
      pose proof (dot_moved T star n). rewrite (dot_swapped T n), (dot_swapped T star) in *. lra. }
    pose proof (near X vX) as nX. pose proof (near Y vY) as nY. pose proof (near Z vZ) as nZ.
    assert (0 <= nu * t) as nut by (apply Rmult_le_pos; [apply norm_nonneg | lra]).
    pose proof computed_error as He. unfold Lanes.rounds, conservative_error in He. rewrite (Rabs_pos_eq (_ * u * W)) in He by lra.
    apply Rabs_le_inv in He, sx, sy, sz, ox, oy, oz.
    assert (Rabs (least - error) <= 1.02 * W) as sm by (apply Rabs_le; destruct one as [-> | [-> | ->]]; lra).
    pose proof Hm as offm. unfold Lanes.rounds in offm. apply Rabs_le_inv in offm. apply (Rmult_le_compat_l u) in sm; [| lra].
    assert (nu * nu - 3 * (nu * t) - 50 * (t * t) <= m) as mlow by (rewrite tt; destruct one as [-> | [-> | ->]]; lra).
    (* The squares. *)
    assert (norm n <= 1.0001 * w) as nsize.
    { apply norm_at_most; [lra |]. apply Rabs_le_inv in sn. replace (1.0001 * w * (1.0001 * w)) with (1.0001 * 1.0001 * (w * w)) by ring.
    lra. }
    pose proof (small w ltac:(lra)) as uw.
    assert (nu <= 1.001 * w) as nusize.
    { unfold nu. pose proof (norm_triangle n (sub star n)) as tri. rewrite add_difference in tri. rewrite norm_turned in close. lra. }
    assert (nu * nu <= 1.001 * w * (1.001 * w)) as nusq by (apply Rmult_le_compat; try lra; apply norm_nonneg).
    assert (dot n n <= nu * nu + 60.2 * (u * W)) as nnup.
    { assert (norm n <= nu + 30 * (u * w)) as le1.
      { pose proof (norm_triangle star (sub n star)) as tri. rewrite add_difference in tri. fold nu in tri. lra. }
      rewrite <- norm_square. apply Rle_trans with ((nu + 30 * (u * w)) * (nu + 30 * (u * w))).
      - apply Rmult_le_compat; try apply norm_nonneg; assumption.
      - assert (u * w * nu <= u * w * (1.001 * w)) by (apply Rmult_le_compat_l; lra).
        assert (u * w * (u * w) <= u * w * (w / 1048576)) by (apply Rmult_le_compat_l; lra).
        replace (u * w * (1.001 * w)) with (1.001 * (u * (w * w))) in * by ring.
        replace (u * w * (w / 1048576)) with (u * (w * w) / 1048576) in * by field.
        rewrite ww in *. lra. }
    pose proof (square_error_near u eta u_range eta_nonneg W W_positive underflow_2 square_error computed_square_error) as snear.
    unfold conservative_square_error in snear. pose proof (dot_self_nonneg n) as n0. apply Rabs_le_inv in snear, on, sn.
    pose proof Hs as offs. unfold Lanes.rounds in offs. assert (Rabs (nn + square_error) <= 1.001 * W) as ss by (apply Rabs_le; lra).
    apply (Rmult_le_compat_l u) in ss; [| lra]. apply Rabs_le_inv in offs.
    assert (0 <= square <= nu * nu + 94 * (t * t)) as srange by (rewrite tt; lra).
    assert (u * (nu * nu) <= 1.01 * (t * t)) as unu.
    { rewrite tt. apply (Rmult_le_compat_l u) in nusq; [| lra].
    replace (u * (1.001 * w * (1.001 * w))) with (1.002001 * (u * (w * w))) in nusq by lra. rewrite ww in nusq. lra. }
    destruct (deep_edge u t nu r m Rc square ltac:(lra) t0 r_nonneg far unu mlow Rc_range srange) as [m0 beyond].
    split; [assumption |]. apply (passes_rounded m square); try assumption. lra.
  Qed.
End Phantom.
