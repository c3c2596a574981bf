// The filter kernels are the program that the Coq theorem is about (Filter.v, `never_lies`): on each instruction set
// they answer as the recorded expressions do, evaluated operation by operation, with Filter.v's own words around them.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "proofs/program.h"
#include "proofs/certified/turns.h"
#include "kernel/include/axiscert/certified.h"
#include "kernel/sphere_triangle/certified/thresholds.h"
#include "kernel/sphere_triangle/forms/margin_bounds.h"
#include "kernel/sphere_triangle/forms/filter_thresholds.h"
#include "kernel/kernel.h"
#include "kernel/random_testing.h"

namespace axiscert::proofs {
namespace {

using testing_support::random_query;
using Thresholds = std::array<filter::Threshold, comparison_count>;

// The program of the coarse step's theorem has this constant; the certified predicate's own steps are recorded and
// compared in certified_program_test.cpp.
static_assert(axiscert::certified::least_relative_triangle == 1.0 / 1048576);
// The promised depth of phantoms is at least `phantom_depth` of PhantomStep.v, 20, times the root of u.
static_assert(AXISCERT_PHANTOM_DEPTH_F32 * AXISCERT_PHANTOM_DEPTH_F32 >= 20 * 20 * 0x1p-24);
static_assert(AXISCERT_PHANTOM_DEPTH_F64 * AXISCERT_PHANTOM_DEPTH_F64 >= 20 * 20 * 0x1p-53);

struct FilterUnderTest {
  const char* kernel;
  Form form;
  const Thresholds* thresholds;
};
constexpr std::array<FilterUnderTest, 2> filters = {{
    {"certified-filter", Form::reduced, &filter::reduced_thresholds},
    {"certified-filter-published", Form::published, &filter::published_thresholds},
}};

// `run` of Filter.v, over hardware numbers.
template <class Real>
void run(const Program& program, const Query<Real>& q, std::vector<Real>& values) {
  values.clear();
  std::size_t inputs = 0;
  for (const Step& step : program.steps()) {
    const auto operand = [&](std::size_t k) { return values[step.operands[k]]; };
    switch (step.operation) {
      case Operation::input:
        values.push_back(coordinates(q)[inputs++]);
        break;
      case Operation::zero:
        values.push_back(0);
        break;
      case Operation::negate:
        values.push_back(-operand(0));
        break;
      case Operation::add:
        values.push_back(operand(0) + operand(1));
        break;
      case Operation::subtract:
        values.push_back(operand(0) - operand(1));
        break;
      case Operation::multiply:
        values.push_back(operand(0) * operand(1));
        break;
      case Operation::fused:
        values.push_back(std::fma(operand(0), operand(1), operand(2)));
        break;
    }
  }
}

// `greatest`, `inside`, `certainly_greater`, `certainly_less` and `filter` of Filter.v, literally.
template <class Real>
class FilterProgram {
 public:
  FilterProgram(Form form, const Thresholds& thresholds)
      : recording_(record(form, Contraction::plain)), thresholds_(thresholds) {}

  Verdict operator()(const Query<Real>& q) {
    Real m = q.r;
    bool inside = 0 <= q.r && q.r <= filter::greatest_magnitude<Real>;
    const auto v = coordinates(q);
    for (std::size_t i = 0; i < 9; ++i) {
      const Real size = std::fabs(v[i] - v[9 + i % 3]);
      if (m < size) m = size;
      inside = inside && size <= filter::greatest_magnitude<Real>;
    }
    if (!inside || !(filter::least_magnitude<Real> <= m)) return Verdict::undecided;
    run(recording_.program, q, values_);
    ComparisonBits not_greater = 0, less = 0;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      const Real limit = coefficient(thresholds_[k].n) * power(m, thresholds_[k].degree);
      const Real margin = values_[recording_.lhs[k]] - values_[recording_.rhs[k]];
      const auto bit = static_cast<ComparisonBits>(1u << k);
      if (!(limit < margin)) not_greater |= bit;
      if (margin < -limit) less |= bit;
    }
    bool all_blocked = true;
    for (const ComparisonBits axis : axis_comparisons) {
      if ((axis & not_greater) == 0) return Verdict::separated;
      all_blocked = all_blocked && (axis & less) != 0;
    }
    return all_blocked ? Verdict::contact : Verdict::undecided;
  }

 private:
  static Real coefficient(int n) { return std::ldexp(static_cast<Real>(n), sizeof(Real) == 4 ? -24 : -53); }
  static Real power(Real m, int degree) {
    const Real m2 = m * m;
    return degree == 2 ? m2 : degree == 4 ? m2 * m2 : (m2 * m2) * m2;
  }

