// ask_contacts QUERIES [MESH...]: the library's contacts against their stated bounds, QUERIES in each precision shared
// by the families and meshes; a family marked with a cost is asked a sixteenth. Of 32 blocks one is asked on every
// instruction set too, two as single pairs and two as meshes, which have to be the same to the bit. Exit 1: one is
// wrong.
//
// ask_contacts --rationals QUERIES [MESH...]: feature and verdict alone, against the rationals of the judge, which are
// held to CGAL.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <numeric>
#include <string>
#include <vector>

#include "exact/sphere_triangle/certified_contact_truth.h"
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
  std::atomic<std::uint64_t> asked = 0, by_integers = 0, by_mpfr = 0, compared = 0, wrong = 0;
  std::mutex mutex;
  std::uint64_t first_position = ~std::uint64_t{0};
  std::string first;

  void add_wrong(std::uint64_t position, const std::string& text) {
    const std::lock_guard lock(mutex);
    ++wrong;
    if (position < first_position) first_position = position, first = text;
  }
};

template <class Real>
using Columns = std::array<const Real*, coordinate_count>;

template <class Real>
std::string numbers_of(const Columns<Real>& columns, std::size_t i) {
  std::string text;
  for (const Real* column : columns) text += fmt::format(" {:a}", column[i]);
  return text;
}

// To the bit, but that one NaN is as good as another.
bool is_same(double x, double y) {
  return (x == y && std::signbit(x) == std::signbit(y)) || (std::isnan(x) && std::isnan(y));
}
bool is_same(const testing_support::ContactSaid& a, const testing_support::ContactSaid& b) {
  bool same = a.verdict == b.verdict && a.feature == b.feature && a.has_normal == b.has_normal &&
              is_same(a.separation, b.separation);
  for (std::size_t k = 0; k < 3; ++k)
    same = same && is_same(a.normal[k], b.normal[k]) && is_same(a.point[k], b.point[k]);
  return same;
}

// Queries of a block, from `first` on, and the library's answers to them as pairs.
template <class Real>
struct Asked {
  const QueryColumns<Real>& batch;
  Columns<Real> columns;
  std::uint64_t first;
  axiscert_question question;
  std::vector<testing_support::ContactSaid> said;

  Asked(const QueryColumns<Real>& queries, std::uint64_t from, axiscert_question asked)
      : batch(queries), first(from), question(asked) {
    std::copy_n(queries.column.begin(), coordinate_count, columns.begin());
    said = testing_support::contacts_said<Real>(columns, queries.size, question);
  }
  std::string at(std::size_t i) const { return ":" + numbers_of<Real>(columns, i); }
};

// The bounds, by what is certain, or the judge's rationals.
enum class By { bounds, rationals };

template <class Real>
void judge_by_rationals(const Asked<Real>& asked, Counted& counted) {
  for (std::size_t i = 0; i < asked.said.size(); ++i) {
    std::array<double, 13> q;
    for (std::size_t k = 0; k < 13; ++k) q[k] = asked.columns[k][i];
    const std::string wrong = testing_support::what_is_wrong_for_the_judge(q, asked.said[i]);
    if (!wrong.empty()) counted.add_wrong(asked.first + i, wrong + asked.at(i));
  }
  counted.asked += asked.said.size();
}

template <class Real>
void judge(const Asked<Real>& asked, Counted& counted) {
  const bool is_open = asked.question == AXISCERT_OPEN_SPHERE;
  for (std::size_t i = 0; i < asked.said.size(); ++i) {
    std::array<double, 13> q;
    for (std::size_t k = 0; k < 13; ++k) q[k] = asked.columns[k][i];
    int by = 0;
    if (const std::string wrong = testing_support::what_is_wrong<Real>(q, is_open, asked.said[i], &by); !wrong.empty())
      counted.add_wrong(asked.first + i, wrong + asked.at(i));
    counted.by_integers += by == 1;
    counted.by_mpfr += by == 2;
  }
  counted.asked += asked.said.size();
}

