/* One pair at a time. The sphere touches the triangle's longest edge in one point: float arithmetic may answer
 * either, and the exact answer depends on the question. */
#include <axiscert/certified.h>
#include <stdio.h>

int main(void) {
  const float triangle[9] = {-2, 3, 0, 1, 3, 0, 2, 3, 0}; /* three vertices on a line: no area */
  const float touching[4] = {0, 0, 0, 3}, clear[4] = {0, 0, 0, 2.9999998f};
  const int closed = axiscert_pair_f32(triangle, touching, AXISCERT_CLOSED_SPHERE) == AXISCERT_CONTACT;
  const int open = axiscert_pair_f32(triangle, touching, AXISCERT_OPEN_SPHERE) == AXISCERT_CONTACT;
  const int other = axiscert_pair_f32(triangle, clear, AXISCERT_CLOSED_SPHERE) == AXISCERT_CONTACT;
  printf("touching, closed sphere: %s\n", closed ? "contact" : "separated");
  printf("touching, open sphere: %s\n", open ? "contact" : "separated");
  printf("an ulp smaller: %s\n", other ? "contact" : "separated");
  return closed && !open && !other ? 0 : 1;
}
