// Kernels and queries of two tests are refused in one line that says which is of which test.
#include "cli/options/test_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/base/error.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const TestDescription& point_box() {
  static const TestDescription test = checked({.id = "point-box",
                                               .asks = "whether a point is in a box",
                                               .touching = "the point is on a face",
                                               .wrong_answers = {},
                                               .entries = {{"low-high", "low <= high", {{"x", Role::coordinate, "p"}}},
                                                           {"centre", "any", {{"c", Role::coordinate, "c"}}}},
                                               .comparisons = {{"x.low", 0}},
                                               .clauses = {{"x", 1}},
                                               .measures = {}});
  return test;
}

class NoQueries final : public ColumnSource<NoQueries> {
 public:
  NoQueries(std::string name, const TestDescription& test, std::size_t entry)
      : name_(std::move(name)), test_(test), entry_(entry) {}
  std::string name() const override { return name_; }
  std::string address_name() const override { return name_; }
  std::string purpose() const override { return ""; }
  int version() const override { return 1; }
  const TestDescription& test() const override { return test_; }
  std::size_t entry() const override { return entry_; }
  template <class Real>
  void fill_columns(std::uint64_t, std::uint64_t, const MutableColumns<Real>&) const {}

 private:
  std::string name_;
  const TestDescription& test_;
  std::size_t entry_;
};

SourcePtr source(const char* name, const TestDescription& test, std::size_t entry = 0) {
  return std::make_shared<NoQueries>(name, test, entry);
}

Kernel kernel_of(const char* id, const TestDescription& test) {
  Kernel kernel;
  kernel.id = id;
  kernel.test = &test;
  return kernel;
}

const Kernel published = kernel_of("published", sphere_triangle_test()),
             strict = kernel_of("point-box/strict", point_box());
const SourcePtr tangent = source("tangent", sphere_triangle_test()), corners = source("point-box/corners", point_box());

TEST(TestOptions, TheTestIsThatOfTheKernelsUnlessItIsGiven) {
  EXPECT_EQ(&test_of_kernels("", {}), &sphere_triangle_test());
  EXPECT_EQ(&test_of_kernels("", {&strict}), &point_box());
  EXPECT_EQ(&test_of_kernels("sphere-triangle", {&published}), &sphere_triangle_test());
  EXPECT_EQ(&test_given(""), &sphere_triangle_test());
  EXPECT_THAT([] { test_given("nosuch"); }, ThrowsMessage<Error>(HasSubstr("unknown test 'nosuch'; tests: ")));
}

TEST(TestOptions, KernelsOfTwoTestsAreRefused) {
  EXPECT_THAT(
      [] {
        test_of_kernels("", {&published, &strict});
      },
      ThrowsMessage<Error>("kernel 'published' is of the test sphere-triangle, and kernel 'point-box/strict' of "
                           "point-box; a run judges kernels of one test"));
  EXPECT_THAT([] { test_of_kernels("sphere-triangle", {&strict}); },
              ThrowsMessage<Error>("kernel 'point-box/strict' is of the test point-box, and --test is sphere-triangle; "
                                   "a run judges kernels of one test"));
}

TEST(TestOptions, AKernelIsJudgedOnQueriesOfItsTestAndEntry) {
  EXPECT_NO_THROW(require_one_test({&published}, {tangent}));
  EXPECT_NO_THROW(require_one_test({&strict}, {corners}));
  EXPECT_THAT(
      [] {
        require_one_test({&strict}, {corners, tangent});
      },
      ThrowsMessage<Error>("kernel 'point-box/strict' is of the test point-box, and family 'tangent' of "
                           "sphere-triangle; a run judges kernels of one test (--test)"));
  const SourcePtr centred = source("point-box/centred", point_box(), 1);
  EXPECT_THAT(
      [&] { require_one_test({&strict}, {centred}); },
      ThrowsMessage<Error>("kernel 'point-box/strict' takes the entry low-high of the test point-box, and family "
                           "'point-box/centred' has centre; a kernel is judged on queries of its own entry"));
}

TEST(TestOptions, QueriesOfTwoTestsAreRefused) {
  EXPECT_EQ(&test_of_sources("", {corners}), &point_box());
  EXPECT_EQ(&test_of_sources("", {}), &sphere_triangle_test());
  EXPECT_THAT(
      [] {
        test_of_sources("", {tangent, corners});
      },
      ThrowsMessage<Error>("family 'point-box/corners' is of the test point-box, and family 'tangent' of "
                           "sphere-triangle; queries of one test go together (--test)"));
  EXPECT_THAT(
      [] { test_of_sources("sphere-triangle", {corners}); },
      ThrowsMessage<Error>("family 'point-box/corners' is of the test point-box, and --test is sphere-triangle; "
                           "queries of one test go together"));
}

TEST(TestOptions, ACommandOfOneTestSaysWhichItServes) {
  EXPECT_NO_THROW(require_served("search", sphere_triangle_test(), tests_with(has_formulae)));
  EXPECT_THAT([] { require_served("search", point_box(), tests_with(has_formulae)); },
              ThrowsMessage<Error>("search does not serve the test point-box yet; it serves sphere-triangle"));
}

}  // namespace
}  // namespace axiscert
