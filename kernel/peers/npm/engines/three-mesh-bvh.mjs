// three-mesh-bvh: ExtendedTriangle in double, a MeshBVH over vertices in float.
//   triangle      ExtendedTriangle.intersectsSphere
//   bvh           MeshBVH.intersectsSphere
//   bvh-distance  MeshBVH.closestPointToPoint, its distance against r
import {BufferAttribute, BufferGeometry, Sphere, Vector3} from 'three';
import {ExtendedTriangle, MeshBVH} from 'three-mesh-bvh';

import {serve, spoken, verdictOf, verdictWithin} from './frame.mjs';
import {centre, form, mesh, ofNearest, radius, vertices} from './triangle.mjs';

function bvhOf(q) {
  const {positions, indices} = mesh(q, false), geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return new MeshBVH(geometry);
}

const sphereOf = (q) => new Sphere(new Vector3(...centre(q)), radius(q));

const sphereTriangle = form({
  'triangle': (q) => verdictOf(new ExtendedTriangle(...vertices(q).map((v) => new Vector3(...v))).intersectsSphere(sphereOf(q))),
  'bvh': (q) => verdictOf(bvhOf(q).intersectsSphere(sphereOf(q))),
  'bvh-distance': (q) => {
    const {point, distance} = bvhOf(q).closestPointToPoint(new Vector3(...centre(q)));
    return spoken(verdictWithin(distance, radius(q)), ofNearest(q, point.toArray(), distance));
  },
});

await serve(async () => ({'sphere-triangle': sphereTriangle}));
