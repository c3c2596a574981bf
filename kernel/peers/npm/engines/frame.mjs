// The side of the pipe (docs/pipe.md) that every engine here shares: reads queries from standard input, asks the engine,
// writes its replies to standard output. After the last reply of a stream it reads another header; at the end of the
// file it ends.
//
//   await serve(async () => ({'sphere-triangle': (q) => verdict}));
//
// `make` loads the engine and returns a function for each predicate that it answers, by its name in predicates.mjs. That
// function takes the numbers of one query, in the order of the predicate's columns, and returns a verdict; or, where the engine says
// more, what `hit`, `spoken` or `pair` makes of it, for streams that ask for measures. Queries that are none (a number that is not
// finite, a negative length, a quaternion 0) are answered `invalid` and not handed on.
//
// A function that has a member `batch`, a number, answers up to so many queries at once: it is given the numbers of all, and
// returns a promise of their verdicts. If it throws, the program ends.
//
// An exception declines the query: `undecided`, with a line on standard error. After a trap of WebAssembly the engine's
// memory cannot be trusted, and after an abort it answers nothing: it is made anew.
import {readSync, writeSync} from 'node:fs';

import {predicates} from './predicates.mjs';

export const CONTACT = 0, SEPARATED = 1, UNDECIDED = 2, INVALID = 3;
export const verdictOf = (contact) => (contact ? CONTACT : SEPARATED);
// The verdict of an engine that gives a distance.
export const verdictWithin = (distance, reach) => (Number.isNaN(distance) ? INVALID : verdictOf(distance <= reach));
// The answer of an engine that hits: what it says of the first contact, in the order of the measures of moving-sphere
// (`axiscert predicates`). `time` is a fraction of the displacement; `normal` and `point` have three numbers each. A hit whose
// time is NaN is no answer.
const UNSAID = [NaN, NaN, NaN];
export function hit(time, normal = UNSAID, point = UNSAID) {
  return {verdict: Number.isNaN(time) ? INVALID : CONTACT, measures: [time, NaN, ...normal, ...point]};
}
// A verdict on a sphere and a triangle with what the engine says beside it: the separation is minus the depth where the two overlap, the
// normal pushes the sphere, and the point is the triangle's. No engine names the part that is nearest.
export function spoken(verdict, {separation = NaN, normal = UNSAID, point = UNSAID} = {}) {
  return {verdict, measures: [separation, NaN, ...normal, ...point]};
}
// The same of two bodies: the normal pushes the second, and each has a point.
export function pair(verdict, {separation = NaN, normal = UNSAID, a = UNSAID, b = UNSAID} = {}) {
  return {verdict, measures: [separation, ...normal, ...a, ...b]};
}
// Of several contacts the deepest, the first of those; empty where there is none.
export const deepest = (contacts) => contacts.reduce((best, one) => (best.separation <= one.separation ? best : one), {});

const VERSION = 3;  // of the streams
const HEAD = 64, GREATEST_HEADER = 1 << 20, REPLY = 16;  // bytes
const MEASURES_FOLLOW = 2;  // bit 1 of a reply's flags
// Queries whose replies are written together: few, so that a reader knows how far a program came that hangs.
const QUERIES_A_WRITE = 64;
// Lines on standard error for each stream. Some engines print one for every shape that they refuse.
const MOST_LINES = 20;

let lines = 0;
function say(...words) {
  if (lines++ < MOST_LINES) writeAll(2, Buffer.from(words.map(String).join(' ').slice(0, 2000) + '\n'));
}
// Standard output carries replies alone; engines print on the console.
console.log = console.info = console.warn = console.error = console.debug = say;

export function fail(why) {
  lines = 0;
  say(`${process.argv[1]}: ${why}`);
  process.exit(2);
}

// A descriptor that somebody else has set to non-blocking says EAGAIN.
const moment = new Int32Array(new SharedArrayBuffer(4));
function patiently(call) {
  for (;;) {
    try {
      return call();
    } catch (error) {
      if (error.code === 'EOF') return 0;  // Windows' word for the end of a pipe
      if (error.code === 'EPIPE') process.exit(0);  // nobody reads the replies any more
      if (error.code !== 'EAGAIN') throw error;
      Atomics.wait(moment, 0, 0, 1);
    }
  }
}

function writeAll(to, bytes) {
  for (let done = 0; done < bytes.length;) done += patiently(() => writeSync(to, bytes, done));
}

// Fills `bytes` from standard input; returns how many there were before its end.
function readAll(bytes) {
  let done = 0;
  while (done < bytes.length) {
    const got = patiently(() => readSync(0, bytes, done, bytes.length - done, null));
    if (got === 0) break;
    done += got;
  }
  return done;
}

