#include "fuzz/search/method.h"

#include <fmt/format.h>

#include "fuzz/queries/capabilities.h"
#include "fuzz/search/verdict_guide.h"

namespace axiscert {
namespace {

// Each evaluation asks the exact truth: there is no quick estimate.
class SearchByVerdicts final : public SearchMethod {
 public:
  std::vector<Aim> aims(const Kernel& kernel, const std::vector<std::size_t>& /*only*/) const override {
    if (!oracles_of(kernel).has_depth()) return {};
    return {{Goal::missed_contact}, {Goal::phantom_contact}};
  }
  std::string why_no_aims(const Kernel& kernel) const override {
    return fmt::format("the predicate {} has no depth, by which wrong verdicts are compared", kernel.predicate->id);
  }
  IslandShare share(const Aim&) const override { return {1, 1 << 10}; }
  std::unique_ptr<Guide<float>> guide(const Kernel& kernel, std::string_view target,
                                      std::type_identity<float>) const override {
    return std::make_unique<VerdictGuide<float>>(kernel, target);
  }
  std::unique_ptr<Guide<double>> guide(const Kernel& kernel, std::string_view target,
                                       std::type_identity<double>) const override {
    return std::make_unique<VerdictGuide<double>>(kernel, target);
  }
  const SearchDefaults& defaults() const override {
    static const SearchDefaults defaults = {.evaluations = 1 << 14, .first_queries = 1 << 9};
    return defaults;
  }
  std::vector<std::string> notes() const override {
    return {
        "A depth is in units of the scene. Queries are of numbers up to 2^8; a length is set to where the kernel's own "
        "verdict changes. Every witness was confirmed by all oracles of the predicate. These are lower bounds of the "
        "worst: "
        "a search proves nothing about what it does not find."};
  }
};

}  // namespace

const SearchMethod& search_method_of(const Predicate& predicate) {
  static const SearchByVerdicts by_verdicts;
  const SearchMethod* own = capabilities_of(predicate).search_method;
  return own ? *own : by_verdicts;
}

}  // namespace axiscert
