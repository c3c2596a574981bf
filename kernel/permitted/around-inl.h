// An interval that holds all that a node may be, in a vector's lanes, for the instruction set that foreach_target is
// compiling: as Evaluation::outer_of, in floats. Everything is rounded upward, so that a radius is never too small; the
// middle of a sum or product is off as the values are that it is to be near, and so counted twice.
#include <limits>

#include "kernel/base/per_target.h"
#include "kernel/permitted/graph.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::permitted {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A radius of infinity: nothing is known.
template <class V>
struct Around {
  V middle, radius;
  V size() const { return hn::Add(hn::Abs(middle), radius); }
};

// of(number) is what was found of a node before.
template <class D, class Of>
class AroundNode {
  using V = hn::Vec<D>;
  using A = Around<V>;
  // The relative error of one operation, with more than what all of a node's operations differ by in the second order.
  static constexpr float w = 0x1p-23F * 1.001F, least_normal = std::numeric_limits<float>::min();
  static constexpr float infinity = std::numeric_limits<float>::infinity();

 public:
  AroundNode(const Graph& graph, Of of) : graph_(graph), of_(of) {}

  AXISCERT_INLINE A of(const Node& node, V column) const {
    const A found = unchecked(node, column);
    const V zero = hn::Zero(d_), most = hn::Set(d_, infinity);
    const auto is_known = hn::And(hn::Lt(hn::Abs(found.middle), most), hn::Lt(found.radius, most));
    return {hn::IfThenElse(is_known, found.middle, zero), hn::IfThenElse(is_known, found.radius, most)};
  }

  A value(Value v) const {
    const A a = of_(v.node);
    return {v.is_negative ? hn::Neg(a.middle) : a.middle, a.radius};
  }

 private:
  AXISCERT_INLINE A unchecked(const Node& node, V column) const {
    const V zero = hn::Zero(d_);
    switch (node.kind) {
      case Kind::input: {
        const V size = hn::Abs(column);
        return {column, hn::IfThenElse(hn::Lt(size, hn::Set(d_, least_normal)), size, zero)};
      }
      case Kind::constant:
        return {hn::Set(d_, static_cast<float>(node.payload)), zero};
      case Kind::kept:
        return value(node.children[0]);
      case Kind::magnitude: {
        const A a = value(node.children[0]);
        return {hn::Abs(a.middle), a.radius};
      }
      case Kind::least:
      case Kind::greatest: {
        const A a = value(node.children[0]), b = value(node.children[1]);
        return {node.kind == Kind::least ? hn::Min(a.middle, b.middle) : hn::Max(a.middle, b.middle),
                hn::Max(a.radius, b.radius)};
      }
      case Kind::quotient:
        return {zero, hn::Set(d_, infinity)};
      case Kind::reciprocal:
        return reciprocal(value(node.children[0]));
      case Kind::sum:
        return sum(node);
      case Kind::product:
        return product(node);
    }
    return {zero, zero};
  }

  V times(V v, double factor) const { return hn::Mul(v, hn::Set(d_, static_cast<float>(factor))); }
  // Where `size` is far from overflow.
  A where_small(V size, A a) const {
    const V most = hn::Set(d_, infinity);
    return {a.middle, hn::IfThenElse(hn::Lt(times(size, 64), most), a.radius, most)};
  }
  // By which what is flushed in a product grows at most.
  V growth(const Node& product) const {
    V all = hn::Set(d_, 1);
    for (const Value factor : product.children) all = hn::Mul(all, hn::Max(hn::Set(d_, 1), of_(factor.node).size()));
    return all;
  }

  A reciprocal(const A& a) const {
    // A difference and a product rounded downward.
    const V size = hn::Abs(a.middle), least = hn::Neg(hn::Sub(a.radius, size)),
            divisor = hn::Neg(hn::Mul(hn::Neg(least), size)), middle = hn::Div(hn::Set(d_, 1), a.middle);
    const auto is_bounded =
        hn::And(hn::Gt(least, hn::Set(d_, 2 * least_normal)), hn::Lt(a.size(), hn::Set(d_, 0x1p125F)));
    const V radius = hn::Add(hn::Div(a.radius, divisor), times(hn::Abs(middle), 2 * w));
    return {middle, hn::IfThenElse(is_bounded, radius, hn::Set(d_, infinity))};
  }
  A sum(const Node& node) const {
    V middle = hn::Zero(d_), radius = middle, size = middle, grown = hn::Set(d_, 1);
    std::size_t operations = node.children.size();
    for (const Value term : node.children) {
      const A a = value(term);
      middle = hn::Add(middle, a.middle);
      radius = hn::Add(radius, a.radius);
      size = hn::Add(size, a.size());
      const Node& child = graph_.nodes()[term.node];
      if (child.kind != Kind::product) continue;
      grown = hn::Max(grown, growth(child));
      operations += child.children.size();
    }
    const double roundings = 2 * static_cast<double>(node.children.size() - 1);
    radius = hn::Add(radius, times(size, roundings * w));
    radius = hn::Add(radius, times(grown, static_cast<double>(operations) * least_normal));
    return where_small(hn::Add(size, grown), {middle, radius});
  }
  A product(const Node& node) const {
    V middle = hn::Set(d_, 1), radius = hn::Zero(d_), size = middle, whole = middle;
    double roundings = 0;
    for (const Value factor : node.children) {
      const A a = value(factor);
      radius = hn::Add(hn::Mul(size, a.radius), hn::Mul(radius, a.size()));
      middle = hn::Mul(middle, a.middle);
      size = hn::Mul(size, hn::Abs(a.middle));
      whole = hn::Mul(whole, a.size());
      roundings += graph_.nodes()[factor.node].kind == Kind::reciprocal ? 3 : 1;
    }
    const V grown = growth(node);
    radius = hn::Add(radius, times(whole, 2 * roundings * w));
    radius = hn::Add(radius, times(grown, static_cast<double>(node.children.size()) * least_normal));
    return where_small(grown, {middle, radius});
  }

  const Graph& graph_;
  Of of_;
  D d_{};
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::permitted
HWY_AFTER_NAMESPACE();
