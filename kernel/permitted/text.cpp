// The evaluation that attains an end of a node, found again by what each choice gives.
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "kernel/permitted/reach.h"

namespace axiscert::permitted {

struct Text {
  Evaluation& evaluation;
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
      case Kind::input: {
        const auto i = static_cast<std::size_t>(node.payload);
        return end(evaluation.of({number}), greatest) == evaluation.inputs_[i] ? names[i] : "flushed(" + names[i] + ")";
      }
      case Kind::constant:
        return fmt::format("{}", node.payload);
      case Kind::kept: {
        // Behind it every value may be that of an end; where one is fixed it says which.
        const float value = end(evaluation.of({number}), greatest);
        return fmt::format("kept({})", of(node.children[0], end(evaluation.of(node.children[0]), true) == value));
      }
      case Kind::magnitude: {
        const Reach a = evaluation.of(node.children[0]);
        return fmt::format("|{}|", of(node.children[0], greatest == (std::fabs(a.greatest) >= std::fabs(a.least))));
      }
      case Kind::least:
      case Kind::greatest:
        return fmt::format("{}({}, {})", node.kind == Kind::least ? "min" : "max", of(node.children[0], greatest),
                           of(node.children[1], greatest));
      case Kind::quotient: {
        const float wanted = end(evaluation.of({number}), greatest);
        const auto text = [&](bool greatest_end, const Value v) { return of(v, greatest_end); };
        for (const bool x_end : {true, false}) {
          for (const bool y_end : {true, false}) {
            const float x = end(evaluation.of(node.children[0]), x_end),
                        y = end(evaluation.of(node.children[1]), y_end);
            if (end(rounded_quotient(permissions(), x, y), greatest) == wanted)
              return divided(text(x_end, node.children[0]), text(y_end, node.children[1]), wanted, x, y);
          }
        }
        break;
      }
      case Kind::reciprocal:
        break;
      case Kind::sum:
      case Kind::product: {
        std::vector<Reach> all;
        evaluation.subsets(node, all);
        return subset(node, all, static_cast<std::uint32_t>(all.size() - 1), greatest);
      }
    }
    return "any()";
  }
  // "up(a + b)" where the end is not the nearest float.
  static std::string marked(const std::string& text, float value, float nearest) {
    if (value == nearest) return "(" + text + ")";
    if (value == 0) return "flushed(" + text + ")";
    return fmt::format("{}({})", value > nearest ? "up" : "down", text);
  }
  std::string divided(const std::string& x_text, const std::string& y_text, float value, float x, float y) const {
    const std::string text = x_text + " / " + y_text;
    if (value == x / y || !permissions().divided) return marked(text, value, x / y);
    return fmt::format("near({}, {:.9g})", text, value);
  }
  std::string subset(const Node& node, const std::vector<Reach>& all, std::uint32_t mask, bool greatest) const {
    const auto child = [&](std::uint32_t one) {
      return node.children[static_cast<std::size_t>(std::countr_zero(one))];
    };
    if (std::has_single_bit(mask)) return of(child(mask), greatest);
    const float wanted = end(all[mask], greatest);
    const std::uint32_t divisors = divisors_of(evaluation.graph_, node);
    std::string found;
    const auto sum = [&](std::uint32_t sub, std::uint32_t rest) {
      const float x = end(all[sub], greatest), y = end(all[rest], greatest);
      if (end(rounded_sum(permissions(), x, y), greatest) != wanted) return;
      found = marked(subset(node, all, sub, greatest) + " + " + subset(node, all, rest, greatest), wanted, x + y);
    };
    const auto product = [&](std::uint32_t sub, std::uint32_t rest, bool sub_end, bool rest_end) {
      if ((sub & ~divisors) == 0) std::swap(sub, rest);
      if ((rest & ~divisors) == 0) {
        if (!std::has_single_bit(rest)) return;
        const Value divisor = nodes()[child(rest).node].children[0];
        const float x = end(all[sub], sub_end), y = end(evaluation.of(divisor), rest_end);
        if (end(rounded_quotient(permissions(), x, y), greatest) == wanted)
          found = divided(subset(node, all, sub, sub_end), of(divisor, rest_end), wanted, x, y);
        return;
      }
      const float x = end(all[sub], sub_end), y = end(all[rest], rest_end);
      if (end(rounded_product(permissions(), x, y), greatest) == wanted)
        found = marked(subset(node, all, sub, sub_end) + " " + subset(node, all, rest, rest_end), wanted, x * y);
    };
    for_each_split(mask, [&](std::uint32_t sub, std::uint32_t rest) {
      if (!found.empty()) return;
      if (node.kind == Kind::sum) return sum(sub, rest);
      for (const bool sub_end : {true, false}) {
        for (const bool rest_end : {true, false}) {
          if (found.empty()) product(sub, rest, sub_end, rest_end);
        }
      }
    });
    for (const Factoring& factoring : node.factorings) {
      if (found.empty() && factoring.mask == mask && end(evaluation.of(factoring.product), greatest) == wanted)
        found = of(factoring.product, greatest);
    }
    if (found.empty() && node.kind == Kind::sum) found = fused(node, all, mask, greatest);
    return found.empty() ? "any()" : found;
  }
  // "fma(a, b, c)" of a term that is a product and the rest of a sum.
  std::string fused(const Node& node, const std::vector<Reach>& all, std::uint32_t mask, bool greatest) const {
    const float wanted = end(all[mask], greatest);
    std::string found;
    for (std::uint32_t left = mask; left != 0; left &= left - 1) {
      const std::uint32_t one = left & (~left + 1), rest = mask & ~one;
      const Value term = node.children[static_cast<std::size_t>(std::countr_zero(one))];
      const Node& product = nodes()[term.node];
      if (product.kind != Kind::product) continue;
      std::vector<Reach> factors;
      evaluation.subsets(product, factors);
      for_each_split(static_cast<std::uint32_t>(factors.size() - 1), [&](std::uint32_t x, std::uint32_t y) {
        for (const bool x_end : {true, false}) {
          for (const bool y_end : {true, false}) {
            const float a = end(factors[x], x_end), b = end(factors[y], y_end), z = end(all[rest], greatest);
            if (!found.empty() || std::fma(term.is_negative ? -a : a, b, z) != wanted) continue;
            found = fmt::format("fma({}{}, {}, {})", term.is_negative ? "-" : "", subset(product, factors, x, x_end),
                                subset(product, factors, y, y_end), subset(node, all, rest, greatest));
          }
        }
      });
    }
    return found;
  }
};

std::string Evaluation::text(Value v, bool greatest, std::span<const std::string> input_names) {
  std::string text = Text{*this, input_names}.of(v, greatest);
  for (std::size_t at; (at = text.find(" + -")) != text.npos;) text.replace(at, 4, " - ");
  return text;
}

}  // namespace axiscert::permitted
