// cannon-es.

// A contact equation of the body `first` and another: the separation is what its solver brings to 0, the normal pushes the other, and
// each has a point.
export function said({bi, bj, ri, rj, ni}, first) {
  const at = [bi.position.vadd(ri), bj.position.vadd(rj)], normal = ni.toArray(), points = at.map((v) => v.toArray());
  const isTurned = bi !== first;
  return {separation: at[1].vsub(at[0]).dot(ni), normal: isTurned ? normal.map((x) => -x) : normal,
          a: points[isTurned ? 1 : 0], b: points[isTurned ? 0 : 1]};
}
