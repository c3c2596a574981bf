// Maps as files: pictures, and an index that says what they show. docs/map.md has the format.
#pragma once

#include <map>
#include <string>

#include "fuzz/map/map.h"
#include "fuzz/text/json.h"
#include "reports/page/png.h"

namespace axiscert {

inline constexpr std::string_view map_index_file = "index.json";

// What a class is drawn in, and what that means.
struct LegendEntry {
  PixelClass pixel;
  Colour colour;
  std::string_view meaning;
};
// In the order of the classes.
const std::array<LegendEntry, pixel_class_count>& map_legend();

// One map of the index: the plane, the witness, the counts of every picture.
Json map_json(const std::string& name, const MapPlan& plan, const std::vector<MapPicture>& pictures,
              const std::string& command);

// The pictures, and the index with this map in it: in the place of one of its name, beside those of `index`, the text
// of the index that is there, empty where there is none. Throws Error where that is no index of maps.
std::map<std::string, std::string> map_files(const Json& map, const MapPlan& plan,
                                             const std::vector<MapPicture>& pictures, const std::string& index);

// The counts as a table for the terminal, and what the colours mean.
std::string map_text(const Json& map);

}  // namespace axiscert
