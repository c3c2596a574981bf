// character MESH: a sphere walks over a mesh by the certified predicate; other kernels are asked about the same
// spheres.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>

#include "examples/character/comparison.h"
#include "examples/character/picture.h"
#include "examples/character/table.h"
#include "fuzz/files/query_file.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "fuzz/confirm/finding_record.h"

namespace axiscert::character {
namespace {

struct Options {
  std::string mesh, radius, up, out, queries;
  std::uint64_t seed = 1, steps = 2000;
  std::vector<std::string> kernels;
};

constexpr double default_share = 64, least_share = 4096;  // divisors of the box's diagonal

float radius_of(const Options& options, const Mesh& mesh) {
  if (!(mesh.diagonal >= 0x1p-100 && mesh.diagonal <= 0x1p+100)) {
    throw Error(fmt::format("{}: its box has the diagonal {}; a walk needs one from 2^-100 to 2^100", options.mesh,
                            mesh.diagonal));
  }
  if (options.radius.empty()) return static_cast<float>(mesh.diagonal / default_share);
  // Rounded to float, so that the limits named in a refusal are accepted.
  const auto least = static_cast<float>(mesh.diagonal / least_share), greatest = static_cast<float>(mesh.diagonal);
  const auto refused = [&](const std::string& why) {
    return Error(fmt::format(
        "--radius {}: {}; give a number from {} to {}, a {}th of the diagonal of the mesh's box to all of it",
        shown(options.radius), why, least, greatest, least_share));
  };
  float radius = 0;
  try {
    radius = parse_number<float>(options.radius);
  } catch (const Error& wrong) {
    throw refused(wrong.what());
  }
  if (!(radius >= least && radius <= greatest)) throw refused("out of range for this mesh");
  return radius;
}

// The kernels asked for; if none, the published test and Bullet's, if Bullet's was built.
std::vector<const Kernel*> kernels_of(const Options& options, std::string& not_checked) {
  std::vector<const Kernel*> found;
  for (const std::string& id : options.kernels) {
    const Kernel* kernel = &find_kernel(id);
    if (std::ranges::find(found, kernel) == found.end()) found.push_back(kernel);
  }
  if (options.kernels.empty()) {
    found.push_back(&find_kernel("published"));
    try {
      found.push_back(&find_kernel("peer/bullet"));
    } catch (const Error& absent) {
      not_checked = fmt::format("NOT CHECKED: {}\n", absent.what());
    }
  }
  for (const Kernel* kernel : found) {
    require_loaded(*kernel);
    if (!kernel->has(Precision::binary32)) {
      throw Error(fmt::format("--kernel {}: does not exist in binary32, the precision of this walk", kernel->id));
    }
  }
  return found;
}

// The file that an option names. It is opened before the walk, so that no walk is made in vain; an existing file stays
// as it is until begin().
class Out {
 public:
  Out(std::string option, const std::string& path)
      : option_(std::move(option)), path_(path), file_(path, std::ios::binary | std::ios::app) {
    require();
  }
  void begin() {
    file_.close();
    file_.open(path_, std::ios::binary | std::ios::trunc);
    require();
  }
  void write(const std::string& text) { file_ << text; }
  void end() {
    file_.close();
    require();
  }

 private:
  void require() const {
    if (!file_) {
      throw Error(fmt::format("{} {}: {}; give a file that can be written", option_, path_, std::strerror(errno)));
    }
  }
  std::string option_, path_;
  std::ofstream file_;
};
std::optional<Out> out_of(const std::string& option, const std::string& path) {
  if (path.empty()) return {};
  return std::make_optional<Out>(option, path);
}

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
      out.write(query_line({id, Precision::binary32, Numbers<float>(ground.query(ask.sphere, t))}) + "\n");
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
  const std::vector<const Kernel*> kernels = kernels_of(options, not_checked);
  Mesh mesh = load_mesh(options.mesh, read_bytes(options.mesh).size());
  const WalkOptions walk_options{options.seed, options.steps, radius_of(options, mesh)};
  const std::uint64_t without_area = mesh.degenerate_triangles, left_out = mesh.skipped_primitives;
  const std::size_t up = options.up.empty() ? thinnest_axis(mesh.triangles) : std::size_t(options.up[0] - 'x');
  const Ground ground(std::move(mesh.triangles), up);
  std::optional<Out> out = out_of("--out", options.out), queries = out_of("--queries", options.queries);
  const Walk walk = walked(ground, walk_options);
  std::vector<Comparison> comparisons;
  for (const Kernel* kernel : kernels) comparisons.push_back(compared(ground, walk, *kernel));

  const std::string title = fmt::format(
      "{}: {} triangles, {} of them without area{}; a sphere of radius {} takes {} steps, {} up, seed {}",
      base_name(options.mesh), ground.size(), without_area,
      left_out == 0 ? "" : fmt::format(", {} with numbers that are not finite, or lines or points, left out", left_out),
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
      "spheres."};
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
                 "kernel id from `axiscert kernels`, repeatable (default: published, peer/bullet)")
      ->allow_extra_args(false);
  app.add_option("--out", o.out, "SVG picture of the walk");
  app.add_option("--queries", o.queries,
                 "JSON Lines: every sphere with every triangle that the broad phase left for it, for `axiscert check`, "
                 "`run` and every command that takes a query file");
  app.footer("Exit codes: 0 done; 2 bad usage or input; 3 the certified predicate and CGAL's exact distance disagree.");
  try {
    app.parse(argc, argv);
    return character::run(o);
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
