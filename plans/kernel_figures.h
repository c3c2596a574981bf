// What the instruments find about one kernel, by what is asked for: a diagnosis, a search.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/search/search.h"
#include "reports/instrument/instrument.h"
#include "plans/output_folder.h"
#include "plans/search_plan.h"

namespace axiscert {

// Each throws Error in the words of the command of its name.

struct DiagnoseOptions {
  std::string kernel, precision, format = "text", out;  // precision: empty for the first in which the kernel exists
  std::uint64_t seed = 1;
};
struct Diagnosed {
  Diagnosis diagnosis;
  InstrumentReport report;
};
Diagnosed diagnosed(const DiagnoseOptions& options, const std::atomic<bool>& interrupted, const ShowProgress& show);

struct Searched {
  SearchResult result;
  InstrumentReport report;
};
// `plan` is that of the options; `state` that of the search that goes on.
Searched searched(const SearchOptions& options, const SearchPlan& plan, const std::optional<std::string>& state,
                  const std::atomic<bool>& interrupted, const std::function<void(const SearchProgress&)>& show);
// The state in the folder of a search that is resumed; nothing where none is.
std::optional<std::string> search_state(const SearchOptions& options);
// The state and the witnesses.
void write_search(const OutputFolder& folder, const SearchResult& result);

}  // namespace axiscert
