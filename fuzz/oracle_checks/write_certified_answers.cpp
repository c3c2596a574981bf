// write_certified_answers FILE SIZE CORPUS MESH...: writes queries of every family, of the corpus, of meshes and of
// integers at the ends of the range, SIZE of each in each precision, with the oracle's answer to each and the answer of
// the conservative kernel on this machine, which is the same on each instruction set.
// kernel/sphere_triangle/certified/tests/ asks them again elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/files/corpus.h"
#include "fuzz/queries/source.h"
#include "kernel/sphere_triangle/certified/tests/stored_answers.h"
#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t seed = 20101230;
constexpr std::size_t largest_group = 299;  // more than a block of the library, and not a multiple of the vector size

template <class Real>
void judge_and_write(const std::string& name, std::size_t in_a_group, const std::vector<Query<Real>>& queries,
                     std::FILE* file) {
  certified::StoredAnswers<Real> stored;
  stored.name = name;
  stored.group = in_a_group;
  QueryBatch<Real> batch(queries.size(), coordinate_count);
  for (const Query<Real>& q : queries) {
    const auto v = coordinates(q);
    for (std::size_t k = 0; k < coordinate_count; ++k) stored.column[k].push_back(v[k]);
    stored.order.push_back(is_valid(q) ? static_cast<std::int8_t>(distance_order(q)) : certified::invalid_order);
    batch.push_back(q);
  }
  for (const std::string& target : available_targets()) {
    std::vector<Verdict> found(queries.size());
    find_kernel("conservative").on<Real>(target).verdicts(batch.columns(), found.data());
    std::vector<std::uint8_t> verdicts;
    for (const Verdict verdict : found) verdicts.push_back(static_cast<std::uint8_t>(verdict));
    if (!stored.conservative.empty() && verdicts != stored.conservative) {
      throw Error(fmt::format("{}: conservative on {} answers otherwise than on {}", name, target,
                              available_targets().front()));
    }
    stored.conservative = verdicts;
  }
  if (!write(stored, file)) throw Error("the file cannot be written");
}

// Writes the queries, and the triangles of some of them with the sphere of the first.
template <class Real>
void write_all(const std::string& name, const std::vector<Query<Real>>& queries, std::FILE* file) {
  judge_and_write(name, 1, queries, file);
  const std::size_t group = std::min(largest_group, queries.size());
  std::vector<Query<Real>> grouped;
  for (std::size_t first = 0; grouped.size() <= queries.size() / 4; first += group) {
    for (std::size_t i = 0; i < group; ++i) {
      Query<Real> q = queries[(first + i) % queries.size()];
      q.p = queries[first].p;
      q.r = queries[first].r;
      grouped.push_back(q);
    }
  }
  judge_and_write(name, group, grouped, file);
}

template <class Real>
void write_precision(const std::vector<SourcePtr>& sources, std::size_t size, std::FILE* file) {
  for (const SourcePtr& source : sources) {
    std::vector<Query<Real>> queries(source->fixed_size(precision_of<Real>).value_or(size));
    for (std::size_t i = 0; i < queries.size(); ++i) queries[i] = source->make<Real>(seed, i);
    if (!queries.empty()) write_all(source->name(), queries, file);
  }
  std::mt19937_64 random(seed);
  std::vector<Query<Real>> queries(size);
  for (Query<Real>& q : queries) q = testing_support::coarse_query_of_any_size<Real>(random);
  write_all("integers", queries, file);
}

void write_file(const char* path, std::size_t size, const std::vector<SourcePtr>& sources) {
  std::FILE* file = std::fopen(path, "wb");
  if (!file) throw Error(fmt::format("{}: cannot be written", path));
  write_precision<float>(sources, size, file);
  write_precision<double>(sources, size, file);
  if (std::fclose(file) != 0) throw Error(fmt::format("{}: cannot be written", path));
}

}  // namespace
}  // namespace axiscert

int main(int argc, char** argv) {
  using namespace axiscert;
  const std::size_t size = argc < 4 ? 0 : std::strtoull(argv[2], nullptr, 10);
  if (size == 0) {
    fmt::print(stderr, "usage: write_certified_answers FILE SIZE CORPUS MESH...\n");
    return 2;
  }
  try {
    std::vector<SourcePtr> sources;
    for (const Family* family : families_of(sphere_triangle_predicate())) sources.push_back(family_source(*family));
    sources.push_back(corpus_source(argv[3], sphere_triangle_predicate()));
    for (int i = 4; i < argc; ++i) sources.push_back(mesh_source(argv[i], sphere_triangle_predicate()));
    write_file(argv[1], size, sources);
  } catch (const std::exception& error) {
    fmt::print(stderr, "write_certified_answers: {}\n", error.what());
    return 1;
  }
}
