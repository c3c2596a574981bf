// cannon-es: Narrowphase.getContacts of a Sphere and a Trimesh, whose vertices are float; it computes in double.
import {Body, Sphere, Trimesh, Vec3, World} from 'cannon-es';

import {deepest, serve, spoken, verdictOf} from './frame.mjs';
import {said} from './cannon-loaded.mjs';
import {centre, mesh, radius} from './triangle.mjs';

const world = new World();
const bodyOf = (shape, place) => new Body({mass: 0, shape, position: new Vec3(...place)});

function sphereTriangle(q) {
  const {positions, indices} = mesh(q, false), contacts = [];
  const sphere = bodyOf(new Sphere(radius(q)), centre(q)), triangle = bodyOf(new Trimesh(positions, indices), [0, 0, 0]);
  world.narrowphase.getContacts([sphere], [triangle], world, contacts, [], [], []);
  const {separation, normal, b} = deepest(contacts.map((one) => said(one, sphere)));
  return spoken(verdictOf(contacts.length > 0), {separation, normal: normal?.map((x) => -x), point: b});
}

await serve(async () => ({'sphere-triangle': sphereTriangle}));
