/* One's own kernel, say of spheres against triangles, for axiscert to judge: `axiscert run --kernel plugin:PATH.so`.
 *
 * A plug-in is a shared object that exports one function, axiscert_plugin, which hands out kernels: at most one in each
 * precision. This header is all that it needs: C99, or C++11; no library to link. The smallest plug-in is a function of
 * one query, which returns an axiscert_verdict, and one line:
 *
 *     static int my_test(const float a[3], const float b[3], const float c[3], const float p[3], float r) { ... }
 *     AXISCERT_PLUGIN(float, "my-test", my_test)
 *
 * There is a line for each predicate (`axiscert predicates`). `real` is float or double, and every array is const:
 *
 *   sphere-triangle: the triangle abc, and the sphere of centre p and radius r
 *       AXISCERT_PLUGIN(real, "NAME", f)
 *           f(real a[3], real b[3], real c[3], real p[3], real r)
 *       AXISCERT_CONTACT_PLUGIN(real, "NAME", f, MEASURES)
 *           the same; MEASURES is what f says beside its verdict, as below, where `all` begins with real* separation
 *   moving-sphere: the same, where the centre goes from p to p + d, or to the end e
 *       AXISCERT_MOTION_PLUGIN(real, "NAME", f, displacement, MEASURES)
 *           f(real a[3], real b[3], real c[3], real p[3], real d[3], real r)
 *       AXISCERT_MOTION_PLUGIN(real, "NAME", f, endpoints, MEASURES)
 *           f(real a[3], real b[3], real c[3], real p[3], real e[3], real r)
 *       MEASURES is what f says of the first contact, in arguments that it writes and that say "not given" before:
 *           none   nothing
 *           time   f(..., real* time)
 *           all    f(..., real* time, real* feature, real normal[3], real point[3])
 *   box-box: each box by its centre, half extents, and its axes, 0 1 2 one after the other, or a quaternion w x y z; or
 *   a box along the world's axes by its two corners
 *       AXISCERT_BOX_PLUGIN(real, "NAME", f, matrix)
 *           f(real a_centre[3], real a_half[3], real a_axes[9], real b_centre[3], real b_half[3], real b_axes[9])
 *       AXISCERT_BOX_PLUGIN(real, "NAME", f, quaternion)
 *           f(real a_centre[3], real a_half[3], real a_turn[4], real b_centre[3], real b_half[3], real b_turn[4])
 *       AXISCERT_BOX_PLUGIN(real, "NAME", f, minmax)
 *           f(real a_low[3], real a_high[3], real b_low[3], real b_high[3])
 *       AXISCERT_BOX_PLUGIN(real, "NAME", f, minmax_quaternion)
 *           f(real a_low[3], real a_high[3], real b_centre[3], real b_half[3], real b_turn[4])
 *   box-triangle: a box along the world's axes, by its centre or by its two corners, or an oriented one, and abc
 *       AXISCERT_BOX_TRIANGLE_PLUGIN(real, "NAME", f, centre)
 *           f(real centre[3], real half[3], real a[3], real b[3], real c[3])
 *       AXISCERT_BOX_TRIANGLE_PLUGIN(real, "NAME", f, minmax)
 *           f(real low[3], real high[3], real a[3], real b[3], real c[3])
 *       AXISCERT_BOX_TRIANGLE_PLUGIN(real, "NAME", f, matrix)
 *           f(real centre[3], real half[3], real axes[9], real a[3], real b[3], real c[3])
 *       AXISCERT_BOX_TRIANGLE_PLUGIN(real, "NAME", f, quaternion)
 *           f(real centre[3], real half[3], real turn[4], real a[3], real b[3], real c[3])
 *
 * Such a kernel shows its verdicts, and touching is contact. One that shows its comparisons or declares more is a line
 * of AXISCERT_PLUGIN_OF; one that takes whole batches, or both precisions, fills in axiscert_kernel itself. Both are
 * below.
 *
 * axiscert runs a plug-in in a process of its own. What it does wrong there beside a wrong answer (a crash, a hang, an
 * access outside its arrays, answers that change from call to call or with a query's place in the batch, a changed
 * floating-point environment) is reported with the query that did it, and the run goes on. The process keeps accidents
 * apart; it is no defence against a plug-in that means harm.
 */
