// closestPointToTriangle of three-mesh-bvh's shaders in WGSL, by which its closestPointToPoint asks each triangle.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

const {resolve} = createRequire(new URL('../../peers/npm/package.json', import.meta.url));
const [, closest] = /export const closestPointToTriangle = wgslTagFn[^`]*`([^`]*)`/.exec(readFileSync(resolve('three-mesh-bvh/src/webgpu/tsl/fns.js'), 'utf8'));

export default `${closest}
fn separated(a: vec3f, b: vec3f, c: vec3f, p: vec3f, r: f32) -> u32 {
  let weights = closestPointToTriangle(p, a, b, c);
  let delta = p - (weights.x * a + weights.y * b + weights.z * c);
  return u32(dot(delta, delta) > r * r);
}
`;
