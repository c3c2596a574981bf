/* One's own sphere-triangle kernel, for axiscert to judge: `axiscert run --kernel plugin:PATH.so`.
 *
 * A plug-in is a shared object that exports one function, axiscert_plugin, which hands out kernels: at most one in each
 * precision. This header is all that it needs: C99, or C++11; no library to link. The smallest plug-in is a function of
 * one query and one line:
 *
 *     static int my_test(const float a[3], const float b[3], const float c[3], const float p[3], float r) { ... }
 *     AXISCERT_PLUGIN(float, "my-test", my_test)
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

/* The version of everything below. A later one that changes any layout has another number, and axiscert refuses a
 * kernel whose number it does not know. */
#define AXISCERT_PLUGIN_ABI 1u

#if defined(_WIN32)
#define AXISCERT_EXPORT __declspec(dllexport)
#else
#define AXISCERT_EXPORT __attribute__((visibility("default")))
#endif

/* What a kernel says of a query: the closed solid sphere of centre p and radius r, the closed triangle abc. */
enum axiscert_verdict {
  AXISCERT_CONTACT = 0,
  AXISCERT_SEPARATED = 1,
  AXISCERT_UNDECIDED = 2, /* the kernel declines to say */
  AXISCERT_INVALID = 3    /* no query: a coordinate that is not finite, a negative radius; or a result that is NaN */
};

/* What a kernel can fill in beside its verdicts. Each includes the one before. */
enum axiscert_exposure { AXISCERT_VERDICT_ONLY = 0, AXISCERT_COMPARISONS = 1, AXISCERT_SIDES = 2 };

/* What the kernel means to say of a sphere that touches the triangle in one point, its distance being exactly r. */
enum axiscert_touching {
  AXISCERT_TOUCHING_IS_CONTACT = 0,
  AXISCERT_TOUCHING_IS_SEPARATED = 1,
  AXISCERT_TOUCHING_IS_EITHER = 2 /* it makes no promise: neither answer is counted as wrong */
};

/* A batch of queries, structure of arrays. Each array has exactly `size` entries of the kernel's precision, float or
 * double, and no more alignment than one of these; it is read-only, and the pages around it cannot be touched. Any bits
 * can come: infinities, NaN, subnormal numbers, negative radii. `size` is any number from 1 on. */
typedef struct axiscert_batch {
  size_t size;
  const void* coordinate[13]; /* ax ay az bx by bz cx cy cz px py pz r */
} axiscert_batch;

/* Where the answers to a batch go: arrays of exactly the batch's size. An array that is null is not asked for. */
typedef struct axiscert_answers {
  uint8_t* verdict; /* an axiscert_verdict each; never null */
  /* From AXISCERT_COMPARISONS on. Bit i is comparison i, 1 where it holds:
   *   0 plane.radius
   *   1 vertex_a.radius   2 vertex_a.side_b   3 vertex_a.side_c
   *   4 vertex_b.radius   5 vertex_b.side_a   6 vertex_b.side_c
   *   7 vertex_c.radius   8 vertex_c.side_a   9 vertex_c.side_b
   *  10 edge_ab.radius   11 edge_ab.side_c
   *  12 edge_bc.radius   13 edge_bc.side_a
   *  14 edge_ca.radius   15 edge_ca.side_b */
  uint16_t* comparisons;
  /* From AXISCERT_SIDES on: both sides of each `lhs > rhs` as computed, in the kernel's precision. */
  void* lhs[16];
  void* rhs[16];
  /* Reserved: null in this version, and not to be written. */
  void* distance;
  void* closest_point[3];
  void* normal[3];
  uint8_t* feature;
} axiscert_answers;

/* Within what the kernel promises to be right. Wrong answers to queries outside are reported apart and fail no
 * requirement. All zero: everywhere. */
typedef struct axiscert_limits {
  double least_coordinate;    /* of |x| for each coordinate of a, b, c, p that is not zero; 0: none */
  double greatest_coordinate; /* of |x| for each coordinate of a, b, c, p; 0: none */
  double least_area;          /* of the triangle; 0: none */
  double least_radius;        /* 0: none */
  double greatest_radius;     /* 0: none */
} axiscert_limits;

