// Known witnesses, evaluated again by the kernels of this build and by all oracles.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/record.h"
#include "kernel/base/enums.h"

namespace axiscert {

enum class ReplayOutcome {
  as_before,   // the same flips, with the same broken links; of a reported contact the same faults
  mended,      // flips or faults before; none now, and the verdict is the right one
  changed,     // others than before
  no_verdict,  // undecided now, or where the verdict was wrong, invalid or without an answer; it was none of these
  wrong_now,   // the verdict was right, and is wrong, invalid, missing or declined without leave now; or a time late or
               // none, or a feature wrong, that was not
  not_promised,  // the kernel promised to answer it, and does so no more
  not_replayed   // this build lacks the kernel, the plug-in is not trusted, or the answers came through a pipe
};
template <>
inline constexpr std::size_t enum_count<ReplayOutcome> = 7;
inline constexpr EnumArray<ReplayOutcome, std::string_view> replay_names = {
    "as before", "mended", "changed", "no verdict now", "wrong now", "no longer promised", "not replayed"};
constexpr std::string_view name(ReplayOutcome outcome) { return replay_names[outcome]; }

struct ReplayedQuery {
  std::string id, kernel, precision, family;
  ReplayOutcome outcome;
  std::string note;  // why it was not replayed, or is not promised; otherwise the answer's faults now
  bool is_alarm() const { return outcome == ReplayOutcome::wrong_now || outcome == ReplayOutcome::not_promised; }
  AXISCERT_FIELDS(ReplayedQuery, AXISCERT_FIELD(id, "Its id in OLD."), AXISCERT_FIELD(kernel, "Its id."),
                  AXISCERT_FIELD(precision, "The precision."), AXISCERT_FIELD(family, "Its family."),
                  AXISCERT_FIELD(outcome, "What the kernel does now."),
                  AXISCERT_FIELD(note,
                                 "The faults of the answer now, what is not promised, or why it was not evaluated."))
};

// The plug-ins that may be loaded: by the id that a record has, "plugin:PATH", the id of the one to load for it.
using TrustedPlugins = std::map<std::string, std::string>;

// Evaluates every witness of the record, in its order. A plug-in is loaded only where `trusted` has its id: a record
// that came by mail must not choose what code runs here. Throws OracleDisagreement.
std::vector<ReplayedQuery> replay_witnesses(const Record& record, std::string_view target,
                                            const TrustedPlugins& trusted = {});

}  // namespace axiscert
