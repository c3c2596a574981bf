// Havok with an empty world and a collector of one hit, and what stands in the world while a question is asked.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

import HavokPhysics from '@babylonjs/havok';

const wasm = readFileSync(createRequire(import.meta.url).resolve('@babylonjs/havok').replace(/umd[/\\][^/\\]*$/, 'esm/HavokPhysics.wasm'));

export const origin = [0, 0, 0], noTurn = [0, 0, 0, 1], nobody = [0n];

export async function loadedHavok() {
  const hk = await HavokPhysics({wasmBinary: wasm});
  const world = hk.HP_World_Create()[1], collector = hk.HP_QueryCollector_Create(1)[1];
  const room = hk._malloc(6 * 3 * 4), indices = hk._malloc(6 * 4);  // of two triangles

  // The shape of what a call returns, or null where Havok refuses it.
  const made = ([result, shape]) => result === hk.Result.RESULT_OK ? shape : null;

  // The mesh, or the hull of its points, or null; made: what mesh() of triangle.mjs makes.
  function meshOf({positions, indices: numbers, triangles}, isHull = false) {
    new Float32Array(hk.HEAPU8.buffer, room, positions.length).set(positions);
    new Int32Array(hk.HEAPU8.buffer, indices, numbers.length).set(numbers);
    return made(isHull ? hk.HP_Shape_CreateConvexHull(room, 3) : hk.HP_Shape_CreateMesh(room, positions.length / 3, indices, triangles.length));
  }

  // The answer of `ask` with a static body of that shape in the world; it stands at `place`, turned by `turn` (x y z w).
  function withBody(shape, ask, place = origin, turn = noTurn) {
    const body = hk.HP_Body_Create()[1];
    hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
    hk.HP_Body_SetShape(body, shape);
    hk.HP_Body_SetQTransform(body, [place, turn]);
    hk.HP_World_AddBody(world, body, false);
    const answer = ask();
    hk.HP_World_RemoveBody(world, body);
    hk.HP_Body_Release(body);
    return answer;
  }

  const hits = () => hk.HP_QueryCollector_GetNumHits(collector)[1] > 0;
  // What is said of a shape, at `place` and turned by `turn`, and something in the world at distance 0 from it; or null. The normal pushes
  // the shape, `point` is that of what is in the world, and `own` the shape's, without its place and turn.
  function near(shape, place, turn = noTurn) {
    hk.HP_World_ShapeProximityWithCollector(world, collector, [shape, [...place], turn, 0, false, nobody]);
    if (!hits()) return null;
    const [separation, ofShape, found] = hk.HP_QueryCollector_GetShapeProximityResult(collector, 0)[1];
    return {separation, normal: found[4], point: found[3], own: ofShape[3]};
  }

  return {hk, world, collector, made, meshOf, withBody, hits, near};
}
