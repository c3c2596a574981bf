// PhysX with a foundation of its own, silent.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

// Its loader refuses node, and takes what shows the globals of a worker.
async function wasm() {
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

export async function loadedPhysX() {
  const Px = await wasm(), top = Px.PxTopLevelFunctions.prototype, query = Px.PxGeometryQuery.prototype;
  const version = top.PHYSICS_VERSION, allocator = new Px.PxDefaultAllocator();
  const errors = new Px.PxErrorCallbackImpl();
  errors.reportError = () => {};
  const foundation = top.CreateFoundation(version, allocator, errors);
  const scale = new Px.PxTolerancesScale();
  top.CreatePhysics(version, foundation, scale);
  const cooking = new Px.PxCookingParams(scale);
  cooking.suppressTriangleMeshRemapTable = true;

  // The mesh of these triangles, or null where cooking refuses it.
  function meshOf(triangles, indices) {
    const points = new Px.PxArray_PxVec3(), numbers = new Px.PxArray_PxU32();
    for (const v of triangles.flat()) {
      const point = new Px.PxVec3(v[0], v[1], v[2]);
      points.pushBack(point);
      Px.destroy(point);
    }
    indices.forEach((i) => numbers.pushBack(i));
    const of = new Px.PxTriangleMeshDesc();
    of.points.count = points.size();
    of.points.stride = 12;
    of.points.data = points.begin();
    of.triangles.count = triangles.length;
    of.triangles.stride = 12;
    of.triangles.data = numbers.begin();
    const cooked = top.CreateTriangleMesh(cooking, of);
    for (const used of [of, numbers, points]) Px.destroy(used);
    return Px.getPointer(cooked) ? cooked : null;
  }

  return {Px, query, cooking, meshOf};
}
