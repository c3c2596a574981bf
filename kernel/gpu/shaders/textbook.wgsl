// The textbook's separating axes of two boxes, in A's frame: kernel/boxes/relative.h.

// The boxes are ca, ha, ma and cb, hb, mb: centre, half extents, and the axes as columns.
fn separated(ca: vec3f, ha: vec3f, ma: mat3x3f, cb: vec3f, hb: vec3f, mb: mat3x3f) -> u32 {
  let t = (cb - ca) * ma;               // A' T
  let R = transpose(ma) * mb;           // A' B: R[j] is b_j in A's frame
  let S = mat3x3f(abs(R[0]), abs(R[1]), abs(R[2]));
  for (var i = 0u; i < 3u; i++) {
    if (abs(t[i]) > ha[i] + (hb.x * S[0][i] + hb.y * S[1][i] + hb.z * S[2][i])) { return 1u; }
    if (abs(dot(t, R[i])) > hb[i] + dot(ha, S[i])) { return 1u; }
  }
  for (var i = 0u; i < 3u; i++) {
    let i1 = (i + 1u) % 3u;
    let i2 = (i + 2u) % 3u;
    for (var j = 0u; j < 3u; j++) {
      let j1 = (j + 1u) % 3u;
      let j2 = (j + 2u) % 3u;
      let apart = abs(t[i2] * R[j][i1] - t[i1] * R[j][i2]);
      if (apart > (ha[i1] * S[j][i2] + ha[i2] * S[j][i1]) + (hb[j1] * S[j2][i] + hb[j2] * S[j1][i])) { return 1u; }
    }
  }
  return 0u;
}
