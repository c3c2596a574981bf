// Shaders in GLSL, by glslangValidator and Vulkan, and kernels of OpenCL C: each in a process of its own, vulkan_host or
// opencl_host, which `./dev gpu` builds.
import {spawn, spawnSync} from 'node:child_process';
import {existsSync, mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {fileURLToPath} from 'node:url';
import {join} from 'node:path';

import {fail} from '../peers/npm/engines/frame.mjs';
import {columnsOf, languages, toldError} from './languages.mjs';

const READY = 'device: ';  // what the line begins with that a host writes once it can answer
const HOSTS = process.env.AXISCERT_GPU_HOSTS ?? fileURLToPath(new URL('../../build/gpu', import.meta.url));

function hostOf(name) {
  const path = join(HOSTS, name);
  if (!existsSync(path)) fail(`NOT CHECKED: ${path} is not there; ./dev gpu builds it`);
  return path;
}

// Compiles a shader in GLSL; returns the file of its words.
function compiled({file, text, question}, folder) {
  const source = join(folder, 'shader.comp'), words = join(folder, 'shader.spv');
  writeFileSync(source, languages.glsl.whole(text, question));
  const {stdout, error} = spawnSync('glslangValidator', ['-V', source, '-o', words], {encoding: 'utf8'});
  if (error) fail(`NOT CHECKED: glslangValidator cannot be run (${error.code}); ./dev gpu brings it`);
  const found = /^ERROR: .*?:(\d+): (.*)$/m.exec(stdout);
  if (found) fail(toldError(file, text, 'glsl', question, Number(found[1]), undefined, found[2]));
  if (!existsSync(words)) fail(`${file}: ${stdout.trim().split('\n').at(-1)}`);
  return words;
}

// Starts a host; resolves to a function as webgpu.mjs returns, once the host has said which device it has.
function started(command, given) {
  const host = spawn(command[0], command.slice(1), {stdio: ['pipe', 'pipe', 'pipe']});
  let waiting = null, words = [], said = '';
  const ended = (status, signal) => {
    if (signal) fail(`the device's process ended by ${signal}`);
    const text = said.split('\n').filter((line) => !line.startsWith(READY)).join('\n').trim();
    // clang's own form, and pocl's.
    const error = /:(\d+):(\d+): (?:fatal )?error: (.*)/.exec(text) ?? /error: \S*:(\d+):(\d+): (.*)/.exec(text);
    if (error && status === 2) fail(toldError(given.file, given.text, 'cl', given.question, Number(error[1]), Number(error[2]), error[3]));
    fail(text || `the device's process ended with exit code ${status}`);
  };
  host.on('close', ended);
  host.on('error', (error) => fail(`${command[0]} cannot be run: ${error.message}`));
  host.stdin.on('error', () => {});  // it ended, and 'close' says why
  host.stdout.on('data', (bytes) => {
    words.push(bytes);
    const all = waiting && words.reduce((sum, part) => sum + part.length, 0);
    if (waiting === null || all < 4 * waiting.count) return;
    const whole = Buffer.concat(words);
    const {resolve, count} = waiting;
    [waiting, words] = [null, []];
    resolve(Uint32Array.from({length: count}, (_, i) => whole.readUInt32LE(4 * i)));
  });
  const ask = (numbers) => new Promise((resolve) => {
    const count = numbers.length / columnsOf(given.question);
    waiting = {resolve, count};
    host.stdin.write(`${count}\n`);
    host.stdin.write(Buffer.from(numbers.buffer, numbers.byteOffset, numbers.byteLength));
  });
  return new Promise((resolve) => host.stderr.on('data', (bytes) => {
    said += bytes;
    const ready = said.split('\n').slice(0, -1).find((line) => line.startsWith(READY));
    if (ready) resolve(Object.assign(ask, {
      device: ready.slice(READY.length),
      close: () => host.removeListener('close', ended).stdin.end(),
    }));
  }));
}

let folder = null;  // of this process
export async function open(given) {
  if (folder === null) {
    folder = mkdtempSync(join(tmpdir(), 'axiscert-gpu-'));
    process.on('exit', () => rmSync(folder, {recursive: true, force: true}));
  }
  const columns = String(columnsOf(given.question));
  if (given.language === 'glsl') return started([hostOf('vulkan_host'), compiled(given, folder), columns, given.device], given);
  const source = join(folder, 'kernel.cl');
  writeFileSync(source, languages.cl.whole(given.text, given.question));
  return started([hostOf('opencl_host'), source, columns, given.device, given.options], given);
}
