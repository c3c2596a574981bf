(* The conservative test as a program over the operations of a machine, in the order of
   kernel/sphere_triangle/certified/conservative_step-inl.h, with the constants as they are in the code: over rounded reals
   it is the program of ConservativeStep.v, over IEEE-754 numbers the one that runs. *)
From Coq Require Import Reals ZArith Bool List Lra.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Expression Certified CertifiedStep Conservative ConservativeStep Machine.
Import ListNotations.

Section Program.
  Variable m : machine.
  Local Notation number := (m_number m).
  Local Notation "x + y" := (m_add m x y).
  Local Notation "x - y" := (m_subtract m x y).
  Local Notation "x * y" := (m_multiply m x y).

  Record machine_vec := MachineVec { mx : number; my : number; mz : number }.
  Definition program_sub (v w : machine_vec) := MachineVec (mx v - mx w) (my v - my w) (mz v - mz w).
  Definition program_product (v w : machine_vec) : number := mx v * mx w + my v * my w + mz v * mz w.
  Definition program_cross (v w : machine_vec) := MachineVec
    (my v * mz w - mz v * my w) (mz v * mx w - mx v * mz w) (mx v * my w - my v * mx w).
  Definition program_least (x y z : number) : number := m_least m (m_least m x y) z.

  (* W from 2^least, the sum of the squares to 2^greatest; the square of the scaled normal from 2^least_normal. *)
  Variables prec least least_normal greatest : Z.
  Variables (a b c p : machine_vec) (r : number).
  Let A := program_sub a p.
  Let B := program_sub b p.
  Let C := program_sub c p.
  Let product := program_product.
  Let aa := product A A.
  Let bb := product B B.
  Let cc := product C C.
  Let ab := product A B.
  Let bc := product B C.
  Let ca := product C A.
  Let rr := r * r.
  Definition program_W : number := m_greatest m (m_greatest m aa bb) (m_greatest m cc rr).
  Let zero := m_zero m.
  Let one := m_constant m 1 0.
  Definition program_error : number := m_constant m 5 (1 - prec) * program_W.
  Definition program_square_error : number := m_constant m 153 (-3 - prec) * program_W.
  Definition program_passes (x square : number) : bool :=
    m_less m zero x && m_less m ((rr + program_square_error) * square) (x * x).
  (* The position, from X to Y along an edge as computed, of the point nearest to the centre. *)
  Definition program_share (X along : machine_vec) : number :=
    let e := product along along in
    m_least m (m_greatest m (if m_less m zero e then m_divide m (m_negate m (product X along)) e else zero) zero) one.
  Definition program_mix (s x y : number) : number := x + s * (y - x).
  Definition program_edge (X along : machine_vec) (xx xy yy xz yz : number) : bool :=
    let s := program_share X along in
    let at_x := program_mix s xx xy in
    let at_y := program_mix s xy yy in
    program_passes (program_least at_x at_y (program_mix s xz yz) - program_error) (program_mix s at_x at_y + program_square_error).
  (* V scaled by the power of two below 1 / W. *)
  Definition program_normal : machine_vec :=
    let V := program_cross (program_sub A C) (program_sub B A) in
    let k := m_inverse_power m program_W in
    MachineVec (mx V * k) (my V * k) (mz V * k).
  Definition program_plane : bool :=
    let n := program_normal in
    let side := m_with_sign m one (product A n) in
    m_at_most m (m_constant m 1 least_normal) (product n n) &&
    program_passes (program_least (side * product A n) (side * product B n) (side * product C n)) (product n n).
  Definition program_squares : number := aa + bb + cc + rr.
  Definition program_known : bool :=
    m_at_most m zero r && (m_at_most m (m_constant m 1 least) program_W && m_at_most m program_squares (m_constant m 1 greatest)).
  Definition program_separated : bool :=
    program_edge A (program_sub B A) aa ab bb ca bc || program_edge B (program_sub C B) bb bc cc ab ca ||
    program_edge C (program_sub A C) cc ca aa bc ab || program_plane.
  (* Separated; unknown. *)
  Definition conservative_answers : list bool := [program_separated && program_known; negb program_known].
End Program.
Arguments MachineVec {m}.
Arguments mx {m}.
Arguments my {m}.
Arguments mz {m}.

Lemma less_real_is x y : less_real x y = true <-> (x < y)%R.
Proof. unfold less_real. destruct Rlt_dec; split; intros; try reflexivity; try discriminate; assumption || contradiction. Qed.
Lemma at_most_real_is x y : at_most_real x y = true <-> (x <= y)%R.
Proof. unfold at_most_real. destruct Rle_dec; split; intros; try reflexivity; try discriminate; assumption || contradiction. Qed.

