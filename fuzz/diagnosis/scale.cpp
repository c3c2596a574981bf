// Numbers of a kernel's own that have a length in them: an epsilon, a clamp, a threshold. Times a power of two every
// rounding is the same, so an answer that changes was compared with such a number, or left the range.
#include <cmath>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/ask.h"

namespace axiscert::diagnosis {
namespace {

// Clear queries of every family in other units. To exclude the range, every built-in form of the predicate has to give
// the same significands in both.
template <class Real>
class UnitsByForms {
 public:
  explicit UnitsByForms(Subject<Real>& subject) : subject_(subject) {
    for (const Kernel& kernel : kernels()) {
      if (kernel.predicate != subject.kernel().predicate || kernel.entry != subject.kernel().entry) continue;
      if (!kernel.has(precision_of<Real>)) continue;
      Implementation<Real> form = kernel.on<Real>(scalar_target);
      if (kernel.exposes == Exposure::sides && form.explain) forms_.push_back(std::move(form));
    }
  }
  bool has_forms() const { return !forms_.empty(); }

  ProbeFinding found() {
    for (const Family* family : families_of(subject_.predicate())) {
      if (family->entry == subject_.kernel().entry && image_group(family->name) == nullptr) add(*family);
    }
    if (images_ + not_decided_ == 0)
      return undecided("No query that is far from touching kept within the range in another unit.");
    if (changed_ == 0 && images_ <= not_decided_) {
      return undecided(fmt::format("It decided {} of {} clear queries in both units: too few to say.", images_,
                                   images_ + not_decided_));
    }
    const Json measured = {{"images", images_}, {"bases", changed_}, {"exponents", by_exponent_}};
    if (changed_ == 0) {
      return decided(Threshold::none_found,
                     fmt::format("In another unit of length it answers as before: no verdict that is clear of touching "
                                 "changed over {} images.",
                                 images_),
                     {}, measured);
    }
    return decided(
        Threshold::present,
        fmt::format("It compares something with a number that has a length in it: {} of {} clear queries are "
                    "right in one unit and wrong in another, and no built-in form leaves the range in "
                    "either.",
                    changed_, images_),
        std::move(witnesses_), measured);
  }

 private:
  static constexpr std::uint64_t positions = 48;
  static constexpr double clear = 0x1p-10;
  static constexpr int exponents[] = {-24, -18, -12, -8, -4, 4, 8, 12, 18, 24};

  void add(const Family& family) {
    const Oracles& oracles = oracles_of(subject_.kernel());
    for (std::uint64_t position = 0; position < positions; ++position) {
      const Numbers<Real> base = family.make<Real>(subject_.seed(), position);
      const Truth truth = oracles.truth(base);
      if (truth.verdict == Verdict::invalid || !is_promised(subject_.kernel(), base)) continue;
      const std::optional<double> depth = oracles.depth(base);
      if (!depth || !(*depth > clear)) continue;
      Queries<Real> all = {base};
      std::vector<int> units = {0};
      for (const int exponent : exponents) {
        const Numbers<Real> scaled = in_unit(subject_.kernel(), base, exponent);
        if (!commutes(base, scaled)) continue;
        all.push_back(scaled);
        units.push_back(exponent);
      }
      if (all.size() > 1) compare(all, units, truth.verdict);
    }
  }

  void compare(const Queries<Real>& all, const std::vector<int>& units, Verdict truth) {
    const auto said = subject_.ask(all);
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (!is_decided(said[0]) || !is_decided(said[i])) {
        ++not_decided_;
        continue;
      }
      ++images_;
      if (said[i] == said[0]) continue;
      ++changed_;
      const std::string unit = std::to_string(units[i]);
      by_exponent_[unit] = by_exponent_.value(unit, 0) + 1;
      if (witnesses_.size() >= 2) continue;
      const std::size_t wrong = said[i] == truth ? 0 : i, right = i - wrong;
      for (const std::size_t k : {right, wrong}) {
        witnesses_.push_back(subject_.witness(
            all[k], said[k], fmt::format("the same scene in units 2^{} and 2^{}", units[right], units[wrong])));
      }
    }
  }

  bool commutes(const Numbers<Real>& base, const Numbers<Real>& scaled) {
    const auto same = [](Real x, Real y) {
      if (!std::isfinite(x) || !std::isfinite(y)) return false;
      int of_x, of_y;
      return std::frexp(x, &of_x) == std::frexp(y, &of_y);
    };
    return std::ranges::all_of(forms_, [&](const Implementation<Real>& form) {
      const Reply<Real> one = axiscert::ask(form, base), other = axiscert::ask(form, scaled);
      for (std::size_t k = 0; k < one.answers.lhs.size(); ++k) {
        if (!same(one.answers.lhs[k][0], other.answers.lhs[k][0])) return false;
        if (!same(one.answers.rhs[k][0], other.answers.rhs[k][0])) return false;
      }
      return true;
    });
  }

  Subject<Real>& subject_;
  std::vector<Implementation<Real>> forms_;
  std::uint64_t images_ = 0, changed_ = 0;  // decided in both units
  std::uint64_t not_decided_ = 0;           // in one of them at least
  Json by_exponent_ = Json::object();
  std::vector<DiagnosisWitness> witnesses_;
};

}  // namespace

template <class Real>
ProbeFinding absolute_thresholds(Subject<Real>& subject) {
  if (const auto by_images = scenes_of<Real>(subject.predicate()).threshold_by_images) return by_images(subject);
  if (!oracles_of(subject.kernel()).has_depth())
    return unasked("This predicate has no depth, by which queries are clear.");
  UnitsByForms<Real> units(subject);
  if (!units.has_forms()) {
    return unasked(
        "No built-in kernel of this predicate shows its sides in this entry, by which the range is excluded.");
  }
  return units.found();
}
template ProbeFinding absolute_thresholds(Subject<float>&);
template ProbeFinding absolute_thresholds(Subject<double>&);

// The powers of two times which a kernel answers as at scale 1.

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