/* One kernel in one precision. Members left out of an initialiser are zero, which says the least of each. */
typedef struct axiscert_kernel {
  uint32_t abi;       /* AXISCERT_PLUGIN_ABI */
  uint32_t precision; /* 32: the arrays are float; 64: double */
  const char* name;
  /* Answers the batch. Called from one thread; the floating-point environment is the default one, and is to be so on
   * return. Its answer to a query depends on that query alone. */
  void (*run)(const axiscert_batch* batch, const axiscert_answers* answers);
  const char* summary; /* one line; null: none */
  uint32_t exposes;    /* an axiscert_exposure */
  uint32_t touching;   /* an axiscert_touching */
  /* The id of a built-in kernel (`axiscert kernels`) that it equals bit for bit: any difference is then an
   * `implementation` fault. Null: none. */
  const char* conforms_to;
  /* The id of a built-in kernel whose formulae it evaluates, in an order or arithmetic of its own: its comparisons are
   * held against these in exact arithmetic. Null: those of conforms_to; where that is null too, "published" for a
   * kernel that exposes comparisons, and else none, so that only its verdict is judged. */
  const char* formulae;
  axiscert_limits limits;
  const void* reserved[4]; /* null */
} axiscert_kernel;

/* The plug-in's one export: its kernel number `index`, from 0 on; null where there is none. What it points to is
 * read once and has to stay. */
AXISCERT_EXPORT const axiscert_kernel* axiscert_plugin(uint32_t index);

/* Defines `static void batch_function(batch, answers)`, for axiscert_kernel.run, from a function of one query:
 *     int one_query(const real a[3], const real b[3], const real c[3], const real p[3], real r)
 * which returns an axiscert_verdict. `real` is float or double. */
#define AXISCERT_BATCH(batch_function, real, one_query)                                      \
  static void batch_function(const axiscert_batch* batch, const axiscert_answers* answers) { \
    size_t i;                                                                                \
    int k;                                                                                   \
    for (i = 0; i < batch->size; ++i) {                                                      \
      real v[13];                                                                            \
      for (k = 0; k < 13; ++k) v[k] = ((const real*)batch->coordinate[k])[i];                \
      answers->verdict[i] = (uint8_t)one_query(v, v + 3, v + 6, v + 9, v[12]);               \
    }                                                                                        \
  }

/* The same for a function that also gives the sixteen comparison bits; for a kernel that exposes comparisons:
 *     int one_query(const real a[3], const real b[3], const real c[3], const real p[3], real r, uint16_t *comparisons)
 */
#define AXISCERT_BATCH_WITH_COMPARISONS(batch_function, real, one_query)                     \
  static void batch_function(const axiscert_batch* batch, const axiscert_answers* answers) { \
    size_t i;                                                                                \
    int k;                                                                                   \
    for (i = 0; i < batch->size; ++i) {                                                      \
      real v[13];                                                                            \
      uint16_t bits = 0;                                                                     \
      for (k = 0; k < 13; ++k) v[k] = ((const real*)batch->coordinate[k])[i];                \
      answers->verdict[i] = (uint8_t)one_query(v, v + 3, v + 6, v + 9, v[12], &bits);        \
      if (answers->comparisons) answers->comparisons[i] = bits;                              \
    }                                                                                        \
  }

/* A whole plug-in from a function of one query, as for AXISCERT_BATCH: one kernel, verdicts only, touching is contact.
 */
#define AXISCERT_PLUGIN(real, kernel_name, one_query)          \
  AXISCERT_BATCH(axiscert_batch_of_one_query, real, one_query) \
  const axiscert_kernel* axiscert_plugin(uint32_t index) {     \
    static axiscert_kernel kernel;                             \
    if (index != 0) return NULL;                               \
    kernel.abi = AXISCERT_PLUGIN_ABI;                          \
    kernel.precision = 8 * (uint32_t)sizeof(real);             \
    kernel.name = kernel_name;                                 \
    kernel.run = axiscert_batch_of_one_query;                  \
    return &kernel;                                            \
  }

#ifdef __cplusplus
}
#endif

#endif