(* Over rounded reals. *)
Section Reals.
  Open Scope R_scope.
  Variable rnd : R -> R.
  Variables prec least least_normal greatest : Z.
  Variables (a b c p : vec) (r : R).
  Let M := real_machine rnd.
  Definition on_reals (v : vec) : machine_vec M := @MachineVec M (cx v) (cy v) (cz v).
  Hypothesis rounded_is_itself : forall x, rnd (rnd x) = rnd x.
  Hypothesis rounded_opposite : forall x, rnd (- x) = - rnd x.

  Lemma number_power e : IZR 1 * bpow radix2 e = bpow radix2 e. Proof using Type. ring. Qed.
  Lemma error_is : IZR 5 * bpow radix2 (1 - prec) = conservative_error * u prec.
  Proof using Type. unfold conservative_error, u, Zminus. rewrite bpow_plus. change (bpow radix2 1) with 2. lra. Qed.
  Lemma square_error_is : IZR 153 * bpow radix2 (-3 - prec) = conservative_square_error * u prec.
  Proof using Type. unfold conservative_square_error, u, Zminus. rewrite bpow_plus. change (bpow radix2 (-3)) with (/ 8). lra. Qed.

  Lemma sub_on_reals v w : program_sub M (on_reals v) (on_reals w) = on_reals (rounded_sub rnd v w).
  Proof using Type. reflexivity. Qed.
  Lemma product_on_reals v w : program_product M (on_reals v) (on_reals w) = rounded_dot rnd false v w.
  Proof using Type. reflexivity. Qed.
  Lemma signed_product t v w : let side := if Rlt_dec t 0 then - Rabs (IZR 1 * bpow radix2 0) else Rabs (IZR 1 * bpow radix2 0) in
    rnd (side * rounded_dot rnd false v w) = (if Rlt_dec t 0 then - rounded_dot rnd false v w else rounded_dot rnd false v w).
  Proof using rounded_is_itself rounded_opposite.
    cbv zeta. assert (exists x, rounded_dot rnd false v w = rnd x) as [x ->] by (eexists; reflexivity).
    rewrite number_power. change (bpow radix2 0) with 1. rewrite Rabs_R1. destruct Rlt_dec.
    - replace (- (1) * rnd x) with (- rnd x) by ring. rewrite rounded_opposite, rounded_is_itself. reflexivity.
    - rewrite Rmult_1_l. apply rounded_is_itself.
  Qed.
  Lemma passes_on_reals (x square : R) : program_passes M prec (on_reals a) (on_reals b) (on_reals c) (on_reals p) r x square = true <->
    0 < x /\ rnd (rnd (rnd (r * r) + rnd (conservative_square_error * u prec * conservative_W rnd a b c p r)) * square) < rnd (x * x).
  Proof using Type. rewrite <- square_error_is. unfold program_passes. rewrite andb_true_iff. cbn. rewrite !less_real_is. reflexivity. Qed.
  Lemma share_on_reals X along : program_share M (on_reals X) (on_reals along) = conservative_share rnd X along.
  Proof using Type. unfold program_share, conservative_share. cbn. rewrite Rmult_1_l. unfold less_real. destruct Rlt_dec; reflexivity. Qed.
  Lemma edge_on_reals X along xx xy yy xz yz :
    program_edge M prec (on_reals a) (on_reals b) (on_reals c) (on_reals p) r (on_reals X) (on_reals along) xx xy yy xz yz = true <->
    conservative_edge rnd (u prec) a b c p r X along xx xy yy xz yz.
  Proof using Type.
    unfold program_edge. cbv zeta. rewrite passes_on_reals, share_on_reals. unfold program_error, program_square_error.
    cbn [M m_multiply real_machine m_constant].
    rewrite error_is, square_error_is. reflexivity.
  Qed.
  Lemma plane_on_reals : program_plane M prec least_normal (on_reals a) (on_reals b) (on_reals c) (on_reals p) r = true <->
    conservative_plane rnd (u prec) (bpow radix2 least_normal) a b c p r.
  Proof using rounded_is_itself rounded_opposite.
    unfold program_plane. cbv zeta. rewrite andb_true_iff, passes_on_reals. cbn [M real_machine m_at_most m_constant].
    rewrite at_most_real_is, number_power.
    unfold conservative_plane. cbv zeta.
    rewrite <- !(signed_product (rounded_dot rnd false (rounded_sub rnd a p) (conservative_normal rnd a b c p r))).
    reflexivity.
  Qed.
  Theorem separated_on_reals : program_separated M prec least_normal (on_reals a) (on_reals b) (on_reals c) (on_reals p) r = true <->
    conservative_separated rnd (u prec) (bpow radix2 least_normal) a b c p r.
  Proof using rounded_is_itself rounded_opposite.
    unfold program_separated, conservative_separated. rewrite !orb_true_iff, plane_on_reals, <- !edge_on_reals, !or_assoc. reflexivity.
  Qed.
End Reals.
