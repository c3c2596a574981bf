// Formulae of one's own, written once for every number type: judged in float and double, and in exact arithmetic.
//
//     #include <axiscert/formulae.hpp>
//     struct Mine {
//       template <class T>
//       static bool separated(const axiscert::formulae::Query<T>& q) { ... }  // T has + - * / and comparisons
//     };
//     AXISCERT_FORMULAE("mine", Mine)
//
// CMake's axiscert_add_formulae(mine mine.cpp) makes two plug-ins of it: mine.so, with T float and double, and
// mine-exact.so, compiled with AXISCERT_FORMULAE_EXACT, with T the number of exact_number.hpp. Both are judged by
// `axiscert run --kernel plugin:mine.so --kernel plugin:mine-exact.so`: a wrong verdict of the second is a fault of the
// formulae, one of the first alone is rounding or range. docs/plugins.md says more.
//
// Where the exact formulae divide by zero they say nothing, and the verdict is AXISCERT_UNDECIDED. A query that is not
// valid (a number that is not finite, a negative radius) is AXISCERT_INVALID, and the formulae are not asked.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "plugin.h"
#ifdef AXISCERT_FORMULAE_EXACT
#include "exact_number.hpp"
#endif

namespace axiscert::formulae {

template <class T>
struct Vec {
  T x, y, z;
};
template <class T>
Vec<T> operator+(const Vec<T>& u, const Vec<T>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <class T>
Vec<T> operator-(const Vec<T>& u, const Vec<T>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
template <class T>
Vec<T> operator*(const Vec<T>& u, const T& s) {
  return {u.x * s, u.y * s, u.z * s};
}
template <class T>
T dot(const Vec<T>& u, const Vec<T>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <class T>
Vec<T> cross(const Vec<T>& u, const Vec<T>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// A sphere of centre p and radius r, and the triangle abc.
template <class T>
struct Query {
  Vec<T> a, b, c, p;
  T r;
};

namespace detail {

constexpr std::size_t columns = 13, radius = 12;

template <class Real>
bool is_valid(const Real (&v)[columns]) {
  for (const Real x : v) {
    if (!std::isfinite(x)) return false;
  }
  return v[radius] >= 0;
}

template <class T, class Formulae, class Real>
int separated(const Real (&v)[columns]) {
  const Query<T> q = {{T(v[0]), T(v[1]), T(v[2])},
                      {T(v[3]), T(v[4]), T(v[5])},
                      {T(v[6]), T(v[7]), T(v[8])},
                      {T(v[9]), T(v[10]), T(v[11])},
                      T(v[radius])};
  return Formulae::template separated<T>(q) ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
}

template <class Formulae, class Real>
int verdict(const Real (&v)[columns]) {
  if (!is_valid(v)) return AXISCERT_INVALID;
#ifdef AXISCERT_FORMULAE_EXACT
  try {
    return separated<Exact, Formulae>(v);
  } catch (const Undefined&) {
    return AXISCERT_UNDECIDED;
  }
#else
  return separated<Real, Formulae>(v);
#endif
}

template <class Formulae, class Real>
void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (std::size_t i = 0; i < batch->count; ++i) {
    Real v[columns];
    for (std::size_t k = 0; k < columns; ++k) v[k] = static_cast<const Real*>(batch->column[k])[i];
    answers->verdict[i] = static_cast<std::uint8_t>(verdict<Formulae>(v));
  }
}

template <class Formulae, class Real>
axiscert_kernel kernel(const char* name, const char* source) {
  axiscert_kernel k = {};
  k.abi = AXISCERT_PLUGIN_ABI;
  k.precision = 8 * static_cast<std::uint32_t>(sizeof(Real));
  k.size = sizeof(k);
  k.name = name;
  k.column_count = columns;
  k.run = run<Formulae, Real>;
  k.source = source;
#ifdef AXISCERT_FORMULAE_EXACT
  k.summary = "in exact arithmetic: a wrong verdict is a fault of the formulae";
  k.may_decline = 1;
#endif
  return k;
}

}  // namespace detail
}  // namespace axiscert::formulae

#ifdef AXISCERT_FORMULAE_EXACT
#define AXISCERT_I_FORMULAE_NAME(name) name "-exact"
#else
#define AXISCERT_I_FORMULAE_NAME(name) name
#endif

// The whole plug-in: the formulae in binary32 and in binary64, touching is contact. `kernel_name` is a literal.
#define AXISCERT_FORMULAE(kernel_name, Formulae)                                                                       \
  const axiscert_kernel* axiscert_plugin(std::uint32_t axiscert_i_index) {                                             \
    static const axiscert_kernel axiscert_i_kernels[] = {                                                              \
        axiscert::formulae::detail::kernel<Formulae, float>(AXISCERT_I_FORMULAE_NAME(kernel_name), AXISCERT_SOURCE),   \
        axiscert::formulae::detail::kernel<Formulae, double>(AXISCERT_I_FORMULAE_NAME(kernel_name), AXISCERT_SOURCE)}; \
    return axiscert_i_index < 2 ? &axiscert_i_kernels[axiscert_i_index] : nullptr;                                     \
  }
