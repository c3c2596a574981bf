(* The box's steps as recorded from the code that runs, kernel/sphere_triangle/certified/box_step-inl.h, are right whatever the thirteen
   numbers are: a triangle that is passed over, from columns or from vertices as vectors, is separated, for either sphere; and a bit
   of a vertex's outcode is set only where the vertex is beyond that face. *)
From Coq Require Import Reals ZArith Bool List.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Filter OpenSphere Box Machine RecordedCertified.
Import ListNotations.

(* A recorded definition asked about a query. *)
Local Notation of_query f prec emax M a b c p r :=
  (f M (fx prec emax a) (fy prec emax a) (fz prec emax a) (fx prec emax b) (fy prec emax b) (fz prec emax b)
     (fx prec emax c) (fy prec emax c) (fz prec emax c) (fx prec emax p) (fy prec emax p) (fz prec emax p) r).

(* The program, over any numbers. *)
Section Program.
  Variable m : machine.
  Notation number := (m_number m).
  Variables (ax ay az bx by_ bz cx cy cz px py pz r : number).
  Let gone x := m_subtract m x x.
  Definition code_valid : bool :=
    m_at_most m (m_zero m) r && m_equal m (m_add m (m_add m (gone px) (gone py)) (m_add m (gone pz) (gone r))) (m_zero m).
  Definition code_low (p : number) : number := if code_valid then m_subtract m p r else m_negate m (m_infinity m).
  Definition code_high (p : number) : number := if code_valid then m_add m p r else m_infinity m.
  (* Three coordinates. *)
  Definition all_beyond (p x y z : number) : bool :=
    m_less m (m_greatest m (m_greatest m x y) z) (code_low p) || m_less m (code_high p) (m_least m (m_least m x y) z).
  Definition sum_of_three (x y z : number) : number := m_add m (m_add m x y) z.
  Definition is_whole (x : number) : bool := m_equal m (gone x) (m_zero m).
  Definition some_face : bool := all_beyond px ax bx cx || all_beyond py ay by_ cy || all_beyond pz az bz cz.
  Definition column_answer : bool :=
    some_face && is_whole (m_add m (m_add m (sum_of_three ax ay az) (sum_of_three bx by_ bz)) (sum_of_three cx cy cz)).
  Definition vertex_answer : bool :=
    is_whole (sum_of_three ax bx cx) && is_whole (sum_of_three ay by_ cy) && is_whole (sum_of_three az bz cz) && some_face.
  (* The bit of vertex A's outcode. *)
  Definition outcode_bit (f : face) : bool := is_whole (sum_of_three ax ay az) &&
    match f with
    | low_x => m_less m ax (code_low px) | high_x => m_less m (code_high px) ax
    | low_y => m_less m ay (code_low py) | high_y => m_less m (code_high py) ay
    | low_z => m_less m az (code_low pz) | high_z => m_less m (code_high pz) az
    end.
  Definition box_answers : list bool :=
    column_answer :: vertex_answer :: map outcode_bit [low_x; high_x; low_y; high_y; low_z; high_z].
End Program.

Definition recorded_box_is_program (recorded : forall m : machine, m_number m -> m_number m -> m_number m -> m_number m -> m_number m ->
    m_number m -> m_number m -> m_number m -> m_number m -> m_number m -> m_number m -> m_number m -> m_number m -> list bool) : Prop :=
  forall m ax ay az bx by_ bz cx cy cz px py pz r,
  recorded m ax ay az bx by_ bz cx cy cz px py pz r = box_answers m ax ay az bx by_ bz cx cy cz px py pz r.
Theorem recorded_box32 : recorded_box_is_program box_plain_binary32_answers.
Proof. intros m ax ay az bx by_ bz cx cy cz px py pz r. reflexivity. Qed.
Theorem recorded_box64 : recorded_box_is_program box_plain_binary64_answers.
Proof. intros m ax ay az bx by_ bz cx cy cz px py pz r. reflexivity. Qed.

Section Float.
  Variables prec emax : Z.
  Context (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax).
  Notation float := (binary_float prec emax).
  Notation float_vec := (float_vec prec emax).
  Notation real_vec := (real_vec prec emax).
  Notation finite x := (is_finite x = true).
  Variables low high : float -> float -> float.
  Variable other : float -> float.
  Notation M := (float_machine prec emax _ _ low high other).
  Hypothesis low_is : is_least prec emax low.
  Hypothesis high_is : is_greatest prec emax high.

  Lemma finite_terms (x y : float) : finite (Bplus mode_NE x y) -> finite x /\ finite y.
  Proof using Type. destruct x as [| [] | |], y as [| [] | |]; cbn; auto; discriminate. Qed.
  Lemma finite_gone (x : float) : finite (Bminus mode_NE x x) -> finite x.
  Proof using Type. destruct x as [| [] | |]; cbn; auto; discriminate. Qed.
  Lemma finite_zero (x : float) : Beqb x (B754_zero false) = true -> finite x.
  Proof using Type. destruct x as [| [] | |]; cbn; auto; discriminate. Qed.
  Lemma whole_is_finite (x : float) : is_whole M x = true -> finite x.
  Proof using Type. intros whole. apply finite_gone, finite_zero, whole. Qed.
  Lemma sum_is_finite (x y z : float) : finite (sum_of_three M x y z) -> finite x /\ finite y /\ finite z.
  Proof using Type. intros F. apply finite_terms in F as [F Fz]. apply finite_terms in F. tauto. Qed.

  Section Query.
    Variables (a b c p : float_vec) (r : float).
    Notation valid := (code_valid M (fx _ _ p) (fy _ _ p) (fz _ _ p) r).
    Lemma valid_is_sphere : valid = true -> is_sphere prec emax p r = true.
    Proof using Type.
      unfold code_valid. rewrite andb_true_iff. intros [nonneg zero]. apply finite_zero, finite_terms in zero as [one two].
      apply finite_terms in one as [Fx Fy]. apply finite_terms in two as [Fz Fr].
      apply finite_gone in Fx, Fy, Fz, Fr. unfold is_sphere, is_finite_vec. rewrite Fx, Fy, Fz, Fr. exact nonneg.
    Qed.
    Notation end_low q := (code_low M (fx _ _ p) (fy _ _ p) (fz _ _ p) r q).
    Notation end_high q := (code_high M (fx _ _ p) (fy _ _ p) (fz _ _ p) r q).
    Lemma low_tells (x q : float) : Bltb x (end_low q) = true -> Bltb x (box_low prec emax _ _ (is_sphere prec emax p r) q r) = true.
    Proof using Type.
      unfold code_low. destruct valid eqn:is_valid; [rewrite (valid_is_sphere is_valid); exact (fun H => H) |].
      intros less. pose proof (not_below_minus_infinity prec emax x) as none. cbn in less, none. congruence.
    Qed.
    Lemma high_tells (x q : float) : Bltb (end_high q) x = true -> Bltb (box_high prec emax _ _ (is_sphere prec emax p r) q r) x = true.
    Proof using Type.
      unfold code_high. destruct valid eqn:is_valid; [rewrite (valid_is_sphere is_valid); exact (fun H => H) |].
      intros less. pose proof (not_above_infinity prec emax x) as none. cbn in less, none. congruence.
    Qed.

    (* The greatest of finite numbers is below a number, an infinity or a NaN where each of them is. *)
    Lemma below_more (t x y : float) : finite x -> finite y -> Bleb x y = true -> Bltb y t = true -> Bltb x t = true.
    Proof using Type.
      intros Fx Fy order less. destruct (is_finite t) eqn:Ft.
      - rewrite Bleb_correct in order by assumption. rewrite Bltb_correct in less |- * by assumption.
        revert order less. case Rle_bool_spec; [intros order _ | discriminate]. case Rlt_bool_spec; [intros less _ | discriminate].
        apply Rlt_bool_true. eapply Rle_lt_trans; eassumption.
      - destruct x as [| | | []], y as [| | | []], t as [| [] | |]; cbn in *; congruence.
    Qed.
    Lemma above_more (t x y : float) : finite x -> finite y -> Bleb x y = true -> Bltb t x = true -> Bltb t y = true.
    Proof using Type.
      intros Fx Fy order less. destruct (is_finite t) eqn:Ft.
      - rewrite Bleb_correct in order by assumption. rewrite Bltb_correct in less |- * by assumption.
        revert order less. case Rle_bool_spec; [intros order _ | discriminate]. case Rlt_bool_spec; [intros less _ | discriminate].
        apply Rlt_bool_true. eapply Rlt_le_trans; eassumption.
      - destruct x as [| | | []], y as [| | | []], t as [| [] | |]; cbn in *; congruence.
    Qed.
    Lemma high_below (t x y : float) : finite x -> finite y -> finite (high x y) /\ (Bltb (high x y) t = true -> Bltb x t = true /\ Bltb y t = true).
    Proof using high_is.
      intros Fx Fy. destruct (high_is x y (finite_not_nan _ _ x Fx) (finite_not_nan _ _ y Fy)) as [[-> order] | [-> order]];
        (split; [assumption |]); intros less; (split; [| try exact less]); try exact less;
        [exact (below_more t y x Fy Fx order less) | exact (below_more t x y Fx Fy order less)].
    Qed.
    Lemma low_above (t x y : float) : finite x -> finite y -> finite (low x y) /\ (Bltb t (low x y) = true -> Bltb t x = true /\ Bltb t y = true).
    Proof using low_is.
      intros Fx Fy. destruct (low_is x y (finite_not_nan _ _ x Fx) (finite_not_nan _ _ y Fy)) as [[-> order] | [-> order]];
        (split; [assumption |]); intros less; (split; [| try exact less]); try exact less;
        [exact (above_more t x y Fx Fy order less) | exact (above_more t y x Fy Fx order less)].
    Qed.
    Lemma all_beyond_tells (q x y z : float) : finite x -> finite y -> finite z ->
      all_beyond M (fx _ _ p) (fy _ _ p) (fz _ _ p) r q x y z = true ->
      let l := box_low prec emax _ _ (is_sphere prec emax p r) q r in let h := box_high prec emax _ _ (is_sphere prec emax p r) q r in
      (Bltb x l = true /\ Bltb y l = true /\ Bltb z l = true) \/ (Bltb h x = true /\ Bltb h y = true /\ Bltb h z = true).
    Proof using high_is low_is.
      intros Fx Fy Fz. unfold all_beyond. rewrite orb_true_iff. cbn [m_less m_greatest m_least float_machine]. intros [less | less]; [left | right].
      - destruct (high_below (end_low q) x y Fx Fy) as [F tells]. apply (high_below _ _ z F Fz) in less as [less lz].
        apply tells in less as [lx ly]. auto using low_tells.
      - destruct (low_above (end_high q) x y Fx Fy) as [F tells]. apply (low_above _ _ z F Fz) in less as [less lz].
        apply tells in less as [lx ly]. auto using high_tells.
    Qed.

    Notation finite_vec v := (is_finite_vec prec emax v = true).
    Lemma finite_parts v : finite (fx _ _ v) -> finite (fy _ _ v) -> finite (fz _ _ v) -> finite_vec v.
    Proof using Type. unfold is_finite_vec. intros -> -> ->. reflexivity. Qed.
    Definition box_is_right_of : Prop := is_sphere prec emax p r = true /\ finite_vec a /\ finite_vec b /\ finite_vec c /\
      separated (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r) /\
      separated_open (real_vec a) (real_vec b) (real_vec c) (real_vec p) (B2R r).
    Lemma some_face_is_right : finite_vec a -> finite_vec b -> finite_vec c ->
      of_query some_face prec emax M a b c p r = true -> box_is_right_of.
    Proof using high_is low_is.
      intros Fa Fb Fc. unfold some_face.
      assert (forall f, beyond prec emax _ _ p r f a = true -> beyond prec emax _ _ p r f b = true -> beyond prec emax _ _ p r f c = true ->
        box_is_right_of) as by_face.
      { intros f one two three. apply (passed_over_is_separated prec emax _ _ p r f [a; b; c] a b c); cbn [forallb In]; auto.
        rewrite one, two, three. reflexivity. }
      unfold beyond in by_face. rewrite Fa, Fb, Fc in by_face. unfold is_finite_vec in Fa, Fb, Fc.
      apply andb_true_iff in Fa as [[Fax Fay]%andb_true_iff Faz]. apply andb_true_iff in Fb as [[Fbx Fby]%andb_true_iff Fbz].
      apply andb_true_iff in Fc as [[Fcx Fcy]%andb_true_iff Fcz].
      rewrite !orb_true_iff. intros [[H | H] | H]; apply all_beyond_tells in H; try assumption; destruct H as [(one & two & three) | (one & two & three)].
      - exact (by_face low_x one two three).
      - exact (by_face high_x one two three).
      - exact (by_face low_y one two three).
      - exact (by_face high_y one two three).
      - exact (by_face low_z one two three).
      - exact (by_face high_z one two three).
    Qed.
    Lemma column_is_right : of_query column_answer prec emax M a b c p r = true -> box_is_right_of.
    Proof using high_is low_is.
      unfold column_answer. rewrite andb_true_iff. intros [face whole]. apply whole_is_finite, finite_terms in whole as [F Fc].
      apply finite_terms in F as [Fa Fb]. apply sum_is_finite in Fa as (? & ? & ?), Fb as (? & ? & ?), Fc as (? & ? & ?).
      apply some_face_is_right; auto using finite_parts.
    Qed.
    Lemma vertex_is_right : of_query vertex_answer prec emax M a b c p r = true -> box_is_right_of.
    Proof using high_is low_is.
      unfold vertex_answer. rewrite !andb_true_iff. intros [[[x y] z] face]. apply whole_is_finite, sum_is_finite in x as (? & ? & ?).
      apply whole_is_finite, sum_is_finite in y as (? & ? & ?). apply whole_is_finite, sum_is_finite in z as (? & ? & ?).
      apply some_face_is_right; auto using finite_parts.
    Qed.
    Lemma outcode_is_right f : outcode_bit M (fx _ _ a) (fy _ _ a) (fz _ _ a) (fx _ _ p) (fy _ _ p) (fz _ _ p) r f = true ->
      beyond prec emax _ _ p r f a = true.
    Proof using Type.
      unfold outcode_bit, beyond. rewrite andb_true_iff. intros [whole bit]. apply whole_is_finite, sum_is_finite in whole as (? & ? & ?).
      rewrite finite_parts by assumption. destruct f; first [apply low_tells, bit | apply high_tells, bit].
    Qed.
  End Query.
End Float.

(* What the recorded answers are worth: passed over from columns, from vertices as vectors; the bits of vertex A's outcode. *)
Definition box_is_right prec emax (prec_gt_0_ : Prec_gt_0 prec) (prec_lt_emax_ : Prec_lt_emax prec emax)
    (answers : float_vec prec emax -> float_vec prec emax -> float_vec prec emax -> float_vec prec emax -> binary_float prec emax -> list bool) : Prop :=
  forall a b c p r, let says n := nth n (answers a b c p r) false in
  (says 0%nat = true -> box_is_right_of prec emax a b c p r) /\ (says 1%nat = true -> box_is_right_of prec emax a b c p r) /\
  Forall2 (fun f bit => bit = true -> beyond prec emax _ _ p r f a = true) [low_x; high_x; low_y; high_y; low_z; high_z]
    (skipn 2 (answers a b c p r)).
Lemma program_is_right prec emax prec_gt_0_ prec_lt_emax_ low high other : is_least prec emax low -> is_greatest prec emax high ->
  box_is_right prec emax prec_gt_0_ prec_lt_emax_
    (fun a b c p r => of_query box_answers prec emax (float_machine prec emax _ _ low high other) a b c p r).
Proof.
  intros low_is high_is a b c p r. cbv zeta. unfold box_answers. cbn [nth map skipn].
  split; [apply column_is_right; assumption |]. split; [apply vertex_is_right; assumption |].
  repeat constructor; apply outcode_is_right.
Qed.
Theorem recorded_box_is_right32 low high other : is_least 24 128 low -> is_greatest 24 128 high ->
  box_is_right 24 128 eq_refl eq_refl (fun a b c p r => of_query box_plain_binary32_answers 24 128 (float_machine 24 128 eq_refl eq_refl low high other) a b c p r).
Proof.
  intros low_is high_is a b c p r. cbv zeta. rewrite recorded_box32. apply program_is_right; assumption.
Qed.
Theorem recorded_box_is_right64 low high other : is_least 53 1024 low -> is_greatest 53 1024 high ->
  box_is_right 53 1024 eq_refl eq_refl (fun a b c p r => of_query box_plain_binary64_answers 53 1024 (float_machine 53 1024 eq_refl eq_refl low high other) a b c p r).
Proof.
  intros low_is high_is a b c p r. cbv zeta. rewrite recorded_box64. apply program_is_right; assumption.
Qed.
