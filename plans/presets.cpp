// Presets of `axiscert run`: plans with a name. A new one is a line here.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "exact/judge/oracles.h"
#include "fuzz/files/corpus.h"
#include "fuzz/queries/family.h"
#include "kernel/base/error.h"
#include "plans/predicate_options.h"
#include "plans/run_plan.h"

namespace axiscert {
namespace {

struct Preset {
  const char* name;
  const char* meaning;
  void (*apply)(const Predicate& predicate, std::size_t entry, bool gives_times, RunOptions& options);
};

// Bounded by trials, so that the plan is the same everywhere; the trials are so few that the default kernel takes no
// more than 20 s on two cores.
void ask_everything(const Predicate& predicate, std::size_t, bool, RunOptions& options) {
  if (options.families.empty() && options.meshes.empty() && options.queries.empty()) options.families = {"all"};
  // A corpus that states the exact answers in full is part of every run of the preset.
  if (!options.corpus && oracles_of(predicate).has_squared_distance()) options.corpus = default_corpus_folder();
  if (!options.trials) options.trials = std::uint64_t{1} << 14;
}

// Scenes of a game: a millimetre is no error that anybody sees.
void ask_scenes(const Predicate& predicate, std::size_t entry, bool gives_times, RunOptions& options) {
  if (options.families.empty() && options.meshes.empty() && options.queries.empty()) {
    for (const Family* family : families_of(predicate, entry)) {
      if (family->trust_group == TrustGroup::scene) options.families.emplace_back(family->name);
    }
  }
  if (options.families.empty() && options.meshes.empty() && options.queries.empty()) {
    throw Error(
        fmt::format("--preset game: {} has no families of scenes in the entry {}; give your own with --mesh or "
                    "--queries",
                    predicate.id, predicate.entries[entry].name));
  }
  if (!options.trials) options.trials = std::uint64_t{1} << (has_filters(predicate) ? 16 : 13);
  if (options.required.levels.empty()) {
    options.required.levels = {"depth=1mm", "logic"};
    // A kernel with a reference, or own queries none of which is clear, may leave these unchecked; so may kernels that
    // give no times.
    options.required.allow_unchecked = {"logic"};
    for (const char* level : {"early=1mm", "never-late=1mm"}) {
      if (!gives_times) continue;
      options.required.levels.emplace_back(level);
      options.required.allow_unchecked.emplace_back(level);
    }
  }
  if (options.required.unit.empty()) options.required.unit = "m";
  options.is_brief = true;
}

constexpr Preset presets[] = {
    {"ci", "all families and the corpus with 2^14 queries each", ask_everything},
    {"game",
     "everyday scenes in metres, held to depth=1mm, logic and, of times, early=1mm and never-late=1mm, in ten lines",
     ask_scenes}};

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : presets) names.emplace_back(preset.name);
  return names;
}

std::string presets_text() {
  std::string text;
  for (const Preset& preset : presets) text += fmt::format("{}: {}; ", preset.name, preset.meaning);
  return text + "other options override it";
}

RunOptions with_preset(const RunOptions& given) {
  RunOptions options = given;
  const auto preset = std::ranges::find_if(presets, [&](const Preset& one) { return one.name == given.preset; });
  if (given.preset.empty()) return options;
  if (preset == std::end(presets)) {
    const std::vector<std::string> known = preset_names();
    throw Error(unknown_name("preset", "presets", given.preset, {known.begin(), known.end()}));
  }
  std::vector<const Kernel*> kernels;
  for (const std::string& id : given.kernels) kernels.push_back(&find_kernel(id));
  const Predicate& predicate = predicate_of_kernels(given.predicate, kernels);
  const std::size_t entry = kernels.empty() ? entry_of_families(predicate, given.families) : kernels.front()->entry;
  if (kernels.empty()) kernels.push_back(&default_kernel(predicate, entry));
  const bool gives_times = std::ranges::any_of(kernels, [](const Kernel* one) { return one->measure_count != 0; });
  preset->apply(predicate, entry, gives_times, options);
  return options;
}

}  // namespace axiscert
