// A shader as a program of the pipe (docs/pipe.md, docs/gpu.md): one dispatch for each batch of queries.
//
//   node shader.mjs FILE.wgsl [QUESTION [DEVICE]] < queries > replies
//
// DEVICE is a word that the adapter's name has to have, so that a manifest can say in its own name which device answers.
// FILE has `fn separated(...) -> u32` with the arguments of the question (arguments below), and is compiled with what is
// put behind it here. It returns 0 contact, 1 separated, 2 undecided.
import {readFileSync} from 'node:fs';

import {fail, serve} from '../peers/npm/engines/frame.mjs';
import {nameOf, openAdapter} from './device.mjs';

// The arguments of `separated` by question, in the order of the columns. The columns of a matrix are a box's axes.
const arguments_of = {
  'sphere-triangle': ['vec3f', 'vec3f', 'vec3f', 'vec3f', 'f32'],         // a b c p r
  'moving-sphere': ['vec3f', 'vec3f', 'vec3f', 'vec3f', 'vec3f', 'f32'],  // a b c p d r
  // Of each box: its centre, its half extents, and its axes or its quaternion w x y z.
  'box-box/matrix': ['vec3f', 'vec3f', 'mat3x3f', 'vec3f', 'vec3f', 'mat3x3f'],
  'box-box/quaternion': ['vec3f', 'vec3f', 'vec4f', 'vec3f', 'vec3f', 'vec4f'],
  // The box, then the triangle's a b c; `minmax`: the box by its least and its greatest corner.
  'box-triangle/centre': ['vec3f', 'vec3f', 'vec3f', 'vec3f', 'vec3f'],
  'box-triangle/minmax': ['vec3f', 'vec3f', 'vec3f', 'vec3f', 'vec3f'],
  'box-triangle/matrix': ['vec3f', 'vec3f', 'mat3x3f', 'vec3f', 'vec3f', 'vec3f'],
};
const sizes = {f32: 1, vec3f: 3, vec4f: 4, mat3x3f: 9};  // numbers

const GROUP = 64;             // invocations of a workgroup
const MOST_QUERIES = 1 << 18; // of a dispatch

// The shader's own text comes first, so that the lines of its errors are its own. Inputs are words, which become floats
// in the call alone. axiscert_zero is 0 at run time, which no compiler can know.
function whole(text, types) {
  let next = 0;
  const number = () => `bitcast<f32>(axiscert_numbers[at + ${next++}u])`;
  const values = types.map((type) => (type === 'f32' ? number() : `${type}(${Array.from({length: sizes[type]}, number).join(', ')})`));
  return `${text}
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
  let at = i * ${next}u;
  axiscert_verdicts[i] = separated(${values.join(', ')});
}
`;
}

async function compile(device, file, text, types) {
  const code = whole(text, types);
  device.pushErrorScope('validation');
  const module = device.createShaderModule({code});
  const {messages} = await module.getCompilationInfo();
  const errors = messages.filter(({type}) => type === 'error');
  if (errors.length > 0) {
    const [{lineNum, linePos, message}] = errors;
    const lines = text.split('\n').length;
    fail(lineNum > lines ? `${file} does not fit what calls it: ${message}; its function is to be ${'fn separated('}${types.join(', ')}) -> u32` :
      `${file}:${lineNum}:${linePos}: ${message}`);
  }
  const pipeline = await device.createComputePipelineAsync({layout: 'auto', compute: {module, entryPoint: 'axiscert_main'}})
    .catch((error) => fail(`${file} compiles, but not into a pipeline of this device: ${error.message}`));
  const error = await device.popErrorScope();
  if (error) fail(`${file}: ${error.message}`);
  return pipeline;
}

const [file, question = 'sphere-triangle', wanted = ''] = process.argv.slice(2);
const types = arguments_of[question];
if (file === undefined || types === undefined) {
  fail(`node shader.mjs FILE.wgsl [QUESTION [DEVICE]]; the question is one of ${Object.keys(arguments_of).join(', ')}`);
}
let text;
try {
  text = readFileSync(file, 'utf8');
} catch (error) {
  fail(`${file} cannot be read: ${error.message}`);
}

await serve(async () => {
  const adapter = await openAdapter().catch((error) => fail(error.message));
  if (!nameOf(adapter).toLowerCase().includes(wanted.toLowerCase())) fail(`NOT CHECKED: the GPU adapter is '${nameOf(adapter)}', not ${wanted}`);
  const device = await adapter.requestDevice();
  // Without this, a lost device would answer zeros: contact.
  device.lost.then(({reason, message}) => reason !== 'destroyed' && fail(`the device was lost (${reason}): ${message}`));
  const pipeline = await compile(device, file, text, types);
  const columns = types.reduce((sum, type) => sum + sizes[type], 0);
  const {STORAGE, COPY_DST, COPY_SRC, MAP_READ} = GPUBufferUsage;

  let buffers = null;  // for as many queries as a batch had so far
  function buffersFor(count) {
    if (buffers !== null && buffers.count >= count) return buffers;
    const buffer = (size, usage) => device.createBuffer({size, usage});
    buffers = {
      count,
      numbers: buffer(4 * columns * count, STORAGE | COPY_DST),
      verdicts: buffer(4 * count, STORAGE | COPY_SRC),
      zero: buffer(8, STORAGE | COPY_DST),
      read: buffer(4 * count, MAP_READ | COPY_DST),
    };
    const entries = [buffers.numbers, buffers.verdicts, buffers.zero].map((buffer, binding) => ({binding, resource: {buffer}}));
    buffers.group = device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries});
    return buffers;
  }

  async function answer(numbers) {
    const count = numbers.length / columns;
    device.pushErrorScope('out-of-memory');
    device.pushErrorScope('validation');
    device.pushErrorScope('internal');
    const {numbers: input, verdicts, zero, read, group} = buffersFor(count);
    device.queue.writeBuffer(input, 0, numbers);
    device.queue.writeBuffer(zero, 0, Uint32Array.of(0, count));
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    pass.dispatchWorkgroups(Math.ceil(count / GROUP));
    pass.end();
    encoder.copyBufferToBuffer(verdicts, 0, read, 0, 4 * count);
    device.queue.submit([encoder.finish()]);
    for (const kind of ['internal error', 'fault', 'lack of memory']) {
      const error = await device.popErrorScope();
      if (error) throw new Error(`${kind} of the device: ${error.message}`);
    }
    await read.mapAsync(GPUMapMode.READ, 0, 4 * count);
    const found = Uint32Array.from(new Uint32Array(read.getMappedRange(0, 4 * count)));
    read.unmap();
    return found;
  }
  answer.batch = MOST_QUERIES;
  if (process.env.AXISCERT_GPU_SAY) process.stderr.write(`${nameOf(adapter)}\n`);
  return {[question]: answer};
});
process.exit(0);  // Dawn's threads end with the process
