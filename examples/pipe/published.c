/* The published sphere-triangle predicate in C99, as a program for axiscert's pipe (docs/pipe.md):
 *
 *     cc -std=c99 -O2 -ffp-contract=off -o published published.c
 *     axiscert generate --family tangent --binary | ./published | axiscert judge --conforms-to published
 *     axiscert run --kernel program:published_c.json
 *
 * -ffp-contract=off forbids the compiler to fuse a * b + c into one operation with one rounding, as many do by
 * default where the machine has it: the replies would be those of another kernel, and deeply wrong on repeated
 * vertices. -DREAL=double makes the program for binary64. Big-endian machines would have to swap bytes. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#ifndef REAL
#define REAL float
#endif
typedef REAL real;
enum { GREATEST_HEADER = 1 << 20 }; /* bytes */
typedef struct {
  real x, y, z;
} vec;

static vec sub(vec u, vec v) { return (vec){u.x - v.x, u.y - v.y, u.z - v.z}; }
static vec scale(vec u, real s) { return (vec){u.x * s, u.y * s, u.z * s}; }
static real dot(vec u, vec v) { return (u.x * v.x + u.y * v.y) + u.z * v.z; }
static vec cross(vec u, vec v) { return (vec){u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x}; }

/* Bit 0: edge uv lies beyond the sphere; bit 1: so does the third vertex w. */
static unsigned beyond_edge(vec u, vec v, vec w, real uu, real uv, real rr) {
  const vec edge = sub(v, u);
  const real d = uv - uu, e = dot(edge, edge);
  const vec q = sub(scale(u, e), scale(edge, d));
  return (unsigned)(dot(q, q) > (rr * e) * e) | (unsigned)(dot(q, sub(scale(w, e), q)) > 0) << 1;
}

/* The sixteen comparisons; bit i is comparison i in axiscert's order. v: a, b, c, p, r. */
static unsigned comparisons(const real v[13]) {
  const vec p = {v[9], v[10], v[11]};
  const vec a = sub((vec){v[0], v[1], v[2]}, p), b = sub((vec){v[3], v[4], v[5]}, p);
  const vec c = sub((vec){v[6], v[7], v[8]}, p);
  const real rr = v[12] * v[12];
  const vec normal = cross(sub(b, a), sub(c, a));
  const real d = dot(a, normal), e = dot(normal, normal);
  const real aa = dot(a, a), ab = dot(a, b), ac = dot(a, c), bb = dot(b, b), bc = dot(b, c), cc = dot(c, c);
  const int first_ten[10] = {d * d > rr * e, aa > rr, ab > aa, ac > aa, bb > rr,
                             ab > bb,        bc > bb, cc > rr, ac > cc, bc > cc};
  unsigned bits = 0, i;
  for (i = 0; i < 10; ++i) bits |= (unsigned)first_ten[i] << i;
  return bits | beyond_edge(a, b, c, aa, ab, rr) << 10 | beyond_edge(b, c, a, bb, bc, rr) << 12 |
         beyond_edge(c, a, b, cc, ac, rr) << 14;
}

/* An axis separates if all its comparisons hold; sphere and triangle are separated if any axis separates. */
static int separated(unsigned bits) {
  static const unsigned axis[7] = {0x0001, 0x000e, 0x0070, 0x0380, 0x0c00, 0x3000, 0xc000};
  int i, any = 0;
  for (i = 0; i < 7; ++i) any |= (bits & axis[i]) == axis[i];
  return any;
}

static int fail(const char* what) {
  fprintf(stderr, "published: %s\n", what); /* standard output is for replies only */
  return 1;
}

/* One stream: its header, and a reply for each query. */
static int answer(unsigned char* header) {
  uint32_t version, precision, header_size;
  uint64_t count;
  if (memcmp(header, "AXISCERT", 8) != 0) return fail("standard input is not a query stream");
  memcpy(&version, header + 8, 4);
  memcpy(&precision, header + 12, 4);
  memcpy(&count, header + 16, 8);
  memcpy(&header_size, header + 24, 4);
  if (version != 3) return fail("the stream is not of version 3");
  if (precision != 8 * sizeof(real)) return fail("compiled for the other precision; see -DREAL");
  if (header_size < 64 || header_size > GREATEST_HEADER)
    return fail("the header is shorter than 64 bytes or longer than 1 MiB");
  if (fread(header + 64, 1, header_size - 64, stdin) != header_size - 64) return fail("the header is cut short");
  fwrite(header, 1, header_size, stdout);
  for (; count != 0; --count) {
    real query[13];
    unsigned bits;
    unsigned char reply[16] = {0, 1}; /* contact; flags: comparison bits are given */
    if (fread(query, sizeof query, 1, stdin) != 1) return fail("a query is cut short");
    bits = comparisons(query);
    reply[0] = (unsigned char)separated(bits);
    reply[8] = (unsigned char)(bits & 0xff);
    reply[9] = (unsigned char)(bits >> 8);
    fwrite(reply, sizeof reply, 1, stdout);
  }
  return fflush(stdout) == 0 ? 0 : fail("the replies cannot be written");
}

/* One stream in a pipe; `--kernel program:` writes one after another. */
int main(void) {
  static unsigned char header[GREATEST_HEADER];
  size_t got, streams = 0;
  for (; (got = fread(header, 1, 64, stdin)) == 64; ++streams) {
    if (answer(header) != 0) return 1;
  }
  return got == 0 && streams != 0 ? 0 : fail("standard input is not a query stream");
}