// The header's bytes and what they say, or null at the end of the file.
function readHeader(answers) {
  const head = Buffer.alloc(HEAD);
  const got = readAll(head);
  if (got === 0) return null;
  if (got < HEAD || head.toString('latin1', 0, 8) !== 'AXISCERT') {
    fail('standard input is not a query stream; `axiscert generate --binary` makes one');
  }
  const version = head.readUInt32LE(8), precision = head.readUInt32LE(12), count = Number(head.readBigUInt64LE(16));
  const size = head.readUInt32LE(24), recordSize = head.readUInt32LE(28);
  if (version !== VERSION) fail(`the stream's version is ${version}; this program reads ${VERSION}`);
  if (precision !== 32 && precision !== 64) fail(`the stream's precision is ${precision}; it is 32 or 64`);
  if (size < HEAD || size > GREATEST_HEADER) fail(`the header's size is ${size} bytes; it is from ${HEAD} to ${GREATEST_HEADER}`);
  const plan = Buffer.alloc(size - HEAD);
  if (readAll(plan) < plan.length) fail('the stream ends within its header');

  let id, entry, measures;
  try {
    ({predicate: id, entry, measures = 0} = JSON.parse(plan.toString('utf8')));
  } catch {
    fail('the plan in the header is to be JSON with the members "predicate" and "entry"');
  }
  if (`${id}/${entry}` in predicates) id = `${id}/${entry}`;
  const ids = Object.keys(answers);
  if (!ids.includes(id)) fail(`the stream asks '${id}'; this program answers ${ids.join(', ')}`);
  const columns = predicates[id].columns;
  if (!(measures >= 0 && measures <= predicates[id].measures)) {
    fail(`the stream asks for ${measures} measures; ${id} has ${predicates[id].measures}`);
  }
  if (recordSize !== columns * precision / 8) {
    fail(`a record of ${id} in binary${precision} has ${columns * precision / 8} bytes, not ${recordSize}`);
  }
  return {bytes: Buffer.concat([head, plan]), id, precision, count, columns, recordSize, measures,
          replySize: REPLY + measures * precision / 8};
}

function isQuery(predicate, q) {
  for (let k = 0; k < q.length; ++k) if (!Number.isFinite(q[k])) return false;
  return predicate.lengths.every((k) => q[k] >= 0) && !predicate.isNone?.(q);
}

// Traps are RuntimeErrors; emscripten's abort() throws one too, or a text.
const isFatal = (error) => error instanceof WebAssembly.RuntimeError || /abort/i.test(String(error));

export async function serve(make) {
  let answers = await make();
  for (let header; (header = readHeader(answers)) !== null;) {
    lines = 0;
    const {id, columns, recordSize, replySize, measures} = header;
    const {batch} = answers[id], most = batch ?? QUERIES_A_WRITE;
    const records = Buffer.from(new ArrayBuffer(Math.min(most, header.count) * recordSize));
    const numbers = new (header.precision === 32 ? Float32Array : Float64Array)(records.buffer);
    const put = header.precision === 32 ? Buffer.prototype.writeFloatLE : Buffer.prototype.writeDoubleLE;
    writeAll(1, header.bytes);
    for (let first = 0; first < header.count; first += most) {
      const count = Math.min(most, header.count - first);
      const got = readAll(records.subarray(0, count * recordSize));
      if (got < count * recordSize) fail(`the stream ends after ${first + Math.floor(got / recordSize)} of ${header.count} queries`);
      const replies = Buffer.alloc(count * replySize);
      const verdicts = batch ? await answers[id](numbers.subarray(0, count * columns)).catch((error) => fail(error.message)) : [];
      for (let i = 0; i < count; ++i) {
        const q = numbers.subarray(i * columns, (i + 1) * columns);
        let verdict = INVALID, said = [];
        if (!isQuery(predicates[id], q)) {
          // It stays invalid.
        } else if (batch) {
          verdict = verdicts[i];
        } else {
          try {
            const answer = answers[id](q);
            ({verdict, measures: said} = typeof answer === 'object' ? answer : {verdict: answer, measures: []});
          } catch (error) {
            verdict = UNDECIDED;
            say(`query ${first + i}: ${error}`);
            if (isFatal(error)) answers = await make();
          }
        }
        if (![CONTACT, SEPARATED, UNDECIDED, INVALID].includes(verdict)) fail(`query ${first + i}: '${verdict}' is not a verdict`);
        replies[i * replySize] = verdict;
        if (measures === 0) continue;
        replies[i * replySize + 1] = MEASURES_FOLLOW;
        for (let k = 0; k < measures; ++k) put.call(replies, said[k] ?? NaN, i * replySize + REPLY + k * header.precision / 8);
      }
      writeAll(1, replies);
    }
  }
}
