#include "kernel/permitted/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace axiscert::permitted {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float least_normal = std::numeric_limits<float>::min();
constexpr Reach indeterminate{-infinity, infinity};

Reach checked(Reach r) {
  return std::isfinite(r.least) && std::isfinite(r.greatest) ? r : indeterminate;  // NaN is not finite
}
Reach flushed(const Permissions& permissions, Reach r) {
  if (!permissions.flushed) return r;
  if (r.least > 0 && r.least < least_normal) r.least = 0;
  if (r.greatest < 0 && r.greatest > -least_normal) r.greatest = 0;
  return r;
}
// `nearest` is the float nearest to the exact value; `rest`, by its sign, what is missing.
Reach around(const Permissions& permissions, float nearest, double rest) {
  Reach r{nearest, nearest};
  if (permissions.faithful && rest > 0) r.greatest = std::nextafter(nearest, infinity);
  if (permissions.faithful && rest < 0) r.least = std::nextafter(nearest, -infinity);
  return flushed(permissions, checked(r));
}

Reach negative(Reach r) { return {-r.greatest, -r.least}; }
Reach joined(Reach a, Reach b) { return {std::min(a.least, b.least), std::max(a.greatest, b.greatest)}; }
bool is_indeterminate(Reach r) { return r == indeterminate; }

Reach sum_of(const Permissions& permissions, Reach a, Reach b) {
  if (is_indeterminate(a) || is_indeterminate(b)) return indeterminate;
  return checked(
      {rounded_sum(permissions, a.least, b.least).least, rounded_sum(permissions, a.greatest, b.greatest).greatest});
}
Reach product_of(const Permissions& permissions, Reach a, Reach b) {
  if (is_indeterminate(a) || is_indeterminate(b)) return indeterminate;
  Reach all{infinity, -infinity};
  for (const float x : {a.least, a.greatest}) {
    for (const float y : {b.least, b.greatest}) all = joined(all, rounded_product(permissions, x, y));
  }
  return checked(all);
}
// x y + z, rounded once, to nearest: faithful roundings of product and sum reach at least as far.
Reach fused_of(const Permissions& permissions, Reach a, Reach b, Reach z) {
  if (is_indeterminate(a) || is_indeterminate(b) || is_indeterminate(z)) return indeterminate;
  Reach all{infinity, -infinity};
  for (const float x : {a.least, a.greatest}) {
    for (const float y : {b.least, b.greatest}) {
      all.least = std::min(all.least, std::fma(x, y, z.least));
      all.greatest = std::max(all.greatest, std::fma(x, y, z.greatest));
    }
  }
  return flushed(permissions, checked(all));
}

// Calls split(sub, rest) for each way to part a mask in two, each once.
template <class Split>
void for_each_split(std::uint32_t mask, Split&& split) {
  const std::uint32_t first = mask & (~mask + 1);
  for (std::uint32_t sub = (mask - 1) & mask; sub != 0; sub = (sub - 1) & mask) {
    if ((sub & first) != 0) split(sub, mask & ~sub);
  }
}

}  // namespace

Reach rounded_sum(const Permissions& permissions, float a, float b) {
  const float sum = a + b;
  if (!std::isfinite(sum)) return indeterminate;
  const float of_b = sum - a;
  return around(permissions, sum, (a - (sum - of_b)) + (b - of_b));  // two-sum: the error, exactly
}
Reach rounded_product(const Permissions& permissions, float a, float b) {
  const double exact = static_cast<double>(a) * b;  // 48 bits
  const auto nearest = static_cast<float>(exact);
  if (!std::isfinite(nearest)) return indeterminate;
  return around(permissions, nearest, exact - nearest);
}

Reach Evaluation::of(Value v) const { return v.is_negative ? negative(reach_[v.node]) : reach_[v.node]; }

std::vector<std::uint32_t> Evaluation::kept_nodes() const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < graph_.nodes().size(); ++i) {
    if (graph_.nodes()[i].kind == Kind::kept) found.push_back(i);
  }
  return found;
}

