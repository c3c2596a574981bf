// The plug-ins with a fault of logic: the one without a fault is the built-in kernel bit for bit, and each of the
// others is wrong on small integers, where nothing is rounded, in the comparisons and in the direction that its file
// states.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "kernel/kernel.h"
#include "kernel/include/axiscert/plugin.h"
#include "kernel/predicate.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing_support::random_query;

// The effect of a fault on queries of small integers whose triangle has area.
struct Fault {
  std::string_view name;
  bool misses_contacts, invents_contacts;
  std::set<std::string_view> comparisons;  // those that differ on some query; empty for a plug-in that shows only
                                           // verdicts
};

const Fault faults[] = {
    {"copy_paste", false, true, {"vertex_c.side_a"}},
    {"dropped_axis", false, true, {"edge_ca.radius"}},
    {"dropped_side", true, false, {"vertex_b.side_c"}},
    {"early_return", false, true, {}},
    {"in_place",
     true,
     true,
     {"vertex_a.side_b", "vertex_b.radius", "vertex_b.side_a", "vertex_b.side_c", "vertex_c.side_b", "edge_ab.radius",
      "edge_ab.side_c", "edge_bc.radius", "edge_bc.side_a", "edge_ca.side_b"}},
    {"inverted", true, true, {}},
    {"missing_square", true, false, {"edge_ab.radius"}},
    {"none", false, false, {}},
    {"one_sided_plane", false, true, {"plane.radius"}},
    {"radius_not_strict", true, false, {"vertex_a.radius"}},
    {"reversed_edge", true, true, {"edge_ca.radius", "edge_ca.side_b"}},
    {"swapped_comparison", true, true, {"edge_ca.side_b"}},
    {"unsquared_radius",
     true,
     false,
     {"plane.radius", "vertex_a.radius", "vertex_b.radius", "vertex_c.radius", "edge_ab.radius", "edge_bc.radius",
      "edge_ca.radius"}},
    {"untranslated",
     true,
     true,
     {"plane.radius", "vertex_a.side_c", "vertex_b.side_c", "vertex_c.radius", "vertex_c.side_a", "vertex_c.side_b",
      "edge_ab.side_c", "edge_bc.radius", "edge_bc.side_a", "edge_ca.radius", "edge_ca.side_b"}},
    {"wrong_index", true, true, {"plane.radius"}},
    {"wrong_operand", true, true, {"edge_bc.radius", "edge_bc.side_a"}},
    {"wrong_sign", true, true, {"edge_ab.radius", "edge_ab.side_c"}},
    {"wrong_vertex", false, true, {"edge_bc.side_a"}},
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

template <class Real>
const axiscert_kernel& plugin(std::string_view name) {
  const std::string path = std::string(BUILD_FOLDER "/faults/") + std::string(name) + ".so";
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(dlerror());
  const auto entry = reinterpret_cast<decltype(&axiscert_plugin)>(dlsym(library, "axiscert_plugin"));
  if (entry == nullptr) throw std::runtime_error(dlerror());
  return *entry(sizeof(Real) == 4 ? 0 : 1);
}

struct ToldAnswers {
  std::vector<Verdict> verdicts;
  std::vector<std::uint64_t> bits;
};

template <class Real>
ToldAnswers ask(const axiscert_kernel& kernel, const QueryColumns<Real>& queries) {
  ToldAnswers told{std::vector<Verdict>(queries.size), std::vector<std::uint64_t>(queries.size)};
  std::array<const void*, coordinate_count> column;
  std::copy_n(queries.column.begin(), queries.count, column.begin());
  const axiscert_batch batch{sizeof batch, queries.size, column.size(), column.data()};
  axiscert_answers answers{};
  answers.size = sizeof answers;
  answers.verdict = reinterpret_cast<std::uint8_t*>(told.verdicts.data());
  if (kernel.exposes >= AXISCERT_COMPARISONS) answers.comparisons = told.bits.data();
  kernel.run(&batch, &answers);
  return told;
}

template <class Real>
std::vector<Verdict> verdicts_of(std::string_view built_in, const QueryColumns<Real>& queries) {
  std::vector<Verdict> verdicts(queries.size);
  find_kernel(built_in).on<Real>(scalar_target).verdicts(queries, verdicts.data());
  return verdicts;
}

template <class Real>
ToldAnswers ask_published(const QueryColumns<Real>& queries) {
  Answers<Real> answers;
  answers.resize(queries.size, comparison_count);
  find_kernel("published").on<Real>(scalar_target).explain(queries, answers);
  return {verdicts_of("published", queries), {answers.bits.begin(), answers.bits.end()}};
}

template <class Real>
void expect_that_the_control_is_published() {
  constexpr std::size_t count = 200'000;
  std::mt19937_64 random(1);
  QueryBatch<Real> queries(count, coordinate_count);
  for (std::size_t i = 0; i < count; ++i) queries.push_back(random_query<Real>(random, i % 2 == 1));
  const ToldAnswers control = ask(plugin<Real>("none"), queries.columns()),
                    published = ask_published(queries.columns());
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(control.bits[i], published.bits[i]) << "random query " << i;
    ASSERT_EQ(control.verdicts[i], published.verdicts[i]) << "random query " << i;
  }
}

