// The powers of two times which a kernel answers as at scale 1.
#include <cmath>

#include "fuzz/diagnosis/other_units.h"
#include "fuzz/diagnosis/probes.h"

namespace axiscert::diagnosis {

namespace {

constexpr std::size_t window_count = 64;

template <class Real>
class WindowScan {
 public:
  explicit WindowScan(Subject<Real>& subject)
      : subject_(subject), clear_(clear_queries<Real>(subject.kernel(), window_count)) {
    for (const auto& query : clear_) base_.push_back(query.numbers);
    at_one_ = subject.ask(base_);
  }
  std::size_t size() const { return base_.size(); }
  // Both verdicts occur, and all are decided: otherwise nothing can change, or nothing is known.
  bool tells() const {
    return std::ranges::count(at_one_, Verdict::contact) != 0 && std::ranges::count(at_one_, Verdict::separated) != 0 &&
           std::ranges::all_of(at_one_, is_decided);
  }
  // The last exponent from 0 towards `end` with the same answers, and a query that differs at the next.
  int last(int end, std::optional<DiagnosisWitness>& beyond) {
    const int step = end > 0 ? 1 : -1;
    for (int m = step; m != end + step; m += step) {
      const Queries<Real> scaled = times(m);
      const auto said = subject_.ask(scaled);
      for (std::size_t i = 0; i < said.size(); ++i) {
        if (said[i] == at_one_[i]) continue;
        beyond =
            subject_.witness(scaled[i], said[i], fmt::format("times 2^{} the answer was {}", -m, name(at_one_[i])));
        return m - step;
      }
    }
    return end;
  }

 private:
  Queries<Real> times(int exponent) const {
    Queries<Real> scaled;
    for (const Numbers<Real>& base : base_) scaled.push_back(in_unit(subject_.kernel(), base, exponent));
    return scaled;
  }

  Subject<Real>& subject_;
  std::vector<ClearQuery<Real>> clear_;
  Queries<Real> base_;
  std::vector<Verdict> at_one_;
};

}  // namespace

template <class Real>
ProbeFinding range_window(Subject<Real>& subject) {
  WindowScan<Real> scan(subject);
  if (scan.size() == 0)
    return unasked("This predicate has no queries here that are known to be far from every boundary.");
  if (!scan.tells())
    return undecided("At scale 1 it does not give both answers to queries that are far from touching.");
  const ExponentWindow scanned = scenes_of<Real>(subject.predicate()).scanned(precision_of<Real>);
  std::optional<DiagnosisWitness> above, below;
  const int high = scan.last(scanned.high, above), low = scan.last(scanned.low, below);
  const Json measured = {{"low", low}, {"high", high}, {"scanned_low", scanned.low}, {"scanned_high", scanned.high}};
  std::vector<DiagnosisWitness> witnesses;
  for (auto* witness : {&below, &above}) {
    if (*witness) witnesses.push_back(**witness);
  }
  if (low == scanned.low && high == scanned.high) {
    return decided(Window::whole,
                   fmt::format("Times every power of two from 2^{} to 2^{} it answers {} clear queries as "
                               "at scale 1.",
                               low, high, scan.size()),
                   {}, measured);
  }
  return decided(
      Window::limited,
      fmt::format("It answers {} clear queries as at scale 1 from 2^{} to 2^{} ({:.0e} to {:.0e} in the "
                  "queries' unit); 2^{} to 2^{} were asked.",
                  scan.size(), low, high, std::ldexp(1.0, low), std::ldexp(1.0, high), scanned.low, scanned.high),
      std::move(witnesses), measured);
}
template ProbeFinding range_window(Subject<float>&);
template ProbeFinding range_window(Subject<double>&);

}  // namespace axiscert::diagnosis
