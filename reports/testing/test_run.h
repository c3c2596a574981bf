// For tests: the stored record, and run folders that are removed afterwards.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "reports/formats/format.h"

namespace axiscert {
inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// testing/record.json: `published` with flips on `tangent`, none on `lattice` and `mesh/a|b.obj`; `<script>`, which
// shows only verdicts, with flips on both of its families. Tolerance for plane.radius, requirement `logic`.
inline Json stored_record() { return Json::parse(text_of(SOURCE_FOLDER "/reports/testing/record.json")); }
// The same whose kernel, family, mesh and witness carry `name`.
inline Json named(const std::string& name) {
  std::string text = stored_record().dump();
  for (const std::string old : {"<script>", "a|b.obj"}) {
    const std::string quoted = Json(name).dump();
    const std::string replacement = quoted.substr(1, quoted.size() - 2);
    for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + replacement.size())) {
      text.replace(at, old.size(), replacement);
    }
  }
  return Json::parse(text);
}
inline Json stored_run_info() { return Json::parse(text_of(SOURCE_FOLDER "/reports/testing/run.json")); }
// The counts of `published` on `tangent`.
inline Json& tangent_counts(Json& record) { return record["kernels"][0]["families"]["tangent"]; }

class TestFolder : public TemporaryFolder {
 public:
  TestFolder() = default;
  explicit TestFolder(const Json& record) { write("record.json", record.dump()); }

  std::string read(const std::string& file) const { return text_of(path() / file); }

