(* The coarse step, taken in doubles for the queries that it leaves open, tells the next steps bits of each axis: every bit is
   right, for either sphere, and the bits are those recorded from the code that runs. *)
From Coq Require Import Reals ZArith Bool List Lra.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Exact Reduced Expression Format Run Filter Certified CertifiedStep Sizes CoarseFloat OpenSphere
  Known Machine RecordedCertified RecordedIsCertified.
Import ListNotations.
Open Scope R_scope.

Lemma sign_of_exact_margin a b c p r K : let s := reduced (sub a p) (sub b p) (sub c p) (r * r) K in
  (0 < exact_margin a b c p r K -> fst s > snd s) /\ (exact_margin a b c p r K < 0 -> fst s < snd s).
Proof. cbv zeta. unfold exact_margin. destruct K; split; intros; lra. Qed.

Section Float.
  Variables prec emax least half : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Notation real_vec := (real_vec prec emax).
  Notation emin := (3 - emax - prec)%Z.
  Variable fused : bool.
  Variable low : float -> float -> float.
  Notation margin := (float_margin prec emax _ _ fused).
  Notation threshold := (float_threshold prec emax _ _ fused).
  Notation in_range := (float_in_range prec emax _ _ fused least half).

  Section Query.
    Variables (a b c p : float_vec) (r : float).
    Let m := margin a b c p r.
    Let t := threshold a b c p r.
    (* The least of an axis's side margins; the plane has none. *)
    Definition side_of (i : axis) : option float :=
      match i with
      | axis_a => Some (low (m vertex_a_side_b) (m vertex_a_side_c))
      | axis_b => Some (low (m vertex_b_side_c) (m vertex_b_side_a))
      | axis_c => Some (low (m vertex_c_side_a) (m vertex_c_side_b))
      | axis_plane => None
      | axis_ab => Some (m edge_ab_side_c)
      | axis_bc => Some (m edge_bc_side_a)
      | axis_ca => Some (m edge_ca_side_b)
      end.
    Definition coarse_known : known := Known
      (fun i => let below x := Bltb x (Bopp (t (radius_of i))) in
         match side_of i with Some side => below (m (radius_of i)) || below side | None => below (m (radius_of i)) end)
      (fun i => Bltb (t (radius_of i)) (m (radius_of i)))
      (fun i => match side_of i with Some side => Bltb (t (radius_of i)) side | None => true end).
    Definition known_list (k : known) : list bool :=
      map (known_fails k) all_axes ++ map (known_radius k) all_axes ++ map (known_sides k) all_axes.

    Hypothesis low_is : is_least prec emax low.
    Hypothesis fits : step_fits prec emax least half.
    Hypothesis never : coarse_never_lies prec emin least.
    Hypothesis inside : in_range a b c p r = true.
    Let A := sub (real_vec a) (real_vec p). Let B := sub (real_vec b) (real_vec p). Let C := sub (real_vec c) (real_vec p).
    Notation holds q := (holds_for q A B C (B2R r * B2R r)).

    Lemma margin_tells q K : is_finite (m K) = true /\ is_finite (t K) = true /\
      (Bltb (t K) (m K) = true -> holds q K) /\ (Bltb (m K) (Bopp (t K)) = true -> ~ holds q K).
    Proof using fits inside never.
      destruct fits as (p20 & half0 & fit & deep & least_range & constants).
      destruct (range_spec prec emax _ _ fused least half a b c p r p20 half0 deep least_range constants inside)
        as (_ & _ & _ & enough & r0).
      destruct (never fused _ _ _ _ _ (in_format_real prec emax a) (in_format_real prec emax b) (in_format_real prec emax c)
        (in_format_real prec emax p) r0 enough) as (near & _ & _).
      destruct (step_is_program prec emax _ _ fused least half a b c p r p20 half0 fit deep least_range constants inside K)
        as [(F & value & _) (F' & value' & _)].
      split; [exact F |]. split; [exact F' |]. unfold m, t.
      rewrite !Bltb_correct, B2R_Bopp, value, value' by (rewrite ?is_finite_Bopp; assumption).
      pose proof (near K) as off. apply Rabs_le_inv in off. unfold Run.nearest in *.
      destruct (sign_of_exact_margin (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) K) as [positive negative].
      destruct (sign_decides q A B C (B2R r * B2R r) K (Rle_0_sqr _)) as (above & below & _).
      split; case Rlt_bool_spec; intros compared; try discriminate; intros _.
      - apply above, positive. lra.
      - apply below, negative. lra.
    Qed.
    Lemma low_tells q K K' : Bltb (t K) (low (m K) (m K')) = true -> t K = t K' -> holds q K /\ holds q K'.
    Proof using fits inside low_is never.
      intros less same. destruct (margin_tells q K) as (F & Ft & one & _), (margin_tells q K') as (F' & _ & two & _).
      destruct (less_low prec emax low low_is (t K) _ _ Ft F F') as (_ & split_ & _).
      rewrite split_, andb_true_iff in less. destruct less as [less less']. rewrite same in less'. auto.
    Qed.
    Lemma low_refutes q K K' : Bltb (low (m K) (m K')) (Bopp (t K)) = true -> t K = t K' -> ~ (holds q K /\ holds q K').
    Proof using fits inside low_is never.
      intros less same. destruct (margin_tells q K) as (F & Ft & _ & one), (margin_tells q K') as (F' & _ & _ & two).
      assert (is_finite (Bopp (t K)) = true) as Fo by (rewrite is_finite_Bopp; exact Ft).
      destruct (less_low prec emax low low_is (Bopp (t K)) _ _ Fo F F') as (_ & _ & split_).
      rewrite split_, orb_true_iff in less. rewrite same in *. tauto.
    Qed.

    Theorem coarse_known_is_sound q : sound_known (holds q) coarse_known.
    Proof using fits inside low_is never.
      intros i. cbn [coarse_known known_fails known_radius known_sides]. unfold axis_holds.
      pose proof (margin_tells q (radius_of i)) as (_ & _ & radius & radius_fails).
      split; [| split; [exact radius |]].
      - destruct i; cbn [side_of radius_of sides_hold] in *; rewrite ?orb_true_iff; intros less.
        + destruct less as [less | less]; [intros [H _]; apply (radius_fails less H) |]. intros [_ H].
          apply (low_refutes q vertex_a_side_b vertex_a_side_c less eq_refl), H.
        + destruct less as [less | less]; [intros [H _]; apply (radius_fails less H) |]. intros [_ [H H']].
          apply (low_refutes q vertex_b_side_c vertex_b_side_a less eq_refl). auto.
        + destruct less as [less | less]; [intros [H _]; apply (radius_fails less H) |]. intros [_ H].
          apply (low_refutes q vertex_c_side_a vertex_c_side_b less eq_refl), H.
        + intros [H _]. apply (radius_fails less H).
        + destruct less as [less | less]; intros [H H']; [apply (radius_fails less H) |].
          apply (proj2 (proj2 (proj2 (margin_tells q edge_ab_side_c))) less H').
        + destruct less as [less | less]; intros [H H']; [apply (radius_fails less H) |].
          apply (proj2 (proj2 (proj2 (margin_tells q edge_bc_side_a))) less H').
        + destruct less as [less | less]; intros [H H']; [apply (radius_fails less H) |].
          apply (proj2 (proj2 (proj2 (margin_tells q edge_ca_side_b))) less H').
      - destruct i; cbn [side_of radius_of sides_hold] in *; intros less.
        + apply (low_tells q vertex_a_side_b vertex_a_side_c less eq_refl).
        + apply and_comm, (low_tells q vertex_b_side_c vertex_b_side_a less eq_refl).
        + apply (low_tells q vertex_c_side_a vertex_c_side_b less eq_refl).
        + exact I.
        + apply (proj1 (proj2 (proj2 (margin_tells q edge_ab_side_c))) less).
        + apply (proj1 (proj2 (proj2 (margin_tells q edge_bc_side_a))) less).
        + apply (proj1 (proj2 (proj2 (margin_tells q edge_ca_side_b))) less).
    Qed.
  End Query.
End Float.

Definition recorded_coarse_known (fused : bool) := if fused then coarse_fma_binary64_known else coarse_plain_binary64_known.
(* Conversion leaves the operations alone. *)
Local Strategy 1000 [Bplus Bminus Bmult Bfma Bopp binary_normalize Bltb Bleb].
Theorem recorded_coarse_known_is_proved low high other fused a b c p r :
  of_query (recorded_coarse_known fused) 53 1024 (machine64 low high other) a b c p r =
  known_list (coarse_known 53 1024 eq_refl eq_refl fused low a b c p r).
Proof. destruct fused, a, b, c, p; reflexivity. Qed.
Theorem coarse_known_is_sound64 low fused a b c p r : is_least 53 1024 low ->
  float_in_range 53 1024 eq_refl eq_refl fused (-300) 150 a b c p r = true -> forall q,
  let at_ := real_vec 53 1024 in
  sound_known (holds_for q (sub (at_ a) (at_ p)) (sub (at_ b) (at_ p)) (sub (at_ c) (at_ p)) (B2R r * B2R r))
    (coarse_known 53 1024 eq_refl eq_refl fused low a b c p r).
Proof.
  intros low_is inside q. cbv zeta.
  eapply (coarse_known_is_sound 53 1024 (-300) 150);
    first [exact low_is | exact step_fits64 | exact coarse_never_lies64 | exact inside].
Qed.
