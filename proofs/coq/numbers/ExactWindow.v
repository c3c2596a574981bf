(* Which integers the exact step takes for a query: they are the query's numbers in one unit, they fit, and no smaller ones would
   have been allowed; a radius that is taken as zero is negligible, and the sphere then taken as closed; balls are asked before, and
   digits taken, for spans that are too wide. *)
From Coq Require Import ZArith Bool List Lia.
Import ListNotations.
Open Scope Z_scope.

Record exact_window := ExactWindow {
  w_widest : Z;  (* 0: the way of AXISCERT_EXACT_ONLY, with integers to 286 bits and no balls before *)
  w_open : bool; w_open_after : bool;
  w_size : Z;  (* of the integers; 0: digits; -1: none, since the answer was there *)
  w_balls : bool;
  w_query : list (Z * Z);  (* n 2^e *)
  w_numbers : list Z }.

(* The numbers in units of the least exponent. *)
Definition least_exponent (l : list (Z * Z)) : Z := fold_right (fun x e => if fst x =? 0 then e else Z.min (snd x) e) 10000 l.
Definition in_units (l : list (Z * Z)) : list Z := let e := least_exponent l in map (fun x => fst x * 2 ^ (snd x - e)) l.
(* The n for which numbers are below 2^(n - 1). *)
Definition window_span (l : list Z) : Z := fold_right (fun x n => if x =? 0 then n else Z.max (2 + Z.log2 (Z.abs x)) n) 1 l.
Definition same_ratio (x0 z0 x z : Z) : bool := x * z0 =? z * x0.

Definition window_sizes := [30; 62; 94; 126; 286].
Definition window_is_right (w : exact_window) : bool :=
  let xs := in_units (w_query w) in
  let points := firstn 12 xs in let r := nth 12 xs 0 in
  let z0 := hd 0 (w_numbers w) in let x0 := hd 0 xs in
  let zr := nth 12 (w_numbers w) 0 in
  let n := window_span (firstn 12 (w_numbers w)) in
  (* r <= 2^(-2 n - 2) in units of the integers *)
  let negligible := (zr =? 0) && (0 <? r) && (r * Z.abs z0 * 2 ^ (2 * n + 2) <=? Z.abs x0) in
  let points_alone := window_span (in_units (firstn 12 (w_query w))) in
  let wide := if w_widest w =? 0 then 286 else w_widest w in
  let before := if w_widest w =? 0 then 286 else 126 in
  (* An open sphere of radius 0 is empty. *)
  if w_open w && (r =? 0) then (w_size w =? -1) && negb (w_balls w)
  else if w_size w =? -1 then before <? window_span xs
  else if w_size w =? 0 then (wide <? window_span xs) && (w_balls w || (w_widest w =? 0) || negb (before <? window_span xs))
  else
    existsb (Z.eqb (w_size w)) window_sizes && (Z.of_nat (length (w_numbers w)) =? 13) && negb (z0 =? 0) &&
    forallb (fun z => Z.abs z <? 2 ^ (w_size w - 1)) (w_numbers w) &&
    forallb (fun p => same_ratio x0 z0 (fst p) (snd p)) (combine points (firstn 12 (w_numbers w))) &&
    (if same_ratio x0 z0 r zr then Bool.eqb (w_open w) (w_open_after w) else negligible && negb (w_open_after w)) &&
    (w_size w <=? Z.max 62 wide) && (if negligible then true else Bool.eqb (w_balls w) (before <? window_span xs)).
