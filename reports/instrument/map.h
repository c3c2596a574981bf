// Maps as files: pictures, and an index that describes them. docs/map.md has the format.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuzz/instruments/map.h"
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

  AXISCERT_FIELDS(LegendData, field(&LegendData::pixel, {"class", "The name in the counts."}),
                  AXISCERT_FIELD(colour, "Red, green, blue."), AXISCERT_FIELD(meaning, "The text of the legend."))
};

struct SideData {
  Name numbers;
  std::uint64_t pixels = 0, origin = 0, step = 0;

  static constexpr std::string_view about = "One side of a plane.";
  AXISCERT_FIELDS(SideData,
                  AXISCERT_FIELD(numbers, "The numbers that change: a.x ... p.z, r; a, b, c, p, triangle, scene."),
                  AXISCERT_FIELD(pixels, "The number of pixels.", "pixels"),
                  AXISCERT_FIELD(origin, "The pixel at which the numbers are the witness's.", "pixels"),
                  AXISCERT_FIELD(step, "Ulps, or exponents of two, from pixel to pixel.", "ulps or exponents"))
};

struct PictureData {
  Level level = Level::verdict;
  Name name, file;
  std::uint64_t decided = 0;
  EnumArray<PixelClass, std::uint64_t> counts{};

  static constexpr std::string_view about = "One file.";
  AXISCERT_FIELDS(PictureData, AXISCERT_FIELD(level, "The subject of the picture."),
                  AXISCERT_FIELD(name, "verdict, edge_ab, edge_ab.radius ..."),
                  AXISCERT_FIELD(file, "A PNG file next to this one, with a palette."),
                  AXISCERT_FIELD(decided,
                                 "Pixels within the kernel's limits at which it said yes or no. With none, the picture "
                                 "shows nothing about it.",
                                 "pixels"),
                  AXISCERT_FIELD(counts, "Pixels of each class of the legend.", "pixels"))
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
  AXISCERT_FIELDS(
      MapData, AXISCERT_FIELD(name, "Unique in this file."),
      AXISCERT_FIELD(command, "The command that draws it again."),
      AXISCERT_FIELD(kernel, "The kernel as given to --kernel."),
      AXISCERT_FIELD(may_decline,
                     "Whether the kernel declares that it may answer `undecided`; else such a pixel is a fault."),
      AXISCERT_FIELD(precision, "The precision of the queries."),
      AXISCERT_FIELD(kind, "The step of the numbers from pixel to pixel: ulps, or powers of two."),
      AXISCERT_FIELD(along, "To the right."),
      AXISCERT_FIELD(across, "Upwards: pixel 0 is the lowest row of a picture."),
      AXISCERT_FIELD(witness, "The query that the plane goes through, as a line of a query file."),
      AXISCERT_FIELD(pictures, "The verdict, axes, comparisons."))
};

struct MapsData : DataHead<MapsData> {
  static constexpr std::string_view format = "axiscert-maps/3", title = "The maps of a folder";
  std::vector<LegendData> legend;
  std::vector<MapData> maps;

  static constexpr std::string_view about =
      "maps/index.json, which `axiscert map` writes next to its pictures. It depends on the queries and the kernels "
      "alone.";
  AXISCERT_FIELDS(MapsData, base<Of, DataHead<Of>>(),
                  AXISCERT_FIELD(legend, "Every class of pixel, in the order of the pictures' palettes."),
                  AXISCERT_FIELD(maps, "In the order in which they were drawn."))
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
