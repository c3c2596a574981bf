// Correct kernels in other forms, which a harness that detects mutants must not flag.
#include "fuzz/mutation/mutation.h"

#include <algorithm>

#include "fuzz/queries/capabilities.h"

namespace axiscert {
namespace {

// In addition to the correct forms each arithmetic under the base.
std::vector<Kernel> kernels_of(const std::string& base) {
  std::vector<Kernel> kernels;
  for (const std::string_view id : capabilities_of(*find_kernel(base).predicate).correct_forms)
    kernels.push_back(find_kernel(id));
  for (const ArithmeticInfo& arithmetic : arithmetics()) {
    if (arithmetic.arithmetic != Arithmetic::plain) kernels.push_back(find_kernel(base + "+" + arithmetic.name));
  }
  return kernels;
}

// The same answers from a kernel that claims the formulae, but neither their order nor their rounding.
Kernel claiming_formulae_alone(Kernel kernel) {
  kernel.is_reference = false;
  kernel.arithmetic = Arithmetic::plain;
  kernel.exposes = std::min(kernel.exposes, Exposure::comparisons);
  return kernel;
}

std::uint64_t flagged(const VerdictTally& verdict, bool claims_bits, bool shows_formulae) {
  const auto wrong = [&](Link link) { return verdict.links[link]; };
  if (claims_bits) return wrong(Link::specification) + wrong(Link::implementation);
  if (!shows_formulae) return wrong(Link::specification);
  return wrong(Link::specification) + wrong(Link::unattributed) - verdict.touching_links[Link::unattributed];
}

}  // namespace

std::vector<Control> run_controls(const MutationPlan& plan, std::uint64_t trials, const std::atomic<bool>& interrupted,
                                  const ShowProgress& report) {
  std::vector<Kernel> kernels = kernels_of(plan.base);
  const std::size_t by_bits = kernels.size();
  for (std::size_t k = 0; k < by_bits; ++k) {
    // A method has no comparisons to claim; its scalar form is itself the reference.
    if (has_comparisons(kernels[k])) kernels.push_back(claiming_formulae_alone(kernels[k]));
  }
  Plan campaign;
  campaign.questions.seed = plan.seed;
  for (const Kernel& kernel : kernels) campaign.answerers.kernels.push_back(&kernel);
  for (const Family* family : plan.families) campaign.questions.sources.push_back(family_source(*family));
  campaign.questions.precisions = plan.precisions;
  campaign.questions.trials = [trials](const Source&, Precision) { return trials; };
  campaign.running.target = std::string(scalar_target);
  campaign.running.threads = plan.threads;
  const CampaignResult result = run_campaign(campaign, interrupted, report);
  std::vector<Control> controls;
  for (const Precision precision : plan.precisions) {
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      if (!kernels[k].has(precision)) continue;
      Control& control = controls.emplace_back(Control{kernels[k].id, k < by_bits, precision});
      for (const CellResult& cell : result.cells) {
        if (cell.precision != precision) continue;
        const Tally& tally = cell.tallies[k];
        control.queries += tally.trials;
        const Source& source = *campaign.questions.sources[cell.source];
        control.flagged +=
            flagged(tally.verdict, control.claims_bits, shows_formulae(source.name(), source.exact_arithmetic()));
      }
    }
  }
  return controls;
}

}  // namespace axiscert
