// Numbers of a kernel's own that have a length in them: an epsilon, a clamp, a threshold. Times a power of two each
// rounding is the same, so an answer that changes was compared with such a number, or left the range.
#include <fmt/ranges.h>

#include <cmath>

#include "fuzz/confirm/absolute_size.h"
#include "fuzz/diagnosis/other_units.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/text/json.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::uint64_t bases_of_images = 1500, bases_of_others = 48;
constexpr double clear = 0x1p-10;
// In units that a family does not say itself: as far as formulae of degree 8 go in the precision, and beyond.
template <class Real>
std::vector<int> usual_units() {
  std::vector<int> units = {2, 4, 6, 9, 12, 16, 20, 24};
  if (sizeof(Real) == 8) units.insert(units.end(), {30, 40, 60, 90, 120});
  const std::size_t count = units.size();
  for (std::size_t k = 0; k < count; ++k) units.push_back(-units[k]);
  return units;
}
constexpr std::size_t most_flips = 1024;  // of a direction
// Flips from which on a quantity that explains them is named.
constexpr std::size_t least_named = 8;

// A clear scene that is answered rightly times 2^right, and wrongly times 2^wrong.
template <class Real>
struct UnitChange {
  Numbers<Real> base;
  UnitRange range;
  Verdict truth;
  int right, wrong;

  bool is_small() const { return wrong < right; }
  // Whether formulae of a degree keep both in range, in the precision `In`.
  template <class In>
  bool is_within(int degree) const {
    return range.holds<In>(right, degree) && range.holds<In>(wrong, degree);
  }
};

struct ImageCount {
  std::uint64_t images = 0, undecided = 0;  // decided in both units; in one of them at least not
  std::uint64_t left_out = 0;               // not asked: inexact, or beyond the range of the built-in forms
  std::uint64_t changed = 0;                // of the first
};

// All that changes with one scaling.
template <class Real>
class ScalingScan {
 public:
  ScalingScan(Subject<Real>& subject, const SidesOfForms<Real>& forms, Scaling scaling)
      : subject_(subject), forms_(forms), scaling_(std::move(scaling)) {}

  // Clear queries of a family, or the bases of one of images in other units.
  void add(const Family& family) {
    const ImageGroup* group = image_group(family.name);
    const bool has_units = group != nullptr && group->range != nullptr;
    if (group != nullptr && !has_units) return;
    const Oracles& oracles = oracles_of(subject_.kernel());
    pending_.clear();
    queries_.clear();
    for (std::uint64_t i = 0; i < (has_units ? bases_of_images : bases_of_others); ++i) {
      const Numbers<Real> base = family.make<Real>(subject_.seed(), has_units ? i * group->size : i);
      if (!oracles.is_valid(base) || !is_promised(subject_.kernel(), base)) continue;
      const std::optional<Verdict> truth = oracles.verdict_beyond(clear, base);
      if (!truth) continue;
      std::vector<int> units;
      if (has_units) {
        for (std::size_t k = 1; k < group->size; ++k) {
          if (group->kind(k) == ImageKind::scale) units.push_back(group->exponent(precision_of<Real>, i, k));
        }
      } else {
        units = usual_units<Real>();
      }
      put_scene(base, *truth, units);
    }
    take_answers();
  }

  // Clear queries whose greatest number is near 1, in each unit of those within which the others are asked.
  void add(const std::vector<ClearQuery<Real>>& queries) {
    pending_.clear();
    queries_.clear();
    std::vector<int> units;
    constexpr int step = sizeof(Real) == 4 ? 1 : 5, most = sizeof(Real) == 4 ? 20 : 120;
    for (int unit = -most; unit <= most; unit += step) {
      if (unit != 0) units.push_back(unit);
    }
    for (const auto& query : queries) put_scene(query.numbers, query.truth, units);
    take_answers();
  }

