#include "plans/plan_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "fuzz/confirm/record.h"
#include "fuzz/files/corpus.h"
#include "fuzz/instruments/effort.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "plans/predicate_options.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

constexpr const char* plan_schema = "axiscert-plan/2";

// Calls visit(name, member) with each option that a record depends on.
template <class Options, class Visit>
void for_each_option(Options& o, Visit&& visit) {
  visit("predicate", o.predicate);
  visit("kernels", o.kernels);
  visit("families", o.families);
  visit("meshes", o.meshes);
  visit("queries", o.queries);
  visit("corpus", o.corpus);
  visit("trials", o.trials);
  visit("seed", o.seed);
  visit("precision", o.precision);
  visit("tolerances", o.tolerances);
}

// Those of `axiscert certify`, which a plan without an effort does not have.
template <class Options, class Visit>
void for_each_option_of_effort(Options& o, Visit&& visit) {
  visit("effort", o.effort);
  visit("is_slow", o.is_slow);
}

template <class Value>
void put(Json& json, const Value& value) {
  json = value;
}
template <class Value>
void put(Json& json, const std::optional<Value>& value) {
  if (value) json = *value;
}
template <class Value>
void get(const Json& json, Value& value) {
  if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) value = whole_number<Value>(json);
  else json.get_to(value);
}
template <class Value>
void get(const Json& json, std::optional<Value>& value) {
  if (!json.is_null()) get(json, value.emplace());
}
template <class Value>
void get_member(const Json& object, const char* name, Value& value) {
  try {
    get(object.at(name), value);
  } catch (const std::exception& wrong) {  // Json::exception, or whole_number's Error
    throw Error(fmt::format("'{}': {}", name, wrong.what()));
  }
}

// Levels: one as text, several as a list; none as an empty text.
void put_required(Json& options, const RunRequirements& required) {
  const std::vector<std::string>& levels = required.levels;
  options["require"] = levels.empty() ? Json("") : levels.size() == 1 ? Json(levels.front()) : Json(levels);
  if (!required.allow_unchecked.empty()) options["allow_unchecked"] = required.allow_unchecked;
  if (!required.unit.empty()) options["unit"] = required.unit;
}
void get_required(const Json& options, RunRequirements& required) {
  if (!options.at("require").is_string()) get_member(options, "require", required.levels);
  else if (const std::string level = options["require"]; !level.empty()) required.levels = {level};
  if (options.contains("allow_unchecked")) get_member(options, "allow_unchecked", required.allow_unchecked);
  if (options.contains("unit")) get_member(options, "unit", required.unit);
}

std::string digest_of(Json json) {
  json.erase("digest");
  const std::string text = json.dump();
  return sha256_hex(std::as_bytes(std::span(text)));
}

// Replaces each file that does not exist by the file of the same base name next to the plan, where that exists.
void look_beside(const std::string& plan_path, std::vector<std::string>& files) {
  for (std::string& file : files) {
    const auto beside = std::filesystem::path(plan_path).parent_path() / std::filesystem::path(file).filename();
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored) && std::filesystem::exists(beside, ignored)) file = beside.string();
  }
}

}  // namespace

std::string PlanFile::text() const { return json.dump(1) + "\n"; }

PlanFile plan_file_of(const RunOptions& given, std::optional<std::uint64_t> units_each) {
  for (const std::string& path : given.queries) {
    if (path == "-") throw Error("--queries -: standard input cannot be read again; give a file");
  }
  const Plan plan = plan_of(given);
  RunOptions options = given;
  options.predicate = plan.questions.predicate().id;
  const Stretches stretches(plan.questions, units_each ? *units_each : Stretches::default_units_each(plan.questions));
  PlanFile file{"the plan", {}, {}, options, stretches.units_each()};
  for (const auto* files : {&options.meshes, &options.queries}) {
    for (const std::string& path : *files) require_utf8(path, "file");
  }
  if (options.corpus) require_utf8(*options.corpus, "--corpus");
  Json stored = Json::object();
  for_each_option(options, [&](const char* name, const auto& value) { put(stored[name], value); });
  if (!options.effort.empty()) {
    for_each_option_of_effort(options, [&](const char* name, const auto& value) { put(stored[name], value); });
  }
  put_required(stored, options.required);
  file.json = {{"schema", plan_schema},
               {"plan", json_of(plan_record(plan, options.required))},
               {"options", stored},
               {"queries", stretches.queries()},
               {"units", stretches.units()},
               {"units_per_stretch", stretches.units_each()},
               {"stretches", stretches.count()}};
  file.digest = digest_of(file.json);
  file.json["digest"] = file.digest;
  return file;
}

