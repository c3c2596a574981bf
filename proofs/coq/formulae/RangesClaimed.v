From Coq Require Import Reals Lra.
From Axiscert Require Import Ranges.
Open Scope R_scope.

(* Written by write_proofs from the formulae and proofs/ranges.cpp: do not edit.

   Each quantity of the recorded program that a Gappa script of the scaled domain has a range for, and the range. *)

Definition exact_V_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  AB_y * AC_z - AB_z * AC_y.

Theorem range_V_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -4 <= exact_V_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 4.
Proof.
  intros. assert (L := V_range a_y a_z b_y b_z c_y c_z). unfold exact_V_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_V_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (12 * h) (exact_V_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_V_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := V_change h a_y a_z b_y b_z c_y c_z a_y' a_z' b_y' b_z' c_y' c_z'). unfold exact_V_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_V_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_z := b_z - a_z in
  let AC_x := c_x - a_x in
  let AC_z := c_z - a_z in
  AB_z * AC_x - AB_x * AC_z.

Theorem range_V_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -4 <= exact_V_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 4.
Proof.
  intros. assert (L := V_range a_z a_x b_z b_x c_z c_x). unfold exact_V_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_V_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (12 * h) (exact_V_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_V_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := V_change h a_z a_x b_z b_x c_z c_x a_z' a_x' b_z' b_x' c_z' c_x'). unfold exact_V_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_V_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  AB_x * AC_y - AB_y * AC_x.

Theorem range_V_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -4 <= exact_V_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 4.
Proof.
  intros. assert (L := V_range a_x a_y b_x b_y c_x c_y). unfold exact_V_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_V_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (12 * h) (exact_V_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_V_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := V_change h a_x a_y b_x b_y c_x c_y a_x' a_y' b_x' b_y' c_x' c_y'). unfold exact_V_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_d (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let AC_x := c_x - a_x in
  let AC_y := c_y - a_y in
  let AC_z := c_z - a_z in
  let V_x := AB_y * AC_z - AB_z * AC_y in
  let V_y := AB_z * AC_x - AB_x * AC_z in
  let V_z := AB_x * AC_y - AB_y * AC_x in
  a_x * V_x + a_y * V_y + a_z * V_z.

Theorem range_d : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -4 <= exact_d a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 4.
Proof.
  intros. assert (L := d_range a_x a_y a_z b_x b_y b_z c_x c_y c_z). unfold exact_d; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_d : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (18 * h) (exact_d a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_d a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := d_change h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z'). unfold exact_d; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_N1_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  a_y * b_z - a_z * b_y.

Theorem range_N1_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N1_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range a_y a_z b_y b_z). unfold exact_N1_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N1_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N1_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N1_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h a_y a_z b_y b_z a_y' a_z' b_y' b_z'). unfold exact_N1_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_N1_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  a_z * b_x - a_x * b_z.

Theorem range_N1_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N1_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range a_z a_x b_z b_x). unfold exact_N1_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N1_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N1_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N1_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h a_z a_x b_z b_x a_z' a_x' b_z' b_x'). unfold exact_N1_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_N1_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  a_x * b_y - a_y * b_x.

Theorem range_N1_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N1_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range a_x a_y b_x b_y). unfold exact_N1_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N1_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N1_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N1_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h a_x a_y b_x b_y a_x' a_y' b_x' b_y'). unfold exact_N1_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem sum_N1 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  Rabs (exact_N1_x a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_N1_y a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_N1_z a_x a_y a_z b_x b_y b_z c_x c_y c_z) <= 400 / 100.
Proof.
  intros.
  refine (Rle_trans _ _ _ (Req_le _ _ _) (N_sum a_x a_y a_z b_x b_y b_z _ _ _ _ _ _)); try assumption.
  unfold exact_N1_x; cbv zeta.
  unfold exact_N1_y; cbv zeta.
  unfold exact_N1_z; cbv zeta.
  unfold Q. repeat apply f_equal2; apply f_equal; ring.
