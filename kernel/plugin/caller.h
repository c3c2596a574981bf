// One call to a plug-in: its inputs placed between the guard pages, its outputs read back and their surroundings
// checked; and how the outputs of two calls differ.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "kernel/kernel.h"
#include "kernel/plugin/host_process.h"

namespace axiscert::plugin {
// The outputs of a call as they were written: a verdict is any byte, and any bit may be set.
template <class Real>
struct Outputs {
  std::vector<std::uint8_t> verdicts;
  // Empty unless asked for.
  std::vector<std::uint64_t> bits;
  std::vector<std::vector<Real>> lhs, rhs;  // by comparison
  std::vector<std::vector<Real>> measures;  // as many as asked for
};

// A kernel of a plug-in, and how it is called.
struct Callee {
  HostedPlugin hosted;
  std::uint32_t index;  // in the plug-in; of a program, that of the precision
  Subject subject;
};

// Where and how a call is made.
struct Arrangement {
  Placement placement = {};
  Exposure asked = Exposure::verdict;
  std::size_t measures = 0;     // asked for
  std::uint8_t filling = 0xa5;  // what the outputs hold before: an entry that still holds it was not written
};

template <class Real>
class Caller {
 public:
  // Nothing is started before the first call, which, like the first after a stop, may take `first_seconds`.
  Caller(const Callee& callee, double first_seconds) : callee_(callee), first_seconds_(first_seconds) {}

  struct Result {
    std::optional<Stop> stop;   // then nothing else holds
    std::optional<Stop> stray;  // it wrote beside an output, where no guard page was
    Reply reply = {};
  };
  // Queries `first` to `first + size` of the batch, at most batch_capacity.
  Result call(const QueryColumns<Real>& batch, std::size_t first, std::size_t size, const Arrangement& arrangement,
              double seconds, Outputs<Real>& out);

 private:
  std::span<std::byte> array(std::size_t which, std::size_t size, Placement placement) const;
  template <class Visit>
  void for_each_output(const Arrangement& arrangement, const Visit& visit) const;

  Callee callee_;
  double first_seconds_;
  std::optional<HostProcess> process_;
};

// Differences between two sets of outputs, in words: "verdict contact, then separated". Only what `b` has is compared;
// a NaN equals any other, since what its bits are is no part of an answer.

// Between the answers to query i of `a` and to query j of `b`.
template <class Real>
std::optional<std::string> difference_at(const Predicate& predicate, const Outputs<Real>& a, std::size_t i,
                                         const Outputs<Real>& b, std::size_t j);

struct Difference {
  std::size_t query;  // of `b`
  std::string detail;
};

// The first. Query i of `b` is query first + i of `a`.
template <class Real>
std::optional<Difference> first_difference(const Predicate& predicate, const Outputs<Real>& a, std::size_t first,
                                           const Outputs<Real>& b);

// "contact", or "7, which is no verdict".
std::string verdict_text(std::uint8_t verdict);
inline bool is_verdict(std::uint8_t byte) { return byte <= static_cast<std::uint8_t>(Verdict::invalid); }

}  // namespace axiscert::plugin
