// Jolt.
//   oriented-box  OrientedBox.OverlapsOrientedBox, its epsilon of 1e-6 as by default; takes matrices
//   box           TransformedShape.CollideShape of two BoxShapes, convex radius 0.05 as by default: it rounds their edges
//   box-sharp     the same with convex radius 0
//   mesh          of the predicate box-triangle: CollideShape of a BoxShape of convex radius 0 with a MeshShape of one
//                 triangle, back faces collide
import {CONTACT, pair, SEPARATED, serve, UNDECIDED, verdictOf} from './frame.mjs';
import {loadedJolt} from './jolt-loaded.mjs';
import {form} from './triangle.mjs';
import {matrices, quaternions, single} from './box.mjs';

const asked = form({
  'oriented-box': {isOriented: true},
  'box': {},
  'box-sharp': {radius: 0},
  'mesh': {radius: 0, isMesh: true},
});

async function make() {
  const {Jolt, created, meshOf, said} = await loadedJolt();
  const settings = new Jolt.CollideShapeSettings();
  settings.mMaxSeparationDistance = 0;
  settings.mBackFaceMode = Jolt.EBackFaceMode_CollideWithBackFaces;
  const one = new Jolt.Vec3(1, 1, 1), origin = new Jolt.RVec3(0, 0, 0), filter = new Jolt.ShapeFilter();
  const noTurn = new Jolt.Quat(0, 0, 0, 1);
  const vector = (v) => new Jolt.Vec3(v[0], v[1], v[2]), quat = ({x, y, z, w}) => new Jolt.Quat(x, y, z, w);

  function orientedOf({m, s, axes}) {
    const place = new Jolt.Mat44(), columns = [...axes, m].map(vector), half = vector(s);
    columns.forEach((column, k) => place.SetColumn3(k, column));  // its fourth row is then 0 0 0 1
    const box = new Jolt.OrientedBox(place, half);
    for (const used of [half, ...columns, place]) Jolt.destroy(used);
    return box;
  }
  function overlaps(a, b) {
    const [first, second] = [a, b].map(orientedOf), verdict = verdictOf(first.OverlapsOrientedBox(second));
    for (const used of [first, second]) Jolt.destroy(used);
    return verdict;
  }

  function boxOf(s) {
    const half = vector(s);
    const shape = created(asked.radius === undefined ? new Jolt.BoxShapeSettings(half) : new Jolt.BoxShapeSettings(half, asked.radius));
    Jolt.destroy(half);
    return shape;
  }

  // What is said of a box at a place and the shape at another; undecided where Jolt refuses one of them. Both are released.
  function collide(box, [m, turn], shape, [at, turned]) {
    let answer = UNDECIDED;
    if (box && shape) {
      const transformed = new Jolt.TransformedShape(), where = new Jolt.RVec3(at[0], at[1], at[2]), centre = new Jolt.RVec3(m[0], m[1], m[2]);
      transformed.mShape = shape;
      transformed.SetWorldTransform(where, turned, one);
      const place = Jolt.RMat44.prototype.sRotationTranslation(turn, centre), collector = new Jolt.CollideShapeClosestHitCollisionCollector();
      transformed.CollideShape(box, one, place, settings, origin, collector, filter);
      answer = collector.HadHit() ? pair(CONTACT, said(collector.mHit)) : SEPARATED;
      for (const used of [collector, centre, where, transformed]) Jolt.destroy(used);
    }
    for (const used of [box, shape]) if (used) used.Release();
    return answer;
  }
  function boxBox(a, b) {
    const turns = [a, b].map(({turn}) => quat(turn));
    const verdict = collide(boxOf(a.s), [a.m, turns[0]], boxOf(b.s), [b.m, turns[1]]);
    turns.forEach((turn) => Jolt.destroy(turn));
    return verdict;
  }
  const boxTriangle = (q) => collide(boxOf(q.subarray(3)), [q, noTurn], meshOf(single(q, 6).triangles), [[0, 0, 0], noTurn]);

  if (asked.isMesh) return {'box-triangle/centre': boxTriangle};
  return asked.isOriented ? matrices(overlaps) : quaternions(boxBox);
}

await serve(make);
