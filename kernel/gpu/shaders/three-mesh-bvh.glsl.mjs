// closestPointToTriangle of three-mesh-bvh's shaders in GLSL, BVHShaderGLSL.bvh_distance_functions.
import {createRequire} from 'node:module';

const {resolve} = createRequire(new URL('../../peers/npm/package.json', import.meta.url));
const {bvh_distance_functions: all} = await import(resolve('three-mesh-bvh/src/webgl/glsl/bvh_distance_functions.glsl.js'));

export default `${all.slice(0, all.indexOf('float distanceToTriangles('))}
uint separated(vec3 a, vec3 b, vec3 c, vec3 p, float r) {
  vec3 weights;
  vec3 delta = p - closestPointToTriangle(p, a, b, c, weights);
  return dot2(delta) <= r * r ? 0u : 1u;
}
`;