#ifndef AXISCERT_PLUGIN_H
#define AXISCERT_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of everything below. A change to an existing member gives the interface another number, and axiscert
 * refuses a kernel of any other: build it again with the header of that axiscert. A new member goes to the end of its
 * struct and leaves the number as it is: every struct has a `size` in bytes, set by the side that fills it in, and the
 * other side reads nothing beyond it. */
#define AXISCERT_PLUGIN_ABI 3u

/* Upper limits for every predicate. */
#define AXISCERT_MOST_COLUMNS 64
#define AXISCERT_MOST_COMPARISONS 64
#define AXISCERT_MOST_MEASURES 64

#if defined(_WIN32)
#define AXISCERT_EXPORT __declspec(dllexport)
#else
#define AXISCERT_EXPORT __attribute__((visibility("default")))
#endif

/* The answer to a query. In sphere-triangle the query is the closed solid sphere of centre p and radius r and the
 * closed triangle abc. */
enum axiscert_verdict {
  AXISCERT_CONTACT = 0,
  AXISCERT_SEPARATED = 1,
  AXISCERT_UNDECIDED = 2, /* the kernel declines to say: a fault, unless its `may_decline` is 1 */
  AXISCERT_INVALID = 3    /* no query: a number that is not finite, a negative radius; or a result that is NaN */
};

/* The outputs that a kernel can fill in. Each value includes the one before. */
enum axiscert_exposure { AXISCERT_VERDICT_ONLY = 0, AXISCERT_COMPARISONS = 1, AXISCERT_SIDES = 2 };

/* The intended answer where the two touch without overlapping: in sphere-triangle, where the distance is exactly r. */
enum axiscert_touching {
  AXISCERT_TOUCHING_IS_CONTACT = 0,
  AXISCERT_TOUCHING_IS_SEPARATED = 1,
  AXISCERT_TOUCHING_IS_EITHER = 2 /* it makes no promise: neither answer is counted as wrong */
};

/* What a kernel of a predicate of motions promises, where engines differ. Queries beyond it are counted apart and fail
 * no requirement. Zero is the whole promise. */
enum axiscert_start {                                    /* of two that have a point in common before the motion */
                      AXISCERT_START_IS_REPORTED = 0,    /* contact, at time 0 */
                      AXISCERT_START_IF_APPROACHING = 1, /* contact, where the distance between them falls at first */
                      AXISCERT_START_IS_IGNORED = 2      /* nothing */
};
enum axiscert_still { /* of a displacement of zero */
                      AXISCERT_STILL_IS_REPORTED = 0,
                      AXISCERT_STILL_IS_IGNORED = 1
};
enum axiscert_sides { /* of triangles; of predicates without motions that have one too */
                      AXISCERT_BOTH_SIDES = 0,
                      /* those that the motion meets from the front: d.(ab x ac) < 0; without a motion those in front of
                       * which the centre of the sphere or box is: (p - a).(ab x ac) > 0 */
                      AXISCERT_FRONT_ONLY = 1
};

/* A batch of queries, structure of arrays. Each column has exactly `count` numbers of the kernel's precision, float or
 * double, and no more alignment than one of these; it is read-only, and the pages around it cannot be touched. Any bits
 * can come: infinities, NaN, subnormal numbers, negative radii. `count` is any number from 1 on. */
typedef struct axiscert_batch {
  size_t size; /* bytes of this struct */
  size_t count;
  size_t column_count; /* the columns of the kernel's entry */
  /* The columns in the order of `axiscert predicates`; in sphere-triangle ax ay az bx by bz cx cy cz px py pz r. */
  const void* const* column;
} axiscert_batch;

