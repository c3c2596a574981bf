// What a device and its compiler make of arithmetic that no shading language promises: one line each.
//
//   node probe.mjs [LANGUAGE [DEVICE [OPTIONS]]]    as shader.mjs has them; the language is wgsl, glsl or cl
//
// Each question is an expression of floats x, y, z, v that are known at run time alone, with the answers that tell the ways to
// evaluate it apart. It is asked as the shader of a sphere and a triangle, whose first coordinates they are.
import {fail} from '../peers/npm/engines/frame.mjs';
import {columnsOf, languages} from './languages.mjs';

const u = 2 ** -24;
const wide = 1 + 2 ** -12;  // its square has a bit more than a float
const cancelling = [1.0118216276168823, 1.4504636526107788, -1.460378885269165];
// words, expression of the floats, and the answers by their names
const questions = [
  ['the error of a sum, by two-sum', [1, 2 ** -30], 'two_sum_error(x, y)', {kept: 2 ** -30, 'folded to 0': 0}],
  ['(x + y) + z', [1, u, u], '(x + y) + z', {'in this order': 1, reassociated: 1 + 2 * u}],
  ['dot(), three products', [1, u, u, 1], 'dot3(x, y, z, v)', {'x + y first': 1, 'y + z first': 1 + 2 * u}],
  ['(y - z) - (x - z), z far away', [0, 1, 2 ** 25], '(y - z) - (x - z)', {'as written': 0, 'y - x': 1}],
  ['the same behind a barrier', [0, 1, 2 ** 25], 'axiscert_kept(y - z) - axiscert_kept(x - z)', {'as written': 0, 'y - x': 1}],
  ['x y + z', [wide, wide, -(1 + 2 ** -11)], 'x * y + z', {'two roundings': 0, contracted: u}],
  ['x y - y x', [wide, wide], 'x * y - y * x', {'0': 0, contracted: u, 'contracted the other way': -u}],
  ['fma(x, y, z)', [wide, wide, -(1 + 2 ** -11)], 'fma(x, y, z)', {'two roundings': 0, fused: u}],
  ['x y + x z', cancelling, 'x * y + x * z',
   {'as written': -0.010032415390014648, factored: -0.010032447054982185, contracted: -0.01003239955753088, 'contracted the other way': -0.01003246195614338}],
  ['x + y < x, y negative and tiny', [1, -(2 ** -30)], 'truth(x + y < x)', {'as written': 0, 'y < 0': 1}],
  ['(x - y) + y', [1.2345678806304932, 4096], '(x - y) + y', {'as written': 1.234619140625, x: 1.2345678806304932}],
  ['(x - y) + y behind a barrier', [1.2345678806304932, 4096], 'axiscert_kept(x - y) + y', {'as written': 1.234619140625, x: 1.2345678806304932}],
  ['(x / y) y', [1, 41], '(x / y) * y', {'as written': 1 - u, cancelled: 1}],
  ['a subnormal times 1', [2 ** -130, 1], 'x * y', {kept: 2 ** -130, flushed: 0}],
  ['2^-126 / 2', [2 ** -126, 0.5], 'x * y', {kept: 2 ** -127, flushed: 0}],
  ['a subnormal that is moved alone', [2 ** -130], 'x', {kept: 2 ** -130, flushed: 0}],
  ['2^-149 > 0', [2 ** -149, 0], 'truth(x > y)', {yes: 1, no: 0}],
  ['NaN != NaN', [NaN], 'truth(x != x)', {yes: 1, no: 0}],
  ['NaN > 0', [NaN, 0], 'truth(x > y)', {yes: 1, no: 0}],
  ['overflow', [3e38, 10], 'x * y', {infinity: Infinity, 'the greatest float': 3.4028234663852886e38}],
  ['infinity - infinity', [3e38, 10], 'truth((x * y - x * y) == zero())', {NaN: 0, '0': 1}],
  ['0 times -1', [0, -1], 'truth(word(x * y) != word(zero()))', {'-0': 1, '0': 0}],
];
// Operations over many numbers: how many results are not the nearest float, and the greatest error in ulp.
const surveys = [
  ['x / y', 'x / y', (x, y) => x / y],
  ['sqrt(x)', 'sqrt(x)', (x) => Math.sqrt(x)],
  ['1 / sqrt(x), the function', 'inverse_root(x)', (x) => 1 / Math.sqrt(x)],
  ['x + y', 'x + y', (x, y) => x + y],
  ['x y', 'x * y', (x, y) => x * y],
];
const SURVEYED = 1 << 18;

