#include "examples/character/picture.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "examples/character/projection.h"

namespace axiscert::character {
namespace {

constexpr double margin = 32, gap = 28, head = 84, caption = 58, foot = 64;
constexpr double panel_width = 480, panel_height = 760;

// Colours that people with red-green colour blindness can tell apart.
constexpr const char* style = R"(<style>
text{font-family:"Helvetica Neue",Helvetica,Arial,"Liberation Sans",sans-serif;fill:#1c2733}
.title{font-size:22px;font-weight:bold}.about{font-size:14px;fill:#4d5b6a}
.name{font-size:17px;font-weight:bold}.count{font-size:13px;fill:#4d5b6a}
.mesh path{stroke-width:.35;stroke-linejoin:round}
.path{fill:none;stroke-linejoin:round;stroke-linecap:round}
.walk{stroke:#007a5a;stroke-width:1.6}.faint{stroke:#1c2733;stroke-width:.7;stroke-opacity:.55}
.missed{fill:#d1480a}.invented{fill:#0a62c4}.both{fill:#9a2fa8}.set{fill:#fff;stroke:#007a5a;stroke-width:1.6}
.area{fill-opacity:.5;stroke-opacity:.9;stroke-width:.6;stroke-linejoin:round}
.needle{stroke-width:1.8}
.area.missed{stroke:#d1480a}.area.invented{stroke:#0a62c4}.area.both{stroke:#9a2fa8}
.dot{stroke:#fff;stroke-width:.5}.lost{fill:none;stroke:#1c2733;stroke-width:.9}
</style>
)";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else out += c;
  }
  return out;
}

// Rounded to a tenth of a pixel, so that positions that cannot be told apart are written once.
std::string at(const Pixel& p) { return fmt::format("{:.1f},{:.1f}", p.x, p.y); }

std::string outline(const Projection& project, const MeshTriangle& t) {
  const auto vertex = [&](std::size_t k) { return at(project(point(t[k]))); };
  return fmt::format("M{}L{} {}Z", vertex(0), vertex(1), vertex(2));
}

double height(const Ground& ground, std::size_t t) {
  double sum = 0;
  for (const Vec3<float>& v : ground.triangle(t)) sum += point(v)[ground.up()];
  return sum;
}

// A grey that depends on how steep the triangle is, lit from one side; both sides of a triangle are alike.
std::string grey(const Ground& ground, std::size_t t) {
  const MeshTriangle& v = ground.triangle(t);
  const auto edge = [&](std::size_t k) {
    const Point from = point(v[0]), to = point(v[k]);
    return Vec3<double>{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  };
  const Vec3<double> n = portable::cross(edge(1), edge(2));
  const double length = std::sqrt(portable::dot(n, n));
  if (!(length > 0)) return "#c9d1da";
  const std::array<double, 3> unit = {n.x / length, n.y / length, n.z / length};
  const double side = unit[ground.up()] < 0 ? -1 : 1;
  const double light =
      side * (0.88 * unit[ground.up()] - 0.34 * unit[(ground.up() + 1) % 3] + 0.34 * unit[(ground.up() + 2) % 3]);
  const int level = static_cast<int>(std::lround(std::clamp(light, 0.0, 1.0) * 12));  // few levels, so that triangles
                                                                                      // can be grouped
  return fmt::format("#{:02x}{:02x}{:02x}", 150 + 7 * level, 161 + 6 * level, 172 + 6 * level);
}

// The triangles from the lowest to the highest, so that higher ones cover lower ones.
std::string mesh(const Ground& ground, const Projection& project) {
  std::vector<std::size_t> order(ground.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> heights;
  for (const std::size_t t : order) heights.push_back(height(ground, t));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  std::string svg = "<defs><g id=\"mesh\" class=\"mesh\">\n", shade, run;
  const auto close = [&] {
    if (!run.empty()) svg += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n", shade, run);
    run.clear();
  };
  for (const std::size_t t : order) {
    const std::string next = grey(ground, t);
    if (next != shade) close();
    shade = next;
    run += outline(project, ground.triangle(t));
  }
  close();
  return svg + "</g></defs>\n";
}

std::string paths(const Walk& walk, const Projection& project, std::string_view kind) {
  std::string svg = fmt::format("<path class=\"path {}\" d=\"", kind);
  for (const auto& path : walk.paths) {
    std::string last;
    for (const Vec3<float>& p : path) {
      const std::string here = at(project(point(p)));
      if (here == last) continue;
      svg += (last.empty() ? "M" : " ") + here;
      last = here;
    }
  }
  return svg + "\"/>\n";
}

std::string circle(std::string_view kind, const std::string& where, double radius) {
  const std::size_t comma = where.find(',');
  return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", kind, where.substr(0, comma),
                     where.substr(comma + 1), radius);
}

// The triangles about which a kernel was wrong anywhere, the spheres with which it was, and those at rest that lost the
// ground.
std::string marks(const Ground& ground, const Walk& walk, const Comparison& comparison, const Projection& project) {
  constexpr unsigned missed = 1, invented = 2;
  constexpr std::array<std::string_view, 4> kinds = {"", "missed", "invented", "both"};
  std::map<std::uint32_t, unsigned> triangles;
  std::map<std::string, unsigned> places;
  for (const Wrong& wrong : comparison.wrong) {
    const unsigned kind = wrong.missed ? missed : invented;
    triangles[wrong.triangle] |= kind;
    places[at(project(point(walk.asks[wrong.ask].sphere.centre)))] |= kind;
  }
  std::string svg;
  for (const auto& [t, kind] : triangles) {
    svg += fmt::format("<path class=\"area{} {}\" d=\"{}\"/>\n", ground.has_area(t) ? "" : " needle", kinds[kind],
                       outline(project, ground.triangle(t)));
  }
  svg += paths(walk, project, "faint");
  for (const auto& [where, kind] : places) svg += circle(fmt::format("dot {}", kinds[kind]), where, 2.1);
  std::set<std::string> lost;
  for (const std::size_t a : comparison.lost) lost.insert(at(project(point(walk.asks[a].sphere.centre))));
  for (const std::string& where : lost) svg += circle("lost", where, 3.6);
  return svg;
}

std::string starts(const Walk& walk, const Projection& project) {
  std::string svg;
  for (const auto& path : walk.paths) svg += circle("set", at(project(point(path[0]))), 3.2);
  return svg;
}

std::string text(double x, double y, std::string_view kind, std::string_view words) {
  return fmt::format("<text class=\"{}\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n", kind, x, y, escaped(words));
}

// A number in groups of three digits.
std::string grouped(std::uint64_t n) {
  if (n < 1000) return fmt::format("{}", n);
  return fmt::format("{},{:03}", grouped(n / 1000), n % 1000);
}

// The depth of the deepest wrong answer; empty for 0. Most are roundings, which the marks do not show.
std::string deepest(double depth) { return depth > 0 ? fmt::format(", by {:.1e} at most", depth) : ""; }

struct LegendEntry {
  std::string_view mark, words;
  double width;
};
constexpr std::array<LegendEntry, 6> legend_entries = {{
    {"<circle class=\"dot missed\" cx=\"8\" cy=\"-4\" r=\"4.2\"/>", "missed a contact", 150},
    {"<circle class=\"dot invented\" cx=\"8\" cy=\"-4\" r=\"4.2\"/>", "invented one", 124},
    {"<circle class=\"dot both\" cx=\"8\" cy=\"-4\" r=\"4.2\"/>", "both", 72},
    {"<circle class=\"lost\" cx=\"8\" cy=\"-4\" r=\"4.6\"/>", "stood, and lost the ground", 208},
    {"<path class=\"area missed\" d=\"M1,1L15,1 8,-10Z\"/>",
     "triangle that it was wrong about, a line where it has no area", 420},
    {"<circle class=\"set\" cx=\"8\" cy=\"-4\" r=\"3.6\"/>", "set down", 100},
}};
constexpr double legend_width = [] {
  double width = 2 * margin;
  for (const LegendEntry& entry : legend_entries) width += entry.width;
  return width;
}();

std::string legend(double y) {
  std::string svg;
  double x = margin;
  for (const LegendEntry& entry : legend_entries) {
    svg += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">{}{}</g>\n", x, y, entry.mark,
                       text(22, 0, "count", entry.words));
    x += entry.width;
  }
  return svg;
}

}  // namespace

std::string picture(const Ground& ground, const Walk& walk, std::span<const Comparison> comparisons,
                    const std::string& title) {
  const Projection project(ground, 2 * double(walk.asks.front().sphere.radius), panel_width, panel_height);
  const Pixel size = project.size();
  const bool beside = size.x < 1.6 * size.y;
  const double columns = beside ? double(comparisons.size() + 1) : 1,
               rows = beside ? 1 : double(comparisons.size() + 1);
  const double width = std::max(2 * margin + columns * size.x + (columns - 1) * gap, legend_width);
  const double height = head + rows * (caption + size.y) + (rows - 1) * gap + foot;

  std::uint64_t contacts = 0, touching = 0;
  for (const Asked& a : asked(ground, walk)) {
    contacts += a.contacts;
    touching += a.touching;
  }
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<title>{2}</title>\n{3}{4}"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height, escaped(title), style, mesh(ground, project));
  const std::size_t colon = title.find(": ");
  svg += text(margin, 40, "title", title.substr(0, colon));
  svg += text(margin, 64, "about", title.substr(std::min(title.size(), colon + 2)));

  double x = margin, y = head;
  const auto panel = [&](const std::string& name, const std::string& count, const std::string& second,
                         const std::string& inside) {
    svg += text(x, y + 16, "name", name) + text(x, y + 34, "count", count) + text(x, y + 50, "count", second);
    svg += fmt::format("<g transform=\"translate({:.1f} {:.1f})\"><use xlink:href=\"#mesh\"/>\n{}</g>\n", x,
                       y + caption, inside);
    if (beside) x += size.x + gap;
    else y += caption + size.y + gap;
  };
  panel(
      "the walk, by the certified predicate",
      fmt::format("{} spheres, {} triangles in their boxes", grouped(walk.asks.size()), grouped(walk.triangles.size())),
      fmt::format("{} contacts, {} of them touching exactly", grouped(contacts), grouped(touching)),
      paths(walk, project, "walk") + starts(walk, project));
  for (const Comparison& comparison : comparisons) {
    panel(comparison.kernel + (comparison.touching == Touching::separated ? ", to which touching is not contact" : ""),
          fmt::format("{} contacts missed{}, {} invented{}", grouped(comparison.all.errors.missed),
                      deepest(comparison.all.errors.deepest_missed), grouped(comparison.all.errors.invented),
                      deepest(comparison.all.errors.deepest_invented)),
          fmt::format("stood {} times, lost the ground {} times", grouped(walk.rests.size()),
                      grouped(comparison.lost.size())),
          marks(ground, walk, comparison, project));
  }
  return svg + legend(height - 26) + "</svg>\n";
}

}  // namespace axiscert::character
