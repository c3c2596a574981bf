(* The certified predicate's first step for a single query, kernel/sphere_triangle/certified/pair_step-inl.h: one lane for
   each vertex. A lane is the coarse step of the triangle with its vertices renamed in turn, to the bit, of which it takes the
   axes of the vertex called A and of the edge AB, and the plane's. Each lane has S, E and thresholds of its own: they may
   differ in the last bit, since sums are taken in another order. *)
From Coq Require Import Reals ZArith Bool Lra.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Reduced Expression Format Run Filter Certified CertifiedStep Sizes CoarseFloat OpenSphere.
Open Scope R_scope.

(* The axes of a lane. *)
Definition lane_axis (holds : comparison -> Prop) : Prop :=
  holds plane_radius \/ (holds vertex_a_radius /\ holds vertex_a_side_b /\ holds vertex_a_side_c) \/
  (holds edge_ab_radius /\ holds edge_ab_side_c).
Definition lane_axis_b (holds : comparison -> bool) : bool :=
  holds plane_radius || (holds vertex_a_radius && holds vertex_a_side_b && holds vertex_a_side_c) ||
  (holds edge_ab_radius && holds edge_ab_side_c).
Lemma lane_axis_b_spec f : lane_axis_b f = true <-> lane_axis (fun K => f K = true).
Proof. unfold lane_axis_b, lane_axis. rewrite !orb_true_iff, !andb_true_iff. tauto. Qed.
Lemma lane_axis_mono (H H' : comparison -> Prop) : (forall K, H K -> H' K) -> lane_axis H -> lane_axis H'.
Proof. unfold lane_axis. intuition auto. Qed.

(* The three lanes have all seven axes. *)
Lemma lanes_have_all A B C rr (holds : R * R -> Prop) : some_axis (fun K => holds (reduced A B C rr K)) ->
  lane_axis (fun K => holds (reduced A B C rr K)) \/ lane_axis (fun K => holds (reduced B C A rr K)) \/
  lane_axis (fun K => holds (reduced C A B rr K)).
Proof. unfold some_axis, lane_axis. cbn [reduced published]. tauto. Qed.

Lemma turned_triangle X A B C : in_triangle X A B C -> in_triangle X B C A.
Proof.
  intros (u & v & w & u0 & v0 & w0 & sum & ->). exists v, w, u. repeat split; try assumption; [lra |].
  unfold combination. vec_ring.
Qed.
Lemma turned_separated A B C P r : separated B C A P r -> separated A B C P r.
Proof. intros far X inside. apply far, turned_triangle, inside. Qed.