// The functions above, and `separated` with an expression.
const texts = {
  wgsl: (expression) => `
fn two_sum_error(x: f32, y: f32) -> f32 { let s = x + y; let t = s - x; return (x - (s - t)) + (y - t); }
fn dot3(x: f32, y: f32, z: f32, v: f32) -> f32 { return dot(vec3f(x, y, z), vec3f(v, v, v)); }
fn truth(b: bool) -> f32 { return f32(b); }
fn word(x: f32) -> u32 { return bitcast<u32>(x); }
fn zero() -> f32 { return 0.0; }
fn inverse_root(x: f32) -> f32 { return inverseSqrt(x); }
fn separated(a: vec3f, b: vec3f, c: vec3f, p: vec3f, r: f32) -> u32 {
  let x = a.x; let y = a.y; let z = a.z; let v = b.x;
  return word(${expression});
}`,
  glsl: (expression) => `
float two_sum_error(float x, float y) { float s = x + y; float t = s - x; return (x - (s - t)) + (y - t); }
float dot3(float x, float y, float z, float v) { return dot(vec3(x, y, z), vec3(v, v, v)); }
float truth(bool b) { return float(b); }
uint word(float x) { return floatBitsToUint(x); }
float zero() { return 0.0; }
float inverse_root(float x) { return inversesqrt(x); }
uint separated(vec3 a, vec3 b, vec3 c, vec3 p, float r) {
  float x = a.x, y = a.y, z = a.z, v = b.x;
  return word(${expression});
}`,
  cl: (expression) => `
float two_sum_error(float x, float y) { float s = x + y; float t = s - x; return (x - (s - t)) + (y - t); }
float dot3(float x, float y, float z, float v) { return dot((float3)(x, y, z), (float3)(v, v, v)); }
float truth(bool b) { return b; }
uint word(float x) { return as_uint(x); }
float zero(void) { return 0.0f; }
float inverse_root(float x) { return rsqrt(x); }
uint separated(float3 a, float3 b, float3 c, float3 p, float r) {
  const float x = a.x, y = a.y, z = a.z, v = b.x;
  return word(${expression});
}`,
};

const [language = 'wgsl', device = '', options = ''] = process.argv.slice(2);
if (!(language in languages)) fail(`node probe.mjs [LANGUAGE [DEVICE [OPTIONS]]]; the language is one of ${Object.keys(languages).join(', ')}`);
const {open} = await import(language === 'wgsl' ? './webgpu.mjs' : './native.mjs');
const columns = columnsOf('sphere-triangle');
const say = (name, what) => process.stdout.write(`${name.padEnd(40)} ${what}\n`);
let device_name = null;
async function run(expression, given, count) {
  const answer = await open({file: 'probe', text: texts[language](expression), language, question: 'sphere-triangle', device, options});
  if (device_name === null) say('device', device_name = answer.device);
  const numbers = new Float32Array(columns * count);
  given.forEach((x, i) => { numbers[columns * Math.floor(i / 4) + i % 4] = x; });
  const words = await answer(numbers);
  answer.close?.();
  return new Float32Array(words.buffer, words.byteOffset, count);
}

const ulp = (x) => 2 ** (Math.max(-126, Math.floor(Math.log2(Math.abs(x)))) - 23);

for (const [name, floats, expression, answers] of questions) {
  const [value] = await run(expression, floats, 1);
  const known = Object.entries(answers).find(([, answer]) => answer === value);
  say(name, known ? known[0] : `another way: ${value}`);
}
// A multiplicative generator: the same numbers everywhere, exponents from 2^-20 to 2^20.
let state = 12345;
const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0);
const words = Uint32Array.from({length: 4 * SURVEYED}, () => ((107 + (random() >>> 8) % 41) << 23) | (random() >>> 9));
const many = new Float32Array(words.buffer);
for (const [name, expression, exact] of surveys) {
  const found = await run(expression, many, SURVEYED);
  let wrong = 0, greatest = 0;
  for (let i = 0; i < SURVEYED; ++i) {
    // The double is within 2^-29 ulp of the exact value, but for ties, of which sums alone have any.
    const truth = exact(many[4 * i], many[4 * i + 1]);
    if (found[i] !== Math.fround(truth)) ++wrong;
    greatest = Math.max(greatest, Math.abs(found[i] - truth) / ulp(truth));
  }
  say(name, `${wrong} of ${SURVEYED} not the nearest float, error at most ${greatest.toFixed(3)} ulp`);
}
process.exit(0);
