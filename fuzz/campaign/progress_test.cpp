// Progress is counted from any number of threads, and shown from one at a time.
#include "fuzz/campaign/progress.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace axiscert {
namespace {

TEST(ProgressCount, CountsWhatEveryThreadHasFinished) {
  constexpr std::uint64_t threads = 4, units = 500, queries = 3;
  std::vector<Progress> shown;
  std::atomic<int> showing = 0;
  bool at_once = false;
  const ShowProgress show = [&](const Progress& p) {
    at_once |= showing.fetch_add(1) != 0;
    shown.push_back(p);
    --showing;
  };
  {
    ProgressCount count(show, threads * units, "stage");
    std::vector<std::thread> workers;
    for (std::uint64_t t = 0; t < threads; ++t) {
      workers.emplace_back([&] {
        for (std::uint64_t i = 0; i < units; ++i) {
          count.add_queries(queries);
          count.finish_unit(1);
        }
      });
    }
    for (std::thread& worker : workers) worker.join();
  }
  EXPECT_FALSE(at_once);
  ASSERT_GE(shown.size(), 1 + threads * units);  // when it begins, and each unit
  EXPECT_EQ(shown.front().units_done, 0u);
  EXPECT_EQ(shown.front().units, threads * units);
  EXPECT_EQ(shown.back().units_done, threads * units);
  EXPECT_EQ(shown.back().queries, threads * units * (queries + 1));
  EXPECT_EQ(shown.back().stage, "stage");
  for (std::size_t i = 1; i < shown.size(); ++i) {
    EXPECT_GE(shown[i].units_done, shown[i - 1].units_done);
    EXPECT_GE(shown[i].seconds, shown[i - 1].seconds);
  }
}

TEST(ProgressCount, WithNobodyToShowItToCountsInVain) {
  const ShowProgress nobody;
  ProgressCount count(nobody, 1);
  count.add_queries(1);
  count.finish_unit();
}

}  // namespace
}  // namespace axiscert
