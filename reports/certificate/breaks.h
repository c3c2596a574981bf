// What breaks of a kernel: the situations (fuzz/queries/family.h) in which it is wrong, and the fault that matters
// first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/queries/family.h"
#include "fuzz/record/record.h"
#include "reports/certificate/certificate_data.h"

namespace axiscert {
// A depth, relative to the scene, from which on roundings near touching are not to blame.
inline constexpr double visible_depth = 0.001;

// The wrong verdicts of a kernel in one situation and precision.
struct WrongVerdicts {
  const Situation* situation = nullptr;
  Precision precision = Precision::binary32;
  std::uint64_t missed = 0, phantom = 0;
  double deepest_missed = 0, deepest_phantom = 0;
  std::vector<std::string> families = {};  // with a wrong verdict, the deepest first

  std::uint64_t count(bool is_missed) const { return is_missed ? missed : phantom; }
  double deepest(bool is_missed) const { return is_missed ? deepest_missed : deepest_phantom; }
};

// The situations in which a kernel is wrong, an entry for each precision, the most everyday ones first, queries of no
// family last.
std::vector<WrongVerdicts> wrong_situations(const Record& record, const std::string& kernel);

// The entry of these that breaks first: the most everyday one with missed contacts of a visible depth, else with such
// phantoms, else that with the deepest missed contact, or phantom. Null where there is none. `missed` says which it is.
const WrongVerdicts* first_situation(const std::vector<WrongVerdicts>& situations, bool& missed);

// The fault of a kernel that matters first, and what to do about it; and the witnesses to paste.

// What breaks by the traits of the queries has this as its cause.
inline constexpr std::string_view cause_of_traits = "traits";

// The worst of a record about a kernel: a finding, else the class of queries within which it is wrong, else the cause
// of its missed contacts that goes deepest, else that of its phantom contacts; of a kernel of another predicate that
// shows its verdict alone the situation that breaks first.
std::optional<BreakStatement> what_breaks_first(const Record& record, const std::string& kernel);

// The situations in which it is wrong.
std::vector<SituationStatement> where_it_is_wrong(const Record& record, const std::string& kernel);

// The sections of the documents to which the advice of causes points.
std::vector<std::string_view> advised_sections();

// At most three wrong verdicts, the deepest of different families first.
std::vector<CertificateWitness> worst_of_certificate(const Record& record, const std::string& kernel);

}  // namespace axiscert