PlanFile read_plan_file(const std::string& path) {
  PlanFile file{path, {}, {}, {}, 1};
  try {
    file.json = parsed_json(read_bytes(path));
  } catch (const Json::exception&) {
    // null: no plan, reported below
  }
  const Json& json = file.json;
  if (!json.is_object() || !json.contains("schema")) {
    throw Error(fmt::format("{}: not a plan, or cut off: `axiscert plan -o {}` writes one", path, path));
  }
  if (json["schema"] != plan_schema) {
    throw Error(
        fmt::format("{}: its schema is {}, but this axiscert reads \"{}\"; write it again with `axiscert plan -o {}`",
                    path, shown(json["schema"].dump()), plan_schema, path));
  }
  file.digest = digest_of(json);
  if (const Json digest = json.value("digest", Json()); digest != file.digest) {
    throw Error(
        fmt::format("{}: changed after it was written: its digest is {}, but it states {}; write a new plan with "
                    "`axiscert plan`",
                    path, file.digest, shown(digest.dump())));
  }
  try {
    const Json& options = json.at("options");
    for_each_option(file.options, [&](const char* name, auto& value) { get_member(options, name, value); });
    if (options.is_object() && options.contains("effort")) {
      for_each_option_of_effort(file.options, [&](const char* name, auto& value) { get_member(options, name, value); });
    }
    get_required(options, file.options.required);
    get_member(json, "units_per_stretch", file.units_each);
    std::uint64_t counted;  // computed again where the plan is taken
    for (const char* count : {"queries", "units", "stretches"}) get_member(json, count, counted);
    if (!json.at("plan").is_object()) throw Error("'plan' is not an object");
  } catch (const std::exception& wrong) {
    throw Error(fmt::format("{}: does not conform to {}: {}", path, plan_schema, wrong.what()));
  }
  if (file.units_each == 0) throw Error(fmt::format("{}: a stretch has at least one unit, not 0", path));
  return file;
}

Plan plan_of(const PlanFile& file) {
  RunOptions options = file.options;
  look_beside(file.path, options.meshes);
  look_beside(file.path, options.queries);
  Plan plan = plan_of(options);
  const std::string differs = difference(json_of(plan_record(plan, options.required)), file.json["plan"]);
  if (!differs.empty()) {
    throw Error(
        fmt::format("{}: cannot be run as planned: here {}; write a new plan, or use the axiscert and the "
                    "files that it was written with",
                    file.path, differs));
  }
  return plan;
}

std::string difference(const Json& plan, const Json& expected) {
  const Json here = plan.flatten(), there = expected.flatten();
  const auto value = [](const Json& flat, const std::string& key) {
    return flat.contains(key) ? flat[key].dump() : "missing";
  };
  for (const Json* flat : {&there, &here}) {
    for (const auto& [key, ignored] : flat->items()) {
      const std::string is = value(here, key), expected_to_be = value(there, key);
      if (is != expected_to_be)
        return fmt::format("{} is {}, not {}", key.empty() ? "the plan" : key.substr(1), shown(is),
                           shown(expected_to_be));
    }
  }
  return here == there ? "" : "the order of its members differs";
}

namespace {

std::vector<std::string> measured_beside(const Predicate& predicate, std::size_t entry, const std::string& kernel) {
  std::vector<std::string> ids = {default_kernel(predicate, entry).id};
  if (!predicate.certified.empty()) ids.emplace_back(predicate.certified);
  std::erase(ids, kernel);
  std::erase_if(ids, [&](const std::string& id) { return find_kernel(id).entry != entry; });
  return ids;
}

// `kernels`: of this predicate and entry.
RunOptions certified_options(const CertifiedRun& run, const Predicate& predicate, std::size_t entry,
                             const std::vector<std::string>& kernels, bool is_slow) {
  RunOptions options;
  options.kernels = kernels;
  options.families = {"all"};
  options.meshes = run.meshes;
  const auto is_of_kernel = [&](const CorpusEntry& known) {
    return known.stored.predicate == &predicate && known.stored.entry == entry;
  };
  if (std::ranges::any_of(read_corpus(default_corpus_folder()), is_of_kernel)) options.corpus = default_corpus_folder();
  options.seed = run.seed;
  options.effort = run.effort;
  options.is_slow = is_slow;
  options.threads = run.threads;
  return options;
}

}  // namespace

PlanFile certified_plan(const CertifiedRun& run) {
  const Kernel& kernel = find_kernel(run.kernel);
  require_loaded(kernel);
  parse_effort(run.effort);
  std::vector<std::string> kernels = {run.kernel};
  for (const std::string& id : measured_beside(*kernel.predicate, kernel.entry, kernel.id)) kernels.push_back(id);
  return plan_file_of(certified_options(run, *kernel.predicate, kernel.entry, kernels, !kernel.file.empty()),
                      std::nullopt);
}

PlanOfAbsent certified_plan_of(const CertifiedRun& run, const AbsentKernel& kernel) {
  const std::vector<std::string> yardsticks = measured_beside(*kernel.predicate, kernel.entry, run.kernel);
  std::vector<std::string> run_here = yardsticks;
  if (run_here.empty())
    run_here = {default_kernel(*kernel.predicate, kernel.entry).id};  // in place of the one that is absent
  Plan plan = plan_of(certified_options(run, *kernel.predicate, kernel.entry, run_here, kernel.is_slow));
  plan.questions.precisions.clear();
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const bool has = std::ranges::find(kernel.precisions, precision) != kernel.precisions.end();
    if (has || std::ranges::any_of(yardsticks, [&](const std::string& id) { return find_kernel(id).has(precision); }))
      plan.questions.precisions.push_back(precision);
  }
  Json json = json_of(plan_record(plan));
  json["kernels"] = yardsticks;
  json["kernels"].insert(json["kernels"].begin(), run.kernel);
  return {std::move(plan.questions), std::move(json)};
}

}  // namespace axiscert
