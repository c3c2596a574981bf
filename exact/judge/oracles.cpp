#include "exact/judge/oracles.h"

#include <fmt/format.h>

#include "kernel/base/error.h"
#include "kernel/predicate_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name)         \
  const Predicate& name##_predicate(); \
  const Oracles& name##_oracles(std::size_t entry);
AXISCERT_PREDICATES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

const Oracles& oracles_of(const Predicate& predicate, std::size_t entry) {
#define AXISCERT_FIND(name) \
  if (&predicate == &name##_predicate()) return name##_oracles(entry);
  AXISCERT_PREDICATES(AXISCERT_FIND)
#undef AXISCERT_FIND
  throw HarnessFault(fmt::format("the predicate '{}' is not on the list of kernel/predicate_list.h", predicate.id));
}

bool is_within_margin(const Distance& distance, double margin) {
  const Rational farthest = distance.reach + exact(margin);
  return distance.squared > distance.reach * distance.reach && distance.squared <= farthest * farthest;
}

namespace {

template <class Real>
std::optional<Verdict> verdict_beyond_rounded(const Oracles& oracles, double threshold, const Numbers<Real>& numbers) {
  const Truth truth = oracles.truth(numbers);
  if (truth.verdict == Verdict::invalid) return std::nullopt;
  const std::optional<double> depth = oracles.depth(numbers);
  return depth && *depth > threshold ? std::optional(truth.verdict) : std::nullopt;
}

Rational relative_margin(const ExactComparison& sides) {
  if (sides.is_undefined) return 0;
  Rational lhs = rational(sides.is_rooted ? BinaryFraction(sides.lhs.over) : sides.lhs);
  Rational rhs = rational(sides.is_rooted ? BinaryFraction(sides.rhs.over) : sides.rhs);
  if (sides.is_rooted) rhs = rhs * abs(rhs);
  const Rational scale = abs(lhs) + abs(rhs);
  return sgn(scale) == 0 ? Rational(0) : Rational((lhs - rhs) / scale);
}

}  // namespace

std::vector<Rational> AskedQuery::relative_margins(const Kernel& kernel, ComparisonBits comparisons) {
  std::vector<Rational> margins;
  const ExactSides* found = sides(kernel);
  if (found == nullptr) return margins;
  for_each_bit(comparisons, [&](std::size_t k) { margins.push_back(relative_margin(found->comparison(k))); });
  return margins;
}

std::optional<Verdict> Oracles::verdict_beyond(double depth, const Numbers<float>& numbers) const {
  return verdict_beyond_rounded(*this, depth, numbers);
}
std::optional<Verdict> Oracles::verdict_beyond(double depth, const Numbers<double>& numbers) const {
  return verdict_beyond_rounded(*this, depth, numbers);
}

std::unique_ptr<BatchOracle<float>> Oracles::batches(std::string_view, std::type_identity<float>) const {
  return std::make_unique<AskedOneByOne<float>>();
}
std::unique_ptr<BatchOracle<double>> Oracles::batches(std::string_view, std::type_identity<double>) const {
  return std::make_unique<AskedOneByOne<double>>();
}

}  // namespace axiscert
