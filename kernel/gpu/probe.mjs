// What this device and its compiler make of arithmetic that no shading language promises: one line each.
//
//   node probe.mjs
//
// Each question is an expression of the words w[0], w[1], ..., which are known at run time alone, with the answers that
// tell the ways to evaluate it apart.
import {nameOf, openAdapter} from './device.mjs';

const bits = new DataView(new ArrayBuffer(4));
const wordOf = (x) => (bits.setFloat32(0, x), bits.getUint32(0));
const floatOf = (word) => (bits.setUint32(0, word), bits.getFloat32(0));

const u = 2 ** -24;
const wide = 1 + 2 ** -12;  // its square has a bit more than a float
// words, expression of the floats x, y, z of the first three, and the answers by their names
const questions = [
  ['the error of a sum, by two-sum', [1, 2 ** -30], 'two_sum_error(x, y)', {kept: 2 ** -30, 'folded to 0': 0}],
  ['(x + y) + z', [1, u, u], '(x + y) + z', {'in this order': 1, reassociated: 1 + 2 * u}],
  ['dot(), three products', [1, u, u], 'dot(vec3f(x, y, z), vec3f(w(3), w(3), w(3)))', {'x + y first': 1, 'y + z first': 1 + 2 * u}, [1]],
  ['(y - z) - (x - z), z far away', [0, 1, 2 ** 25], '(y - z) - (x - z)', {'as written': 0, 'y - x': 1}],
  ['the same behind a barrier', [0, 1, 2 ** 25], 'kept(y - z) - kept(x - z)', {'as written': 0, 'y - x': 1}],
  ['x y + z', [wide, wide, -(1 + 2 ** -11)], 'x * y + z', {'two roundings': 0, contracted: u}],
  ['x y - y x', [wide, wide], 'x * y - y * x', {'0': 0, contracted: u, 'contracted the other way': -u}],
  ['fma(x, y, z)', [wide, wide, -(1 + 2 ** -11)], 'fma(x, y, z)', {'two roundings': 0, fused: u}],
  ['x y + x z', [1.0118216276168823, 1.4504636526107788, -1.460378885269165], 'x * y + x * z',
   {'as written': -0.010032415390014648, factored: -0.010032447054982185, contracted: -0.01003239955753088, 'contracted the other way': -0.01003246195614338}],
  ['x + y < x, y negative and tiny', [1, -(2 ** -30)], 'f32(x + y < x)', {'as written': 0, 'y < 0': 1}],
  ['(x - y) + y', [1.2345678806304932, 4096], '(x - y) + y', {'as written': 1.234619140625, x: 1.2345678806304932}],
  ['the same behind a barrier', [1.2345678806304932, 4096], 'kept(x - y) + y', {'as written': 1.234619140625, x: 1.2345678806304932}],
  ['(x / y) y', [1, 41], '(x / y) * y', {'as written': 1 - u, cancelled: 1}],
  ['a subnormal times 1', [2 ** -130, 1], 'x * y', {kept: 2 ** -130, flushed: 0}],
  ['2^-126 / 2', [2 ** -126, 0.5], 'x * y', {kept: 2 ** -127, flushed: 0}],
  ['bitcast of a subnormal, and back', [2 ** -130], 'x', {kept: 2 ** -130, flushed: 0}],
  ['2^-149 > 0', [2 ** -149, 0], 'f32(x > y)', {yes: 1, no: 0}],
  ['NaN != NaN', [NaN], 'f32(x != x)', {yes: 1, no: 0}],
  ['NaN > 0', [NaN, 0], 'f32(x > y)', {yes: 1, no: 0}],
  ['overflow', [3e38, 10], 'x * y', {infinity: Infinity, 'the greatest float': 3.4028234663852886e38}],
  ['infinity - infinity', [3e38, 10], 'f32((x * y - x * y) == 0.0)', {NaN: 0, '0': 1}],
  ['0 times -1', [0, -1], 'f32(bitcast<u32>(x * y) != 0u)', {'-0': 1, '0': 0}],
];
// Operations over many numbers: how many results are not the nearest float, and the greatest error in ulp.
const surveys = [
  ['x / y', 'x / y', (x, y) => x / y],
  ['sqrt(x)', 'sqrt(x)', (x) => Math.sqrt(x)],
  ['inverseSqrt(x)', 'inverseSqrt(x)', (x) => 1 / Math.sqrt(x)],
  ['x + y', 'x + y', (x, y) => x + y],
  ['x y', 'x * y', (x, y) => x * y],
];
const SURVEYED = 1 << 18;

