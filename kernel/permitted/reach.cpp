#include "kernel/permitted/reach.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace axiscert::permitted {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();
constexpr double greatest_float = std::numeric_limits<float>::max();
constexpr double least_normal = std::numeric_limits<float>::min();
// The relative error of one operation: a faithful rounding, with more than what the doubles here may be off.
constexpr double w = 0x1p-23 * 1.001;
constexpr double quotient_roundings = 2.6;  // 2.5 ulp, in w
constexpr double doubles = 0x1p-46;         // what less than 64 operations in doubles may be off, relative

Outer around(double least, double greatest) {
  const double most = std::max(std::fabs(least), std::fabs(greatest));
  return {least + (greatest - least) / 2, (greatest - least) / 2 + most * doubles};
}

}  // namespace

std::uint32_t divisors_of(const Graph& graph, const Node& node) {
  std::uint32_t mask = 0;
  if (node.kind != Kind::product) return mask;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (graph.nodes()[node.children[i].node].kind == Kind::reciprocal) mask |= std::uint32_t{1} << i;
  }
  return mask;
}

void Evaluation::start(std::span<const float> inputs) {
  inputs_ = inputs;
  std::ranges::fill(reach_, std::nullopt);
  std::ranges::fill(outer_, std::nullopt);
  std::ranges::fill(fixed_, std::nullopt);
}

void Evaluation::fix(std::uint32_t kept, std::optional<float> value) {
  std::fill(reach_.begin() + kept, reach_.end(), std::nullopt);  // children come before the nodes that have them
  fixed_[kept] = value;
}

Reach Evaluation::of(Value v) {
  std::optional<Reach>& r = reach_[v.node];
  if (!r) r = found(graph_.nodes()[v.node]);
  return v.is_negative ? negative(*r) : *r;
}

void Evaluation::subsets(const Node& node, std::vector<Reach>& all) {
  const Permissions& permissions = graph_.permissions();
  const std::size_t count = node.children.size();
  for (const Value child : node.children) of(child);  // which may use the same `all`
  for (const Factoring& factoring : node.factorings) of(factoring.product);
  all.resize(std::size_t{1} << count);
  for (std::size_t i = 0; i < count; ++i) all[std::size_t{1} << i] = of(node.children[i]);
  const bool is_sum = node.kind == Kind::sum;
  const std::uint32_t divisors = divisors_of(graph_, node);
  // A term that is a product, to be fused with the rest of a sum.
  const auto fused = [&](std::uint32_t one, std::uint32_t rest, Reach& r) {
    if (!std::has_single_bit(one)) return;
    const Value term = node.children[static_cast<std::size_t>(std::countr_zero(one))];
    const Node& product = graph_.nodes()[term.node];
    if (product.kind != Kind::product || divisors_of(graph_, product) != 0) return;
    std::vector<Reach> factors;
    subsets(product, factors);
    const auto whole = static_cast<std::uint32_t>(factors.size() - 1);
    for_each_split(whole, [&](std::uint32_t x, std::uint32_t y) {
      r = joined(r, fused_of(permissions, term.is_negative ? negative(factors[x]) : factors[x], factors[y], all[rest]));
    });
  };
  for (std::uint32_t mask = 1; mask < all.size(); ++mask) {
    if (std::has_single_bit(mask) || (mask & ~divisors) == 0) continue;
    std::optional<Reach> r;
    for_each_split(mask, [&](std::uint32_t sub, std::uint32_t rest) {
      if ((sub & ~divisors) == 0) std::swap(sub, rest);
      if ((rest & ~divisors) == 0 && !std::has_single_bit(rest)) return;  // one after the other
      Reach here = is_sum                    ? sum_of(permissions, all[sub], all[rest])
                   : (rest & ~divisors) == 0 ? quotient_of(permissions, all[sub], all[rest])
                                             : product_of(permissions, all[sub], all[rest]);
      if (is_sum && permissions.fused && !permissions.faithful) {
        fused(sub, rest, here);
        fused(rest, sub, here);
      }
      r = r ? joined(*r, here) : here;
    });
    for (const Factoring& factoring : node.factorings) {
      if (factoring.mask == mask) r = joined(*r, of(factoring.product));
    }
    all[mask] = checked(*r);
  }
}

Reach Evaluation::found(const Node& node) {
  const Permissions& permissions = graph_.permissions();
  switch (node.kind) {
    case Kind::input: {
      const float x = inputs_[static_cast<std::size_t>(node.payload)];
      return flushed(permissions, checked({x, x}));
    }
    case Kind::constant:
      return {static_cast<float>(node.payload), static_cast<float>(node.payload)};
    case Kind::magnitude: {
      const Reach a = of(node.children[0]);
      const float x = std::fabs(a.least), y = std::fabs(a.greatest);
      return {std::min(x, y), std::max(x, y)};
    }
    case Kind::least:
    case Kind::greatest: {
      const Reach a = of(node.children[0]), b = of(node.children[1]);
      if (node.kind == Kind::least) return {std::min(a.least, b.least), std::min(a.greatest, b.greatest)};
      return {std::max(a.least, b.least), std::max(a.greatest, b.greatest)};
    }
    case Kind::kept: {
      const std::optional<float>& value = fixed_[static_cast<std::size_t>(&node - graph_.nodes().data())];
      return value ? Reach{*value, *value} : of(node.children[0]);
    }
    case Kind::quotient:
      return quotient_of(permissions, of(node.children[0]), of(node.children[1]));
    case Kind::reciprocal:
      return of(node.children[0]);  // it has no value of its own; that of its divisor is what a product asks for
    case Kind::sum:
    case Kind::product:
      subsets(node, scratch_);
      return scratch_.back();
  }
  return {};
}