  Recording recording_;
  const Thresholds& thresholds_;
  std::vector<Real> values_;
};

template <class Real>
class FilterKernels : public testing::Test {
 protected:
  static constexpr std::uint64_t seed = 20261122;
  std::mt19937_64 random{seed};

  // A query in [-1, 1); a third have a repeated vertex, and a third a centre that shares a coordinate with each vertex.
  Query<Real> ordinary() {
    Query<Real> q = random_query<Real>(random, false);
    q.r = std::fabs(q.r);
    if (random() % 3 == 0) q.b = q.a;
    if (random() % 3 == 0) q.p = {q.a.x, q.b.y, q.c.z};
    return q;
  }
  Query<Real> scaled(Query<Real> q, int exponent) {
    auto v = coordinates(q);
    for (Real& x : v) x = std::ldexp(x, exponent);
    return from_coordinates(v);
  }
  // Queries of every kind: ordinary, at and beyond the ends of the window, with arbitrary bits.
  QueryBatch<Real> queries(std::size_t count) {
    constexpr int end = sizeof(Real) == 4 ? 19 : 168;
    QueryBatch<Real> all(count, coordinate_count);
    for (std::size_t i = 0; i < count; ++i) {
      const int exponent = static_cast<int>(random() % (2 * end + 9)) - end - 4;
      all.push_back(i % 4 == 0 ? random_query<Real>(random, true) : scaled(ordinary(), i % 4 == 1 ? 0 : exponent));
    }
    return all;
  }
  // Queries at which the program's answer changes, by each coordinate in turn.
  QueryBatch<Real> turns(FilterProgram<Real>& program, std::size_t count) {
    QueryBatch<Real> all(2 * count, coordinate_count);
    for (std::size_t i = 0; all.size() < 2 * count; ++i) {
      const Query<Real> q = ordinary();
      const std::size_t coordinate = i % coordinate_count;
      const Real to = coordinates(ordinary())[coordinate];
      append_turn(q, coordinate, to, program, all);
    }
    return all;
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(FilterKernels, Reals);

template <class Real>
void expect_the_program(const FilterUnderTest& filter, FilterProgram<Real>& program, const QueryBatch<Real>& batch) {
  const std::size_t n = batch.size();
  std::vector<Verdict> expected(n), found(n);
  std::array<int, 3> counts{};
  for (std::size_t i = 0; i < n; ++i) {
    expected[i] = program(batch[i]);
    ++counts[static_cast<std::size_t>(expected[i])];
  }
  for (const int count : counts) EXPECT_GT(count, 0) << filter.kernel << ": an answer never comes";
  for (const std::string& target : available_targets()) {
    find_kernel(filter.kernel).on<Real>(target).verdicts(batch.columns(), found.data());
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(name(found[i]), name(expected[i])) << filter.kernel << " on " << target << ", query " << i;
    }
  }
}

TYPED_TEST(FilterKernels, AnswerAsTheRecordedProgramOfTheTheorem) {
  SCOPED_TRACE(testing::Message() << "seed " << this->seed);
  for (const FilterUnderTest& filter : filters) {
    FilterProgram<TypeParam> program(filter.form, *filter.thresholds);
    expect_the_program(filter, program, this->queries(40'001));  // not a multiple of any vector length
    expect_the_program(filter, program, this->turns(program, 4'000));
  }
}

// These queries depend on the last bit: a threshold greater by one shows, for each kind of comparison. (Not for each
// comparison: where a vertex axis is at its boundary, an edge axis mostly separates too.)
TYPED_TEST(FilterKernels, WouldShowAThresholdThatIsOffByOne) {
  SCOPED_TRACE(testing::Message() << "seed " << this->seed);
  for (const FilterUnderTest& filter : filters) {
    FilterProgram<TypeParam> program(filter.form, *filter.thresholds);
    const QueryBatch<TypeParam> batch = this->turns(program, 3'000);
    std::map<std::string, int> seen;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      Thresholds planted = *filter.thresholds;
      ++planted[k].n;
      FilterProgram<TypeParam> wrong(filter.form, planted);
      const std::string_view name = comparisons[k].name;
      int& of_kind = seen[std::string(name.substr(0, name.find_first_of("_."))) +
                          (comparisons[k].is_radius ? " radius" : " side")];
      for (std::size_t i = 0; i < batch.size(); ++i) of_kind += wrong(batch[i]) != program(batch[i]);
    }
    EXPECT_EQ(seen.size(), 5u);
    for (const auto& [kind, times] : seen) EXPECT_GT(times, 0) << filter.kernel << ", " << kind;
  }
}

}  // namespace
}  // namespace axiscert::proofs
