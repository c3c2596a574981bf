(* The conservative test as recorded from the code that runs is the program of ConservativeStep.v, over rounding to nearest with
   gradual underflow; so what is proved of that program is proved of the code, except overflow: it never misses a contact, and
   its phantoms are shallow. The section states the program once more with answers that are bits and with the code's constants;
   its abbreviations are those of ConservativeStep.v, which do not leave the section there. *)
From Coq Require Import Reals ZArith Bool List Lra Lia.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Exact Expression Format Lanes Certified CertifiedStep Conservative ConservativeStep Phantom PhantomStep
  Machine RecordedCertified.
Import ListNotations.
Open Scope R_scope.

Lemma less_real_is x y : less_real x y = true <-> x < y.
Proof. unfold less_real. destruct Rlt_dec; split; intros; try reflexivity; try discriminate; assumption || contradiction. Qed.
Lemma at_most_real_is x y : at_most_real x y = true <-> x <= y.
Proof. unfold at_most_real. destruct Rle_dec; split; intros; try reflexivity; try discriminate; assumption || contradiction. Qed.

Section Program.
  Variable rnd : R -> R.
  Variables prec least least_normal greatest : Z.
  Variables (a b c p : vec) (r : R).
  Let A := rounded_sub rnd a p.
  Let B := rounded_sub rnd b p.
  Let C := rounded_sub rnd c p.
  Let product := rounded_dot rnd false.
  Let aa := product A A.
  Let bb := product B B.
  Let cc := product C C.
  Let ab := product A B.
  Let bc := product B C.
  Let ca := product C A.
  Let rr := rnd (r * r).
  Let W := conservative_W rnd a b c p r.
  Let number n e := IZR n * bpow radix2 e.
  Let one := number 1 0.
  (* The constants as they are in the code. *)
  Let error := rnd (number 5 (1 - prec) * W).
  Let square_error := rnd (number 153 (-3 - prec) * W).
  Definition passes_b (m square : R) : bool := less_real 0 m && less_real (rnd (rnd (rr + square_error) * square)) (rnd (m * m)).
  Definition share_b (X along : vec) : R :=
    let e := product along along in Rmin (Rmax (if less_real 0 e then rnd (- product X along / e) else 0) 0) one.
  Let mix (s x y : R) := rnd (x + rnd (s * rnd (y - x))).
  Definition edge_b (X along : vec) (xx xy yy xz yz : R) : bool :=
    let s := share_b X along in
    let at_x := mix s xx xy in
    let at_y := mix s xy yy in
    passes_b (rnd (Rmin (Rmin at_x at_y) (mix s xz yz) - error)) (rnd (mix s at_x at_y + square_error)).
  Definition plane_b : bool :=
    let n := conservative_normal rnd a b c p r in
    let at_a := product A n in
    let side := if Rlt_dec at_a 0 then - Rabs one else Rabs one in
    at_most_real (number 1 least_normal) (product n n) &&
    passes_b (Rmin (Rmin (rnd (side * at_a)) (rnd (side * product B n))) (rnd (side * product C n))) (product n n).
  Definition squares : R := rnd (rnd (rnd (aa + bb) + cc) + rr).
  Definition known_b : bool :=
    at_most_real 0 r && (at_most_real (number 1 least) W && at_most_real squares (number 1 greatest)).
  Definition separated_b : bool :=
    edge_b A (rounded_sub rnd B A) aa ab bb ca bc || edge_b B (rounded_sub rnd C B) bb bc cc ab ca ||
    edge_b C (rounded_sub rnd A C) cc ca aa bc ab || plane_b.
  Definition conservative_answers : list bool := [separated_b && known_b; negb known_b].

  Lemma number_power e : number 1 e = bpow radix2 e. Proof. unfold number. ring. Qed.
  Lemma one_is : one = 1. Proof. unfold one. rewrite number_power. reflexivity. Qed.
  Lemma error_is : number 5 (1 - prec) = conservative_error * u prec.
  Proof. unfold number, conservative_error, u, Zminus. rewrite bpow_plus. change (bpow radix2 1) with 2. lra. Qed.
  Lemma square_error_is : number 153 (-3 - prec) = conservative_square_error * u prec.
  Proof. unfold number, conservative_square_error, u, Zminus. rewrite bpow_plus. change (bpow radix2 (-3)) with (/ 8). lra. Qed.

  Lemma share_is X along : share_b X along = conservative_share rnd X along.
  Proof. unfold share_b, conservative_share, less_real, product. rewrite one_is. destruct Rlt_dec; reflexivity. Qed.
  Hypothesis rounded_is_itself : forall x, rnd (rnd x) = rnd x.
  Hypothesis rounded_opposite : forall x, rnd (- x) = - rnd x.
  Lemma product_is_rounded X Y : exists x, product X Y = rnd x.
  Proof. unfold product, rounded_dot. eexists. reflexivity. Qed.
  Lemma signed_product t X Y : let side := if Rlt_dec t 0 then - Rabs one else Rabs one in
    rnd (side * product X Y) = (if Rlt_dec t 0 then - product X Y else product X Y).
  Proof.
    cbv zeta. destruct (product_is_rounded X Y) as [x ->]. rewrite one_is, Rabs_R1. destruct Rlt_dec.
    - replace (- (1) * rnd x) with (- rnd x) by ring. rewrite rounded_opposite, rounded_is_itself. reflexivity.
    - rewrite Rmult_1_l. apply rounded_is_itself.
  Qed.

  Theorem separated_is : separated_b = true <-> conservative_separated rnd (u prec) (bpow radix2 least_normal) a b c p r.
  Proof.
    assert (passes : forall m square, passes_b m square = true <->
      0 < m /\ rnd (rnd (rr + rnd (conservative_square_error * u prec * W)) * square) < rnd (m * m)).
    { intros m square. unfold passes_b, square_error. rewrite square_error_is, andb_true_iff, !less_real_is. reflexivity. }
    assert (edges : forall X along xx xy yy xz yz, edge_b X along xx xy yy xz yz = true <->
      conservative_edge rnd (u prec) a b c p r X along xx xy yy xz yz).
    { intros. unfold edge_b. cbv zeta. rewrite passes, share_is. unfold error, square_error. rewrite error_is, square_error_is. reflexivity. }
    unfold separated_b, conservative_separated. rewrite !orb_true_iff, !edges.
    assert (plane_b = true <-> conservative_plane rnd (u prec) (bpow radix2 least_normal) a b c p r) as plane.
    { unfold plane_b. cbv zeta. rewrite andb_true_iff, at_most_real_is, passes, number_power, !signed_product. reflexivity. }
    rewrite plane. unfold A, B, C, aa, bb, cc, ab, bc, ca, product. cbv zeta. tauto.
  Qed.
  Lemma known_is : known_b = true <-> 0 <= r /\ bpow radix2 least <= W /\ squares <= bpow radix2 greatest.
  Proof. unfold known_b. rewrite !andb_true_iff, !at_most_real_is, !number_power. reflexivity. Qed.