  // Asks between the two units of each change until they are neighbours.
  void narrow() {
    const auto is_narrow = [](const auto& change) { return std::abs(change.right - change.wrong) <= 1; };
    for (;;) {
      Queries<Real> queries;
      std::vector<UnitChange<Real>*> wide;
      for (auto& change : changes_) {
        if (is_narrow(change)) continue;
        queries.push_back(*times_exactly(change.base, scaling_.columns, (change.right + change.wrong) / 2));
        wide.push_back(&change);
      }
      if (wide.empty()) break;
      const std::vector<Verdict> said = subject_.ask(queries);
      for (std::size_t i = 0; i < wide.size(); ++i) {
        const int middle = (wide[i]->right + wide[i]->wrong) / 2;
        (said[i] == wide[i]->truth ? wide[i]->right : wide[i]->wrong) = middle;
      }
    }
    // An image that a form leaves the range on shows the range.
    std::erase_if(changes_, [&](const auto& change) {
      return !forms_.commute(image(change, change.right), image(change, change.wrong));
    });
    drop_chance();
  }

  Numbers<Real> image(const UnitChange<Real>& change, int exponent) const {
    return *times_exactly(change.base, scaling_.columns, exponent);
  }
  const std::vector<UnitChange<Real>>& changes() const { return changes_; }
  const ImageCount& count() const { return count_; }
  // In binary64 twice as much leaves room for every number that somebody may have written down.
  int most_degree() const { return sizeof(Real) == 8 ? 2 * scaling_.most_degree : scaling_.most_degree; }

  // The same scene as it is right and as it is wrong.
  void show(const UnitChange<Real>& change, std::string_view what, std::vector<DiagnosisWitness>& witnesses) {
    for (const int exponent : {change.right, change.wrong}) {
      const Numbers<Real> query = image(change, exponent);
      const std::vector<Verdict> said = subject_.ask(std::span(&query, 1));
      witnesses.push_back(subject_.witness(query, said[0],
                                           fmt::format("the same scene with {} times 2^{} and 2^{}; clear of touching",
                                                       what, change.right, change.wrong)));
    }
  }

 private:
  struct Scene {
    UnitChange<Real> scene;
    std::vector<int> units;  // in order, 0 among them
    std::size_t first;       // its queries
  };

  // A few changes may be of kernels whose answers depend on the place in the batch: alone, they answer both alike.
  void drop_chance() {
    constexpr std::size_t few = 32;
    if (changes_.size() > few) return;
    const auto alone = [&](const auto& change, int exponent) {
      const Numbers<Real> query = image(change, exponent);
      return subject_.ask(std::span(&query, 1)).front();
    };
    std::erase_if(changes_, [&](const auto& change) {
      return alone(change, change.right) != change.truth || alone(change, change.wrong) == change.truth;
    });
  }

  void put_scene(const Numbers<Real>& base, Verdict truth, std::vector<int> units) {
    const std::optional<UnitRange> range = forms_.range(base, scaling_);
    if (!range || !range->holds<Real>(0, range->degree_of_forms)) {
      count_.left_out += units.size();
      return;
    }
    units.push_back(0);
    std::ranges::sort(units);
    Scene scene{{base, *range, truth, 0, 0}, {}, queries_.size()};
    for (const int unit : units) {
      const auto scaled = times_exactly(base, scaling_.columns, unit);
      if (!scaled || !range->holds<Real>(unit, range->degree_of_forms) || !is_promised(subject_.kernel(), *scaled)) {
        ++count_.left_out;
        continue;
      }
      queries_.push_back(*scaled);
      scene.units.push_back(unit);
    }
    pending_.push_back(std::move(scene));
  }

  void take_answers() {
    const std::vector<Verdict> said = subject_.ask(queries_);
    for (const Scene& scene : pending_) {
      const auto at = static_cast<std::size_t>(std::ranges::find(scene.units, 0) - scene.units.begin());
      for (std::size_t k = 0; k < scene.units.size(); ++k) {
        if (k == at) continue;
        const Verdict one = said[scene.first + at], other = said[scene.first + k];
        if (!is_decided(one) || !is_decided(other)) {
          ++count_.undecided;
          continue;
        }
        ++count_.images;
        count_.changed += one != other;
      }
      for (const int step : {-1, 1}) keep_first(scene, said, at, step);
    }
  }

