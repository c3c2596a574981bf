// Situations and advice of more than one test.
#pragma once

#include "reports/certificate/findings/situations.h"

namespace axiscert {

inline constexpr std::string_view mend_units =
    "Bring the scene to a unit in which the kernel is right: `range_window` and "
    "`absolute_threshold` of the diagnosis say which.";
inline constexpr std::string_view shrink_small_integers =
    "A case is wrong or left out, or an epsilon is larger than the gap: `axiscert shrink` a "
    "witness.";
inline constexpr Situation of_corpus = {"known", "queries of the corpus, which were hard once or are faults of engines",
                                        "`axiscert corpus list` says what each is about.", "docs/corpus.md#the-corpus",
                                        "corpus"};
constexpr Situation of_own_queries(std::string_view meaning, std::string_view section) {
  return {"own", meaning, "`axiscert check` a witness.", section, ""};
}

}  // namespace axiscert
