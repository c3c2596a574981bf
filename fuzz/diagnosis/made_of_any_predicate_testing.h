// Kernels of any test that show a verdict alone, each with one property that is known because it is made so: another
// kernel, of which the query or the answer is changed.
#pragma once

#include <cmath>
#include <string>

#include "fuzz/diagnosis/scenes/scenes_by_trait.h"
#include "kernel/ask.h"
#include "kernel/base/environment.h"
#include "kernel/kernel.h"

namespace axiscert::made {

template <class Real>
Verdict verdict_by(const Implementation<Real>& kernel, const Numbers<Real>& query) {
  return axiscert::ask(kernel, query).verdicts[0];
}

// A kernel that answers a query by `answer(base, implementation of it, query)`.
template <class Answer>
Kernel answered_by(const Kernel& base, const std::string& suffix, Answer answer) {
  Kernel kernel = base;
  kernel.id += "-" + suffix;
  kernel.exposes = Exposure::verdict;
  const auto made = [base, answer]<class Real>(std::string_view target) {
    const Implementation<Real> right = base.on<Real>(target);
    Implementation<Real> implementation;
    implementation.verdicts = [base, answer, right](const QueryColumns<Real>& batch, Verdict* out) {
      for (std::size_t i = 0; i < batch.size; ++i) {
        Numbers<Real> query(batch.count);
        for (std::size_t k = 0; k < batch.count; ++k) query[k] = batch.column[k][i];
        out[i] = answer(base, right, query);
      }
    };
    return implementation;
  };
  kernel.binary32 = [made](std::string_view target) { return made.template operator()<float>(target); };
  kernel.binary64 = [made](std::string_view target) { return made.template operator()<double>(target); };
  return kernel;
}

// Every length, as radii and half extents are, taken as at least 0.01.
inline Kernel clamped(const Kernel& base) {
  return answered_by(base, "clamped", []<class Real>(const Kernel& of, const auto& right, Numbers<Real> query) {
    const std::vector<PredicateColumn>& columns = of.predicate->entries[of.entry].columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k].role == Role::length && query[k] < Real(0.01)) query[k] = Real(0.01);
    }
    return verdict_by(right, query);
  });
}

// Every length times 1 + 2^-20 or 1 - 2^-20: further than a rounding, nearer than what the probe takes for a slack. In
// small integers, where nothing is rounded, that opens what is closed.
inline Kernel opened(const Kernel& base) {
  return answered_by(base, "opened", []<class Real>(const Kernel& of, const auto& right, const Numbers<Real>& query) {
    return verdict_by(right, diagnosis::with_lengths_times(of, query, Real(1 - 0x1p-20)));
  });
}
// Closed where the first number is above 0, and open elsewhere.
inline Kernel half_opened(const Kernel& base) {
  return answered_by(base, "half-opened",
                     []<class Real>(const Kernel& of, const auto& right, const Numbers<Real>& query) {
                       const Real factor = query[0] > 0 ? Real(1) : Real(1 - 0x1p-20);
                       return verdict_by(right, diagnosis::with_lengths_times(of, query, factor));
                     });
}
// Every length a hundredth more.
inline Kernel with_slack(const Kernel& base) {
  return answered_by(base, "slack", []<class Real>(const Kernel& of, const auto& right, const Numbers<Real>& query) {
    return verdict_by(right, diagnosis::with_lengths_times(of, query, Real(1.01)));
  });
}

template <class Real>
Vec3<double> vertex(const Kernel& of, const Numbers<Real>& query, std::size_t which) {
  const std::size_t first = (*diagnosis::vertex_columns(of))[which];
  return {static_cast<double>(query[first]), static_cast<double>(query[first + 1]),
          static_cast<double>(query[first + 2])};
}
template <class Real>
Vec3<double> face_normal(const Kernel& of, const Numbers<Real>& query) {
  const Vec3<double> a = vertex(of, query, 0);
  return cross(vertex(of, query, 1) - a, vertex(of, query, 2) - a);
}

// Contacts from one side alone: of motions those that go against the normal, or with it; of boxes those whose centre
// is on that side.
inline Kernel one_sided(const Kernel& base, bool is_front) {
  return answered_by(base, is_front ? "front-only" : "back-only",
                     [is_front]<class Real>(const Kernel& of, const auto& right, const Numbers<Real>& query) {
                       const auto triple = [&](std::size_t first) {
                         return Vec3<double>{static_cast<double>(query[first]), static_cast<double>(query[first + 1]),
                                             static_cast<double>(query[first + 2])};
                       };
                       const Vec3<double> normal = face_normal(of, query);
                       const auto d = diagnosis::first_column(of, "d"), m = diagnosis::first_column(of, "box.m");
                       const double side =
                           d ? -dot(triple(*d), normal) : dot(triple(*m) - vertex(of, query, 0), normal);
                       return (is_front ? side <= 0 : side >= 0) ? Verdict::separated : verdict_by(right, query);
                     });
}

// Overlaps before the motion missed: where the distance does not fall at first, where nothing moves, or all of them.
enum class MissedStarts : std::uint8_t { leaving_and_still, still, all_starts };
inline Kernel missing_starts(const Kernel& base, MissedStarts missed) {
  return answered_by(
      base, "missing-starts", [missed]<class Real>(const Kernel& of, const auto& right, const Numbers<Real>& query) {
        const Numbers<Real> still = diagnosis::without_motion(of, query);
        if (verdict_by(right, still) == Verdict::separated) return verdict_by(right, query);
        const bool is_still = std::ranges::equal(still, query);
        const bool is_approaching =
            oracles_of(of).is_promised(MotionPolicy{.start = StartPolicy::approaching}, query) && !is_still;
        const bool is_missed = missed == MissedStarts::still               ? is_still
                               : missed == MissedStarts::leaving_and_still ? !is_approaching
                                                                           : true;
        return is_missed ? Verdict::separated : Verdict::contact;
      });
}

// Triangles without area answered in one way, whatever the query.
inline Kernel flat_triangles(const Kernel& base, Verdict verdict) {
  return answered_by(base, "flat-" + std::string(name(verdict)),
                     [verdict]<class Real>(const Kernel& of, const auto& right, const Numbers<Real>& query) {
                       const Vec3<double> normal = face_normal(of, query);
                       return dot(normal, normal) == 0 ? verdict : verdict_by(right, query);
                     });
}

inline Kernel flushing(const Kernel& base) {
  return answered_by(base, "flushing", []<class Real>(const Kernel&, const auto& right, const Numbers<Real>& query) {
    const FloatingEnvironment flushed(Rounding::nearest, true);
    return verdict_by(right, query);
  });
}

// Every number rounded to binary32, or widened to binary64, before it is computed with.
template <class Inner>
Kernel computing_in(const Kernel& base) {
  const Implementation<Inner> inner = base.on<Inner>(scalar_target);
  return answered_by(base, sizeof(Inner) == 4 ? "in-float" : "in-double",
                     [inner]<class Real>(const Kernel&, const auto&, const Numbers<Real>& query) {
                       Numbers<Inner> other(query.size());
                       for (std::size_t k = 0; k < query.size(); ++k) other[k] = static_cast<Inner>(query[k]);
                       return verdict_by(inner, other);
                     });
}

}  // namespace axiscert::made