/* The arrays for the answers to a batch, each of exactly the batch's count. A null pointer is not asked for. */
typedef struct axiscert_answers {
  size_t size;
  uint8_t* verdict; /* an axiscert_verdict each; never null */
  /* For kernels that expose AXISCERT_COMPARISONS or more. Bit i is 1 where comparison i holds; bits beyond the last
   * comparison are 0. `axiscert predicates` lists the comparisons; those of sphere-triangle are
   *   0 plane.radius
   *   1 vertex_a.radius   2 vertex_a.side_b   3 vertex_a.side_c
   *   4 vertex_b.radius   5 vertex_b.side_a   6 vertex_b.side_c
   *   7 vertex_c.radius   8 vertex_c.side_a   9 vertex_c.side_b
   *  10 edge_ab.radius   11 edge_ab.side_c
   *  12 edge_bc.radius   13 edge_bc.side_a
   *  14 edge_ca.radius   15 edge_ca.side_b */
  uint64_t* comparisons;
  /* For kernels that expose AXISCERT_SIDES: `comparison_count` arrays each, with both sides of each `lhs > rhs` as
   * computed, in the kernel's precision. */
  size_t comparison_count; /* the comparisons of the predicate */
  void* const* lhs;
  void* const* rhs;
  /* Numbers beside the verdict, such as a time of impact, in the kernel's precision: as many arrays as the kernel's own
   * measure_count, or none where they are not asked for. Every entry is written; a NaN says that the number is not
   * given. Those of moving-sphere stand beside contact, and are
   *   0 time      fraction of the displacement at the first contact, from 0 to 1
   *   1 feature   what is nearest to the centre then: 0, 1, 2 vertex a, b, c; 3, 4, 5 edge ab, bc, ca; 6 the face
   *   2, 3, 4     normal: unit vector from the triangle's nearest point to the centre then
   *   5, 6, 7     point: the triangle's point
   * Those of sphere-triangle stand beside both verdicts: the same, of the sphere as it is, with
   *   0 separation   distance of the centre less the radius: below 0 where the two overlap
   * Those of box-box, box-triangle and capsule-triangle stand beside both verdicts too:
   *   0 separation   distance of the two, or less their penetration
   *   1, 2, 3        normal: unit vector in which the second is pushed
   *   4 to 6, 7 to 9 a point of the first, and one of the second */
  size_t measure_count;
  void* const* measure;
} axiscert_answers;

/* The range in which the kernel promises right answers. Wrong answers to queries outside it are reported separately and
 * fail no requirement. Members that are zero set no limit. Those but the last are of sphere-triangle. */
typedef struct axiscert_limits {
  size_t size;                /* sizeof(axiscert_limits) */
  double least_coordinate;    /* of |x| for each coordinate of a, b, c, p that is not zero; 0: none */
  double greatest_coordinate; /* of |x| for each coordinate of a, b, c, p; 0: none */
  double least_area;          /* of the triangle; 0: none */
  double least_radius;        /* 0: none */
  double greatest_radius;     /* 0: none */
  /* Of any predicate: contact may be reported where the two are apart by at most this length. 0: none. */
  double margin;
} axiscert_limits;

/* One kernel in one precision. The members down to `run` are needed; zero in any other is the simplest choice. */
typedef struct axiscert_kernel {
  uint32_t abi;       /* AXISCERT_PLUGIN_ABI */
  uint32_t precision; /* 32: the arrays are float; 64: double */
  size_t size;        /* sizeof(axiscert_kernel) */
  const char* name;
  size_t column_count; /* the columns that it reads: those of its entry, 13 in sphere-triangle */
  /* Answers the batch. Called from one thread; the floating-point environment is the default one, and is to be so on
   * return. Its answer to a query depends on that query alone. */
  void (*run)(const axiscert_batch* batch, const axiscert_answers* answers);
  const char* predicate; /* the question that it answers (`axiscert predicates`); null: "sphere-triangle" */
  const char* entry;     /* the form in which it takes the numbers; null: the predicate's first */
  const char* summary;   /* one line; null: none */
  const char* source;    /* AXISCERT_SOURCE, "FILE:LINE", its place in its author's sources; null: unknown */
  uint32_t exposes;      /* an axiscert_exposure */
  uint32_t touching;     /* an axiscert_touching */
  size_t measure_count;  /* it gives so many of the predicate's measures, from the first on */
  /* The id of a built-in kernel (`axiscert kernels`) that it equals bit for bit: any difference is then an
   * `implementation` fault. Null: none. */
  const char* conforms_to;
  /* The id of a built-in kernel whose formulae it evaluates, in an order or arithmetic of its own: its comparisons are
   * compared with these in exact arithmetic. Null: those of conforms_to; where that is null too, "published" for a
   * kernel of sphere-triangle that exposes comparisons, and else none, so that only its verdict is judged. */
  const char* formulae;
  const axiscert_limits* limits; /* null: none */
  uint32_t start;                /* an axiscert_start, of a predicate of motions, as the next one */
  uint32_t still;                /* an axiscert_still */
  uint32_t sides;                /* an axiscert_sides */
  /* 0: it answers separated or contact to every valid query within its limits. 1: it may answer AXISCERT_UNDECIDED. */
  uint32_t may_decline;
} axiscert_kernel;

