// PhysX: PxGeometryQuery of a sphere and a triangle mesh. Meshes are two-sided in overlaps, whatever their flags.
//   mesh            overlap; cooked as by default, which cleans the mesh
//   mesh-uncleaned  overlap; cooked with eDISABLE_CLEAN_MESH
//   mesh-beside     overlap; as by default, a second triangle is in the mesh
//   point-distance  pointDistance from the centre, a squared distance, against r r
//   sweep           of the predicate moving-sphere: sweep with eMESH_BOTH_SIDES. It takes a direction of length 1 and a
//                   distance, both rounded here, and has none for a displacement of length 0, which is undecided. The
//                   time is its distance over ours.
import {hit, SEPARATED, serve, spoken, UNDECIDED, verdictOf, verdictWithin} from './frame.mjs';
import {loadedPhysX} from './physx-loaded.mjs';
import {centre, form, mesh, motion, ofNearest, radius} from './triangle.mjs';

const asked = form({
  'mesh': {},
  'mesh-uncleaned': {uncleaned: true},
  'mesh-beside': {two: true},
  'point-distance': {distance: true},
  'sweep': {sweep: true},
});

async function make() {
  const {Px, query, cooking, meshOf: cooked} = await loadedPhysX();
  if (asked.uncleaned) cooking.meshPreprocessParams.raise(Px.PxMeshPreprocessingFlagEnum.eDISABLE_CLEAN_MESH);

  const place = new Px.PxTransform(Px.PxIDENTITYEnum.PxIdentity), origin = new Px.PxTransform(Px.PxIDENTITYEnum.PxIdentity);
  const nearest = new Px.PxVec3(0, 0, 0), unscaled = new Px.PxMeshScale(1), flags = new Px.PxMeshGeometryFlags(0);

  // The mesh, or null where cooking refuses it or it has no room.
  function meshOf(q) {
    const made = mesh(q, asked.two);
    return made && cooked(made.triangles, made.indices);
  }

  function sphereTriangle(q) {
    const shaped = meshOf(q);
    if (shaped === null) return UNDECIDED;
    const shape = new Px.PxTriangleMeshGeometry(shaped, unscaled, flags), r = radius(q), p = centre(q);
    const sphere = new Px.PxSphereGeometry(r), point = new Px.PxVec3(p[0], p[1], p[2]);
    place.p = point;
    let answer = UNDECIDED;
    if (asked.distance) {
      const squared = query.pointDistance(point, shape, origin, nearest), {x, y, z} = nearest;
      if (squared >= 0)  // -1: it gives none
        answer = spoken(verdictWithin(squared, Math.fround(r * r)), ofNearest(q, [x, y, z], Math.sqrt(squared)));
    } else if (query.isValid(sphere)) {
      answer = verdictOf(query.overlap(sphere, place, shape, origin));
    }
    for (const used of [sphere, point, shape]) Px.destroy(used);
    shaped.release();
    return answer;
  }

  function movingSphere(q) {
    const shaped = meshOf(q), p = centre(q), d = motion(q), length = Math.hypot(...d);
    if (shaped === null || length === 0) return UNDECIDED;
    const shape = new Px.PxTriangleMeshGeometry(shaped, unscaled, flags), sphere = new Px.PxSphereGeometry(radius(q));
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
    shaped.release();
    return answer;
  }

  return asked.sweep ? {'moving-sphere': movingSphere} : {'sphere-triangle': sphereTriangle};
}

await serve(make);
