// three-mesh-bvh: OrientedBox.intersectsTriangle, in double.
//   oriented-box       the box after set(), as MeshBVH makes one
//   oriented-box-made  the box as its constructor makes it of the same arguments
import {Matrix4, Triangle, Vector3} from 'three';
import {OrientedBox} from 'three-mesh-bvh';

import {serve, UNDECIDED, verdictOf} from './frame.mjs';
import {form} from './triangle.mjs';
import {corners, placed} from './box.mjs';

const vector = (v) => new Vector3(v[0], v[1], v[2]);
const boxOf = form({
  'oriented-box': (...given) => {
    const box = new OrientedBox();
    box.set(...given);
    return box;
  },
  'oriented-box-made': (...given) => new OrientedBox(...given),
});

function boxTriangle(q) {
  const box = placed(q);
  if (box === null) return UNDECIDED;
  const {m, s, axes: [x, y, z]} = box;
  const matrix = new Matrix4(x[0], y[0], z[0], m[0], x[1], y[1], z[1], m[1], x[2], y[2], z[2], m[2], 0, 0, 0, 1);
  const asked = boxOf(vector(s).negate(), vector(s), matrix);
  return verdictOf(asked.intersectsTriangle(new Triangle(...corners(q, 15).map(vector))));
}

await serve(async () => ({'box-triangle/matrix': boxTriangle}));
