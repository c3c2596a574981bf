// Wild Magic 5, the library that became Geometric Tools: IntrTriangle3Sphere3, a sphere that moves against a triangle,
// after Eberly. The description applies to Wild Magic 5.17. It takes the displacement as a velocity over a time of 1,
// and gives a time and, where that is not 0, the point.
#pragma once

#include <Wm5IntrTriangle3Sphere3.h>

#include <csetjmp>
#include <csignal>

#include "kernel/peers/moving_sphere/sweep.h"

namespace axiscert::peer {

// Debian builds the library with its assertions. One of them fails where the square root of 0 is divided by, as on
// paths that touch a vertex's or an edge's sphere or cylinder, and ends the process of whoever asks. Here such a motion
// has no answer, and is declined: else a few of them would leave all others without one.
template <class Ask>
bool is_answered(Ask&& ask) {
  static thread_local sigjmp_buf before;
  struct sigaction leave = {}, others;
  leave.sa_handler = [](int) { siglongjmp(before, 1); };
  sigaction(SIGABRT, &leave, &others);
  const bool returned = sigsetjmp(before, 1) == 0;
  if (returned) ask();
  sigaction(SIGABRT, &others, nullptr);
  return returned;
}

template <class Number>
struct WildMagicSweep {
  using Real = Number;
  static constexpr std::size_t measure_count = 1;
  static constexpr bool may_decline = true;

  int operator()(const Sweep<Real>& q, FirstContact<Real>& first) const {
    const auto vector = [](const Vec3<Real>& v) { return Wm5::Vector3<Real>(v.x, v.y, v.z); };
    const Wm5::Triangle3<Real> triangle(vector(q.a), vector(q.b), vector(q.c));
    const Wm5::Sphere3<Real> sphere(vector(q.p), q.r);
    Wm5::IntrTriangle3Sphere3<Real> method(triangle, sphere);
    bool is_hit = false;
    if (!is_answered([&] { is_hit = method.Find(1, Wm5::Vector3<Real>::ZERO, vector(q.d)); }))
      return AXISCERT_UNDECIDED;
    first.time = method.GetContactTime();
    return verdict_of_hit(is_hit, first.time);
  }
};

}  // namespace axiscert::peer
