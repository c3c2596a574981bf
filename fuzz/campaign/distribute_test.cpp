// Tasks over ranks that are threads here: each task is done once, in any order, and a fault of any rank is reported.
#include "fuzz/campaign/distribute.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// Mail between threads in place of MPI.
class Post {
 public:
  void put(int to, Ranks::Message message) {
    const std::lock_guard lock(mutex_);
    boxes_[to].push_back(std::move(message));
  }
  std::optional<Ranks::Message> take(int rank) {
    const std::lock_guard lock(mutex_);
    if (boxes_[rank].empty()) return std::nullopt;
    Ranks::Message message = std::move(boxes_[rank].front());
    boxes_[rank].pop_front();
    return message;
  }

 private:
  std::mutex mutex_;
  std::map<int, std::deque<Ranks::Message>> boxes_;
};

class ThreadRank final : public Ranks {
 public:
  ThreadRank(Post& post, int rank, int size) : post_(post), rank_(rank), size_(size) {}
  int rank() const override { return rank_; }
  int size() const override { return size_; }
  void send(int to, std::string_view bytes) override { post_.put(to, {rank_, std::string(bytes)}); }
  std::optional<Message> receive() override { return post_.take(rank_); }
  void abort(int) override { std::abort(); }

 private:
  Post& post_;
  int rank_, size_;
};

std::string squared(Task task) { return std::to_string(task * task); }

// The other ranks; each stops when rank 0 says so.
class Others {
 public:
  Others(Post& post, int size, const Crew::Run& run) {
    for (int rank = 1; rank < size; ++rank) {
      threads_.emplace_back([&post, rank, size, run] {
        ThreadRank me(post, rank, size);
        Crew crew(2, run);
        serve(crew, me);
      });
    }
  }
  ~Others() {
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::vector<std::thread> threads_;
};

TEST(Distribute, EveryTaskIsDoneOnce) {
  for (const int size : {1, 2, 4}) {
    Post post;
    const Others others(post, size, squared);
    ThreadRank me(post, 0, size);
    Crew crew(2, squared);
    Distributor distributor(crew, size == 1 ? nullptr : &me);
    for (const Task count : {0u, 1u, 500u}) {
      Task next = 0;
      std::map<Task, std::string> done;
      distributor.run({[&] { return next == count ? std::nullopt : std::optional<Task>(next++); },
                       [&] { return count - next; },
                       [&](const TaskResult& result) {
                         EXPECT_TRUE(done.emplace(result.task, result.bytes).second) << result.task;
                       }});
      EXPECT_EQ(done.size(), count);
      for (const auto& [task, bytes] : done) EXPECT_EQ(bytes, squared(task));
    }
    std::uint64_t tasks = 0;
    const auto uses = distributor.finish();
    EXPECT_EQ(uses.size(), static_cast<std::size_t>(size));
    for (const RankUse& use : uses) {
      tasks += use.tasks;
      EXPECT_EQ(use.threads, 2);
      EXPECT_GT(use.peak_memory, 0u);
    }
    EXPECT_EQ(tasks, 501u);
  }
}

// Rank 1 alone meets the fault: the crew of rank 0 does nothing.
template <class Fault>
void expect_told(const Fault& fault, const std::function<void(const Fault&)>& check) {
  Post post;
  const Others others(post, 2, [&](Task) -> std::string { throw fault; });
  ThreadRank me(post, 0, 2);
  Crew crew(1, [](Task) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return std::string();
  });
  Distributor distributor(crew, &me);
  try {
    distributor.run({[] { return std::optional<Task>(7); }, [] { return 1000; }, [](const TaskResult&) {}});
    ADD_FAILURE() << "was not told";
  } catch (const Fault& told) {
    EXPECT_STREQ(told.what(), fault.what());
    check(told);
  }
  distributor.finish();
}

TEST(Distribute, AFaultOfAnotherRankIsToldHere) {
  Query<float> q{};
  q.r = 0x1.8p-140f;
  expect_told<OracleDisagreement>({"two of them", Numbers<float>(q), sphere_triangle_predicate()},
                                  [&](const OracleDisagreement& told) {
                                    EXPECT_EQ(told.predicate, &sphere_triangle_predicate());
                                    EXPECT_EQ(told.precision, Precision::binary32);
                                    EXPECT_THAT(told.query, testing::ElementsAreArray(coordinates(widened(q))));
                                  });
  expect_told<HarnessFault>(HarnessFault("it is"), [](const HarnessFault&) {});
  expect_told<Error>(Error("bad"), [](const Error&) {});
}

}  // namespace
}  // namespace axiscert
