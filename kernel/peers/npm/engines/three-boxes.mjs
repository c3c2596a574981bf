// three.js, in double.
//   obb   OBB.intersectsOBB, its epsilon as by default
//   box3  of the predicate box-triangle: Box3.intersectsTriangle
import {Box3, Matrix3, Triangle, Vector3} from 'three';
import {OBB} from 'three/examples/jsm/math/OBB.js';

import {serve, verdictOf} from './frame.mjs';
import {form} from './triangle.mjs';
import {corners, matrices} from './box.mjs';

const vector = (v) => new Vector3(v[0], v[1], v[2]);
function obbOf({m, s, axes: [x, y, z]}) {
  return new OBB(vector(m), vector(s), new Matrix3(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]));
}

const answers = form({
  'obb': matrices((a, b) => verdictOf(obbOf(a).intersectsOBB(obbOf(b)))),
  'box3': {
    'box-triangle/minmax': (q) => verdictOf(
        new Box3(vector(q), vector(q.subarray(3))).intersectsTriangle(new Triangle(...corners(q, 6).map(vector)))),
  },
});

await serve(async () => answers);
