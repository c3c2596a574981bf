(* The recorded windows, to both sides of each size's end and of the negligible radius. *)
From Coq Require Import List.
From Axiscert Require Import ExactWindow RecordedWindows.
Theorem recorded_windows_are_right : forallb window_is_right recorded_windows = true.
Proof. vm_compute; reflexivity. Qed.
