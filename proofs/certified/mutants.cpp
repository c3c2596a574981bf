#include "proofs/certified/mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "proofs/certified/step_queries.h"

namespace axiscert::proofs::certified {
namespace {

bool depends_on_order(Op op) {
  switch (op) {
    case Op::subtract:
    case Op::divide:
    case Op::with_sign:
    case Op::fused:
    case Op::word_subtract:
    case Op::less:
    case Op::at_most:
    case Op::word_less:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::vector<Mutant> mutants_of(const RecordedStep& step) {
  std::vector<Index> ends;
  for (const Result& result : step.results) ends.push_back(result.node);
  std::vector<Mutant> all;
  for (const Index i : step.graph.needed_by(ends)) {
    const Node& node = step.graph.nodes()[i];
    const auto add = [&](std::string fault, const auto& change) {
      Node changed = node;
      change(changed);
      all.push_back({std::move(fault), i, std::move(changed)});
    };
    if (node.op == Op::constant && node.number != 0 && std::isfinite(node.number)) {  // half of infinity is infinity
      add(fmt::format("{:a} halved", node.number), [](Node& n) { n.number /= 2; });
      add(fmt::format("{:a} doubled", node.number), [](Node& n) { n.number *= 2; });
    }
    if (node.op == Op::choose) {
      add(fmt::format("choose {}: the other", i), [](Node& n) { std::swap(n.operands[1], n.operands[2]); });
    } else if (node.op == Op::fused) {
      add(fmt::format("fused {}: a factor exchanged with the term", i),
          [](Node& n) { std::swap(n.operands[1], n.operands[2]); });
    } else if (depends_on_order(node.op)) {
      add(fmt::format("{} {}: operands exchanged", info(node.op).name, i),
          [](Node& n) { std::swap(n.operands[0], n.operands[1]); });
    }
    if (node.op == Op::both || node.op == Op::either) {
      for (const std::size_t kept : {0, 1}) {
        add(fmt::format("{} {}: the {} condition dropped", info(node.op).name, i, kept == 0 ? "second" : "first"),
            [kept](Node& n) { n.operands[1 - kept] = n.operands[kept]; });
      }
    }
  }
  return all;
}

RecordedStep with(const Mutant& mutant, RecordedStep step) {
  step.graph.replace(mutant.at, mutant.node);
  return step;
}

namespace {

constexpr std::string_view few_units =
    "a unit is at most 2^-60 of the greatest number, all are below 2^62 units, and the bound is at most 2^-98 "
    "of the terms' sizes: of degree 2 it is below 2^30 units, so the condition always holds";
constexpr std::string_view radius_nan =
    "a radius that is not a number is not in the range of the bounds, and the answer is not used";
constexpr std::string_view radius_in_range =
    "a radius in the range of the bounds is 0 or at least 2^-100, and a number has at least 2^-101 units: the "
    "product does not underflow";
constexpr std::string_view radius_in_units =
    "the margin is open only where r is |A| within 2^-40 of it, so r's last bit, 2^-53 of r, is a whole "
    "number of units, which are 2^-60 of the greatest or less; else the sign is known before";
constexpr std::string_view first_is_greater =
    "the second operand of this sum is less than 2^-40 of the first, which is a sum of squares: what is lost "
    "of the first is zero, with either sign";
constexpr std::string_view difference_is_exact =
    "where |A| and r differ by less than a half the difference of their squares is exact, and this error of "
    "it is zero either way; where they do not, the margin exceeds its bound by far more than a rounding error";
constexpr std::string_view sign_is_lost = "the sign of a component of N, which is squared or compared with zero";
constexpr std::string_view zero_is_beyond = "a side that is zero counts like one that is positive";
constexpr std::string_view powers_of_two =
    "powers of two: scaling is exact whichever of them it takes, and the greatest component is between 1 and "
    "2 afterwards";
constexpr std::string_view zeros_alone =
    "the greatest component is 0 or, after the scaling before, at least 2^-85 (binary64: 2^-946): only zeros, "
    "which stay zero, meet the limit";
constexpr std::string_view after_scaling =
    "after scaling the greatest component is between 1 and 2: W is between 1 and 12 and the sum of squares at "
    "most 40, or a number is not finite and neither limit decides";
constexpr std::string_view all_zero =
    "after scaling W is at least 1, or all numbers are 0 and nothing separates, a contact with and without "
    "the condition";

constexpr auto all = std::to_array<Equivalent>({
    {"conservative_scaled", 32, "0x1p-100 halved", powers_of_two},
    {"conservative_scaled", 32, "0x1p-100 doubled", powers_of_two},
    {"conservative_scaled", 32, "0x1p+64 halved", powers_of_two},
    {"conservative_scaled", 32, "0x1p+64 doubled", powers_of_two},
    {"conservative_scaled", 32, "0x1p-120 halved", zeros_alone},
    {"conservative_scaled", 32, "0x1p-120 doubled", zeros_alone},
    {"conservative_scaled", 32, "0x1p+60 halved", after_scaling},
    {"conservative_scaled", 32, "0x1p+60 doubled", after_scaling},
    {"conservative_scaled", 32, "0x1p-42 halved", after_scaling},
    {"conservative_scaled", 32, "0x1p-42 doubled", after_scaling},
    {"conservative_scaled", 32, "both 317: the first condition dropped", all_zero},
    {"conservative_scaled", 64, "0x1p-900 halved", powers_of_two},
    {"conservative_scaled", 64, "0x1p-900 doubled", powers_of_two},
    {"conservative_scaled", 64, "0x1p+128 halved", powers_of_two},
    {"conservative_scaled", 64, "0x1p+128 doubled", powers_of_two},
    {"conservative_scaled", 64, "0x1p-1000 halved", zeros_alone},
    {"conservative_scaled", 64, "0x1p-1000 doubled", zeros_alone},
    {"conservative_scaled", 64, "0x1p+400 halved", after_scaling},
    {"conservative_scaled", 64, "0x1p+400 doubled", after_scaling},
    {"conservative_scaled", 64, "0x1p-400 halved", after_scaling},
    {"conservative_scaled", 64, "0x1p-400 doubled", after_scaling},
    {"conservative_scaled", 64, "both 317: the first condition dropped", all_zero},
    {"deep_vertex_radius", 64, "0x1p+60 halved", few_units},
    {"deep_vertex_radius", 64, "0x1p+60 doubled", few_units},
    {"deep_vertex_radius", 64, "both 411: the second condition dropped", few_units},
    {"deep_vertex_radius", 64, "both 304: the first condition dropped", radius_in_units},
    {"deep_vertex_radius", 64, "both 304: the second condition dropped", radius_in_range},
    {"deep_vertex_radius", 64, "both 398: the second condition dropped", radius_in_units},
    {"deep_vertex_radius", 64, "both 316: the first condition dropped", radius_nan},
    {"deep_vertex_radius", 64, "subtract 249: operands exchanged", first_is_greater},
    {"deep_vertex_radius", 64, "subtract 253: operands exchanged", difference_is_exact},
    {"deep_vertex_radius", 64, "subtract 254: operands exchanged", difference_is_exact},
    {"deep_vertex_radius", 64, "subtract 256: operands exchanged", difference_is_exact},
    {"deep_vertex_sides", 64, "0x1p+60 halved", few_units},
    {"deep_vertex_sides", 64, "0x1p+60 doubled", few_units},
    {"deep_vertex_sides", 64, "both 650: the second condition dropped", few_units},
    {"deep_vertex_sides", 64, "both 684: the second condition dropped", few_units},
    {"deep_vertex_sides", 64, "either 653: the first condition dropped", zero_is_beyond},
    {"deep_edge_radius", 64, "both 579: the first condition dropped", radius_nan},
    {"deep_edge_radius", 64, "both 567: the second condition dropped", radius_in_range},
    {"deep_edge_radius", 64, "both 791: the second condition dropped", few_units},
    {"deep_edge_radius", 64, "word_subtract 742: operands exchanged", sign_is_lost},
    {"deep_edge_radius", 64, "word_subtract 745: operands exchanged", sign_is_lost},
    {"deep_edge_radius", 64, "word_subtract 748: operands exchanged", sign_is_lost},
    {"deep_edge_side", 64, "both 945: the second condition dropped", few_units},
    {"deep_edge_side", 64, "either 929: the first condition dropped", zero_is_beyond},
    {"deep_plane_radius", 64, "both 652: the first condition dropped", radius_nan},
    {"deep_plane_radius", 64, "both 640: the second condition dropped", radius_in_range},
    {"deep_plane_radius", 64, "both 948: the second condition dropped", few_units},
});

}  // namespace

std::span<const Equivalent> equivalent_faults() { return all; }

const Equivalent* reason_of_equivalence(const RecordedStep& step, std::string_view fault) {
  const auto found = std::ranges::find_if(
      all, [&](const Equivalent& e) { return e.step == step.name && e.bits == step.bits && e.fault == fault; });
  return found == all.end() ? nullptr : &*found;
}

namespace {

template <class Real>
StepScore score_in(const RecordedStep& step, std::size_t queries, std::uint64_t seed) {
  RecordedAnswers<Real> right(step);
  const QueryBatch<Real> batch = StepQueries<Real>(seed).of(right, queries);
  std::vector<StepAnswers> expected;
  for (std::size_t i = 0; i < batch.size(); ++i) expected.push_back(right(batch[i]));
  StepScore score{.step = step.name, .bits = step.bits};
  for (const Mutant& mutant : mutants_of(step)) {
    const RecordedStep planted = with(mutant, step);
    RecordedAnswers<Real> wrong(planted);
    bool is_seen = false;
    for (std::size_t i = 0; i < batch.size() && !is_seen; ++i) is_seen = wrong(batch[i]) != expected[i];
    const bool is_equivalent = reason_of_equivalence(step, mutant.name) != nullptr;
    ++score.mutants;
    if (is_equivalent) score.equivalent.push_back(mutant.name);
    else if (!is_seen) score.unseen.push_back(mutant.name);
    if (is_equivalent && is_seen)
      score.contradictions.push_back(mutant.name + ": is argued to be equivalent, and shown");
  }
  return score;
}

}  // namespace

StepScore score_of(const RecordedStep& step, std::size_t queries, std::uint64_t seed) {
  return step.bits == 32 ? score_in<float>(step, queries, seed) : score_in<double>(step, queries, seed);
}

}  // namespace axiscert::proofs::certified
