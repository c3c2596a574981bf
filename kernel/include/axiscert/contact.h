/* Where a sphere and a triangle touch: the verdict of certified.h, the part of the triangle that is nearest, and how
 * far, where and in which direction, with bounds that hold for every finite input.
 *
 *     axiscert_contact_data_f32 at;
 *     if (axiscert_contact_f32(triangle, sphere, AXISCERT_CLOSED_SPHERE, &at) == AXISCERT_CONTACT)
 *       push(sphere, at.normal, -at.separation);
 *
 * Verdict and feature are exact. The numbers are within these bounds of the exact ones, with u = 2^-24 (f32) or 2^-53
 * (f64), M = max(|A-P|, |B-P|, |C-P|, r), and the least subnormal number more for each:
 *
 *                                               f32                         f64
 *   separation  distance - r                    u |separation| + 2^-13 u M  16 u M
 *   normal      from the point to the centre,   (1 + 2^-9) u                12 u
 *               of length 1
 *   point       of the triangle, the nearest    u |point| + 2^-12 u M       u |point| + 14 u M
 *               to the centre
 *
 * Of vectors it is the length of the difference. A nearest vertex is given as it stands. A separation has the sign of
 * its verdict: of the closed sphere it is at most 0 in contact and else positive, of the open one negative in contact
 * and else at least 0. One above the greatest number is infinite.
 *
 * Where the centre is on the triangle, no direction leads from the point to it: has_normal is 0, and the normal is that
 * of the face, on the side from which A, B, C turn counterclockwise; of a triangle without area one across its longest
 * edge, or z where it is a point. Along each of them r parts the two.
 *
 * The feature is the part of the least dimension that holds the nearest point: a vertex before an edge, an edge before
 * the face; among several, where vertices coincide or edges overlap, the first in the order of the enum.
 *
 * Where the verdict is AXISCERT_INVALID the feature is AXISCERT_NO_FEATURE, has_normal 0 and each number a NaN.
 *
 * The questions are those of spheres, closed and open; AXISCERT_CONSERVATIVE counts as the closed one. All else is as
 * certified.h says: modes, threads, allocation, alignment. All numbers are the same, to the bit, on every instruction
 * set, and for one pair, many or a mesh; AXISCERT_EXACT_ONLY may give others, within the bounds.
 */
#ifndef AXISCERT_CONTACT_H
#define AXISCERT_CONTACT_H

#include "certified.h"

#ifdef __cplusplus
extern "C" {
#endif

enum axiscert_feature {
  AXISCERT_VERTEX_A = 0,
  AXISCERT_VERTEX_B = 1,
  AXISCERT_VERTEX_C = 2,
  AXISCERT_EDGE_AB = 3,
  AXISCERT_EDGE_BC = 4,
  AXISCERT_EDGE_CA = 5,
  AXISCERT_FACE = 6,
  AXISCERT_NO_FEATURE = 7
};

typedef struct axiscert_contact_data_f32 {
  float separation;
  float normal[3], point[3];
  uint8_t feature; /* an axiscert_feature */
  uint8_t has_normal;
} axiscert_contact_data_f32;
typedef struct axiscert_contact_data_f64 {
  double separation;
  double normal[3], point[3];
  uint8_t feature;
  uint8_t has_normal;
} axiscert_contact_data_f64;

/* One pair; `data` may be null. */
AXISCERT_EXPORT enum axiscert_verdict axiscert_contact_f32(const float triangle[9], const float sphere[4],
                                                           enum axiscert_question question,
                                                           axiscert_contact_data_f32* data) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT enum axiscert_verdict axiscert_contact_f64(const double triangle[9], const double sphere[4],
                                                           enum axiscert_question question,
                                                           axiscert_contact_data_f64* data) AXISCERT_NOEXCEPT;

/* The arrays to write: each one that is not null, one entry a query or a contact. */
typedef struct axiscert_contact_arrays_f32 {
  uint8_t* verdict; /* of pairs; a mesh call, whose entries are contacts, does not write it */
  uint8_t* feature;
  uint8_t* has_normal;
  float* separation;
  float* normal[3]; /* x, y, z */
  float* point[3];
} axiscert_contact_arrays_f32;
typedef struct axiscert_contact_arrays_f64 {
  uint8_t* verdict;
  uint8_t* feature;
  uint8_t* has_normal;
  double* separation;
  double* normal[3];
  double* point[3];
} axiscert_contact_arrays_f64;

/* Many pairs, structure of arrays, as axiscert_pairs_f32: an entry for each query, contact or not. */
AXISCERT_EXPORT axiscert_counts axiscert_contact_pairs_f32(const float* const columns[13], size_t size,
                                                           enum axiscert_question question,
                                                           const axiscert_contact_arrays_f32* arrays) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_contact_pairs_f64(const double* const columns[13], size_t size,
                                                           enum axiscert_question question,
                                                           const axiscert_contact_arrays_f64* arrays) AXISCERT_NOEXCEPT;

/* One sphere against triangles of a mesh, as axiscert_mesh_list_f32 and axiscert_mesh_range_f32: the contacts alone,
 * one after the other. Entry i belongs to triangle hits[i], which is below 2^32. Each array, and hits, which must not
 * be null, needs room for `count` entries; contents after the contacts are unspecified. */
AXISCERT_EXPORT axiscert_counts axiscert_contact_mesh_list_f32(
    const float sphere[4], const axiscert_mesh_f32* mesh, const uint32_t* triangle, size_t count,
    enum axiscert_question question, uint32_t* hits, const axiscert_contact_arrays_f32* arrays) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_contact_mesh_list_f64(
    const double sphere[4], const axiscert_mesh_f64* mesh, const uint32_t* triangle, size_t count,
    enum axiscert_question question, uint32_t* hits, const axiscert_contact_arrays_f64* arrays) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_contact_mesh_range_f32(
    const float sphere[4], const axiscert_mesh_f32* mesh, size_t first, size_t count, enum axiscert_question question,
    uint32_t* hits, const axiscert_contact_arrays_f32* arrays) AXISCERT_NOEXCEPT;
AXISCERT_EXPORT axiscert_counts axiscert_contact_mesh_range_f64(
    const double sphere[4], const axiscert_mesh_f64* mesh, size_t first, size_t count, enum axiscert_question question,
    uint32_t* hits, const axiscert_contact_arrays_f64* arrays) AXISCERT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
