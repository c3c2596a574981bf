// Fuzzes records: record.json and run.json as a report reads them. They are refused with an Error; or accepted, and
// then every format renders them or says in an Error why not.
#include <fmt/format.h>

#include "fuzz/targets/json_mutator.h"
#include "fuzz/targets/target.h"
#include "fuzz/text/json_form.h"
#include "reports/formats/format.h"
#include "reports/run_folder/run_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace axiscert;
  using namespace axiscert::fuzzing;
  const MemoryFile file(text_of(data, size));
  Run run;
  Json json;
  if (!accepts([&] { json = read_json(file.path()); })) return 0;
  accepts([&] { read_run_info(json, "run.json"); });
  if (!accepts([&] { run.record = read_record(json, "record.json"); })) return 0;
  run.folder = "/nonexistent";  // a folder without attachments
  for (const Format* format : formats()) {
    accepts([&] {
      if (format->render(run).empty()) report_fault(fmt::format("an empty {}", format->file));
    });
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  return axiscert::fuzzing::mutate_json(data, size, room, seed);
}
