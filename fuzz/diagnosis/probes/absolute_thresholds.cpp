// Numbers of a kernel's own that have a length in them: an epsilon, a clamp, a threshold. Times a power of two every
// rounding is the same, so an answer that changes was compared with such a number, or left the range.
#include <cmath>

#include "fuzz/diagnosis/probes/probes.h"
#include "fuzz/diagnosis/scenes/clear_queries.h"
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

}  // namespace axiscert::diagnosis
