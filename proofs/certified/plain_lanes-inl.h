// The functions of Highway that take blocks of queries apart and put them together, over lanes that are numbers: any
// number of them, on any processor. The including file has defined HWY_NAMESPACE.
namespace hwy {
inline void Prefetch(const void*) {}
}  // namespace hwy
namespace hwy::HWY_NAMESPACE {

template <class Lane, std::size_t lanes>
struct Tag {};
template <class Lane, std::size_t lanes>
struct Vector {
  using LaneType = Lane;
  std::array<Lane, lanes> at;
};
template <std::size_t lanes>
struct Flags {
  std::array<bool, lanes> at;
};
template <class D>
struct Of;
template <class Lane_, std::size_t lanes>
struct Of<Tag<Lane_, lanes>> {
  using Lane = Lane_;
  static constexpr std::size_t count = lanes;
};
template <class D>
using TFromD = typename Of<D>::Lane;
template <class To, class D>
using Rebind = Tag<To, Of<D>::count>;
template <class D>
using Vec = Vector<TFromD<D>, Of<D>::count>;
template <class D>
using Mask = Flags<Of<D>::count>;
template <class D>
using RebindToUnsigned = Rebind<std::conditional_t<sizeof(TFromD<D>) == 4, std::uint32_t, std::uint64_t>, D>;
template <class D>
constexpr std::size_t MaxLanes(D) {
  return Of<D>::count;
}

template <class D, class Make>
Vec<D> made_of(D, const Make& make) {
  Vec<D> to;
  for (std::size_t i = 0; i < to.at.size(); ++i) to.at[i] = make(i);
  return to;
}
template <std::size_t n, class Make>
Flags<n> flags_of(const Make& make) {
  Flags<n> to;
  for (std::size_t i = 0; i < n; ++i) to.at[i] = make(i);
  return to;
}
template <class D>
Vec<D> Set(D d, TFromD<D> x) {
  return made_of(d, [&](std::size_t) { return x; });
}
template <class D>
Vec<D> Zero(D d) {
  return Set(d, 0);
}
template <class D>
Vec<D> LoadU(D d, const TFromD<D>* from) {
  return made_of(d, [&](std::size_t i) { return from[i]; });
}
template <class D>
void StoreU(const Vec<D>& v, D, TFromD<D>* to) {
  std::copy(v.at.begin(), v.at.end(), to);
}
template <class D, class From>
Vec<D> PromoteTo(D d, const From& v) {
  return made_of(d, [&](std::size_t i) { return static_cast<TFromD<D>>(v.at[i]); });
}
template <class D, class From>
Vec<D> BitCast(D d, const From& v) {
  return made_of(d, [&](std::size_t i) { return std::bit_cast<TFromD<D>>(v.at[i]); });
}

#define AXISCERT_LANES(Name, expression)                                               \
  template <class Lane, std::size_t n>                                                 \
  Vector<Lane, n> Name(const Vector<Lane, n>& a, const Vector<Lane, n>& b) {           \
    return made_of(Tag<Lane, n>(), [&](std::size_t i) -> Lane { return expression; }); \
  }
AXISCERT_LANES(Mul, a.at[i] * b.at[i])
AXISCERT_LANES(Sub, a.at[i] - b.at[i])
AXISCERT_LANES(And, a.at[i] & b.at[i])
AXISCERT_LANES(Or, a.at[i] | b.at[i])
AXISCERT_LANES(AndNot, ~a.at[i] & b.at[i])
#undef AXISCERT_LANES
template <int bits, class Lane, std::size_t n>
Vector<Lane, n> ShiftLeft(const Vector<Lane, n>& a) {
  return made_of(Tag<Lane, n>(), [&](std::size_t i) -> Lane { return a.at[i] << bits; });
}
template <class Lane, std::size_t n>
Flags<n> Eq(const Vector<Lane, n>& a, const Vector<Lane, n>& b) {
  return flags_of<n>([&](std::size_t i) { return a.at[i] == b.at[i]; });
}
template <std::size_t n>
Flags<n> And(const Flags<n>& a, const Flags<n>& b) {
  return flags_of<n>([&](std::size_t i) { return a.at[i] && b.at[i]; });
}
template <std::size_t n>
Flags<n> Or(const Flags<n>& a, const Flags<n>& b) {
  return flags_of<n>([&](std::size_t i) { return a.at[i] || b.at[i]; });
}
template <class D>
bool AllFalse(D, const Mask<D>& mask) {
  return std::none_of(mask.at.begin(), mask.at.end(), [](bool x) { return x; });
}
template <class D, class From>
Mask<D> RebindMask(D, const From& mask) {
  return mask;
}
// Bits of lanes that are not there have any value in the bytes of another instruction set; here they are 0.
template <class D>
std::size_t StoreMaskBits(D, const Mask<D>& mask, std::uint8_t* to) {
  for (std::size_t i = 0; i < mask.at.size(); ++i) {
    to[i / 8] = static_cast<std::uint8_t>((to[i / 8] & ~(1u << (i % 8))) | (unsigned{mask.at[i]} << (i % 8)));
  }
  return (mask.at.size() + 7) / 8;
}
template <class D>
Mask<D> LoadMaskBits(D, const std::uint8_t* from) {
  return flags_of<Of<D>::count>([&](std::size_t i) { return ((from[i / 8] >> (i % 8)) & 1u) != 0; });
}
template <class D, class Integer>
Integer IndicesFromVec(D, const Integer& from) {
  return from;
}
template <class Lane, std::size_t n, class Integer>
Vector<Lane, n> TableLookupLanes(const Vector<Lane, n>& a, const Integer& from) {
  return made_of(Tag<Lane, n>(), [&](std::size_t i) { return a.at.at(from.at[i]); });
}
// Lanes after those that are kept have any value.
template <class Lane, std::size_t n>
Vector<Lane, n> Compress(const Vector<Lane, n>& a, const Flags<n>& mask) {
  Vector<Lane, n> to = Set(Tag<Lane, n>(), static_cast<Lane>(-7));
  std::size_t next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (mask.at[i]) to.at[next++] = a.at[i];
  }
  return to;
}

}  // namespace hwy::HWY_NAMESPACE