async function run(device, body, words, count) {
  const code = `
@group(0) @binding(0) var<storage, read> words: array<u32>;
@group(0) @binding(1) var<storage, read_write> found: array<u32>;
@group(0) @binding(2) var<storage, read_write> zero: array<u32>;
fn w(i: u32) -> f32 { return bitcast<f32>(words[i]); }
fn kept(x: f32) -> f32 { return bitcast<f32>(bitcast<u32>(x) ^ zero[0]); }
fn two_sum_error(x: f32, y: f32) -> f32 { let s = x + y; let t = s - x; return (x - (s - t)) + (y - t); }
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i < ${count}u) { ${body} }
}`;
  const module = device.createShaderModule({code});
  const pipeline = await device.createComputePipelineAsync({layout: 'auto', compute: {module, entryPoint: 'main'}});
  const {STORAGE, COPY_DST, COPY_SRC, MAP_READ} = GPUBufferUsage;
  const input = device.createBuffer({size: Math.max(16, 4 * words.length), usage: STORAGE | COPY_DST});
  const found = device.createBuffer({size: 4 * count, usage: STORAGE | COPY_SRC});
  const zero = device.createBuffer({size: 4, usage: STORAGE | COPY_DST});
  const read = device.createBuffer({size: 4 * count, usage: MAP_READ | COPY_DST});
  device.queue.writeBuffer(input, 0, Uint32Array.from(words));
  const entries = [input, found, zero].map((buffer, binding) => ({binding, resource: {buffer}}));
  const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  // `auto` leaves out what a body does not use: all three are named below.
  pass.setBindGroup(0, device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries}));
  pass.dispatchWorkgroups(Math.ceil(count / 64));
  pass.end();
  encoder.copyBufferToBuffer(found, 0, read, 0, 4 * count);
  device.queue.submit([encoder.finish()]);
  await read.mapAsync(GPUMapMode.READ);
  return Uint32Array.from(new Uint32Array(read.getMappedRange()));
}

const ulp = (x) => 2 ** (Math.max(-126, Math.floor(Math.log2(Math.abs(x)))) - 23);

const adapter = await openAdapter().catch((error) => {
  console.error(`probe.mjs: ${error.message}`);
  process.exit(2);
});
const device = await adapter.requestDevice();
console.log(`${'device'.padEnd(40)} ${nameOf(adapter)}`);
for (const [name, floats, expression, answers, more = []] of questions) {
  const words = [...floats, ...Array(3 - floats.length).fill(0), ...more].map(wordOf);
  const [word] = await run(device, `let x = w(0u); let y = w(1u); let z = w(2u); found[i] = bitcast<u32>(${expression.replaceAll(/w\((\d)\)/g, 'w($1u)')}) ^ zero[0];`, words, 1);
  const value = floatOf(word);
  const known = Object.entries(answers).find(([, answer]) => answer === value);
  console.log(`${name.padEnd(40)} ${known ? known[0] : `another way: ${value}`}`);
}
// A multiplicative generator: the same numbers everywhere, exponents from 2^-20 to 2^20.
let state = 12345;
const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0);
const many = Uint32Array.from({length: 2 * SURVEYED}, () => ((107 + (random() >>> 8) % 41) << 23) | (random() >>> 9));
for (const [name, expression, exact] of surveys) {
  const found = await run(device, `let x = w(2u * i); let y = w(2u * i + 1u); found[i] = bitcast<u32>(${expression}) ^ zero[0];`, many, SURVEYED);
  let wrong = 0, greatest = 0;
  for (let i = 0; i < SURVEYED; ++i) {
    // The double is within 2^-29 ulp of the exact value, but for ties, of which sums alone have any.
    const truth = exact(floatOf(many[2 * i]), floatOf(many[2 * i + 1])), value = floatOf(found[i]);
    if (value !== Math.fround(truth)) ++wrong;
    greatest = Math.max(greatest, Math.abs(value - truth) / ulp(truth));
  }
  console.log(`${name.padEnd(40)} ${wrong} of ${SURVEYED} not the nearest float, error at most ${greatest.toFixed(3)} ulp`);
}
process.exit(0);
