// Runs a plug-in's kernel over batches, again in other arrangements, and tells what it does wrong beside its answers.
#pragma once

#include <mutex>

#include "kernel/base/enums.h"
#include "kernel/plugin/caller.h"
#include "kernel/plugin/reordering.h"

namespace axiscert::plugin {

// Processor time that a plug-in may take, in seconds: for a batch of batch_capacity, in proportion for a shorter one,
// but never less than a tenth. Set before the first plug-in is loaded.
inline double batch_seconds = 1;

// The facts about a kernel that the supervisor needs.
struct SupervisedKernel {
  Callee callee;
  Exposure exposes;
  Strictness strictness;
  std::size_t measures = 0;  // that it gives
};

// Holds one process, started when it is first asked. Asked from one thread at a time; others wait.
template <class Real>
class Supervisor {
 public:
  explicit Supervisor(const SupervisedKernel& kernel) : kernel_(kernel), caller_(kernel.callee, batch_seconds) {}

  // The kernel's answers; `unanswered` where there is none. `explained` is null where the verdicts are enough. After
  // the first stop that is no guard page's, a plug-in is asked query by query, so that the one is found that did it; of
  // a program, whose start may cost as much as many queries, only the parts of that batch. After `most_stops`, not at
  // all: these are all stops of a plug-in, and of a program those that are told and all hangs. With `watched`, each
  // batch is looked at for the faults of FindingKind. Crashes and hangs are told each; of the other kinds the first.
  void run(const QueryColumns<Real>& batch, Verdict* out, Answers<Real>* explained, Watched* watched);

  static constexpr int most_stops = 16;
  // State over all calls so far.
  double nanoseconds() const { return nanoseconds_; }

 private:
  struct Chunk;
  using Result = typename Caller<Real>::Result;

  Result ask(const Chunk& chunk, const Arrangement& arrangement, Outputs<Real>& out);
  void tell(const Chunk& chunk, FindingKind kind, std::size_t query, std::string detail);
  void tell(const Chunk& chunk, const Stop& stop, const std::string& where = {});
  // In place, with all that is asked of the chunk.
  Arrangement whole(const Chunk& chunk, std::uint8_t filling) const;
  void leave_unanswered(const Chunk& chunk);
  void take(const Chunk& chunk, const Outputs<Real>& outputs);
  void run_chunk(const Chunk& chunk);
  void run_singly(const Chunk& chunk, const Stop& of_batch);
  void run_parts(const Chunk& chunk, const Stop& of_batch);
  bool is_program() const { return kernel_.callee.hosted.is_program(); }
  bool repeats(const Chunk& chunk, const Outputs<Real>& outputs);
  void rearrange(const Chunk& chunk, const Outputs<Real>& outputs);
  bool is_to_be_reordered(const Chunk& chunk);
  Reordering<Real> reordering_of(const Chunk& chunk);
  void reorder(const Chunk& chunk, const Outputs<Real>& outputs);
  // Once of each kind.
  void tell_with_cause(const Chunk& chunk, FindingKind kind, std::size_t query, std::string detail);
  void look_for_changed_environment(const Chunk& chunk, std::uint32_t changed);
  void look_for_contradictions(const Chunk& chunk, const Outputs<Real>& outputs);

  SupervisedKernel kernel_;
  Caller<Real> caller_;
  std::mutex mutex_;
  int stops_ = 0;
  double nanoseconds_ = 0;
  bool asks_singly_ = false, rearranges_ = true;
  Anchor anchor_ = Anchor::end;
  std::uint64_t chunks_ = 0, reordered_at_ = 0;
  EnumSet<FindingKind, std::uint16_t> told_;
};

template <class Real>
Implementation<Real> supervised_implementation(const SupervisedKernel& kernel);

}  // namespace axiscert::plugin
