#include "examples/character/table.h"

#include <fmt/format.h>

#include "reports/wording/aligned_table.h"

namespace axiscert::character {
namespace {

using Row = std::vector<std::string>;

std::string text(std::uint64_t n) { return fmt::format("{}", n); }
std::string depth_text(std::uint64_t count, double depth) { return count == 0 ? "-" : fmt::format("{:.2e}", depth); }

std::string walk_table(const WalkCountsByMoment& asked) {
  std::vector<Row> rows;
  WalkCounts all;
  const auto add = [&rows](std::string_view moment, const WalkCounts& a) {
    rows.push_back({std::string(moment), text(a.spheres), text(a.triangles), text(a.contacts), text(a.touching),
                    text(a.without_area)});
  };
  for (std::size_t m = 0; m < moment_count; ++m) {
    const WalkCounts& a = asked[m];
    add(moment_names[m], a);
    all.spheres += a.spheres;
    all.triangles += a.triangles;
    all.contacts += a.contacts;
    all.touching += a.touching;
    all.without_area += a.without_area;
  }
  add("all", all);
  return aligned_table({"asked to", "spheres", "triangles", "contacts", "touching", "no area"}, rows);
}

std::string moments_table(std::span<const Comparison> comparisons) {
  std::vector<Row> rows;
  for (const Comparison& c : comparisons) {
    const auto add = [&](std::string_view moment, const Tally& t) {
      rows.push_back({c.kernel, std::string(moment), text(t.errors.missed), text(t.errors.invented), text(t.lost),
                      text(t.phantom)});
    };
    for (std::size_t m = 0; m < moment_count; ++m) add(moment_names[m], c.tallies[m]);
    add("all", c.all);
  }
  return aligned_table({"kernel", "asked to", "missed", "invented", "lost", "phantom"}, rows);
}

std::string depths_table(std::span<const Comparison> comparisons) {
  std::vector<Row> rows;
  for (const Comparison& c : comparisons) {
    const auto add = [&](const char* triangles, const Errors& e) {
      rows.push_back({c.kernel, triangles, text(e.missed), text(e.invented), depth_text(e.missed, e.deepest_missed),
                      depth_text(e.invented, e.deepest_invented)});
    };
    add("with area", c.with_area);
    add("without", c.without_area);
  }
  return aligned_table({"kernel", "triangles", "missed", "invented", "deepest missed", "deepest invented"}, rows);
}

}  // namespace

std::string table(const Ground& ground, const Walk& walk, std::span<const Comparison> comparisons) {
  return walk_table(asked(ground, walk)) + "\n" + moments_table(comparisons) + "\n" + depths_table(comparisons);
}

}  // namespace axiscert::character
