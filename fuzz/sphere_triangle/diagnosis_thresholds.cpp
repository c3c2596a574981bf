// Numbers of a kernel's own that have a length in them, by what becomes of scenes in other units.
#include <cmath>

#include "fuzz/confirm/asymmetry.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/sphere_triangle/families/parts/lattice_bounds.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/diagnosis_scenes.h"

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
void add_sizes(UnitFindings& into, Subject<Real>& subject, const SeededSource& of, const std::vector<UnitFlip>& flips,
               bool is_small) {
  if (flips.empty()) return;
  into.bases += flips.size();
  into.within_floats += static_cast<std::uint64_t>(std::ranges::count_if(flips, [&](const UnitFlip& flip) {
    const PowerRange floats = range_in_floats(of.source.make<Real>(of.seed, flip.base));
    return floats.contains(flip.right) && floats.contains(flip.wrong);
  }));
  for (const AbsoluteSize& size : absolute_sizes(of, flips)) {
    const Quantity& quantity = size.quantity;
    into.compared.push_back({{"family", of.source.name()},
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
  const Numbers<Real> base = of.source.make<Real>(of.seed, flip.base);
  for (const int exponent : {flip.right, flip.wrong}) {
    const Numbers<Real> scaled = times_power(base, exponent);
    const std::vector<Verdict> said = subject.ask_batch(std::span(&scaled, 1));
    into.witnesses.push_back(subject.witness(
        scaled, said[0], fmt::format("the same scene times 2^{} and 2^{}; clear of touching", flip.right, flip.wrong)));
  }
}

}  // namespace

template <class Real>
ProbeFinding threshold_by_units(Subject<Real>& subject) {
  UnitFindings found;
  std::uint64_t images = 0;
  for (const std::string_view family : unit_families) {
    const SourcePtr source = family_source(find_family(family));
    const SeededSource of{*source, subject.seed(), precision_of<Real>};
    const auto asymmetry = asymmetry_of(of, unit_trials, subject.kernel(), nullptr, {subject.target()});
    if (!asymmetry) continue;
    for (const ImageChanges& changes : asymmetry->invariance.kinds) images += changes.images;
    subject.count(unit_trials);
    add_sizes(found, subject, of, asymmetry->invariance.units.small, true);
    add_sizes(found, subject, of, asymmetry->invariance.units.large, false);
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
template ProbeFinding threshold_by_units(Subject<float>&);
template ProbeFinding threshold_by_units(Subject<double>&);

}  // namespace axiscert::diagnosis
