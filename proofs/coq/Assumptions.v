(* Prints the assumptions of each main theorem; Assumptions.expected has the text that it has to print. *)
From Axiscert Require Import Exact Reduced OpenSphere Known Scaled RecordedIsSat7 RecordedIsProgram Expression Run Windows Thresholds
  Filter Filters Margins Pairs CertifiedStep CoarseFloat OpenCoarse PairStep Box ConservativeStep PhantomStep ConservativeFloat InversePower Exported Decides
  CoarseKnown RecordedIsCertified FineStep RecordedIsDeep RecordedIsConservative ExactStep Negligible CertifiedIsExact.

Tactic Notation "theorem" string(name) := idtac "==" name.
Goal True. theorem "sat7_exact". Abort.
Print Assumptions sat7_exact.
Goal True. theorem "sat7_exact_strict". Abort.
Print Assumptions sat7_exact_strict.
Goal True. theorem "sat7_strict_sound". Abort.
Print Assumptions sat7_strict_sound.
Goal True. theorem "strict_wrong_for_repeated_vertex". Abort.
Print Assumptions strict_wrong_for_repeated_vertex.
Goal True. theorem "strict_wrong_for_collinear". Abort.
Print Assumptions strict_wrong_for_collinear.
Goal True. theorem "reduced_equiv". Abort.
Print Assumptions reduced_equiv.
Goal True. theorem "reduced_exact". Abort.
Print Assumptions reduced_exact.
Goal True. theorem "open_exact". Abort.
Print Assumptions open_exact.
Goal True. theorem "open_contact". Abort.
Print Assumptions open_contact.
Goal True. theorem "open_left_side". Abort.
Print Assumptions open_left_side.
Goal True. theorem "either_exact". Abort.
Print Assumptions either_exact.
Goal True. theorem "sign_decides". Abort.
Print Assumptions sign_decides.
Goal True. theorem "both_are_sound". Abort.
Print Assumptions both_are_sound.
Goal True. theorem "known_is_right". Abort.
Print Assumptions known_is_right.
Goal True. theorem "last_step_decides". Abort.
Print Assumptions last_step_decides.
Goal True. theorem "scaled_is_same". Abort.
Print Assumptions scaled_is_same.
Goal True. theorem "recorded_published_is_sat7". Abort.
Print Assumptions recorded_published_is_sat7.
Goal True. theorem "recorded_reduced_is_sat7". Abort.
Print Assumptions recorded_reduced_is_sat7.
Goal True. theorem "published_float_program". Abort.
Print Assumptions published_float_program.
Goal True. theorem "published_fma_program". Abort.
Print Assumptions published_fma_program.
Goal True. theorem "reduced_float_program". Abort.
Print Assumptions reduced_float_program.
Goal True. theorem "reduced_fma_program". Abort.
Print Assumptions reduced_fma_program.
Goal True. theorem "bound_sound". Abort.
Print Assumptions bound_sound.
Goal True. theorem "run_correct". Abort.
Print Assumptions run_correct.
Goal True. theorem "published_window32". Abort.
Print Assumptions published_window32.
Goal True. theorem "published_window64". Abort.
Print Assumptions published_window64.
Goal True. theorem "reduced_window32". Abort.
Print Assumptions reduced_window32.
Goal True. theorem "reduced_window64". Abort.
Print Assumptions reduced_window64.
Goal True. theorem "published_covered_binary32". Abort.
Print Assumptions published_covered_binary32.
Goal True. theorem "published_covered_binary64". Abort.
Print Assumptions published_covered_binary64.
Goal True. theorem "reduced_covered_binary32". Abort.
Print Assumptions reduced_covered_binary32.
Goal True. theorem "reduced_covered_binary64". Abort.
Print Assumptions reduced_covered_binary64.
Goal True. theorem "published_filter32_never_lies". Abort.
Print Assumptions published_filter32_never_lies.
Goal True. theorem "published_filter64_never_lies". Abort.
Print Assumptions published_filter64_never_lies.
Goal True. theorem "reduced_filter32_never_lies". Abort.
Print Assumptions reduced_filter32_never_lies.
Goal True. theorem "reduced_filter64_never_lies". Abort.
Print Assumptions reduced_filter64_never_lies.
Goal True. theorem "exported_published_thresholds". Abort.
Print Assumptions exported_published_thresholds.
Goal True. theorem "exported_reduced_thresholds". Abort.
Print Assumptions exported_reduced_thresholds.
Goal True. theorem "exported_window_binary32". Abort.
Print Assumptions exported_window_binary32.
Goal True. theorem "exported_window_binary64". Abort.
Print Assumptions exported_window_binary64.
Goal True. theorem "exported_filters_binary32". Abort.
Print Assumptions exported_filters_binary32.
Goal True. theorem "exported_filters_binary64". Abort.
Print Assumptions exported_filters_binary64.
Goal True. theorem "vertex_radius_bound". Abort.
Print Assumptions vertex_radius_bound.
Goal True. theorem "vertex_side_bound". Abort.
Print Assumptions vertex_side_bound.
Goal True. theorem "plane_radius_bound". Abort.
Print Assumptions plane_radius_bound.
Goal True. theorem "edge_radius_bound". Abort.
Print Assumptions edge_radius_bound.
Goal True. theorem "edge_side_bound". Abort.
Print Assumptions edge_side_bound.
Goal True. theorem "times_length_bound". Abort.
Print Assumptions times_length_bound.
Goal True. theorem "double_dot_near". Abort.
Print Assumptions double_dot_near.
Goal True. theorem "double_cross_near". Abort.
Print Assumptions double_cross_near.
Goal True. theorem "double_minus_near". Abort.
Print Assumptions double_minus_near.
Goal True. theorem "sign_of_leading". Abort.
Print Assumptions sign_of_leading.
Goal True. theorem "pair_minus_near". Abort.
Print Assumptions pair_minus_near.
Goal True. theorem "leading_near". Abort.
Print Assumptions leading_near.
Goal True. theorem "pair_minus_cancels". Abort.
Print Assumptions pair_minus_cancels.
Goal True. theorem "leading_is_a_double". Abort.
Print Assumptions leading_is_a_double.
Goal True. theorem "coarse_never_lies32". Abort.
Print Assumptions coarse_never_lies32.
Goal True. theorem "coarse_never_lies64". Abort.
Print Assumptions coarse_never_lies64.
Goal True. theorem "float_coarse_never_lies32". Abort.
Print Assumptions float_coarse_never_lies32.
Goal True. theorem "float_coarse_never_lies64". Abort.
Print Assumptions float_coarse_never_lies64.
Goal True. theorem "float_coarse_never_lies_open32". Abort.
Print Assumptions float_coarse_never_lies_open32.
Goal True. theorem "float_coarse_never_lies_open64". Abort.
Print Assumptions float_coarse_never_lies_open64.
Goal True. theorem "float_pair_never_lies32". Abort.
Print Assumptions float_pair_never_lies32.
Goal True. theorem "float_pair_never_lies64". Abort.
Print Assumptions float_pair_never_lies64.
Goal True. theorem "beyond_is_separated". Abort.
Print Assumptions beyond_is_separated.
Goal True. theorem "passed_over_is_separated". Abort.
Print Assumptions passed_over_is_separated.
Goal True. theorem "conservative_never_misses32". Abort.
Print Assumptions conservative_never_misses32.
Goal True. theorem "conservative_never_misses64". Abort.
Print Assumptions conservative_never_misses64.
Goal True. theorem "conservative_phantoms_shallow32". Abort.
Print Assumptions conservative_phantoms_shallow32.
Goal True. theorem "conservative_phantoms_shallow64". Abort.
Print Assumptions conservative_phantoms_shallow64.
Goal True. theorem "exported_margin_bounds". Abort.
Print Assumptions exported_margin_bounds.
Goal True. theorem "exported_coarse_bounds". Abort.
Print Assumptions exported_coarse_bounds.
Goal True. theorem "exported_conservative_bounds". Abort.
Print Assumptions exported_conservative_bounds.
Goal True. theorem "filters_decide". Abort.
Print Assumptions filters_decide.
Goal True. theorem "coarse_step_decides". Abort.
Print Assumptions coarse_step_decides.
Goal True. theorem "coarse_known_is_sound64". Abort.
Print Assumptions coarse_known_is_sound64.
Goal True. theorem "recorded_coarse_margins32". Abort.
Print Assumptions recorded_coarse_margins32.
Goal True. theorem "recorded_coarse_margins64". Abort.
Print Assumptions recorded_coarse_margins64.
Goal True. theorem "recorded_coarse_is_proved32". Abort.
Print Assumptions recorded_coarse_is_proved32.
Goal True. theorem "recorded_coarse_is_proved64". Abort.
Print Assumptions recorded_coarse_is_proved64.
Goal True. theorem "recorded_coarse_known_is_proved". Abort.
Print Assumptions recorded_coarse_known_is_proved.
Goal True. theorem "recorded_pair_is_proved32". Abort.
Print Assumptions recorded_pair_is_proved32.
Goal True. theorem "recorded_pair_is_proved64". Abort.
Print Assumptions recorded_pair_is_proved64.
Goal True. theorem "fine_is_near". Abort.
Print Assumptions fine_is_near.
Goal True. theorem "recorded_fine_margins". Abort.
Print Assumptions recorded_fine_margins.
Goal True. theorem "recorded_deep_constants". Abort.
Print Assumptions recorded_deep_constants.
Goal True. theorem "float_conservative_is_right32". Abort.
Print Assumptions float_conservative_is_right32.
Goal True. theorem "float_conservative_is_right64". Abort.
Print Assumptions float_conservative_is_right64.
Goal True. theorem "inverse_power_is32". Abort.
Print Assumptions inverse_power_is32.
Goal True. theorem "inverse_power_is64". Abort.
Print Assumptions inverse_power_is64.
Goal True. theorem "order_gives_least". Abort.
Print Assumptions order_gives_least.
Goal True. theorem "conservative_step_decides". Abort.
Print Assumptions conservative_step_decides.
Goal True. theorem "recorded_conservative32". Abort.
Print Assumptions recorded_conservative32.
Goal True. theorem "recorded_conservative64". Abort.
Print Assumptions recorded_conservative64.
Goal True. theorem "recorded_conservative_is_right32". Abort.
Print Assumptions recorded_conservative_is_right32.
Goal True. theorem "recorded_conservative_is_right64". Abort.
Print Assumptions recorded_conservative_is_right64.
Goal True. theorem "exact_values_fit". Abort.
Print Assumptions exact_values_fit.
Goal True. theorem "recorded_margins". Abort.
Print Assumptions recorded_margins.
Goal True. theorem "exact_step_decides". Abort.
Print Assumptions exact_step_decides.
Goal True. theorem "negligible_radius". Abort.
Print Assumptions negligible_radius.
Goal True. theorem "certified_is_exact_within_126_bits". Abort.
Print Assumptions certified_is_exact_within_126_bits.
Goal True. theorem "exact_only_is_exact_within_126_bits". Abort.
Print Assumptions exact_only_is_exact_within_126_bits.
