// Babylon.js, in double: the distance that Vector3.ProjectOnTriangleToRef gives, against r.
import {Vector3} from '@babylonjs/core/Maths/math.vector.js';

import {serve, spoken, verdictWithin} from './frame.mjs';
import {centre, ofNearest, radius, vertices} from './triangle.mjs';

const nearest = new Vector3();
function sphereTriangle(q) {
  const [a, b, c] = vertices(q).map((v) => new Vector3(...v));
  const distance = Vector3.ProjectOnTriangleToRef(new Vector3(...centre(q)), a, b, c, nearest);
  return spoken(verdictWithin(distance, radius(q)), ofNearest(q, nearest.asArray(), distance));
}

await serve(async () => ({'sphere-triangle': sphereTriangle}));
