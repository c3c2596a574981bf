// Screens stand between the kernels' answers to a batch and the oracles. A predicate with filters has a screen that
// judges nearly every answer itself (fuzz/sphere_triangle/screen.h); for all others the oracles are asked about every
// query.
#pragma once

#include <memory>
#include <vector>

#include "fuzz/campaign/stages/kernel_run.h"

namespace axiscert {

// Of one unit: its batches in the order of their positions, and of each batch these calls in this order. Kernel `k` is
// number k of the unit's runs, query `i` of the batch. Throws OracleDisagreement where the oracles contradict a filter.
template <class Real>
class Screen {
 public:
  virtual ~Screen() = default;
  // The queries are made and the kernels asked. Counts the steps that decide; takes its own time.
  virtual void decide(const MadeBatch<Real>& batch) = 0;
  virtual void look_at_errors() {}
  // Counts answers with nothing to see in bulk. Whether some kernel's answer to query `i` is left.
  virtual void count_clear() {}
  virtual bool is_open(std::size_t) const { return true; }
  // Whether kernel k's answer to an open query is judged and counted, now or before; else the oracles judge it.
  virtual bool try_judge(std::size_t, std::size_t) { return false; }
  // Open query `i`, for the oracles. Good until another is asked for.
  virtual AskedQuery& about(std::size_t i) = 0;
  // The oracles have judged kernel k's answer to that query. Counts what is to be seen in its sides.
  virtual void look_at_answer(std::size_t k, std::size_t i, const typename KernelRun<Real>::JudgedAnswer& found) = 0;
  // All of the batch is judged: measures what is measured of a sample alone.
  virtual void sample() {}
  // After the last batch: counts what was put off.
  virtual void finish() {}
};

// What a screen works on; all has to outlive it.
template <class Real>
struct ScreenedRuns {
  const JudgingOptions& judging;
  const std::string& target;  // of the filters
  const Oracles& oracles;
  KernelRuns<Real>& runs;        // not empty
  std::uint64_t first_position;  // of the unit
  StepCounts& steps;
  std::uint64_t& second_opinions;
};

// A capability of a predicate: its screens.
class Screens {
 public:
  virtual std::unique_ptr<Screen<float>> screen(const ScreenedRuns<float>& of) const = 0;
  virtual std::unique_ptr<Screen<double>> screen(const ScreenedRuns<double>& of) const = 0;

 protected:
  ~Screens() = default;
};

// That of the kernels' predicate.
template <class Real>
std::unique_ptr<Screen<Real>> screen_of(const ScreenedRuns<Real>& of);

}  // namespace axiscert
