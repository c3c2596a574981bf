// Scenes of any test, made of what its families and its columns say: for the probes whose scenes are else those of
// sphere-triangle. Every truth is the oracles'.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fuzz/diagnosis/scenes/scenes.h"
#include "fuzz/diagnosis/subject.h"

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

// Queries of the families whose arithmetic is exact that touch, are separated with half the lengths and in contact with
// half as much again; plump. At most `count`.
template <class Real>
Queries<Real> touching_queries(Subject<Real>& subject, std::size_t count);

// A clear contact, and the side of (B - A) x (C - A) from which it comes: where the box's centre is, or the moving
// centre before the motion, which goes to the other side and is clear of the triangle at first. At most `count`, of
// which half are of each side.
template <class Real>
struct SidedQuery {
  Numbers<Real> query;
  bool is_front;
};
template <class Real>
std::vector<SidedQuery<Real>> sided_queries(Subject<Real>& subject, std::size_t count);

// Queries of the plain family with the vertices in one place, two of them in one, or all on a line, exactly; clear of
// touching. Of each kind at most `of_each`, as many contacts as separations. What the kernel does not promise is left
// out.
template <class Real>
struct FlatQuery {
  Numbers<Real> query;
  Flat flat;
  bool is_contact;
};
template <class Real>
std::vector<FlatQuery<Real>> flat_queries(Subject<Real>& subject, std::size_t of_each);

}  // namespace axiscert::diagnosis