End Program.

Notation of_real_query f rnd a b c p r :=
  (f (real_machine rnd) (cx a) (cy a) (cz a) (cx b) (cy b) (cz b) (cx c) (cy c) (cz c) (cx p) (cy p) (cz p) r).
Notation nearest32 := (round radix2 (FLT_exp (-149) 24) ZnearestE).
Notation nearest64 := (round radix2 (FLT_exp (-1074) 53) ZnearestE).

(* Conversion leaves the operations alone: both sides have the same ones. *)
Local Strategy 1000 [Rmin Rmax Rabs bpow less_real at_most_real].
Theorem recorded_conservative32 rnd a b c p r : of_real_query conservative_plain_binary32_answers rnd a b c p r =
  conservative_answers rnd 24 (-42) (-60) 60 a b c p r.
Proof. destruct a, b, c, p. reflexivity. Qed.
Theorem recorded_conservative64 rnd a b c p r : of_real_query conservative_plain_binary64_answers rnd a b c p r =
  conservative_answers rnd 53 (-400) (-120) 400 a b c p r.
Proof. destruct a, b, c, p. reflexivity. Qed.

(* The code's answers are right: what it calls separated is; and where every point is farther than the depth that certified.h
   promises, it says so. *)
Definition recorded_conservative_is_right (prec emin : Z) (depth : Z * Z) (answers : vec -> vec -> vec -> vec -> R -> list bool) : Prop :=
  forall a b c p r, in_format prec emin a -> in_format prec emin b -> in_format prec emin c -> in_format prec emin p ->
  let unknown := nth 1 (answers a b c p r) true in
  let says := nth 0 (answers a b c p r) false in
  (says = true -> unknown = false /\ separated a b c p r) /\
  (unknown = false -> (forall X, in_triangle X a b c -> r + IZR (fst depth) * bpow radix2 (snd depth) * query_size a b c p r < distance p X) -> says = true).

