// The first step of contacts compiled for every instruction set.
#include <cstring>
#include <limits>

#include "kernel/sphere_triangle/certified/contact_steps.h"
#include "kernel/sphere_triangle/certified/exact_contact.h"
#include "kernel/sphere_triangle/certified/thresholds.h"
#include "hwy/cache_control.h"
#include "kernel/sphere_triangle/certified/exact_step.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: tests have to reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/sphere_triangle/certified/contact_forms.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/base/geometry.h"
#include "kernel/sphere_triangle/certified/coarse_step-inl.h"
#include "kernel/sphere_triangle/certified/pairs-inl.h"
#include "kernel/sphere_triangle/certified/leftovers-inl.h"
#include "kernel/sphere_triangle/certified/contact_step-inl.h"
#include "kernel/sphere_triangle/certified/contact_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified::HWY_NAMESPACE {
ContactForms contact_forms() {
  using Floats = hn::ScalableTag<float>;
  using Doubles = hn::ScalableTag<double>;
  using OneFloat = hn::CappedTag<float, 1>;
  using OneDouble = hn::CappedTag<double, 1>;
  return {decide_contacts<Floats, Doubles, float>, decide_contacts<Floats, Doubles, double>,
          decide_contacts<OneFloat, OneDouble, float>, decide_contacts<OneFloat, OneDouble, double>};
}
}  // namespace axiscert::certified::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert::certified {
HWY_EXPORT(contact_forms);

ContactForms chosen_contact_forms() { return HWY_DYNAMIC_DISPATCH(contact_forms)(); }
}  // namespace axiscert::certified
#endif
