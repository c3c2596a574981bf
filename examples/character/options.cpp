#include "examples/character/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "fuzz/confirm/record.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::character {
namespace {

constexpr double least_share = 4096;  // divisor of the box's diagonal

}  // namespace

float radius_of(const Options& options, const Mesh& mesh, double share) {
  if (!(mesh.diagonal >= 0x1p-100 && mesh.diagonal <= 0x1p+100)) {
    throw Error(fmt::format("{}: its box has the diagonal {}; a walk needs one from 2^-100 to 2^100", options.mesh,
                            mesh.diagonal));
  }
  if (options.radius.empty()) return static_cast<float>(mesh.diagonal / share);
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

namespace {

void require_of(const Predicate& predicate, const Kernel& kernel) {
  if (kernel.predicate == &predicate) return;
  throw Error(fmt::format("--kernel {}: answers {}; {}", kernel.id, kernel.predicate->id,
                          &predicate == &sphere_triangle_predicate()
                              ? "a walk by static predicates asks sphere-triangle, and --sweep moving-sphere"
                              : "--sweep asks moving-sphere: axiscert kernels --predicate moving-sphere"));
}

}  // namespace

std::vector<const Kernel*> kernels_of(const Options& options, const Predicate& predicate,
                                      std::span<const std::string_view> defaults, std::string& not_checked) {
  std::vector<const Kernel*> found;
  for (const std::string& id : options.kernels) {
    const Kernel* kernel = &find_kernel(id);
    if (std::ranges::find(found, kernel) == found.end()) found.push_back(kernel);
  }
  if (options.kernels.empty()) {
    for (const std::string_view id : defaults) {
      try {
        found.push_back(&find_kernel(id));
      } catch (const Error& absent) {
        not_checked += fmt::format("NOT CHECKED: {}\n", absent.what());
      }
    }
  }
  for (const Kernel* kernel : found) {
    require_loaded(*kernel);
    require_of(predicate, *kernel);
    if (!kernel->has(Precision::binary32)) {
      throw Error(fmt::format("--kernel {}: does not exist in binary32, the precision of this walk", kernel->id));
    }
  }
  return found;
}

std::string mesh_words(const Options& options, const Mesh& mesh) {
  return fmt::format("{}: {} triangles, {} of them without area{}", base_name(options.mesh), mesh.triangles.size(),
                     mesh.degenerate_triangles,
                     mesh.skipped_primitives == 0
                         ? ""
                         : fmt::format(", {} with numbers that are not finite, or lines or points, left out",
                                       mesh.skipped_primitives));
}

Out::Out(std::string option, const std::string& path)
    : option_(std::move(option)), path_(path), file_(path, std::ios::binary | std::ios::app) {
  require();
}
void Out::begin() {
  file_.close();
  file_.open(path_, std::ios::binary | std::ios::trunc);
  require();
}
void Out::end() {
  file_.close();
  require();
}
void Out::require() const {
  if (!file_) {
    throw Error(fmt::format("{} {}: {}; give a file that can be written", option_, path_, std::strerror(errno)));
  }
}

std::optional<Out> out_of(const std::string& option, const std::string& path) {
  if (path.empty()) return {};
  return std::make_optional<Out>(option, path);
}

}  // namespace axiscert::character
