// Stages of a certificate that are ended and continued.
#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <string>

#include "cli/commands/certify.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "plans/search_plan.h"

namespace axiscert {
namespace {

class StagesOfASearch : public testing::Test {
 protected:
  static SearchPlan plan() {
    SearchOptions options;
    options.kernel = "published";
    options.evaluations = 250'000;
    options.first_queries = 64;
    options.threads = 1;
    return search_plan_of(options);
  }
  Stages stages(const std::string& digest = "a plan", bool resume = true) const {
    return Stages(output_, folder_.path(), digest, resume);
  }

  TemporaryFolder folder_;
  OutputFolder output_{folder_.path()};
  std::atomic<bool> interrupted_ = false;
};

TEST_F(StagesOfASearch, AreTheSameHoweverOftenTheyAreEnded) {
  const SearchResult whole = search(plan(), std::nullopt, interrupted_, [](const SearchProgress&) {});
  std::uint64_t reached = 0;
  int ends = 0;
  for (;; ++ends) {
    // Another process, that is interrupted at its first island.
    interrupted_ = false;
    Stages here = stages();
    try {
      const SearchResult result =
          run_resumable_search(plan(), here, "search", 60, interrupted_, [&](const SearchProgress& p) {
            EXPECT_GT(p.evaluations, reached);
            reached = p.evaluations;
            interrupted_ = true;
          });
      EXPECT_EQ(result.finds, whole.finds);
      EXPECT_EQ(result.state, whole.state);
      break;
    } catch (const StageInterrupted&) {
    }
  }
  EXPECT_GT(ends, 3);
}

// With no time between two states, one is kept after each island.
TEST_F(StagesOfASearch, KeepTheirStateAsTimePasses) {
  const SearchResult whole = search(plan(), std::nullopt, interrupted_, [](const SearchProgress&) {});
  Stages here = stages();
  double seconds = 0;
  std::uint64_t islands = 0;
  std::optional<std::string> last;
  const SearchResult result =
      run_resumable_search(plan(), here, "search", 0, interrupted_, [&](const SearchProgress& p) {
        EXPECT_EQ(p.islands, ++islands);
        EXPECT_GE(p.seconds, seconds) << "counted from the beginning";
        seconds = p.seconds;
        const std::optional<std::string> now = stages().state("search");
        EXPECT_EQ(now.has_value(), islands > 1);
        if (now) {
          EXPECT_NE(now, last) << "kept before island " << islands;
        }
        last = now;
      });
  EXPECT_EQ(result.finds, whole.finds);
  EXPECT_EQ(result.state, whole.state);
  EXPECT_GT(islands, 3u);
}

TEST_F(StagesOfASearch, HaveNoStateOnceDoneNorThatOfAnotherPlan) {
  stages().keep_state("search", "half");
  EXPECT_EQ(stages().state("search"), "half");
  EXPECT_EQ(stages().state("other"), std::nullopt);
  EXPECT_EQ(stages("another plan").state("search"), std::nullopt);
  EXPECT_EQ(stages("a plan", false).state("search"), std::nullopt);
  stages().get("search", [] { return Json("done"); });
  EXPECT_EQ(stages().state("search"), std::nullopt);
  EXPECT_EQ(stages().get("search", []() -> Json { throw Error("done again"); }), "done");
}

}  // namespace
}  // namespace axiscert
