#include "reports/instrument/map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "reports/instrument/instrument.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

std::string text_of(const Colour& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); }

SideData side_data(const PlaneSide& side) {
  return {side.numbers.name, side.pixels, side.origin(), static_cast<std::uint64_t>(side.step)};
}

std::string picture_file(const std::string& map, const MapPlan& plan, const MapSubject& subject) {
  return fmt::format("{}-{}.png", map, name(subject, *plan.kernel->predicate));
}

// "Nothing was looked at in verdict: no pixel is decided. ": what stands before anything else; empty where every
// picture has a decided pixel.
std::string nothing_looked_at(const MapData& map) {
  std::vector<std::string> pictures;
  for (const PictureData& picture : map.pictures) {
    if (picture.decided == 0) pictures.push_back(picture.name);
  }
  if (pictures.empty()) return "";
  return fmt::format("Nothing was looked at in {}: no pixel is decided. ", fmt::join(pictures, ", "));
}

}  // namespace

// Wrong signs have the two colours of Okabe and Ito's palette that are easiest to tell apart with any colour vision and
// in greyscale; yes is light, no is darker; the band is yellow with the same two lightnesses.
const std::array<LegendEntry, pixel_class_count>& map_legend() {
  using enum PixelClass;
  static constexpr std::array<LegendEntry, pixel_class_count> legend = {{
      {no_query, {0x6e, 0x6e, 0x6e}, "no query: a number is not finite, or the radius is below zero"},
      {outside_limits, {0x9a, 0x8f, 0x80}, "outside the limits that the kernel declares, whatever it says"},
      {false_separation, {0xd5, 0x5e, 0x00}, "the kernel wrongly says yes; for a verdict: a missed contact"},
      {missed_separation, {0x00, 0x72, 0xb2}, "the kernel wrongly says no; for a verdict: a phantom contact"},
      {undecided, {0xcc, 0x79, 0xa7}, "the kernel declines to say"},
      {invalid, {0x7a, 0x3b, 0x62}, "the kernel calls a valid query invalid"},
      {unanswered, {0x56, 0xb4, 0xe9}, "no answer: a crash, a hang, or what is no verdict"},
      {not_finite, {0x00, 0x9e, 0x73}, "right, though a computed side is not finite"},
      {tie, {0x00, 0x00, 0x00}, "exactly on the boundary; for a verdict: the sphere touches"},
      {boundary, {0x40, 0x40, 0x40}, "no, next to a pixel that is yes: the exact boundary runs between them"},
      {yes_uncertain, {0xfd, 0xf0, 0xa8}, "yes (holds, separates), where the bound does not determine the sign"},
      {no_uncertain, {0xd8, 0xc0, 0x60}, "no, where the bound does not determine the sign"},
      {yes, {0xff, 0xff, 0xff}, "yes: the comparison holds, the axis separates, the sphere and the triangle are apart"},
      {no, {0xc8, 0xc8, 0xc8}, "no"},
  }};
  return legend;
}

MapData map_data(const std::string& map_name, const MapPlan& plan, const std::vector<MapPicture>& pictures,
                 const std::string& command) {
  if (!std::regex_match(map_name, std::regex{std::string(MapNameRule::pattern)}))
    throw Error(fmt::format("--name {}: a name may contain only letters, digits, _ and -", map_name));
  MapData map{map_name,
              command,
              plan.kernel->id,
              plan.kernel->may_decline,
              plan.witness.precision,
              plan.plane.kind,
              side_data(plan.plane.along),
              side_data(plan.plane.across),
              query_line(plan.witness),
              {}};
  for (const MapPicture& picture : pictures) {
    map.pictures.push_back({picture.subject.level, name(picture.subject, *plan.kernel->predicate),
                            picture_file(map_name, plan, picture.subject), picture.decided(), picture.counts});
  }
  return map;
}

std::map<std::string, std::string> map_files(const MapData& map, const MapPlan& plan,
                                             const std::vector<MapPicture>& pictures, const std::string& index) {
  std::map<std::string, std::string> files;
  std::vector<Colour> palette;
  for (const LegendEntry& entry : map_legend()) palette.push_back(entry.colour);
  for (const MapPicture& picture : pictures) {
    static_assert(sizeof(PixelClass) == 1);
    const std::span pixels(reinterpret_cast<const std::uint8_t*>(picture.pixels.data()), picture.pixels.size());
    files[picture_file(map.name, plan, picture.subject)] = indexed_png(plan.plane.columns(), pixels, palette);
  }
  std::vector<MapData> maps;
  if (!index.empty()) {
    try {
      maps = read_as<MapsData>(parsed_json(index)).maps;
    } catch (const std::exception& fault) {
      throw Error(fmt::format("maps/{}: does not conform to {}: {}; remove it, or give another --out", map_index_file,
                              MapsData::format, fault.what()));
    }
    std::erase_if(maps, [&](const MapData& other) { return other.name == map.name; });
  }
  maps.push_back(map);
  files[std::string(map_index_file)] = index_of(std::move(maps)).dump(1) + "\n";
  return files;
}

Json index_of(std::vector<MapData> maps) {
  MapsData index;
  for (const LegendEntry& entry : map_legend())
    index.legend.push_back({entry.pixel, text_of(entry.colour), entry.meaning});
  index.maps = std::move(maps);
  return json_of(index);
}

std::string map_text(const MapData& map) {
  const auto side = [&](const char* which, const SideData& s) {
    return fmt::format("{} {}, {} pixels of {}", which, s.numbers, s.pixels,
                       map.kind == PlaneKind::ulps ? fmt::format("{} ulp", s.step) : fmt::format("2^{}", s.step));
  };
  InstrumentReport report;
  report.title = nothing_looked_at(map) + fmt::format("{} in {} around {}: {}, {}", map.kernel, name(map.precision),
                                                      Json::parse(std::string(map.witness))["id"].get<std::string>(),
                                                      side("along", map.along), side("across", map.across));
  report.command = map.command;
  InstrumentTable table{"Pixels", {"picture", "decided"}, {}};
  for (const std::string_view c : pixel_class_names) table.columns.emplace_back(c);
  for (const PictureData& picture : map.pictures) {
    auto& row = table.rows.emplace_back(std::vector<std::string>{picture.name, fmt::format("{}", picture.decided)});
    for (const std::uint64_t count : picture.counts) row.push_back(fmt::format("{}", count));
  }
  report.tables.push_back(table);
  for (const LegendEntry& entry : map_legend())
    report.notes.push_back(fmt::format("{} {}: {}", name(entry.pixel), text_of(entry.colour), entry.meaning));
  for (const PictureData& picture : map.pictures) {
    const std::uint64_t undecided = picture.counts[PixelClass::undecided];
    if (map.may_decline || undecided == 0) continue;
    report.notes.push_back(
        fmt::format("{}: {} pixels are undecided, and the kernel does not declare that it may decline: a fault.",
                    picture.name, undecided));
  }
  return instrument_text(report);
}

}  // namespace axiscert