// The kernel of this name is the library's code on a given instruction set.
template <class Real>
void ask_instruction_sets(const Asked<Real>& asked, Counted& counted) {
  const Kernel& kernel = find_kernel("contact");
  Reply<Real> best, other;
  for (const std::string& target : available_targets()) {
    Reply<Real>& reply = best.verdicts.empty() ? best : other;
    ask(kernel.on<Real>(target), asked.batch, reply);
    if (other.verdicts.empty()) continue;
    for (std::size_t i = 0; i < asked.batch.size; ++i) {
      bool same = best.verdicts[i] == other.verdicts[i];
      for (std::size_t k = 0; k < kernel.measure_count; ++k)
        same &= is_same(best.answers.measures[k][i], other.answers.measures[k][i]);
      if (!same) counted.add_wrong(asked.first + i, target + " has other bits" + asked.at(i));
    }
  }
}

template <class Real>
void ask_single_pairs(const Asked<Real>& asked, Counted& counted) {
  for (std::size_t i = 0; i < asked.said.size(); ++i) {
    std::array<Real, 13> q;
    for (std::size_t k = 0; k < 13; ++k) q[k] = asked.columns[k][i];
    certified::ContactData<Real> at;
    const axiscert_verdict verdict = certified::contact(q.data(), q.data() + 9, at, asked.question);
    testing_support::ContactSaid one{verdict, at.feature, at.has_normal, at.separation, {}, {}};
    std::copy_n(at.normal, 3, one.normal.begin());
    std::copy_n(at.point, 3, one.point.begin());
    if (!is_same(one, asked.said[i])) counted.add_wrong(asked.first + i, "a single pair has other bits" + asked.at(i));
  }
}

// The triangles as a mesh, with the sphere of one query: the contacts alone, as pairs have them, which are judged too.
template <class Real>
void ask_mesh(const Asked<Real>& asked, Counted& counted) {
  const std::size_t size = asked.said.size(), own = asked.first / block % size;
  std::vector<Real> vertices;
  std::vector<std::uint32_t> indices(3 * size);
  std::iota(indices.begin(), indices.end(), 0u);
  QueryBatch<Real> one_sphere(size, coordinate_count);
  Numbers<Real> q(coordinate_count);
  for (std::size_t k = 9; k < coordinate_count; ++k) q[k] = asked.columns[k][own];
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < 9; ++k) vertices.push_back(q[k] = asked.columns[k][i]);
    one_sphere.push_back(q);
  }
  const QueryColumns<Real> columns = one_sphere.columns();
  const Asked<Real> pairs(columns, asked.first, asked.question);
  judge(pairs, counted);
  std::vector<std::uint32_t> hits(size);
  std::vector<std::uint8_t> feature(size), has_normal(size);
  std::array<std::vector<Real>, 7> n;
  for (auto& column : n) column.resize(size);
  const axiscert_counts counts = certified::contact_mesh_range(
      q.data() + 9, certified::Mesh<Real>{vertices.data(), 3, indices.data()}, 0, size, asked.question, hits.data(),
      {nullptr,
       feature.data(),
       has_normal.data(),
       n[0].data(),
       {n[1].data(), n[2].data(), n[3].data()},
       {n[4].data(), n[5].data(), n[6].data()}});
  std::size_t next = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (pairs.said[i].verdict != AXISCERT_CONTACT) continue;
    const std::size_t at = next++;
    if (at < counts.contacts && hits[at] == i &&
        is_same({AXISCERT_CONTACT,
                 feature[at],
                 has_normal[at],
                 n[0][at],
                 {n[1][at], n[2][at], n[3][at]},
                 {n[4][at], n[5][at], n[6][at]}},
                pairs.said[i]))
      continue;
    counted.add_wrong(asked.first + i, "a mesh has another contact" + pairs.at(i));
  }
  if (next != counts.contacts) counted.add_wrong(asked.first, "a mesh has more contacts");
}

