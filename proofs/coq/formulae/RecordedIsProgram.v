(* The programs of Programs.v, rounded, are the programs recorded from the kernel, operation by operation; and over the
   reals they have its exact values. *)
From Coq Require Import Reals.
From Axiscert Require Import Vectors Expression Programs Recorded Sides.
Open Scope R_scope.

(* The leaves of a query: its translated coordinates, each rounded by `rnd`, its radius, and the bound m of these. *)
Definition leaves (rnd : R -> R) (q : query) (m : R) (l : leaf) : R :=
  match l with
  | ax => rnd (cx (vertex_a q) - cx (centre q))
  | ay => rnd (cy (vertex_a q) - cy (centre q))
  | az => rnd (cz (vertex_a q) - cz (centre q))
  | bx => rnd (cx (vertex_b q) - cx (centre q))
  | by_ => rnd (cy (vertex_b q) - cy (centre q))
  | bz => rnd (cz (vertex_b q) - cz (centre q))
  | cx_ => rnd (cx (vertex_c q) - cx (centre q))
  | cy_ => rnd (cy (vertex_c q) - cy (centre q))
  | cz_ => rnd (cz (vertex_c q) - cz (centre q))
  | radius => query_radius q
  | magnitude => m
  end.

Definition exact_leaves := leaves (fun x => x).

Definition rounded_sides (rnd : R -> R) (x : leaf -> R) (sides : expression * expression) : R * R :=
  (rounded rnd x (fst sides), rounded rnd x (snd sides)).
Definition exact_sides (x : leaf -> R) (sides : expression * expression) : R * R :=
  (exact x (fst sides), exact x (snd sides)).

Theorem published_float_program rnd q m K :
  recorded_published_float rnd q K = rounded_sides rnd (leaves rnd q m) (published_program false K).
Proof. destruct K; reflexivity. Qed.
Theorem published_fma_program rnd q m K :
  recorded_published_fma rnd q K = rounded_sides rnd (leaves rnd q m) (published_program true K).
Proof. destruct K; reflexivity. Qed.
Theorem reduced_float_program rnd q m K :
  recorded_reduced_float rnd q K = rounded_sides rnd (leaves rnd q m) (reduced_program false K).
Proof. destruct K; reflexivity. Qed.
Theorem reduced_fma_program rnd q m K :
  recorded_reduced_fma rnd q K = rounded_sides rnd (leaves rnd q m) (reduced_program true K).
Proof. destruct K; reflexivity. Qed.

Ltac same_value q K := destruct q as [[? ? ?] [? ? ?] [? ? ?] [? ? ?] ?]; destruct K;
  cbv -[Rplus Rminus Rmult Ropp IZR]; apply f_equal2; ring.

Theorem published_exact_program fused q m K :
  recorded_published_exact q K = exact_sides (exact_leaves q m) (published_program fused K).
Proof. destruct fused; same_value q K. Qed.
Theorem reduced_exact_program fused q m K :
  recorded_reduced_exact q K = exact_sides (exact_leaves q m) (reduced_program fused K).
Proof. destruct fused; same_value q K. Qed.
