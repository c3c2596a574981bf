// Whether the kernel answers as if a shape or a motion were a little larger, or smaller, than it is.
#include "fuzz/text/json_form.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/confirm/slack.h"

namespace axiscert::diagnosis {

template <class Real>
ProbeFinding slack(Subject<Real>& subject) {
  const auto slacks = slacks_of(subject.kernel(), precision_of<Real>, subject.seed(), subject.target());
  if (!slacks) return unasked("This predicate has no scenes in which the exact answer turns at a known length.");
  subject.count(slacks->answers);
  const Json measured = {{"bracketed", slacks->bracketed},
                         {"least_relative", json_of(least_relative(*slacks))},
                         {"blind", json_of(slacks->blind)},
                         {"found", json_of(slacks->found)}};
  if (slacks->found.empty()) {
    const SlackLook* const off = most_off(*slacks, SlackKind::relative);
    if (off != nullptr) return undecided("No one size: " + off_text(*off, SlackKind::relative) + ".", measured);
    if (!least_relative(*slacks)) return undecided(no_slack_text(*slacks) + ".", measured);
    if (!slacks->blind.empty()) return undecided("Nothing is known: " + blind_text(*slacks) + ".", measured);
  }
  if (slacks->found.empty()) return decided(Slack::none_found, "It has " + no_slack_text(*slacks) + ".", {}, measured);
  std::vector<DiagnosisWitness> witnesses;
  std::string text;
  for (const SlackRecord& one : slacks->found) {
    if (witnesses.size() == 3) break;
    text += (text.empty() ? "It has " : "; ") + slack_text(one);
    witnesses.push_back({one.witness, std::string(name(one.said)),
                         std::string(name(one.said == Verdict::contact ? Verdict::separated : Verdict::contact)),
                         "half way between the exact turn of the answer and its own"});
  }
  const bool is_early = slacks->found.front().side == SlackSide::early;
  return decided(is_early ? Slack::early : Slack::late, text + ".", std::move(witnesses), measured);
}
template ProbeFinding slack(Subject<float>&);
template ProbeFinding slack(Subject<double>&);

}  // namespace axiscert::diagnosis
