(* The recorded blocks: each query's answer is supported by what was said of that query, no bit is given to the last step that was
   not told of it, and what is invalid is marked and never a contact. *)
From Coq Require Import List.
From Axiscert Require Import Blocks RecordedBlocks.
Theorem recorded_blocks_are_right : forallb (forallb taken_is_right) recorded_blocks = true.
Proof. vm_compute; reflexivity. Qed.
