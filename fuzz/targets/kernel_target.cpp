// The kernel target: every oracle on one query, in both precisions, and some kernels beside them. Faults of a published
// kernel guide the target; it ends where the harness is at fault, or a kernel that must never be.
#include <fmt/format.h>

#include <map>

#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/cascade.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/oracles/grid_signs.h"
#include "exact/sphere_triangle/oracles/wide_margins.h"
#include "fuzz/files/query_file.h"
#include "fuzz/targets/margin_bucket.h"
#include "fuzz/targets/query_moves.h"
#include "fuzz/targets/target.h"
#include "kernel/ask.h"
#include "kernel/include/axiscert/certified.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/query.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;

constexpr std::size_t most_kernels = 64;
constexpr std::size_t verdict_counter_count = 2 * most_kernels * 3 * link_count;

// Cleared by libFuzzer before each input; each counter that is not zero afterwards is a feature of the input.
__attribute__((section("__libfuzzer_extra_counters")))
std::uint8_t features[margin_counter_count + verdict_counter_count];

// One query in one precision.
template <class Real>
class Look {
 public:
  explicit Look(const Query<Real>& q) : q_(q) {}

  void at(const Kernel& chosen) {
    truth_ = decided();
    if (!truth_->sides) {
      // The answers to an invalid query are not checked; the kernels only have to return.
      for (const Kernel* kernel : {&chosen, &find_kernel("certified")}) answer_of(*kernel, available_targets().front());
      return;
    }
    check_signs();
    check_distances();
    see_margins();
    check_claims(chosen);
    for (const std::string& target : available_targets()) check_certified(target);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    report_fault(
        fmt::format("{}\n{}", what, query_line({"fuzzed", precision_of<Real>, q_, &sphere_triangle_predicate()})));
  }

  ExactTruth decided() const {
    try {
      return exact_truth(q_, true);
    } catch (const HarnessFault& wrong) {
      fail(wrong.what());
    }
  }

  // Checks every way of deciding the sixteen signs, including those that a cheaper one would have made unnecessary.
  void check_signs() const {
    const Signs expected = signs_of(*truth_->sides);
    const auto check = [&](std::string_view way, const std::optional<Signs>& found) {
      if (!found || *found == expected) return;
      fail(fmt::format(
          "{}: signs {:016b} ties {:016b}; the exact formulae: {:016b} ties {:016b} (bit 0 is the first comparison)",
          way, found->strict, found->ties, expected.strict, expected.ties));
    };
    check("integers", integer_signs(q_));
    check("grid", grid_signs(q_));
    check("wide margins", WideMargins(widened(q_)).signs());
    QueryBatch<Real> one(1, coordinate_count);
    one.push_back(q_);
    for (const std::string& target : available_targets()) {
      FilteredSigns lanes;
      filter_on<Real>(target).signs(one.columns(), &lanes);
      const ComparisonBits wrong =
          ((lanes.signs.strict ^ expected.strict) | (lanes.signs.ties ^ expected.ties)) & lanes.certain;
      if (lanes.is_valid && wrong == 0) continue;
      fail(fmt::format("the filter on {} is certain of {:016b} and wrong at {:016b} (bit 0 is the first comparison)",
                       target, lanes.certain, wrong));
    }
  }

  void check_distances() const {
    const Rational squared = squared_distance(q_);
    const Real exact_one = nearest_sqrt<Real>(squared), found = rounded_distance(q_);
    if (found != exact_one) {
      fail(
          fmt::format("the distance {} was rounded to {}", fmt::format("{:a}", exact_one), fmt::format("{:a}", found)));
    }
    const DepthRange range = depth_range(q_);
    depth_ = depth(q_, squared);
    if (!(range.low <= depth_ && depth_ <= range.high)) {
      fail(fmt::format("the depth {:a} is not in its range [{:a}, {:a}]", depth_, range.low, range.high));
    }
  }

  void see_margins() const {
    const ExactSides& exact = *truth_->sides;
    const Sides<Real> computed = reference_sides(q_);
    for (std::size_t i = 0; i < comparison_count; ++i) {
      const Real lhs = computed.lhs[i], rhs = computed.rhs[i];
      const bool says = lhs > rhs, holds = has_bit(exact.strict, i);
      const bool is_finite = std::isfinite(lhs) && std::isfinite(rhs);
      const SignKind kind = !is_finite      ? SignKind::not_finite
                            : says == holds ? SignKind::right
                            : says          ? SignKind::false_yes
                                            : SignKind::false_no;
      features[margin_counter(precision_of<Real>, static_cast<Comparison>(i), exact.lhs[i].over, exact.rhs[i].over,
                              kind)] = 1;
    }
  }

  Answer answer_of(const Kernel& kernel, const std::string& target) const {
    using StartedKernels = std::map<std::pair<std::string, std::string>, Implementation<Real>>;
    static StartedKernels begun;
    auto& implementation = begun[{kernel.id, target}];
    if (!implementation.verdicts) implementation = kernel.on<Real>(target);
    return ask(implementation, q_).outcome(0);
  }

