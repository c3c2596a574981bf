(* The bounds beside the margins of exact/sphere_triangle/oracles/margins-inl.h and
   kernel/sphere_triangle/certified/margins-inl.h: each is proved to exceed its margin's error by a thirty-second part,
   which is left for the rounding of the bound itself and of the pair whose leading double is compared.

   u is the unit of the arithmetic: 2^-53 for doubles, 2^-103 and 2^-102 for their pairs. A product of two numbers has a
   relative error of u. A dot product, a difference of products and a difference have errors relative to the sizes of
   what is added, not to the result, which may be far smaller: the sums of the certified predicate's pairs have no better
   bound (Pairs.v). Doubles do better, which double_dot_near and its like prove. Nothing underflows: a rounding has no
   other error here. Lower case is exact, upper case computed; A, B, ... are leaves, N and V cross products of leaves. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Lanes.
Open Scope R_scope.

(* The exported constants. Multiples of a unit, which is u and a sixteenth of it: *)
Definition unit_factor : R := 1.0625.
Definition vertex_radius_units : R := 6.
Definition vertex_side_units : R := 15.
Definition normal_units : R := 8.
Definition offset_units : R := 4.
Definition plane_lhs_units : R := 2.
Definition plane_rhs_units : R := 6.
Definition edge_square_units : R := 4.
Definition edge_rhs_units : R := 8.
Definition edge_side_units : R := 3.
Definition edge_length_units : R := 6.
(* Factors: of one, two and three errors of a component. *)
Definition once : R := 1.0625.
Definition once_offset : R := 1.125.
Definition twice : R := 2.125.
Definition thrice_in_side : R := 3.1.
Definition thrice : R := 3.2.

Definition greatest_component (v : vec) := Rmax (Rmax (Rabs (cx v)) (Rabs (cy v))) (Rabs (cz v)).
Definition total (v : vec) := Rabs (cx v) + Rabs (cy v) + Rabs (cz v).
(* The share of the bound that is kept after its own rounding. *)
Definition kept : R := 31 / 32.

Section Margins.
  Variable u : R.
  Hypothesis u_range : 0 <= u <= / 1048576.
  Notation rounds := (rounds u 0).
  (* The premises: a dot product, a b - c d, a cross product, x - y. *)
  Definition near_dot (X Y : vec) (D : R) := Rabs (D - dot X Y) <= 3.001 * u * sizes X Y.
  Definition near_difference (a b c d D : R) := Rabs (D - (a * b - c * d)) <= 2.001 * u * (Rabs (a * b) + Rabs (c * d)).
  Definition near_cross (X Y N : vec) : Prop :=
    near_difference (cy X) (cz Y) (cz X) (cy Y) (cx N) /\ near_difference (cz X) (cx Y) (cx X) (cz Y) (cy N) /\
    near_difference (cx X) (cy Y) (cy X) (cx Y) (cz N).
  Definition near_minus (x y M : R) := Rabs (M - (x - y)) <= u * (Rabs x + Rabs y).
  Notation leaf_of := (leaf_of u).
  Definition units (n : R) := n * (u * unit_factor).

  Local Notation small := (small u u_range).
  Local Notation smaller := (smaller u u_range).

  (* Errors relative to the computed value. *)
  Lemma rounded_back x X : rounds x X -> Rabs (x - X) <= 1.001 * u * Rabs X.
  Proof using All.
    unfold Lanes.rounds. intros H. rewrite Rplus_0_r in H.
    assert (Rabs x <= Rabs X + u * Rabs x) as up.
    { replace x with (X - (X - x)) at 1 by ring. unfold Rminus at 1. eapply Rle_trans; [apply Rabs_triang |].
      rewrite Rabs_Ropp. lra. }
    pose proof (small (Rabs x) (Rabs_pos x)). rewrite Rabs_minus_sym in H.
    pose proof (smaller (Rabs x) (Rabs_pos x)).
    assert (u * Rabs x <= u * (Rabs X + u * Rabs x)) by (apply Rmult_le_compat_l; lra). lra.
  Qed.

  Definition near_leaf (x X : vec) :=
    Rabs (cx x - cx X) <= 1.001 * u * Rabs (cx X) /\ Rabs (cy x - cy X) <= 1.001 * u * Rabs (cy X) /\
    Rabs (cz x - cz X) <= 1.001 * u * Rabs (cz X).
  Lemma leaf_back x X : leaf_of x X -> near_leaf x X.
  Proof using All. intros (? & ? & ?). repeat split; apply rounded_back; unfold Lanes.rounds; lra. Qed.

  Lemma greatest_nonneg v : 0 <= greatest_component v.
  Proof using Type. unfold greatest_component. eapply Rle_trans; [apply (Rabs_pos (cz v)) | apply Rmax_r]. Qed.
  Lemma at_most_greatest v : Rabs (cx v) <= greatest_component v /\ Rabs (cy v) <= greatest_component v /\ Rabs (cz v) <= greatest_component v.
  Proof using Type.
    unfold greatest_component. pose proof (Rmax_l (Rabs (cx v)) (Rabs (cy v))). pose proof (Rmax_r (Rabs (cx v)) (Rabs (cy v))).
    pose proof (Rmax_l (Rmax (Rabs (cx v)) (Rabs (cy v))) (Rabs (cz v))).
    pose proof (Rmax_r (Rmax (Rabs (cx v)) (Rabs (cy v))) (Rabs (cz v))). lra.
  Qed.
  Lemma total_nonneg v : 0 <= total v.
  Proof using Type. unfold total. pose proof (Rabs_pos (cx v)). pose proof (Rabs_pos (cy v)). pose proof (Rabs_pos (cz v)). lra. Qed.

  Lemma product_at_most a b x y : Rabs a <= x -> Rabs b <= y -> Rabs (a * b) <= x * y.
  Proof using Type. intros. rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.

  Lemma sizes_greatest x y : sizes x y <= 3 * (greatest_component x * greatest_component y).
  Proof using All.
    unfold sizes. destruct (at_most_greatest x) as (? & ? & ?), (at_most_greatest y) as (? & ? & ?).
    pose proof (product_at_most (cx x) (cx y) (greatest_component x) (greatest_component y)).
    pose proof (product_at_most (cy x) (cy y) (greatest_component x) (greatest_component y)).
    pose proof (product_at_most (cz x) (cz y) (greatest_component x) (greatest_component y)). intuition lra.
  Qed.
  Lemma sizes_mixed x y : sizes x y <= greatest_component x * total y.
  Proof using Type.
    unfold sizes, total. destruct (at_most_greatest x) as (? & ? & ?).
    pose proof (product_at_most (cx x) (cx y) (greatest_component x) (Rabs (cx y)) ltac:(assumption) ltac:(lra)).
    pose proof (product_at_most (cy x) (cy y) (greatest_component x) (Rabs (cy y)) ltac:(assumption) ltac:(lra)).
    pose proof (product_at_most (cz x) (cz y) (greatest_component x) (Rabs (cz y)) ltac:(assumption) ltac:(lra)). lra.
  Qed.
  Lemma sizes_total x y : sizes x y <= total x * total y.
  Proof using Type.
    eapply Rle_trans; [apply sizes_mixed |]. apply Rmult_le_compat_r; [apply total_nonneg |].
    unfold greatest_component, total. pose proof (Rabs_pos (cx x)). pose proof (Rabs_pos (cy x)). pose proof (Rabs_pos (cz x)).
    repeat apply Rmax_lub; lra.
  Qed.
  Lemma sizes_nonneg x y : 0 <= sizes x y.
  Proof using Type. unfold sizes. pose proof (Rabs_pos (cx x * cx y)). pose proof (Rabs_pos (cy x * cy y)). pose proof (Rabs_pos (cz x * cz y)). lra. Qed.
  Lemma sizes_square x : sizes x x = dot x x.
  Proof using Type. unfold sizes, dot. rewrite !Rabs_pos_eq by (apply Rle_0_sqr). reflexivity. Qed.

  (* A product of two components of leaves. *)
  Lemma leaf_times a b A B : Rabs (a - A) <= 1.001 * u * Rabs A -> Rabs (b - B) <= 1.001 * u * Rabs B ->
    Rabs (a * b - A * B) <= 2.003 * u * Rabs (A * B).
  Proof using All.
    intros Ha Hb. pose proof (times_off _ _ _ _ _ _ Ha Hb) as H. rewrite Rabs_mult.
    assert (0 <= Rabs A * Rabs B) as s0 by (apply Rmult_le_pos; apply Rabs_pos). set (s := Rabs A * Rabs B) in *.
    replace (1.001 * u * Rabs A * Rabs B + Rabs A * (1.001 * u * Rabs B) + 1.001 * u * Rabs A * (1.001 * u * Rabs B))
      with (2.002 * (u * s) + 1.002001 * (u * u * s)) in H by (unfold s; lra).
    pose proof (small s s0). pose proof (smaller s s0). lra.
  Qed.

  Lemma leaf_dot a b A B D : near_leaf a A -> near_leaf b B -> near_dot A B D ->
    Rabs (D - dot a b) <= 5.004 * u * sizes A B.
  Proof using All.
    intros (ax & ay & az) (bx & by_ & bz) HD. unfold near_dot in HD.
    pose proof (leaf_times _ _ _ _ ax bx) as X. pose proof (leaf_times _ _ _ _ ay by_) as Y. pose proof (leaf_times _ _ _ _ az bz) as Z.
    rewrite Rabs_minus_sym in X, Y, Z.
    replace (D - dot a b) with ((D - dot A B) + (((cx A * cx B - cx a * cx b) + (cy A * cy B - cy a * cy b)) + (cz A * cz B - cz a * cz b)))
      by (unfold dot; ring).
    eapply Rle_trans; [apply Rabs_triang |]. eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang |].
    eapply Rle_trans; [apply Rplus_le_compat_l, Rplus_le_compat_r, Rabs_triang |]. unfold sizes in *.
    lra.
  Qed.

  (* Each component has an error of at most e. *)
  Definition off_by (e : R) (v V : vec) := Rabs (cx v - cx V) <= e /\ Rabs (cy v - cy V) <= e /\ Rabs (cz v - cz V) <= e.

  Lemma leaf_difference a b c d A B C D E x y : Rabs (a - A) <= 1.001 * u * Rabs A -> Rabs (b - B) <= 1.001 * u * Rabs B ->
    Rabs (c - C) <= 1.001 * u * Rabs C -> Rabs (d - D) <= 1.001 * u * Rabs D ->
    Rabs A <= x -> Rabs B <= y -> Rabs C <= x -> Rabs D <= y ->
    near_difference A B C D E -> Rabs (a * b - c * d - E) <= 8.012 * u * (x * y).
  Proof using All.
    intros Ha Hb Hc Hd. intros. pose proof (leaf_times _ _ _ _ Ha Hb) as L1. pose proof (leaf_times _ _ _ _ Hc Hd) as L2.
    assert (near_difference A B C D E) as L3 by assumption. unfold near_difference in L3. rewrite Rabs_minus_sym in L3.
    pose proof (product_at_most A B x y ltac:(assumption) ltac:(assumption)) as s1.
    pose proof (product_at_most C D x y ltac:(assumption) ltac:(assumption)) as s2.
    apply (Rmult_le_compat_l u) in s1, s2; try lra. pose proof (small _ (Rabs_pos (A * B))).
    pose proof (minus_off _ _ _ _ _ _ L1 L2) as L4.
    replace (a * b - c * d - E) with ((a * b - c * d - (A * B - C * D)) + (A * B - C * D - E)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. lra.
  Qed.

  Lemma leaf_cross a b A B N : near_leaf a A -> near_leaf b B -> near_cross A B N ->
    off_by (8.012 * u * (greatest_component A * greatest_component B)) (cross a b) N.
  Proof using All.
    intros (ax & ay & az) (bx & by_ & bz) (HX & HY & HZ).
    destruct (at_most_greatest A) as (? & ? & ?), (at_most_greatest B) as (? & ? & ?).
    unfold off_by, cross. cbn [cx cy cz]. repeat split; eapply leaf_difference; eassumption.
  Qed.

  Lemma off_dot e f n m N M : 0 <= e -> 0 <= f -> off_by e n N -> off_by f m M ->
    Rabs (dot n m - dot N M) <= f * total N + e * total M + 3 * (e * f).
  Proof using Type.
    intros e0 f0 (nx & ny & nz) (mx & my & mz).
    pose proof (times_off _ _ _ _ _ _ nx mx) as X. pose proof (times_off _ _ _ _ _ _ ny my) as Y. pose proof (times_off _ _ _ _ _ _ nz mz) as Z.
    replace (dot n m - dot N M) with (((cx n * cx m - cx N * cx M) + (cy n * cy m - cy N * cy M)) + (cz n * cz m - cz N * cz M))
      by (unfold dot; ring).
    eapply Rle_trans; [apply Rabs_triang |]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang |]. unfold total. lra.
  Qed.

  Lemma off_leaf_dot w a v A V : 0 <= w -> near_leaf a A -> off_by w v V ->
    Rabs (dot a v - dot A V) <= greatest_component A * (3.001 * w + 1.001 * u * total V).
  Proof using All.
    intros w0 (ax & ay & az) (vx & vy & vz). destruct (at_most_greatest A) as (gx & gy & gz).
    assert (component : forall x X t T, Rabs (x - X) <= 1.001 * u * Rabs X -> Rabs X <= greatest_component A -> Rabs (t - T) <= w ->
      Rabs (x * t - X * T) <= greatest_component A * (1.0003 * w + 1.001 * u * Rabs T)).
    { intros x X t T hx g ht. pose proof (times_off _ _ _ _ _ _ hx ht) as H. eapply Rle_trans; [exact H |].
      replace (1.001 * u * Rabs X * Rabs T + Rabs X * w + 1.001 * u * Rabs X * w)
        with (Rabs X * (w + 1.001 * (u * w) + 1.001 * u * Rabs T)) by ring.
      pose proof (small w w0). pose proof (small (Rabs T) (Rabs_pos T)).
      apply Rmult_le_compat; [apply Rabs_pos | lra | assumption | lra]. }
    pose proof (component _ _ _ _ ax gx vx). pose proof (component _ _ _ _ ay gy vy). pose proof (component _ _ _ _ az gz vz).
    replace (dot a v - dot A V) with (((cx a * cx v - cx A * cx V) + (cy a * cy v - cy A * cy V)) + (cz a * cz v - cz A * cz V))
      by (unfold dot; ring).
    eapply Rle_trans; [apply Rabs_triang |]. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang |].
    unfold total. pose proof (Rmult_le_pos _ _ (greatest_nonneg A) w0). lra.
  Qed.

  (* A square, bounded from its computed value. *)
  Lemma square_back N nn : near_dot N N nn -> 0 <= nn /\ Rabs (nn - dot N N) <= 3.01 * u * nn.
  Proof using All.
    intros H. unfold near_dot in H. rewrite sizes_square in H. pose proof (dot_self_nonneg N) as s0.
    pose proof (small _ s0). pose proof (smaller _ s0). apply Rabs_le_inv in H as H'.
    assert (0 <= nn) by lra. split; [assumption |]. eapply Rle_trans; [exact H |].
    assert (u * dot N N <= u * (1.00001 * nn)) by (apply Rmult_le_compat_l; lra). lra.
  Qed.

  Lemma radius_back r rr : rounds (r * r) rr -> 0 <= rr /\ Rabs (rr - r * r) <= 1.001 * u * rr.
  Proof using All.
    intros Hrr. apply rounded_back in Hrr. assert (0 <= r * r) as r0 by (apply Rle_0_sqr).
    assert (0 <= rr) as rr0.
    { apply Rabs_le_inv in Hrr. destruct (Rle_or_lt 0 rr) as [| negative]; [assumption |].
      rewrite Rabs_left in Hrr by assumption. pose proof (small (- rr) ltac:(lra)). lra. }
    rewrite Rabs_minus_sym, (Rabs_pos_eq rr rr0) in Hrr. split; assumption.
  Qed.

  (* |A|^2 - r^2. *)
  Theorem vertex_radius_bound a A aa r rr M : leaf_of a A -> near_dot A A aa -> rounds (r * r) rr -> near_minus aa rr M ->
    Rabs (M - (dot a a - r * r)) <= kept * (units vertex_radius_units * (aa + rr)).
  Proof using All.
    intros la Haa Hrr HM. apply leaf_back in la. pose proof (square_back _ _ Haa) as [aa0 back].
    pose proof (leaf_dot _ _ _ _ _ la la Haa) as first. rewrite sizes_square in first.
    destruct (radius_back _ _ Hrr) as [rr0 Hrr']. clear Hrr. rename Hrr' into Hrr. unfold near_minus in HM.
    rewrite (Rabs_pos_eq aa aa0), (Rabs_pos_eq rr rr0) in HM.
    apply Rabs_le_inv in back. pose proof (small _ aa0). pose proof (smaller _ aa0).
    assert (u * dot A A <= u * (aa + 3.01 * u * aa)) by (apply Rmult_le_compat_l; lra).
    pose proof (minus_off _ _ _ _ _ _ first Hrr) as both.
    replace (M - (dot a a - r * r)) with ((M - (aa - rr)) + (aa - rr - (dot a a - r * r))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. unfold kept, units, unit_factor, vertex_radius_units.
    pose proof (small _ rr0). lra.
  Qed.

  (* A.(B - A). *)
  Theorem vertex_side_bound a ab A AB M : leaf_of a A -> leaf_of ab AB -> near_dot A AB M ->
    Rabs (M - dot a ab) <= kept * (units vertex_side_units * (greatest_component A * greatest_component AB)).
  Proof using All.
    intros la lab H. apply leaf_back in la, lab. pose proof (leaf_dot _ _ _ _ _ la lab H). pose proof (sizes_greatest A AB) as s.
    apply (Rmult_le_compat_l u) in s; [| lra]. unfold kept, units, unit_factor, vertex_side_units.
    assert (0 <= u * (greatest_component A * greatest_component AB)).
    { apply Rmult_le_pos; [lra | apply Rmult_le_pos; apply greatest_nonneg]. }
    lra.
  Qed.

  (* The error of a cross product's components, as in the bound: nu for N, omega for V. *)
  Definition component_error (A B : vec) := units normal_units * (greatest_component A * greatest_component B).
  Lemma component_error_nonneg A B : 0 <= component_error A B.
  Proof using All.
    unfold component_error, units, unit_factor, normal_units. pose proof (greatest_nonneg A). pose proof (greatest_nonneg B).
    apply Rmult_le_pos; [lra | apply Rmult_le_pos; assumption].
  Qed.
  Lemma cross_back a b A B N : leaf_of a A -> leaf_of b B -> near_cross A B N ->
    off_by (0.943 * component_error A B) (cross a b) N.
  Proof using All.
    intros la lb H. apply leaf_back in la, lb. pose proof (leaf_cross _ _ _ _ _ la lb H) as (X & Y & Z).
    assert (8.012 * u * (greatest_component A * greatest_component B) <= 0.943 * component_error A B).
    { unfold component_error, units, unit_factor, normal_units. assert (0 <= greatest_component A * greatest_component B) as g0
        by (apply Rmult_le_pos; apply greatest_nonneg). pose proof (small _ g0). lra. }
    repeat split; eapply Rle_trans; eassumption.
  Qed.

  (* V = CA x AB. Where B = C it is taken as zero, and so is omega. *)
  Definition computed_normal (ca ab CA AB V : vec) (omega : R) : Prop :=
    leaf_of ca CA /\ leaf_of ab AB /\
    (near_cross CA AB V /\ omega = component_error CA AB \/
     V = Vec 0 0 0 /\ omega = 0 /\ cross ca ab = Vec 0 0 0).
  Lemma normal_back ca ab CA AB V omega : computed_normal ca ab CA AB V omega ->
    0 <= omega /\ off_by (0.943 * omega) (cross ca ab) V.
  Proof using All.
    intros (lca & lab & [[H ->] | (-> & -> & ->)]).
    - split; [apply component_error_nonneg | apply cross_back; assumption].
    - split; [lra |]. unfold off_by. cbn [cx cy cz]. rewrite Rminus_eq_0, Rabs_R0. repeat split; lra.
  Qed.

  Lemma off_square e n N nn : 0 <= e -> off_by (0.943 * e) n N -> near_dot N N nn ->
    0 <= nn /\ Rabs (nn - dot n n) <= 3.01 * u * nn + e * (1.886 * total N + 2.67 * e).
  Proof using All.
    intros e0 off H. destruct (square_back _ _ H) as [nn0 back]. split; [assumption |].
    pose proof (off_dot (0.943 * e) (0.943 * e) n n N N ltac:(lra) ltac:(lra) off off) as change. rewrite Rabs_minus_sym in change.
    replace (nn - dot n n) with ((nn - dot N N) + (dot N N - dot n n)) by ring. eapply Rle_trans; [apply Rabs_triang |].
    assert (0 <= e * e) by nra. lra.
  Qed.

  (* r^2 e, both computed, where e has the error X and that of three roundings, or of five. *)
  Lemma product_back k x rr RR e E X : 0 <= k <= 6 -> 0 <= x -> 0 <= RR -> 0 <= E -> Rabs (RR - rr) <= 1.001 * u * RR ->
    Rabs (E - e) <= k * u * E + x -> rounds (RR * E) X ->
    0 <= X /\ Rabs (X - rr * e) <= (k + 2.01) * u * X + 1.001 * (RR * x).
  Proof using All.
    intros k0 x0 RR0 E0 Hr He HX. rewrite Rabs_minus_sym in Hr, He. pose proof (times_off _ _ _ _ _ _ Hr He) as H.
    apply rounded_back in HX. rewrite (Rabs_pos_eq RR RR0), (Rabs_pos_eq E E0) in H.
    assert (0 <= RR * E) as s0 by (apply Rmult_le_pos; assumption). assert (0 <= RR * x) as t0 by (apply Rmult_le_pos; assumption).
    set (s := RR * E) in *. set (t := RR * x) in *.
    assert (0 <= X) as X0.
    { apply Rabs_le_inv in HX. destruct (Rle_or_lt 0 X) as [| negative]; [assumption |].
      rewrite Rabs_left in HX by assumption. pose proof (small (- X) ltac:(lra)). lra. }
    split; [assumption |]. rewrite (Rabs_pos_eq X X0) in HX.
    replace (1.001 * u * RR * E + RR * (k * u * E + x) + 1.001 * u * RR * (k * u * E + x))
      with (1.001 * (u * s) + k * (u * s) + t + 1.001 * k * (u * u * s) + 1.001 * (u * t)) in H by (unfold s, t; lra).
    pose proof (small s s0). pose proof (smaller s s0). pose proof (small t t0). pose proof (small X X0). pose proof (smaller X X0).
    apply Rabs_le_inv in HX as HX'. rewrite Rabs_minus_sym in HX, H.
    assert (u * s <= u * (X + 1.001 * u * X)) as us by (apply Rmult_le_compat_l; lra).
    replace (X - rr * e) with ((X - s) + (s - rr * e)) by ring. eapply Rle_trans; [apply Rabs_triang |].
    assert (k * (u * s) <= k * (u * (X + 1.001 * u * X))) by (apply Rmult_le_compat_l; lra).
    assert (k * (u * u * s) <= 6 * (u * u * s)) by (apply Rmult_le_compat_r; lra).
    assert (k * (u * u * X) <= 6 * (u * u * X)) by (apply Rmult_le_compat_r; lra). lra.
  Qed.

  Lemma rounded_difference X Y M : 0 <= X -> 0 <= Y -> near_minus X Y M -> Rabs (M - (X - Y)) <= u * X + u * Y.
  Proof using Type. intros X0 Y0 H. unfold near_minus in H. rewrite (Rabs_pos_eq X X0), (Rabs_pos_eq Y Y0) in H. lra. Qed.

  (* d^2 - r^2 |V|^2. *)
  Definition offset_error (A V : vec) (omega : R) := greatest_component A * (units offset_units * total V + thrice * omega).
  Definition plane_bound (A V : vec) (omega D rr lhs rhs : R) :=
    let delta := offset_error A V omega in
    (delta * (twice * Rabs D + delta * once_offset) + units plane_lhs_units * lhs) +
    (rr * (omega * (twice * total V + thrice * omega)) + units plane_rhs_units * rhs).
  Theorem plane_radius_bound a A ca ab CA AB V omega D E r rr lhs rhs M :
    leaf_of a A -> computed_normal ca ab CA AB V omega -> near_dot A V D -> near_dot V V E -> rounds (r * r) rr ->
    rounds (D * D) lhs -> rounds (rr * E) rhs -> near_minus lhs rhs M ->
    let v := cross ca ab in
    Rabs (M - (dot a v * dot a v - r * r * dot v v)) <= kept * plane_bound A V omega D rr lhs rhs.
  Proof using All.
    intros la HV HD HE Hrr Hl Hr HM v. destruct (normal_back _ _ _ _ _ _ HV) as [omega0 off]. apply leaf_back in la. fold v in off.
    destruct (radius_back _ _ Hrr) as [rr0 back_rr]. clear Hrr.
    unfold plane_bound. set (delta := offset_error A V omega).
    pose proof (greatest_nonneg A) as g0. pose proof (total_nonneg V) as t0. pose proof (small _ t0) as ut.
    assert (Rabs (dot a v - D) <= 0.944 * delta) as Hd.
    { pose proof (off_leaf_dot (0.943 * omega) _ _ _ _ ltac:(lra) la off) as H. unfold near_dot in HD.
      pose proof (sizes_mixed A V) as sm. apply (Rmult_le_compat_l u) in sm; [| lra]. rewrite Rabs_minus_sym in HD.
      replace (dot a v - D) with ((dot a v - dot A V) + (dot A V - D)) by ring. eapply Rle_trans; [apply Rabs_triang |].
      unfold delta, offset_error, units, unit_factor, offset_units, thrice.
      pose proof (Rmult_le_pos _ _ g0 omega0). assert (0 <= u * (greatest_component A * total V)).
      { apply Rmult_le_pos; [lra |]. apply Rmult_le_pos; assumption. }
      lra. }
    assert (0 <= delta) as delta0.
    { apply Rmult_le_pos; [assumption |]. unfold units, unit_factor, offset_units, thrice. lra. }
    clearbody delta.
    pose proof (times_off _ _ _ _ _ _ Hd Hd) as square. apply rounded_back in Hl.
    assert (0 <= D * D) as DD0 by (apply Rle_0_sqr).
    assert (0 <= lhs) as lhs0.
    { apply Rabs_le_inv in Hl. destruct (Rle_or_lt 0 lhs) as [| negative]; [assumption |].
      rewrite Rabs_left in Hl by assumption. pose proof (small (- lhs) ltac:(lra)). lra. }
    rewrite (Rabs_pos_eq lhs lhs0) in Hl.
    destruct (off_square omega v V E omega0 off HE) as [E0 back_E].
    assert (0 <= omega * (1.886 * total V + 2.67 * omega)) as x0 by (apply Rmult_le_pos; lra).
    destruct (product_back 3.01 _ _ _ _ _ _ ltac:(lra) x0 rr0 E0 back_rr back_E Hr) as [rhs0 back_rhs].
    pose proof (rounded_difference _ _ _ lhs0 rhs0 HM) as last. rewrite Rabs_minus_sym in Hl, square.
    replace (M - (dot a v * dot a v - r * r * dot v v))
      with ((M - (lhs - rhs)) + ((lhs - D * D) + (D * D - dot a v * dot a v) - (rhs - r * r * dot v v))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. unfold Rminus at 3.
    eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang |]. rewrite Rabs_Ropp.
    eapply Rle_trans; [apply Rplus_le_compat_l, Rplus_le_compat_r, Rabs_triang |].
    unfold kept, twice, once_offset, thrice, units, unit_factor, plane_lhs_units, plane_rhs_units.
    pose proof (Rmult_le_pos _ _ delta0 (Rabs_pos D)). pose proof (Rmult_le_pos _ _ delta0 delta0).
    assert (0 <= rr * (omega * total V)) by (repeat apply Rmult_le_pos; assumption).
    assert (0 <= rr * (omega * omega)) by (repeat apply Rmult_le_pos; assumption).
    pose proof (small _ lhs0). pose proof (small _ rhs0). lra.
  Qed.

  (* |N|^2 - r^2 |AB|^2. *)
  Definition edge_radius_limit (N : vec) (nu nn rr_e : R) :=
    nu * (twice * total N + thrice * nu) + (units edge_square_units * nn + units edge_rhs_units * rr_e).
  Theorem edge_radius_bound a ab A AB N nn e r rr rr_e M :
    leaf_of a A -> leaf_of ab AB -> near_cross A AB N -> near_dot N N nn -> near_dot AB AB e -> rounds (r * r) rr ->
    rounds (rr * e) rr_e -> near_minus nn rr_e M ->
    let n := cross a ab in
    Rabs (M - (dot n n - r * r * dot ab ab)) <= kept * edge_radius_limit N (component_error A AB) nn rr_e.
  Proof using All.
    intros la lab HN Hnn He Hrr Hre HM n. pose proof (cross_back _ _ _ _ _ la lab HN) as off. fold n in off.
    pose proof (component_error_nonneg A AB) as nu0. set (nu := component_error A AB) in *. clearbody nu.
    destruct (radius_back _ _ Hrr) as [rr0 back_rr]. clear Hrr.
    destruct (off_square nu n N nn nu0 off Hnn) as [nn0 back_nn]. apply leaf_back in lab.
    destruct (square_back _ _ He) as [e0 back_e]. pose proof (leaf_dot _ _ _ _ _ lab lab He) as dot_e.
    rewrite sizes_square in dot_e.
    assert (Rabs (e - dot ab ab) <= 5.01 * u * e + 0) as e_off.
    { apply Rabs_le_inv in back_e. pose proof (small _ e0). pose proof (smaller _ e0).
      assert (u * dot AB AB <= u * (e + 3.01 * u * e)) by (apply Rmult_le_compat_l; lra). lra. }
    destruct (product_back 5.01 0 _ _ _ _ _ ltac:(lra) ltac:(lra) rr0 e0 back_rr e_off Hre) as [re0 back_re].
    pose proof (rounded_difference _ _ _ nn0 re0 HM) as last.
    replace (M - (dot n n - r * r * dot ab ab)) with ((M - (nn - rr_e)) + ((nn - dot n n) - (rr_e - r * r * dot ab ab))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. unfold Rminus at 3.
    eapply Rle_trans; [apply Rplus_le_compat_l, Rabs_triang |]. rewrite Rabs_Ropp.
    unfold edge_radius_limit, kept, twice, thrice, units, unit_factor, edge_square_units, edge_rhs_units.
    pose proof (Rmult_le_pos _ _ nu0 (total_nonneg N)). pose proof (Rmult_le_pos _ _ nu0 nu0).
    pose proof (small _ nn0). pose proof (small _ re0). lra.
  Qed.

  (* -N.V. *)
  Definition edge_side_limit (N V : vec) (nu omega : R) :=
    omega * once * (thrice_in_side * nu + total N) + total V * (units edge_side_units * total N + nu * once).
  Theorem edge_side_bound a ab A AB N ca ab' CA AB' V omega M :
    leaf_of a A -> leaf_of ab AB -> near_cross A AB N -> computed_normal ca ab' CA AB' V omega -> near_dot N V M ->
    Rabs (- M - - dot (cross a ab) (cross ca ab')) <= kept * edge_side_limit N V (component_error A AB) omega.
  Proof using All.
    intros la lab HN HV HM. pose proof (cross_back _ _ _ _ _ la lab HN) as off.
    destruct (normal_back _ _ _ _ _ _ HV) as [omega0 off']. pose proof (component_error_nonneg A AB) as nu0.
    set (nu := component_error A AB) in *. clearbody nu. unfold near_dot in HM.
    pose proof (off_dot (0.943 * nu) (0.943 * omega) _ _ _ _ ltac:(lra) ltac:(lra) off off') as change.
    pose proof (sizes_total N V) as sm. apply (Rmult_le_compat_l u) in sm; [| lra]. rewrite Rabs_minus_sym in HM.
    replace (- M - - dot (cross a ab) (cross ca ab')) with ((dot (cross a ab) (cross ca ab') - dot N V) + (dot N V - M)) by ring.
    eapply Rle_trans; [apply Rabs_triang |].
    unfold edge_side_limit, kept, once, thrice_in_side, units, unit_factor, edge_side_units.
    pose proof (total_nonneg N) as n0. pose proof (total_nonneg V) as v0. pose proof (Rmult_le_pos _ _ omega0 n0).
    pose proof (Rmult_le_pos _ _ nu0 v0). pose proof (Rmult_le_pos _ _ omega0 nu0).
    assert (0 <= u * (total N * total V)) by (repeat apply Rmult_le_pos; lra). lra.
  Qed.

  (* A margin of an edge times |AB|^2: the published form. *)
  Theorem times_length_bound m M limit ab AB e T : leaf_of ab AB -> near_dot AB AB e -> 0 <= limit ->
    Rabs (M - m) <= kept * limit -> rounds (M * e) T ->
    Rabs (T - m * dot ab ab) <= kept * ((e * limit + units edge_length_units * Rabs T) * once).
  Proof using All.
    intros lab He limit0 Hm HT. apply leaf_back in lab. destruct (square_back _ _ He) as [e0 back_e].
    pose proof (leaf_dot _ _ _ _ _ lab lab He) as dot_e. rewrite sizes_square in dot_e.
    assert (Rabs (dot ab ab - e) <= 5.01 * u * e) as e_off.
    { rewrite Rabs_minus_sym. apply Rabs_le_inv in back_e. pose proof (small _ e0). pose proof (smaller _ e0).
      assert (u * dot AB AB <= u * (e + 3.01 * u * e)) by (apply Rmult_le_compat_l; lra). lra. }
    rewrite Rabs_minus_sym in Hm. pose proof (times_off _ _ _ _ _ _ Hm e_off) as H. apply rounded_back in HT.
    rewrite (Rabs_pos_eq e e0) in H.
    assert (0 <= limit * e) as le0 by (apply Rmult_le_pos; assumption). pose proof (small _ le0).
    assert (Rabs (M * e) = Rabs M * e) as size by (rewrite Rabs_mult, (Rabs_pos_eq e e0); reflexivity).
    assert (Rabs (M * e) <= Rabs T + 1.001 * u * Rabs T) as up.
    { replace (M * e) with (T + (M * e - T)) by ring. eapply Rle_trans; [apply Rabs_triang |]. lra. }
    rewrite size in up. apply (Rmult_le_compat_l u) in up; [| lra]. pose proof (smaller _ (Rabs_pos T)). pose proof (small _ (Rabs_pos T)).
    rewrite Rabs_minus_sym in HT, H.
    replace (T - m * dot ab ab) with ((T - M * e) + (M * e - m * dot ab ab)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. unfold kept, units, unit_factor, edge_length_units, once in *. lra.
  Qed.

  (* Doubles, whose operations have an error relative to their results, meet the premises. *)
  Theorem double_dot_near X Y D : computed_dot u 0 X Y D -> near_dot X Y D.
  Proof using All. intros H. apply dot_error in H; unfold near_dot; lra. Qed.
  Lemma double_difference_near a b c d D : computed_difference u 0 a b c d D -> near_difference a b c d D.
  Proof using All. intros H. apply difference_error in H; unfold near_difference; lra. Qed.
  Theorem double_cross_near X Y N : computed_cross u 0 X Y N -> near_cross X Y N.
  Proof using All. intros (x & y & z). repeat split; apply double_difference_near; assumption. Qed.
  Theorem double_minus_near x y M : rounds (x - y) M -> near_minus x y M.
  Proof using All.
    unfold Lanes.rounds, near_minus. intros H. rewrite Rplus_0_r in H.
    assert (Rabs (x - y) <= Rabs x + Rabs y) by (unfold Rminus; rewrite <- (Rabs_Ropp y); apply Rabs_triang).
    assert (u * Rabs (x - y) <= u * (Rabs x + Rabs y)) by (apply Rmult_le_compat_l; lra). lra.
  Qed.
End Margins.

(* The double that is compared, L, is the leading one of the pair M: beyond the bound it has the sign of the exact m. *)
Theorem sign_of_leading m M L bound : 0 <= bound -> Rabs (M - m) <= kept * bound -> Rabs (L - M) <= / 1048576 * Rabs M ->
  (bound < L -> 0 < m) /\ (L < - bound -> m < 0).
Proof. unfold kept. intros. split; intros; unfold Rabs in *; repeat destruct Rcase_abs; lra. Qed.