  // The first change on the way from the base to one end.
  void keep_first(const Scene& scene, const std::vector<Verdict>& said, std::size_t at, int step) {
    if (!is_decided(said[scene.first + at])) return;
    for (std::size_t near = at;;) {
      const std::size_t far = near + static_cast<std::size_t>(step);
      if (far >= scene.units.size() || !is_decided(said[scene.first + far])) return;
      if (said[scene.first + near] == said[scene.first + far]) {
        near = far;
        continue;
      }
      UnitChange<Real> change = scene.scene;
      change.right = scene.units[said[scene.first + near] == change.truth ? near : far];
      change.wrong = scene.units[said[scene.first + near] == change.truth ? far : near];
      const auto of_direction = [&](const auto& other) { return other.is_small() == change.is_small(); };
      if (static_cast<std::size_t>(std::ranges::count_if(changes_, of_direction)) < most_flips)
        changes_.push_back(std::move(change));
      return;
    }
  }

  Subject<Real>& subject_;
  const SidesOfForms<Real>& forms_;
  Scaling scaling_;
  std::vector<Scene> pending_;
  Queries<Real> queries_;
  std::vector<UnitChange<Real>> changes_;
  ImageCount count_;
};

constexpr Quantity quaternion_length = {"the length of the quaternion", 1};

struct ThresholdFindings {
  std::uint64_t bases = 0;
  Json compared = Json::array();
  std::vector<AbsoluteSize> named;  // a number of each, the first that explains most
  std::uint64_t most = 0;
  bool explains_nearly_all = false;  // of one direction, and of enough
};

// What was compared, of scenes that are wrong where numbers are small, or large.
template <class Real>
void add_sizes(ThresholdFindings& into, const Kernel& kernel, const std::vector<UnitChange<Real>>& changes,
               bool is_small, const Scaling* quaternion) {
  std::vector<MeasuredFlip> flips;
  const Quantities* quantities = capabilities_of(*kernel.predicate).quantities;
  for (const UnitChange<Real>& change : changes) {
    if (change.is_small() != is_small) continue;
    std::vector<double> values;
    if (quaternion) {
      double squared = 0;
      for (const std::size_t k : quaternion->columns) {
        const auto x = static_cast<double>(change.base[k]);
        squared += x * x;
      }
      values = {std::sqrt(squared)};
    } else if (quantities) {
      values = quantities->values(kernel.entry, change.base);
    }
    flips.push_back({std::move(values), change.right, change.wrong});
  }
  into.bases += flips.size();
  if (flips.empty() || (!quaternion && !quantities)) return;
  const std::span<const Quantity> all = quaternion ? std::span(&quaternion_length, 1) : quantities->all;
  const std::vector<AbsoluteSize> sizes = absolute_sizes(all, flips);
  for (const AbsoluteSize& size : sizes) {
    into.compared.push_back({{"wrong_where", is_small ? "small" : "large"},
                             {"quantity", size.quantity.text},
                             {"degree", size.quantity.degree},
                             {"least", size.least},
                             {"greatest", size.greatest},
                             {"explains", size.explains},
                             {"bases", flips.size()}});
  }
  if (sizes.empty() || flips.size() < least_named) return;
  into.explains_nearly_all |=
      flips.size() >= 2 * least_named && 20 * sizes.front().explains >= 19 * static_cast<std::uint64_t>(flips.size());
  // One number is named once, though it may make scenes wrong on both sides of it.
  const AbsoluteSize& best = sizes.front();
  const bool is_named = std::ranges::any_of(into.named, [&](const AbsoluteSize& named) {
    return named.quantity.text == best.quantity.text && best.least <= 2 * named.greatest &&
           named.least <= 2 * best.greatest;
  });
  if (is_named) return;
  if (best.explains > into.most) into.named.insert(into.named.begin(), best);
  else into.named.push_back(best);
  into.most = std::max(into.most, best.explains);
}

