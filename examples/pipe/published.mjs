// The published sphere-triangle test in JavaScript, as a program for axiscert's pipe (docs/pipe.md), and a template:
//
//     axiscert generate --family tangent --binary | node published.mjs | axiscert judge --conforms-to published
//     axiscert run --kernel program:published_node.json
//
// Another question takes other COLUMNS, as `axiscert predicates` lists them, and another function `separated`. The
// numbers of JavaScript are doubles: where the queries are floats, `round` makes one of the result of every operation, so
// the answers are those of axiscert's own kernel.
import {readSync, writeSync} from 'node:fs';

const PREDICATE = 'sphere-triangle', ENTRY = 'vertices';
const COLUMNS = 'ax ay az bx by bz cx cy cz px py pz r'.split(' ');

let round = Math.fround;
const minus = (u, v) => u.map((x, k) => round(x - v[k]));
const times = (u, s) => u.map((x) => round(x * s));
const dot = (u, v) => round(round(round(u[0] * v[0]) + round(u[1] * v[1])) + round(u[2] * v[2]));
const cross = (u, v) => [[1, 2], [2, 0], [0, 1]].map(([i, j]) => round(round(u[i] * v[j]) - round(u[j] * v[i])));

// Whether an axis separates: through the vertex a, or through the nearest point of the line of the edge ab.
const vertex = (a, b, c, rr) => dot(a, a) > rr && dot(a, b) > dot(a, a) && dot(a, c) > dot(a, a);
function edge(a, b, c, rr) {
  const ab = minus(b, a), d = round(dot(a, b) - dot(a, a)), e = dot(ab, ab);
  const q = minus(times(a, e), times(ab, d));
  return dot(q, q) > round(round(rr * e) * e) && dot(q, minus(times(c, e), q)) > 0;
}

// The answer to a query, whose numbers have the names of the columns.
function separated(q) {
  const p = [q.px, q.py, q.pz], rr = round(q.r * q.r);
  const a = minus([q.ax, q.ay, q.az], p), b = minus([q.bx, q.by, q.bz], p), c = minus([q.cx, q.cy, q.cz], p);
  const normal = cross(minus(b, a), minus(c, a)), d = dot(a, normal);
  return round(d * d) > round(rr * dot(normal, normal)) ||
         vertex(a, b, c, rr) || vertex(b, c, a, rr) || vertex(c, a, b, rr) ||
         edge(a, b, c, rr) || edge(b, c, a, rr) || edge(c, a, b, rr);
}

// What follows is the same for every question.

function fail(why) {
  console.error(`published.mjs: ${why}`);  // standard output is for replies only
  process.exit(1);
}

// Reads or writes the whole buffer; returns how much there was.
function wholly(move, buffer) {
  let done = 0;
  while (done < buffer.length) {
    try {
      const moved = move(buffer, done);
      if (moved === 0) break;
      done += moved;
    } catch (error) {
      if (error.code !== 'EAGAIN') throw error;  // a pipe that somebody has made non-blocking
    }
  }
  return done;
}
function read(size) {
  const buffer = Buffer.alloc(size);
  return buffer.subarray(0, wholly((to, at) => readSync(0, to, at, size - at, null), buffer));
}
const write = (buffer) => wholly((from, at) => writeSync(1, from, at), buffer);

// Answers one stream; false where there is none.
function stream() {
  const head = read(64);
  if (head.length === 0) return false;
  if (head.length < 64 || head.toString('latin1', 0, 8) !== 'AXISCERT') {
    fail('standard input is not a query stream; axiscert generate --binary makes one');
  }
  const [version, precision, headerSize, recordSize] = [8, 12, 24, 28].map((at) => head.readUInt32LE(at));
  if (version !== 3) fail('the stream is not of version 3');
  const plan = read(headerSize - 64), {predicate, entry} = JSON.parse(plan);
  if (predicate !== PREDICATE || entry !== ENTRY) {
    fail(`the stream asks ${predicate}, entry ${entry}; this program answers ${PREDICATE}, entry ${ENTRY}`);
  }
  const size = precision / 8;  // of a number, in bytes
  if (recordSize !== COLUMNS.length * size) fail(`a query has ${recordSize / size} numbers, and COLUMNS ${COLUMNS.length} names`);
  write(Buffer.concat([head, plan]));
  round = precision === 32 ? Math.fround : (x) => x;
  const number = precision === 32 ? Buffer.prototype.readFloatLE : Buffer.prototype.readDoubleLE;
  for (let left = Number(head.readBigUInt64LE(16)); left > 0;) {
    const count = Math.min(left, 1024), records = read(count * recordSize), replies = Buffer.alloc(16 * count), q = {};
    if (records.length < count * recordSize) fail('a query is cut short');
    for (let i = 0; i < count; ++i) {
      COLUMNS.forEach((name, k) => { q[name] = number.call(records, i * recordSize + k * size); });
      replies[16 * i] = separated(q) ? 1 : 0;
    }
    write(replies);
    left -= count;
  }
  return true;
}

// One stream in a pipe; `--kernel program:` writes one after another.
if (!stream()) fail('standard input is empty; axiscert generate --binary makes a query stream');
while (stream());
