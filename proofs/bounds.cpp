#include "proofs/bounds.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace axiscert::proofs {
namespace {

// The three edges have the ranges of the first.
constexpr auto range_table = std::to_array<Range>({
    // clang-format off
    {Domain::scaled, "V",  true,  "-4",  "4",    "12", 0, "V", "y0 z0 y1 z1 y2 z2"},
    {Domain::scaled, "d",  false, "-4",  "4",    "18", 0, "d", "x0 y0 z0 x1 y1 z1 x2 y2 z2"},
    {Domain::scaled, "N1", true,  "-2",  "2",    "4", 400, "N", "y0 z0 y1 z1"},
    {Domain::scaled, "N2", true,  "-2",  "2",    "4", 400, "N", "y0 z0 y1 z1"},
    {Domain::scaled, "N3", true,  "-2",  "2",    "4", 400, "N", "y0 z0 y1 z1"},
    {Domain::scaled, "d1", false, "-6",  "0.75", "", 0, "d1", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "d2", false, "-6",  "0.75", "", 0, "d1", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "d3", false, "-6",  "0.75", "", 0, "d1", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "Q1", true,  "-8",  "8",    "24", 1386, "Q", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "Q2", true,  "-8",  "8",    "24", 1386, "Q", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "Q3", true,  "-8",  "8",    "24", 1386, "Q", "x0 y0 z0 x1 y1 z1"},
    {Domain::scaled, "QC", true,  "-16", "16",   "60", 0, "QC", "x0 y0 z0 x1 y1 z1 x2"},
    {Domain::scaled, "QA", true,  "-16", "16",   "60", 0, "QC", "x0 y0 z0 x1 y1 z1 x2"},
    {Domain::scaled, "QB", true,  "-16", "16",   "60", 0, "QC", "x0 y0 z0 x1 y1 z1 x2"},
    {Domain::absolute, "V",  true,  "-4",  "4",  "", 0, "", ""},
    {Domain::absolute, "d",  false, "-16", "16", "", 0, "", ""},
    {Domain::absolute, "N1", true,  "-4",  "4",  "", 1200, "", ""},
    {Domain::absolute, "N2", true,  "-4",  "4",  "", 1200, "", ""},
    {Domain::absolute, "N3", true,  "-4",  "4",  "", 1200, "", ""},
    {Domain::absolute, "d1", false, "-12", "3",  "", 0, "", ""},
    {Domain::absolute, "d2", false, "-12", "3",  "", 0, "", ""},
    {Domain::absolute, "d3", false, "-12", "3",  "", 0, "", ""},
    {Domain::absolute, "Q1", true,  "-16", "16", "", 4157, "", ""},
    {Domain::absolute, "Q2", true,  "-16", "16", "", 4157, "", ""},
    {Domain::absolute, "Q3", true,  "-16", "16", "", 4157, "", ""},
    // clang-format on
});

}  // namespace

std::span<const Range> ranges() { return range_table; }

namespace {

// The bounds in u/16, by domain and contraction. In u, the bounds of binary64 are less than those of binary32 only by
// terms of second order, so one table serves both.
struct Row {
  std::string_view what;
  std::array<std::array<int, 2>, 2> sixteenths;  // [domain][contraction]
};
constexpr auto table = std::to_array<Row>({
    {"plane.radius", {{{21761, 18689}, {179841, 164225}}}},
    {"vertex.radius", {{{128, 112}, {488, 424}}}},
    {"vertex.side", {{{240, 208}, {960, 832}}}},
    {"published edge.radius", {{{74837, 67705}, {559007, 517353}}}},
    {"published edge.side", {{{132161, 119260}, {1157095, 1073347}}}},
    {"reduced edge.radius", {{{1761, 1569}, {9217, 7873}}}},
    {"reduced edge.side", {{{3073, 2593}, {12545, 11265}}}},
    {"V", {{{352, 320}, {640, 608}}}},
    {"N", {{{64, 56}, {256, 224}}}},
    {"Q", {{{1633, 1505}, {6017, 5633}}}},
    {"QC", {{{2849, 2657}, {9089, 8577}}}},
});

int cell(const Setting& setting, std::string_view what) {
  for (const Row& row : table) {
    if (row.what == what) {
      return row.sixteenths[static_cast<std::size_t>(setting.domain)][static_cast<std::size_t>(setting.contraction)];
    }
  }
  throw std::logic_error("no bound of " + std::string(what));
}

}  // namespace

Kind kind_of(Comparison which) {
  const ComparisonInfo& about = info(which);
  if (about.axis == Axis::plane) return Kind::plane_radius;
  if (about.axis <= Axis::vertex_c) return about.is_radius ? Kind::vertex_radius : Kind::vertex_side;
  return about.is_radius ? Kind::edge_radius : Kind::edge_side;
}

int bound(const Setting& setting, Comparison which) {
  const std::string form(name(setting.form));
  switch (kind_of(which)) {
    case Kind::plane_radius:
      return cell(setting, "plane.radius");
    case Kind::vertex_radius:
      return cell(setting, "vertex.radius");
    case Kind::vertex_side:
      return cell(setting, "vertex.side");
    case Kind::edge_radius:
      return cell(setting, form + " edge.radius");
    case Kind::edge_side:
      return cell(setting, form + " edge.side");
  }
  return 0;
}

int vector_bound(const Setting& setting, std::string_view vector) {
  const bool is_foot = vector == "Q1" || vector == "Q2" || vector == "Q3";
  return cell(setting, vector == "V" ? "V" : vector[0] == 'N' ? "N" : is_foot ? "Q" : "QC");
}

bool is_shared(Comparison which) { return info(which).axis < Axis::edge_ab; }

std::string script_path(const Setting& setting, Comparison which) {
  const Form form = is_shared(which) ? Form::published : setting.form;
  return fmt::format("gappa/{}/{}/{}_{}_{}.g", name(setting.precision), name(setting.domain), name(form),
                     name(setting.contraction), identifier(which));
}

}  // namespace axiscert::proofs
