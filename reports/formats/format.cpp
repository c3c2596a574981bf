#include "reports/formats/format.h"

#include <map>
#include <string>

#include "fuzz/text/json.h"

// The formats that exist, one line each: X(NAME) is `NAME_format`, which a file of its own defines.
#define AXISCERT_FORMATS(X) \
  X(html)                   \
  X(csv)                    \
  X(witnesses)              \
  X(markdown)               \
  X(junit)                  \
  X(sarif)                  \
  X(ratchet)

namespace axiscert {

#define AXISCERT_DECLARE(name) extern const Format name##_format;
AXISCERT_FORMATS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

std::span<const Format* const> formats() {
#define AXISCERT_POINT(name) &name##_format,
  static const Format* const all[] = {AXISCERT_FORMATS(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

void render_reports(const std::filesystem::path& run_folder) {
  const Run run = read_run(run_folder);
  std::map<std::string, std::string> texts;
  for (const Format* format : formats()) texts[format->file] = format->render(run);
  write_files(run_folder, texts);
}

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
