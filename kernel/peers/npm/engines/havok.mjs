// Havok: HP_World_ShapeProximityWithCollector of a sphere against a static body, distance 0.
//   mesh         HP_Shape_CreateMesh
//   mesh-beside  a second triangle is in the mesh
//   hull         HP_Shape_CreateConvexHull of the three vertices
//   sweep        of the predicate moving-sphere: HP_World_ShapeCastWithCollector against the mesh. It takes where the centre
//                ends, rounded here.
import {hit, SEPARATED, serve, spoken, UNDECIDED, verdictOf} from './frame.mjs';
import {loadedHavok, nobody, noTurn, origin} from './havok-loaded.mjs';
import {centre, end, form, mesh, radius} from './triangle.mjs';

const asked = form({'mesh': {}, 'mesh-beside': {two: true}, 'hull': {hull: true}, 'sweep': {sweep: true}});

async function make() {
  const {hk, world, collector, made, meshOf, withBody, hits, near} = await loadedHavok();

  // The answer of `ask` about the sphere, with the triangle in the world; undecided where Havok refuses one of them.
  function withShapes(q, ask) {
    const sphere = made(hk.HP_Shape_CreateSphere(origin, radius(q)));
    if (sphere === null) return UNDECIDED;
    const given = mesh(q, asked.two), shape = given && meshOf(given, asked.hull);
    const answer = shape === null ? UNDECIDED : withBody(shape, () => ask(sphere));
    for (const used of [shape, sphere]) if (used !== null) hk.HP_Shape_Release(used);
    return answer;
  }

  const sphereTriangle = (q) => withShapes(q, (sphere) => {
    const found = near(sphere, centre(q));
    return spoken(verdictOf(found !== null), found ?? {});
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
