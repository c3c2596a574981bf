// Jolt: TransformedShape.CollideShape of a SphereShape with a MeshShape or a ConvexHullShape, separation distance 0.
//   mesh             back faces collide; by default they do not
//   mesh-one-sided   as by default
//   mesh-beside      back faces collide; a second triangle is in the mesh
//   hull             a convex hull of the three vertices, with the default convex radius
//   sweep            of the predicate moving-sphere: TransformedShape.CastShape with the mesh, back faces too
//   sweep-one-sided  the same, back faces ignored, as by default
import {CONTACT, hit, SEPARATED, serve, spoken, UNDECIDED} from './frame.mjs';
import {loadedJolt} from './jolt-loaded.mjs';
import {centre, form, mesh, motion, radius, unit, vertices} from './triangle.mjs';

const asked = form({
  'mesh': {backFaces: true},
  'mesh-one-sided': {backFaces: false},
  'mesh-beside': {backFaces: true, two: true},
  'hull': {backFaces: true, hull: true},
  'sweep': {backFaces: true, sweep: true},
  'sweep-one-sided': {backFaces: false, sweep: true},
});

async function make() {
  const {Jolt, created, meshOf, said} = await loadedJolt();
  const settings = new Jolt.CollideShapeSettings();
  settings.mMaxSeparationDistance = 0;
  const casting = new Jolt.ShapeCastSettings();
  settings.mBackFaceMode = casting.mBackFaceModeTriangles = casting.mBackFaceModeConvex =
      asked.backFaces ? Jolt.EBackFaceMode_CollideWithBackFaces : Jolt.EBackFaceMode_IgnoreBackFaces;
  const one = new Jolt.Vec3(1, 1, 1), zero = new Jolt.Vec3(0, 0, 0), noTurn = new Jolt.Quat(0, 0, 0, 1);
  const origin = new Jolt.RVec3(0, 0, 0), filter = new Jolt.ShapeFilter();

  function hullOf(q) {
    const of = new Jolt.ConvexHullShapeSettings();
    for (const v of vertices(q)) {
      const point = new Jolt.Vec3(v[0], v[1], v[2]);
      of.mPoints.push_back(point);
      Jolt.destroy(point);
    }
    return created(of);
  }

  function shapeOf(q) {
    if (asked.hull) return hullOf(q);
    const made = mesh(q, asked.two);
    return made && meshOf(made.triangles);
  }

  // The answer of `ask` about the triangle's shape and the sphere; undecided where Jolt refuses one of them.
  function withShapes(q, ask) {
    const sphere = created(new Jolt.SphereShapeSettings(radius(q)));
    const shape = sphere && shapeOf(q);
    let verdict = UNDECIDED;
    if (shape) {
      const transformed = new Jolt.TransformedShape();
      transformed.mShape = shape;
      transformed.SetWorldTransform(origin, noTurn, one);
      const p = centre(q), at = new Jolt.RVec3(p[0], p[1], p[2]);
      verdict = ask(transformed, sphere, Jolt.RMat44.prototype.sTranslation(at));
      for (const made of [at, transformed]) Jolt.destroy(made);
      shape.Release();
    }
    if (sphere) sphere.Release();
    return verdict;
  }

  const sphereTriangle = (q) => withShapes(q, (transformed, sphere, place) => {
    const collector = new Jolt.CollideShapeClosestHitCollisionCollector();
    transformed.CollideShape(sphere, one, place, settings, origin, collector, filter);
    let answer = SEPARATED;
    if (collector.HadHit()) {
      const {separation, normal, b} = said(collector.mHit);
      answer = spoken(CONTACT, {separation, normal: normal.map((x) => -x), point: b});
    }
    Jolt.destroy(collector);
    return answer;
  });

  const movingSphere = (q) => withShapes(q, (transformed, sphere, place) => {
    const d = motion(q), direction = new Jolt.Vec3(d[0], d[1], d[2]);
    const cast = new Jolt.RShapeCast(sphere, one, place, direction), collector = new Jolt.CastShapeClosestHitCollisionCollector();
    transformed.CastShape(cast, casting, origin, collector, filter);
    let answer = SEPARATED;
    if (collector.HadHit()) {
      const {mFraction, mPenetrationAxis: axis, mContactPointOn2: on} = collector.mHit;  // the axis leads to the triangle
      answer = hit(mFraction, unit([axis.GetX(), axis.GetY(), axis.GetZ()], -1), [on.GetX(), on.GetY(), on.GetZ()]);
    }
    for (const made of [collector, cast, direction]) Jolt.destroy(made);
    return answer;
  });

  return asked.sweep ? {'moving-sphere': movingSphere} : {'sphere-triangle': sphereTriangle};
}

await serve(make);
