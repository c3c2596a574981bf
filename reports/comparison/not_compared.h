// Parts that two runs did not compare are said, and no pass, unless NEW alone has them or the user allows them by name.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fuzz/text/values.h"
#include "kernel/base/enums.h"

namespace axiscert {

enum class Absence {
  fails,     // OLD has it, or both have it and counted it over other queries
  allowed,   // the same, which the user allows by name
  only_new,  // no fault
  empty,     // neither run has a query of it that the kernel promises to answer: no fault
  verdicts   // a number whose answers are others, since verdicts changed: no fault
};
template <>
inline constexpr std::size_t enum_count<Absence> = 5;
inline constexpr EnumArray<Absence, std::string_view> absence_names = {"fails", "allowed", "only in NEW", "empty",
                                                                       "with the verdicts"};
constexpr std::string_view name(Absence absence) { return absence_names[absence]; }

struct NotCompared {
  std::string what, why;
  std::vector<std::string> kernels = {};  // all names of the kernel that it is about
  std::string family = {};
  Absence absence = Absence::fails;

  AXISCERT_FIELDS(
      NotCompared,
      AXISCERT_FIELD(what,
                     "A kernel, a precision or family of it, a cell, a family of the plan, or OLD or NEW. "
                     "--allow-not-compared takes it."),
      AXISCERT_FIELD(why, "The reason."), journalled(&Of::kernels), journalled(&Of::family),
      field(&Of::absence,
            {"state",
             "fails: exit 1. allowed: by --allow-not-compared. only in NEW, empty (no promised query in either "
             "run) and with the verdicts (a number whose answers are others, since verdicts changed): no fault."}))
};

// Allows everything that one of `names` names: by its `what`, by its kernel or by its family. Throws Error where a name
// names nothing, and says what there is.
void allow(std::vector<NotCompared>& all, const std::vector<std::string>& names);

// "K is only in OLD; 26 of 27 families: is only in OLD": those with this absence, put together by reason, the first
// few. `families` is the number of families of OLD. Empty where there is none.
std::string absences_text(const std::vector<NotCompared>& all, Absence absence, std::size_t families);

}  // namespace axiscert
