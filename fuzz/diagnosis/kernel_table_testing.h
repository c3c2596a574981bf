// Kernels by what is true of them: those that are so, and those that are not.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "fuzz/diagnosis/changed_kernels_testing.h"
#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/diagnosis/made_kernels_testing.h"

namespace axiscert::made {

using Values = std::map<std::string, std::string>;

// True of the published formulae in binary32 or binary64, evaluated as they stand. nearest_form is empty where every
// answer would be true, since the kernel is like no built-in one in particular.
inline Values of_published() {
  return {{"touching", "closed"},
          {"sides", "both"},
          {"degenerate_triangles", "wrong_on_some"},
          {"absolute_threshold", "none_found"},
          {"range_window", "limited"},
          {"subnormal_numbers", "kept"},
          {"operation_order", "left_to_right"},
          {"inner_precision", "own"},
          {"repeated", "same"},
          {"position_in_batch", "independent"},
          {"batch_length", "independent"},
          {"neighbours", "independent"},
          {"nearest_form", "published"}};
}
inline Values with(Values values, const Values& others) {
  for (const auto& [name, value] : others) values[name] = value;
  return values;
}
inline Values of_nonstrict() {
  return with(of_published(), {{"degenerate_triangles", "handled"}, {"nearest_form", "nonstrict"}});
}

// A row says what is true of a kernel; a diagnosis has to say that, or not_known.
struct Row {
  std::string name;
  Precision precision;
  std::function<Kernel()> make;
  Values truth;    // empty: any
  Values decided;  // those of them that the diagnosis has to find
};

inline void PrintTo(const Row& row, std::ostream* to) { *to << row.name; }

inline std::function<Kernel()> id(const std::string& id) {
  return [=] { return find_kernel(id); };
}
inline std::function<Kernel()> plugin(const std::string& file) {
  return id(fmt::format("plugin:{}/{}.so", BUILD_FOLDER, file));
}
inline std::function<Kernel()> made_by(Kernel (*make)()) { return make; }

// Kernels that are so: `decided` is why the row is there.
inline std::vector<Row> kernels_that_are_so() {
  const Values nonstrict = of_nonstrict();
  std::vector<Row> rows;
  const auto add = [&](std::string name, Precision precision, std::function<Kernel()> make, const Values& base,
                       const Values& decided) {
    rows.push_back({std::move(name), precision, std::move(make), with(base, decided), decided});
  };
  add("open_sphere", single, made_by(open_sphere), with(nonstrict, {{"nearest_form", ""}}), {{"touching", "open"}});
  add("open_sphere_64", twice, made_by(open_sphere), with(nonstrict, {{"nearest_form", ""}}), {{"touching", "open"}});
  add("half_open_sphere", single, made_by(half_open_sphere),
      with(nonstrict, {{"nearest_form", ""}, {"operation_order", ""}, {"range_window", ""}}),
      {{"touching", "neither"}});
  const Values sided = with(nonstrict, {{"touching", ""}, {"degenerate_triangles", ""}, {"nearest_form", ""}});
  add("front_only", single, [] { return one_sided(true); }, sided, {{"sides", "front_only"}});
  add("back_only", twice, [] { return one_sided(false); }, sided, {{"sides", "back_only"}});
  add("skips_flat", single, [] { return flat_triangles("skips-flat", Verdict::separated); },
      with(nonstrict, {{"nearest_form", ""}}), {{"degenerate_triangles", "skipped"}});
  add("hits_flat", twice, [] { return flat_triangles("hits-flat", Verdict::contact); },
      with(nonstrict, {{"nearest_form", ""}}), {{"degenerate_triangles", "always_hit"}});
  add("refuses_flat", single, [] { return flat_triangles("refuses-flat", Verdict::invalid); },
      with(nonstrict, {{"nearest_form", ""}}), {{"degenerate_triangles", "refused"}});
  add("published", single, id("published"), of_published(),
      {{"degenerate_triangles", "wrong_on_some"}, {"range_window", "limited"}, {"nearest_form", "published"}});
  const Values another =
      with(of_nonstrict(), {{"nearest_form", ""}, {"absolute_threshold", "present"}, {"range_window", ""}});
  for (const char* file : {"clamped_radius", "least_area", "slack_squared", "tiny_sphere", "strict_squared", "in_plane",
                           "greatest_radius"}) {
    add(file, single, plugin(fmt::format("absolute/{}", file)),
        with(another, {{"touching", ""}, {"inner_precision", ""}}), {{"absolute_threshold", "present"}});
  }
  add("coarse_grid", single, plugin("absolute/coarse_grid"),
      with(another, {{"touching", ""}, {"operation_order", ""}, {"inner_precision", ""}}),
      {{"absolute_threshold", "present"}});
  for (const char* file : {"slack_distance", "short_edge", "inside_epsilon", "far_world"}) {
    add(file, twice, plugin(fmt::format("absolute/{}", file)),
        with(another, {{"touching", ""}, {"inner_precision", ""}}), {{"absolute_threshold", "present"}});
  }
  add("clipped", single, made_by(clipped), with(nonstrict, {{"absolute_threshold", "present"}}),
      {{"range_window", "limited"}});
  add("flushed", single, id("published+ftz"), of_published(), {{"subnormal_numbers", "flushed"}});
  add("flushing_64", twice, made_by(flushing), of_published(), {{"subnormal_numbers", "flushed"}});
  add("fused", single, id("published+fma"), with(of_published(), {{"nearest_form", ""}}),
      {{"operation_order", "contracted"}});
  add("contracted", twice, made_by(contracted_kernel),
      with(of_published(), {{"nearest_form", ""}, {"degenerate_triangles", ""}}), {{"operation_order", "contracted"}});
  add("yz_first", single, id("published+dot-yz-x"), with(of_published(), {{"nearest_form", ""}}),
      {{"operation_order", "other_order"}});
  add("xz_first", twice, id("published+dot-xz-y"), with(of_published(), {{"nearest_form", ""}}),
      {{"operation_order", "other_order"}});
  const Values other_precision = with(
      of_published(), {{"nearest_form", ""}, {"range_window", ""}, {"operation_order", ""}, {"subnormal_numbers", ""}});
  add("float_inside", twice, made_by(float_inside), other_precision, {{"inner_precision", "narrower"}});
  add("float_points", twice, made_by(float_points), other_precision, {{"inner_precision", "narrower"}});
  add("world_double", twice, id("published+world-double"), other_precision, {{"inner_precision", "narrower"}});
  add("double_inside", single, made_by(double_inside), with(other_precision, {{"subnormal_numbers", "kept"}}),
      {{"inner_precision", "wider"}});
  const Values changes = with(nonstrict, {{"repeated", "differs"},
                                          {"position_in_batch", ""},
                                          {"batch_length", ""},
                                          {"neighbours", ""},
                                          {"touching", ""},
                                          {"sides", ""},
                                          {"degenerate_triangles", ""},
                                          {"absolute_threshold", ""},
                                          {"range_window", ""},
                                          {"operation_order", ""},
                                          {"inner_precision", ""},
                                          {"subnormal_numbers", ""}});
  add("changing", single, [] { return changing(1009); }, changes, {{"repeated", "differs"}});
  add("random", single, plugin("misbehaving/random"), with(changes, {{"nearest_form", ""}}), {{"repeated", "differs"}});
  const Values placed = with(nonstrict, {{"touching", ""}, {"operation_order", ""}, {"inner_precision", ""}});
  add("lane_dependent", single, made_by(lane_dependent), placed,
      {{"position_in_batch", "depends"}, {"batch_length", "independent"}});
  add("length_dependent", twice, made_by(length_dependent), placed,
      {{"batch_length", "depends"}, {"position_in_batch", "independent"}});
  add("last_lane", single, plugin("misbehaving/last_lane"),
      with(placed, {{"degenerate_triangles", ""},
                    {"nearest_form", ""},
                    {"sides", ""},
                    {"absolute_threshold", ""},
                    {"range_window", ""}}),
      {{"batch_length", "depends"}, {"position_in_batch", "depends"}});
  add("other_tail", single, made_by(other_tail), with(placed, {{"nearest_form", ""}}),
      {{"batch_length", "depends"}, {"position_in_batch", "depends"}});
  add("carries_over", single, made_by(carries_over),
      with(placed, {{"sides", ""},
                    {"degenerate_triangles", ""},
                    {"nearest_form", ""},
                    {"absolute_threshold", ""},
                    {"range_window", ""},
                    {"subnormal_numbers", ""}}),
      {{"neighbours", "depends"}, {"position_in_batch", "independent"}, {"batch_length", "independent"}});
  return rows;
}

// Kernels that are not so, and what has to be found of them all the same; of some nothing can be.
inline std::vector<Row> kernels_that_are_not_so() {
  std::vector<Row> rows;
  const auto add = [&](std::string name, Precision precision, std::function<Kernel()> make, const Values& truth,
                       const Values& decided = {}) {
    rows.push_back({std::move(name), precision, std::move(make), with(truth, decided), decided});
  };
  const Values places = {{"repeated", "same"},
                         {"position_in_batch", "independent"},
                         {"batch_length", "independent"},
                         {"neighbours", "independent"}};
  const Values sound = with(places, {{"touching", "closed"}, {"sides", "both"}, {"absolute_threshold", "none_found"}});
  for (const Precision precision : {single, twice}) {
    const std::string bits = precision == single ? "_32" : "_64";
    add("nonstrict" + bits, precision, id("nonstrict"), of_nonstrict(),
        with(sound, {{"degenerate_triangles", "handled"},
                     {"inner_precision", "own"},
                     {"operation_order", "left_to_right"},
                     {"subnormal_numbers", "kept"},
                     {"nearest_form", "nonstrict"}}));
    add("certified" + bits, precision, id("certified"),
        with(sound, {{"degenerate_triangles", "handled"},
                     {"range_window", "whole"},
                     {"subnormal_numbers", "kept"},
                     {"operation_order", "not_known"},
                     {"nearest_form", "not_known"}}),
        with(sound, {{"inner_precision", "wider"}, {"range_window", "whole"}, {"degenerate_triangles", "handled"}}));
    const Values method = {{"nearest_form", ""}, {"degenerate_triangles", ""}, {"range_window", ""}};
    for (const char* form : {"reduced", "reduced-determinant", "reduced-shared", "ladder-0", "ladder-4", "minkowski",
                             "closest-point", "segments", "eigen"}) {
      const bool is_eigen = std::string_view(form) == "eigen";
      add(form + bits, precision, id(form),
          with(with(of_published(), method), is_eigen ? Values{{"operation_order", ""}} : Values{}), sound);
    }
    add("packed_nonstrict" + bits, precision, id("packed-nonstrict"), with(of_nonstrict(), {{"nearest_form", ""}}),
        sound);
    add("conservative" + bits, precision, id("conservative"),
        with(places, {{"sides", "both"}, {"nearest_form", "conservative"}}), places);
    add("up" + bits, precision, id("published+up"),
        with(of_published(),
             {{"touching", ""}, {"nearest_form", ""}, {"operation_order", "not_known"}, {"degenerate_triangles", ""}}),
        places);
    add("compensated" + bits, precision, id("published+compensated"),
        with(of_published(), {{"nearest_form", ""},
                              {"inner_precision", ""},
                              {"operation_order", "contracted"},
                              {"degenerate_triangles", ""}}),
        places);
    add("prescaled" + bits, precision, id("published+prescaled"),
        with(of_published(), {{"nearest_form", ""}, {"range_window", ""}, {"degenerate_triangles", ""}}), places);
    add("square_first" + bits, precision, id("published+rr-ee"), with(of_published(), {{"nearest_form", ""}}), sound);
    add("slip" + bits, precision, id("first-publication"),
        with(of_published(), {{"touching", ""}, {"nearest_form", "first-publication"}, {"degenerate_triangles", ""}}),
        {{"nearest_form", "first-publication"}});
    // Nothing can be said of kernels whose answers have nothing to do with the query.
    for (const Verdict verdict : {Verdict::contact, Verdict::separated}) {
      Values nothing = with(places, {{"touching", "not_known"},
                                     {"sides", "not_known"},
                                     {"degenerate_triangles", "not_known"},
                                     {"range_window", "not_known"},
                                     {"operation_order", "not_known"},
                                     {"inner_precision", "not_known"},
                                     {"subnormal_numbers", "not_known"},
                                     {"nearest_form", "not_known"},
                                     {"absolute_threshold", "none_found"}});
      add(
          "always_" + std::string(name(verdict)) + bits, precision, [=] { return constant(verdict); }, nothing, places);
    }
    add("by_coin" + bits, precision, by_coin,
        with(places, {{"touching", "not_known"},
                      {"sides", "not_known"},
                      {"degenerate_triangles", "not_known"},
                      {"operation_order", "not_known"},
                      {"inner_precision", "not_known"},
                      {"subnormal_numbers", "not_known"},
                      {"nearest_form", "not_known"},
                      {"absolute_threshold", ""},
                      {"range_window", ""}}),
        places);
  }
  add("none", single, plugin("absolute/none"), with(of_nonstrict(), {{"nearest_form", ""}, {"range_window", ""}}),
      with(sound, {{"degenerate_triangles", "handled"}}));
  add("none64", twice, plugin("absolute/none64"), with(of_nonstrict(), {{"nearest_form", ""}, {"range_window", ""}}),
      with(sound, {{"degenerate_triangles", "handled"}}));
  add("alignment", single, plugin("misbehaving/alignment"),
      with(of_published(), {{"position_in_batch", "depends"}, {"batch_length", "depends"}, {"nearest_form", ""}}),
      {{"repeated", "same"}});
  return rows;
}

}  // namespace axiscert::made
