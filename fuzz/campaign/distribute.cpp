#include "fuzz/campaign/distribute.h"

#include <fmt/format.h>
#include <mpfr.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "exact/judge/judge.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// Frees the numbers that MPFR keeps for a thread, which it does not do by itself where the thread ends.
struct ThreadsMpfr {
  ~ThreadsMpfr() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

}  // namespace

Crew::Crew(int threads, Run run) : run_(std::move(run)) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  has_task_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::give(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(task);
  }
  has_task_.notify_one();
}

std::vector<TaskResult> Crew::take(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  has_result_.wait_for(lock, patience, [this] { return failure_ || !results_.empty(); });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return std::exchange(results_, {});
}

void Crew::work() {
  const ThreadsMpfr mpfr;
  std::unique_lock lock(mutex_);
  while (true) {
    has_task_.wait(lock, [this] { return is_over_ || !tasks_.empty(); });
    if (is_over_) return;
    const Task task = tasks_.front();
    tasks_.pop_front();
    lock.unlock();
    TaskResult result{task, {}};
    std::exception_ptr failure;
    try {
      result.bytes = run_(task);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure) failure_ = failure;
    else results_.push_back(std::move(result));
    has_result_.notify_one();
  }
}

namespace {

using Cbor = nlohmann::json;

Cbor fault_json(const std::exception_ptr& fault) {
  try {
    std::rethrow_exception(fault);
  } catch (const OracleDisagreement& d) {
    return {"disagreement", d.what(), d.precision, d.query, d.predicate->id, d.entry};
  } catch (const HarnessFault& f) {
    return {"harness", f.what()};
  } catch (const Error& e) {
    return {"input", e.what()};
  } catch (const std::exception& e) {
    return {"other", e.what()};
  }
}

}  // namespace

std::string fault_message(const std::exception_ptr& fault) {
  std::string bytes;
  Cbor::to_cbor(fault_json(fault), bytes);
  return bytes;
}

void rethrow_fault(std::string_view message, int rank) {
  const Cbor json = Cbor::from_cbor(message);
  const auto kind = json.at(0).get<std::string>(), what = json.at(1).get<std::string>();
  if (kind == "disagreement") {
    OracleDisagreement disagreement("", Numbers<float>(), find_predicate(json.at(4).get<std::string>()));
    json.at(5).get_to(disagreement.entry);
    disagreement.precision = json.at(2).get<Precision>();
    json.at(3).get_to(disagreement.query);
    static_cast<HarnessFault&>(disagreement) = HarnessFault(what);
    throw disagreement;
  }
  if (kind == "harness") throw HarnessFault(what);
  if (kind == "input") throw Error(what);
  throw std::runtime_error(fmt::format("rank {}: {}", rank, what));
}

namespace {

// The time that a process with other ranks sleeps between checks for messages, and a process without others between
// checks for an interrupt. A unit takes 10 ms or more, and a rank already has its next one when it finishes the last; a
// check costs about 20 microseconds.
constexpr std::chrono::milliseconds between_looks{4}, between_interrupts{50};

// A message consists of its kind and its content.
enum class Kind : char { ready = 'r', task = 't', result = 'd', fault = 'f', stop = 's', gone = 'g' };

template <class Content>
std::string message(Kind kind, const Content& content) {
  std::string bytes(1 + sizeof content, static_cast<char>(kind));
  std::memcpy(bytes.data() + 1, &content, sizeof content);
  return bytes;
}
template <class Content>
Content content_of(const std::string& bytes) {
  Content content;
  std::memcpy(&content, bytes.data() + 1, sizeof content);
  return content;
}

std::uint64_t peak_memory() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<std::uint64_t>(use.ru_maxrss) * 1024;
}

}  // namespace

Distributor::Distributor(Crew& crew, Ranks* ranks)
    : crew_(crew), ranks_(ranks), workers_(static_cast<std::size_t>(ranks ? ranks->size() : 1)) {
  workers_[0].use.threads = crew.threads();
}

// Two tasks per thread, so that no thread waits for its next one; one per thread near the end, so that no thread is
// idle while another has a second one queued.
void Distributor::hand_out(const Flow& flow) {
  std::uint64_t threads = 0;
  for (const Worker& worker : workers_) threads += static_cast<std::uint64_t>(worker.use.threads);
  for (std::size_t rank = 0; rank < workers_.size(); ++rank) {
    Worker& worker = workers_[rank];
    while (worker.under_way < static_cast<std::uint64_t>(worker.use.threads) * (flow.left() > 4 * threads ? 2 : 1)) {
      const std::optional<Task> task = flow.next();
      if (!task) return;
      if (rank == 0) crew_.give(*task);
      else ranks_->send(static_cast<int>(rank), message(Kind::task, *task));
      ++worker.under_way;
      ++under_way_;
    }
  }
}

void Distributor::take(int rank, TaskResult result, const Flow& flow) {
  Worker& worker = workers_[static_cast<std::size_t>(rank)];
  --worker.under_way;
  --under_way_;
  ++worker.use.tasks;
  flow.done(std::move(result));
}

void Distributor::receive(const Flow* flow) {
  while (const auto received = ranks_->receive()) {
    Worker& worker = workers_[static_cast<std::size_t>(received->from)];
    const std::string& bytes = received->bytes;
    switch (static_cast<Kind>(bytes[0])) {
      case Kind::ready:
        worker.use.threads = content_of<int>(bytes);
        break;
      case Kind::result:
        if (flow) take(received->from, {content_of<Task>(bytes), bytes.substr(1 + sizeof(Task))}, *flow);
        break;
      case Kind::fault:
        if (flow) rethrow_fault(std::string_view(bytes).substr(1), received->from);
        break;
      case Kind::gone:
        worker.use.peak_memory = content_of<std::uint64_t>(bytes);
        worker.has_left = true;
        break;
      case Kind::task:
      case Kind::stop:
        break;  // only rank 0 sends these
    }
  }
}

void Distributor::run(const Flow& flow) {
  while (true) {
    hand_out(flow);
    if (under_way_ == 0) return;
    for (TaskResult& result : crew_.take(ranks_ ? between_looks : between_interrupts)) take(0, std::move(result), flow);
    if (ranks_) receive(&flow);
  }
}

std::vector<RankUse> Distributor::finish() {
  for (std::size_t rank = 1; rank < workers_.size(); ++rank)
    ranks_->send(static_cast<int>(rank), message(Kind::stop, 0));
  const auto is_here = [](const Worker& worker) { return !worker.has_left; };
  while (std::any_of(workers_.begin() + 1, workers_.end(), is_here)) {
    receive(nullptr);
    std::this_thread::sleep_for(between_looks);
  }
  workers_[0].use.peak_memory = peak_memory();
  std::vector<RankUse> uses;
  for (const Worker& worker : workers_) uses.push_back(worker.use);
  return uses;
}

void serve(Crew& crew, Ranks& ranks) {
  ranks.send(0, message(Kind::ready, crew.threads()));
  while (true) {
    try {
      for (const TaskResult& result : crew.take(between_looks)) {
        ranks.send(0, message(Kind::result, result.task) + result.bytes);
      }
    } catch (...) {
      ranks.send(0, static_cast<char>(Kind::fault) + fault_message(std::current_exception()));
    }
    while (const auto received = ranks.receive()) {
      if (static_cast<Kind>(received->bytes[0]) == Kind::task) crew.give(content_of<Task>(received->bytes));
      else {
        ranks.send(0, message(Kind::gone, peak_memory()));
        return;
      }
    }
  }
}

}  // namespace axiscert
