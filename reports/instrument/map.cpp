#include "reports/instrument/map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "kernel/base/error.h"
#include "reports/page/embedded.h"
#include "reports/instrument/data.h"
#include "reports/instrument/instrument.h"
#include "reports/run_folder/parsed_json.h"
#include "reports/run_folder/schema.h"

namespace axiscert {
namespace {

constexpr const char* index_schema = "axiscert-maps/2";

std::string text_of(const Colour& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue); }

Json legend_json() {
  Json legend = Json::array();
  for (const LegendEntry& entry : map_legend()) {
    legend.push_back(
        {{"class", pixel_class_names[entry.pixel]}, {"colour", text_of(entry.colour)}, {"meaning", entry.meaning}});
  }
  return legend;
}

Json side_json(const PlaneSide& side) {
  return {{"numbers", side.numbers.name}, {"pixels", side.pixels}, {"origin", side.origin()}, {"step", side.step}};
}

// The characters allowed in the name of a map, which begins the names of its files.
constexpr std::string_view name_letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

std::string picture_file(const std::string& map, const MapPlan& plan, const MapSubject& subject) {
  return fmt::format("{}-{}.png", map, name(subject, *plan.kernel->test));
}

// "Nothing was looked at in verdict: no pixel is decided. ": what stands before anything else; empty where every
// picture has a decided pixel.
std::string nothing_looked_at(const Json& map) {
  std::vector<std::string> pictures;
  for (const Json& picture : map["pictures"]) {
    if (picture["decided"] == 0) pictures.push_back(picture["name"]);
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

Json map_json(const std::string& map_name, const MapPlan& plan, const std::vector<MapPicture>& pictures,
              const std::string& command) {
  if (map_name.empty() || map_name.find_first_not_of(name_letters) != map_name.npos) {
    throw Error(fmt::format("--name {}: a name may contain only letters, digits, _ and -", map_name));
  }
  Json map = {{"name", map_name},
              {"command", command},
              {"kernel", plan.kernel->id},
              {"may_decline", plan.kernel->may_decline},
              {"precision", name(plan.witness.precision)},
              {"kind", plane_kind_names[plan.plane.kind]},
              {"along", side_json(plan.plane.along)},
              {"across", side_json(plan.plane.across)},
              {"witness", Json::parse(query_line(plan.witness))},
              {"pictures", Json::array()}};
  for (const MapPicture& picture : pictures) {
    Json counts = Json::object();
    for (std::size_t c = 0; c < pixel_class_count; ++c) counts[std::string(pixel_class_names[c])] = picture.counts[c];
    map["pictures"].push_back({{"level", level_names[picture.subject.level]},
                               {"name", name(picture.subject, *plan.kernel->test)},
                               {"file", picture_file(map_name, plan, picture.subject)},
                               {"decided", picture.decided()},
                               {"counts", counts}});
  }
  return map;
}

std::map<std::string, std::string> map_files(const Json& map, const MapPlan& plan,
                                             const std::vector<MapPicture>& pictures, const std::string& index) {
  std::map<std::string, std::string> files;
  std::vector<Colour> palette;
  for (const LegendEntry& entry : map_legend()) palette.push_back(entry.colour);
  for (const MapPicture& picture : pictures) {
    static_assert(sizeof(PixelClass) == 1);
    const std::span pixels(reinterpret_cast<const std::uint8_t*>(picture.pixels.data()), picture.pixels.size());
    files[picture_file(map["name"], plan, picture.subject)] = indexed_png(plan.plane.columns(), pixels, palette);
  }
  std::vector<Json> maps;
  if (!index.empty()) {
    Json given = Json::value_t::discarded;  // stays so where the index is not JSON, for the schema to refuse
    try {
      given = parsed_json(index);
    } catch (const Json::exception&) {
    }
    check_schema(Json::parse(embedded::maps_schema_json), given, fmt::format("maps/{}", map_index_file),
                 "remove it, or give another --out");
    for (const Json& other : given["maps"]) {
      if (other["name"] != map["name"]) maps.push_back(other);
    }
  }
  maps.push_back(map);
  files[std::string(map_index_file)] = index_of(maps).dump(1) + "\n";
  return files;
}

Json index_of(const std::vector<Json>& maps) {
  return headed(index_schema, {{"legend", legend_json()}, {"maps", maps}});
}

std::string map_text(const Json& map) {
  const auto side = [&](const char* which) {
    const Json& s = map[which];
    return fmt::format("{} {}, {} pixels of {}", which, s["numbers"].get<std::string>(), s["pixels"].get<std::size_t>(),
                       map["kind"] == "ulps" ? fmt::format("{} ulp", s["step"].get<std::int64_t>())
                                             : fmt::format("2^{}", s["step"].get<std::int64_t>()));
  };
  InstrumentReport report;
  report.title =
      nothing_looked_at(map) + fmt::format("{} in {} around {}: {}, {}", map["kernel"].get<std::string>(),
                                           map["precision"].get<std::string>(), map["witness"]["id"].get<std::string>(),
                                           side("along"), side("across"));
  report.command = map["command"];
  InstrumentTable table{"Pixels", {"picture", "decided"}, {}};
  for (const std::string_view c : pixel_class_names) table.columns.emplace_back(c);
  for (const Json& picture : map["pictures"]) {
    std::vector<std::string> row = {picture["name"], picture["decided"].dump()};
    for (const std::string_view c : pixel_class_names) row.push_back(picture["counts"][std::string(c)].dump());
    table.rows.push_back(row);
  }
  report.tables.push_back(table);
  for (const LegendEntry& entry : map_legend()) {
    report.notes.push_back(
        fmt::format("{} {}: {}", pixel_class_names[entry.pixel], text_of(entry.colour), entry.meaning));
  }
  for (const Json& picture : map["pictures"]) {
    const Json& counts = picture["counts"];
    if (map["may_decline"] == true || counts["undecided"] == 0) continue;
    report.notes.push_back(
        fmt::format("{}: {} pixels are undecided, and the kernel does not declare that it may "
                    "decline: a fault.",
                    picture["name"].get<std::string>(), counts["undecided"].dump()));
  }
  return instrument_text(report);
}

}  // namespace axiscert
