// Mesh files: assimp reads them in a process of its own. Whatever happens to that process, the file is refused by Error
// or gives triangles of which every query is finite.
//
// Input: byte 0 chooses the format, by the file's name; then the file. No coverage comes back from the other process,
// so an input counts as new by its result: a message, or a number of triangles.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <filesystem>

#include "fuzz/files/mesh.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/mesh_queries.h"
#include "fuzz/targets/target.h"
#include "kernel/base/folders.h"
#include "kernel/sphere_triangle/query.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;

constexpr std::array<std::string_view, 6> formats = {"obj", "ply", "stl", "off", "dae", "gltf"};
constexpr std::size_t outcome_count = 4096;

__attribute__((section("__libfuzzer_extra_counters"))) std::uint8_t outcomes[outcome_count];

void see(std::string_view outcome) { outcomes[name_hash(outcome) % outcome_count] = 1; }

// A message without the parts that depend on the file: numbers and quotations.
std::string kind_of(std::string_view message) {
  std::string kind;
  for (const char c : message.substr(message.find(": ") + 1)) {
    if (c == '"' || c == '\'') break;
    if (c < '0' || c > '9') kind += c;
  }
  return kind;
}

template <class Real>
void check_queries(const Source& source) {
  QueryBatch<Real> batch(64, coordinate_count);
  source.fill(1, 0, batch.capacity(), batch);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!is_valid(query_from(batch[i])))
      report_fault(fmt::format("query {} in {} of a mesh that was accepted is not valid", i, name(precision_of<Real>)));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return -1;
  static const TemporaryFolder folder;  // its own, so that files which the mesh names are not found
  const std::string path =
      folder.write(fmt::format("fuzzed.{}", formats[data[0] % formats.size()]), text_of(data + 1, size - 1));
  try {
    // assimp may use all the time that it is given, so it gets little; a file that was read within it is read again.
    import_mesh(path, {std::uint64_t{1} << 30, 1});
    const SourcePtr source = mesh_source(path, sphere_triangle_predicate());
    const FileInfo file = *source->file();
    see(fmt::format("{} {} {}", std::bit_width(file.triangles), std::bit_width(file.degenerate_triangles),
                    std::bit_width(file.skipped_primitives)));
    check_queries<float>(*source);
    check_queries<double>(*source);
  } catch (const Error& refusal) {
    check_message(refusal.what());
    see(kind_of(refusal.what()));
  }
  std::filesystem::remove(path);
  return 0;
}
