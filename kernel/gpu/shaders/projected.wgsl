// The fifteen axes of two boxes as products of their own vectors, all six terms: right for every pair over the reals.
// kernel/boxes/projected.h.
fn half_extent(along: vec3f, h: vec3f, axes: mat3x3f) -> f32 {
  return dot(h, abs(along * axes));
}

fn facet_normal(axes: mat3x3f, k: u32) -> vec3f {
  return cross(axes[(k + 1u) % 3u], axes[(k + 2u) % 3u]);
}

// The boxes are ca, ha, ma and cb, hb, mb: centre, half extents, and the axes as columns.
fn separated(ca: vec3f, ha: vec3f, ma: mat3x3f, cb: vec3f, hb: vec3f, mb: mat3x3f) -> u32 {
  let between = cb - ca;
  for (var i = 0u; i < 15u; i++) {
    var along = facet_normal(ma, i);
    if (i >= 6u) {
      along = cross(ma[(i - 6u) / 3u], mb[(i - 6u) % 3u]);
    } else if (i >= 3u) {
      along = facet_normal(mb, i - 3u);
    }
    if (abs(dot(along, between)) > half_extent(along, ha, ma) + half_extent(along, hb, mb)) { return 1u; }
  }
  return 0u;
}