void Evaluation::subsets(const Node& node, std::vector<Reach>& all) const {
  const Permissions& permissions = graph_.permissions();
  const std::size_t count = node.children.size();
  all.resize(std::size_t{1} << count);
  for (std::size_t i = 0; i < count; ++i) all[std::size_t{1} << i] = of(node.children[i]);
  const bool is_sum = node.kind == Kind::sum;
  // A term that is a product, to be fused with the rest of a sum.
  const auto fused = [&](std::uint32_t one, std::uint32_t rest, Reach& r) {
    if (!std::has_single_bit(one)) return;
    const Value term = node.children[static_cast<std::size_t>(std::countr_zero(one))];
    const Node& product = graph_.nodes()[term.node];
    if (product.kind != Kind::product) return;
    std::vector<Reach> factors;
    subsets(product, factors);
    const auto whole = static_cast<std::uint32_t>(factors.size() - 1);
    for_each_split(whole, [&](std::uint32_t x, std::uint32_t y) {
      r = joined(r, fused_of(permissions, term.is_negative ? negative(factors[x]) : factors[x], factors[y], all[rest]));
    });
  };
  for (std::uint32_t mask = 1; mask < all.size(); ++mask) {
    if (std::has_single_bit(mask)) continue;
    std::optional<Reach> r;
    for_each_split(mask, [&](std::uint32_t sub, std::uint32_t rest) {
      Reach here = is_sum ? sum_of(permissions, all[sub], all[rest]) : product_of(permissions, all[sub], all[rest]);
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

void Evaluation::evaluate(std::span<const float> inputs, std::span<const float> kept) {
  const Permissions& permissions = graph_.permissions();
  std::size_t next_kept = 0;
  for (std::size_t i = 0; i < reach_.size(); ++i) {
    const Node& node = graph_.nodes()[i];
    Reach& r = reach_[i];
    switch (node.kind) {
      case Kind::input: {
        const float x = inputs[static_cast<std::size_t>(node.payload)];
        r = flushed(permissions, checked({x, x}));
        break;
      }
      case Kind::constant:
        r = {static_cast<float>(node.payload), static_cast<float>(node.payload)};
        break;
      case Kind::magnitude: {
        const Reach a = of(node.children[0]);
        r = a.least >= 0 ? a : a.greatest <= 0 ? negative(a) : Reach{0, std::max(-a.least, a.greatest)};
        break;
      }
      case Kind::kept:
        r = of(node.children[0]);
        if (!kept.empty()) r = {kept[next_kept], kept[next_kept]};
        ++next_kept;
        break;
      case Kind::sum:
      case Kind::product:
        subsets(node, scratch_);
        r = scratch_.back();
        break;
    }
  }
}

// The evaluation that attains an end of a node, found again by what each choice gives.
struct Text {
  const Evaluation& evaluation;
  std::span<const std::string> names;

  const std::vector<Node>& nodes() const { return evaluation.graph_.nodes(); }
  const Permissions& permissions() const { return evaluation.graph_.permissions(); }

  static float end(Reach r, bool greatest) { return greatest ? r.greatest : r.least; }
  std::string of(Value v, bool greatest) const {
    const std::string text = node(v.node, greatest != v.is_negative);
    return v.is_negative ? "-" + text : text;
  }
  std::string node(std::uint32_t number, bool greatest) const {
    const Node& node = nodes()[number];
    switch (node.kind) {
      case Kind::input:
        return names[static_cast<std::size_t>(node.payload)];
      case Kind::constant:
        return fmt::format("{}", node.payload);
      case Kind::kept:
        return fmt::format("kept({})", of(node.children[0], greatest));
      case Kind::magnitude: {
        const Reach a = evaluation.of(node.children[0]);
        return fmt::format("|{}|", of(node.children[0], greatest == (a.greatest >= -a.least)));
      }
      case Kind::sum:
      case Kind::product: {
        std::vector<Reach> all;
        evaluation.subsets(node, all);
        return subset(node, all, static_cast<std::uint32_t>(all.size() - 1), greatest);
      }
    }
    return {};
  }
  // "up(a + b)" where the end is not the nearest float.
  static std::string marked(std::string text, float value, float nearest) {
    if (value == nearest) return "(" + text + ")";
    return fmt::format("{}({})", value > nearest ? "up" : value < nearest ? "down" : "", text);
  }
  std::string subset(const Node& node, const std::vector<Reach>& all, std::uint32_t mask, bool greatest) const {
    if (std::has_single_bit(mask)) return of(node.children[static_cast<std::size_t>(std::countr_zero(mask))], greatest);
    const float wanted = end(all[mask], greatest);
    std::optional<std::string> found;
    for_each_split(mask, [&](std::uint32_t sub, std::uint32_t rest) {
      if (found) return;
      if (node.kind == Kind::sum) {
        const float x = end(all[sub], greatest), y = end(all[rest], greatest);
        if (end(rounded_sum(permissions(), x, y), greatest) != wanted) return;
        found = marked(subset(node, all, sub, greatest) + " + " + subset(node, all, rest, greatest), wanted, x + y);
        return;
      }
      for (const bool x_greatest : {true, false}) {
        for (const bool y_greatest : {true, false}) {
          const float x = end(all[sub], x_greatest), y = end(all[rest], y_greatest);
          if (found || end(rounded_product(permissions(), x, y), greatest) != wanted) continue;
          found = marked(subset(node, all, sub, x_greatest) + " " + subset(node, all, rest, y_greatest), wanted, x * y);
        }
      }
    });
    for (const Factoring& factoring : node.factorings) {
      if (!found && factoring.mask == mask && end(evaluation.of(factoring.product), greatest) == wanted)
        found = of(factoring.product, greatest);
    }
    return found.value_or("fma(...)");
  }
};

std::string Evaluation::text(Value v, bool greatest, std::span<const std::string> input_names) const {
  std::string text = Text{*this, input_names}.of(v, greatest);
  for (std::size_t at; (at = text.find(" + -")) != text.npos;) text.replace(at, 4, " - ");
  return text;
}

}  // namespace axiscert::permitted