std::string text_of(const std::vector<AbsoluteSize>& named) {
  std::string text;
  for (const AbsoluteSize& size : named) {
    const std::string least = fmt::format("{:.2g}", size.least), greatest = fmt::format("{:.2g}", size.greatest);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", and ", size.quantity.text,
                        least == greatest ? "near " + least : fmt::format("between {} and {}", least, greatest));
  }
  return text;
}

// The units nearest to the scenes' own in which one is wrong.
template <class Real>
std::string units_text(const std::vector<UnitChange<Real>>& changes) {
  std::optional<int> down, up;  // the nearest to the scene's own
  for (const auto& change : changes) {
    if (change.is_small()) down = std::max(down.value_or(change.wrong), change.wrong);
    else up = std::min(up.value_or(change.wrong), change.wrong);
  }
  std::vector<std::string> parts;
  if (down) parts.push_back(fmt::format("small: from 2^{} down", *down));
  if (up) parts.push_back(fmt::format("large: from 2^{} up", *up));
  return fmt::format("where they are {}", fmt::join(parts, ", and "));
}

template <class Real>
Json measured_of(const ImageCount& count, const ThresholdFindings& found,
                 const std::vector<UnitChange<Real>>& changes) {
  Json exponents = Json::object();
  for (const auto& change : changes) {
    const std::string unit = std::to_string(change.wrong);
    exponents[unit] = exponents.value(unit, 0) + 1;
  }
  return {{"images", count.images},
          {"left_out", count.left_out},
          {"bases", found.bases},
          {"exponents", std::move(exponents)},
          {"compared", found.compared}};
}

// Whether the kernel shows a number of its own in binary64, where there is room enough; empty where it has none.
template <class Real>
std::optional<bool> has_one_in_double(Subject<Real>& subject) {
  if (sizeof(Real) == 8 || !subject.kernel().has(Precision::binary64)) return std::nullopt;
  DiagnosisOptions options = subject.options();
  options.precision = Precision::binary64;
  Subject<double> twice(subject.kernel(), options);
  const ProbeFinding found = absolute_thresholds(twice);
  subject.count(twice.take_count());
  return found.value == name(Threshold::present);
}

// What the changes of one scaling show: a number of the kernel's own, or, empty, the range alone, which `remark` says.
// `what` is scaled.
template <class Real>
std::optional<ProbeFinding> shown_by(Subject<Real>& subject, ScalingScan<Real>& scan, const Scaling* quaternion,
                                     std::string_view what, std::string& remark) {
  // A form of so great a degree is right in binary64, and leaves the range of binary32 within that of degree 8.
  constexpr int greatest_degree = 12;
  const std::vector<UnitChange<Real>>& all = scan.changes();
  if (all.empty()) return std::nullopt;
  const auto within_degree = [&](int degree) {
    std::vector<UnitChange<Real>> within;
    std::ranges::copy_if(all, std::back_inserter(within),
                         [&](const auto& change) { return change.template is_within<Real>(degree); });
    return within;
  };
  const std::vector<UnitChange<Real>> within = within_degree(scan.most_degree());
  const bool may_be_range = within.empty() || within_degree(greatest_degree).empty();
  const std::optional<bool> in_double = may_be_range && !quaternion ? has_one_in_double(subject) : std::nullopt;
  ThresholdFindings found;
  const auto& shown = within.empty() ? all : within;
  for (const bool is_small : {true, false}) add_sizes(found, subject.kernel(), shown, is_small, quaternion);
  const Json measured = measured_of(scan.count(), found, shown);
  const std::string number =
      found.named.empty() ? "No one quantity explains them." : "What explains them best: " + text_of(found.named) + ".";
  const std::string beyond =
      fmt::format("{} clear scenes are wrong in another unit, {}, where formulae of degree {} leave the range",
                  shown.size(), units_text(shown), within.empty() ? scan.most_degree() : greatest_degree);
  if (may_be_range && (in_double ? !*in_double : within.empty() && !found.explains_nearly_all)) {
    remark = fmt::format(" {}: that is its range (range_window).", beyond);
    return std::nullopt;
  }
  if (within.empty()) {
    return undecided(
        fmt::format("{}: that may be its range (range_window), or a number of its own. {}", beyond, number), measured);
  }
  std::vector<DiagnosisWitness> witnesses;
  for (const bool is_small : {true, false}) {
    const auto first = std::ranges::find_if(within, [&](const auto& change) { return change.is_small() == is_small; });
    if (first != within.end()) scan.show(*first, what, witnesses);
  }
  if (quaternion) {
    return decided(Threshold::quaternions,
                   fmt::format("It compares the length of a quaternion with a number of its own, though a rotation has "
                               "quaternions of any length: {} clear scenes are wrong {}. {}",
                               within.size(), units_text(within), number),
                   std::move(witnesses), measured);
  }
  if (sizeof(Real) == 8 && inner_precision(subject).value == name(Inner::narrower) &&
      std::ranges::none_of(within,
                           [&](const auto& change) { return change.template is_within<float>(scan.most_degree()); })) {
    return undecided(fmt::format("In another unit {} clear scenes are wrong that are right in their own, all of them "
                                 "beyond the range of binary32, in which it computes.",
                                 within.size()),
                     measured);
  }
  return decided(Threshold::present,
                 fmt::format("It compares something with a number that has a length in it: in another unit {} clear "
                             "scenes are wrong that are right in their own, {}. {}",
                             within.size(), units_text(within), number),
                 std::move(witnesses), measured);
}

}  // namespace

