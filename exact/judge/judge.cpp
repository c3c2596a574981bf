#include "exact/judge/judge.h"

#include <type_traits>

namespace axiscert {
namespace {

// For each link, the bits at which the chain E -> R-infinity -> R -> K breaks at one level; `of` takes that level's
// bits from comparison bits.
template <class Of>
auto broken_links(const Reference& chain, std::invoke_result_t<Of, ComparisonBits> kernel, Of&& of) {
  using Bits = std::invoke_result_t<Of, ComparisonBits>;
  std::array<Bits, link_count> broken{};
  const auto put = [&](Link link, Bits before, Bits after) {
    broken[static_cast<std::size_t>(link)] = static_cast<Bits>(before ^ after);
  };
  const Bits exact = of(*chain.exact.bits);
  if (!chain.rounded) {
    put(Link::unattributed, exact, kernel);
    return broken;
  }
  const Bits range_free = of(*chain.rounded->range_free.bits), reference = of(*chain.rounded->reference.bits);
  put(Link::rounding, exact, range_free);
  put(Link::range, range_free, reference);
  put(Link::implementation, reference, kernel);
  return broken;
}

LinkBits verdict_links(Verdict right, const Reference& chain, Verdict kernel) {
  LinkBits links = 0;
  const auto compare = [&](Verdict before, Verdict after, Link link) {
    if (before != after) links |= link_bit(link);
  };
  compare(right, chain.exact.verdict, Link::specification);
  if (!chain.rounded) {
    compare(chain.exact.verdict, kernel, Link::unattributed);
    return links;
  }
  compare(chain.exact.verdict, chain.rounded->range_free.verdict, Link::rounding);
  compare(chain.rounded->range_free.verdict, chain.rounded->reference.verdict, Link::range);
  compare(chain.rounded->reference.verdict, kernel, Link::implementation);
  return links;
}

void judge_bits(const Reference& chain, ComparisonBits bits, Verdict verdict, Judgement& out) {
  const ComparisonBits exact = *chain.exact.bits;
  const AxisBits axes = axes_of(bits), exact_axes = axes_of(exact);
  out.comparison_flips = exact ^ bits;
  out.axis_flips = exact_axes ^ axes;
  out.broken = broken_links(chain, bits, [](ComparisonBits own) { return own; });
  out.broken_axes = broken_links(chain, axes, axes_of);
  if (verdict == verdict_of(exact_axes)) return;  // nothing flipped the verdict: all masked
  // A wrong verdict has one direction, and so has every flip that can have caused it: the axes that flipped in that
  // direction and, within those axes, the comparisons that did.
  const bool false_separation = verdict == Verdict::separated;
  out.axis_decisive = out.axis_flips & (false_separation ? axes : exact_axes);
  ComparisonBits in_those_axes = 0;
  for (std::size_t i = 0; i < axis_count; ++i) {
    if ((out.axis_decisive >> i) & 1u) in_those_axes |= comparisons_of(static_cast<Axis>(i));
  }
  out.comparison_decisive = out.comparison_flips & in_those_axes & (false_separation ? bits : exact);
}

// The reference on a touching query under a convention other than `contact`, which decides its radius ties.
Reference by_convention(Reference chain, Touching touching, const Answer& answer) {
  if (!chain.exact.bits) {
    chain.exact.verdict = touching == Touching::separated ? Verdict::separated : answer.verdict;
    return chain;
  }
  const auto open = static_cast<ComparisonBits>(chain.ties & ~side_comparisons);
  const ComparisonBits decided = touching == Touching::separated ? open : answer.bits.value_or(0);
  chain.exact = outcome_of(static_cast<ComparisonBits>((*chain.exact.bits & ~open) | (decided & open)));
  return chain;
}

}  // namespace

std::string_view name(const Flip& flip) {
  switch (flip.level) {
    case Level::verdict:
      return "verdict";
    case Level::axis:
      return axis_names[flip.index];
    case Level::comparison:
      return comparisons[flip.index].name;
  }
  return {};
}

std::optional<Verdict> right_verdict(const Truth& truth, Touching touching) {
  if (!truth.touching) return truth.verdict;
  switch (touching) {
    case Touching::contact:
      return Verdict::contact;
    case Touching::separated:
      return Verdict::separated;
    case Touching::either:
      return std::nullopt;
  }
  return truth.verdict;
}

Judgement judge(const Truth& truth, const std::optional<Reference>& reference, const Answer& answer,
                Touching touching) {
  Judgement out;
  if (truth.verdict == Verdict::invalid) return out;
  const bool decided = answer.verdict == Verdict::separated || answer.verdict == Verdict::contact;
  const std::optional<Verdict> right = right_verdict(truth, touching);
  if (decided && right && answer.verdict != *right) {
    out.verdict_flip = answer.verdict == Verdict::separated ? FlipKind::false_separation : FlipKind::false_contact;
  }
  if (!reference) {
    if (out.verdict_flip) out.verdict_links = link_bit(Link::unattributed);
    return out;
  }
  const bool conventional = truth.touching && touching != Touching::contact && !reference->rounded;
  const Reference chain = conventional ? by_convention(*reference, touching, answer) : *reference;
  out.exact = chain.exact.bits;
  if (decided && right) out.verdict_links = verdict_links(*right, chain, answer.verdict);
  if (decided && answer.bits && chain.exact.bits) judge_bits(chain, *answer.bits, answer.verdict, out);
  return out;
}

std::vector<Flip> Judgement::flips() const {
  std::vector<Flip> all;
  for_each_flip([&](const Flip& flip) { all.push_back(flip); });
  return all;
}

}  // namespace axiscert
