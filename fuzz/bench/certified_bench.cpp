// The cost of exactness: `certified` and `conservative` beside the raw kernels and CGAL, and the contacts beside those
// of the libraries of kernel/peers, on the same queries.
//
//     certified_bench [--target T] [FAMILY...]
//
// Without names: all families and a mesh, and the cost of a large mesh. T is an instruction set from `axiscert
// kernels`, by default the best one; one pair always uses the best.
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "fuzz/bench/bench_table.h"
#include "fuzz/bench/naive_judges.h"
#include "fuzz/campaign/machine.h"
#include "fuzz/queries/source.h"
#include "kernel/include/axiscert/contact.hpp"
#include "kernel/include/axiscert/plugin.h"
#include "kernel/kernel.h"
#include "kernel/plugin/load.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
// Prints, for each precision and shape, the rate at which one sphere is tested against a mesh larger than the
// last-level cache, beside that of a read alone of the same bytes.
void print_certified_streams();

namespace {

constexpr std::uint32_t side = 2049;  // vertices per side: 2^23 triangles, 288 MiB of binary32
constexpr std::size_t triangle_count = std::size_t{2} * (side - 1) * (side - 1);
constexpr int stream_repetitions = 9;

// Rolling ground with cells of one unit, as an indexed mesh and as columns.
template <class Real>
struct Ground {
  std::vector<Real> vertices;
  std::vector<std::uint32_t> indices;
  std::array<std::vector<Real>, 9> columns;

  Ground() {
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        const double height = 3 * std::sin(0.11 * x) * std::cos(0.07 * y);
        vertices.insert(vertices.end(), {static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(height)});
      }
    }
    for (std::uint32_t y = 0; y + 1 < side; ++y) {
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        const std::uint32_t at = y * side + x;
        indices.insert(indices.end(), {at, at + 1, at + side, at + 1, at + side + 1, at + side});
      }
    }
    for (std::size_t k = 0; k < 9; ++k) {
      for (std::size_t i = 0; i < triangle_count; ++i) {
        columns[k].push_back(vertices[3 * std::size_t{indices[3 * i + k / 3]} + k % 3]);
      }
    }
  }
  // Puts the mesh's triangles in an order independent of their places.
  void shuffle() {
    std::mt19937_64 random(20101230);
    for (std::size_t i = triangle_count - 1; i > 0; --i) {
      const std::size_t other = random() % (i + 1);
      std::swap_ranges(&indices[3 * i], &indices[3 * i] + 3, &indices[3 * other]);
    }
  }
};

// A read of the bytes alone: the sum of their words, in eight sums that do not wait for each other.
template <class Element>
std::uint64_t sum_of(const std::vector<Element>& all) {
  std::uint64_t sums[8] = {}, words[8];
  const char* bytes = reinterpret_cast<const char*>(all.data());
  const std::size_t size = all.size() * sizeof(Element);
  for (std::size_t i = 0; i + sizeof words <= size; i += sizeof words) {
    std::memcpy(words, bytes + i, sizeof words);
    for (int k = 0; k < 8; ++k) sums[k] += words[k];
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t s : sums) sum += s;
  return sum;
}

double seconds(const std::function<void()>& pass) {
  const double start = thread_seconds();
  pass();
  return thread_seconds() - start;
}

// The two are timed in turns, so that other load on the machine affects both.
void print_row(std::string_view shape, Precision precision, std::size_t bytes, const std::function<void()>& ask,
               const std::function<void()>& read) {
  std::vector<double> asks, reads;
  for (int i = 0; i < stream_repetitions; ++i) {
    asks.push_back(seconds(ask));
    reads.push_back(seconds(read));
  }
  const double asked = median(asks), read_alone = median(reads), size = static_cast<double>(bytes);
  fmt::print("| {} | {} | {:.0f} | {:.2f} | {:.1f} | {:.1f} | {:.0f} % |\n", shape, name(precision), size / 0x1p20,
             asked / static_cast<double>(triangle_count) * 1e9, size / asked * 1e-9, size / read_alone * 1e-9,
             100 * read_alone / asked);
}

