"""The faults that `prove.py --planted` plants in the theory."""

# Faults: what is replaced in which file, and the file at which coqc has to stop.
FAULTS = {
    "a wrong coefficient in a recorded formula, exact": (
        "Recorded.v", "let Q1_x := a_x * e1 - AB_x * d1 in", "let Q1_x := a_x * e1 + AB_x * d1 in", "RecordedIsSat7.v"),
    "a recorded float program in another order": (
        "Recorded.v", "let rr := rnd (r * r) in", "let rr := rnd (r * rnd (r * 1)) in", "RecordedIsProgram.v"),
    "a swapped comparison": (
        "Recorded.v", "Definition published_exact_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=",
        "Definition published_exact_vertex_a_radius_lhs (Bx By Bz Ax Ay Az Cx Cy Cz Px Py Pz r : R) : R :=",
        "RecordedIsSat7.v"),
    "a threshold halved": ("Thresholds.v", "=> 13240", "=> 6620", "Thresholds.v"),
    "a range too narrow": ("Programs.v", "capped 8", "capped 7", "Caps.v"),
    "a side reversed": (
        "Sat7.v", "Definition vertex_side_sides (A B : vec) := (dot A B, dot A A).",
        "Definition vertex_side_sides (A B : vec) := (dot A A, dot A B).", "Sound.v"),
    "an exported threshold that is not the proved one": ("Exported.v", "(13240, 6%nat)", "(13241, 6%nat)", "Exported.v"),
    "a filter's window too wide": ("Filters.v", "8388608 (-4) eq_refl", "8388608 (-3) eq_refl", "Filters.v"),
    "a comparison's window too wide": (
        "Windows.v", "edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 20", "edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 21",
        "Windows.v"),
    "a bound beside a margin too small": (
        "Margins.v", "Definition edge_side_units : R := 3.", "Definition edge_side_units : R := 2.", "Margins.v"),
    "a coarse threshold too small": (
        "Certified.v", "Definition coarse_degree_4 : R := 11.15625.", "Definition coarse_degree_4 : R := 10.", "Certified.v"),
    "a coarse range that overflows": ("CoarseFloat.v", "24 128 (-21) 19 eq_refl", "24 128 (-21) 20 eq_refl", "CoarseFloat.v"),
    "a fused product of the wrong sign": (
        "Sizes.v", "if fused then Bfma mode_NE (Bopp y) z x", "if fused then Bfma mode_NE y z x", "Sizes.v"),
    "an error of the conservative test too small": (
        "Conservative.v", "Definition conservative_error : R := 10.", "Definition conservative_error : R := 7.", "Conservative.v"),
    "a range of the conservative test too wide": (
        "ConservativeStep.v", "conservative_never_misses 24 (-149) (-42)", "conservative_never_misses 24 (-149) (-43)", "ConservativeStep.v"),
    "a margin of the conservative test with the error added": (
        "ConservativeStep.v", "(mix s xz yz) - error)", "(mix s xz yz) + error)", "ConservativeStep.v"),
    "an open sphere that a triangle without area is apart from by its plane": (
        "OpenSphere.v", "| plane_radius => normal A B C <> Vec 0 0 0", "| plane_radius => True", "OpenSphere.v"),
    "an open sphere that an edge without length is an axis of": (
        "OpenSphere.v", "| edge_bc_radius => sub C B <> Vec 0 0 0", "| edge_bc_radius => True", "OpenSphere.v"),
    "an open sphere that touching counts as contact with": (
        "OpenSphere.v", "in_triangle X A B C -> r <= distance P X", "in_triangle X A B C -> r < distance P X", "OpenSphere.v"),
    "an open sphere's coarse range that overflows": (
        "OpenCoarse.v", "24 128 (-21) 19 eq_refl", "24 128 (-21) 20 eq_refl", "OpenCoarse.v"),
    "a pair's difference with an error of four units": (
        "Margins.v", "Rabs (M - (x - y)) <= u * (Rabs x", "Rabs (M - (x - y)) <= 4 * u * (Rabs x", "Margins.v"),
    "a leading double with an error of a sixteenth": (
        "Margins.v", "Rabs (L - M) <= / 1048576 * Rabs M", "Rabs (L - M) <= / 16 * Rabs M", "Margins.v"),
    "a pair's difference with a sum of one error more": (
        "Pairs.v", "(rnd (x - rnd (sum - part)) + rnd (y - part))", "(rnd (x - rnd (sum - part)) + (rnd y - part))", "Pairs.v"),
    "a pair's difference without its low parts": (
        "Pairs.v", "(plus (minus (pair_low x) (pair_low y)) (pair_low s))", "(pair_low s)", "Pairs.v"),
    "a lane that has the axis of another edge": (
        "PairStep.v", "(holds edge_ab_radius /\\ holds edge_ab_side_c).", "(holds edge_bc_radius /\\ holds edge_bc_side_a).", "PairStep.v"),
    "a lane that is not renamed": (
        "PairStep.v", "lane_contact a b c p r && lane_contact b c a p r && lane_contact c a b p r",
        "lane_contact a b c p r && lane_contact a b c p r && lane_contact c a b p r", "PairStep.v"),
    "a face of the box on the wrong side": (
        "Box.v", "then Bminus mode_NE p r else B754_infinity true", "then Bplus mode_NE p r else B754_infinity true", "Box.v"),
    "a box about a sphere that is not valid": (
        "Box.v", "then Bplus mode_NE p r else B754_infinity false", "then Bplus mode_NE p r else p", "Box.v"),
    "a tie that counts as beyond for the closed sphere": (
        "Known.v", "q = open_sphere /\\ has_normal A B C K)", "has_normal A B C K)", "Known.v"),
    "an edge that is nearest from the inside": (
        "NearestPart.v", "corner_beyond A B C <= 0.\n", "0 <= corner_beyond A B C.\n", "NearestPart.v"),
    "a contact that one axis without a bit is enough for": (
        "Known.v", "is_contact (k : known) : bool := forallb", "is_contact (k : known) : bool := existsb", "Known.v"),
    # Faults that an audit planted in the sources of the certified predicate and no random query showed, as the recorder would emit them.
    "coarse thresholds a quarter of what is proved": (
        "RecordedCertified.v", "m_multiply m (m_constant m 323 (-28))", "m_multiply m (m_constant m 323 (-30))", "RecordedIsCertified.v"),
    "coarse thresholds a sixteenth of what is proved": (
        "RecordedCertified.v", "m_multiply m (m_constant m 187 (-29))", "m_multiply m (m_constant m 187 (-33))", "RecordedIsCertified.v"),
    "a coarse range in binary32 from 2^-60": (
        "RecordedCertified.v", "m_at_most m (m_constant m 1 (-21))", "m_at_most m (m_constant m 1 (-60))", "RecordedIsCertified.v"),
    "a unit of pairs of 2^-106": ("RecordedCertified.v", "(51, (-105))", "(51, (-109))", "RecordedIsDeep.v"),
    "residues known below 2^64 units": ("RecordedCertified.v", "(1, 60)", "(1, 64)", "RecordedIsDeep.v"),
    "an error of the conservative test a quarter of what is proved": (
        "RecordedCertified.v", "m_multiply m (m_constant m 5 (-23))", "m_multiply m (m_constant m 5 (-25))", "RecordedIsConservative.v"),
    "a promised depth of phantoms that is not proved": (
        "RecordedCertified.v", "binary32 : Z * Z := (5, (-10))", "binary32 : Z * Z := (19, (-12))", "RecordedIsConservative.v"),
    "a lane of the single pair with its neighbour's vertices": (
        "RecordedCertified.v", "Definition pair_fma_binary32_answers (m : machine) (ax ay az bx by_ bz",
        "Definition pair_fma_binary32_answers (m : machine) (bx by_ bz ax ay az", "RecordedIsCertified.v"),
    "an operand exchanged in the exact step": ("RecordedExact.v", "(Minus 0 9, 1)", "(Minus 9 0, 1)", "ExactStep.v"),
    "a tie that the exact step takes as beyond": (
        "RecordedExact.v", "Definition recorded_closed_axes : list tree :=\n  [Ask (Knows 0 0) (Answer false) (Ask (Knows 1 0) (",
        "Definition recorded_closed_axes : list tree :=\n  [Ask (Knows 0 0) (Answer true) (Ask (Knows 1 0) (", "ExactVerdict.v"),
    "an axis that is left out of the exact step": ("RecordedExact.v", "Ask (Separates 6)", "Ask (Separates 5)", "ExactVerdict.v"),
    "integers of 94 bits for numbers of 95": ("RecordedExact.v", "(32%nat, 94)", "(33%nat, 94)", "ExactVerdict.v"),
    "integers of 126 bits for numbers of 127": ("RecordedExact.v", "(32%nat, 126)", "(33%nat, 126)", "ExactVerdict.v"),
    "a word too few for degree 4 in integers of 94 bits": ("RecordedExact.v", "[2; 3; 5; 6; 9]", "[2; 3; 5; 5; 9]", "ExactVerdict.v"),
    "a normal that is not computed where the plane asks for it": (
        "RecordedExact.v", "Definition recorded_needs_normal : list bool :=\n  [true;", "Definition recorded_needs_normal : list bool :=\n  [false;",
        "ExactVerdict.v"),
    "a ball that is rounded and keeps its error": ("Balls.v", "k / power + lost m power + lost k power", "k / power + lost k power", "Balls.v"),
    "an edge's side that a ball tells from the wrong sign": (
        "RecordedExact.v", "Is_at_most_zero 136", "Is_at_least_zero 136", "Balls.v"),
    "a word too few for a product of the exact step": (
        "ExactProgram.v", "then 1 else degree + 2)", "then 1 else degree - 2)", "ExactProgram.v"),
    "a fine bound too small": (
        "FineStep.v", "Definition fine_vertex_side := number 255 (-57).", "Definition fine_vertex_side := number 255 (-58).", "FineStep.v"),
    "a tie that the fine step takes as contact of the open sphere": (
        "FineKnown.v", "if open then m_less m (fine_value K) least", "if open then m_at_most m (fine_value K) least", "FineKnown.v"),
    "an edge without length that the fine step's bits do not ask for": (
        "RecordedCertified.v", "m_equal m t47 (m_zero m)", "m_equal m t31 (m_zero m)", "FineKnown.v"),
    "a grid below the least number": ("Extents.v", "((-1074 <=? grid d)", "((-1105 <=? grid d)", "Extents.v"),
    "a coarse step that tells that a comparison holds where it may not": (
        "CoarseKnown.v", "(fun i => Bltb (t (radius_of i)) (m (radius_of i)))", "(fun i => Bltb (Bopp (t (radius_of i))) (m (radius_of i)))",
        "CoarseKnown.v"),
    "a radius taken as zero that is not negligible": (
        "Negligible.v", "r <= bpow radix2 (-2 * n - 2))%R.", "r <= bpow radix2 (-2 * n - 1))%R.", "Negligible.v"),
    "a conservative test's range that overflows": (
        "ConservativeFloat.v", "float_answers 24 128 (-42) 30 (-60)", "float_answers 24 128 (-42) 32 (-60)", "ConservativeFloat.v"),
    "a share of an edge that is not clamped from above": (
        "ConservativeProgram.v", "(product X along)) e else zero) zero) one", "(product X along)) e else zero) zero) zero", "ConservativeProgram.v"),
    "a side of the plane by another vertex": (
        "ConservativeProgram.v", "m_with_sign m one (product A n)", "m_with_sign m one (product B n)", "ConservativeProgram.v"),
    "a power of two from bits with another bias": ("InversePower.v", "0x7f000000 0x7f800000", "0x7f800000 0x7f800000", "InversePower.v"),
    "an upper end of the conservative test that is not proved": (
        "RecordedCertified.v", "(m_constant m 1 60)", "(m_constant m 1 64)", "RecordedIsConservative.v"),
    "a share that is not clamped from above in the code": (
        "RecordedCertified.v", "let t71 := m_least m t70 (m_constant m 1 0) in", "let t71 := t70 in", "RecordedIsConservative.v"),
    "a quotient that is taken where the edge has no length": (
        "RecordedCertified.v", "let t69 := if t61 then t68 else (m_zero m) in", "let t69 := t68 in", "RecordedIsConservative.v"),
    "a low end of the box that is the high one": (
        "RecordedIsBox.v", "if code_valid then m_subtract m p r", "if code_valid then m_add m p r", "RecordedIsBox.v"),
    "an answer that the opposite verdict supports": ("Blocks.v", "| said_contact => negb apart", "| said_contact => apart", "Blocks.v"),
    "a last step that is given bits that nothing told": (
        "Blocks.v", "Z.land k (Z.lnot told) =? 0 | _ => true", "Z.land k told =? k + 1 | _ => true", "BlocksAreRight.v"),
    "a contact that a recorded block's answer lacks": (
        "RecordedBlocks.v", "Taken false true false [said_contact]", "Taken false false false [said_contact]", "BlocksAreRight.v"),
    "integers of 62 bits for numbers of 94": ("RecordedWindows.v", " (94) ", " (62) ", "WindowsAreRight.v"),
    "a coarse step that is trusted outside its range": (
        "WhatRemains.v", "fused low a b c p r else nothing_known.", "fused low a b c p r else coarse_known 53 1024 eq_refl eq_refl fused low a b c p r.",
        "WhatRemains.v"),
    # Theorems made weaker, which the theorems that use them refuse.
    "a coarse step that may be wrong for an infinite radius": (
        "CoarseFloat.v", "(r : binary_float prec emax),\n", "(r : binary_float prec emax), is_finite r = true ->\n",
        "PairStep.v"),
    "a conservative test that may miss a point's contact": (
        "ConservativeStep.v", "in_format prec emin p -> 0 <= r ->\n  let rnd", "in_format prec emin p -> 0 < r ->\n  let rnd",
        "ConservativeFloat.v"),
    "phantoms too shallow": ("PhantomStep.v", "Definition phantom_depth : R := 20.", "Definition phantom_depth : R := 19.", "PhantomStep.v"),
}

