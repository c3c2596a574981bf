// Queries of a kernel's predicate on which no rounding is to blame for a wrong answer, and their images in another
// unit.
#pragma once

#include "fuzz/diagnosis/scenes/scenes.h"
#include "fuzz/queries/family.h"

namespace axiscert::diagnosis {

// The depth, relative to the scene, above which a query is clear of touching.
inline constexpr double clear_depth = 0x1p-6;

// The family of the kernel's predicate that is named "general", with the entry that the kernel takes before it or after
// it
// ("ends_general", "general_minmax"); null where there is none.
const Family* family_named_general(const Kernel& kernel);

// The predicate's own, or the first `count` queries of its family `general` whose depth is above 2^-6. The numbers are
// of the kernel's entry. Empty where the predicate has no depth or no such family.
template <class Real>
std::vector<ClearQuery<Real>> clear_queries(const Kernel& kernel, std::size_t count);

// Whether a predicate is of motions, whose directions are displacements: it has a time.
bool is_of_motions(const Predicate& predicate);

// The query in another unit of length: places, lengths and displacements times 2^exponent. The axes of a box stay.
template <class Real>
Numbers<Real> in_unit(const Kernel& kernel, const Numbers<Real>& numbers, int exponent);

// Clear queries times powers of two at which intermediate results, but not the query's numbers, become subnormal:
// enough where comparisons are of a degree above 1. Those of boxes are not, and nothing becomes subnormal before their
// lengths do.
template <class Real>
Queries<Real> small_of_high_degree(const Kernel& kernel);

// Whether the kernel is right on clear queries of both verdicts at least two times in three: of one that is not, little
// can be said by its answers. The sentence says how often it is right where it is not;
// of a predicate without clear queries nothing is said.
template <class Real>
std::optional<std::string> why_not_sound(Subject<Real>& subject);

}  // namespace axiscert::diagnosis
