// Shaders in WGSL, by Dawn.
import {fail} from '../peers/npm/engines/frame.mjs';
import {nameOf, openAdapter} from './device.mjs';
import {columnsOf, GROUP, languages, toldError} from './languages.mjs';

async function compile(device, file, text, question) {
  const code = languages.wgsl.whole(text, question);
  device.pushErrorScope('validation');
  const module = device.createShaderModule({code});
  const {messages} = await module.getCompilationInfo();
  const errors = messages.filter(({type}) => type === 'error');
  if (errors.length > 0) {
    const [{lineNum, linePos, message}] = errors;
    fail(toldError(file, text, 'wgsl', question, lineNum, linePos, message));
  }
  const pipeline = await device.createComputePipelineAsync({layout: 'auto', compute: {module, entryPoint: 'axiscert_main'}})
    .catch((error) => fail(`${file} compiles, but not into a pipeline of this device: ${error.message}`));
  const error = await device.popErrorScope();
  if (error) fail(`${file}: ${error.message}`);
  return pipeline;
}

// The device of this process, by its first wish, and the adapter's name.
let opened = null;
async function openDevice(wanted) {
  const adapter = await openAdapter().catch((error) => fail(error.message));
  const name = nameOf(adapter);
  if (!name.toLowerCase().includes(wanted.toLowerCase())) fail(`NOT CHECKED: the GPU adapter is '${name}', not ${wanted}`);
  const device = await adapter.requestDevice();
  // Without this, a lost device would answer zeros: contact.
  device.lost.then(({reason, message}) => fail(`the device was lost (${reason}): ${message}`));
  return {device, name};
}

// Returns a function from the numbers of some queries to a promise of their words, with the device's name as a member, and
// `lose`, by which a test loses the device.
export async function open({file, text, question, device: wanted}) {
  opened ??= openDevice(wanted);
  const {device, name} = await opened;
  const pipeline = await compile(device, file, text, question);
  const columns = columnsOf(question);
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

  const answer = async (numbers) => {
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
  };
  return Object.assign(answer, {device: name, lose: () => device.destroy()});
}
