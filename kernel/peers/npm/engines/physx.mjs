// PhysX: PxGeometryQuery of a sphere and a triangle mesh. Meshes are two-sided in overlaps, whatever their flags.
//   mesh            overlap; cooked as by default, which cleans the mesh
//   mesh-uncleaned  overlap; cooked with eDISABLE_CLEAN_MESH
//   mesh-beside     overlap; as by default, a second triangle is in the mesh
//   point-distance  pointDistance from the centre, a squared distance, against r r
//   sweep           of the test moving-sphere: sweep with eMESH_BOTH_SIDES. It takes a direction of length 1 and a
//                   distance, both rounded here, and has none for a displacement of length 0, which is undecided. The
//                   time is its distance over ours.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

import {hit, SEPARATED, serve, UNDECIDED, verdictOf, verdictWithin} from './frame.mjs';
import {centre, form, mesh, motion, radius} from './triangle.mjs';

const asked = form({
  'mesh': {},
  'mesh-uncleaned': {uncleaned: true},
  'mesh-beside': {two: true},
  'point-distance': {distance: true},
  'sweep': {sweep: true},
});

// Its loader refuses node, and takes what shows the globals of a worker.
async function loaded() {
  const file = createRequire(import.meta.url).resolve('physx-js-webidl');
  const {default: PhysX} = await import('physx-js-webidl');
  const kept = globalThis.process;
  globalThis.process = undefined;
  globalThis.WorkerGlobalScope = class {};
  try {
    return await PhysX({wasmBinary: readFileSync(file.replace(/[^/\\]*$/, 'physx-js-webidl.wasm'))});
  } finally {
    globalThis.process = kept;
    delete globalThis.WorkerGlobalScope;
  }
}

async function make() {
  const Px = await loaded(), top = Px.PxTopLevelFunctions.prototype, query = Px.PxGeometryQuery.prototype;
  const version = top.PHYSICS_VERSION, allocator = new Px.PxDefaultAllocator();
  const errors = new Px.PxErrorCallbackImpl();
  errors.reportError = () => {};
  const foundation = top.CreateFoundation(version, allocator, errors);
  const scale = new Px.PxTolerancesScale();
  top.CreatePhysics(version, foundation, scale);
  const cooking = new Px.PxCookingParams(scale);
  cooking.suppressTriangleMeshRemapTable = true;
  if (asked.uncleaned) cooking.meshPreprocessParams.raise(Px.PxMeshPreprocessingFlagEnum.eDISABLE_CLEAN_MESH);

  const place = new Px.PxTransform(Px.PxIDENTITYEnum.PxIdentity), origin = new Px.PxTransform(Px.PxIDENTITYEnum.PxIdentity);
  const unscaled = new Px.PxMeshScale(1), flags = new Px.PxMeshGeometryFlags(0);

  // The mesh, or null where cooking refuses it.
  function meshOf(q) {
    const made = mesh(q, asked.two);
    if (made === null) return null;
    const points = new Px.PxArray_PxVec3(), indices = new Px.PxArray_PxU32();
    for (const v of made.triangles.flat()) {
      const point = new Px.PxVec3(v[0], v[1], v[2]);
      points.pushBack(point);
      Px.destroy(point);
    }
    made.indices.forEach((i) => indices.pushBack(i));
    const of = new Px.PxTriangleMeshDesc();
    of.points.count = points.size();
    of.points.stride = 12;
    of.points.data = points.begin();
    of.triangles.count = made.triangles.length;
    of.triangles.stride = 12;
    of.triangles.data = indices.begin();
    const cooked = top.CreateTriangleMesh(cooking, of);
    for (const used of [of, indices, points]) Px.destroy(used);
    return Px.getPointer(cooked) ? cooked : null;
  }

  function sphereTriangle(q) {
    const cooked = meshOf(q);
    if (cooked === null) return UNDECIDED;
    const shape = new Px.PxTriangleMeshGeometry(cooked, unscaled, flags), r = radius(q), p = centre(q);
    const sphere = new Px.PxSphereGeometry(r), point = new Px.PxVec3(p[0], p[1], p[2]);
    place.p = point;
    let verdict = UNDECIDED;
    if (asked.distance) {
      const squared = query.pointDistance(point, shape, origin);
      if (squared >= 0) verdict = verdictWithin(squared, Math.fround(r * r));  // -1: it gives none
    } else if (query.isValid(sphere)) {
      verdict = verdictOf(query.overlap(sphere, place, shape, origin));
    }
    for (const used of [sphere, point, shape]) Px.destroy(used);
    cooked.release();
    return verdict;
  }

  function movingSphere(q) {
    const cooked = meshOf(q), p = centre(q), d = motion(q), length = Math.hypot(...d);
    if (cooked === null || length === 0) return UNDECIDED;
    const shape = new Px.PxTriangleMeshGeometry(cooked, unscaled, flags), sphere = new Px.PxSphereGeometry(radius(q));
    const point = new Px.PxVec3(p[0], p[1], p[2]), direction = new Px.PxVec3(d[0] / length, d[1] / length, d[2] / length);
    const found = new Px.PxSweepHit(), hitFlags = new Px.PxHitFlags(Px.PxHitFlagEnum.eDEFAULT | Px.PxHitFlagEnum.eMESH_BOTH_SIDES);
    place.p = point;
    let answer = UNDECIDED;
    if (query.isValid(sphere)) {
      answer = SEPARATED;
      if (query.sweep(direction, length, sphere, place, shape, origin, found, hitFlags)) {
        const {normal: n, position: at} = found, has = found.flags.isSet(Px.PxHitFlagEnum.ePOSITION);
        answer = hit(found.distance / length, [n.x, n.y, n.z], has ? [at.x, at.y, at.z] : undefined);
      }
    }
    for (const used of [hitFlags, found, direction, point, sphere, shape]) Px.destroy(used);
    cooked.release();
    return answer;
  }

  return asked.sweep ? {'moving-sphere': movingSphere} : {'sphere-triangle': sphereTriangle};
}

await serve(make);
