// Why a kernel is wrong whose links do not say it: its wrong verdicts by class of the input, over all families, and the
// built-in kernel that fails alike.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/kernel_record.h"
#include "reports/wording/summary.h"

namespace axiscert {

// A class for the author of a kernel; its meaning is without a full stop.
extern const EnumArray<InputClass, CauseWords> class_words;

// The wrong verdicts of a kernel on input of one class.
struct ClassRow {
  InputClass which;
  std::uint64_t missed, phantom;
  double deepest;
  std::string family, witness;  // of the deepest: its family and its address
};

// Whether a kernel has classes: those whose links do not say why they are wrong.
bool has_classes(const KernelRecord& kernel);

// The classes with a wrong verdict, in the order of InputClass.
std::vector<ClassRow> class_rows(const KernelRecord& kernel);

// "Nearest of the built-in kernels: published, wrong on 93 % of the queries on which either is (412 of 443; ...)."
// Empty where the entry has none.
std::string nearest_sentence(const KernelRecord& kernel);

// The same as members for the page: rows with their meanings, and the sentence. Null for a kernel without classes.
Json classes_data(const KernelRecord& kernel);

}  // namespace axiscert
