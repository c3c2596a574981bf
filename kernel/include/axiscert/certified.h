/* Does a sphere touch a triangle: the exact answer, at about the price of the float predicate.
 *
 *     float triangle[9] = {ax, ay, az, bx, by, bz, cx, cy, cz}, sphere[4] = {px, py, pz, r};
 *     if (axiscert_pair_f32(triangle, sphere, AXISCERT_CLOSED_SPHERE) == AXISCERT_CONTACT) ...
 *
 * The sphere is solid and the triangle closed; both are taken as the exact values of the given numbers. For every
 * finite input with r >= 0 (-0 too) the answer is that of exact arithmetic: triangles without area, subnormal numbers
 * and the greatest ones included, on every instruction set, in every rounding mode, with subnormal numbers flushed to
 * zero or not. docs/certified.md says what of this is proved, what is tested, and the cost.
 *
 * A verdict (plugin.h) is AXISCERT_CONTACT = 0, AXISCERT_SEPARATED = 1 or, where one of the thirteen numbers is not
 * finite or the radius is negative, AXISCERT_INVALID = 3; never AXISCERT_UNDECIDED. It is not a boolean: contact is 0.
 *
 * No function allocates, throws, prints, locks or keeps state, except that the first call chooses the instruction set
 * and checks the library, and ends the process with a sentence on standard error where even its integers fail the
 * check; all may be called by any number of threads. On return the floating-point modes are the
 * caller's again. If they were the default modes, status flags may have been raised; otherwise the flags are as they
 * were too. Arrays need no alignment beyond their type's, and must not overlap the results. With no queries (size or
 * count 0) no array is read, and any may be null.
 */
#ifndef AXISCERT_CERTIFIED_H
#define AXISCERT_CERTIFIED_H

#include "plugin.h" /* enum axiscert_verdict */

#ifdef __cplusplus
#define AXISCERT_NOEXCEPT noexcept
extern "C" {
#else
#define AXISCERT_NOEXCEPT
#endif

/* Any other value counts as the first. */
enum axiscert_question {
  AXISCERT_CLOSED_SPHERE = 0, /* contact: distance <= r. Touching counts */
  AXISCERT_OPEN_SPHERE = 1,   /* contact: distance < r. Touching does not; r = 0 touches nothing */
  AXISCERT_CONSERVATIVE = 2,  /* never a missed contact of the closed sphere, but sometimes one too many:
                                 distance - r <= AXISCERT_PHANTOM_DEPTH_F32 (F64) max(|A-P|, |B-P|, |C-P|, r) */
  /* The same answers as the first two, each by integers alone: no step in floating point, no vector. Far slower on most
     queries; for those who want the shortest way that has to be trusted. */
  AXISCERT_EXACT_ONLY = 4,     /* contact: distance <= r */
  AXISCERT_OPEN_EXACT_ONLY = 5 /* contact: distance < r */
};

/* How deep a phantom contact of AXISCERT_CONSERVATIVE can be: 20 sqrt(u), u = 2^-24 and 2^-53, rounded up. */
#define AXISCERT_PHANTOM_DEPTH_F32 0.0048828125
#define AXISCERT_PHANTOM_DEPTH_F64 2.1074e-7

/* The arrays to write: each one that is not null. A null pointer to this struct writes none; the counts are returned in
   any case. */
typedef struct axiscert_results {
  uint8_t* verdict;  /* an axiscert_verdict for each query */
  uint64_t* contact; /* bit i % 64 of word i / 64: query i is a contact; whole words are written, the rest 0 */
  uint32_t* hits;    /* the contacts in the order of the queries: indices, or the low 32 bits of the triangles' numbers.
                        Needs room for all queries; its contents after the contacts are unspecified */
} axiscert_results;

typedef struct axiscert_counts {
  size_t contacts, invalid;
} axiscert_counts;

/* An indexed mesh: vertex v begins at vertices[v * stride], stride >= 3; the vertices of triangle t are indices[3 t] to
 * indices[3 t + 2]. The indices are not checked: the vertices that they name must exist. Other vertices between the
 * least and the greatest vertex of the triangles asked may be read too, whatever they contain. */
typedef struct axiscert_mesh_f32 {
  const float* vertices;
  size_t stride;
  const uint32_t* indices;
} axiscert_mesh_f32;
typedef struct axiscert_mesh_f64 {
  const double* vertices;
  size_t stride;
  const uint32_t* indices;
} axiscert_mesh_f64;

/* 1 where the library passed the check that its first call makes, 0 where its steps in floating point gave a wrong
 * answer there, as they do where they were compiled with flags that change arithmetic. Then all questions are answered
 * as AXISCERT_EXACT_ONLY are: right, and slower. */
AXISCERT_EXPORT int axiscert_passed_self_check(void) AXISCERT_NOEXCEPT;

/* One pair: triangle is ax ay az bx by bz cx cy cz, sphere px py pz r. */
AXISCERT_EXPORT enum axiscert_verdict axiscert_pair_f32(const float triangle[9], const float sphere[4],
                                                        enum axiscert_question question) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT enum axiscert_verdict axiscert_pair_f64(const double triangle[9], const double sphere[4],
                                                        enum axiscert_question question) AXISCERT_NOEXCEPT;

/* Many pairs, structure of arrays: the columns ax ay az bx by bz cx cy cz px py pz r of `size` numbers each. */
AXISCERT_EXPORT axiscert_counts axiscert_pairs_f32(const float* const columns[13], size_t size,
                                                   enum axiscert_question question,
                                                   const axiscert_results* results) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_pairs_f64(const double* const columns[13], size_t size,
                                                   enum axiscert_question question,
                                                   const axiscert_results* results) AXISCERT_NOEXCEPT;

/* One sphere against many triangles, structure of arrays: the columns ax to cz. */
AXISCERT_EXPORT axiscert_counts axiscert_triangles_f32(const float sphere[4], const float* const columns[9],
                                                       size_t size, enum axiscert_question question,
                                                       const axiscert_results* results) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_triangles_f64(const double sphere[4], const double* const columns[9],
                                                       size_t size, enum axiscert_question question,
                                                       const axiscert_results* results) AXISCERT_NOEXCEPT;

/* One sphere against `count` triangles of a mesh: those of a list, such as a broad phase makes, in any order and
 * with or without repetitions; or those from `first` on. Result i belongs to the i-th of these; hits are triangles'
 * numbers. */
AXISCERT_EXPORT axiscert_counts axiscert_mesh_list_f32(const float sphere[4], const axiscert_mesh_f32* mesh,
                                                       const uint32_t* triangle, size_t count,
                                                       enum axiscert_question question,
                                                       const axiscert_results* results) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_mesh_list_f64(const double sphere[4], const axiscert_mesh_f64* mesh,
                                                       const uint32_t* triangle, size_t count,
                                                       enum axiscert_question question,
                                                       const axiscert_results* results) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_mesh_range_f32(const float sphere[4], const axiscert_mesh_f32* mesh,
                                                        size_t first, size_t count, enum axiscert_question question,
                                                        const axiscert_results* results) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_mesh_range_f64(const double sphere[4], const axiscert_mesh_f64* mesh,
                                                        size_t first, size_t count, enum axiscert_question question,
                                                        const axiscert_results* results) AXISCERT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
