#include "examples/character/picture.h"

#include <fmt/format.h>

#include <climits>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace axiscert::character {
namespace {

constexpr double margin = 32, gap = 28, head = 84, caption = 58, foot = 64;
constexpr double panel_width = 480, panel_height = 760;

// Colours that people with red-green colour blindness can tell apart. A panel's lines are in tenths of a pixel, as
// Place is; its markers are scaled by stroke-width.
constexpr const char* style = R"(<style>
text{font-family:"Helvetica Neue",Helvetica,Arial,"Liberation Sans",sans-serif;fill:#1c2733}
.title{font-size:22px;font-weight:bold}.about{font-size:14px;fill:#4d5b6a}
.name{font-size:17px;font-weight:bold}.count{font-size:13px;fill:#4d5b6a}
.mesh path{stroke-width:3.5;stroke-linejoin:round}
.path{fill:none;stroke-linejoin:round;stroke-linecap:round}
.walk{stroke:#007a5a;stroke-width:16}.faint{stroke:#1c2733;stroke-width:7;stroke-opacity:.55}
.missed{fill:#d1480a}.invented{fill:#0a62c4}.both{fill:#9a2fa8}.set{fill:#fff;stroke:#007a5a;stroke-width:1.6}
.area{fill-opacity:.5;stroke-opacity:.9;stroke-width:6;stroke-linejoin:round}
.needle{stroke-width:18}.places{fill:none;stroke-width:10}marker{overflow:visible}
.area.missed{stroke:#d1480a}.area.invented{stroke:#0a62c4}.area.both{stroke:#9a2fa8}
.dot{stroke:#fff;stroke-width:.5}.lost{fill:none;stroke:#1c2733;stroke-width:.9}
</style>
<defs>
<marker id="missed"><circle class="missed dot" r="2.1"/></marker>
<marker id="invented"><circle class="invented dot" r="2.1"/></marker>
<marker id="both"><circle class="both dot" r="2.1"/></marker>
<marker id="lost"><circle class="lost" r="3.6"/></marker>
<marker id="set"><circle class="set" r="3.2"/></marker>
</defs>
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

// Once round the triangle, back to the first corner; all turn the same way, so that two in one path make no hole.
using Loop = std::array<Place, 4>;
bool has_area(const Loop& loop) { return cross(loop[1] - loop[0], loop[2] - loop[0]) != 0; }
Loop around(const Projection& project, const MeshTriangle& t) {
  const Place a = project(t[0]), b = project(t[1]), c = project(t[2]);
  return cross(b - a, c - a) < 0 ? Loop{a, c, b, a} : Loop{a, b, c, a};
}

// The d of a path, in few bytes: steps from place to place, "m+123-4+5+60z", where a sign needs no separator.
struct PathData {
  std::string text = {};
  Place pen = {0, 0};

  void add(std::span<const Place> line) {
    const bool closed = line.size() > 1 && line.front() == line.back();
    text += 'm';
    for (const Place& p : line.first(line.size() - closed)) {
      text += fmt::format("{:+}{:+}", p.x - pen.x, p.y - pen.y);
      pen = p;
    }
    if (!closed) return;
    text += 'z';
    pen = line.front();
  }
};

// Without the places at most this far, in tenths of a pixel, from the straight line that then passes them.
std::vector<Place> straightened(std::span<const Place> line, double reach) {
  std::vector<Place> kept = {line.front()};
  for (std::size_t passed = 1, i = 1; i < line.size(); ++i) {
    const Place from = kept.back(), whole = line[i] - from;
    const double furthest = reach * std::sqrt(dot(whole, whole));
    const auto is_off = [&](const Place& p) {  // beyond an end, or aside
      return dot(p - from, line[i] - p) < 0 || std::abs(cross(p - from, whole)) > furthest;
    };
    if (std::none_of(line.begin() + passed, line.begin() + i, is_off)) continue;
    kept.push_back(line[i - 1]);
    passed = i;
  }
  kept.push_back(line.back());
  return kept;
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

// The d of triangles of one shade, without the edges that two of them take in opposite directions: around every place
// as many loops turn as before, so that it fills the same.
std::string outline(std::span<const Loop> triangles) {
  PathData data;
  std::multiset<std::pair<Place, Place>> edges;
  for (const Loop& t : triangles) {
    if (!has_area(t)) data.add(t);  // upright: a line
    for (std::size_t k = 0; has_area(t) && k < 3; ++k) {
      if (const auto back = edges.find({t[k + 1], t[k]}); back != edges.end()) edges.erase(back);
      else edges.insert({t[k], t[k + 1]});
    }
  }
  while (!edges.empty()) {
    std::vector<Place> loop = {edges.begin()->first};
    do {  // as many edges leave a place as enter it, so this ends where it started
      const auto edge = edges.lower_bound({loop.back(), {INT_MIN, INT_MIN}});
      loop.push_back(edge->second);
      edges.erase(edge);
    } while (loop.back() != loop.front());
    data.add(straightened(loop, 0));
  }
  return data.text;
}

// The triangles from the lowest to the highest, so that higher ones cover lower ones.
std::string mesh(const Ground& ground, const Projection& project) {
  std::vector<std::tuple<double, std::string, Loop>> order;
  for (std::size_t t = 0; t < ground.size(); ++t) {
    order.emplace_back(height(ground, t), grey(ground, t), around(project, ground.triangle(t)));
  }
  std::sort(order.begin(), order.end());
  std::string svg = "<g id=\"mesh\" class=\"mesh\">\n";
  std::vector<Loop> run;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& [above, shade, loop] = order[i];
    run.push_back(loop);
    if (i + 1 < order.size() && std::get<1>(order[i + 1]) == shade) continue;
    svg += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n", shade, outline(run));
    run.clear();
  }
  return svg + "</g>\n";
}

std::string paths(const Walk& walk, const Projection& project) {
  PathData data;
  for (const auto& path : walk.paths) {
    std::vector<Place> line;
    for (const Vec3<float>& p : path) line.push_back(project(p));
    data.add(straightened(line, 2.5));
  }
  return fmt::format("<path id=\"walk\" d=\"{}\"/>\n", data.text);
}

// A marker at each place.
std::string marked(std::string_view marker, const std::vector<Place>& places) {
  PathData data;
  if (!places.empty()) data.add(places);
  return fmt::format("<path class=\"places\" style=\"marker:url(#{})\" d=\"{}\"/>\n", marker, data.text);
}

// The triangles about which a kernel was wrong anywhere, the spheres with which it was, and those at rest that lost the
// ground.
std::string marks(const Ground& ground, const Walk& walk, const Comparison& comparison, const Projection& project) {
  constexpr unsigned missed = 1, invented = 2;
  constexpr std::array<std::string_view, 4> kinds = {"", "missed", "invented", "both"};
  std::map<std::uint32_t, unsigned> triangles;
  std::map<Place, unsigned> places;
  const auto centre = [&](std::size_t ask) { return project(walk.asks[ask].sphere.centre); };
  for (const Wrong& wrong : comparison.wrong) {
    const unsigned kind = wrong.missed ? missed : invented;
    triangles[wrong.triangle] |= kind;
    places[centre(wrong.ask)] |= kind;
  }
  std::map<std::pair<std::string_view, unsigned>, PathData> areas;
  for (const auto& [t, kind] : triangles) {
    areas[{ground.has_area(t) ? "area" : "area needle", kind}].add(around(project, ground.triangle(t)));
  }
  std::string svg;
  for (const auto& [key, data] : areas) {
    svg += fmt::format("<path class=\"{} {}\" d=\"{}\"/>\n", key.first, kinds[key.second], data.text);
  }
  svg += "<use class=\"path faint\" xlink:href=\"#walk\"/>\n";
  std::map<unsigned, std::vector<Place>> dots;
  for (const auto& [where, kind] : places) dots[kind].push_back(where);
  for (const auto& [kind, at] : dots) svg += marked(kinds[kind], at);
  std::set<Place> lost;
  for (const std::size_t a : comparison.lost) lost.insert(centre(a));
  return svg + marked("lost", {lost.begin(), lost.end()});
}

std::string starts(const Walk& walk, const Projection& project) {
  std::vector<Place> places;
  for (const auto& path : walk.paths) places.push_back(project(path[0]));
  return marked("set", places);
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
    {"<path class=\"area missed\" transform=\"scale(.1)\" d=\"M10,10L150,10 80,-100Z\"/>",
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
  for (const WalkCounts& a : asked(ground, walk)) {
    contacts += a.contacts;
    touching += a.touching;
  }
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<title>{2}</title>\n{3}<defs>\n{4}{5}</defs>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height, escaped(title), style, mesh(ground, project), paths(walk, project));
  const std::size_t colon = title.find(": ");
  svg += text(margin, 40, "title", title.substr(0, colon));
  svg += text(margin, 64, "about", title.substr(std::min(title.size(), colon + 2)));

  double x = margin, y = head;
  const auto panel = [&](const std::string& name, const std::string& count, const std::string& second,
                         const std::string& inside) {
    svg += text(x, y + 16, "name", name) + text(x, y + 34, "count", count) + text(x, y + 50, "count", second);
    svg += fmt::format("<g transform=\"translate({:.1f} {:.1f}) scale(.1)\"><use xlink:href=\"#mesh\"/>\n{}</g>\n", x,
                       y + caption, inside);
    if (beside) x += size.x + gap;
    else y += caption + size.y + gap;
  };
  panel(
      "the walk, by the certified predicate",
      fmt::format("{} spheres, {} triangles in their boxes", grouped(walk.asks.size()), grouped(walk.triangles.size())),
      fmt::format("{} contacts, {} of them touching exactly", grouped(contacts), grouped(touching)),
      "<use class=\"path walk\" xlink:href=\"#walk\"/>\n" + starts(walk, project));
  for (const Comparison& comparison : comparisons) {
    panel(comparison.kernel +
              (comparison.touching == TouchingPolicy::separated ? ", to which touching is not contact" : ""),
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
