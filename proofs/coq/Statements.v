(* Prints the statement of each main theorem and the definitions that it uses; Statements.expected has the text that it
   has to print. Coq checks a proof, but a statement can only be checked by reading it, so a statement that becomes
   weaker must not go unread. *)
From Coq Require Import Reals ZArith List.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Sat7 Exact Reduced OpenSphere Known Scaled Sides RecordedIsSat7 RecordedIsProgram Expression
  Programs Format Run Window Windows Thresholds Filter Filters Lanes Margins Pairs Certified CertifiedStep Sizes CoarseFloat OpenCoarse
  PairStep Box Conservative ConservativeStep PhantomStep ConservativeProgram ConservativeFloat InversePower Exported Decides
  ExactProgram RecordedExact ExactStep Negligible CertifiedIsExact Machine RecordedCertified RecordedIsCertified CoarseKnown FineStep RecordedIsDeep RecordedIsConservative.
Open Scope R_scope.
Set Printing Width 120.

Tactic Notation "statement" string(name) := idtac "==" name.
Goal True. statement "sat7_exact". Abort.
Check sat7_exact.
Goal True. statement "sat7_exact_strict". Abort.
Check sat7_exact_strict.
Goal True. statement "sat7_strict_sound". Abort.
Check sat7_strict_sound.
Goal True. statement "strict_wrong_for_repeated_vertex". Abort.
Check strict_wrong_for_repeated_vertex.
Goal True. statement "strict_wrong_for_collinear". Abort.
Check strict_wrong_for_collinear.
Goal True. statement "reduced_equiv". Abort.
Check reduced_equiv.
Goal True. statement "reduced_exact". Abort.
Check reduced_exact.
Goal True. statement "open_exact". Abort.
Check open_exact.
Goal True. statement "open_contact". Abort.
Check open_contact.
Goal True. statement "open_left_side". Abort.
Check open_left_side.
Goal True. statement "either_exact". Abort.
Check either_exact.
Goal True. statement "sign_decides". Abort.
Check sign_decides.
Goal True. statement "both_are_sound". Abort.
Check both_are_sound.
Goal True. statement "known_is_right". Abort.
Check known_is_right.
Goal True. statement "last_step_decides". Abort.
Check last_step_decides.
Goal True. statement "scaled_is_same". Abort.
Check scaled_is_same.
Goal True. statement "recorded_published_is_sat7". Abort.
Check recorded_published_is_sat7.
Goal True. statement "recorded_reduced_is_sat7". Abort.
Check recorded_reduced_is_sat7.
Goal True. statement "published_float_program". Abort.
Check published_float_program.
Goal True. statement "published_fma_program". Abort.
Check published_fma_program.
Goal True. statement "reduced_float_program". Abort.
Check reduced_float_program.
Goal True. statement "reduced_fma_program". Abort.
Check reduced_fma_program.
Goal True. statement "bound_sound". Abort.
Check bound_sound.
Goal True. statement "run_correct". Abort.
Check run_correct.
Goal True. statement "published_window32". Abort.
Check published_window32.
Goal True. statement "published_window64". Abort.
Check published_window64.
Goal True. statement "reduced_window32". Abort.
Check reduced_window32.
Goal True. statement "reduced_window64". Abort.
Check reduced_window64.
Goal True. statement "published_covered_binary32". Abort.
Check published_covered_binary32.
Goal True. statement "published_covered_binary64". Abort.
Check published_covered_binary64.
Goal True. statement "reduced_covered_binary32". Abort.
Check reduced_covered_binary32.
Goal True. statement "reduced_covered_binary64". Abort.
Check reduced_covered_binary64.
Goal True. statement "published_filter32_never_lies". Abort.
Check published_filter32_never_lies.
Goal True. statement "published_filter64_never_lies". Abort.
Check published_filter64_never_lies.
Goal True. statement "reduced_filter32_never_lies". Abort.
Check reduced_filter32_never_lies.
Goal True. statement "reduced_filter64_never_lies". Abort.
Check reduced_filter64_never_lies.
Goal True. statement "exported_published_thresholds". Abort.
Check exported_published_thresholds.
Goal True. statement "exported_reduced_thresholds". Abort.
Check exported_reduced_thresholds.
Goal True. statement "exported_window_binary32". Abort.
Check exported_window_binary32.
Goal True. statement "exported_window_binary64". Abort.
Check exported_window_binary64.
Goal True. statement "exported_filters_binary32". Abort.
Check exported_filters_binary32.
Goal True. statement "exported_filters_binary64". Abort.
Check exported_filters_binary64.
Goal True. statement "vertex_radius_bound". Abort.
Check vertex_radius_bound.
Goal True. statement "vertex_side_bound". Abort.
Check vertex_side_bound.
Goal True. statement "plane_radius_bound". Abort.
Check plane_radius_bound.
Goal True. statement "edge_radius_bound". Abort.
Check edge_radius_bound.
Goal True. statement "edge_side_bound". Abort.
Check edge_side_bound.
Goal True. statement "times_length_bound". Abort.
Check times_length_bound.
Goal True. statement "double_dot_near". Abort.
Check double_dot_near.
Goal True. statement "double_cross_near". Abort.
Check double_cross_near.
Goal True. statement "double_minus_near". Abort.
Check double_minus_near.
Goal True. statement "sign_of_leading". Abort.
Check sign_of_leading.
Goal True. statement "pair_minus_near". Abort.
Check pair_minus_near.
Goal True. statement "leading_near". Abort.
Check leading_near.
Goal True. statement "pair_minus_cancels". Abort.
Check pair_minus_cancels.
Goal True. statement "leading_is_a_double". Abort.
Check leading_is_a_double.
Goal True. statement "coarse_never_lies32". Abort.
Check coarse_never_lies32.
Goal True. statement "coarse_never_lies64". Abort.
Check coarse_never_lies64.
Goal True. statement "float_coarse_never_lies32". Abort.
Check float_coarse_never_lies32.
Goal True. statement "float_coarse_never_lies64". Abort.
Check float_coarse_never_lies64.
Goal True. statement "float_coarse_never_lies_open32". Abort.
Check float_coarse_never_lies_open32.
Goal True. statement "float_coarse_never_lies_open64". Abort.
Check float_coarse_never_lies_open64.
Goal True. statement "float_pair_never_lies32". Abort.
Check float_pair_never_lies32.
Goal True. statement "float_pair_never_lies64". Abort.
Check float_pair_never_lies64.
Goal True. statement "beyond_is_separated". Abort.
Check beyond_is_separated.
Goal True. statement "passed_over_is_separated". Abort.
Check passed_over_is_separated.
Goal True. statement "conservative_never_misses32". Abort.
Check conservative_never_misses32.
Goal True. statement "conservative_never_misses64". Abort.
Check conservative_never_misses64.
Goal True. statement "conservative_phantoms_shallow32". Abort.
Check conservative_phantoms_shallow32.
Goal True. statement "conservative_phantoms_shallow64". Abort.
Check conservative_phantoms_shallow64.
Goal True. statement "exported_margin_bounds". Abort.
Check exported_margin_bounds.
Goal True. statement "exported_coarse_bounds". Abort.
Check exported_coarse_bounds.
Goal True. statement "exported_conservative_bounds". Abort.
Check exported_conservative_bounds.
Goal True. statement "filters_decide". Abort.
Check filters_decide.
Goal True. statement "coarse_step_decides". Abort.
Check coarse_step_decides.