# Theorems made weaker, which still have their proofs: what is replaced in which file, and the statement that says less
# then.
WEAKENED = {
    "a conservative test that may be wrong for an infinite radius": (
        "ConservativeFloat.v", "  forall a b c p r,\n  let says := nth 0 (answers", "  forall a b c p r, is_finite r = true ->\n  let says := nth 0 (answers",
        "conservative_is_right"),
    "a filter that may be wrong for an infinite radius": (
        "Filters.v", "-> Prop) : Prop := forall q,", "-> Prop) : Prop := forall q, is_finite (fr prec emax q) = true ->",
        "never_lies"),
    "a program recorded for one comparison only": (
        "RecordedIsProgram.v", "Theorem published_float_program rnd q m K :",
        "Theorem published_float_program rnd q m K : K = plane_radius ->", "published_float_program"),
    "a single pair that may be wrong for an infinite radius": (
        "PairStep.v", "(r : binary_float prec emax),\n  let closed", "(r : binary_float prec emax), is_finite r = true ->\n  let closed",
        "float_pair_never_lies"),
    "an open coarse step that may be wrong with fused products": (
        "OpenCoarse.v", "  forall fused (a b c p : float_vec prec emax) (r : binary_float prec emax),\n  let apart",
        "  forall fused (a b c p : float_vec prec emax) (r : binary_float prec emax), fused = false ->\n  let apart",
        "float_coarse_never_lies_open"),
    "phantoms that may be deeper": (
        "PhantomStep.v", "Definition phantom_depth : R := 20.", "Definition phantom_depth : R := 21.", "phantom_depth"),
}