  // Checks the kernel against its claims, level by level, and the two evaluations of each level against each other.
  void check_claims(const Kernel& kernel) const {
    std::optional<Reference> chain, again;
    try {
      chain = AskedSphereTriangle<Real>(q_, Opinion::second).chain(kernel);
      again = AskedSphereTriangle<Real>(q_, Opinion::exact_only).chain(kernel);
    } catch (const HarnessFault& wrong) {
      fail(wrong.what());
    }
    if (chain && chain->rounded) {
      if (chain->rounded->range_free != again->rounded->range_free ||
          chain->rounded->reference != again->rounded->reference) {
        fail(fmt::format(
            "{}: two evaluations with an unbounded exponent, or of the scalar reference, give different answers",
            kernel.id));
      }
    }
    const bool is_always_right =
        kernel.strictness == Strictness::nonstrict || formulae_of(kernel) == Formulae::minkowski;
    if (chain && is_always_right && chain->exact.verdict != truth_->verdict) {
      fail(fmt::format("{} answers {} in exact arithmetic, the truth is {}", kernel.id, name(chain->exact.verdict),
                       name(truth_->verdict)));
    }
    for (const std::string& target : available_targets()) {
      const Answer answer = answer_of(kernel, target);
      if (chain && chain->rounded && answer.verdict != chain->rounded->reference.verdict) {
        fail(fmt::format("{} on {} says {}, its scalar reference {}", kernel.id, target, name(answer.verdict),
                         name(chain->rounded->reference.verdict)));
      }
      if (chain && chain->rounded && answer.bits && answer.bits != chain->rounded->reference.bits) {
        fail(fmt::format("{} on {} has the comparison bits {:016b}, its scalar reference {:016b}", kernel.id, target,
                         *answer.bits, chain->rounded->reference.bits.value_or(0)));
      }
      see_verdict(kernel, judge(*kernel.predicate, *truth_, chain, answer, kernel.touching));
    }
  }

  void see_verdict(const Kernel& kernel, const Judgement& judgement) const {
    const auto index = static_cast<std::size_t>(&kernel - kernels().data());
    const std::size_t kind = judgement.verdict_flip ? 1 + index_of(*judgement.verdict_flip) : 0;
    for (const Link link : judgement.verdict_links) {
      const std::size_t of_kernel = index_of(precision_of<Real>) * most_kernels + index;
      features[margin_counter_count + (of_kernel * 3 + kind) * link_count + index_of(link)] = 1;
    }
  }

  void check_certified(const std::string& target) const {
    const Verdict exact_one = answer_of(find_kernel("certified"), target).verdict;
    if (exact_one != truth_->verdict) {
      fail(fmt::format("certified on {} answers {}, the truth is {}", target, name(exact_one), name(truth_->verdict)));
    }
    const Verdict careful = answer_of(find_kernel("conservative"), target).verdict;
    const double promised = sizeof(Real) == sizeof(float) ? AXISCERT_PHANTOM_DEPTH_F32 : AXISCERT_PHANTOM_DEPTH_F64;
    const bool is_phantom = careful == Verdict::contact && truth_->verdict == Verdict::separated;
    if (careful != truth_->verdict && (!is_phantom || depth_ > promised)) {
      fail(
          fmt::format("conservative on {} answers {}, the truth is {} by a depth of {}; the promise is no missed "
                      "contact, and a depth of at most {}",
                      target, name(careful), name(truth_->verdict), depth_, promised));
    }
  }

  const Query<Real>& q_;
  std::optional<ExactTruth> truth_;
  mutable double depth_ = 0;
};

FuzzedQuery given(const std::uint8_t* data, std::size_t size) { return fuzzed_query({data, size}); }

std::size_t put(const FuzzedQuery& fuzzed, std::uint8_t* data, std::size_t room) {
  const auto bytes = bytes_of(fuzzed);
  const std::size_t size = std::min(room, bytes.size());
  std::copy_n(bytes.begin(), size, data);
  return size;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedQuery fuzzed = given(data, size);
  // Kernels of sphere-triangle, which are listed first.
  static const auto known =
      static_cast<std::size_t>(std::count_if(kernels().begin(), kernels().end(), [](const Kernel& kernel) {
        return kernel.predicate == &sphere_triangle_predicate();
      }));
  const Kernel& chosen = kernels()[fuzzed.kernel % std::min(known, most_kernels)];
  const auto look = [&](const auto& q) { Look(q).at(chosen); };
  std::visit(look, fuzzed.query);
  change_precision(fuzzed);
  std::visit(look, fuzzed.query);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  FuzzedQuery fuzzed = given(data, size);
  mutate(fuzzed, seed);
  return put(fuzzed, data, room);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data, std::size_t size, const std::uint8_t* other,
                                                 std::size_t other_size, std::uint8_t* out, std::size_t room,
                                                 unsigned seed) {
  FuzzedQuery fuzzed = given(data, size);
  cross(fuzzed, given(other, other_size), seed);
  return put(fuzzed, out, room);
}
