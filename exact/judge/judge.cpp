#include "exact/judge/judge.h"

namespace axiscert {
namespace {

// For each link, the bits at which the chain E -> R-infinity -> R -> K breaks at one level; level(bits) is that level's
// bits: those of the comparisons themselves, or of the clauses that hold by them.
template <class LevelOf>
EnumArray<Link, std::uint64_t> broken_links(const Reference& chain, ComparisonBits kernel, LevelOf&& level) {
  EnumArray<Link, std::uint64_t> broken{};
  const auto put = [&](Link link, ComparisonBits before, ComparisonBits after) {
    broken[link] = level(before) ^ level(after);
  };
  const ComparisonBits exact = *chain.exact.bits;
  if (!chain.rounded) {
    put(Link::unattributed, exact, kernel);
    return broken;
  }
  const ComparisonBits range_free = *chain.rounded->range_free.bits, reference = *chain.rounded->reference.bits;
  put(Link::rounding, exact, range_free);
  put(Link::range, range_free, reference);
  put(Link::implementation, reference, kernel);
  return broken;
}

LinkSet verdict_links(Verdict right, const Reference& chain, Verdict kernel) {
  LinkSet links;
  const auto compare = [&](Verdict before, Verdict after, Link link) {
    if (before != after) links.insert(link);
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

void judge_bits(const Predicate& predicate, const Reference& chain, ComparisonBits bits, Verdict verdict,
                Judgement& out) {
  const ComparisonBits exact = *chain.exact.bits;
  const auto clauses = [&](ComparisonBits own) { return clauses_of(predicate, own); };
  const ClauseBits axes = clauses(bits);
  out.comparison_flips = exact ^ bits;
  out.axis_flips = out.exact_axes ^ axes;
  out.broken = broken_links(chain, bits, [](ComparisonBits own) { return own; });
  out.broken_axes = broken_links(chain, bits, clauses);
  if (verdict == verdict_of(predicate, exact)) return;  // nothing flipped the verdict: all masked
  // A wrong verdict has one direction, and so has every flip that can have caused it: the axes that flipped in that
  // direction and, within those axes, the comparisons that did.
  const bool false_separation = verdict == Verdict::separated;
  out.axis_decisive = out.axis_flips & (false_separation ? axes : out.exact_axes);
  ComparisonBits in_those_axes = 0;
  for (std::size_t i = 0; i < predicate.clauses.size(); ++i) {
    if (has_bit(out.axis_decisive, i)) in_those_axes |= predicate.clauses[i].comparisons;
  }
  out.comparison_decisive = out.comparison_flips & in_those_axes & (false_separation ? bits : exact);
}

// The reference on a touching query under a convention other than `contact`, which decides its ties at touching.
Reference by_convention(const Predicate& predicate, Reference chain, TouchingPolicy touching, const Answer& answer) {
  if (!chain.exact.bits) {
    chain.exact.verdict = touching == TouchingPolicy::separated ? Verdict::separated : answer.verdict;
    return chain;
  }
  ComparisonBits open = 0;
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    if (predicate.comparisons[i].ties_at_touching) open |= chain.ties & one_bit<ComparisonBits>(i);
  }
  const ComparisonBits decided = touching == TouchingPolicy::separated ? open : answer.bits.value_or(0);
  const ComparisonBits bits = (*chain.exact.bits & ~open) | (decided & open);
  chain.exact = {verdict_of(predicate, bits), bits};
  return chain;
}

}  // namespace

std::vector<std::string_view> names(LinkSet links) {
  std::vector<std::string_view> all;
  for (const Link link : links) all.push_back(link_names[link]);
  return all;
}

std::string_view name(const Predicate& predicate, const Flip& flip) {
  switch (flip.level) {
    case Level::verdict:
      return "verdict";
    case Level::axis:
      return predicate.clauses[flip.index].name;
    case Level::comparison:
      return predicate.comparisons[flip.index].name;
  }
  return {};
}

std::optional<Verdict> right_verdict(const Truth& truth, TouchingPolicy touching) {
  if (!truth.touching) return truth.verdict;
  switch (touching) {
    case TouchingPolicy::contact:
      return Verdict::contact;
    case TouchingPolicy::separated:
      return Verdict::separated;
    case TouchingPolicy::either:
      return std::nullopt;
  }
  return truth.verdict;
}

Judgement judge(const Predicate& predicate, const Truth& truth, const std::optional<Reference>& reference,
                const Answer& answer, TouchingPolicy touching) {
  Judgement out;
  if (truth.verdict == Verdict::invalid) return out;
  const bool decided = answer.verdict == Verdict::separated || answer.verdict == Verdict::contact;
  const std::optional<Verdict> right = right_verdict(truth, touching);
  if (decided) out.right_of_decided = right;
  if (out.right_of_decided && answer.verdict != *right) {
    out.verdict_flip = answer.verdict == Verdict::separated ? FlipKind::false_separation : FlipKind::false_contact;
  }
  if (!reference) {
    if (out.verdict_flip) out.verdict_links = {Link::unattributed};
    return out;
  }
  const bool conventional = truth.touching && touching != TouchingPolicy::contact && !reference->rounded;
  const Reference chain = conventional ? by_convention(predicate, *reference, touching, answer) : *reference;
  out.exact = chain.exact.bits;
  if (out.exact) out.exact_axes = clauses_of(predicate, *out.exact);
  if (decided && right) out.verdict_links = verdict_links(*right, chain, answer.verdict);
  if (decided && answer.bits && chain.exact.bits) judge_bits(predicate, chain, *answer.bits, answer.verdict, out);
  return out;
}

std::vector<Flip> Judgement::flips() const {
  std::vector<Flip> all;
  for_each_flip([&](const Flip& flip) { all.push_back(flip); });
  return all;
}

}  // namespace axiscert
