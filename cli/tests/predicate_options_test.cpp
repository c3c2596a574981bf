// Kernels and queries of two predicates are refused in one line that says which is of which.
#include "plans/predicate_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const Predicate& point_box() {
  static const Predicate predicate = checked({.id = "point-box",
                                              .asks = "whether a point is in a box",
                                              .touching = "the point is on a face",
                                              .wrong_answers = {},
                                              .entries = {{"low-high", "low <= high", {{"x", Role::coordinate, "p"}}},
                                                          {"centre", "any", {{"c", Role::coordinate, "c"}}}},
                                              .comparisons = {{"x.low", 0}},
                                              .clauses = {{"x", 1}},
                                              .measures = {}});
  return predicate;
}

class NoQueries final : public Source {
 public:
  NoQueries(std::string name, const Predicate& predicate, std::size_t entry)
      : name_(std::move(name)), predicate_(predicate), entry_(entry) {}
  std::string name() const override { return name_; }
  std::string address_name() const override { return name_; }
  std::string purpose() const override { return ""; }
  int version() const override { return 1; }
  const Predicate& predicate() const override { return predicate_; }
  std::size_t entry() const override { return entry_; }
  void fill_columns(std::uint64_t, std::uint64_t, const MutableColumns<float>&) const override {}
  void fill_columns(std::uint64_t, std::uint64_t, const MutableColumns<double>&) const override {}

 private:
  std::string name_;
  const Predicate& predicate_;
  std::size_t entry_;
};

SourcePtr source(const char* name, const Predicate& predicate, std::size_t entry = 0) {
  return std::make_shared<NoQueries>(name, predicate, entry);
}

Kernel kernel_of(const char* id, const Predicate& predicate) {
  Kernel kernel;
  kernel.id = id;
  kernel.predicate = &predicate;
  return kernel;
}

const Kernel published = kernel_of("published", sphere_triangle_predicate()),
             strict = kernel_of("point-box/strict", point_box());
const SourcePtr tangent = source("tangent", sphere_triangle_predicate()),
                corners = source("point-box/corners", point_box());

TEST(PredicateOptions, ThePredicateIsThatOfTheKernelsUnlessItIsGiven) {
  EXPECT_EQ(&predicate_of_kernels("", {}), &sphere_triangle_predicate());
  EXPECT_EQ(&predicate_of_kernels("", {&strict}), &point_box());
  EXPECT_EQ(&predicate_of_kernels("sphere-triangle", {&published}), &sphere_triangle_predicate());
  EXPECT_EQ(&predicate_given(""), &sphere_triangle_predicate());
  EXPECT_THAT([] { predicate_given("nosuch"); },
              ThrowsMessage<Error>(HasSubstr("unknown predicate 'nosuch'; predicates: ")));
}

TEST(PredicateOptions, KernelsOfTwoPredicatesAreRefused) {
  EXPECT_THAT(
      [] {
        predicate_of_kernels("", {&published, &strict});
      },
      ThrowsMessage<Error>("kernel 'published' is of the predicate sphere-triangle, and kernel 'point-box/strict' of "
                           "point-box; a run judges kernels of one predicate"));
  EXPECT_THAT([] { predicate_of_kernels("sphere-triangle", {&strict}); },
              ThrowsMessage<Error>(
                  "kernel 'point-box/strict' is of the predicate point-box, and --predicate is sphere-triangle; "
                  "a run judges kernels of one predicate"));
}

TEST(PredicateOptions, AKernelIsJudgedOnQueriesOfItsPredicateAndEntry) {
  EXPECT_NO_THROW(require_one_predicate({&published}, {tangent}));
  EXPECT_NO_THROW(require_one_predicate({&strict}, {corners}));
  EXPECT_THAT(
      [] {
        require_one_predicate({&strict}, {corners, tangent});
      },
      ThrowsMessage<Error>("kernel 'point-box/strict' is of the predicate point-box, and family 'tangent' of "
                           "sphere-triangle; a run judges kernels of one predicate (--predicate)"));
  const SourcePtr centred = source("point-box/centred", point_box(), 1);
  EXPECT_THAT(
      [&] { require_one_predicate({&strict}, {centred}); },
      ThrowsMessage<Error>("kernel 'point-box/strict' takes the entry low-high of the predicate point-box, and family "
                           "'point-box/centred' has centre; a kernel is judged on queries of its own entry"));
}

TEST(PredicateOptions, QueriesOfTwoPredicatesAreRefused) {
  EXPECT_EQ(&predicate_of_sources("", {corners}), &point_box());
  EXPECT_EQ(&predicate_of_sources("", {}), &sphere_triangle_predicate());
  EXPECT_THAT(
      [] {
        predicate_of_sources("", {tangent, corners});
      },
      ThrowsMessage<Error>("family 'point-box/corners' is of the predicate point-box, and family 'tangent' of "
                           "sphere-triangle; queries of one predicate go together (--predicate)"));
  EXPECT_THAT([] { predicate_of_sources("sphere-triangle", {corners}); },
              ThrowsMessage<Error>(
                  "family 'point-box/corners' is of the predicate point-box, and --predicate is sphere-triangle; "
                  "queries of one predicate go together"));
}

TEST(PredicateOptions, ACommandOfOnePredicateSaysWhichItServes) {
  EXPECT_NO_THROW(require_served("search", sphere_triangle_predicate(), predicates_with(has_formulae)));
  EXPECT_THAT([] { require_served("search", point_box(), predicates_with(has_formulae)); },
              ThrowsMessage<Error>("search does not serve the predicate point-box yet; it serves sphere-triangle"));
}

}  // namespace
}  // namespace axiscert