Qed.

Definition exact_N2_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  b_y * c_z - b_z * c_y.

Theorem range_N2_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N2_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range b_y b_z c_y c_z). unfold exact_N2_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N2_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N2_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N2_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h b_y b_z c_y c_z b_y' b_z' c_y' c_z'). unfold exact_N2_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_N2_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  b_z * c_x - b_x * c_z.

Theorem range_N2_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N2_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range b_z b_x c_z c_x). unfold exact_N2_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N2_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N2_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N2_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h b_z b_x c_z c_x b_z' b_x' c_z' c_x'). unfold exact_N2_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_N2_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  b_x * c_y - b_y * c_x.

Theorem range_N2_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N2_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range b_x b_y c_x c_y). unfold exact_N2_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N2_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N2_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N2_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h b_x b_y c_x c_y b_x' b_y' c_x' c_y'). unfold exact_N2_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem sum_N2 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  Rabs (exact_N2_x a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_N2_y a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_N2_z a_x a_y a_z b_x b_y b_z c_x c_y c_z) <= 400 / 100.
Proof.
  intros.
  refine (Rle_trans _ _ _ (Req_le _ _ _) (N_sum b_x b_y b_z c_x c_y c_z _ _ _ _ _ _)); try assumption.
  unfold exact_N2_x; cbv zeta.
  unfold exact_N2_y; cbv zeta.
  unfold exact_N2_z; cbv zeta.
  unfold Q. repeat apply f_equal2; apply f_equal; ring.
Qed.

Definition exact_N3_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  c_y * a_z - c_z * a_y.

Theorem range_N3_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N3_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range c_y c_z a_y a_z). unfold exact_N3_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N3_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N3_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N3_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h c_y c_z a_y a_z c_y' c_z' a_y' a_z'). unfold exact_N3_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_N3_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  c_z * a_x - c_x * a_z.

Theorem range_N3_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N3_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range c_z c_x a_z a_x). unfold exact_N3_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N3_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N3_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N3_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h c_z c_x a_z a_x c_z' c_x' a_z' a_x'). unfold exact_N3_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_N3_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  c_x * a_y - c_y * a_x.

Theorem range_N3_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -2 <= exact_N3_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 2.
Proof.
  intros. assert (L := N_range c_x c_y a_x a_y). unfold exact_N3_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_N3_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (4 * h) (exact_N3_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_N3_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := N_change h c_x c_y a_x a_y c_x' c_y' a_x' a_y'). unfold exact_N3_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem sum_N3 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  Rabs (exact_N3_x a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_N3_y a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_N3_z a_x a_y a_z b_x b_y b_z c_x c_y c_z) <= 400 / 100.
Proof.
  intros.
  refine (Rle_trans _ _ _ (Req_le _ _ _) (N_sum c_x c_y c_z a_x a_y a_z _ _ _ _ _ _)); try assumption.
  unfold exact_N3_x; cbv zeta.
  unfold exact_N3_y; cbv zeta.
  unfold exact_N3_z; cbv zeta.
  unfold Q. repeat apply f_equal2; apply f_equal; ring.
Qed.

Definition exact_d1 (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  ab - aa.

Theorem range_d1 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -6 <= exact_d1 a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 3 / 4.
Proof.
  intros. assert (L := d1_range a_x a_y a_z b_x b_y b_z). unfold exact_d1; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_d2 (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  bc - bb.

Theorem range_d2 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -6 <= exact_d2 a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 3 / 4.
Proof.
  intros. assert (L := d1_range b_x b_y b_z c_x c_y c_z). unfold exact_d2; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_d3 (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  ac - cc.

Theorem range_d3 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -6 <= exact_d3 a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 3 / 4.
Proof.
  intros. assert (L := d1_range c_x c_y c_z a_x a_y a_z). unfold exact_d3; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_Q1_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  a_x * e1 - AB_x * d1.

Theorem range_Q1_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q1_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range a_x a_y a_z b_x b_y b_z). unfold exact_Q1_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q1_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q1_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q1_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h a_x a_y a_z b_x b_y b_z a_x' a_y' a_z' b_x' b_y' b_z'). unfold exact_Q1_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_Q1_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  a_y * e1 - AB_y * d1.

Theorem range_Q1_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q1_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range a_y a_z a_x b_y b_z b_x). unfold exact_Q1_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q1_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q1_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q1_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h a_y a_z a_x b_y b_z b_x a_y' a_z' a_x' b_y' b_z' b_x'). unfold exact_Q1_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_Q1_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  a_z * e1 - AB_z * d1.