  // The message of the Error that rendering throws; empty where it succeeds.
  std::string rendering_error() const {
    try {
      render_reports(path());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

// One part of a page's data, decoded as a browser does it.
inline Json page_part(const std::string& html, const std::string& id) {
  const std::string open = "<script type=\"text/plain\" id=\"" + id + "\">";
  const std::size_t begin = html.find(open) + open.size();
  const std::string text = html.substr(begin, html.find("</script>", begin) - begin);
  std::string deflated(text.size(), '\0');
  const int size = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(deflated.data()),
                                   reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  EXPECT_GT(size, 0);
  std::string json(1 << 20, '\0');
  for (;; json.resize(2 * json.size())) {
    uLongf length = json.size();
    // The bytes of base64's padding come after the end, which zlib finds by itself.
    const int outcome = uncompress(reinterpret_cast<Bytef*>(json.data()), &length,
                                   reinterpret_cast<const Bytef*>(deflated.data()), static_cast<uLong>(size));
    if (outcome == Z_BUF_ERROR && json.size() < std::size_t{1} << 30) continue;
    EXPECT_EQ(outcome, Z_OK);
    json.resize(length);
    return Json::parse(json);
  }
}

// The whole data of a page, as its scripts have it.
inline Json page_data(const std::string& html) {
  Json data = page_part(html, "data");
  data["witnesses"] = page_part(html, "witness-data");
  return data;
}

inline std::size_t occurrences(const std::string& text, const std::string& piece) {
  std::size_t n = 0;
  for (std::size_t at = text.find(piece); at != text.npos; at = text.find(piece, at + piece.size())) ++n;
  return n;
}

// For tests: the stored run whose `published` promises something else.

// So many queries outside the limits, all of them decided, and right.
inline Json outside_all(std::uint64_t contact, std::uint64_t touching, std::uint64_t separated) {
  return {{"trials", contact + separated},
          {"decided_contacts", contact},
          {"decided_separations", separated},
          {"decided", contact + separated},
          {"false_separation", 0},
          {"false_contact", 0},
          {"unanswered", 0},
          {"contact", contact},
          {"touching", touching},
          {"deepest", 0.0}};
}

// `published` promises nothing below this radius, and so many valid queries of each family are outside, of which three
// in five are contacts.
inline Json with_least_radius(double radius, std::uint64_t outside) {
  Json record = stored_record();
  Json& kernel = record["kernels"][0];
  kernel["limits"] = {{"least_coordinate", nullptr},
                      {"greatest_coordinate", nullptr},
                      {"least_area", nullptr},
                      {"least_radius", radius},
                      {"greatest_radius", nullptr},
                      {"margin", nullptr},
                      {"sides", nullptr}};
  for (Json& family : kernel["families"]) {
    const std::uint64_t contacts = outside * 3 / 5;
    Json& verdict = family["verdict"];
    const std::uint64_t touching = family["truth"]["touching"],
                        touching_within =
                            std::min(touching, family["truth"]["contact"].get<std::uint64_t>() - contacts);
    verdict["outside_limits"] = outside_all(contacts, touching - touching_within, outside - contacts);
    const auto leave_out = [&](const char* figure, std::uint64_t count) {
      verdict[figure] = verdict[figure].get<std::uint64_t>() - count;
    };
    leave_out("decided_contacts", contacts);
    leave_out("decided_touching", touching - touching_within);
    leave_out("decided_separations", outside - contacts);
    leave_out("decided", outside);
  }
  return record;
}

// `published` without any wrong answer.
inline Json without_errors(Json record) {
  for (Json& family : record["kernels"][0]["families"]) {
    Json& verdict = family["verdict"];
    for (const char* member : {"false_separation", "false_contact", "undecided", "invalid", "unanswered"})
      verdict[member] = 0;
    for (const char* member : {"deepest", "deepest_false_separation", "deepest_false_contact",
                               "farthest_false_separation", "farthest_false_contact"})
      verdict[member] = 0.0;
    for (Json& comparison : family["comparisons"]) {
      for (const char* member : {"false_separation", "missed_separation", "tolerance_failures", "range_events"}) {
        if (!comparison[member].is_null()) comparison[member] = 0;
      }
    }
  }
  return record;
}

// For tests: the stored run as one of moving-sphere.

// A number beside so many contacts, the same ones in each record, and beside no other answer.
inline Json given_beside(std::uint64_t contacts) {
  const std::string which = contacts == 0 ? "" : fmt::format("{:x}", contacts);
  return {{"contacts", contacts}, {"separations", 0}, {"which_contacts", which}, {"which_separations", ""}};
}

// A family's first contacts, on 900 that are right: so many times are late, with these deepest tunnels.
inline Json contacts(std::uint64_t late, double late_tunnel, double missed_tunnel) {
  const auto tunnels = [](double deepest) {
    return Json{{"through", deepest == 1 ? 3 : 0}, {"deepest_tunnel", deepest}};
  };
  const Json none = {{"largest_ulps", 0},
                     {"largest_in_u", 0},
                     {"largest_share", 0.0},
                     {"largest_length", 0.0},
                     {"by_power", Json::object()}};
  Json errors = none;
  if (late != 0) {
    errors["largest_ulps"] = errors["largest_in_u"] = 2.5;
    errors["by_power"] = {{"2", late}};
    errors["largest_share"] = 1.5e-7;
    errors["largest_length"] = 0.25;
  }
  Json early = none;
  early["by_power"] = {{"0", 100}};
  return {{"answers", 900},
          {"separations", 0},
          {"decided", 900},
          {"missed", tunnels(missed_tunnel)},
          {"time",
           {{"none", 0},
            {"invalid", 0},
            {"early", 100},
            {"best", 800 - late},
            {"late", late},
            {"given", given_beside(900)},
            {"judged", 900},
            {"late_errors", errors},
            {"late_tunnels", tunnels(late_tunnel)},
            {"early_errors", early},
            {"largest_gap", 0.0}}},
          {"consistency", nullptr},
          {"separation", nullptr},
          {"feature", nullptr},
          {"normal", nullptr},
          {"pushed", nullptr},
          {"point", nullptr},
          {"point_a", nullptr},
          {"point_b", nullptr},
          {"points", nullptr}};
}

// The record with as many contacts that are right as its families say something of: it can be read from a file.
inline Json grown(Json record) {
  for (Json& family : record["kernels"][0]["families"]) {
    Json& verdict = family["verdict"];
    const std::uint64_t more = family["contacts"]["answers"].get<std::uint64_t>() +
                               verdict["false_separation"].get<std::uint64_t>() -
                               verdict["decided_contacts"].get<std::uint64_t>();
    for (Json* count :
         {&family["trials"], &family["truth"]["contact"], &verdict["decided_contacts"], &verdict["decided"]})
      *count = count->get<std::uint64_t>() + more;
  }
  return record;
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
  kernel["families"]["lattice"]["contacts"] = contacts(0, 0, 0);
  Json& lattice = kernel["families"]["lattice"]["verdict"];  // its invalid answer is a separation here
  lattice["invalid"] = 0;
  lattice["decided_separations"] = 198;
  lattice["decided"] = 498;
  Json& tangent = kernel["families"]["tangent"]["contacts"] = on_tangent;
  if (Json& time = tangent["time"]; time.is_object())
    time["judged"] = time["early"].get<int>() + time["best"].get<int>() + time["late"].get<int>();
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
  witness["exact_contact"] = {
      {"time", "0x1p-2"},          {"features", {"vertex_a"}},        {"start", "clear"},          {"after_time", 0.0},
      {"point", {1.0, 0.0, -0.1}}, {"point_from_a", {0.0, 0.0, 0.0}}, {"normal", {-1.0, 0.0, 0.0}}};
  record["witnesses"] = Json::array({witness});
  return record;
}

}  // namespace axiscert
