#include "reports/run_folder/attachments.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "reports/page/encoding.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

using Path = std::filesystem::path;

Error bad_form(const Path& file, const std::string& what) {
  return Error(fmt::format("{}: {}; write it again with the command that made it, or remove it", file.string(), what));
}

// The first of these members that exists, or null.
Json first_of(const Json& from, std::initializer_list<const char*> members) {
  for (const char* member : members) {
    if (from.contains(member)) return from[member];
  }
  return nullptr;
}

// The array of objects that a file is, or that it holds under one of these names.
const Json& rows_of(const Path& file, const Json& whole, std::initializer_list<const char*> members) {
  const Json* rows = whole.is_array() ? &whole : nullptr;
  for (const char* member : members) {
    if (!rows && whole.is_object() && whole.contains(member)) rows = &whole[member];
  }
  if (!rows || !rows->is_array()) throw bad_form(file, fmt::format("has no array \"{}\"", *members.begin()));
  for (const Json& row : *rows) {
    if (!row.is_object())
      throw bad_form(file, fmt::format("\"{}\" has an element that is not an object", *members.begin()));
  }
  return *rows;
}

Json picked(const Json& from, std::initializer_list<const char*> members) {
  Json some = Json::object();
  for (const char* member : members) some[member] = first_of(from, {member});
  return some;
}

std::string bytes_of(const Path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in) throw Error(fmt::format("{}: cannot be read", file.string()));
  return bytes.str();
}

// A picture's path in maps/; its name may be only that of a file there.
std::string picture_file(const Path& index, const Json& picture) {
  const std::string name = picture.value("file", "");
  if (name.empty() || name.find_first_of("/\\") != name.npos || name.starts_with('.'))
    throw bad_form(index, fmt::format("\"{}\" is not the name of a file in maps/", name));
  return "maps/" + name;
}

Json maps_data(const Path& index, std::size_t room) {
  const Json whole = read_json(index);
  Json data = {{"legend", rows_of(index, whole, {"legend"})}, {"maps", Json::array()}};
  for (const Json& map : rows_of(index, whole, {"maps"})) {
    Json& shown = data["maps"].emplace_back(
        picked(map, {"name", "kernel", "precision", "kind", "along", "across", "command", "witness"}));
    shown["pictures"] = Json::array();
    for (const Json& picture : rows_of(index, map, {"pictures"})) {
      Json& drawn = shown["pictures"].emplace_back(picked(picture, {"level", "name", "counts"}));
      drawn["file"] = picture_file(index, picture);
      drawn["image"] = nullptr;
    }
  }
  for (const bool comparisons : {false, true}) {
    for (Json& map : data["maps"]) {
      for (Json& picture : map["pictures"]) {
        if ((picture["level"] == "comparison") != comparisons) continue;
        const std::string image = bytes_of(index.parent_path().parent_path() / picture["file"].get<std::string>());
        picture["bytes"] = image.size();
        if (image.size() > room) continue;
        room -= image.size();
        picture["image"] = "data:image/png;base64," + base64(image);
      }
    }
  }
  return data;
}

Json proofs_data(const Path& file) {
  const Json whole = read_json(file);
  Json data = {{"comparisons", Json::array()},
               {"checkers", whole.is_object() ? first_of(whole, {"checkers", "versions"}) : Json()}};
  for (const Json& row : rows_of(file, whole, {"comparisons", "bounds", "proofs"})) {
    // The bars show the scaled domain, that of `axiscert search`.
    if (const Json domain = first_of(row, {"domain"}); !domain.is_null() && domain != "scaled") continue;
    data["comparisons"].push_back({{"name", first_of(row, {"name", "comparison"})},
                                   {"formulae", first_of(row, {"formulae", "kernel"})},
                                   {"precision", first_of(row, {"precision"})},
                                   {"arithmetic", first_of(row, {"arithmetic"})},
                                   {"status", first_of(row, {"status"})},
                                   {"proved_u", first_of(row, {"proved_u", "bound_u", "bound"})},
                                   {"attained_u", first_of(row, {"attained_u", "attained"})},
                                   {"file", first_of(row, {"file"})}});
  }
  return data;
}

// Whether no query of a mutant's precision was valid.
bool was_not_judged(const Json& mutation, const Json& mutant) {
  const std::string precision = mutant.value("precision", "");
  return mutation.is_object() && mutation.value("score", Json::object())
                                         .value(precision, Json::object())
                                         .value("not_judged", std::uint64_t{0}) != 0;
}

Json mutation_data(const Path& file) {
  const Json whole = read_json(file);
  Json data = whole.is_object() ? picked(whole, {"command", "kernel", "complete"}) : Json::object();
  data["mutants"] = data["controls"] = Json::array();
  for (const Json& row : rows_of(file, whole, {"mutants"})) {
    // The family and the number of queries at which it was caught, or null; or whether it was caught, with the rest
    // next to it.
    const Json caught = first_of(row, {"caught"});
    const Json& catch_of = caught.is_object() ? caught : row;
    const bool is_caught = caught.is_object() || caught == true;
    data["mutants"].push_back({{"name", first_of(row, {"id", "name"})},
                               {"precision", first_of(row, {"precision"})},
                               {"caught", !is_caught && was_not_judged(whole, row) ? Json(nullptr) : Json(is_caught)},
                               {"family", first_of(catch_of, {"family"})},
                               {"queries", first_of(catch_of, {"queries"})},
                               {"equivalent", first_of(row, {"equivalent"})}});
  }
  if (whole.is_object() && whole.contains("controls")) {
    for (const Json& row : rows_of(file, whole, {"controls"}))
      data["controls"].push_back(picked(row, {"kernel", "precision", "claims", "queries", "flagged"}));
  }
  return data;
}

