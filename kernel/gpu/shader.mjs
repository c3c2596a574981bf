// A shader as a program of the pipe (docs/pipe.md, docs/gpu.md): one dispatch for each batch of queries.
//
//   node shader.mjs FILE [QUESTION [DEVICE [OPTIONS]]] < queries > replies
//
// FILE has the function `separated`, with the arguments of the question (languages.mjs), and returns 0 contact, 1 separated,
// 2 undecided. It ends in .wgsl, .glsl, or .cl of OpenCL C; with .mjs behind it, it is a module whose default export is the
// text, as where a package has a part of it. DEVICE is a word that the device's name has to have, so that a
// manifest can say in its own name which device answers. OPTIONS are those of OpenCL's compiler.
import {readFileSync} from 'node:fs';
import {basename, extname} from 'node:path';
import {pathToFileURL} from 'node:url';

import {fail, serve} from '../peers/npm/engines/frame.mjs';
import {languages, questionNames} from './languages.mjs';

const MOST_QUERIES = 1 << 18;  // of a dispatch

const [file, question = 'sphere-triangle', device = '', options = ''] = process.argv.slice(2);
if (file === undefined || !questionNames.includes(question)) {
  fail(`node shader.mjs FILE [QUESTION [DEVICE [OPTIONS]]]; the question is one of ${questionNames.join(', ')}`);
}
const isModule = extname(file) === '.mjs';
const language = extname(isModule ? basename(file, '.mjs') : file).slice(1);
if (!(language in languages)) fail(`${file} is to end in .${Object.keys(languages).join(', .')}, which says its language, or in one of these and .mjs`);
if (options !== '' && language !== 'cl') fail(`options are for .cl alone; ${file} is given '${options}'`);
let text;
try {
  text = isModule ? (await import(pathToFileURL(file))).default : readFileSync(file, 'utf8');
} catch (error) {
  fail(`${file} cannot be read: ${error.message}`);
}

await serve(async () => {
  const {open} = await import(language === 'wgsl' ? './webgpu.mjs' : './native.mjs');
  const answer = await open({file, text, language, question, device, options});
  answer.batch = MOST_QUERIES;
  if (process.env.AXISCERT_GPU_SAY) process.stderr.write(`${answer.device}\n`);
  return {[question]: answer};
});
process.exit(0);  // Dawn's threads end with the process
