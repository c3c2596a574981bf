// The probes, one for each property. Each asks the kernel, and gives a value only where the answers decide it.
#pragma once

#include "fuzz/diagnosis/probes/values.h"
#include "fuzz/diagnosis/subject.h"

namespace axiscert::diagnosis {

// Probes whose scenes are the test's own, or made of its families and columns (scenes/scenes.h); operation_order is of
// tests with near ties alone, overlap_at_start of motions.
template <class Real>
Found at_touching(Subject<Real>& subject);
template <class Real>
Found sides_hit(Subject<Real>& subject);
template <class Real>
Found overlap_at_start(Subject<Real>& subject);
template <class Real>
Found degenerate_triangles(Subject<Real>& subject);
template <class Real>
Found subnormal_numbers(Subject<Real>& subject);
template <class Real>
Found operation_order(Subject<Real>& subject);
template <class Real>
Found inner_precision(Subject<Real>& subject);

// Probes that need nothing of the scene.
template <class Real>
Found absolute_thresholds(Subject<Real>& subject);
template <class Real>
Found range_window(Subject<Real>& subject);
template <class Real>
Found repeated(Subject<Real>& subject);
template <class Real>
Found nearest_form(Subject<Real>& subject);
// Probes of a kernel that gives the same batch the same answers.
template <class Real>
Found position_in_batch(Subject<Real>& subject);
template <class Real>
Found batch_length(Subject<Real>& subject);
template <class Real>
Found neighbours(Subject<Real>& subject);

}  // namespace axiscert::diagnosis
