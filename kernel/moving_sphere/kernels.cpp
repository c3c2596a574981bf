#include "kernel/moving_sphere/kernels.h"

#include "kernel/moving_sphere/advance.h"
#include "kernel/moving_sphere/fauerby.h"
#include "kernel/moving_sphere/gated.h"
#include "kernel/moving_sphere/physx.h"
#include "kernel/moving_sphere/segment.h"
#include "kernel/moving_sphere/timed.h"
#include "kernel/moving_sphere/twenty.h"
#include "kernel/moving_sphere/walk.h"
#include "kernel/permitted/graph.h"

namespace axiscert {
namespace {

using namespace moving_sphere;

Kernel taking_arithmetic(Kernel kernel) {
  kernel.takes_arithmetic = true;
  return kernel;
}

// A method of motions by displacement, asked about the rounded difference of the ends, as an engine that takes D is.
template <class M>
struct ByDifference : M {
  template <class Real>
  static MovingQuery<Real> motion(const EndsQuery<Real>& q) {
    return {q.a, q.b, q.c, q.p, q.p1 - q.p, q.r};
  }
  template <class Real>
  static bool separated(const EndsQuery<Real>& q) {
    return M::template separated<Real>(motion(q));
  }
  template <class Real>
  static void measure(const EndsQuery<Real>& q, Real* out) {
    M::template measure<Real>(motion(q), out);
  }
};

// The verdict of the twenty axes alone.
struct TwentyVerdict {
  template <class Real>
  static bool separated(const MovingQuery<Real>& q) {
    return verdict_of(moving_sphere_predicate(), bits_of<TwentyNonstrict, Real>(q, [](std::size_t, Real, Real) {})) ==
           Verdict::separated;
  }
};

template <class M>
Kernel by_difference(std::string id, std::string summary) {
  return method_kernel<MovingEnds, ByDifference<M>>(std::move(id), std::move(summary));
}

template <class M>
Kernel timed(std::string id, std::string summary) {
  return method_kernel<MovingSphere, TimedMethod<M>>(std::move(id), std::move(summary));
}

Kernel promising(const MotionPolicy& policy, Kernel kernel) {
  kernel.motion = policy;
  return kernel;
}

}  // namespace

std::vector<Kernel> moving_sphere_kernels() {
  return {
      taking_arithmetic(
          with_lane_forms(formulae_kernel<MovingSphere, Twenty>("moving-sphere/twenty",
                                                                "the sphere against the prism of the motion: 20 axes"),
                          simd_twenty)),
      taking_arithmetic(with_lane_forms(
          formulae_kernel<MovingSphere, TwentyNonstrict>(
              "moving-sphere/twenty-nonstrict", "the same with >= in the sides: over the reals right for every query"),
          simd_twenty_nonstrict)),
      timed<GatedTwenty>("moving-sphere/gated",
                         "the verdict by the twenty axes, the time by c / (b + sqrt(b^2 - a c))"),
      timed<Walk>("moving-sphere/walk", "the seven static axes tracked over time, from interval to interval"),
      with_lane_forms(
          timed<OneNumber<portable::RoundedDifference>>(
              "moving-sphere/rounded", "the centre's path against face, cylinders and spheres, by roots of quadratics"),
          simd_rounded),
      timed<OneNumber<portable::RoundedQuotient>>("moving-sphere/rounded-quotient",
                                                  "the same, a root as c / (b + sqrt(b^2 - a c))"),
      timed<OneNumber<portable::RoundedProducts>>("moving-sphere/rounded-products",
                                                  "then b^2 - a c as a difference of products"),
      promising(
          {.still = StillPolicy::ignored},
          timed<Fauerby>("moving-sphere/fauerby", "Fauerby's sweep of a unit sphere, for both sides of the triangle")),
      promising({.still = StillPolicy::ignored},
                timed<PhysX4>("moving-sphere/physx4", "PhysX 4.1: the plane's point picks one vertex or one edge")),
      promising({.still = StillPolicy::ignored},
                timed<PhysX5>("moving-sphere/physx5", "PhysX 5: the plane's point picks one edge or two")),
      method_kernel<MovingSphere, Segment>("moving-sphere/segment",
                                           "the distance of the centre's path, a segment, from the triangle"),
      timed<Advance<true>>("moving-sphere/advance",
                           "conservative advancement by the speed along the nearest direction, 32 steps"),
      timed<Advance<false>>("moving-sphere/advance-by-length", "the same by |D|, which takes more steps"),
      formulae_kernel<MovingEnds, Twenty>("moving-sphere/ends-twenty",
                                          "twenty, of a motion given by its ends P and P1"),
      formulae_kernel<MovingEnds, TwentyNonstrict>(
          "moving-sphere/ends-twenty-nonstrict", "the same with >= in the sides: over the reals right for every query"),
      by_difference<TwentyVerdict>("moving-sphere/ends-difference",
                                   "twenty-nonstrict of D = P1 - P, rounded: what a caller of it would ask"),
      by_difference<TimedMethod<GatedTwenty>>("moving-sphere/ends-gated", "gated of that D"),
      by_difference<TimedMethod<OneNumber<portable::RoundedDifference>>>("moving-sphere/ends-rounded",
                                                                         "rounded of that D"),
  };
}

}  // namespace axiscert

namespace axiscert::permitted {

Recorder moving_sphere_recorder(const Kernel& kernel) {
  Recorder found;
  put_recorder<MovingSphere, portable::Twenty>(kernel, found);
  put_recorder<MovingSphere, portable::TwentyNonstrict>(kernel, found);
  put_recorder<MovingEnds, portable::Twenty>(kernel, found);
  put_recorder<MovingEnds, portable::TwentyNonstrict>(kernel, found);
  return found;
}

}  // namespace axiscert::permitted
