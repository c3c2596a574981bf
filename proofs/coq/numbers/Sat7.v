(* The seven-axis test over the reals, with the sphere's centre at the origin: the formulae of
   kernel/sphere_triangle/formulae.h, stated by hand. RecordedIsSat7.v proves that the expressions recorded from that
   file are these. *)
From Coq Require Import Reals.
From Axiscert Require Import Vectors.
Open Scope R_scope.

Definition normal (A B C : vec) := cross (sub B A) (sub C A).
Definition offset (A B C : vec) := dot A (normal A B C).
Definition length2 (A B : vec) := dot (sub B A) (sub B A).

(* The foot of the origin on the line AB, scaled by |AB|^2; and the vector from there to C. *)
Definition foot (A B : vec) := sub (scale A (length2 A B)) (scale (sub B A) (dot A B - dot A A)).
Definition from_foot (A B C : vec) := sub (scale C (length2 A B)) (foot A B).

(* The sides (lhs, rhs) of an axis' comparisons. *)
Definition plane_sides (A B C : vec) (rr : R) :=
  (offset A B C * offset A B C, rr * dot (normal A B C) (normal A B C)).
Definition vertex_radius_sides (A : vec) (rr : R) := (dot A A, rr).
Definition vertex_side_sides (A B : vec) := (dot A B, dot A A).
Definition edge_radius_sides (A B : vec) (rr : R) :=
  (dot (foot A B) (foot A B), rr * length2 A B * length2 A B).
Definition edge_side_sides (A B C : vec) := (dot (foot A B) (from_foot A B C), 0).

Definition published (A B C : vec) (rr : R) (K : comparison) : R * R :=
  match K with
  | plane_radius => plane_sides A B C rr
  | vertex_a_radius => vertex_radius_sides A rr
  | vertex_a_side_b => vertex_side_sides A B
  | vertex_a_side_c => vertex_side_sides A C
  | vertex_b_radius => vertex_radius_sides B rr
  | vertex_b_side_a => vertex_side_sides B A
  | vertex_b_side_c => vertex_side_sides B C
  | vertex_c_radius => vertex_radius_sides C rr
  | vertex_c_side_a => vertex_side_sides C A
  | vertex_c_side_b => vertex_side_sides C B
  | edge_ab_radius => edge_radius_sides A B rr
  | edge_ab_side_c => edge_side_sides A B C
  | edge_bc_radius => edge_radius_sides B C rr
  | edge_bc_side_a => edge_side_sides B C A
  | edge_ca_radius => edge_radius_sides C A rr
  | edge_ca_side_b => edge_side_sides C A B
  end.

(* The degree-4 edges: N = A x B, and sides |N|^2 > rr |AB|^2 and 0 > N.V. *)
Definition reduced_radius_sides (A B : vec) (rr : R) := (dot (cross A B) (cross A B), rr * length2 A B).
Definition reduced_side_sides (A B C : vec) := (0, dot (cross A B) (normal A B C)).

Definition reduced (A B C : vec) (rr : R) (K : comparison) : R * R :=
  match K with
  | edge_ab_radius => reduced_radius_sides A B rr
  | edge_ab_side_c => reduced_side_sides A B C
  | edge_bc_radius => reduced_radius_sides B C rr
  | edge_bc_side_a => reduced_side_sides B C A
  | edge_ca_radius => reduced_radius_sides C A rr
  | edge_ca_side_b => reduced_side_sides C A B
  | _ => published A B C rr K
  end.

(* The published test has strict comparisons; the one that is right for every triangle has >= in the side
   comparisons. *)
Definition strict (sides : R * R) := fst sides > snd sides.
Definition nonstrict (K : comparison) (sides : R * R) :=
  if is_side K then fst sides >= snd sides else fst sides > snd sides.

Definition sat7_strict (A B C : vec) (rr : R) := some_axis (fun K => strict (published A B C rr K)).
Definition sat7 (A B C : vec) (rr : R) := some_axis (fun K => nonstrict K (published A B C rr K)).
