/* Where spheres touch one triangle: what is nearest, how deep, and which way out. */
#include <axiscert/contact.h>
#include <stdio.h>

int main(void) {
  static const char* const parts[8] = {"vertex A", "vertex B", "vertex C", "edge AB",
                                       "edge BC",  "edge CA",  "face",     "none"};
  const float triangle[9] = {0, 0, 0, 4, 0, 0, 0, 4, 0};
  const float spheres[4][4] = {{1, 1, 0.75f, 1}, {2, -3, 4, 5}, {7, -4, 0, 2}, {1, 2, 0, 1}};
  int contacts = 0;
  for (int i = 0; i < 4; ++i) {
    axiscert_contact_data_f32 at;
    const int contact = axiscert_contact_f32(triangle, spheres[i], AXISCERT_CLOSED_SPHERE, &at) == AXISCERT_CONTACT;
    contacts += contact;
    printf("%s: %s, separation %g, point %g %g %g, normal %g %g %g%s\n", contact ? "contact" : "separated",
           parts[at.feature], at.separation, at.point[0], at.point[1], at.point[2], at.normal[0], at.normal[1],
           at.normal[2], at.has_normal ? "" : " (chosen)");
  }
  return contacts == 3 ? 0 : 1;
}
