// The predicate of a command: kernels and queries that have to be of one predicate, and what commands need of a
// predicate.
#pragma once

#include <string>
#include <vector>

#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

// The predicate of a command that names none, neither itself nor by a kernel or queries.
const Predicate& default_predicate();
// The predicate that --predicate names; the default where it was not given. Throws Error that lists the predicates.
const Predicate& predicate_given(const std::string& predicate);

// The predicate that --predicate names; where it was not given that of the kernels, and the default where there are
// none. Throws Error that names two kernels of different predicates, or a kernel of another predicate than --predicate.
const Predicate& predicate_of_kernels(const std::string& predicate, const std::vector<const Kernel*>& kernels);
// The kernel of a command that names none: the first that takes this entry of the predicate.
const Kernel& default_kernel(const Predicate& predicate, std::size_t entry = 0);
// The entry of the first of these families that is of the predicate; of none, the predicate's first.
std::size_t entry_of_families(const Predicate& predicate, const std::vector<std::string>& families);
// The families of these names; `all` are those of an entry of a predicate.
std::vector<const Family*> families_named(const std::vector<std::string>& names, const Predicate& predicate,
                                          std::size_t entry);
// Throws Error that names a kernel and a source of different predicates, or of different entries of one predicate.
void require_one_predicate(const std::vector<const Kernel*>& kernels, const std::vector<SourcePtr>& sources);
// The predicate that --predicate names; where it was not given that of the first source. Throws Error that names a
// source of another predicate.
const Predicate& predicate_of_sources(const std::string& predicate, const std::vector<SourcePtr>& sources);

// Commands ask whether an entry of a predicate has something that they need.
using Capability = bool(const Predicate& predicate, std::size_t entry);
bool has_critical_length(const Predicate& predicate, std::size_t entry);
bool has_filters(const Predicate& predicate, std::size_t entry = 0);
// Whether search, shrink and map can move its queries.
bool has_moves(const Predicate& predicate, std::size_t entry);
// Whether search values the errors of comparisons (Capabilities::aim_values).
bool has_error_aims(const Predicate& predicate, std::size_t entry);
// Whether shrink maps a query to its images (Capabilities::image_maps).
bool has_image_maps(const Predicate& predicate, std::size_t entry);
// Whether a kernel of the predicate has formulae of kernel/formulae_list.h.
bool has_formulae(const Predicate& predicate, std::size_t entry);
// "sphere-triangle, box-box".
std::string ids_of(const std::vector<const Predicate*>& predicates);
// The predicates that have it in some entry.
std::vector<const Predicate*> predicates_with(Capability& capability);

// For a command, or an option of one, that needs a capability: throws Error where the predicate, or its entry, has it
// not.
void require_capability(Capability& capability, std::string_view command, const Predicate& predicate,
                        std::size_t entry);
void require_moves(std::string_view command, const Predicate& predicate, std::size_t entry);

// For a command, or an option of one, that serves these predicates: throws Error for any other.
void require_served(std::string_view command, const Predicate& predicate, const std::vector<const Predicate*>& served);

}  // namespace axiscert
