// Rapier, that is parry: a Ball with a Triangle or a TriMesh.
//   triangle        Ball.intersectsShape
//   contact         Ball.contactShape with prediction 0
//   trimesh         Ball.intersectsShape, a TriMesh
//   trimesh-beside  the same, a second triangle is in the mesh
import RAPIER from '@dimforge/rapier3d-compat';

import {CONTACT, SEPARATED, serve, UNDECIDED, verdictOf} from './frame.mjs';
import {centre, form, mesh, radius, vertices} from './triangle.mjs';

const asked = form({'triangle': {}, 'contact': {contact: true}, 'trimesh': {mesh: true}, 'trimesh-beside': {mesh: true, two: true}});

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
    return contact === null ? SEPARATED : CONTACT;
  }

  return {'sphere-triangle': sphereTriangle};
}

await serve(make);
