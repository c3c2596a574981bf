#include "reports/run_folder/parsed_json.h"

#include <fmt/format.h>

namespace axiscert {

Json parsed_json(std::string_view text) {
  // Stops in the middle of the text; what was read up to there is not deeper either.
  return Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
    if (depth <= greatest_json_depth) return true;
    throw Json::other_error::create(
        500,
        fmt::format("deeper than {} levels, which is deeper than anything that axiscert writes", greatest_json_depth),
        nullptr);
  });
}

}  // namespace axiscert
