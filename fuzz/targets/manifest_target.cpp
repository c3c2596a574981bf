// The manifest of a program: refused by Error that names the file, or read, and then what was read, written as a
// manifest, is read to the same. Nothing is opened or started.
#include <nlohmann/json.hpp>

#include "fuzz/targets/json_mutator.h"
#include "fuzz/targets/target.h"
#include "fuzz/text/json.h"
#include "kernel/plugin/manifest.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;
using Json = nlohmann::ordered_json;

std::string written(const plugin::Manifest& m) {
  Json json = {{"format", plugin::manifest_format},
               {"name", m.name},
               {"command", m.command},
               {"predicate", m.predicate},
               {"entry", m.entry},
               {"exposes", exposure_names[m.exposes]},
               {"touching", name(m.touching)},
               {"may_decline", m.may_decline},
               {"summary", m.summary},
               {"source", m.source},
               {"conforms_to", m.conforms_to},
               {"formulae", m.formulae},
               {"package", m.package},
               {"version", m.version},
               {"code", m.code},
               {"sides", name(m.limits.sides)},
               {"files", m.files}};
  for (const Precision precision : m.precisions) json["precisions"].push_back(name(precision));
  json["limits"] = {{"least_coordinate", m.limits.least_coordinate},
                    {"greatest_coordinate", m.limits.greatest_coordinate},
                    {"least_area", m.limits.least_area},
                    {"least_radius", m.limits.least_radius},
                    {"greatest_radius", m.limits.greatest_radius},
                    {"margin", m.limits.margin}};
  return json.dump();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plugin::Manifest read, again;
  if (!accepts([&] { read = plugin::read_manifest(text_of(data, size), "fuzzed"); })) return 0;
  if (read.name.empty() || read.command.empty() || read.command.front().empty() || read.precisions.empty()) {
    report_fault("a manifest without a name, a command or a precision was read");
  }
  for (const std::string& word : read.command) {
    if (word.find('\0') != word.npos) report_fault("a word of the command ends before its end");
  }
  if (read.exposes == Exposure::sides) report_fault("a program shows sides");
  const std::string text = written(read);
  if (!accepts([&] { again = plugin::read_manifest(text, "written"); }))
    report_fault("what was read is refused: " + text);
  if (written(again) != text) report_fault("a manifest changes when it is written and read again: " + text);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  return mutate_json(data, size, room, seed);
}