template <class Real, class Mesh>
void print_streams(Precision precision) {
  Ground<Real> ground;
  const Real middle = side / 2, sphere[4] = {middle, middle, Real(2), Real(2.5)};
  std::vector<std::uint64_t> contacts(triangle_count / 64 + 1);
  const axiscert_results results{nullptr, contacts.data(), nullptr};
  std::uint64_t sum = 0;

  std::array<const Real*, 9> columns;
  for (std::size_t k = 0; k < 9; ++k) columns[k] = ground.columns[k].data();
  print_row(
      "structure of arrays", precision, 9 * sizeof(Real) * triangle_count,
      [&] { certified::triangles(sphere, columns, triangle_count, AXISCERT_CLOSED_SPHERE, results); },
      [&] {
        for (const auto& column : ground.columns) sum += sum_of(column);
      });
  const Mesh mesh{ground.vertices.data(), 3, ground.indices.data()};
  const auto print_mesh = [&](std::string_view shape) {
    print_row(
        shape, precision, sizeof(Real) * ground.vertices.size() + 4 * ground.indices.size(),
        [&] { certified::mesh_range(sphere, mesh, 0, triangle_count, AXISCERT_CLOSED_SPHERE, results); },
        [&] { sum += sum_of(ground.vertices) + sum_of(ground.indices); });
  };
  print_mesh("indexed mesh");
  ground.shuffle();
  print_mesh("the same, shuffled");
  if (sum == 0) fmt::print("\n");  // uses the sum, so that the read is not removed
}

}  // namespace

void print_certified_streams() {
  fmt::print(
      "\nOne sphere against 2^23 triangles of rolling ground, one thread, medians of {} passes; read: a plain sum over "
      "the same bytes.\n\n"
      "| shape | precision | MiB | ns a triangle | GB/s | read, GB/s | of it |\n|---|---|---:|---:|---:|---:|---:|\n",
      stream_repetitions);
  print_streams<float, axiscert_mesh_f32>(Precision::binary32);
  print_streams<double, axiscert_mesh_f64>(Precision::binary64);
}

}  // namespace axiscert

namespace axiscert {
namespace {

constexpr std::size_t query_count = std::size_t{1} << 17;  // 6.5 MiB of binary32
constexpr int repetitions = 9;
constexpr double least_seconds = 2e-3;  // least time of one repetition
constexpr double enough_seconds = 4;    // time for all repetitions; slow kernels have fewer, but at least one

// A timed function, interleaved with the others.
struct TimedFunction {
  std::string name;
  std::function<void()> pass;  // one pass over query_count queries
  std::size_t passes = 1;
  std::vector<double> seconds = {};

