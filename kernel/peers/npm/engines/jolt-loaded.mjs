// Jolt with a world of nothing, and shapes of it.
import initialized from 'jolt-physics';

import {unit} from './triangle.mjs';

export async function loadedJolt() {
  const Jolt = await initialized();
  const world = new Jolt.JoltSettings();
  world.mMaxWorkerThreads = 0;
  // Layers of nothing: without a JoltInterface its allocator is not there, and the first shape traps.
  const pairs = new Jolt.ObjectLayerPairFilterTable(1), phases = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  phases.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
  world.mObjectLayerPairFilter = pairs;
  world.mBroadPhaseLayerInterface = phases;
  world.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(phases, 1, pairs, 1);
  new Jolt.JoltInterface(world);

  // The shape that the settings make, with a reference of its own, or null where Jolt refuses it.
  function created(shapeSettings) {
    shapeSettings.AddRef();
    const result = shapeSettings.Create();
    const shape = result.HasError() ? null : result.Get();
    if (shape) shape.AddRef();
    result.Clear();
    shapeSettings.Release();
    return shape;
  }

  // A mesh of these triangles, or null.
  function meshOf(triangles) {
    const list = new Jolt.TriangleList();
    for (const corners of triangles) {
      const points = corners.map((v) => new Jolt.Vec3(v[0], v[1], v[2]));
      const triangle = new Jolt.Triangle(...points, 0);
      list.push_back(triangle);
      Jolt.destroy(triangle);
      points.forEach((point) => Jolt.destroy(point));
    }
    const shape = created(new Jolt.MeshShapeSettings(list));
    Jolt.destroy(list);
    return shape;
  }

  // What CollideShape says of a hit of two shapes: its axis, of any length, is the way to push the second.
  function said({mPenetrationDepth, mPenetrationAxis, mContactPointOn1, mContactPointOn2}) {
    const plain = (v) => [v.GetX(), v.GetY(), v.GetZ()];
    return {separation: -mPenetrationDepth, normal: unit(plain(mPenetrationAxis)), a: plain(mContactPointOn1), b: plain(mContactPointOn2)};
  }

  return {Jolt, created, meshOf, said};
}
