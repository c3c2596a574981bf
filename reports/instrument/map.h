// Maps as files: pictures, and an index that describes them. docs/map.md has the format.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuzz/files/query_object.h"
#include "fuzz/map/map.h"
#include "reports/instrument/data.h"
#include "reports/page/encoding.h"

namespace axiscert {

inline constexpr std::string_view map_index_file = "index.json";

struct ColourRule {
  static constexpr std::size_t longest = 7;
  static constexpr std::string_view pattern = "^#[0-9a-f]{6}$";
};
struct MapNameRule {
  static constexpr std::size_t longest = 255;
  static constexpr std::string_view pattern = "^[A-Za-z0-9_-]+$";
};

// The colour of a class of pixels, and its meaning.
struct LegendEntry {
  PixelClass pixel;
  Colour colour;
  std::string_view meaning;
};
// The legend in the order of the classes.
const std::array<LegendEntry, pixel_class_count>& map_legend();

struct LegendData {
  PixelClass pixel = PixelClass::no_query;
  Text<ColourRule> colour;
  Name meaning;

  static constexpr auto fields(auto&& visit) {
    return visit(field(&LegendData::pixel, {"class", "The name in the counts."}),
                 field(&LegendData::colour, {"colour", "Red, green, blue."}),
                 field(&LegendData::meaning, {"meaning", "The text of the legend."}));
  }
};

struct SideData {
  Name numbers;
  std::uint64_t pixels = 0, origin = 0, step = 0;

  static constexpr std::string_view about = "One side of a plane.";
  static constexpr auto fields(auto&& visit) {
    using Of = SideData;
    return visit(
        field(&Of::numbers, {"numbers", "The numbers that change: a.x ... p.z, r; a, b, c, p, triangle, scene."}),
        field(&Of::pixels, {"pixels", "The number of pixels.", "pixels"}),
        field(&Of::origin, {"origin", "The pixel at which the numbers are the witness's.", "pixels"}),
        field(&Of::step, {"step", "Ulps, or exponents of two, from pixel to pixel.", "ulps or exponents"}));
  }
};

struct PictureData {
  Level level = Level::verdict;
  Name name, file;
  std::uint64_t decided = 0;
  EnumArray<PixelClass, std::uint64_t> counts{};

  static constexpr std::string_view about = "One file.";
  static constexpr auto fields(auto&& visit) {
    using Of = PictureData;
    return visit(
        field(&Of::level, {"level", "The subject of the picture."}),
        field(&Of::name, {"name", "verdict, edge_ab, edge_ab.radius ..."}),
        field(&Of::file, {"file", "A PNG file next to this one, with a palette."}),
        field(&Of::decided,
              {"decided",
               "Pixels within the kernel's limits at which it said yes or no. With none, the picture shows nothing "
               "about it.",
               "pixels"}),
        field(&Of::counts, {"counts", "Pixels of each class of the legend.", "pixels"}));
  }
};

struct MapData {
  Text<MapNameRule> name;
  Name command, kernel;
  bool may_decline = false;
  Precision precision = Precision::binary32;
  PlaneKind kind = PlaneKind::ulps;
  SideData along, across;
  QueryLine witness;
  std::vector<PictureData> pictures;

  static constexpr std::string_view about = "One plane through query space and one kernel.";
  static constexpr auto fields(auto&& visit) {
    using Of = MapData;
    return visit(field(&Of::name, {"name", "Unique in this file."}),
                 field(&Of::command, {"command", "The command that draws it again."}),
                 field(&Of::kernel, {"kernel", "The kernel as given to --kernel."}),
                 field(&Of::may_decline,
                       {"may_decline",
                        "Whether the kernel declares that it may answer `undecided`; else such a pixel is a fault."}),
                 field(&Of::precision, {"precision", "The precision of the queries."}),
                 field(&Of::kind, {"kind", "The step of the numbers from pixel to pixel: ulps, or powers of two."}),
                 field(&Of::along, {"along", "To the right."}),
                 field(&Of::across, {"across", "Upwards: pixel 0 is the lowest row of a picture."}),
                 field(&Of::witness, {"witness", "The query that the plane goes through, as a line of a query file."}),
                 field(&Of::pictures, {"pictures", "The verdict, axes, comparisons."}));
  }
};

struct MapsData : DataHead<MapsData> {
  static constexpr std::string_view format = "axiscert-maps/3", title = "The maps of a folder";
  std::vector<LegendData> legend;
  std::vector<MapData> maps;

  static constexpr std::string_view about =
      "maps/index.json, which `axiscert map` writes next to its pictures. It depends on the queries and the kernels "
      "alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = MapsData;
    return visit(base<Of, DataHead<Of>>(),
                 field(&Of::legend, {"legend", "Every class of pixel, in the order of the pictures' palettes."}),
                 field(&Of::maps, {"maps", "In the order in which they were drawn."}));
  }
};

// The index entry of one map: the plane, the witness, the counts of every picture. Throws Error for a name that cannot
// begin the names of files.
MapData map_data(const std::string& name, const MapPlan& plan, const std::vector<MapPicture>& pictures,
                 const std::string& command);

// An index file holds the legend, and these maps.
Json index_of(std::vector<MapData> maps);

// The pictures, and the index with this map in it: it replaces a map of the same name and joins the other maps of
// `index`, the text of the existing index, empty where there is none. Throws Error where that is not an index of maps.
std::map<std::string, std::string> map_files(const MapData& map, const MapPlan& plan,
                                             const std::vector<MapPicture>& pictures, const std::string& index);

// The counts as a table for the terminal, and the meaning of the colours.
std::string map_text(const MapData& map);

}  // namespace axiscert