(* Definitions. *)
Goal True. statement "vec". Abort.
Print vec.
Goal True. statement "add". Abort.
Print add.
Goal True. statement "sub". Abort.
Print sub.
Goal True. statement "scale". Abort.
Print scale.
Goal True. statement "dot". Abort.
Print dot.
Goal True. statement "cross". Abort.
Print cross.
Goal True. statement "distance". Abort.
Print distance.
Goal True. statement "combination". Abort.
Print combination.
Goal True. statement "in_triangle". Abort.
Print in_triangle.
Goal True. statement "separated". Abort.
Print separated.
Goal True. statement "clear". Abort.
Print clear.
Goal True. statement "comparison". Abort.
Print comparison.
Goal True. statement "is_side". Abort.
Print is_side.
Goal True. statement "some_axis". Abort.
Print some_axis.
Goal True. statement "normal". Abort.
Print normal.
Goal True. statement "offset". Abort.
Print offset.
Goal True. statement "length2". Abort.
Print length2.
Goal True. statement "foot". Abort.
Print foot.
Goal True. statement "from_foot". Abort.
Print from_foot.
Goal True. statement "plane_sides". Abort.
Print plane_sides.
Goal True. statement "vertex_radius_sides". Abort.
Print vertex_radius_sides.
Goal True. statement "vertex_side_sides". Abort.
Print vertex_side_sides.
Goal True. statement "edge_radius_sides". Abort.
Print edge_radius_sides.
Goal True. statement "edge_side_sides". Abort.
Print edge_side_sides.
Goal True. statement "published". Abort.
Print published.
Goal True. statement "reduced_radius_sides". Abort.
Print reduced_radius_sides.
Goal True. statement "reduced_side_sides". Abort.
Print reduced_side_sides.
Goal True. statement "reduced". Abort.
Print reduced.
Goal True. statement "separated_open". Abort.
Print separated_open.
Goal True. statement "has_normal". Abort.
Print has_normal.
Goal True. statement "weak". Abort.
Print weak.
Goal True. statement "open_holds". Abort.
Print open_holds.
Goal True. statement "axis". Abort.
Print axis.
Goal True. statement "radius_of". Abort.
Print radius_of.
Goal True. statement "sides_hold". Abort.
Print sides_hold.
Goal True. statement "axis_holds". Abort.
Print axis_holds.
Goal True. statement "question". Abort.
Print question.
Goal True. statement "holds_for". Abort.
Print holds_for.
Goal True. statement "apart". Abort.
Print apart.
Goal True. statement "known". Abort.
Print known.
Goal True. statement "sound_known". Abort.
Print sound_known.
Goal True. statement "both_known". Abort.
Print both_known.
Goal True. statement "all_axes". Abort.
Print all_axes.
Goal True. statement "is_separated". Abort.
Print is_separated.
Goal True. statement "is_contact". Abort.
Print is_contact.
Goal True. statement "strict". Abort.
Print strict.
Goal True. statement "nonstrict". Abort.
Print nonstrict.
Goal True. statement "sat7_strict". Abort.
Print sat7_strict.
Goal True. statement "sat7". Abort.
Print sat7.
Goal True. statement "same_sign". Abort.
Print same_sign.
Goal True. statement "query". Abort.
Print query.
Goal True. statement "query_separated". Abort.
Print query_separated.
Goal True. statement "leaf". Abort.
Print leaf.
Goal True. statement "expression". Abort.
Print expression.
Goal True. statement "exact". Abort.
Print exact.
Goal True. statement "rounded". Abort.
Print rounded.
Goal True. statement "degree". Abort.
Print degree.
Goal True. statement "bounds". Abort.
Print bounds.
Goal True. statement "within". Abort.
Print within.
Goal True. statement "leaves". Abort.
Print RecordedIsProgram.leaves.
Goal True. statement "exact_leaves". Abort.
Print exact_leaves.
Goal True. statement "rounded_sides". Abort.
Print rounded_sides.
Goal True. statement "exact_sides". Abort.
Print exact_sides.
Goal True. statement "run_program". Abort.
Print run_program.
Goal True. statement "unbounded". Abort.
Print unbounded.
Goal True. statement "grid_point". Abort.
Print grid_point.
Goal True. statement "in_window". Abort.
Print in_window.
Goal True. statement "as_unbounded". Abort.
Print as_unbounded.
Goal True. statement "sides_as_unbounded". Abort.
Print sides_as_unbounded.
Goal True. statement "least_grid". Abort.
Print least_grid.
Goal True. statement "window_degree". Abort.
Print window_degree.
Goal True. statement "published_greatest32". Abort.
Print published_greatest32.
Goal True. statement "published_greatest64". Abort.
Print published_greatest64.
Goal True. statement "reduced_greatest32". Abort.
Print reduced_greatest32.
Goal True. statement "reduced_greatest64". Abort.
Print reduced_greatest64.
Goal True. statement "margin_error". Abort.
Print margin_error.
Goal True. statement "covered". Abort.
Print covered.
Goal True. statement "published_threshold". Abort.
Print published_threshold.
Goal True. statement "reduced_threshold". Abort.
Print reduced_threshold.
Goal True. statement "answer". Abort.
Print answer.
Goal True. statement "float_vec". Abort.
Print float_vec.
Goal True. statement "float_query". Abort.
Print float_query.
Goal True. statement "real_vec". Abort.
Print real_vec.
Goal True. statement "real_query". Abort.
Print real_query.
Goal True. statement "some_axis_b". Abort.
Print some_axis_b.
Goal True. statement "power". Abort.
Print power.
Goal True. statement "coordinates". Abort.
Print coordinates.
Goal True. statement "float_leaf". Abort.
Print float_leaf.
Goal True. statement "greater". Abort.
Print Filter.greater.
Goal True. statement "greatest". Abort.
Print greatest.
Goal True. statement "inside". Abort.
Print inside.
Goal True. statement "coefficient". Abort.
Print coefficient.
Goal True. statement "values". Abort.
Print Filter.values.
Goal True. statement "deep_values". Abort.
Print RecordedIsDeep.values.
Goal True. statement "limit". Abort.
Print limit.
Goal True. statement "margin". Abort.
Print margin.
Goal True. statement "compared_at". Abort.
Print compared_at.
Goal True. statement "compared". Abort.
Print compared.
Goal True. statement "certainly_greater". Abort.
Print certainly_greater.
Goal True. statement "certainly_less". Abort.
Print certainly_less.
Goal True. statement "filter". Abort.
Print filter.
Goal True. statement "least_binary32". Abort.
Print least_binary32.
Goal True. statement "greatest_binary32". Abort.
Print greatest_binary32.
Goal True. statement "least_binary64". Abort.
Print least_binary64.
Goal True. statement "greatest_binary64". Abort.
Print greatest_binary64.
Goal True. statement "published_filter32". Abort.
Print published_filter32.
Goal True. statement "published_filter64". Abort.
Print published_filter64.
Goal True. statement "reduced_filter32". Abort.
Print reduced_filter32.
Goal True. statement "reduced_filter64". Abort.
Print reduced_filter64.
Goal True. statement "published_compared32". Abort.
Print published_compared32.
Goal True. statement "published_compared64". Abort.
Print published_compared64.
Goal True. statement "reduced_compared32". Abort.
Print reduced_compared32.
Goal True. statement "reduced_compared64". Abort.
Print reduced_compared64.
Goal True. statement "never_lies". Abort.
Print never_lies.
Goal True. statement "all_filters". Abort.
Print all_filters.
Goal True. statement "rounds". Abort.
Print Lanes.rounds.
Goal True. statement "leaf_of". Abort.
Print leaf_of.
Goal True. statement "computed_dot". Abort.
Print computed_dot.
Goal True. statement "computed_difference". Abort.
Print computed_difference.
Goal True. statement "computed_cross". Abort.
Print computed_cross.
Goal True. statement "greatest_component". Abort.
Print greatest_component.
Goal True. statement "total". Abort.
Print total.
Goal True. statement "near_dot". Abort.
Print near_dot.
Goal True. statement "near_difference". Abort.
Print near_difference.
Goal True. statement "near_cross". Abort.
Print near_cross.
Goal True. statement "near_minus". Abort.
Print near_minus.
Goal True. statement "is_pair". Abort.
Print is_pair.
Goal True. statement "rounded_two_sum". Abort.
Print rounded_two_sum.
Goal True. statement "rounded_pair_minus". Abort.
Print rounded_pair_minus.
Goal True. statement "kept". Abort.
Print kept.
Goal True. statement "units". Abort.
Print units.
Goal True. statement "component_error". Abort.
Print component_error.
Goal True. statement "computed_normal". Abort.
Print computed_normal.
Goal True. statement "offset_error". Abort.
Print offset_error.
Goal True. statement "plane_bound". Abort.
Print plane_bound.
Goal True. statement "edge_radius_limit". Abort.
Print edge_radius_limit.
Goal True. statement "edge_side_limit". Abort.
Print edge_side_limit.
Goal True. statement "double_pair". Abort.
Print double_pair.
Goal True. statement "pair_value". Abort.
Print pair_value.
Goal True. statement "two_sum". Abort.
Print two_sum.
Goal True. statement "pair_minus". Abort.
Print pair_minus.
Goal True. statement "normalised". Abort.
Print normalised.
Goal True. statement "at_exponent". Abort.
Print at_exponent.
Goal True. statement "rounded_sub". Abort.
Print rounded_sub.
Goal True. statement "rounded_minus_product". Abort.
Print rounded_minus_product.
Goal True. statement "rounded_dot". Abort.
Print rounded_dot.
Goal True. statement "rounded_cross". Abort.
Print rounded_cross.
Goal True. statement "coarse_S". Abort.
Print coarse_S.
Goal True. statement "coarse_E". Abort.
Print coarse_E.
Goal True. statement "coarse_threshold". Abort.
Print coarse_threshold.
Goal True. statement "coarse_margin". Abort.
Print coarse_margin.
Goal True. statement "exact_margin". Abort.
Print exact_margin.
Goal True. statement "in_format". Abort.
Print in_format.
Goal True. statement "coarse_never_lies". Abort.
Print coarse_never_lies.
Goal True. statement "conservative_W". Abort.
Print conservative_W.
Goal True. statement "conservative_share". Abort.
Print conservative_share.
Goal True. statement "conservative_edge". Abort.
Print conservative_edge.
Goal True. statement "conservative_normal". Abort.
Print conservative_normal.
Goal True. statement "conservative_plane". Abort.
Print conservative_plane.
Goal True. statement "conservative_separated". Abort.
Print conservative_separated.
Goal True. statement "conservative_never_misses". Abort.
Print conservative_never_misses.
Goal True. statement "float_sub". Abort.
Print float_sub.
Goal True. statement "float_add_product". Abort.
Print float_add_product.
Goal True. statement "float_dot". Abort.
Print float_dot.
Goal True. statement "float_minus_product". Abort.
Print float_minus_product.
Goal True. statement "float_cross". Abort.
Print float_cross.
Goal True. statement "constant". Abort.
Print constant.
Goal True. statement "float_S". Abort.
Print float_S.
Goal True. statement "float_E". Abort.
Print float_E.
Goal True. statement "float_threshold". Abort.
Print float_threshold.
Goal True. statement "float_margin". Abort.
Print float_margin.
Goal True. statement "float_in_range". Abort.
Print float_in_range.
Goal True. statement "float_separated". Abort.
Print float_separated.
Goal True. statement "float_contact". Abort.
Print float_contact.
Goal True. statement "float_coarse_never_lies". Abort.
Print float_coarse_never_lies.
Goal True. statement "float_coarse_never_lies_open". Abort.
Print float_coarse_never_lies_open.
Goal True. statement "lane_axis_b". Abort.
Print lane_axis_b.
Goal True. statement "lane_separated". Abort.
Print lane_separated.
Goal True. statement "lane_contact". Abort.
Print lane_contact.
Goal True. statement "pair_separated". Abort.
Print pair_separated.
Goal True. statement "pair_contact". Abort.
Print pair_contact.
Goal True. statement "float_pair_never_lies". Abort.
Print float_pair_never_lies.
Goal True. statement "face". Abort.
Print face.
Goal True. statement "beyond_exactly". Abort.
Print beyond_exactly.
Goal True. statement "is_finite_vec". Abort.
Print is_finite_vec.
Goal True. statement "is_sphere". Abort.
Print is_sphere.
Goal True. statement "box_low". Abort.
Print box_low.
Goal True. statement "box_high". Abort.
Print box_high.
Goal True. statement "beyond". Abort.
Print Box.beyond.
Goal True. statement "coarse_steps". Abort.
Print coarse_steps.
Goal True. statement "phantom_depth". Abort.
Print phantom_depth.
Goal True. statement "query_size". Abort.
Print query_size.
Goal True. statement "conservative_phantoms_shallow". Abort.
Print conservative_phantoms_shallow.
Goal True. statement "recorded_coarse_margins32". Abort.
Check recorded_coarse_margins32.
Goal True. statement "recorded_coarse_margins64". Abort.
Check recorded_coarse_margins64.
Goal True. statement "recorded_coarse_is_proved32". Abort.
Check recorded_coarse_is_proved32.
Goal True. statement "recorded_coarse_is_proved64". Abort.
Check recorded_coarse_is_proved64.
Goal True. statement "recorded_pair_is_proved32". Abort.
Check recorded_pair_is_proved32.
Goal True. statement "recorded_pair_is_proved64". Abort.
Check recorded_pair_is_proved64.
Goal True. statement "recorded_coarse_known_is_proved". Abort.
Check recorded_coarse_known_is_proved.
Goal True. statement "coarse_known_is_sound64". Abort.
Check coarse_known_is_sound64.
Goal True. statement "float_conservative_is_right32". Abort.
Check float_conservative_is_right32.
Goal True. statement "float_conservative_is_right64". Abort.
Check float_conservative_is_right64.
Goal True. statement "inverse_power_is32". Abort.
Check inverse_power_is32.
Goal True. statement "inverse_power_is64". Abort.
Check inverse_power_is64.
Goal True. statement "order_gives_least". Abort.
Check order_gives_least.
Goal True. statement "conservative_step_decides". Abort.
Check conservative_step_decides.
Goal True. statement "recorded_conservative32". Abort.
Check recorded_conservative32.
Goal True. statement "recorded_conservative64". Abort.
Check recorded_conservative64.
Goal True. statement "recorded_conservative_is_right32". Abort.
Check recorded_conservative_is_right32.
Goal True. statement "recorded_conservative_is_right64". Abort.
Check recorded_conservative_is_right64.
Goal True. statement "exact_values_fit". Abort.
Check exact_values_fit.
Goal True. statement "recorded_margins". Abort.
Check recorded_margins.
Goal True. statement "exact_step_decides". Abort.
Check exact_step_decides.
Goal True. statement "negligible_radius". Abort.
Check negligible_radius.
Goal True. statement "certified_is_exact_within_126_bits". Abort.
Check certified_is_exact_within_126_bits.
Goal True. statement "exact_only_is_exact_within_126_bits". Abort.
Check exact_only_is_exact_within_126_bits.
Goal True. statement "machine". Abort.
Print machine.
Goal True. statement "float_machine". Abort.
Print float_machine.
Goal True. statement "real_machine". Abort.
Print real_machine.
Goal True. statement "is_least". Abort.
Print is_least.
Goal True. statement "is_greatest". Abort.
Print is_greatest.
Goal True. statement "recorded_order". Abort.
Print recorded_order.
Goal True. statement "coarse_numbers". Abort.
Print coarse_numbers.
Goal True. statement "in_deep_range". Abort.
Print in_deep_range.
Goal True. statement "side_of". Abort.
Print side_of.
Goal True. statement "coarse_known". Abort.
Print coarse_known.
Goal True. statement "known_list". Abort.
Print known_list.
Goal True. statement "machine_vec". Abort.
Print machine_vec.
Goal True. statement "program_sub". Abort.
Print program_sub.
Goal True. statement "program_product". Abort.
Print program_product.
Goal True. statement "program_cross". Abort.
Print program_cross.
Goal True. statement "program_least". Abort.
Print program_least.
Goal True. statement "program_W". Abort.
Print program_W.
Goal True. statement "program_error". Abort.
Print program_error.
Goal True. statement "program_square_error". Abort.
Print program_square_error.
Goal True. statement "program_passes". Abort.
Print program_passes.
Goal True. statement "program_share". Abort.
Print program_share.
Goal True. statement "program_mix". Abort.
Print program_mix.
Goal True. statement "program_edge". Abort.
Print program_edge.
Goal True. statement "program_normal". Abort.
Print program_normal.
Goal True. statement "program_plane". Abort.
Print program_plane.
Goal True. statement "program_squares". Abort.
Print program_squares.
Goal True. statement "program_known". Abort.
Print program_known.
Goal True. statement "program_separated". Abort.
Print program_separated.
Goal True. statement "conservative_answers". Abort.
Print conservative_answers.
Goal True. statement "on_floats". Abort.
Print on_floats.
Goal True. statement "float_answers". Abort.
Print float_answers.
Goal True. statement "conservative_is_right". Abort.
Print conservative_is_right.
Goal True. statement "is_inverse_power". Abort.
Print is_inverse_power.
Goal True. statement "inverse_power_of_bits". Abort.
Print inverse_power_of_bits.
Goal True. statement "inverse_power32". Abort.
Print inverse_power32.
Goal True. statement "inverse_power64". Abort.
Print inverse_power64.
Goal True. statement "promised". Abort.
Print promised.
Goal True. statement "least_by_order". Abort.
Print least_by_order.
Goal True. statement "greatest_by_order". Abort.
Print greatest_by_order.
Goal True. statement "conservative_steps". Abort.
Print conservative_steps.
Goal True. statement "instruction". Abort.
Print instruction.
Goal True. statement "run_program". Abort.
Print run_program.
Goal True. statement "exact_program". Abort.
Print exact_program.
Goal True. statement "exact_results". Abort.
Print exact_results.
Goal True. statement "exact_margins". Abort.
Print exact_margins.
Goal True. statement "real_margins". Abort.
Print real_margins.
Goal True. statement "bits_of". Abort.
Print bits_of.
Goal True. statement "words_of". Abort.
Print words_of.
Goal True. statement "radius_beyond". Abort.
Print radius_beyond.
Goal True. statement "is_zero". Abort.
Print ExactStep.is_zero.
Goal True. statement "double_is_zero". Abort.
Print Pairs.is_zero.
Goal True. statement "vertex_separates". Abort.
Print vertex_separates.
Goal True. statement "plane_separates". Abort.
Print plane_separates.
Goal True. statement "edge_separates". Abort.
Print edge_separates.
Goal True. statement "exact_separates". Abort.
Print exact_separates.
Goal True. statement "grid_point". Abort.
Print grid_point.
Goal True. statement "certified_is_exact". Abort.
Print certified_is_exact.
Goal True. statement "exact_only_is_exact". Abort.
Print exact_only_is_exact.
Goal True. statement "recorded_fine_margins". Abort.
Check recorded_fine_margins.
Goal True. statement "fine_is_near". Abort.
Check fine_is_near.
Goal True. statement "fine_margin". Abort.
Print fine_margin.
Goal True. statement "fine_numbers". Abort.
Print fine_numbers.
Goal True. statement "margin_exactly". Abort.
Print margin_exactly.
Goal True. statement "recorded_deep_constants". Abort.
Check recorded_deep_constants.
Goal True. statement "of_pairs". Abort.
Print of_pairs.
Goal True. statement "least_size". Abort.
Print least_size.
Goal True. statement "greatest_size". Abort.
Print RecordedIsDeep.greatest_size.
Goal True. statement "greatest_bound". Abort.
Print Expression.greatest_size.
Goal True. statement "residue_limit". Abort.
Print residue_limit.
Goal True. statement "split_factor". Abort.
Print split_factor.
