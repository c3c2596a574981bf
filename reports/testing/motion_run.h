// For tests: the stored run as one of moving-sphere.
#pragma once

#include "reports/testing/test_run.h"

namespace axiscert {

// A family's first contacts, on 900 that are right: so many times are late, with these deepest tunnels.
inline Json contacts(std::uint64_t late, double late_tunnel, double missed_tunnel) {
  const auto tunnels = [](double deepest) {
    return Json{{"through", deepest == 1 ? 3 : 0}, {"deepest_tunnel", deepest}};
  };
  const Json none = {{"largest_ulps", 0}, {"largest_in_u", 0}, {"by_power", Json::object()}};
  Json errors = none;
  errors["largest_in_u"] = late == 0 ? 0.0 : 2.5;
  return {{"hits", 900},
          {"missed", tunnels(missed_tunnel)},
          {"time",
           {{"none", 0},
            {"invalid", 0},
            {"early", 100},
            {"best", 800 - late},
            {"late", late},
            {"late_errors", errors},
            {"late_tunnels", tunnels(late_tunnel)},
            {"early_errors", none},
            {"largest_gap", 0.0}}},
          {"feature", nullptr},
          {"normal", nullptr},
          {"point", nullptr}};
}

// `<script>` as a kernel of moving-sphere with these contacts on `tangent`, and all times the best on `lattice`; with a
// witness, `late`, of a late time.
inline Json motions(const Json& on_tangent) {
  Json record = stored_record();
  for (Json* kernels : {&record["kernels"], &record["plan"]["kernels"]}) kernels->erase(0);
  record["plan"]["predicate"] = "moving-sphere";
  record["plan"]["tolerance"] = Json::object();
  Json& kernel = record["kernels"][0];
  kernel["measures"] = {"time"};
  kernel["families"]["lattice"]["motion"] = contacts(0, 0, 0);
  kernel["families"]["lattice"]["verdict"]["invalid"] = 0;
  kernel["families"]["tangent"]["motion"] = on_tangent;
  Json witness = record["witnesses"].back();
  witness["id"] = "late";
  witness["family"] = "tangent";
  witness["kernel"] = kernel["id"];
  witness["precision"] = kernel["precision"];
  witness["d"] = {"0x1p+1", "0x0p+0", "0x0p+0"};
  witness["truth"] = witness["computed"] = "contact";
  witness.erase("class");
  witness["depth"] = nullptr;
  witness["flips"] = Json::array();
  witness["shows"] = {"latest time: 2.5 ulps"};
  witness["measures"] = {{"given", {{"time", "0x1p-1"}}}, {"tunnel", 0.25}, {"time", "late"}, {"ulps", 2.5}};
  witness["first_contact"] = {
      {"time", "0x1p-2"},          {"features", {"vertex_a"}},        {"start", "clear"},          {"after_time", 0.0},
      {"point", {1.0, 0.0, -0.1}}, {"point_from_a", {0.0, 0.0, 0.0}}, {"normal", {-1.0, 0.0, 0.0}}};
  record["witnesses"] = Json::array({witness});
  return record;
}

}  // namespace axiscert