Json search_data(const Path& file) {
  const Json whole = read_json(file);
  Json data = picked(whole, {"kernel", "precision", "evaluations", "seed"});
  data["comparisons"] = Json::array();
  for (const Json& row : rows_of(file, whole, {"comparisons"})) {
    data["comparisons"].push_back(picked(row, {"name", "attained_u", "proved_u", "relative_u", "witness"}));
  }
  return data;
}

Json ladder_data(const Path& file) {
  const Json whole = read_json(file);
  Json data = picked(whole, {"precision", "seed", "trials", "speed"});
  data["kernels"] = Json::array();
  for (const Json& row : rows_of(file, whole, {"kernels"})) {
    Json& kernel = data["kernels"].emplace_back(picked(row, {"id", "summary", "windows"}));
    const Json families = row.value("families", Json::object());
    for (const auto& [family, result] : families.items()) {
      Json& shown = kernel["families"][family] = picked(result, {"queries", "verdict"});
      const Json axes = result.value("axes", Json::object());
      for (const auto& [axis, figures] : axes.items())
        shown["axes"][axis] = picked(figures, {"false_separation", "missed_separation", "p99_u", "worst_u"});
    }
  }
  return data;
}

Json precision_data(const Path& file) {
  const Json whole = read_json(file);
  Json data = picked(whole, {"precision", "command"});
  data["kernels"] = Json::object();
  if (!whole.contains("all") || !whole["all"].contains("kernels"))
    throw bad_form(file, "has no \"all\" with \"kernels\"");
  data["queries"] = first_of(whole["all"], {"queries"});
  for (const auto& [id, kernel] : whole["all"]["kernels"].items()) {
    for (const Json& at : rows_of(file, kernel, {"precisions"})) {
      const auto wrong = [&](const char* range) {
        const Json& verdict = at.at(range).at("verdict");
        return verdict.at("false_separation").get<std::uint64_t>() + verdict.at("false_contact").get<std::uint64_t>();
      };
      data["kernels"][id].push_back({at.at("bits"), wrong("unlimited"), wrong("limited")});
    }
  }
  return data;
}

Json league_data(const Path& file) {
  const Json whole = read_json(file);
  Json data = {{"kernels", Json::array()}, {"not_checked", first_of(whole, {"not_checked"})}};
  for (const Json& row : rows_of(file, whole, {"kernels"})) {
    Json total = picked(row, {"id", "precision", "summary", "touching", "has_planted_fault", "ns"});
    for (const char* count : {"trials", "decided", "undecided", "invalid", "unanswered", "outside_limits"}) {
      std::uint64_t sum = 0;
      for (const Json& family : row.at("families")) sum += family.at(count).get<std::uint64_t>();
      total[count] = sum;
    }
    // Null where every family has null: not measured.
    for (const char* kind : {"false_separation", "false_contact"}) {
      const std::string depth = fmt::format("deepest_{}", kind);
      Json sum, deepest;
      for (const Json& family : row.at("families")) {
        if (const Json& count = family.at(kind); !count.is_null())
          sum = (sum.is_null() ? 0 : sum.get<std::uint64_t>()) + count.get<std::uint64_t>();
        if (const Json& here = family.at(depth); !here.is_null())
          deepest = deepest.is_null() ? here : std::max(deepest, here);
      }
      total[kind] = std::move(sum);
      total[depth] = std::move(deepest);
    }
    std::uint64_t first = 0;
    for (const auto& [name, family] : row.at("families").items()) {
      const Json& after = family.at("caught_after");
      if (after.is_null() || (first != 0 && after >= first)) continue;
      first = after;
      total["caught_by"] = name;
    }
    total["caught_after"] = first == 0 ? Json(nullptr) : Json(first);
    data["kernels"].push_back(std::move(total));
  }
  return data;
}

}  // namespace

Json attachments(const std::filesystem::path& folder, std::size_t image_bytes) {
  Json data = Json::object();
  const auto attach = [&](const char* kind, const char* name, auto&& read) {
    const Path file = folder / name;
    std::error_code ignored;
    data[kind] = nullptr;
    if (folder.empty() || !std::filesystem::exists(file, ignored)) return;
    try {
      data[kind] = read(file);
    } catch (const Json::exception& problem) {
      throw bad_form(file, problem.what());
    }
  };
  attach("maps", "maps/index.json", [&](const Path& index) { return maps_data(index, image_bytes); });
  attach("proofs", "proofs.json", proofs_data);
  attach("mutation", "mutation.json", mutation_data);
  attach("search", "search.json", search_data);
  attach("ladder", "ladder.json", ladder_data);
  attach("precision", "precision.json", precision_data);
  attach("league", "league.json", league_data);
  return data;
}

}  // namespace axiscert