  double once() const {
    const double start = thread_seconds();
    for (std::size_t i = 0; i < passes; ++i) pass();
    return thread_seconds() - start;
  }
  void find_passes() {
    while (once() < least_seconds) passes *= 2;
  }
  double spent() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
  double nanoseconds() const { return median(seconds) / static_cast<double>(passes * query_count) * 1e9; }
};

// The libraries that give numbers beside a verdict of sphere-triangle, each called in this process as a plug-in.
struct Peer {
  std::string name;
  const axiscert_kernel* kernel;
};
std::vector<Peer> peers_with_contacts() {
  std::vector<Peer> found;
  for (const plugin::ShippedPlugins& shipped : plugin::shipped_plugins()) {
    if (shipped.prefix != "peer/") continue;
    for (const std::string& name : shipped.names) {
      const std::string path = *plugin::plugin_path(shipped.prefix + name);
      void* const library = plugin::is_program(name, path) ? nullptr : dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
      if (library == nullptr) continue;
      const auto kernels = reinterpret_cast<decltype(&axiscert_plugin)>(dlsym(library, "axiscert_plugin"));
      for (std::uint32_t i = 0; const axiscert_kernel* kernel = kernels(i); ++i) {
        if (kernel->measure_count != 0) found.push_back({name, kernel});
      }
    }
  }
  return found;
}

// Rows of the tables after the first.
struct OtherRows {
  std::string exact_only, contacts, peers;
};
// Prints the row of a family, and adds its rows of the other tables.
template <class Real>
void measure(const Source& source, const std::string& target, std::span<const Peer> peers, OtherRows& rows) {
  QueryBatch<Real> batch(query_count, coordinate_count);
  source.fill(1, 0, query_count, batch);
  const QueryColumns<Real> columns = batch.columns();
  std::vector<Query<Real>> queries;
  for (std::size_t i = 0; i < query_count; ++i) queries.push_back(batch[i]);
  std::vector<Verdict> verdicts(query_count);
  std::vector<std::array<Real, coordinate_count>> flat;
  for (const Query<Real>& q : queries) flat.push_back(coordinates(q));
  int contacts = 0;

  std::vector<TimedFunction> all;
  for (const char* id : {"published", "reduced-nonstrict", "certified", "conservative"}) {
    all.push_back({id, [&, run = find_kernel(id).on<Real>(target).verdicts] { run(columns, verdicts.data()); }});
  }
  all.push_back({"scalar published", [&, run = find_kernel("published").on<Real>(scalar_target).verdicts] {
                   run(columns, verdicts.data());
                 }});
  all.push_back({"one pair", [&] {
                   for (const auto& v : flat) contacts += certified::pair(v.data(), v.data() + 9) == AXISCERT_CONTACT;
                 }});
  std::array<const Real*, coordinate_count> pointers;
  std::copy_n(columns.column.begin(), coordinate_count, pointers.begin());
  all.push_back({"exact only", [&] {
                   const axiscert_results to{reinterpret_cast<std::uint8_t*>(verdicts.data()), nullptr, nullptr};
                   certified::pairs(pointers, query_count, AXISCERT_EXACT_ONLY, to);
                 }});
  std::vector<std::uint8_t> features(query_count), has_normal(query_count);
  // Placed as the queries are: columns of vectors would lie at the same places of pages, across cache lines.
  QueryBatch<Real> numbers(query_count, 7);
  const auto number = [&](std::size_t k) { return numbers.mutable_columns().column[k]; };
  all.push_back({"contacts", [&] {
                   certified::contact_pairs(pointers, query_count, AXISCERT_CLOSED_SPHERE,
                                            {reinterpret_cast<std::uint8_t*>(verdicts.data()),
                                             features.data(),
                                             has_normal.data(),
                                             number(0),
                                             {number(1), number(2), number(3)},
                                             {number(4), number(5), number(6)}});
                 }});
  all.push_back({"one contact", [&] {
                   certified::ContactData<Real> at;
                   for (const auto& v : flat) {
                     contacts += certified::contact(v.data(), v.data() + 9, at) == AXISCERT_CONTACT;
                   }
                 }});
  for (TimedFunction& timed : all) timed.find_passes();
  for (int i = 0; i < repetitions; ++i) {
    for (TimedFunction& timed : all) {
      if (timed.spent() < enough_seconds) timed.seconds.push_back(timed.once());
    }
  }
  // It is slow, and steady enough with one pass.
  TimedFunction epick{"CGAL EPICK", [&] { contacts += static_cast<int>(contacts_by_epick(queries)); }};
  epick.seconds.push_back(epick.once());

  const double raw = std::min(all[0].nanoseconds(), all[1].nanoseconds());
  const auto of = [&](std::size_t i, double to) {
    return fmt::format("{:.1f} ({:.2f})", all[i].nanoseconds(), all[i].nanoseconds() / to);
  };
  fmt::print("| {} | {} | {:.1f} | {:.1f} | {} | {} | {:.1f} | {} | {:.0f} ({:.0f}) |\n", source.name(),
             name(precision_of<Real>), all[0].nanoseconds(), all[1].nanoseconds(), of(2, raw), of(3, raw),
             all[4].nanoseconds(), of(5, all[4].nanoseconds()), epick.nanoseconds(),
             epick.nanoseconds() / all[2].nanoseconds());
  std::fflush(stdout);
  const auto row = fmt::format("| {} | {} | {:.1f} |", source.name(), name(precision_of<Real>), all[2].nanoseconds());
  rows.exact_only += fmt::format("{} {} |\n", row, of(6, all[2].nanoseconds()));
  rows.contacts += fmt::format("{} {} | {} |\n", row, of(7, all[2].nanoseconds()), of(8, all[5].nanoseconds()));
  std::vector<std::vector<Real>> measures(AXISCERT_MOST_MEASURES, std::vector<Real>(query_count));
  std::vector<void*> to_measures;
  for (std::vector<Real>& one : measures) to_measures.push_back(one.data());
  const std::vector<const void*> from(pointers.begin(), pointers.end());
  const axiscert_batch asked{sizeof(axiscert_batch), query_count, coordinate_count, from.data()};
  for (const Peer& peer : peers) {
    if (peer.kernel->precision != 8 * sizeof(Real)) continue;
    axiscert_answers answers{};
    answers.size = sizeof answers;
    answers.verdict = reinterpret_cast<std::uint8_t*>(verdicts.data());
    answers.measure_count = peer.kernel->measure_count;
    answers.measure = to_measures.data();
    // One pass, as of EPICK.
    const double taken = seconds([&] { peer.kernel->run(&asked, &answers); }) / double{query_count} * 1e9;
    rows.peers += fmt::format("| {} | {} | {:.1f} ({:.2f}) |\n", peer.name, name(precision_of<Real>), taken,
                              taken / all[7].nanoseconds());
  }
}

void run(std::vector<std::string_view> names) {
  std::string wanted = "auto";
  if (!names.empty() && names[0] == "--target") {
    if (names.size() == 1)
      throw std::invalid_argument("--target: name an instruction set, as listed by `axiscert kernels`");
    wanted = names[1];
    names.erase(names.begin(), names.begin() + 2);
  }
  const std::vector<SourcePtr> sources = sources_named(names);
  const std::string target = resolve_target(wanted);
  fmt::print(
      "{}; {}, {}; instruction set {}. One thread, processor time, ns a query, medians of {} "
      "interleaved repetitions (of what is slow, fewer) over {} queries.\n\n"
      "- certified, conservative: (times the faster of the two raw tests)\n"
      "- one pair: axiscert_pair, (times the scalar published test)\n"
      "- CGAL EPICK: compare_squared_distance_3, (times certified)\n\n"
      "| family | precision | published | reduced-nonstrict | certified | conservative | scalar published | one pair | "
      "CGAL EPICK |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|---:|\n",
      processor_name(), compiler_name(), compiler_flags(), target, repetitions, query_count);
  OtherRows rows;
  const std::vector<Peer> peers = peers_with_contacts();
  for (const SourcePtr& source : sources) {
    // Some libraries do not end on a tie.
    const std::span<const Peer> asked = source->name() == "general" ? std::span(peers) : std::span<const Peer>();
    measure<float>(*source, target, asked, rows);
    measure<double>(*source, target, asked, rows);
  }
  fmt::print(
      "\nAXISCERT_EXACT_ONLY, straight to the exact step: (times certified)\n\n"
      "| family | precision | certified | exact only |\n"
      "|---|---|---:|---:|\n{}"
      "\naxiscert_contact, with all numbers: many pairs (times certified), one pair (times one pair without them)\n\n"
      "| family | precision | certified | contacts | one contact |\n"
      "|---|---|---:|---:|---:|\n{}"
      "\nLibraries on `general`, as kernel/peers calls them, verdict and numbers, one pass: (times contacts)\n\n"
      "| library | precision | ns |\n"
      "|---|---|---:|\n{}",
      rows.exact_only, rows.contacts, rows.peers.empty() ? "None was asked.\n" : rows.peers);
  if (names.empty()) print_certified_streams();
}

}  // namespace
}  // namespace axiscert

int main(int argc, char** argv) { return axiscert::bench_main("certified_bench", argc, argv, axiscert::run); }
