"""A plug-in of the closest point with all of its numbers, in which a fault can be planted."""
import subprocess

from command import ROOT

# The closest point by the region it is in (C. Ericson, Real-Time Collision Detection, 5.1.5), in double. MARGIN is added to the sphere, and CHANGE is
# what is done to the numbers.
PLUGIN = r"""
#include <axiscert/plugin.h>
#include <math.h>
static double dot(const double *u, const double *v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
static int part(const double *ab, const double *ac, const double *ap, const double *bp, const double *cp, double *v, double *w) {
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  *v = *w = 0;
  if (d1 <= 0 && d2 <= 0) return 0;
  if (d3 >= 0 && d4 <= d3) { *v = 1; return 1; }
  if (vc <= 0 && d1 >= 0 && d3 <= 0) { *v = d1 / (d1 - d3); return 3; }
  if (d6 >= 0 && d5 <= d6) { *w = 1; return 2; }
  if (vb <= 0 && d2 >= 0 && d6 <= 0) { *w = d2 / (d2 - d6); return 5; }
  if (va <= 0 && d4 >= d3 && d5 >= d6) { *w = (d4 - d3) / ((d4 - d3) + (d5 - d6)); *v = 1 - *w; return 4; }
  *v = vb / (va + vb + vc); *w = vc / (va + vb + vc);
  return 6;
}
static int mine(const float *a, const float *b, const float *c, const float *p, float r, float *separation, float *feature, float *normal,
                float *point) {
  double ab[3], ac[3], ap[3], bp[3], cp[3], n[3], v, w, d;
  float added = MARGIN;
  int k, where;
  for (k = 0; k < 3; ++k) {
    ab[k] = (double)b[k] - a[k]; ac[k] = (double)c[k] - a[k];
    ap[k] = (double)p[k] - a[k]; bp[k] = (double)p[k] - b[k]; cp[k] = (double)p[k] - c[k];
  }
  where = part(ab, ac, ap, bp, cp, &v, &w);
  for (k = 0; k < 3; ++k) n[k] = ap[k] - v * ab[k] - w * ac[k];
  d = sqrt(dot(n, n));
  for (k = 0; k < 3; ++k) {
    normal[k] = d > 0 ? (float)(n[k] / d) : 0;
    point[k] = (float)(p[k] - n[k]);
  }
  *feature = (float)where;
  *separation = (float)(d - r - added);
  CHANGE;
  return d <= (double)r + added ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
}
static const axiscert_limits kept = {sizeof(axiscert_limits), 0, 0, 0, 0, 0, PROMISED};
AXISCERT_PLUGIN_OF(float, "mine", mine, TRIANGLE, vertices, all, DECLARED)
"""
UPWARDS = "if (normal[2] < 0) for (k = 0; k < 3; ++k) normal[k] = -normal[k]"


def built(folder, name, change="(void)0", margin="0", promised=None):
    source, made = folder / f"{name}.c", folder / f"{name}.so"
    source.write_text(PLUGIN.replace("CHANGE", change).replace("MARGIN", margin).replace("PROMISED", promised or "0")
                      .replace("DECLARED", "AXISCERT_DECLARE(limits, &kept)" if promised else ""))
    subprocess.run(["cc", "-O1", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", made, "-lm"], check=True)
    return f"plugin:{made}"
