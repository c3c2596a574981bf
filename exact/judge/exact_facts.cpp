#include "exact/judge/exact_facts.h"

namespace axiscert {
namespace {

std::string decimal_of(const RootNumber& x, int digits) { return decimal_text(x, digits); }
std::string decimal_of(const ExactDepth& depth, int digits) {
  if (compare(depth, ExactDepth{0, 0, 1}) == 0) return "0";
  const Rational of_length = approximate_magnitude({-depth.r, depth.dd}) / root_below(depth.ss);
  return decimal_text(
      of_length,
      [&](const Rational& y) {
        return compare(depth, ExactDepth{0, y, 1});
      },
      digits);
}

std::string exactly(const RootNumber& x) { return exact_text(x); }
std::string exactly(const ExactDepth& depth) {
  const auto& [dd, r, ss] = depth;
  if (sgn(r) == 0) return exact_text(RootNumber{0, Rational(dd / ss)});
  const std::optional<Rational> d = rational_root(dd);
  if (!d) {
    const std::string scene = exact_text(RootNumber{0, ss});
    const bool is_fraction = !scene.starts_with("sqrt") && scene.find('/') != scene.npos;
    return "|sqrt(" + dd.get_str() + ") - " + r.get_str() + "| / " + (is_fraction ? "(" + scene + ")" : scene);
  }
  const Rational length = *d - r;
  return exact_text(RootNumber{0, Rational(length * length / ss)});
}

}  // namespace

ExactFact place_fact(std::string_view name, const Rational& x, const Rational& y, const Rational& z) {
  return {name, {RootNumber{x}, RootNumber{y}, RootNumber{z}}};
}

ExactFact direction_fact(std::string_view name, const Rational& x, const Rational& y, const Rational& z) {
  ExactFact fact{name};
  const Rational squared = x * x + y * y + z * z;
  if (sgn(squared) == 0) return fact;
  for (const Rational* of : {&x, &y, &z}) fact.numbers.emplace_back(share_of_length(*of, squared));
  return fact;
}

std::string decimal_text(const ExactValue& value, int digits) {
  return std::visit([&](const auto& x) { return decimal_of(x, digits); }, value);
}
std::string exact_text(const ExactValue& value) {
  return std::visit([](const auto& x) { return exactly(x); }, value);
}

}  // namespace axiscert
