// PhysX: PxGeometryQuery.overlap.
//   box   two boxes
//   mesh  of the predicate box-triangle: a box and a triangle mesh, cooked as by default, which cleans it
import {serve, UNDECIDED, verdictOf} from './frame.mjs';
import {loadedPhysX} from './physx-loaded.mjs';
import {form} from './triangle.mjs';
import {quaternions, single} from './box.mjs';

const isMesh = form({'box': false, 'mesh': true});

async function make() {
  const {Px, query, meshOf} = await loadedPhysX();
  const places = [0, 1].map(() => new Px.PxTransform(Px.PxIDENTITYEnum.PxIdentity)), origin = new Px.PxTransform(Px.PxIDENTITYEnum.PxIdentity);
  const unscaled = new Px.PxMeshScale(1), flags = new Px.PxMeshGeometryFlags(0);
  const boxOf = (s) => new Px.PxBoxGeometry(s[0], s[1], s[2]);

  // Sets a place to the centre and, where it is given, the turn.
  function put(place, m, turn) {
    const point = new Px.PxVec3(m[0], m[1], m[2]), quaternion = turn && new Px.PxQuat(turn.x, turn.y, turn.z, turn.w);
    place.p = point;
    if (quaternion) place.q = quaternion;
    for (const used of [point, quaternion]) if (used) Px.destroy(used);
  }

  function boxBox(a, b) {
    const boxes = [boxOf(a.s), boxOf(b.s)];
    [a, b].forEach(({m, turn}, i) => put(places[i], m, turn));
    const verdict = boxes.every((box) => query.isValid(box)) ? verdictOf(query.overlap(boxes[0], places[0], boxes[1], places[1])) : UNDECIDED;
    boxes.forEach((box) => Px.destroy(box));
    return verdict;
  }

  function boxTriangle(q) {
    const {triangles, indices} = single(q, 6), cooked = meshOf(triangles, indices);
    if (cooked === null) return UNDECIDED;
    const box = boxOf(q.subarray(3)), shape = new Px.PxTriangleMeshGeometry(cooked, unscaled, flags);
    put(places[0], q);
    const verdict = query.isValid(box) ? verdictOf(query.overlap(box, places[0], shape, origin)) : UNDECIDED;
    for (const used of [box, shape]) Px.destroy(used);
    cooked.release();
    return verdict;
  }

  return isMesh ? {'box-triangle/centre': boxTriangle} : quaternions(boxBox);
}

await serve(make);
