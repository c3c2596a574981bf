(* The programs of the sixteen comparisons in the language of Expression.v, plain and with fused multiply-adds, with
   caps on quantities whose exact size is less than the sum of their terms' sizes. RecordedIsProgram.v proves that they
   are the programs recorded from the kernel. *)
From Coq Require Import Reals ZArith Lra Psatz.
From Axiscert Require Import Vectors Expression.
Open Scope R_scope.

Record triple := Triple { ex : expression; ey : expression; ez : expression }.

Definition A := Triple (Leaf ax) (Leaf ay) (Leaf az).
Definition B := Triple (Leaf bx) (Leaf by_) (Leaf bz).
Definition C := Triple (Leaf cx_) (Leaf cy_) (Leaf cz_).
Definition rr := Mul (Leaf radius) (Leaf radius).

Definition minus (v w : triple) := Triple (Sub (ex v) (ex w)) (Sub (ey v) (ey w)) (Sub (ez v) (ez w)).
Definition times (v : triple) (s : expression) := Triple (Mul (ex v) s) (Mul (ey v) s) (Mul (ez v) s).
Definition capped (c : Z) (v : triple) := Triple (Cap c (ex v)) (Cap c (ey v)) (Cap c (ez v)).

Section Arithmetic.
  Variable fused : bool.

  Definition sum_of_products (v w : triple) :=
    if fused then Fma (ez v) (ez w) (Fma (ey v) (ey w) (Mul (ex v) (ex w)))
    else Add (Add (Mul (ex v) (ex w)) (Mul (ey v) (ey w))) (Mul (ez v) (ez w)).
  Definition difference_of_products (a b c d : expression) :=
    if fused then Fma a b (Neg (Mul c d)) else Sub (Mul a b) (Mul c d).
  Definition vector_product (v w : triple) :=
    Triple (difference_of_products (ey v) (ez w) (ez v) (ey w)) (difference_of_products (ez v) (ex w) (ex v) (ez w))
           (difference_of_products (ex v) (ey w) (ey v) (ex w)).

  Notation "v ** w" := (sum_of_products v w) (at level 40).

  Definition V := capped 4 (vector_product (minus B A) (minus C A)).
  Definition d := Cap 4 (A ** V).
  Definition plane_radius_program := (Mul d d, Mul rr (V ** V)).

  (* The foot of the sphere's centre on an edge, scaled; `products` is the dot product of its ends. *)
  Definition Q (v w : triple) (products : expression) :=
    let along := minus w v in
    capped 8 (minus (times v (along ** along)) (times along (Sub products (v ** v)))).
  Definition edge_radius_program (v w : triple) (products : expression) :=
    let e := minus w v ** minus w v in
    (Q v w products ** Q v w products, Mul (Mul rr e) e).
  Definition edge_side_program (v w z : triple) (products : expression) :=
    let e := minus w v ** minus w v in
    (Q v w products ** minus (times z e) (Q v w products), Zero 6).

  Definition published_program (K : comparison) : expression * expression :=
    match K with
    | plane_radius => plane_radius_program
    | vertex_a_radius => (A ** A, rr)
    | vertex_a_side_b => (A ** B, A ** A)
    | vertex_a_side_c => (A ** C, A ** A)
    | vertex_b_radius => (B ** B, rr)
    | vertex_b_side_a => (A ** B, B ** B)
    | vertex_b_side_c => (B ** C, B ** B)
    | vertex_c_radius => (C ** C, rr)
    | vertex_c_side_a => (A ** C, C ** C)
    | vertex_c_side_b => (B ** C, C ** C)
    | edge_ab_radius => edge_radius_program A B (A ** B)
    | edge_ab_side_c => edge_side_program A B C (A ** B)
    | edge_bc_radius => edge_radius_program B C (B ** C)
    | edge_bc_side_a => edge_side_program B C A (B ** C)
    | edge_ca_radius => edge_radius_program C A (A ** C)
    | edge_ca_side_b => edge_side_program C A B (A ** C)
    end.

  Definition reduced_radius_program (v w : triple) :=
    (vector_product v w ** vector_product v w, Mul rr (minus w v ** minus w v)).
  Definition reduced_side_program (v w : triple) := (Zero 4, vector_product v w ** V).

  Definition reduced_program (K : comparison) : expression * expression :=
    match K with
    | edge_ab_radius => reduced_radius_program A B
    | edge_ab_side_c => reduced_side_program A B
    | edge_bc_radius => reduced_radius_program B C
    | edge_bc_side_a => reduced_side_program B C
    | edge_ca_radius => reduced_radius_program C A
    | edge_ca_side_b => reduced_side_program C A
    | _ => published_program K
    end.
End Arithmetic.

(* The error of lhs - rhs before the last subtraction, in units of u / 1024 of m^degree; and that degree. *)
Definition margin_error (p : Z) (sides : expression * expression) : option (Z * nat) :=
  match bound p None (fst sides), bound p None (snd sides) with
  | Some l, Some r => if Nat.eqb (of_degree l) (of_degree r) then Some (error l + error r, of_degree l)%Z else None
  | _, _ => None
  end.