Section Instance.
  Variables prec emin least least_normal greatest : Z.
  Context (prec_positive : Prec_gt_0 prec).
  Variable depth : Z * Z.
  Let promised := IZR (fst depth) * bpow radix2 (snd depth).
  Hypothesis positive : 0 <= promised.
  Hypothesis enough : phantom_depth * phantom_depth * u prec <= promised * promised.
  Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
  Lemma depth_is_enough : phantom_depth * sqrt (u prec) <= promised.
  Proof.
    assert (0 <= u prec) as u0 by apply bpow_ge_0. assert (0 <= phantom_depth) as d0 by (unfold phantom_depth; lra).
    rewrite <- (sqrt_square promised positive), <- (sqrt_square phantom_depth d0), <- sqrt_mult by (try apply Rmult_le_pos; assumption).
    apply sqrt_le_1_alt. exact enough.
  Qed.
  Lemma rounded_is_itself x : rnd (rnd x) = rnd x.
  Proof. apply round_generic; auto with typeclass_instances. apply generic_format_round; auto with typeclass_instances. Qed.
  Lemma size_nonneg a b c p r : 0 <= query_size a b c p r.
  Proof. unfold query_size. eapply Rle_trans; [apply (sqrt_pos (dot (sub p a) (sub p a))) |]. eapply Rle_trans; [apply Rmax_l | apply Rmax_l]. Qed.
  Lemma answers_are_right answers : (forall a b c p r, answers a b c p r = conservative_answers rnd prec least least_normal greatest a b c p r) ->
    conservative_never_misses prec emin least least_normal -> conservative_phantoms_shallow prec emin least least_normal ->
    recorded_conservative_is_right prec emin depth answers.
  Proof.
    intros same never shallow a b c p r fa fb fc fp. cbv zeta. rewrite same. unfold conservative_answers. cbn [nth].
    pose proof (known_is rnd least greatest a b c p r) as known.
    pose proof (separated_is rnd prec least_normal a b c p r rounded_is_itself (round_NE_opp radix2 (FLT_exp emin prec))) as says. split.
    - rewrite andb_true_iff, negb_false_iff. intros [apart in_range]. split; [exact in_range |].
      apply known in in_range as (r0 & large & _). apply (never a b c p r fa fb fc fp r0 large), says, apart.
    - rewrite negb_false_iff. intros in_range far. rewrite in_range, andb_true_r. apply known in in_range as (r0 & large & _).
      apply says, (shallow a b c p r fa fb fc fp r0 large). intros X inside. eapply Rle_lt_trans; [| apply far, inside].
      apply Rplus_le_compat_l, Rmult_le_compat_r; [apply size_nonneg | exact depth_is_enough].
  Qed.
End Instance.
Theorem recorded_conservative_is_right32 : recorded_conservative_is_right 24 (-149) promised_phantom_depth_binary32
  (fun a b c p r => of_real_query conservative_plain_binary32_answers nearest32 a b c p r).
Proof.
  apply (answers_are_right 24 (-149) (-42) (-60) 60 eq_refl); [cbn; lra | cbn; unfold phantom_depth; lra | intros; apply recorded_conservative32 |
    exact conservative_never_misses32 | exact conservative_phantoms_shallow32].
Qed.
Theorem recorded_conservative_is_right64 : recorded_conservative_is_right 53 (-1074) promised_phantom_depth_binary64
  (fun a b c p r => of_real_query conservative_plain_binary64_answers nearest64 a b c p r).
Proof.
  apply (answers_are_right 53 (-1074) (-400) (-120) 400 eq_refl); [cbn; lra | cbn; unfold phantom_depth; lra | intros; apply recorded_conservative64 |
    exact conservative_never_misses64 | exact conservative_phantoms_shallow64].
Qed.
