// The probes, one for each property. Each asks the kernel, and gives a value only where the answers decide it.
#pragma once

#include "fuzz/diagnosis/probes/values.h"
#include "fuzz/diagnosis/subject.h"

namespace axiscert::diagnosis {

// Probes whose scenes are the predicate's own, or made of its families and columns (scenes/scenes.h); operation_order
// is of predicates with near ties alone, overlap_at_start of motions.
template <class Real>
ProbeFinding at_touching(Subject<Real>& subject);
template <class Real>
ProbeFinding sides_hit(Subject<Real>& subject);
template <class Real>
ProbeFinding overlap_at_start(Subject<Real>& subject);
template <class Real>
ProbeFinding degenerate_triangles(Subject<Real>& subject);
template <class Real>
ProbeFinding subnormal_numbers(Subject<Real>& subject);
template <class Real>
ProbeFinding operation_order(Subject<Real>& subject);
template <class Real>
ProbeFinding inner_precision(Subject<Real>& subject);

// Probes that need nothing of the scene.
template <class Real>
ProbeFinding absolute_thresholds(Subject<Real>& subject);
template <class Real>
ProbeFinding range_window(Subject<Real>& subject);
template <class Real>
ProbeFinding repeated(Subject<Real>& subject);
template <class Real>
ProbeFinding nearest_form(Subject<Real>& subject);
// Probes of a kernel that gives the same batch the same answers.
template <class Real>
ProbeFinding position_in_batch(Subject<Real>& subject);
template <class Real>
ProbeFinding batch_length(Subject<Real>& subject);
template <class Real>
ProbeFinding neighbours(Subject<Real>& subject);

}  // namespace axiscert::diagnosis
