// Bullet as ammo.js: contactPairTest of a sphere and a triangle, a contact whose distance is at most 0.
//   mesh         btBvhTriangleMeshShape
//   mesh-beside  a second triangle is in the mesh
//   hull         btConvexHullShape of the three vertices, its margin 0
//   hull-margin  the same with its margin of 0.04, as it is made
//   sweep        of the predicate moving-sphere: convexSweepTest against the mesh. It takes where the centre ends, rounded
//                here.
import {createRequire} from 'node:module';

import {deepest, hit, SEPARATED, serve, spoken, UNDECIDED, verdictOf} from './frame.mjs';
import {centre, end, form, mesh, radius, vertices} from './triangle.mjs';

const asked = form({
  'mesh': {},
  'mesh-beside': {two: true},
  'hull': {hull: true, margin: 0},
  'hull-margin': {hull: true},
  'sweep': {sweep: true},
});

async function make() {
  const Ammo = await createRequire(import.meta.url)('ammojs-typed/wasm')();
  const configuration = new Ammo.btDefaultCollisionConfiguration(), dispatcher = new Ammo.btCollisionDispatcher(configuration);
  const world = new Ammo.btDiscreteDynamicsWorld(dispatcher, new Ammo.btDbvtBroadphase(),
                                                 new Ammo.btSequentialImpulseConstraintSolver(), configuration);
  const place = new Ammo.btTransform(), arrival = new Ammo.btTransform(), point = new Ammo.btVector3(0, 0, 0), corners = [0, 1, 2].map(() => new Ammo.btVector3(0, 0, 0));
  const object = new Ammo.btPairCachingGhostObject(), ball = new Ammo.btPairCachingGhostObject();
  let contacts = [];
  const heard = new Ammo.ConcreteContactResultCallback();
  heard.addSingleResult = (contact) => {
    const one = Ammo.wrapPointer(contact, Ammo.btManifoldPoint), n = one.get_m_normalWorldOnB(), on = one.getPositionWorldOnB();
    contacts.push({separation: one.getDistance(), normal: plain(n), point: plain(on)});  // B is the triangle
    return 0;
  };

  const plain = (v) => [v.x(), v.y(), v.z()];
  const moved = (vector, v) => (vector.setValue(v[0], v[1], v[2]), vector);

  // The parts of the shape, the shape last; null where there is no room for a second triangle.
  function shapesOf(q) {
    if (asked.hull) {
      const hull = new Ammo.btConvexHullShape();
      for (const v of vertices(q)) hull.addPoint(moved(point, v), true);
      if (asked.margin !== undefined) hull.setMargin(asked.margin);
      return [hull];
    }
    const made = mesh(q, asked.two);
    if (made === null) return null;
    const triangles = new Ammo.btTriangleMesh(true, false);
    for (const three of made.triangles) triangles.addTriangle(...three.map((v, i) => moved(corners[i], v)), false);
    return [triangles, new Ammo.btBvhTriangleMeshShape(triangles, true, true)];
  }

  function sphereTriangle(q) {
    const shapes = shapesOf(q);
    if (shapes === null) return UNDECIDED;
    const sphere = new Ammo.btSphereShape(radius(q));
    place.setIdentity();
    object.setWorldTransform(place);
    object.setCollisionShape(shapes.at(-1));
    place.setOrigin(moved(point, centre(q)));
    ball.setWorldTransform(place);
    ball.setCollisionShape(sphere);
    contacts = [];
    world.contactPairTest(ball, object, heard);
    for (const used of [sphere, ...shapes.reverse()]) Ammo.destroy(used);
    return spoken(verdictOf(contacts.some((one) => one.separation <= 0)), deepest(contacts));
  }

  function movingSphere(q) {
    const to = end(q);
    if (to === null) return UNDECIDED;
    const shapes = shapesOf(q), sphere = new Ammo.btSphereShape(radius(q));
    place.setIdentity();
    object.setWorldTransform(place);
    object.setCollisionShape(shapes.at(-1));
    world.addCollisionObject(object, 1, -1);
    place.setOrigin(moved(corners[0], centre(q)));
    arrival.setIdentity();
    arrival.setOrigin(moved(corners[1], to));
    const found = new Ammo.ClosestConvexResultCallback(corners[0], corners[1]);
    world.convexSweepTest(sphere, place, arrival, found, 0);
    let answer = SEPARATED;
    if (found.hasHit()) {
      const n = found.get_m_hitNormalWorld(), on = found.get_m_hitPointWorld();
      answer = hit(found.get_m_closestHitFraction(), plain(n), plain(on));
    }
    world.removeCollisionObject(object);
    for (const used of [found, sphere, ...shapes.reverse()]) Ammo.destroy(used);
    return answer;
  }

  return asked.sweep ? {'moving-sphere': movingSphere} : {'sphere-triangle': sphereTriangle};
}

await serve(make);