Theorem range_Q1_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q1_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range a_z a_x a_y b_z b_x b_y). unfold exact_Q1_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q1_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q1_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q1_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h a_z a_x a_y b_z b_x b_y a_z' a_x' a_y' b_z' b_x' b_y'). unfold exact_Q1_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem sum_Q1 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  Rabs (exact_Q1_x a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_Q1_y a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_Q1_z a_x a_y a_z b_x b_y b_z c_x c_y c_z) <= 1386 / 100.
Proof.
  intros.
  refine (Rle_trans _ _ _ (Req_le _ _ _) (Q_sum a_x a_y a_z b_x b_y b_z _ _ _ _ _ _)); try assumption.
  unfold exact_Q1_x; cbv zeta.
  unfold exact_Q1_y; cbv zeta.
  unfold exact_Q1_z; cbv zeta.
  unfold Q. repeat apply f_equal2; apply f_equal; ring.
Qed.

Definition exact_Q2_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  b_x * e2 - BC_x * d2.

Theorem range_Q2_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q2_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range b_x b_y b_z c_x c_y c_z). unfold exact_Q2_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q2_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q2_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q2_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h b_x b_y b_z c_x c_y c_z b_x' b_y' b_z' c_x' c_y' c_z'). unfold exact_Q2_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_Q2_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  b_y * e2 - BC_y * d2.

Theorem range_Q2_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q2_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range b_y b_z b_x c_y c_z c_x). unfold exact_Q2_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q2_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q2_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q2_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h b_y b_z b_x c_y c_z c_x b_y' b_z' b_x' c_y' c_z' c_x'). unfold exact_Q2_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_Q2_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  b_z * e2 - BC_z * d2.

Theorem range_Q2_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q2_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range b_z b_x b_y c_z c_x c_y). unfold exact_Q2_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q2_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q2_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q2_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h b_z b_x b_y c_z c_x c_y b_z' b_x' b_y' c_z' c_x' c_y'). unfold exact_Q2_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem sum_Q2 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  Rabs (exact_Q2_x a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_Q2_y a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_Q2_z a_x a_y a_z b_x b_y b_z c_x c_y c_z) <= 1386 / 100.
Proof.
  intros.
  refine (Rle_trans _ _ _ (Req_le _ _ _) (Q_sum b_x b_y b_z c_x c_y c_z _ _ _ _ _ _)); try assumption.
  unfold exact_Q2_x; cbv zeta.
  unfold exact_Q2_y; cbv zeta.
  unfold exact_Q2_z; cbv zeta.
  unfold Q. repeat apply f_equal2; apply f_equal; ring.
Qed.

Definition exact_Q3_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  c_x * e3 - CA_x * d3.

Theorem range_Q3_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q3_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range c_x c_y c_z a_x a_y a_z). unfold exact_Q3_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q3_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q3_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q3_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h c_x c_y c_z a_x a_y a_z c_x' c_y' c_z' a_x' a_y' a_z'). unfold exact_Q3_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_Q3_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  c_y * e3 - CA_y * d3.

