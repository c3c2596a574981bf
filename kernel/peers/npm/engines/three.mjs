// three.js, in double.
//   closest-point  Triangle.closestPointToPoint, and Sphere.containsPoint of that
//   octree         Octree.triangleSphereIntersect, which games made with three walk on
import {Sphere, Triangle, Vector3} from 'three';
import {Octree} from 'three/examples/jsm/math/Octree.js';

import {serve, verdictOf} from './frame.mjs';
import {centre, form, radius, vertices} from './triangle.mjs';

const octree = new Octree(), nearest = new Vector3();
const answer = form({
  'closest-point': (sphere, triangle) => sphere.containsPoint(triangle.closestPointToPoint(sphere.center, nearest)),
  'octree': (sphere, triangle) => octree.triangleSphereIntersect(sphere, triangle) !== false,
});

function sphereTriangle(q) {
  const [a, b, c] = vertices(q).map((v) => new Vector3(...v));
  return verdictOf(answer(new Sphere(new Vector3(...centre(q)), radius(q)), new Triangle(a, b, c)));
}

await serve(async () => ({'sphere-triangle': sphereTriangle}));
