// What a shader of each language is compiled with: its own text comes first, or has its own numbers of lines, so that those
// of its errors are its own. Inputs are words, which become floats in the call alone.
//
// The arguments of `separated` by question, in the order of the columns; the columns of a matrix are a box's axes.
const questions = {
  'sphere-triangle': ['vector', 'vector', 'vector', 'vector', 'number'],         // a b c p r
  'moving-sphere': ['vector', 'vector', 'vector', 'vector', 'vector', 'number'], // a b c p d r
  // Of each box: its centre, its half extents, and its axes or its quaternion w x y z.
  'box-box/matrix': ['vector', 'vector', 'matrix', 'vector', 'vector', 'matrix'],
  'box-box/quaternion': ['vector', 'vector', 'quaternion', 'vector', 'vector', 'quaternion'],
  // The box, then the triangle's a b c; `minmax`: the box by its least and its greatest corner.
  'box-triangle/centre': ['vector', 'vector', 'vector', 'vector', 'vector'],
  'box-triangle/minmax': ['vector', 'vector', 'vector', 'vector', 'vector'],
  'box-triangle/matrix': ['vector', 'vector', 'matrix', 'vector', 'vector', 'vector'],
};
const sizes = {number: 1, vector: 3, quaternion: 4, matrix: 9};  // numbers

export const GROUP = 64;  // invocations of a workgroup
export const questionNames = Object.keys(questions);
export const columnsOf = (question) => questions[question].reduce((sum, kind) => sum + sizes[kind], 0);

// The call of `separated`, from `number(k)`, the expression of column k.
function call(question, types, number) {
  let next = 0;
  const values = questions[question].map((kind) => {
    const numbers = Array.from({length: sizes[kind]}, () => number(next++));
    return kind === 'number' ? numbers[0] : types[kind](numbers);
  });
  return `separated(${values.join(', ')})`;
}
const made = (type) => (numbers) => `${type}(${numbers.join(', ')})`;

// signature: of the function that a file is to have; whole(text, question): what is compiled.
export const languages = {
  wgsl: {
    names: {number: 'f32', vector: 'vec3f', quaternion: 'vec4f', matrix: 'mat3x3f'},
    signature: (types) => `fn separated(${types.join(', ')}) -> u32`,
    // axiscert_zero[0] is 0 at run time, which no compiler can know; axiscert_zero[1] is the number of queries.
    whole: (text, question) => `${text}
@group(0) @binding(0) var<storage, read> axiscert_numbers: array<u32>;
@group(0) @binding(1) var<storage, read_write> axiscert_verdicts: array<u32>;
@group(0) @binding(2) var<storage, read_write> axiscert_zero: array<u32>;
// x, in a way that no compiler can see: what is computed of it is not merged with what it was computed from.
fn axiscert_kept(x: f32) -> f32 { return bitcast<f32>(bitcast<u32>(x) ^ axiscert_zero[0]); }
fn axiscert_kept3(v: vec3f) -> vec3f { return vec3f(axiscert_kept(v.x), axiscert_kept(v.y), axiscert_kept(v.z)); }
@compute @workgroup_size(${GROUP})
fn axiscert_main(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= axiscert_zero[1]) { return; }
  let at = i * ${columnsOf(question)}u;
  axiscert_verdicts[i] = ${call(question, {vector: made('vec3f'), quaternion: made('vec4f'), matrix: made('mat3x3f')},
    (k) => `bitcast<f32>(axiscert_numbers[at + ${k}u])`)};
}
`,
  },
  glsl: {
    names: {number: 'float', vector: 'vec3', quaternion: 'vec4', matrix: 'mat3'},
    signature: (types) => `uint separated(${types.join(', ')})`,
    whole: (text, question) => `#version 450
layout(local_size_x = ${GROUP}) in;
layout(std430, binding = 0) readonly buffer AxiscertNumbers { uint axiscert_numbers[]; };
layout(std430, binding = 1) writeonly buffer AxiscertVerdicts { uint axiscert_verdicts[]; };
layout(std430, binding = 2) coherent buffer AxiscertZero { uint axiscert_zero[]; };
float axiscert_kept(float x) { return uintBitsToFloat(floatBitsToUint(x) ^ axiscert_zero[0]); }
vec3 axiscert_kept(vec3 v) { return vec3(axiscert_kept(v.x), axiscert_kept(v.y), axiscert_kept(v.z)); }
#line 1
${text}
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= axiscert_zero[1]) return;
  uint at = i * ${columnsOf(question)}u;
  axiscert_verdicts[i] = ${call(question, {vector: made('vec3'), quaternion: made('vec4'), matrix: made('mat3')},
    (k) => `uintBitsToFloat(axiscert_numbers[at + ${k}u])`)};
}
`,
  },
  cl: {
    names: {number: 'float', vector: 'float3', quaternion: 'float4', matrix: 'float3, float3, float3'},
    signature: (types) => `uint separated(${types.join(', ')})`,
    // C promises that a volatile object is stored and loaded.
    whole: (text, question) => `float axiscert_kept(float x) { volatile float kept = x; return kept; }
float3 axiscert_kept3(float3 v) { return (float3)(axiscert_kept(v.x), axiscert_kept(v.y), axiscert_kept(v.z)); }
#line 1
${text}
kernel void axiscert_main(global const uint* axiscert_numbers, global uint* axiscert_verdicts, uint axiscert_count) {
  const uint i = get_global_id(0);
  if (i >= axiscert_count) return;
  const size_t at = (size_t)i * ${columnsOf(question)};
  axiscert_verdicts[i] = ${call(question, {
    vector: (n) => `(float3)(${n.join(', ')})`, quaternion: (n) => `(float4)(${n.join(', ')})`,
    matrix: (n) => [0, 3, 6].map((k) => `(float3)(${n.slice(k, k + 3).join(', ')})`).join(', '),
  }, (k) => `as_float(axiscert_numbers[at + ${k}])`)};
}
`,
  },
};

export const signatureOf = (language, question) => languages[language].signature(questions[question].map((kind) => languages[language].names[kind]));

// What to tell of an error in the text that was compiled.
export function toldError(file, text, language, question, line, column, message) {
  if (line <= text.split('\n').length) return `${file}:${line}:${column === undefined ? '' : `${column}:`} ${message}`;
  return `${file} does not fit what calls it: ${message}; its function is to be ${signatureOf(language, question)}`;
}
