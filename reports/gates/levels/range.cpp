// range: nor by range.
#include <fmt/format.h>

#include "reports/gates/levels/logic.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string range_sentence(const AskedLevel&) {
  return "no wrong verdict but by rounding: the formulae are right (specification), so is the code that computes them "
         "(implementation), and nothing over- or underflows into a wrong verdict (range). A kernel that claims no "
         "formulae, or has its own way to evaluate them, has no wrong verdict, since none can be told to be of "
         "rounding";
}

LevelFindings judge_range(const AskedLevel&, const Subject& subject) {
  LevelFindings found = logic_findings(subject);
  if (subject.basis() == Subject::Basis::reference) {
    for (const auto& [family, result] : subject.families()) {
      subject.add_link(found.failures, family, Link::range, result.verdict.links[Link::range]);
    }
    found.leaves_out = "rounding, and queries that these families do not make";
    return found;
  }
  if (!found.not_checked.empty()) return found;
  const std::string wrong = thousands(subject.wrong_verdicts());
  if (subject.wrong_verdicts() == 0) {
    found.unseen.clear();
    for (const auto& [family, result] : subject.families()) found.families[family] = subject.whole_look(result);
    found.covers = fmt::format("{} queries of {}: no verdict is wrong, so none is by range",
                               thousands(subject.decided()), subject.list_of_families());
    found.leaves_out = "queries that these families do not make";
  } else if (subject.basis() == Subject::Basis::verdicts) {
    found.not_checked = fmt::format(
        "the kernel shows verdicts alone: a wrong verdict ({} of them) cannot be told to be of range or of rounding",
        wrong);
  } else {
    found.not_checked = fmt::format(
        "the kernel evaluates its formulae in its own way: a wrong verdict ({} of them) cannot be told to be of range "
        "or of rounding",
        wrong);
  }
  return found;
}

}  // namespace

extern const GateLevel range_level = {.usage = "range",
                                      .meaning = "no wrong verdict but by rounding",
                                      .check = accept_no_argument,
                                      .sentence = range_sentence,
                                      .judge = judge_range,
                                      .is_about_causes = true};

}  // namespace axiscert