Outer Evaluation::outer_of(Value v) {
  std::optional<Outer>& r = outer_[v.node];
  if (!r) r = outer_found(graph_.nodes()[v.node]);
  return v.is_negative ? Outer{-r->middle, r->radius} : *r;
}

// Whatever the order and grouping, each term passes at most as many roundings as a node has operations, and a flushed
// result is off by less than 2^-126, times the factors that follow.
Outer Evaluation::outer_found(const Node& node) {
  // The product of the factors that are greater than 1, and of all with their radius, by which what was flushed grows.
  const auto growth = [&](const Node& product) {
    double all = 1;
    for (const Value factor : product.children) {
      const Outer of = outer_of(factor);
      all *= std::max(1.0, std::fabs(of.middle) + of.radius);
    }
    return all;
  };
  switch (node.kind) {
    case Kind::input: {
      const double x = inputs_[static_cast<std::size_t>(node.payload)];
      return {x, !std::isfinite(x) ? unknown : std::fabs(x) < least_normal ? std::fabs(x) : 0};
    }
    case Kind::constant:
      return {static_cast<float>(node.payload), 0};
    case Kind::magnitude: {
      const Outer a = outer_of(node.children[0]);
      return {std::fabs(a.middle), a.radius};
    }
    case Kind::least:
    case Kind::greatest: {
      const Outer a = outer_of(node.children[0]), b = outer_of(node.children[1]);
      const bool is_least = node.kind == Kind::least;
      const auto of_two = [&](double x, double y) { return is_least ? std::min(x, y) : std::max(x, y); };
      const double least = of_two(a.middle - a.radius, b.middle - b.radius),
                   greatest = of_two(a.middle + a.radius, b.middle + b.radius);
      if (!(std::fabs(least) < unknown) || !(std::fabs(greatest) < unknown)) return {0, unknown};
      return around(least, greatest);
    }
    case Kind::kept:
      return outer_of(node.children[0]);
    case Kind::reciprocal: {
      const Outer a = outer_of(node.children[0]);
      const double least = std::fabs(a.middle) - a.radius, greatest = std::fabs(a.middle) + a.radius;
      if (!(least > 2 * least_normal) || !(greatest < 0x1p125)) return {0, unknown};
      const Outer positive = around(1 / greatest, 1 / least);
      return {std::copysign(positive.middle, a.middle), positive.radius};
    }
    case Kind::quotient: {
      const Outer a = outer_of(node.children[0]), b = outer_of(node.children[1]);
      const double least = std::fabs(b.middle) - b.radius;
      if (!(least > 2 * least_normal) || !(std::fabs(b.middle) + b.radius < 0x1p125)) return {0, unknown};
      const double middle = a.middle / b.middle, most = (std::fabs(a.middle) + a.radius) / least;
      if (!(most < greatest_float / 2)) return {0, unknown};
      return {middle, (a.radius + std::fabs(middle) * b.radius) / least + most * quotient_roundings * w + least_normal};
    }
    case Kind::sum: {
      const auto count = static_cast<double>(node.children.size());
      double middle = 0, radius = 0, size = 0, grown = 1, operations = count;
      for (const Value term : node.children) {
        const Outer of = outer_of(term);
        middle += of.middle;
        radius += of.radius;
        size += std::fabs(of.middle) + of.radius;
        const Node& child = graph_.nodes()[term.node];
        if (child.kind != Kind::product) continue;
        grown = std::max(grown, growth(child));
        operations += static_cast<double>(child.children.size());
      }
      // The cofactors of a factor that is taken out are summed.
      if (!(size * 2 < greatest_float) || !(grown * 2 * count < greatest_float)) return {0, unknown};
      return {middle, radius + size * (std::pow(1 + w, count - 1) - 1) + operations * least_normal * grown};
    }
    case Kind::product: {
      double middle = 1, size = 1, roundings = 0;
      for (const Value factor : node.children) {
        const Outer of = outer_of(factor);
        middle *= of.middle;
        size *= std::fabs(of.middle) + of.radius;
        roundings += graph_.nodes()[factor.node].kind == Kind::reciprocal ? quotient_roundings : 1;
      }
      const double grown = growth(node);
      if (!(grown * 2 < greatest_float)) return {0, unknown};
      return {middle, size * std::pow(1 + w, roundings) - std::fabs(middle) +
                          static_cast<double>(node.children.size()) * least_normal * grown};
    }
  }
  return {0, unknown};
}

}  // namespace axiscert::permitted
