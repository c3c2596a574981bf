// Numbers of a kernel's own that have a length in them: an epsilon, a clamp, a threshold. Times a power of two every
// rounding is the same, so an answer that changes was compared with such a number, or left the range.
#include <cmath>

#include "fuzz/confirm/asymmetry.h"
#include "fuzz/diagnosis/probes/probes.h"
#include "fuzz/diagnosis/scenes/clear_queries.h"
#include "fuzz/families/sphere_triangle/parts/lattice_bounds.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/ask.h"

namespace axiscert::diagnosis {
namespace {

// Queries of each family of images; the sizes of thresholds are found within a factor of four.
constexpr std::uint64_t unit_trials = 12000;
// Images of the two families together, about half of those that there are.
constexpr std::uint64_t least_images = 10000;
// Scenes from which on a quantity that explains them is named.
constexpr std::size_t least_named = 8;
constexpr std::string_view unit_families[] = {"units", "spans"};

struct UnitFindings {
  std::uint64_t bases = 0;
  Json compared = Json::array();
  std::vector<DiagnosisWitness> witnesses;
  std::string first_text;  // the first quantity with its size
  std::uint64_t most_explained = 0;
  std::uint64_t within_floats = 0;  // bases whose right and wrong units are in the range of binary32's forms
};

// The powers of two times which a scene of integers keeps to the range of forms of degree 6 in binary32.
template <class Real>
PowerRange range_in_floats(const Numbers<Real>& integers) {
  Real greatest = 1;
  for (const Real x : integers) greatest = std::max(greatest, std::abs(x));
  return range_of_degree_6<float>(static_cast<std::int64_t>(greatest));
}

template <class Real>
void add_sizes(UnitFindings& into, Subject<Real>& subject, const Plan& plan, const Source& source,
               const std::vector<UnitFlip>& flips, bool is_small) {
  if (flips.empty()) return;
  into.bases += flips.size();
  into.within_floats += static_cast<std::uint64_t>(std::ranges::count_if(flips, [&](const UnitFlip& flip) {
    const PowerRange floats = range_in_floats(source.make<Real>(plan.seed, flip.base));
    return floats.contains(flip.right) && floats.contains(flip.wrong);
  }));
  for (const AbsoluteSize& size : absolute_sizes(plan, source, precision_of<Real>, flips)) {
    const Quantity& quantity = quantities[size.quantity];
    into.compared.push_back({{"family", source.name()},
                             {"wrong_where", is_small ? "small" : "large"},
                             {"quantity", quantity.text},
                             {"degree", quantity.degree},
                             {"least", size.least},
                             {"greatest", size.greatest},
                             {"explains", size.explains},
                             {"bases", flips.size()}});
    if (flips.size() < least_named || size.explains <= into.most_explained) continue;
    into.most_explained = size.explains;
    into.first_text = fmt::format("{} between {:.2g} and {:.2g}", quantity.text, size.least, size.greatest);
  }
  if (into.witnesses.size() >= 4) return;
  const UnitFlip& flip = flips.front();
  const Numbers<Real> base = source.make<Real>(plan.seed, flip.base);
  for (const int exponent : {flip.right, flip.wrong}) {
    const Numbers<Real> scaled = times_power(base, exponent);
    const std::vector<Verdict> said = subject.ask_batch(std::span(&scaled, 1));
    into.witnesses.push_back(subject.witness(
        scaled, said[0], fmt::format("the same scene times 2^{} and 2^{}; clear of touching", flip.right, flip.wrong)));
  }
}

template <class Real>
Found thresholds_by_images(Subject<Real>& subject) {
  Plan plan;
  plan.seed = subject.seed();
  plan.kernels = {&subject.kernel()};
  plan.target = subject.target();
  UnitFindings found;
  std::uint64_t images = 0;
  for (const std::string_view family : unit_families) {
    const SourcePtr source = family_source(find_family(family));
    const auto asymmetry = asymmetry_of(plan, subject.kernel(), *source, precision_of<Real>, unit_trials);
    if (!asymmetry) continue;
    for (const ImageChanges& changes : asymmetry->invariance.kinds) images += changes.images;
    subject.count(unit_trials);
    add_sizes(found, subject, plan, *source, asymmetry->invariance.units.small, true);
    add_sizes(found, subject, plan, *source, asymmetry->invariance.units.large, false);
  }
  if (found.bases == 0 && images < least_images) {
    return undecided(fmt::format("It decided {} images of scenes in other units: too few to say.", images));
  }
  if (found.bases == 0) {
    return decided(Threshold::none_found,
                   fmt::format("In another unit of length it answers as before: no verdict that is clear of touching "
                               "changed over {} images.",
                               images),
                   {}, {{"images", images}, {"bases", 0}, {"compared", Json::array()}});
  }
  if (sizeof(Real) == 8 && found.within_floats == 0 && inner_precision(subject).value == name(Inner::narrower)) {
    return undecided(fmt::format("In another unit {} clear scenes are wrong that are right in their own, all of them "
                                 "beyond the range of binary32, in which it computes.",
                                 found.bases),
                     {{"images", images}, {"bases", found.bases}, {"compared", found.compared}});
  }
  return decided(Threshold::present,
                 fmt::format("It compares something with a number that has a length in it: in another unit {} clear "
                             "scenes are wrong that are right in their own. {}",
                             found.bases,
                             found.first_text.empty() ? "No one quantity explains them."
                                                      : "What explains them best: " + found.first_text + "."),
                 std::move(found.witnesses),
                 {{"images", images}, {"bases", found.bases}, {"compared", found.compared}});
}

// Other tests: clear queries of every family in other units. To exclude the range, every built-in form of the test has
// to give the same significands in both.
template <class Real>
class UnitsByForms {
 public:
  explicit UnitsByForms(Subject<Real>& subject) : subject_(subject) {
    for (const Kernel& kernel : kernels()) {
      if (kernel.test != subject.kernel().test || kernel.entry != subject.kernel().entry) continue;
      if (!kernel.has(precision_of<Real>)) continue;
      Implementation<Real> form = kernel.on<Real>(scalar_target);
      if (kernel.exposes == Exposure::sides && form.explain) forms_.push_back(std::move(form));
    }
  }
  bool has_forms() const { return !forms_.empty(); }

  Found found() {
    for (const Family* family : families_of(subject_.test())) {
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
      if (truth.verdict == Verdict::invalid || !oracles.is_promised(subject_.kernel().motion, base)) continue;
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
Found absolute_thresholds(Subject<Real>& subject) {
  if (subject.is_first_test()) return thresholds_by_images(subject);
  if (!oracles_of(subject.kernel()).has_depth()) return unasked("This test has no depth, by which queries are clear.");
  UnitsByForms<Real> units(subject);
  if (!units.has_forms()) {
    return unasked("No built-in kernel of this test shows its sides in this entry, by which the range is excluded.");
  }
  return units.found();
}
template Found absolute_thresholds(Subject<float>&);
template Found absolute_thresholds(Subject<double>&);

}  // namespace axiscert::diagnosis
