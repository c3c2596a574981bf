#include "examples/character/command.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/files/query_file.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/registry/self_check.h"
#include "reports/instrument/instrument.h"

namespace axiscert::character {
namespace {

constexpr double character_share = 64, bullet_share = 4096;  // of the diagonal of the mesh's box
constexpr std::array<std::string_view, 3> sweep_kernels = {"moving-sphere/twenty-nonstrict", "moving-sphere/rounded",
                                                           "moving-sphere/physx5"};

JourneyOptions journey_options(const Options& options, const Mesh& mesh) {
  const auto found = std::ranges::find(errand_names, options.sweep);
  const auto errand = static_cast<Errand>(found - errand_names.begin());
  const float radius = radius_of(options, mesh, errand == Errand::bullet ? bullet_share : character_share);
  return {errand, options.seed, options.steps, radius, options.stride, options.skin};
}

// "2000 steps, each of 0.5 radii"
std::string errand_words(const JourneyOptions& options) {
  switch (options.errand) {
    case Errand::walk:
      return fmt::format("walks {} steps of {} radii by sweeps", options.steps, options.stride);
    case Errand::fall:
      return fmt::format("falls {} times", options.steps);
    case Errand::bullet:
      return fmt::format("is shot {} times", options.steps);
  }
  return "";
}

// Every motion of the journey with every triangle that the broad phase left for it, as lines of a query file.
void write_sweeps(Out& out, const World& world, const Journey& journey) {
  out.begin();
  for (std::size_t m = 0; m < journey.motions.size(); ++m) {
    const Motion& motion = journey.motions[m];
    for (std::size_t i = motion.first; i < motion.first + motion.count; ++i) {
      const std::uint32_t t = journey.triangles[i];
      const StoredQuery query{fmt::format("{}-{}-{}", purpose_names[static_cast<std::size_t>(motion.purpose)], m, t),
                              Precision::binary32, Numbers<float>(world.query(motion.from, motion.by, t)),
                              &moving_sphere_predicate()};
      out.write(query_line(query) + "\n");
    }
  }
  out.end();
}

}  // namespace

int run_sweeps(const Options& options) {
  require_uncontracted(resolve_target("auto"));
  std::string not_checked;
  const std::vector<const Kernel*> kernels = kernels_of(options, moving_sphere_predicate(), sweep_kernels, not_checked);
  Mesh mesh = load_mesh(options.mesh, read_bytes(options.mesh).size());
  const JourneyOptions how = journey_options(options, mesh);
  const std::string words = mesh_words(options, mesh);
  const std::size_t up = options.up.empty() ? thinnest_axis(mesh.triangles) : std::size_t(options.up[0] - 'x');
  const Ground ground(std::move(mesh.triangles), up);
  std::optional<Out> queries = out_of("--queries", options.queries);

  std::vector<std::unique_ptr<Sweeper>> sweepers;
  sweepers.push_back(certain_sweeper());
  for (const Kernel* kernel : kernels) sweepers.push_back(sweeper_by(*kernel, options.skin * double(how.radius)));
  std::vector<TravelledSweep> travelled;
  for (const auto& sweeper : sweepers) {
    const Journey made = journey(ground, *sweeper, how);
    const World world{ground, made.grid, how.radius};
    travelled.push_back({sweeper->name(), made.turns, made.set_down, made.left, judged(world, made, sweeper->kernel()),
                         sweeper->kernel() != nullptr && sweeper->kernel()->measure_count > 0});
    if (queries && sweeper == sweepers.front()) write_sweeps(*queries, world, made);
  }
  fmt::print("{}; a sphere of radius {} {}, {} up, seed {}\n\n{}{}", words, how.radius, errand_words(how), "xyz"[up],
             options.seed, sweeps_table(travelled, how), not_checked);
  return 0;
}

namespace {

using Row = std::vector<std::string>;

std::string text(std::uint64_t n) { return fmt::format("{}", n); }

}  // namespace

std::string sweeps_table(std::span<const TravelledSweep> travelled, const JourneyOptions& options) {
  const bool walks = options.errand == Errand::walk;
  std::vector<Row> motions, answers, entered, rates;
  for (const TravelledSweep& t : travelled) {
    const SweepCounts& c = t.counts;
    Row row{t.sweeper, text(c.motions), text(c.stopped), text(c.triangles), text(c.contacts)};
    if (walks) {
      for (const std::uint64_t n : {t.turns, t.set_down, t.left}) row.push_back(text(n));
    }
    motions.push_back(row);
    const auto time = [&](std::uint64_t n) { return t.gives_times ? text(n) : std::string("-"); };
    answers.push_back({t.sweeper, text(c.missed), text(c.phantom), time(c.late), time(c.without_time)});
    entered.push_back({t.sweeper, text(c.entered), text(c.sunk), text(c.through),
                       c.deepest.is_zero() ? "-" : fmt::format("{:.2e}", c.deepest.value())});
    const auto rate = [&](std::uint64_t n) {
      return fmt::format("{:.2f}", 1000.0 * static_cast<double>(n) / static_cast<double>(options.steps));
    };
    rates.push_back({t.sweeper, rate(c.missed), rate(c.phantom), t.gives_times ? rate(c.late) : "-", rate(c.entered),
                     rate(c.sunk), rate(c.through)});
  }
  Row columns{"sphere moved by", "motions", "stopped", "triangles", "contacts"};
  if (walks) columns.insert(columns.end(), {"turned", "set down", "left"});
  return aligned_table(columns, motions) + "\n" +
         aligned_table({"answers of", "missed", "phantom", "late", "no time"}, answers) + "\n" +
         aligned_table({"motions by", "entered", "sunk", "through", "deepest"}, entered) + "\n" +
         aligned_table({"per 1000 steps", "missed", "phantom", "late", "entered", "sunk", "through"}, rates);
}

}  // namespace axiscert::character
