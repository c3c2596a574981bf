// Havok: HP_World_ShapeProximityWithCollector of a sphere against a static body, distance 0.
//   mesh         HP_Shape_CreateMesh
//   mesh-beside  a second triangle is in the mesh
//   hull         HP_Shape_CreateConvexHull of the three vertices
//   sweep        of the test moving-sphere: HP_World_ShapeCastWithCollector against the mesh. It takes where the centre
//                ends, rounded here.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

import HavokPhysics from '@babylonjs/havok';

import {hit, SEPARATED, serve, UNDECIDED, verdictOf} from './frame.mjs';
import {centre, end, form, mesh, radius} from './triangle.mjs';

const asked = form({'mesh': {}, 'mesh-beside': {two: true}, 'hull': {hull: true}, 'sweep': {sweep: true}});
const wasm = readFileSync(createRequire(import.meta.url).resolve('@babylonjs/havok').replace(/umd[/\\][^/\\]*$/, 'esm/HavokPhysics.wasm'));

async function make() {
  const hk = await HavokPhysics({wasmBinary: wasm});
  const world = hk.HP_World_Create()[1], collector = hk.HP_QueryCollector_Create(1)[1];
  const origin = [0, 0, 0], noTurn = [0, 0, 0, 1], nobody = [0n];
  const room = hk._malloc(6 * 3 * 4), indices = hk._malloc(6 * 4);  // of two triangles

  // The shape, or null where Havok refuses it.
  function shapeOf(q) {
    const made = mesh(q, asked.two);
    if (made === null) return null;
    new Float32Array(hk.HEAPU8.buffer, room, made.positions.length).set(made.positions);
    new Int32Array(hk.HEAPU8.buffer, indices, made.indices.length).set(made.indices);
    const [result, shape] = asked.hull ? hk.HP_Shape_CreateConvexHull(room, 3)
                                       : hk.HP_Shape_CreateMesh(room, made.positions.length / 3, indices, made.triangles.length);
    return result === hk.Result.RESULT_OK ? shape : null;
  }

  // What `ask` says of the sphere, with the triangle in the world; undecided where Havok refuses one of them.
  function withShapes(q, ask) {
    const [result, sphere] = hk.HP_Shape_CreateSphere(origin, radius(q));
    if (result !== hk.Result.RESULT_OK) return UNDECIDED;
    const shape = shapeOf(q);
    if (shape === null) {
      hk.HP_Shape_Release(sphere);
      return UNDECIDED;
    }
    const body = hk.HP_Body_Create()[1];
    hk.HP_Body_SetMotionType(body, hk.MotionType.STATIC);
    hk.HP_Body_SetShape(body, shape);
    hk.HP_Body_SetQTransform(body, [origin, noTurn]);
    hk.HP_World_AddBody(world, body, false);
    const answer = ask(sphere);
    hk.HP_World_RemoveBody(world, body);
    hk.HP_Body_Release(body);
    hk.HP_Shape_Release(shape);
    hk.HP_Shape_Release(sphere);
    return answer;
  }
  const hits = () => hk.HP_QueryCollector_GetNumHits(collector)[1] > 0;

  const sphereTriangle = (q) => withShapes(q, (sphere) => {
    hk.HP_World_ShapeProximityWithCollector(world, collector, [sphere, [...centre(q)], noTurn, 0, false, nobody]);
    return verdictOf(hits());
  });

  const movingSphere = (q) => end(q) === null ? UNDECIDED : withShapes(q, (sphere) => {
    hk.HP_World_ShapeCastWithCollector(world, collector, [sphere, noTurn, [...centre(q)], [...end(q)], false, nobody]);
    if (!hits()) return SEPARATED;
    const [fraction, , on] = hk.HP_QueryCollector_GetShapeCastResult(collector, 0)[1];
    return hit(fraction, on[4], on[3]);
  });

  return asked.sweep ? {'moving-sphere': movingSphere} : {'sphere-triangle': sphereTriangle};
}

await serve(make);