Theorem range_Q3_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q3_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range c_y c_z c_x a_y a_z a_x). unfold exact_Q3_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q3_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q3_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q3_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h c_y c_z c_x a_y a_z a_x c_y' c_z' c_x' a_y' a_z' a_x'). unfold exact_Q3_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_Q3_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  c_z * e3 - CA_z * d3.

Theorem range_Q3_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -8 <= exact_Q3_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 8.
Proof.
  intros. assert (L := Q_range c_z c_x c_y a_z a_x a_y). unfold exact_Q3_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_Q3_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (24 * h) (exact_Q3_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_Q3_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := Q_change h c_z c_x c_y a_z a_x a_y c_z' c_x' c_y' a_z' a_x' a_y'). unfold exact_Q3_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem sum_Q3 : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  Rabs (exact_Q3_x a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_Q3_y a_x a_y a_z b_x b_y b_z c_x c_y c_z) +
  Rabs (exact_Q3_z a_x a_y a_z b_x b_y b_z c_x c_y c_z) <= 1386 / 100.
Proof.
  intros.
  refine (Rle_trans _ _ _ (Req_le _ _ _) (Q_sum c_x c_y c_z a_x a_y a_z _ _ _ _ _ _)); try assumption.
  unfold exact_Q3_x; cbv zeta.
  unfold exact_Q3_y; cbv zeta.
  unfold exact_Q3_z; cbv zeta.
  unfold Q. repeat apply f_equal2; apply f_equal; ring.
Qed.

Definition exact_QC_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  let Q1_x := a_x * e1 - AB_x * d1 in
  c_x * e1 - Q1_x.

Theorem range_QC_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QC_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range a_x a_y a_z b_x b_y b_z c_x). unfold exact_QC_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QC_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QC_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QC_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h a_x a_y a_z b_x b_y b_z c_x a_x' a_y' a_z' b_x' b_y' b_z' c_x'). unfold exact_QC_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QC_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  let Q1_y := a_y * e1 - AB_y * d1 in
  c_y * e1 - Q1_y.

Theorem range_QC_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QC_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range a_y a_z a_x b_y b_z b_x c_y). unfold exact_QC_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QC_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QC_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QC_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h a_y a_z a_x b_y b_z b_x c_y a_y' a_z' a_x' b_y' b_z' b_x' c_y'). unfold exact_QC_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QC_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let AB_x := b_x - a_x in
  let AB_y := b_y - a_y in
  let AB_z := b_z - a_z in
  let aa := a_x * a_x + a_y * a_y + a_z * a_z in
  let ab := a_x * b_x + a_y * b_y + a_z * b_z in
  let d1 := ab - aa in
  let e1 := AB_x * AB_x + AB_y * AB_y + AB_z * AB_z in
  let Q1_z := a_z * e1 - AB_z * d1 in
  c_z * e1 - Q1_z.

Theorem range_QC_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QC_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range a_z a_x a_y b_z b_x b_y c_z). unfold exact_QC_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QC_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QC_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QC_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h a_z a_x a_y b_z b_x b_y c_z a_z' a_x' a_y' b_z' b_x' b_y' c_z'). unfold exact_QC_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QA_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  let Q2_x := b_x * e2 - BC_x * d2 in
  a_x * e2 - Q2_x.

Theorem range_QA_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QA_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range b_x b_y b_z c_x c_y c_z a_x). unfold exact_QA_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QA_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QA_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QA_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h b_x b_y b_z c_x c_y c_z a_x b_x' b_y' b_z' c_x' c_y' c_z' a_x'). unfold exact_QA_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QA_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  let Q2_y := b_y * e2 - BC_y * d2 in
  a_y * e2 - Q2_y.

