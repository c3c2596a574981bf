// What the columns of any predicate say of its queries: of these, and of its families, the scenes are made that it does
// not make itself. Every truth is the oracles'.
#pragma once

#include <array>
#include <optional>

#include "fuzz/diagnosis/scenes.h"

namespace axiscert::diagnosis {

// The first column of a group of the kernel's entry, by its name.
std::optional<std::size_t> first_column(const Kernel& kernel, std::string_view group);

// The first columns of the vertices of the entry's triangle; empty where it has none.
std::optional<std::array<std::size_t, 3>> vertex_columns(const Kernel& kernel);

// Whether the entry has lengths, which grow what it asks about: a radius, half extents.
bool has_lengths(const Kernel& kernel);

// The same motion without its displacement; another query as it is.
template <class Real>
Numbers<Real> without_motion(const Kernel& kernel, Numbers<Real> query);

// Whether nothing in a query is without extent, or hardly any: no length of 0, no thin triangle, no displacement of 0.
template <class Real>
bool is_plump(const Kernel& kernel, const Numbers<Real>& query);

// The query with every length times a factor.
template <class Real>
Numbers<Real> with_lengths_times(const Kernel& kernel, Numbers<Real> query, Real factor);

}  // namespace axiscert::diagnosis
