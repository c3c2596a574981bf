// three.js, in double.
//   closest-point  Triangle.closestPointToPoint, and Sphere.containsPoint of that
//   octree         Octree.triangleSphereIntersect, which games made with three walk on
import {Sphere, Triangle, Vector3} from 'three';
import {Octree} from 'three/examples/jsm/math/Octree.js';

import {CONTACT, SEPARATED, serve, spoken, verdictOf} from './frame.mjs';
import {centre, form, ofNearest, radius, vertices} from './triangle.mjs';

const octree = new Octree(), nearest = new Vector3();
const answer = form({
  'closest-point': (sphere, triangle, q) => spoken(verdictOf(sphere.containsPoint(triangle.closestPointToPoint(sphere.center, nearest))),
                                                   ofNearest(q, nearest.toArray())),
  'octree': (sphere, triangle) => {
    const found = octree.triangleSphereIntersect(sphere, triangle);
    return found === false ? SEPARATED
                           : spoken(CONTACT, {separation: -found.depth, normal: found.normal.toArray(), point: found.point.toArray()});
  },
});

function sphereTriangle(q) {
  const [a, b, c] = vertices(q).map((v) => new Vector3(...v));
  return answer(new Sphere(new Vector3(...centre(q)), radius(q)), new Triangle(a, b, c), q);
}

await serve(async () => ({'sphere-triangle': sphereTriangle}));
