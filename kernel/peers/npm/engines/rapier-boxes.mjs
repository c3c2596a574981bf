// Rapier, that is parry: a Cuboid with a Cuboid, a Triangle or a TriMesh.
//   cuboid          intersectsShape
//   cuboid-contact  contactShape with prediction 0, a contact whose distance is at most 0
//   triangle        of the predicate box-triangle: Cuboid.intersectsShape(Triangle)
//   trimesh         of the predicate box-triangle: the same, a TriMesh
import RAPIER from '@dimforge/rapier3d-compat';

import {pair, SEPARATED, serve, verdictOf} from './frame.mjs';
import {form} from './triangle.mjs';
import {corners, quaternions, single} from './box.mjs';

const vector = (v) => ({x: v[0], y: v[1], z: v[2]});
const origin = vector([0, 0, 0]), noTurn = {x: 0, y: 0, z: 0, w: 1};
const cuboid = (s) => new RAPIER.Cuboid(s[0], s[1], s[2]);

const places = (a, b) => [vector(a.m), a.turn, cuboid(b.s), vector(b.m), b.turn];
const boxTriangle = (shapeOf) => ({
  'box-triangle/centre': (q) => verdictOf(cuboid(q.subarray(3)).intersectsShape(vector(q), noTurn, shapeOf(q), origin, noTurn)),
});

const answers = form({
  'cuboid': quaternions((a, b) => verdictOf(cuboid(a.s).intersectsShape(...places(a, b)))),
  'cuboid-contact': quaternions((a, b) => {
    const contact = cuboid(a.s).contactShape(...places(a, b), 0);
    if (contact === null) return SEPARATED;
    const {distance, normal1: n, point1, point2} = contact, plain = ({x, y, z}) => [x, y, z];
    return pair(verdictOf(distance <= 0), {separation: distance, normal: plain(n), a: plain(point1), b: plain(point2)});
  }),
  'triangle': boxTriangle((q) => new RAPIER.Triangle(...corners(q, 6).map(vector))),
  'trimesh': boxTriangle((q) => {
    const {positions, indices} = single(q, 6);
    return new RAPIER.TriMesh(positions, indices);
  }),
});

await serve(async () => {
  await RAPIER.init();
  return answers;
});
