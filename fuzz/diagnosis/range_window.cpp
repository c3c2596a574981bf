// The powers of two times which a kernel answers as at scale 1.
#include "fuzz/diagnosis/beside_runs.h"

#include <algorithm>
#include <cmath>

#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/diagnosis/other_units.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/text/json.h"

namespace axiscert {
namespace diagnosis {
namespace {

constexpr std::size_t window_count = 64;
// Formulae of a greater degree are not expected: what changes within their range is compared with a number.
constexpr int most_degree = 8;

// Where answers change on one side of scale 1.
template <class Real>
struct WindowEnd {
  int last;                        // with the answers of scale 1
  Numbers<Real> base = {};         // of the first that differs
  std::optional<int> beyond = {};  // its power; empty where none does
  std::optional<DiagnosisWitness> witness = {};
};

template <class Real>
class WindowScan {
 public:
  explicit WindowScan(Subject<Real>& subject) : subject_(subject) {
    for (const auto& query : clear_queries<Real>(subject.kernel(), window_count)) base_.push_back(query.numbers);
    clear_ = base_.size();
    if (clear_ != 0) {
      for (const auto& query : clear_of_families(subject)) base_.push_back(query.numbers);
    }
    at_one_ = subject.ask(base_);
    // Those of the others that it decides.
    for (std::size_t i = base_.size(); i-- > clear_;) {
      if (is_decided(at_one_[i])) continue;
      base_.erase(base_.begin() + static_cast<std::ptrdiff_t>(i));
      at_one_.erase(at_one_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  std::size_t size() const { return base_.size(); }
  // Both verdicts occur, and all are decided: otherwise nothing can change, or nothing is known.
  bool tells() const {
    const auto end = at_one_.begin() + static_cast<std::ptrdiff_t>(clear_);
    return std::count(at_one_.begin(), end, Verdict::contact) != 0 &&
           std::count(at_one_.begin(), end, Verdict::separated) != 0 && std::all_of(at_one_.begin(), end, is_decided);
  }
  // From 0 towards `end`, each power of two; of each scene those times which it is exact.
  WindowEnd<Real> last(int end) {
    const int step = end > 0 ? 1 : -1;
    const Scaling unit = unit_of_length(subject_.kernel());
    for (int m = step; m != end + step; m += step) {
      Queries<Real> scaled;
      std::vector<std::size_t> from;
      for (std::size_t i = 0; i < base_.size(); ++i) {
        if (auto image = times_exactly(base_[i], unit.columns, m)) {
          scaled.push_back(std::move(*image));
          from.push_back(i);
        }
      }
      const auto said = subject_.ask(scaled);
      for (std::size_t i = 0; i < said.size(); ++i) {
        const Verdict at_one = at_one_[from[i]];
        if (said[i] == at_one) continue;
        return {m - step, base_[from[i]], m,
                subject_.witness(scaled[i], said[i], fmt::format("times 2^{} the answer was {}", -m, name(at_one)))};
      }
    }
    return {end};
  }

 private:
  Subject<Real>& subject_;
  Queries<Real> base_;  // the clear ones first
  std::size_t clear_ = 0;
  std::vector<Verdict> at_one_;
};

// Why answers change there: the degree whose formulae leave the range, where one of 8 or less does.
template <class Real>
std::string why_text(const Kernel& kernel, const SidesOfForms<Real>& forms, const WindowEnd<Real>& end, Json& measured,
                     const char* key) {
  if (!end.beyond) return "";
  using Limits = std::numeric_limits<Real>;
  const Scaling unit = unit_of_length(kernel);
  double greatest = 0;
  for (const std::size_t k : unit.columns)
    greatest = std::max(greatest, std::abs(std::ldexp(static_cast<double>(end.base[k]), *end.beyond)));
  const bool is_above = *end.beyond > 0;
  // For differences, which are up to twice the numbers.
  const double size = std::log2(is_above ? 2 * greatest : greatest);
  const double degree = std::ceil((is_above ? Limits::max_exponent : Limits::min_exponent) / size);
  if (degree > 0 && degree <= most_degree) {
    measured[key] = degree;
    return fmt::format(
        " At 2^{} {} to the power of {}.", *end.beyond,
        is_above ? "differences of a query's numbers overflow" : "a query's numbers are no normal numbers", degree);
  }
  measured[key] = nullptr;
  const std::optional<UnitRange> range = forms.empty() ? std::nullopt : forms.range(end.base, unit);
  if (range && range->holds<Real>(*end.beyond, most_degree)) {
    return fmt::format(
        " At 2^{} no formula of degree {} or less leaves the range: something is compared with a number of its own "
        "(absolute_threshold).",
        *end.beyond, most_degree);
  }
  return fmt::format(" At 2^{} formulae of degree {} may leave the range.", *end.beyond, most_degree);
}

}  // namespace

template <class Real>
ProbeFinding range_window(Subject<Real>& subject) {
  WindowScan<Real> scan(subject);
  if (scan.size() == 0)
    return unasked("This predicate has no queries here that are known to be far from every boundary.");
  if (!scan.tells())
    return undecided("At scale 1 it does not give both answers to queries that are far from touching.");
  const ExponentWindow scanned = scenes_of<Real>(subject.predicate()).scanned(precision_of<Real>);
  const WindowEnd<Real> high = scan.last(scanned.high), low = scan.last(scanned.low);
  Json measured = {
      {"low", low.last},       {"high", high.last},     {"scanned_low", scanned.low}, {"scanned_high", scanned.high},
      {"degree_low", nullptr}, {"degree_high", nullptr}};
  std::vector<DiagnosisWitness> witnesses;
  for (const auto* end : {&low, &high}) {
    if (end->witness) witnesses.push_back(*end->witness);
  }
  if (!low.beyond && !high.beyond) {
    return decided(Window::whole,
                   fmt::format("Times every power of two from 2^{} to 2^{} it answers {} clear queries as "
                               "at scale 1.",
                               low.last, high.last, scan.size()),
                   {}, measured);
  }
  const SidesOfForms<Real> forms(subject.kernel());
  const std::string why = why_text(subject.kernel(), forms, low, measured, "degree_low") +
                          why_text(subject.kernel(), forms, high, measured, "degree_high");
  return decided(Window::limited,
                 fmt::format("It answers {} clear queries as at scale 1 from 2^{} to 2^{} ({:.0e} to {:.0e} in the "
                             "queries' unit); 2^{} to 2^{} were asked.{}",
                             scan.size(), low.last, high.last, std::ldexp(1.0, low.last), std::ldexp(1.0, high.last),
                             scanned.low, scanned.high, why),
                 std::move(witnesses), std::move(measured));
}
template ProbeFinding range_window(Subject<float>&);
template ProbeFinding range_window(Subject<double>&);

namespace {

template <class Real>
std::optional<WindowRecord> window_of(const Kernel& kernel, const DiagnosisOptions& options) {
  Subject<Real> subject(kernel, options, false);
  WindowScan<Real> scan(subject);
  if (scan.size() == 0 || !scan.tells()) return std::nullopt;
  const ExponentWindow scanned = scenes_of<Real>(subject.predicate()).scanned(precision_of<Real>);
  return WindowRecord{scan.last(scanned.low).last, scan.last(scanned.high).last, scanned.low, scanned.high,
                      scan.size()};
}

}  // namespace
}  // namespace diagnosis

void put_windows(Record& record, const Plan& plan, const CampaignResult& result) {
  if (plan.answerers.replies || !result.complete) return;
  for (KernelRecord& entry : record.kernels) {
    const auto& kernels = plan.answerers.kernels;
    const auto at = std::ranges::find_if(kernels, [&](const Kernel* kernel) { return entry.id == kernel->id; });
    if (at == kernels.end()) continue;
    const DiagnosisOptions options{entry.precision, plan.questions.seed, plan.running.target};
    entry.window = entry.precision == Precision::binary32 ? diagnosis::window_of<float>(**at, options)
                                                          : diagnosis::window_of<double>(**at, options);
  }
}

}  // namespace axiscert