TEST(Faults, TheControlIsThePublishedTestBitForBit) {
  expect_that_the_control_is_published<float>();
  expect_that_the_control_is_published<double>();
}

TEST(Faults, EachSourceHasARow) {
  std::set<std::string> sources, rows;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_FOLDER "/kernel/sphere_triangle/faults")) {
    if (entry.path().extension() == ".c") sources.insert(entry.path().stem());
  }
  for (const Fault& fault : faults) rows.emplace(fault.name);
  for (const std::string& source : sources) {
    EXPECT_TRUE(rows.contains(source))
        << "kernel fault/" << source << " has no row in kernel/sphere_triangle/faults/faults_test.cpp, table `faults`";
  }
  for (const std::string& row : rows) {
    EXPECT_TRUE(sources.contains(row)) << "row '" << row
                                       << "' of kernel/sphere_triangle/faults/faults_test.cpp: there is no "
                                       << "kernel/sphere_triangle/faults/" << row << ".c";
  }
}

// Coordinates in [-2, 2], radius in [0, 4], area not zero: every intermediate result of the test is an integer below
// 2^24, so it is exact in either precision, and the exact test is right for every triangle with area.
template <class Real>
QueryBatch<Real> lattice() {
  constexpr std::size_t count = 50'000;
  std::mt19937_64 random(2);
  QueryBatch<Real> queries(count, coordinate_count);
  while (queries.size() < count) {
    std::array<Real, coordinate_count> v;
    for (Real& x : v) x = static_cast<Real>(static_cast<int>(random() % 5) - 2);
    v.back() += 2;
    const Query<Real> q = from_coordinates(v);
    const Vec3<Real> normal = cross(q.b - q.a, q.c - q.a);
    if (dot(normal, normal) > 0) queries.push_back(q);
  }
  return queries;
}

class FaultsOf : public testing::TestWithParam<Fault> {};

template <class Real>
void expect_wrong_where_its_file_says(const Fault& fault) {
  const QueryBatch<Real> queries = lattice<Real>();
  const axiscert_kernel& kernel = plugin<Real>(fault.name);
  EXPECT_EQ(kernel.abi, AXISCERT_PLUGIN_ABI);
  EXPECT_EQ(kernel.precision, 8 * sizeof(Real));
  EXPECT_EQ(kernel.source, "kernel/sphere_triangle/faults/" + std::string(fault.name) + ".c:1");
  EXPECT_STREQ(kernel.conforms_to, "published");
  const ToldAnswers right = ask_published(queries.columns()), told = ask(kernel, queries.columns());
  // The published test is right here: an unrelated method gives the same verdicts.
  ASSERT_EQ(right.verdicts, verdicts_of("minkowski", queries.columns()));

  std::size_t missed = 0, invented = 0;
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (told.verdicts[i] != right.verdicts[i]) ++(told.verdicts[i] == Verdict::separated ? missed : invented);
    if (kernel.exposes == AXISCERT_VERDICT_ONLY) continue;
    differing |= told.bits[i] ^ right.bits[i];
    ASSERT_EQ(told.verdicts[i], verdict_of(sphere_triangle_predicate(), told.bits[i])) << "lattice query " << i;
  }
  EXPECT_EQ(missed > 0, fault.misses_contacts) << missed << " contacts missed";
  EXPECT_EQ(invented > 0, fault.invents_contacts) << invented << " contacts invented";
  std::set<std::string_view> names;
  EXPECT_EQ(differing >> comparison_count, 0u);
  for (std::size_t k = 0; k < comparison_count; ++k) {
    if (has_bit(differing, k)) names.insert(comparisons[k].name);
  }
  EXPECT_EQ(names, fault.comparisons);
}

TEST_P(FaultsOf, AreWrongWithoutRoundingWhereTheirFileSays) {
  expect_wrong_where_its_file_says<float>(GetParam());
  expect_wrong_where_its_file_says<double>(GetParam());
}
INSTANTIATE_TEST_SUITE_P(Logic, FaultsOf, testing::ValuesIn(faults),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace axiscert
