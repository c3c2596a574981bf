(* The constants of the certified predicate's deep step, as recorded from the code that runs, are those of the theorems: the
   bounds of Margins.v with the unit of pairs, 2^-102; the range of its numbers, 2^-100 to 2^100; and the limit below which a
   value is known by its residue, 2^60 units. Where they stand in its program is compared by proofs.Current, not here. *)
From Coq Require Import Reals ZArith List Lra.
From Flocq Require Import Core.
From Axiscert Require Import Vectors Margins Pairs FineStep RecordedCertified.
Import ListNotations.
Open Scope R_scope.

Definition values (constants : list (Z * Z)) : list R := map (fun x => IZR (fst x) * bpow radix2 (snd x)) constants.
Definition of_pairs (n : R) : R := units (bpow radix2 (-102)) n.
Definition least_size : R := bpow radix2 (-100).
Definition greatest_size : R := bpow radix2 100.
Definition residue_limit : R := bpow radix2 60.
(* The factor that splits a double in two halves, where there is no fused multiply-add. *)
Definition split_factor (fused : bool) : list R := if fused then [] else [134217729].

Definition recorded_deep (fused : bool) : list (list R) :=
  map values (if fused
    then [deep_vertex_radius_fma_binary64_constants; deep_vertex_sides_fma_binary64_constants; deep_edge_radius_fma_binary64_constants;
          deep_edge_side_fma_binary64_constants; deep_plane_radius_fma_binary64_constants]
    else [deep_vertex_radius_plain_binary64_constants; deep_vertex_sides_plain_binary64_constants; deep_edge_radius_plain_binary64_constants;
          deep_edge_side_plain_binary64_constants; deep_plane_radius_plain_binary64_constants]).
(* By size, each once. *)
Theorem recorded_deep_constants fused : recorded_deep fused =
  let last := split_factor fused ++ [residue_limit; greatest_size] in
  [[least_size; of_pairs vertex_radius_units] ++ last;
   [least_size; of_pairs vertex_side_units] ++ last;
   [least_size; of_pairs edge_square_units; of_pairs edge_rhs_units; fine_twice; fine_thrice] ++ last;
   [of_pairs edge_side_units; least_size; of_pairs normal_units; fine_once; fine_thrice_in_side] ++ last;
   [of_pairs plane_lhs_units; least_size; of_pairs offset_units; of_pairs plane_rhs_units; of_pairs normal_units; fine_once_offset; fine_twice;
    fine_thrice] ++ last].
Proof.
  destruct fused; cbv [recorded_deep split_factor map values app fst snd
      deep_vertex_radius_fma_binary64_constants deep_vertex_sides_fma_binary64_constants deep_edge_radius_fma_binary64_constants
      deep_edge_side_fma_binary64_constants deep_plane_radius_fma_binary64_constants deep_vertex_radius_plain_binary64_constants
      deep_vertex_sides_plain_binary64_constants deep_edge_radius_plain_binary64_constants deep_edge_side_plain_binary64_constants
      deep_plane_radius_plain_binary64_constants of_pairs units least_size greatest_size residue_limit vertex_radius_units vertex_side_units
      normal_units offset_units plane_lhs_units plane_rhs_units edge_square_units edge_rhs_units edge_side_units unit_factor fine_once
      fine_once_offset fine_twice fine_thrice fine_thrice_in_side];
    repeat (apply (f_equal2 (@cons (list R))) || apply (f_equal2 (@cons R))); try reflexivity; cbn; lra.
Qed.
