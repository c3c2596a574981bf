// Babylon.js: BoundingInfo.intersects with `precise`, the fifteen axes over the whole extents; its matrices are float, what
// it computes of them is double.
import {BoundingInfo} from '@babylonjs/core/Culling/boundingInfo.js';
import {Matrix, Vector3} from '@babylonjs/core/Maths/math.vector.js';

import {serve, verdictOf} from './frame.mjs';
import {matrices} from './box.mjs';

const infoOf = ({m, s, axes: [x, y, z]}) => new BoundingInfo(
    new Vector3(-s[0], -s[1], -s[2]), new Vector3(...s), Matrix.FromArray([...x, 0, ...y, 0, ...z, 0, ...m, 1]));

await serve(async () => matrices((a, b) => verdictOf(infoOf(a).intersects(infoOf(b), true))));
