// Maps as files: pictures, and an index that describes them. docs/map.md has the format.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuzz/map/map.h"
#include "fuzz/text/json.h"
#include "reports/page/png.h"

namespace axiscert {

inline constexpr std::string_view map_index_file = "index.json";

// The colour of a class of pixels, and its meaning.
struct LegendEntry {
  PixelClass pixel;
  Colour colour;
  std::string_view meaning;
};
// The legend in the order of the classes.
const std::array<LegendEntry, pixel_class_count>& map_legend();

// The index entry of one map: the plane, the witness, the counts of every picture.
Json map_json(const std::string& name, const MapPlan& plan, const std::vector<MapPicture>& pictures,
              const std::string& command);

// An index file holds the legend, and these maps.
Json index_of(const std::vector<Json>& maps);

// The pictures, and the index with this map in it: it replaces a map of the same name and joins the other maps of
// `index`, the text of the existing index, empty where there is none. Throws Error where that is not an index of maps.
std::map<std::string, std::string> map_files(const Json& map, const MapPlan& plan,
                                             const std::vector<MapPicture>& pictures, const std::string& index);

// The counts as a table for the terminal, and the meaning of the colours.
std::string map_text(const Json& map);

}  // namespace axiscert