/* The only export of a plug-in: kernel number `index`, from 0 on; null where there is none. The kernel is read once and
 * has to stay in memory. */
AXISCERT_EXPORT const axiscert_kernel* axiscert_plugin(uint32_t index);

/* The file and line where it is written, for axiscert_kernel.source. */
#define AXISCERT_SOURCE __FILE__ ":" AXISCERT_I_TEXT(__LINE__)
#define AXISCERT_I_TEXT(line) AXISCERT_I_TEXT_OF(line)
#define AXISCERT_I_TEXT_OF(line) #line

/* Kernels from a function of one query. Names that these macros define begin with axiscert_i_; their words (matrix,
 * time and so on) are not taken for macros of the user's. */
#define AXISCERT_PLUGIN(real, kernel_name, one_query) \
  AXISCERT_PLUGIN_OF(real, kernel_name, one_query, TRIANGLE, vertices, none, )
#define AXISCERT_CONTACT_PLUGIN(real, kernel_name, one_query, measures) \
  AXISCERT_PLUGIN_OF(real, kernel_name, one_query, TRIANGLE, vertices, measures, )
#define AXISCERT_MOTION_PLUGIN(real, kernel_name, one_query, entry, measures)                                \
  AXISCERT_I_PLUGIN(real, kernel_name, one_query, AXISCERT_I_GIVE_##measures, AXISCERT_I_DECLARE_##measures, \
                    AXISCERT_I_MOTION_##entry)
#define AXISCERT_BOX_PLUGIN(real, kernel_name, one_query, entry) \
  AXISCERT_I_PLUGIN(real, kernel_name, one_query, AXISCERT_I_GIVE_none, , AXISCERT_I_BOX_##entry)
#define AXISCERT_BOX_TRIANGLE_PLUGIN(real, kernel_name, one_query, entry) \
  AXISCERT_I_PLUGIN(real, kernel_name, one_query, AXISCERT_I_GIVE_none, , AXISCERT_I_BOX_TRIANGLE_##entry)

/* All that those can be, and more. `predicate` is TRIANGLE (whose entry is vertices), MOTION, CAPSULE (endpoints), BOX
 * or BOX_TRIANGLE. `gives` is none, time or separation (the first measure), all, of two bodies pair (real* separation,
 * real normal[3], real point_a[3], real point_b[3]), or comparisons: then the last argument of the function is a
 * `uint64_t* comparisons`, 0 before, whose bits it sets, and a kernel of another predicate than sphere-triangle
 * declares formulae or conforms_to. `declarations` are any number of AXISCERT_DECLARE(member, value), of
 * axiscert_kernel: AXISCERT_PLUGIN_OF(float, "my-boxes", my_boxes, BOX, matrix, comparisons,
 *                        AXISCERT_DECLARE(conforms_to, "box-box/cofactor"))
 */
#define AXISCERT_PLUGIN_OF(real, kernel_name, one_query, predicate, entry, gives, declarations)                     \
  AXISCERT_I_PLUGIN(real, kernel_name, one_query, AXISCERT_I_GIVE_##gives, AXISCERT_I_DECLARE_##gives declarations, \
                    AXISCERT_I_##predicate##_##entry)
#define AXISCERT_DECLARE(member, value) axiscert_i_kernel.member = (value);

/* `static void batch_function(batch, answers)` alone, for axiscert_kernel.run, with the words of AXISCERT_PLUGIN_OF;
 * and the two of sphere-triangle. */
#define AXISCERT_BATCH_OF(batch_function, real, one_query, predicate, entry, gives) \
  AXISCERT_I_BATCH(batch_function, real, one_query, AXISCERT_I_GIVE_##gives, AXISCERT_I_##predicate##_##entry)
#define AXISCERT_BATCH(batch_function, real, one_query) \
  AXISCERT_BATCH_OF(batch_function, real, one_query, TRIANGLE, vertices, none)
#define AXISCERT_BATCH_WITH_COMPARISONS(batch_function, real, one_query) \
  AXISCERT_BATCH_OF(batch_function, real, one_query, TRIANGLE, vertices, comparisons)

/* Each entry: its predicate, its name, its columns, and the arguments that are made of the numbers of a query. */
#define AXISCERT_I_TRIANGLE_vertices \
  "sphere-triangle", "vertices", 13, AXISCERT_I_CORNERS(0), axiscert_i_v + 9, axiscert_i_v[12]
#define AXISCERT_I_MOTION_displacement "moving-sphere", "displacement", AXISCERT_I_MOTION
#define AXISCERT_I_MOTION_endpoints "moving-sphere", "endpoints", AXISCERT_I_MOTION
#define AXISCERT_I_CAPSULE_endpoints "capsule-triangle", "endpoints", AXISCERT_I_MOTION
#define AXISCERT_I_MOTION 16, AXISCERT_I_CORNERS(0), axiscert_i_v + 9, axiscert_i_v + 12, axiscert_i_v[15]
#define AXISCERT_I_BOX_matrix "box-box", "matrix", 30, AXISCERT_I_TURNED(0), AXISCERT_I_TURNED(15)
#define AXISCERT_I_BOX_quaternion "box-box", "quaternion", 20, AXISCERT_I_TURNED(0), AXISCERT_I_TURNED(10)
#define AXISCERT_I_BOX_minmax "box-box", "minmax", 12, AXISCERT_I_CORNERS(0), axiscert_i_v + 9
#define AXISCERT_I_BOX_minmax_quaternion \
  "box-box", "minmax-quaternion", 16, axiscert_i_v, axiscert_i_v + 3, AXISCERT_I_TURNED(6)
#define AXISCERT_I_BOX_TRIANGLE_centre "box-triangle", "centre", AXISCERT_I_UPRIGHT
#define AXISCERT_I_BOX_TRIANGLE_minmax "box-triangle", "minmax", AXISCERT_I_UPRIGHT
#define AXISCERT_I_UPRIGHT 15, axiscert_i_v, axiscert_i_v + 3, AXISCERT_I_CORNERS(6)
#define AXISCERT_I_BOX_TRIANGLE_matrix "box-triangle", "matrix", 24, AXISCERT_I_TURNED(0), AXISCERT_I_CORNERS(15)
#define AXISCERT_I_BOX_TRIANGLE_quaternion \
  "box-triangle", "quaternion", 19, AXISCERT_I_TURNED(0), AXISCERT_I_CORNERS(10)
#define AXISCERT_I_TURNED(first) axiscert_i_v + first, axiscert_i_v + first + 3, axiscert_i_v + first + 6
#define AXISCERT_I_CORNERS(first) AXISCERT_I_TURNED(first) /* three points */

/* The call, and what is done with what the function gives. All bits 1 is a NaN: not given. */
#define AXISCERT_I_GIVE_none(real, one_query, ...) \
  axiscert_i_answers->verdict[axiscert_i_i] = (uint8_t)(one_query)(__VA_ARGS__)
#define AXISCERT_I_GIVE_comparisons(real, one_query, ...)               \
  uint64_t axiscert_i_bits = 0;                                         \
  AXISCERT_I_GIVE_none(real, one_query, __VA_ARGS__, &axiscert_i_bits); \
  if (axiscert_i_answers->comparisons) axiscert_i_answers->comparisons[axiscert_i_i] = axiscert_i_bits
#define AXISCERT_I_GIVE_time(real, one_query, ...) AXISCERT_I_MEASURED(real, one_query, __VA_ARGS__, axiscert_i_m)
#define AXISCERT_I_GIVE_separation(real, one_query, ...) AXISCERT_I_MEASURED(real, one_query, __VA_ARGS__, axiscert_i_m)
#define AXISCERT_I_GIVE_all(real, one_query, ...) \
  AXISCERT_I_MEASURED(real, one_query, __VA_ARGS__, axiscert_i_m, axiscert_i_m + 1, axiscert_i_m + 2, axiscert_i_m + 5)
#define AXISCERT_I_GIVE_pair(real, one_query, ...) \
  AXISCERT_I_MEASURED(real, one_query, __VA_ARGS__, axiscert_i_m, axiscert_i_m + 1, axiscert_i_m + 4, axiscert_i_m + 7)
#define AXISCERT_I_MEASURED(real, one_query, ...)                                                  \
  real axiscert_i_m[10];                                                                           \
  for (axiscert_i_k = 0; axiscert_i_k < sizeof axiscert_i_m; ++axiscert_i_k) {                     \
    ((unsigned char*)axiscert_i_m)[axiscert_i_k] = 0xff;                                           \
  }                                                                                                \
  AXISCERT_I_GIVE_none(real, one_query, __VA_ARGS__);                                              \
  for (axiscert_i_k = 0; axiscert_i_k < axiscert_i_answers->measure_count; ++axiscert_i_k) {       \
    ((real*)axiscert_i_answers->measure[axiscert_i_k])[axiscert_i_i] = axiscert_i_m[axiscert_i_k]; \
  }

#define AXISCERT_I_DECLARE_none
#define AXISCERT_I_DECLARE_comparisons AXISCERT_DECLARE(exposes, AXISCERT_COMPARISONS)
#define AXISCERT_I_DECLARE_time AXISCERT_DECLARE(measure_count, 1)
#define AXISCERT_I_DECLARE_separation AXISCERT_DECLARE(measure_count, 1)
#define AXISCERT_I_DECLARE_all AXISCERT_DECLARE(measure_count, 8)
#define AXISCERT_I_DECLARE_pair AXISCERT_DECLARE(measure_count, 10)

/* The batch function, and the kernel around it; the last arguments are those of an entry. */
#define AXISCERT_I_BATCH(batch_function, real, one_query, give, ...) \
  AXISCERT_I_BATCH_OF(batch_function, real, one_query, give, __VA_ARGS__)
#define AXISCERT_I_BATCH_OF(batch_function, real, one_query, give, id, entry, columns, ...)                        \
  static void batch_function(const axiscert_batch* axiscert_i_batch, const axiscert_answers* axiscert_i_answers) { \
    size_t axiscert_i_i, axiscert_i_k;                                                                             \
    for (axiscert_i_i = 0; axiscert_i_i < axiscert_i_batch->count; ++axiscert_i_i) {                               \
      real axiscert_i_v[columns];                                                                                  \
      for (axiscert_i_k = 0; axiscert_i_k < columns; ++axiscert_i_k) {                                             \
        axiscert_i_v[axiscert_i_k] = ((const real*)axiscert_i_batch->column[axiscert_i_k])[axiscert_i_i];          \
      }                                                                                                            \
      give(real, one_query, __VA_ARGS__);                                                                          \
    }                                                                                                              \
  }
#define AXISCERT_I_PLUGIN(real, kernel_name, one_query, give, declarations, ...) \
  AXISCERT_I_BATCH_OF(axiscert_i_run, real, one_query, give, __VA_ARGS__)        \
  AXISCERT_I_EXPORT(real, kernel_name, declarations, __VA_ARGS__)
#define AXISCERT_I_EXPORT(real, kernel_name, declarations, id, its_entry, columns, ...) \
  const axiscert_kernel* axiscert_plugin(uint32_t axiscert_i_index) {                   \
    static axiscert_kernel axiscert_i_kernel;                                           \
    if (axiscert_i_index != 0) return NULL;                                             \
    axiscert_i_kernel.abi = AXISCERT_PLUGIN_ABI;                                        \
    axiscert_i_kernel.precision = 8 * (uint32_t)sizeof(real);                           \
    axiscert_i_kernel.size = sizeof(axiscert_kernel);                                   \
    axiscert_i_kernel.name = (kernel_name);                                             \
    axiscert_i_kernel.column_count = columns;                                           \
    axiscert_i_kernel.run = axiscert_i_run;                                             \
    axiscert_i_kernel.predicate = id;                                                   \
    axiscert_i_kernel.entry = its_entry;                                                \
    axiscert_i_kernel.source = AXISCERT_SOURCE;                                         \
    { declarations }                                                                    \
    return &axiscert_i_kernel;                                                          \
  }

#ifdef __cplusplus
}
#endif

#endif
