// Havok: HP_World_ShapeProximityWithCollector of a box against a static body, distance 0.
//   box   a box
//   mesh  of the predicate box-triangle: HP_Shape_CreateMesh
import {pair, serve, UNDECIDED, verdictOf} from './frame.mjs';
import {loadedHavok, noTurn, origin} from './havok-loaded.mjs';
import {form} from './triangle.mjs';
import {placedAt, quaternions, single} from './box.mjs';

const isMesh = form({'box': false, 'mesh': true});

async function make() {
  const {hk, made, meshOf, withBody, near} = await loadedHavok();
  const boxOf = (s) => made(hk.HP_Shape_CreateBox(origin, noTurn, [...s].map((x) => 2 * x)));  // it takes whole sizes

  // The answer of `ask` about two shapes; undecided where Havok refuses one of them.
  function withShapes(shapes, ask) {
    const answer = shapes.includes(null) ? UNDECIDED : ask(...shapes);
    for (const used of shapes) if (used !== null) hk.HP_Shape_Release(used);
    return answer;
  }

  const turn = ({x, y, z, w}) => [x, y, z, w];
  // Of what near() has found of a box at `m`, which may be turned.
  function answer(found, m, turned) {
    if (found === null) return verdictOf(false);
    const {separation, normal, point: b, own} = found;
    return pair(verdictOf(true), {separation, normal: normal.map((x) => -x), a: placedAt(own, m, turned), b});
  }
  const boxBox = (a, b) => withShapes([boxOf(a.s), boxOf(b.s)], (first, second) => withBody(
      second, () => answer(near(first, a.m, turn(a.turn)), a.m, a.turn), b.m, turn(b.turn)));
  const boxTriangle = (q) => withShapes([boxOf(q.subarray(3, 6)), meshOf(single(q, 6))], (box, shape) => withBody(
      shape, () => answer(near(box, q.subarray(0, 3)), q.subarray(0, 3))));
  return isMesh ? {'box-triangle/centre': boxTriangle} : quaternions(boxBox);
}

await serve(make);
