#include <fmt/format.h>

#include <algorithm>

#include "fuzz/sphere_triangle/search.h"
#include "fuzz/sphere_triangle/search_evaluator.h"
#include "fuzz/sphere_triangle/search_range.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
namespace {

// Errors of the computed sides, the scales at which range fails, and wrong verdicts by the critical radius.
class SearchBySides final : public SearchMethod {
 public:
  // Comparisons if the kernel exposes their sides and claims formulae.
  std::vector<Aim> aims(const Kernel& kernel, const std::vector<std::size_t>& only) const override {
    std::vector<Aim> aims;
    if (kernel.exposes == Exposure::sides && has_comparisons(formulae_of(kernel))) {
      for (const Goal goal : {Goal::error, Goal::relative_error, Goal::overflow, Goal::underflow}) {
        for (std::size_t k = 0; k < comparison_count; ++k) {
          if (only.empty() || std::find(only.begin(), only.end(), k) != only.end()) aims.push_back({goal, k});
        }
      }
    }
    if (only.empty()) {
      for (const Goal goal : {Goal::missed_contact, Goal::phantom_contact, Goal::critical_radius})
        aims.push_back({goal});
    }
    return aims;
  }
  std::string why_no_aims(const Kernel& kernel) const override {
    return fmt::format("kernel {} exposes none of these comparisons", kernel.id);
  }

  // Errors of vertex comparisons soon reach their maximum; those of edges profit from each other; the plane's has no
  // such partner. An estimate for a verdict takes thirty questions to the kernel, one for range a hundred and exact
  // signs; range is also soon exhausted.
  IslandShare share(const Aim& aim) const override {
    const Axis axis = comparisons[aim.which].axis;
    if (aim.goal == Goal::error && axis == Axis::plane) return {most_islands, 1 << 16};
    if (aim.goal == Goal::error && axis >= Axis::edge_ab) return {6, 1 << 16};
    if (aim.goal == Goal::error) return {1, 1 << 16};
    if (aim.goal == Goal::relative_error) return {1, 1 << 13};
    if (is_about_range(aim.goal)) return {1, 1 << 9};
    return {1, 1 << 14};
  }

  std::unique_ptr<Guide<float>> guide(const Kernel& kernel, std::string_view target,
                                      std::type_identity<float>) const override {
    return std::make_unique<Evaluator<float>>(kernel, target);
  }
  std::unique_ptr<Guide<double>> guide(const Kernel& kernel, std::string_view target,
                                       std::type_identity<double>) const override {
    return std::make_unique<Evaluator<double>>(kernel, target);
  }

  int exponent(Goal goal, Precision precision, double value) const override {
    return range_exponent(goal, precision, value);
  }

  // The evaluations take a few seconds, the run from which a search begins a second or two.
  const SearchDefaults& defaults() const override {
    static const SearchDefaults defaults = {
        .evaluations = 1 << 24,
        .first_queries = 1 << 13,
        .families = {"general", "tangent", "seam", "sliver", "needle", "collinear", "repeated", "far", "ratio"}};
    return defaults;
  }

  std::vector<std::string> notes() const override {
    return {
        "Attained: |(l^ - r^) - (l - r)| in u, the greatest found where every coordinate of A - P, B - P, C - P is in "
        "[-1, 1] and r in [0, 1], the rounding of the translation included. Proved: a bound that a checker accepted; "
        "open where there is none. Relative: the same over |l| + |r|, of any query; looked for up to 2^40 u, and "
        "without a bound where both sides vanish.",
        "Overflow and underflow: the exponent m of the first 2^m at which a comparison leaves the range, of queries of "
        "size 1/2 to 1 that are far from every change of sign and whose radius, edges and distances to the vertices "
        "are at least 1/8 of the greatest.",
        "A depth is in units of the scene, the error of the critical radius in ulps of the exact distance. Every "
        "witness was confirmed by exact arithmetic. All of these are lower bounds of the worst: a search proves "
        "nothing "
        "about what it does not find."};
  }
};

}  // namespace

const SearchMethod& sphere_triangle_search() {
  static const SearchBySides search;
  return search;
}

}  // namespace axiscert
