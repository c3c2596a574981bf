#include "reports/formats/raw_files.h"

#include "reports/formats/format.h"

namespace axiscert {

Json raw_files(const std::filesystem::path& folder) {
  Json files = Json::array();
  std::error_code ignored;
  const auto add = [&](const char* name, const char* meaning) {
    files.push_back({{"name", name}, {"meaning", meaning}});
  };
  const auto add_present = [&](std::initializer_list<std::pair<const char*, const char*>> all) {
    for (const auto& [name, meaning] : all) {
      if (std::filesystem::exists(folder / name, ignored)) add(name, meaning);
    }
  };
  add_present({{"record.json", "every count and every witness; the same bytes from the same plan"},
               {"run.json", "everything that varies: times, machine, target, versions, filter steps"}});
  // These are written together with the page that points to them.
  for (const Format* format : formats()) {
    if (format->meaning) add(format->file, format->meaning);
  }
  add_present({{"witnesses-shrunk.jsonl", "the witnesses made smaller"},
               {"ratchet.json", "the ratchet that the run was compared with, and the outcome"},
               {"proofs.json", "bounds and their checkers"},
               {"search.json", "the worst that a search found"},
               {"ladder.json", "each form of the predicate"},
               {"precision.json", "wrong verdicts against bits"},
               {"league.json", "libraries and kernels"},
               {"mutation.json", "mutants"},
               {"maps/index.json", "maps around witnesses"}});
  return files;
}

}  // namespace axiscert