Theorem range_QA_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QA_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range b_y b_z b_x c_y c_z c_x a_y). unfold exact_QA_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QA_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QA_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QA_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h b_y b_z b_x c_y c_z c_x a_y b_y' b_z' b_x' c_y' c_z' c_x' a_y'). unfold exact_QA_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QA_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let BC_x := c_x - b_x in
  let BC_y := c_y - b_y in
  let BC_z := c_z - b_z in
  let bb := b_x * b_x + b_y * b_y + b_z * b_z in
  let bc := b_x * c_x + b_y * c_y + b_z * c_z in
  let d2 := bc - bb in
  let e2 := BC_x * BC_x + BC_y * BC_y + BC_z * BC_z in
  let Q2_z := b_z * e2 - BC_z * d2 in
  a_z * e2 - Q2_z.

Theorem range_QA_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QA_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range b_z b_x b_y c_z c_x c_y a_z). unfold exact_QA_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QA_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QA_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QA_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h b_z b_x b_y c_z c_x c_y a_z b_z' b_x' b_y' c_z' c_x' c_y' a_z'). unfold exact_QA_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QB_x (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  let Q3_x := c_x * e3 - CA_x * d3 in
  b_x * e3 - Q3_x.

Theorem range_QB_x : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QB_x a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range c_x c_y c_z a_x a_y a_z b_x). unfold exact_QB_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QB_x : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QB_x a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QB_x a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h c_x c_y c_z a_x a_y a_z b_x c_x' c_y' c_z' a_x' a_y' a_z' b_x'). unfold exact_QB_x; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QB_y (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  let Q3_y := c_y * e3 - CA_y * d3 in
  b_y * e3 - Q3_y.

Theorem range_QB_y : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QB_y a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range c_y c_z c_x a_y a_z a_x b_y). unfold exact_QB_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QB_y : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QB_y a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QB_y a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h c_y c_z c_x a_y a_z a_x b_y c_y' c_z' c_x' a_y' a_z' a_x' b_y'). unfold exact_QB_y; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Definition exact_QB_z (a_x a_y a_z b_x b_y b_z c_x c_y c_z : R) : R :=
  let CA_x := a_x - c_x in
  let CA_y := a_y - c_y in
  let CA_z := a_z - c_z in
  let ac := a_x * c_x + a_y * c_y + a_z * c_z in
  let cc := c_x * c_x + c_y * c_y + c_z * c_z in
  let d3 := ac - cc in
  let e3 := CA_x * CA_x + CA_y * CA_y + CA_z * CA_z in
  let Q3_z := c_z * e3 - CA_z * d3 in
  b_z * e3 - Q3_z.

Theorem range_QB_z : forall a_x a_y a_z b_x b_y b_z c_x c_y c_z, unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  -16 <= exact_QB_z a_x a_y a_z b_x b_y b_z c_x c_y c_z <= 16.
Proof.
  intros. assert (L := QC_range c_z c_x c_y a_z a_x a_y b_z). unfold exact_QB_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.

Theorem change_QB_z : forall h a_x a_y a_z b_x b_y b_z c_x c_y c_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z', 0 <= h ->
  unit a_x -> unit a_y -> unit a_z -> unit b_x -> unit b_y -> unit b_z -> unit c_x -> unit c_y -> unit c_z -> 
  unit a_x' -> unit a_y' -> unit a_z' -> unit b_x' -> unit b_y' -> unit b_z' -> unit c_x' -> unit c_y' -> unit c_z' -> 
  near h a_x a_x' -> near h a_y a_y' -> near h a_z a_z' -> near h b_x b_x' -> near h b_y b_y' -> near h b_z b_z' -> near h c_x c_x' -> near h c_y c_y' -> near h c_z c_z' -> 
  near (60 * h) (exact_QB_z a_x a_y a_z b_x b_y b_z c_x c_y c_z)
    (exact_QB_z a_x' a_y' a_z' b_x' b_y' b_z' c_x' c_y' c_z').
Proof.
  intros. assert (L := QC_change h c_z c_x c_y a_z a_x a_y b_z c_z' c_x' c_y' a_z' a_x' a_y' b_z'). unfold exact_QB_z; cbv zeta.
  unfold near, QC, Q in *. destruct L; try assumption. split; lra.
Qed.
