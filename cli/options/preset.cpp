#include "cli/options/preset.h"

#include <algorithm>
#include <iterator>

#include "exact/trait/oracles.h"
#include "fuzz/files/corpus.h"

namespace axiscert {
namespace {

struct Preset {
  const char* name;
  std::uint64_t trials;  // per family and precision
};

// ci: every family and the corpus. Bounded by trials, so that the plan is the same everywhere; the trials are so few
// that the default kernel takes no more than 20 s on two cores.
constexpr Preset presets[] = {{"ci", std::uint64_t{1} << 14}};

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : presets) names.emplace_back(preset.name);
  return names;
}

void apply_preset(const std::string& name, const Predicate& predicate, RunOptions& options) {
  const auto preset =
      std::find_if(std::begin(presets), std::end(presets), [&](const Preset& p) { return p.name == name; });
  if (options.families.empty() && options.meshes.empty() && options.queries.empty()) options.families = {"all"};
  // A corpus that states the exact answers in full is part of every run of the preset.
  if (!options.corpus && oracles_of(predicate).has_squared_distance()) options.corpus = default_corpus_folder();
  if (!options.trials) options.trials = preset->trials;
}

}  // namespace axiscert