template <class Real>
ProbeFinding absolute_thresholds(Subject<Real>& subject) {
  const Kernel& kernel = subject.kernel();
  if (!oracles_of(kernel).has_depth()) return unasked("This predicate has no depth, by which queries are clear.");
  const SidesOfForms<Real> forms(kernel);
  if (forms.empty()) {
    return unasked(
        "No built-in kernel of this predicate shows its sides in this entry, by which the range is excluded.");
  }
  ScalingScan<Real> lengths(subject, forms, unit_of_length(kernel));
  std::vector<Scaling> turns = quaternions(kernel);
  std::vector<ScalingScan<Real>> turned;
  for (const Scaling& scaling : turns) turned.emplace_back(subject, forms, scaling);
  for (const Family* family : families_of(subject.predicate())) {
    if (family->entry != kernel.entry) continue;
    lengths.add(*family);
    for (auto& scan : turned) scan.add(*family);
  }
  lengths.add(clear_of_families(subject));
  lengths.narrow();
  std::string remark;
  const auto of_lengths = shown_by<Real>(subject, lengths, nullptr, "all lengths", remark);
  if (of_lengths && of_lengths->value != not_known) return *of_lengths;
  for (std::size_t k = 0; k < turned.size(); ++k) {
    turned[k].narrow();
    const auto found = shown_by<Real>(subject, turned[k], &turns[k], "a quaternion", remark);
    if (found && found->value != not_known) return *found;
  }
  if (of_lengths) return *of_lengths;
  const ImageCount& count = lengths.count();
  if (count.images + count.undecided == 0)
    return undecided("No query that is far from touching kept within the range in another unit.");
  if (count.images <= count.undecided) {
    return undecided(fmt::format("It decided {} of {} clear scenes in both units: too few to say.", count.images,
                                 count.images + count.undecided));
  }
  return decided(Threshold::none_found,
                 fmt::format("In another unit of length it answers as before: no verdict that is clear of touching "
                             "changed over {} images; {} more are not exact or leave the range, and were not asked.{}",
                             count.images, count.left_out, remark),
                 {}, measured_of<Real>(count, {}, {}));
}
template ProbeFinding absolute_thresholds(Subject<float>&);
template ProbeFinding absolute_thresholds(Subject<double>&);

}  // namespace axiscert::diagnosis