// Queries `first` to first + size of a source, of the open sphere in every fourth block.
template <class Real>
void ask_block(const Source& source, std::uint64_t first, std::size_t size, By by, Counted& counted) {
  QueryBatch<Real> batch(size, coordinate_count);
  source.fill(seed, first, size, batch);
  const std::uint64_t turn = first / block % 32;
  const QueryColumns<Real> columns = batch.columns();
  if (by == By::rationals) {
    judge_by_rationals(Asked<Real>(columns, first, AXISCERT_CLOSED_SPHERE), counted);
    return;
  }
  const Asked<Real> asked(columns, first, turn % 4 == 3 ? AXISCERT_OPEN_SPHERE : AXISCERT_CLOSED_SPHERE);
  judge(asked, counted);
  if (turn == 0) ask_instruction_sets(asked, counted);
  if (turn == 1 || turn == 3) ask_single_pairs(asked, counted);
  if (turn == 2 || turn == 7) ask_mesh(asked, counted);
  if (turn <= 3 || turn == 7) counted.compared += size;
}

struct Total {
  std::uint64_t asked = 0, by_integers = 0, by_mpfr = 0, compared = 0, wrong = 0;
  void print(const std::string& name, std::string_view precision, const std::string& first) const {
    fmt::print("{:16} {} {:>11} asked, {:>10} by integers, {} by MPFR, {:>10} compared, {} wrong{}\n", name, precision,
               asked, by_integers, by_mpfr, compared, wrong, first.empty() ? "" : ", first " + first);
    std::fflush(stdout);
  }
};

template <class Real>
void ask_source(const Source& source, std::uint64_t queries, By by, Total& total) {
  Counted counted;
  tbb::parallel_for(std::uint64_t{0}, (queries + block - 1) / block, [&](std::uint64_t i) {
    ask_block<Real>(source, i * block, std::min(block, queries - i * block), by, counted);
  });
  const Total own{counted.asked, counted.by_integers, counted.by_mpfr, counted.compared, counted.wrong};
  own.print(source.name(), name(precision_of<Real>), counted.first);
  total.asked += own.asked;
  total.by_integers += own.by_integers;
  total.by_mpfr += own.by_mpfr;
  total.compared += own.compared;
  total.wrong += own.wrong;
}

int run(std::uint64_t queries, By by, const std::vector<std::string>& meshes) {
  struct Share {
    SourcePtr source;
    std::uint64_t divisor;
  };
  std::vector<Share> shares;
  for (const Family* family : all_families_of(sphere_triangle_predicate()))
    shares.push_back({family_source(*family), family->cost > 1 ? 16u : 1u});
  for (const std::string& mesh : meshes) shares.push_back({mesh_source(mesh, sphere_triangle_predicate()), 1});
  const std::uint64_t of_each = queries / shares.size();
  Total of[enum_count<Precision>];
  for (const auto& [source, divisor] : shares) {
    const std::uint64_t wanted = std::max<std::uint64_t>(of_each / divisor, 1);
    ask_source<float>(*source, wanted, by, of[index_of(Precision::binary32)]);
    ask_source<double>(*source, wanted, by, of[index_of(Precision::binary64)]);
  }
  std::uint64_t wrong = 0;
  for (const Precision precision : enumerators<Precision>) {
    of[index_of(precision)].print("all", name(precision), "");
    wrong += of[index_of(precision)].wrong;
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace axiscert

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool by_rationals = !words.empty() && words[0] == "--rationals";
  if (by_rationals) words.erase(words.begin());
  if (words.empty()) {
    fmt::print(stderr, "ask_contacts [--rationals] QUERIES [MESH...]\n");
    return 2;
  }
  return axiscert::run(std::strtoull(words[0].c_str(), nullptr, 10),
                       by_rationals ? axiscert::By::rationals : axiscert::By::bounds, {words.begin() + 1, words.end()});
}
