// ask_contacts QUERIES [MESH...]: the library's contacts against their stated bounds, and the same to the bit on every
// instruction set, QUERIES in each precision shared by the families and meshes. Judged by long double, or 113 bits,
// where these are certain, by integers and MPFR elsewhere; a family that these have to judge often is asked a quarter
// or a twentieth. Exit 1: one is wrong.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <bit>
#include <cstdlib>
#include <mutex>
#include <string>
#include <vector>

#include "exact/sphere_triangle/certified/contact_truth.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/source.h"
#include "kernel/ask.h"
#include "kernel/include/axiscert/contact.hpp"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t seed = 20261128, block = std::uint64_t{1} << 14;

struct Counted {
  std::atomic<std::uint64_t> asked = 0, by_integers = 0, wrong = 0;
  std::mutex mutex;
  std::string first;

  void add_wrong(const std::string& text) {
    const std::lock_guard lock(mutex);
    if (wrong++ == 0) first = text;
  }
};

template <class Real>
std::string numbers_of(const std::array<const Real*, coordinate_count>& columns, std::size_t i) {
  std::string text;
  for (const Real* column : columns) text += fmt::format(" {:a}", column[i]);
  return text;
}

// Queries `first` to first + size of a source, the open sphere's for every fourth block.
template <class Real>
void ask_block(const Source& source, std::uint64_t first, std::size_t size, Counted& counted) {
  QueryBatch<Real> batch(size, coordinate_count);
  source.fill(seed, first, size, batch);
  std::array<const Real*, coordinate_count> columns;
  std::copy_n(batch.columns().column.begin(), coordinate_count, columns.begin());
  const bool is_open = first / block % 4 == 3;
  const auto all =
      testing_support::contacts_said<Real>(columns, size, is_open ? AXISCERT_OPEN_SPHERE : AXISCERT_CLOSED_SPHERE);
  for (std::size_t i = 0; i < size; ++i) {
    std::array<double, 13> q;
    for (std::size_t k = 0; k < 13; ++k) q[k] = columns[k][i];
    bool is_exact = false;
    if (const std::string wrong = testing_support::what_is_wrong<Real>(q, is_open, all[i], &is_exact); !wrong.empty())
      counted.add_wrong(wrong + ":" + numbers_of<Real>(columns, i));
    counted.by_integers += is_exact;
  }
  counted.asked += size;
  if (is_open) return;
  // The kernel of this name is the library's code on a given instruction set.
  const Kernel& kernel = find_kernel("contact");
  Reply<Real> best, other;
  for (const std::string& target : available_targets()) {
    Reply<Real>& reply = best.verdicts.empty() ? best : other;
    ask(kernel.on<Real>(target), batch.columns(), reply);
    if (other.verdicts.empty()) continue;
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    for (std::size_t i = 0; i < size; ++i) {
      bool is_same = best.verdicts[i] == other.verdicts[i];
      for (std::size_t k = 0; k < kernel.measure_count; ++k)
        is_same &=
            std::bit_cast<Bits>(best.answers.measures[k][i]) == std::bit_cast<Bits>(other.answers.measures[k][i]);
      if (!is_same) counted.add_wrong(target + " has other bits:" + numbers_of<Real>(columns, i));
    }
  }
}

struct Total {
  std::uint64_t asked = 0, by_integers = 0, wrong = 0;
};

template <class Real>
void ask_source(const Source& source, std::uint64_t queries, Total& total) {
  Counted first;
  ask_block<Real>(source, 0, std::min<std::uint64_t>(queries, 4096), first);
  const double share = static_cast<double>(first.by_integers) / static_cast<double>(first.asked);
  const std::uint64_t divisor = share > 0.2 ? 20 : share > 0.02 ? 4 : 1;
  const std::uint64_t wanted = std::max<std::uint64_t>(queries / divisor, 1);
  Counted counted;
  tbb::parallel_for(std::uint64_t{0}, (wanted + block - 1) / block, [&](std::uint64_t i) {
    ask_block<Real>(source, i * block, std::min(block, wanted - i * block), counted);
  });
  fmt::print("{:16} {} {:>11} asked, {:>10} by integers, {} wrong{}\n", source.name(), name(precision_of<Real>),
             counted.asked.load(), counted.by_integers.load(), counted.wrong.load(),
             counted.first.empty() ? "" : ", first " + counted.first);
  std::fflush(stdout);
  total.asked += counted.asked;
  total.by_integers += counted.by_integers;
  total.wrong += counted.wrong;
}

int run(std::uint64_t queries, const std::vector<std::string>& meshes) {
  std::vector<SourcePtr> sources;
  for (const Family* family : all_families_of(sphere_triangle_predicate())) sources.push_back(family_source(*family));
  for (const std::string& mesh : meshes) sources.push_back(mesh_source(mesh, sphere_triangle_predicate()));
  const std::uint64_t of_each = std::max<std::uint64_t>(queries / sources.size(), 1);
  Total of[enum_count<Precision>];
  for (const SourcePtr& source : sources) {
    ask_source<float>(*source, of_each, of[index_of(Precision::binary32)]);
    ask_source<double>(*source, of_each, of[index_of(Precision::binary64)]);
  }
  std::uint64_t wrong = 0;
  for (const Precision precision : enumerators<Precision>) {
    const Total& all = of[index_of(precision)];
    fmt::print("{:16} {} {:>11} asked, {:>10} by integers, {} wrong\n", "all", name(precision), all.asked,
               all.by_integers, all.wrong);
    wrong += all.wrong;
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace axiscert

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "ask_contacts QUERIES [MESH...]\n");
    return 2;
  }
  return axiscert::run(std::strtoull(argv[1], nullptr, 10), {argv + 2, argv + argc});
}
