// Babylon.js, in double: the distance that Vector3.ProjectOnTriangleToRef gives, against r.
import {Vector3} from '@babylonjs/core/Maths/math.vector.js';

import {serve, verdictWithin} from './frame.mjs';
import {centre, radius, vertices} from './triangle.mjs';

const nearest = new Vector3();
function sphereTriangle(q) {
  const [a, b, c] = vertices(q).map((v) => new Vector3(...v));
  return verdictWithin(Vector3.ProjectOnTriangleToRef(new Vector3(...centre(q)), a, b, c, nearest), radius(q));
}

await serve(async () => ({'sphere-triangle': sphereTriangle}));