Section Float.
  Variables prec emax least half : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Variable fused : bool.
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Notation real_vec := (real_vec prec emax).
  Notation emin := (3 - emax - prec)%Z.
  Notation margin := (float_margin prec emax _ _ fused).
  Notation threshold := (float_threshold prec emax _ _ fused).
  Notation in_range := (float_in_range prec emax _ _ fused least half).

  Definition lane_separated (a b c p : float_vec) (r : float) : bool :=
    in_range a b c p r && lane_axis_b (fun K => Bltb (threshold a b c p r K) (margin a b c p r K)).
  Definition lane_contact (a b c p : float_vec) (r : float) : bool :=
    in_range a b c p r && negb (lane_axis_b (fun K => negb (Bltb (margin a b c p r K) (Bopp (threshold a b c p r K))))).
  (* The step. *)
  Definition pair_separated (a b c p : float_vec) (r : float) : bool :=
    lane_separated a b c p r || lane_separated b c a p r || lane_separated c a b p r.
  Definition pair_contact (a b c p : float_vec) (r : float) : bool :=
    lane_contact a b c p r && lane_contact b c a p r && lane_contact c a b p r.

  Hypothesis fits : step_fits prec emax least half.
  Hypothesis never : coarse_never_lies prec emin least.

  Lemma lane_is_coarse a b c p r : lane_separated a b c p r = true ->
    float_separated prec emax _ _ fused least half a b c p r = true.
  Proof using Type.
    unfold lane_separated, float_separated. rewrite !andb_true_iff. intros [inside axis]. split; [assumption |].
    apply lane_axis_b_spec in axis. apply some_axis_b_spec. unfold lane_axis, some_axis in *. tauto.
  Qed.
  Lemma lane_says_separated a b c p r : lane_separated a b c p r = true ->
    separated (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r).
  Proof using fits never.
    intros says. apply lane_is_coarse in says.
    apply (float_instance prec emax least half prec_gt_0_ prec_lt_emax_ fits never fused a b c p r), says.
  Qed.

  (* None of a lane's axes has all comparisons with >=. *)
  Lemma lane_says_contact a b c p r : lane_contact a b c p r = true -> 0 <= B2R r /\
    ~ lane_axis (fun K => weak (reduced (sub (real_vec a) (real_vec p)) (sub (real_vec b) (real_vec p)) (sub (real_vec c) (real_vec p))
      (B2R r * B2R r) K)).
  Proof using fits never.
    unfold lane_contact. rewrite andb_true_iff, negb_true_iff. intros [inside none].
    destruct fits as (p20 & half0 & fit & deep & least_range & constants).
    destruct (range_spec prec emax _ _ fused least half a b c p r p20 half0 deep least_range constants inside)
      as (_ & _ & _ & low & r0).
    destruct (never fused _ _ _ _ _ (in_format_real prec emax a) (in_format_real prec emax b) (in_format_real prec emax c)
      (in_format_real prec emax p) r0 low) as (near & _ & _).
    split; [assumption |]. intros axis. apply not_true_iff_false in none. apply none, lane_axis_b_spec. revert axis.
    apply lane_axis_mono. intros K holds. apply negb_true_iff.
    destruct (step_is_program prec emax _ _ fused least half a b c p r p20 half0 fit deep least_range constants inside K)
      as [(F & value & _) (F' & value' & _)].
    rewrite Bltb_correct, B2R_Bopp, value, value' by (rewrite ?is_finite_Bopp; assumption).
    apply Rlt_bool_false. pose proof (near K) as off. apply Rabs_le_inv in off.
    pose proof (margin_sign (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) K) as [_ weakly].
    assert (0 <= exact_margin (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) K) by (apply weakly; exact holds).
    unfold Run.nearest in *. lra.
  Qed.

  Lemma pair_says_separated a b c p r : pair_separated a b c p r = true ->
    separated (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r).
  Proof using fits never.
    unfold pair_separated. rewrite !orb_true_iff. intros [[says | says] | says]; apply lane_says_separated in says.
    - assumption.
    - apply turned_separated, says.
    - apply turned_separated, turned_separated, says.
  Qed.
  Lemma pair_says_contact a b c p r : pair_contact a b c p r = true ->
    ~ separated_open (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r).
  Proof using fits never.
    unfold pair_contact. rewrite !andb_true_iff. intros [[one two] three] apart.
    apply lane_says_contact in one as [r0 one], two as [_ two], three as [_ three].
    apply (open_exact _ _ _ _ _ r0) in apart.
    assert (some_axis (fun K => weak (reduced (sub (real_vec a) (real_vec p)) (sub (real_vec b) (real_vec p))
      (sub (real_vec c) (real_vec p)) (B2R r * B2R r) K))) as axis
      by (revert apart; apply some_axis_mono; intros K [holds _]; exact holds).
    apply lanes_have_all in axis. tauto.
  Qed.
End Float.

(* The statement for any thirteen numbers, and for both spheres. *)
Definition float_pair_never_lies (prec emax least half : Z) (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax) : Prop :=
  forall fused (a b c p : float_vec prec emax) (r : binary_float prec emax),
  let closed := separated (real_vec prec emax a) (real_vec prec emax b) (real_vec prec emax c) (real_vec prec emax p) (B2R r) in
  let open := separated_open (real_vec prec emax a) (real_vec prec emax b) (real_vec prec emax c) (real_vec prec emax p) (B2R r) in
  (pair_separated prec emax least half _ _ fused a b c p r = true -> closed /\ open) /\
  (pair_contact prec emax least half _ _ fused a b c p r = true -> ~ closed /\ ~ open).

Lemma float_pair_instance prec emax least half prec_gt_0_ prec_lt_emax_ :
  step_fits prec emax least half -> coarse_never_lies prec (3 - emax - prec) least ->
  float_pair_never_lies prec emax least half prec_gt_0_ prec_lt_emax_.
Proof.
  intros fits never fused a b c p r closed open. split; intros says.
  - apply pair_says_separated in says; try assumption. split; [exact says | apply separated_is_open, says].
  - apply pair_says_contact in says; try assumption. split; [| exact says]. intros apart. apply says, separated_is_open, apart.
Qed.
Theorem float_pair_never_lies32 : float_pair_never_lies 24 128 (-21) 19 eq_refl eq_refl.
Proof. apply float_pair_instance; [apply step_fits32 | apply coarse_never_lies32]. Qed.
Theorem float_pair_never_lies64 : float_pair_never_lies 53 1024 (-300) 150 eq_refl eq_refl.
Proof. apply float_pair_instance; [apply step_fits64 | apply coarse_never_lies64]. Qed.
