// A situation: what the family of a query says of a wrong answer, where nothing but the verdict is seen.
#pragma once

#include <span>
#include <string_view>

namespace axiscert {

struct Situation {
  std::string_view name;     // stable, for files: "parallel"
  std::string_view meaning;  // of its queries: "motions parallel to the face or to an edge"
  std::string_view advice;   // to whoever has to use the kernel, a sentence
  std::string_view section;  // of the documents
};

// Those of a predicate, every family of which names one.
struct Situations {
  std::span<const Situation* const> of_families;  // the most everyday ones first
  Situation own;                                  // of the queries of meshes and files
};

constexpr Situation of_own_queries(std::string_view meaning, std::string_view section) {
  return {"own", meaning, "`axiscert check` a witness.", section};
}
inline constexpr Situation of_corpus = {"known", "queries of the corpus, which were hard once or are faults of engines",
                                        "`axiscert corpus list` says what each is about.", "docs/corpus.md#the-corpus"};

// Advice of more than one predicate.
inline constexpr std::string_view mend_units =
    "Bring the scene to a unit in which the kernel is right: `range_window` and "
    "`absolute_threshold` of the diagnosis say which.";
inline constexpr std::string_view shrink_small_integers =
    "A case is wrong or left out, or an epsilon is larger than the gap: `axiscert shrink` a "
    "witness.";

}  // namespace axiscert
