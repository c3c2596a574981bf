// For tests: what levels, ratchets and comparisons say of a record whose JSON a test edited.
#pragma once

#include <algorithm>

#include "fuzz/text/json_form.h"
#include "reports/comparison/comparison_report.h"
#include "reports/gates/ratchet.h"
#include "reports/gates/requirement.h"
#include "reports/testing/test_run.h"

namespace axiscert {

// The record, whose counts may contradict each other. What its other members say already need not be edited.
inline Record edited(Json json) {
  for (Json& kernel : json["kernels"]) {
    for (Json& family : kernel["families"]) {
      Json& verdict = family["verdict"];
      verdict["deepest"] =
          std::max(verdict["deepest_false_separation"].get<double>(), verdict["deepest_false_contact"].get<double>());
      verdict["decided"] =
          verdict["decided_contacts"].get<std::uint64_t>() + verdict["decided_separations"].get<std::uint64_t>();
      if (verdict["decided"] == 0) verdict["links"] = verdict["masked_links"] = nullptr;
      std::uint64_t answered = family["trials"];
      for (const Json& apart :
           {family["truth"]["invalid"], verdict["undecided"], verdict["invalid"], verdict["unanswered"]})
        answered -= std::min(answered, apart.get<std::uint64_t>());
      verdict["decided_touching"] = std::min(answered, verdict["decided_touching"].get<std::uint64_t>());
      if (verdict["decided_touching"] == 0) verdict["touching_flips"] = verdict["touching_links"] = nullptr;
      for (const char* level : {"axes", "comparisons"}) {
        if (family[level].is_null()) continue;
        for (Json& tally : family[level]) tally["smallest_passing_tolerance"] = tally["max_error_u"];
      }
    }
  }
  return read_as<Record>(json);
}

// A crash of `published` on one query of a family.
inline Json crash_on(const std::string& family) {
  return {{"kernel", "published"}, {"precision", "binary32"}, {"family", family}, {"kind", "crash"}, {"count", 1},
          {"detail", "signal 11"}, {"address", "1:f:1"}};
}
// A kernel that could not be loaded.
inline Json load_fault_of(const std::string& kernel, const std::string& detail) {
  return {{"kernel", kernel}, {"precision", nullptr}, {"family", nullptr}, {"kind", "load"},
          {"count", 1},       {"detail", detail},     {"address", nullptr}};
}

inline std::vector<LevelOutcome> outcomes_of(const Json& record) { return outcomes_of(edited(record)); }
inline std::vector<LevelOutcome> outcomes_at(const Json& record, const std::string& level) {
  return outcomes_at(edited(record), level);
}
inline std::vector<Failure> unmet(const Json& record, const std::string& level) { return unmet(edited(record), level); }
inline std::vector<std::string> unjudged(const Json& record) { return unjudged(edited(record)); }

inline std::string ratchet_text(const Json& record) { return ratchet_text(edited(record)); }
inline RatchetOutcome hold_against(const Ratchet& ratchet, const Json& record, const std::string& today) {
  return hold_against(ratchet, edited(record), today);
}

inline RunComparison compare_records(const Json& before, const Json& after, std::vector<ReplayedQuery> replayed = {},
                                     const std::vector<std::string>& allowed = {}) {
  return compare_records(edited(before), edited(after), std::move(replayed), allowed);
}
inline std::string markdown_of(const Json& before, const Json& after, const RunComparison& comparison) {
  const Record then = edited(before), now = edited(after);
  return comparison_markdown({then, now, "old", "new"}, comparison);
}
inline Json data_of(const Json& before, const Json& after, const RunComparison& comparison) {
  const Record then = edited(before), now = edited(after);
  return comparison_json({then, now, "old", "new"}, comparison);
}

}  // namespace axiscert
