// Why a kernel is wrong, in the words in which every report says it: the cause of its wrong verdicts; and, where its
// links do not say it, these by class of the input, over all families, and the built-in kernel that fails alike.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/kernel_record.h"
#include "fuzz/record/record.h"
#include "reports/wording/summary.h"

namespace axiscert {

// "as if an absolute number near 0.01 (squared 0.0001) were compared with r, or one near ..."; empty where none was.
std::string compared_text(const AbsoluteSizeRecord& sizes);

// The powers of two nearest to 1, as exponents.
struct NearestPowers {
  std::optional<int> down, up;
};
NearestPowers nearest_powers(const CountsBySize& by_size);
// Whether these powers are in the outer half of the range of degree 6, where a form of up to twice that degree has left
// its own.
bool are_outer(const CountsBySize& by_size, const ImageChangesRecord& scale);
// Why the kernel is wrong: its slack; the absolute number that explains what changes with the unit of length; and the
// class of queries in which it is wrong. A slack of few queries comes after the number, and one that is late there
// after the class too: a part that is left out makes contacts late where it decides. Empty where none was found.
std::string cause_sentence(const KernelRecord& kernel);
// "ID binary32: wrong on 206 of 212 spheres nearest to vertex a; right elsewhere (0 of 3,100)". Empty where the entry
// has no cause.
std::string cause_line(const KernelRecord& kernel);
// "shortest witness: it says contact, and is wrong: ax 0, ay 0, ... (ADDRESS)". Empty where there is none.
std::string cause_witness_line(const KernelRecord& kernel, const PlanRecord& plan);

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
