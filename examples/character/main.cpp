// character MESH: a sphere walks over a mesh by the certified predicate; other kernels are asked about the same
// spheres.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>

#include "examples/character/command.h"
#include "examples/character/comparison.h"
#include "examples/character/journey.h"
#include "examples/character/options.h"
#include "examples/character/picture.h"
#include "fuzz/files/query_file.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::character {
namespace {

constexpr double walk_share = 64;  // of the diagonal of the mesh's box
constexpr std::array<std::string_view, 2> walk_kernels = {"published", "peer/bullet"};

// Every sphere with every triangle that the broad phase left for it, in the order of the walk, as lines of a query
// file.
void write_queries(Out& out, const Ground& ground, const Walk& walk) {
  out.begin();
  for (std::size_t a = 0; a < walk.asks.size(); ++a) {
    const Ask& ask = walk.asks[a];
    const std::string_view moment = moment_names[static_cast<std::size_t>(ask.moment)];
    for (std::size_t i = ask.first; i < ask.first + ask.count; ++i) {
      const std::uint32_t t = walk.triangles[i];
      const std::string id = fmt::format("{}-{}-{}", moment, a, t);
      out.write(query_line({id, Precision::binary32, Numbers<float>(ground.query(ask.sphere, t)),
                            &sphere_triangle_predicate()}) +
                "\n");
    }
  }
  out.end();
}

// Accepts only digits that fit in 64 bits: CLI11 would read "-1" and 2^64 as the greatest number.
std::string whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_one = error == std::errc() && end == text.data() + text.size();
  return is_one ? "" : fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text);
}

int run(const Options& options) {
  require_uncontracted(resolve_target("auto"));
  std::string not_checked;
  const std::vector<const Kernel*> kernels =
      kernels_of(options, sphere_triangle_predicate(), walk_kernels, not_checked);
  Mesh mesh = load_mesh(options.mesh, read_bytes(options.mesh).size());
  const WalkOptions walk_options{options.seed, options.steps, radius_of(options, mesh, walk_share)};
  const std::string words = mesh_words(options, mesh);
  const std::size_t up = options.up.empty() ? thinnest_axis(mesh.triangles) : std::size_t(options.up[0] - 'x');
  const Ground ground(std::move(mesh.triangles), up);
  std::optional<Out> out = out_of("--out", options.out), queries = out_of("--queries", options.queries);
  const Walk walk = walked(ground, walk_options);
  std::vector<Comparison> comparisons;
  for (const Kernel* kernel : kernels) comparisons.push_back(compared(ground, walk, *kernel));

  const std::string title = fmt::format("{}; a sphere of radius {} takes {} steps, {} up, seed {}", words,
                                        walk_options.radius, walk_options.steps, "xyz"[up], options.seed);
  fmt::print("{}\n{} times turned round, {} times set down\n\n{}{}", title, walk.turns, walk.paths.size(),
             table(ground, walk, comparisons), not_checked);
  if (out) {
    out->begin();
    out->write(picture(ground, walk, comparisons, title));
    out->end();
  }
  if (queries) write_queries(*queries, ground, walk);
  return 0;
}

}  // namespace
}  // namespace axiscert::character

int main(int argc, char** argv) {
  using namespace axiscert;
  character::Options o;
  CLI::App app{
      "A sphere walks and slides over a mesh by the certified predicate, and other kernels are asked about each of its "
      "spheres; with --sweep by motions, beside one that each of the kernels steers."};
  app.add_option("MESH", o.mesh, "file of any format that assimp reads")->required();
  app.add_option("--steps", o.steps, "number of steps, each of half a radius")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--seed", o.seed, "seed of the places where it is set down and of its turns")
      ->check(character::whole_number)
      ->capture_default_str();
  app.add_option("--radius", o.radius, "radius of the sphere (default: a 64th of the diagonal of the mesh's box)");
  app.add_option("--up", o.up, "axis that points up (default: the one along which the mesh is thinnest)")
      ->check(CLI::IsMember({"x", "y", "z"}));
  app.add_option("--kernel", o.kernels,
                 "kernel id from `axiscert kernels`, repeatable (default: published, peer/bullet; with --sweep "
                 "moving-sphere/twenty-nonstrict, moving-sphere/rounded, moving-sphere/physx5)")
      ->allow_extra_args(false);
  app.add_option("--out", o.out, "SVG picture of the walk");
  const auto sweep =
      app.add_option(
             "--sweep", o.sweep,
             "each step is a motion, stopped at the first contact: `walk`; `fall`, from above the mesh to below "
             "it; `bullet`, through it, of a 4096th of the diagonal where no radius is given")
          ->check(
              CLI::IsMember(std::vector<std::string>(character::errand_names.begin(), character::errand_names.end())))
          ->excludes("--out");
  app.add_option("--stride", o.stride, "radii that a step of --sweep walk is long")
      ->check(CLI::Range(0.125, 64.0))
      ->capture_default_str()
      ->needs(sweep);
  app.add_option("--skin", o.skin,
                 "radii that a slide of --sweep leads away from what it met, and a form of engines stops short")
      ->check(CLI::Range(0.0, 0.5))
      ->capture_default_str()
      ->needs(sweep);
  app.add_option("--queries", o.queries,
                 "JSON Lines: every sphere with every triangle that the broad phase left for it, for `axiscert check`, "
                 "`run` and every command that takes a query file");
  app.footer("Exit codes: 0 done; 2 bad usage or input; 3 the exact answers disagree.");
  try {
    app.parse(argc, argv);
    return o.sweep.empty() ? character::run(o) : character::run_sweeps(o);
  } catch (const CLI::ParseError& usage) {
    return app.exit(usage) == 0 ? 0 : 2;
  } catch (const HarnessFault& fault) {
    fmt::print(stderr, "character: {}\n", fault.what());
    return 3;
  } catch (const Error& error) {
    fmt::print(stderr, "character: {}\n", error.what());
    return 2;
  }
}
