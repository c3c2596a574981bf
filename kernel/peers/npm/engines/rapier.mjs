// Rapier, that is parry: a Ball with a Triangle or a TriMesh.
//   triangle        Ball.intersectsShape
//   contact         Ball.contactShape with prediction 0
//   trimesh         Ball.intersectsShape, a TriMesh
//   trimesh-beside  the same, a second triangle is in the mesh
//   sweep           of the predicate moving-sphere: Ball.castShape with a Triangle, its velocity d, from time 0 to 1
import RAPIER from '@dimforge/rapier3d-compat';

import {CONTACT, hit, SEPARATED, serve, spoken, UNDECIDED, verdictOf} from './frame.mjs';
import {centre, form, mesh, motion, radius, vertices} from './triangle.mjs';

const asked = form({
  'triangle': {},
  'contact': {contact: true},
  'trimesh': {mesh: true},
  'trimesh-beside': {mesh: true, two: true},
  'sweep': {sweep: true},
});

const vector = (v) => ({x: v[0], y: v[1], z: v[2]});
const origin = vector([0, 0, 0]), noTurn = {x: 0, y: 0, z: 0, w: 1};

async function make() {
  await RAPIER.init();

  function shapeOf(q) {
    if (!asked.mesh) return new RAPIER.Triangle(...vertices(q).map(vector));
    const made = mesh(q, asked.two);
    return made && new RAPIER.TriMesh(made.positions, made.indices);
  }

  function sphereTriangle(q) {
    const ball = new RAPIER.Ball(radius(q)), shape = shapeOf(q), place = vector(centre(q));
    if (shape === null) return UNDECIDED;
    if (!asked.contact) return verdictOf(ball.intersectsShape(place, noTurn, shape, origin, noTurn));
    const contact = ball.contactShape(place, noTurn, shape, origin, noTurn, 0);
    if (contact === null) return SEPARATED;
    const {distance, normal2: n, point2: on} = contact;  // of the triangle
    return spoken(CONTACT, {separation: distance, normal: [n.x, n.y, n.z], point: [on.x, on.y, on.z]});
  }

  function movingSphere(q) {
    const shape = shapeOf(q), velocity = vector(motion(q));
    const found = new RAPIER.Ball(radius(q)).castShape(vector(centre(q)), noTurn, velocity, shape, origin, noTurn, origin, 0, 1, true);
    if (found === null) return SEPARATED;
    const {normal2: n, witness2: on} = found;  // of the triangle, which stands at the origin
    return hit(found.time_of_impact, [n.x, n.y, n.z], [on.x, on.y, on.z]);
  }

  return asked.sweep ? {'moving-sphere': movingSphere} : {'sphere-triangle': sphereTriangle};
}

await serve(make);
