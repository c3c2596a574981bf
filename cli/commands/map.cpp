#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.h"
#include "cli/commands/run_output.h"
#include "cli/ending.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "exact/judge/oracles.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "plans/given_queries.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"
#include "reports/instrument/map.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"

namespace axiscert {
namespace {

struct MapOptions {
  std::string query, id, kernel, target = "auto", precision = "binary32", along, across, name = "map", out = "out",
                                 format = "text";
  std::vector<std::string> what;
  bool exponents = false;
  std::optional<std::size_t> size;
  std::int64_t ulps = 1;
  AddressFiles files;
};

// The pixels each way of a map with filters, and of one that is drawn by oracles alone.
constexpr std::size_t filtered_size = 256, exact_size = 64;
std::size_t default_size(const StoredQuery& witness) {
  return has_filters(*witness.predicate, witness.entry) ? filtered_size : exact_size;
}

// Throws Error that names the most alike of the ids.
void require_id(const MapOptions& options, const std::vector<StoredQuery>& queries) {
  std::vector<std::string_view> ids;
  for (const StoredQuery& query : queries) ids.push_back(query.id);
  if (std::find(ids.begin(), ids.end(), options.id) != ids.end()) return;
  constexpr std::size_t most_ids = 8;
  std::vector<std::string_view> nearest = most_alike_first(options.id, ids);
  nearest.resize(std::min(nearest.size(), most_ids));
  throw Error(fmt::format("--id {}: unknown{} of the {} ids of {} the nearest are: {}", options.id,
                          did_you_mean(options.id, ids), ids.size(), options.query, fmt::join(nearest, ", ")));
}

// The query of the file, or the one that --id chooses.
StoredQuery witness_of(const MapOptions& options) {
  std::vector<StoredQuery> queries = queries_given({options.query}, options.precision, options.files);
  if (!options.id.empty()) {
    require_id(options, queries);
    std::erase_if(queries, [&](const StoredQuery& q) { return q.id != printable_line(options.id); });
  }
  if (queries.size() != 1) {
    throw Error(fmt::format("{}: {} queries{}; a map is drawn around one query: choose it with --id", options.query,
                            queries.size(), options.id.empty() ? "" : " of the id '" + options.id + "'"));
  }
  const StoredQuery& only = queries.front();
  const bool valid = std::visit(
      [&](const auto& q) { return oracles_of(*only.predicate, only.entry).truth(q).verdict != Verdict::invalid; },
      only.numbers);
  if (!valid) throw Error(fmt::format("query '{}': not a valid query to draw a map around", queries.front().id));
  return queries.front();
}

std::vector<MapSubject> subjects_of(const MapOptions& options, const Kernel& kernel) {
  std::vector<MapSubject> all = map_subjects(*kernel.predicate);
  if (!has_comparison_maps(kernel)) all.resize(1);
  if (options.what.empty()) return all;
  std::vector<std::string_view> names;
  for (const MapSubject& subject : all) names.push_back(name(subject, *kernel.predicate));
  for (const std::string& what : options.what) {
    if (std::find(names.begin(), names.end(), what) != names.end()) continue;
    throw Error(fmt::format("--what {}: unknown{} kernel {} has maps of: {}", what, did_you_mean(what, names),
                            kernel.id, fmt::join(most_alike_first(what, names), ", ")));
  }
  std::erase_if(all, [&](const MapSubject& subject) {
    return std::find(options.what.begin(), options.what.end(), name(subject, *kernel.predicate)) == options.what.end();
  });
  return all;
}

// The numbers that move where none are given: a.x and r, or the first numbers of an entry's first two groups that have
// a place and a length; of an entry without a length, of the first two.
struct DefaultSides {
  std::string along, across;
};
DefaultSides default_sides(const PredicateEntry& entry) {
  std::vector<std::string> places, lengths;
  for (const ColumnGroup& group : groups_of(entry)) {
    const std::string first = std::string(group.name) + (group.size == 3 ? ".x" : "");
    const Role role = entry.columns[group.first].role;
    if (role == Role::coordinate) places.push_back(first);
    if (role == Role::length) lengths.push_back(first);
  }
  return {places.at(0), lengths.empty() ? places.at(1) : lengths.front()};
}

Plane plane_of(const MapOptions& options, const StoredQuery& witness) {
  const auto given = [&](const std::string& text, const std::string& otherwise) {
    return parse_numbers(text.empty() ? otherwise : text, witness.columns());
  };
  const DefaultSides sides = default_sides(witness.columns());
  const MovedNumbers across = given(options.across, sides.across);
  if (!options.exponents) {
    return ulp_plane(given(options.along, sides.along), across, options.size.value_or(default_size(witness)),
                     options.ulps);
  }
  const MovedNumbers along = given(options.along, "scene");
  return std::visit(
      [&](const auto& q) {
        const std::size_t most = has_filters(*witness.predicate, witness.entry) ? greatest_map : exact_size;
        return exponent_plane(q, along, across, options.size.value_or(most));
      },
      witness.numbers);
}

std::string command_of(const MapOptions& options, const MapPlan& plan) {
  std::string command = "axiscert map " + shell_word(options.query);
  const auto add_file = [&](const char* option, const std::string& file) {
    if (!file.empty()) command += fmt::format(" {} {}", option, shell_word(file));
  };
  add_file("--mesh", options.files.mesh);
  add_file("--queries", options.files.queries);
  add_file("--corpus", options.files.corpus);
  if (!options.id.empty()) command += " --id " + shell_word(options.id);
  if (options.precision != MapOptions().precision) command += " --precision " + options.precision;
  if (options.target != MapOptions().target) command += " --target " + options.target;
  command += fmt::format(" --kernel {} --along {} --across {}", shell_word(plan.kernel->id),
                         plan.plane.along.numbers.name, plan.plane.across.numbers.name);
  if (options.exponents) command += " --exponents";
  else command += fmt::format(" --ulps {}", options.ulps);
  if (options.size || !options.exponents) {
    command += fmt::format(" --size {}", options.size.value_or(default_size(plan.witness)));
  }
  for (const std::string& what : options.what) command += " --what " + what;
  return command + " --name " + options.name;
}

int draw(const MapOptions& options) {
  const StoredQuery witness = witness_of(options);
  const Kernel& kernel =
      options.kernel.empty() ? default_kernel(*witness.predicate, witness.entry) : find_kernel(options.kernel);
  require_loaded(kernel);
  print_first_look(kernel);
  if (kernel.predicate != witness.predicate || kernel.entry != witness.entry) {
    throw Error(fmt::format(
        "query '{}' is of the predicate {}, and kernel {} of {}; give a kernel of its predicate with --kernel",
        witness.id, witness.predicate->id, kernel.id, kernel.predicate->id));
  }
  if (!kernel.has(witness.precision)) {
    throw Error(fmt::format("query '{}' is in {}, in which kernel {} does not exist", witness.id,
                            name(witness.precision), kernel.id));
  }
  const MapPlan plan{&kernel, resolve_target(options.target), witness, plane_of(options, witness),
                     subjects_of(options, kernel)};
  const std::string folder = (std::filesystem::path(options.out) / "maps").string();
  const OutputFolder writable(folder);  // checked before anything runs
  require_uncontracted(plan.target);
  keep_nothing(fmt::format(
      "map keeps nothing of a part of its pictures; --size {} draws a quarter of the pixels{}",
      std::max<std::size_t>(2, std::max(plan.plane.columns(), plan.plane.rows()) / 2),
      plan.subjects.size() == 1 ? "" : fmt::format(", and --what fewer than these {} pictures", plan.subjects.size())));
  const std::vector<MapPicture> pictures =
      with_progress("map", [&](const ShowProgress& show) { return draw_map(plan, show); });
  const MapData map = map_data(options.name, plan, pictures, command_of(options, plan));
  const auto index = std::filesystem::path(folder) / map_index_file;
  write_files(folder, map_files(map, plan, pictures, std::filesystem::exists(index) ? read_bytes(index.string()) : ""));
  fmt::print("{}", options.format == "text" ? map_text(map) : data_text(index_of({map}), options.format));
  if (options.format == "text") fmt::print("{} pictures and {} in {}\n", pictures.size(), map_index_file, folder);
  const bool shows_all =
      std::ranges::all_of(pictures, [](const MapPicture& picture) { return picture.decided() != 0; });
  return shows_all ? exit_done : exit_requirement_failed;
}

}  // namespace

void add_map(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "map",
      "Draw where a kernel is wrong around a query: a plane through query space, one ulp or exponent for each pixel");
  auto options = std::make_shared<MapOptions>();
  MapOptions& o = *options;
  command->add_option("QUERY", o.query, "query file (- for standard input) or address")->required()->check(no_kernel());
  command->add_option("--id", o.id, "id of the query in the file");
  add_kernel(*command, o.kernel, "kernel that is asked", "the first of the query's predicate and entry");
  command->add_option(
      "--along", o.along,
      "the number that changes to the right: a.x ... p.z, d.x ... d.z, r, of boxes a.m.x ... b.s.z (default: the "
      "first); with --exponents also a, b, c, p, d, triangle, scene (default: scene)");
  command->add_option("--across", o.across, "the number that changes upwards (default: r, or the first half extent)");
  auto* exponents = command->add_flag("--exponents", o.exponents, "every power of two instead of ulps");
  command
      ->add_option(
          "--size", o.size,
          fmt::format("pixels each way (default: {}; with --exponents at most these, default: {}; of a predicate "
                      "other than {} {})",
                      filtered_size, greatest_map, ids_of(predicates_with(has_filters)), exact_size))
      ->check(whole_number(2, greatest_map));
  command->add_option("--ulps", o.ulps, "ulps from pixel to pixel")
      ->check(whole_number(1, greatest_ulps))
      ->excludes(exponents)
      ->capture_default_str();
  command->add_option("--what", o.what, "verdict, an axis or a comparison, repeatable (default: all)")
      ->allow_extra_args(false);
  command->add_option("--name", o.name, "name of the map: its pictures are OUT/maps/NAME-WHAT.png")
      ->capture_default_str();
  add_target(*command, o.target);
  add_precision(*command, o.precision, of_csv_files);
  add_address_files(*command, o.files);
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, o.format, data_formats);
  add_out(*command, o.out, "maps/, where the pictures are");
  add_examples(*command, {{"The first number of A to the right, the radius upwards",
                           "axiscert map mine.jsonl published --along a.x --across r --size 32"},
                          {"Over which scales is the verdict right?",
                           "axiscert map mine.jsonl published --exponents --what verdict"}});
  command->callback([&action, options] { action = [options] { return draw(*options); }; });
}

}  // namespace axiscert
