// The command line's options, and the parts of them that need the mesh or the kernels to be understood.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/files/mesh.h"
#include "kernel/kernel.h"

namespace axiscert::character {

struct Options {
  std::string mesh, radius, up, out, queries;
  std::uint64_t seed = 1, steps = 2000;
  std::vector<std::string> kernels;
  std::string sweep;  // the errand of a journey by sweeps; empty: the walk by static predicates
  double stride = 0.5, skin = 0x1p-6;
};

// The radius, by default the diagonal of the mesh's box over `share`.
float radius_of(const Options& options, const Mesh& mesh, double share);

// The kernels of `predicate` that are asked for; if none, the defaults, of which those that are not built are said in
// `not_checked`. Throws Error for a kernel of another predicate, and for one that has no binary32.
std::vector<const Kernel*> kernels_of(const Options& options, const Predicate& predicate,
                                      std::span<const std::string_view> defaults, std::string& not_checked);

// "spider.obj: 1368 triangles, 56 of them without area".
std::string mesh_words(const Options& options, const Mesh& mesh);

// The file that an option names. It is opened before the walk, so that no walk is made in vain; an existing file stays
// as it is until begin().
class Out {
 public:
  Out(std::string option, const std::string& path);
  void begin();
  void write(const std::string& text) { file_ << text; }
  void end();

 private:
  void require() const;
  std::string option_, path_;
  std::ofstream file_;
};
// Empty for an empty path.
std::optional<Out> out_of(const std::string& option, const std::string& path);

}  // namespace axiscert::character
