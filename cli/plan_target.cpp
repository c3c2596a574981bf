// Fuzzes plan files: they are refused with an Error; or read, and then the file written from them is read to the same
// plan, and the plan itself is made or refused. The digest is corrected first, or nearly no input would pass it; every
// input is also read unchanged.
#include <fmt/format.h>

#include "fuzz/text/json.h"
#include "plans/plan_file.h"
#include "kernel/base/sha256.h"
#include "fuzz/targets/json_mutator.h"
#include "fuzz/targets/target.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;

// A plan opens the files that it names, including plug-ins, so a plan with files is read but not made.
bool names_a_file(const RunOptions& options) {
  bool names_one = !options.meshes.empty() || !options.queries.empty() || options.corpus;
  for (const std::string& id : options.kernels) names_one |= id.find_first_of(":/") != id.npos;
  return names_one;
}

void check(const std::string& text) {
  const MemoryFile file(text);
  PlanFile plan;
  if (!accepts([&] { plan = read_plan_file(file.path()); })) return;
  const MemoryFile written(plan.text());
  if (!accepts([&] {
        const PlanFile again = read_plan_file(written.path());
        if (again.json != plan.json || again.digest != plan.digest)
          fault("a plan that was read, written and read again differs");
      })) {
    fault("a plan that was written cannot be read again");
  }
  if (names_a_file(plan.options)) return;
  accepts([&] { plan_of(plan); });  // nearly always differs from the plan stored with the options
  accepts([&] { Stretches(plan_of(plan.options).questions, plan.units_each); });
}

// The same digest that plan_file.cpp makes.
std::string signed_again(std::string_view text) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::string(text);
  json.erase("digest");
  const std::string rest = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  json["digest"] = sha256_hex(std::as_bytes(std::span(rest)));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = text_of(data, size);
  check(std::string(text));
  if (!is_deep(text)) check(signed_again(text));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  return mutate_json(data, size, room, seed);
}
