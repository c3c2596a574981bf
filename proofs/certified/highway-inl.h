// The functions of Highway that the steps of the certified predicate call, over lanes that are nodes of a graph: each
// call appends its operation. The including file has defined HWY_NAMESPACE and HWY_NATIVE_FMA. No include guard:
// included once for each.
//
// Without fused multiply-add MulAdd and its like are a product and a sum, as in Highway, with the operands of the sum
// in the order of the theory: a rounded sum does not depend on it.
namespace hwy::HWY_NAMESPACE {
namespace graph = axiscert::proofs::certified;
using graph::Index, graph::Op;

template <class Lane, std::size_t lanes>
struct Tag {};
template <class Lane, std::size_t lanes>
struct Symbols {
  using LaneType = Lane;
  std::array<Index, lanes> at;
};
template <class Lane, std::size_t lanes>
struct Flags {
  std::array<Index, lanes> at;
};

template <class D>
struct Of;
template <class Lane_, std::size_t lanes>
struct Of<Tag<Lane_, lanes>> {
  using Lane = Lane_;
  using Vector = Symbols<Lane, lanes>;
  using Mask = Flags<Lane, lanes>;
  using Unsigned = Tag<std::conditional_t<sizeof(Lane) == 4, std::uint32_t, std::uint64_t>, lanes>;
  using SignedTag = Tag<std::conditional_t<sizeof(Lane) == 4, std::int32_t, std::int64_t>, lanes>;
  static constexpr std::size_t count = lanes;
};
template <class D>
using TFromD = typename Of<D>::Lane;
template <class D>
using Vec = typename Of<D>::Vector;
template <class D>
using Mask = typename Of<D>::Mask;
template <class D>
using RebindToUnsigned = typename Of<D>::Unsigned;
template <class D>
using RebindToSigned = typename Of<D>::SignedTag;
template <class To, class D>
using Rebind = Tag<To, Of<D>::count>;
template <class D>
constexpr std::size_t MaxLanes(D) {
  return Of<D>::count;
}

// Lane by lane; the kinds of lanes are those of the first result and of the operands.
template <class To, class... From>
To of_lanes(Op op, const From&... from) {
  To to;
  for (std::size_t i = 0; i < to.at.size(); ++i) to.at[i] = graph::recorder->node(op, {from.at[i]...});
  return to;
}
template <class To>
To everywhere(Index node) {
  To to;
  to.at.fill(node);
  return to;
}

template <class D>
Vec<D> Set(D, TFromD<D> x) {
  if constexpr (std::is_floating_point_v<TFromD<D>>) return everywhere<Vec<D>>(graph::node_of(x));
  else return everywhere<Vec<D>>(graph::recorder->word(static_cast<std::make_unsigned_t<TFromD<D>>>(x)));
}
template <class D>
Vec<D> Zero(D d) {
  return Set(d, TFromD<D>{});
}
template <class D>
Vec<D> Load(D, const TFromD<D>* from) {
  Vec<D> to;
  for (std::size_t i = 0; i < to.at.size(); ++i) to.at[i] = graph::node_of(from[i]);
  return to;
}

// of numbers: operations on words of these names are not recorded
#define AXISCERT_RECORDED_NUMBER(Name, op, ...)                                                           \
  template <class Lane, std::size_t n, std::same_as<Symbols<Lane, n>>... More>                            \
  Symbols<Lane, n> Name(const Symbols<Lane, n>& a, const More&... more) {                                 \
    static_assert(std::is_floating_point_v<Lane> && sizeof...(More) + 1 == graph::info(Op::op).operands); \
    return of_lanes<Symbols<Lane, n>>(Op::op, a, more...);                                                \
  }
// of numbers and words
#define AXISCERT_RECORDED_EITHER(Name, op, word_op)                                                 \
  template <class Lane, std::size_t n>                                                              \
  Symbols<Lane, n> Name(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {                     \
    return of_lanes<Symbols<Lane, n>>(std::is_floating_point_v<Lane> ? Op::op : Op::word_op, a, b); \
  }
AXISCERT_RECORDED_NUMBER(Neg, negate)
AXISCERT_RECORDED_NUMBER(Abs, magnitude)
AXISCERT_RECORDED_NUMBER(Trunc, truncate)
AXISCERT_RECORDED_NUMBER(Div, divide)
AXISCERT_RECORDED_NUMBER(Min, least)
AXISCERT_RECORDED_NUMBER(Max, greatest)
AXISCERT_RECORDED_NUMBER(CopySignToAbs, with_sign)
AXISCERT_RECORDED_EITHER(Add, add, word_add)
AXISCERT_RECORDED_EITHER(Sub, subtract, word_subtract)
AXISCERT_RECORDED_EITHER(Mul, multiply, word_multiply)
#undef AXISCERT_RECORDED_NUMBER
#undef AXISCERT_RECORDED_EITHER
template <class Lane, std::size_t n>
Symbols<Lane, n> operator*(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  return Mul(a, b);
}

template <class V>
V MulAdd(const V& a, const V& b, const V& c) {
#if HWY_NATIVE_FMA
  return of_lanes<V>(Op::fused, a, b, c);
#else
  return Add(c, Mul(a, b));
#endif
}
template <class V>
V NegMulAdd(const V& a, const V& b, const V& c) {
#if HWY_NATIVE_FMA
  return of_lanes<V>(Op::fused, Neg(a), b, c);
#else
  return Sub(c, Mul(a, b));
#endif
}
template <class V>
V MulSub(const V& a, const V& b, const V& c) {
#if HWY_NATIVE_FMA
  return of_lanes<V>(Op::fused, a, b, Neg(c));
#else
  return Sub(Mul(a, b), c);
#endif
}

// Comparisons. A number is never compared with a word.
template <class Lane, std::size_t n>
Flags<Lane, n> Eq(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  return of_lanes<Flags<Lane, n>>(std::is_floating_point_v<Lane> ? Op::equal : Op::word_equal, a, b);
}
template <class Lane, std::size_t n>
Flags<Lane, n> Lt(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  return of_lanes<Flags<Lane, n>>(std::is_floating_point_v<Lane> ? Op::less : Op::word_less, a, b);
}
template <class Lane, std::size_t n>
Flags<Lane, n> Gt(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  return Lt(b, a);
}
template <class Lane, std::size_t n>
Flags<Lane, n> Le(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  static_assert(std::is_floating_point_v<Lane>);
  return of_lanes<Flags<Lane, n>>(Op::at_most, a, b);
}
template <class Lane, std::size_t n>
Flags<Lane, n> Ge(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  return Le(b, a);
}
template <class Lane, std::size_t n>
Flags<Lane, n> Not(const Flags<Lane, n>& a) {
  return of_lanes<Flags<Lane, n>>(Op::opposite, a);
}
template <class Lane, std::size_t n>
Flags<Lane, n> Ne(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  return Not(Eq(a, b));
}

// Flags, and the bits of words. The bits of two numbers are only joined to ask whether both are zero.
template <class Lane, std::size_t n>
Flags<Lane, n> And(const Flags<Lane, n>& a, const Flags<Lane, n>& b) {
  return of_lanes<Flags<Lane, n>>(Op::both, a, b);
}
template <class Lane, std::size_t n>
Flags<Lane, n> Or(const Flags<Lane, n>& a, const Flags<Lane, n>& b) {
  return of_lanes<Flags<Lane, n>>(Op::either, a, b);
}
template <class Lane, std::size_t n>
Flags<Lane, n> AndNot(const Flags<Lane, n>& a, const Flags<Lane, n>& b) {
  return And(Not(a), b);
}
template <class Lane, std::size_t n>
Symbols<Lane, n> And(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  static_assert(std::is_integral_v<Lane>);
  return of_lanes<Symbols<Lane, n>>(Op::word_and, a, b);
}
template <class D, class From>
Vec<D> BitCast(D, const From& from);
template <class Lane, std::size_t n>
Symbols<Lane, n> Or(const Symbols<Lane, n>& a, const Symbols<Lane, n>& b) {
  if constexpr (std::is_integral_v<Lane>) {
    return of_lanes<Symbols<Lane, n>>(Op::word_or, a, b);
  } else {
    const RebindToUnsigned<Tag<Lane, n>> words;
    return BitCast(Tag<Lane, n>(), Or(BitCast(words, a), BitCast(words, b)));
  }
}

template <class V, class M>
V IfThenElse(const M& mask, const V& yes, const V& no) {
  return of_lanes<V>(Op::choose, mask, yes, no);
}
template <class Lane, std::size_t n>
Symbols<Lane, n> IfThenZeroElse(const Flags<Lane, n>& mask, const Symbols<Lane, n>& no) {
  return IfThenElse(mask, Zero(Tag<Lane, n>()), no);
}
template <class Lane, std::size_t n>
Symbols<Lane, n> IfThenElseZero(const Flags<Lane, n>& mask, const Symbols<Lane, n>& yes) {
  return IfThenElse(mask, yes, Zero(Tag<Lane, n>()));
}

// Other readings of the same lanes.
template <class D, class From>
Vec<D> BitCast(D, const From& from) {
  using To = TFromD<D>;
  static_assert(std::tuple_size_v<decltype(from.at)> == Of<D>::count);
  constexpr bool from_number = std::is_floating_point_v<typename From::LaneType>;
  if constexpr (from_number == std::is_floating_point_v<To>) return {from.at};
  else return of_lanes<Vec<D>>(from_number ? Op::bits : Op::from_bits, from);
}
template <class D, class From>
Vec<D> ConvertTo(D, const From& from) {
  return of_lanes<Vec<D>>(std::is_floating_point_v<TFromD<D>> ? Op::from_integer : Op::to_integer, from);
}
template <class D>
Vec<D> VecFromMask(D d, const Mask<D>& mask) {
  return BitCast(d, of_lanes<Vec<RebindToUnsigned<D>>>(Op::all_ones, mask));
}
// Only zeros are made masks of.
template <class Lane, std::size_t n>
Flags<Lane, n> MaskFromVec(const Symbols<Lane, n>& zero) {
  if (zero.at != Zero(Tag<Lane, n>()).at) throw std::logic_error("MaskFromVec is recorded of zero only");
  return everywhere<Flags<Lane, n>>(graph::recorder->flag(false));
}
template <class D, class From>
Mask<D> RebindMask(D, const From& from) {
  return {from.at};
}
template <class D>
Mask<D> FirstN(D, std::size_t n) {
  Mask<D> to;
  for (std::size_t i = 0; i < to.at.size(); ++i) to.at[i] = graph::recorder->flag(i < n);
  return to;
}
// A word of fewer bits is recorded as the word, of which only low bits are set.
template <class D, class From>
Vec<D> TruncateTo(D, const From& from) {
  return {from.at};
}

// Lanes moved to other places.
template <class D, class Integer>
const Integer* SetTableIndices(D, const Integer* from) {
  return from;
}
template <class Lane, std::size_t n, class Integer>
Symbols<Lane, n> TableLookupLanes(const Symbols<Lane, n>& a, const Integer* from) {
  Symbols<Lane, n> to;
  for (std::size_t i = 0; i < n; ++i) to.at[i] = a.at[static_cast<std::size_t>(from[i])];
  return to;
}

// A question about all lanes together, which decides what is computed: kept, and answered as the recorder says.
template <class D>
bool AllTrue(D, const Mask<D>& mask) {
  return graph::answer_to({true, {mask.at.begin(), mask.at.end()}});
}
template <class D>
bool AllFalse(D, const Mask<D>& mask) {
  return graph::answer_to({false, {mask.at.begin(), mask.at.end()}});
}

}  // namespace hwy::HWY_NAMESPACE
