// A witness as code to paste. Names from a record appear only in comments, on one line: no line break, and no backslash
// that would continue it.

function one_line(text) { return text.replace(/[\u0000-\u001f\u007f\u2028\u2029\\]/g, ' ').replace(/\*\//g, '* /').replace(/\?\?/g, '? ?'); }

function c_number(text, precision) {
  const special = {nan: 'NAN', inf: 'INFINITY', '-inf': '-INFINITY'};
  return special[text] ?? text + (precision === 'binary32' ? 'f' : '');
}

function c_point(values, precision) { return `{${values.map((value) => c_number(value, precision)).join(', ')}}`; }

function origin(witness) {
  return one_line(`${witness.id}: ${witness.kernel}, ${witness.precision}, family ${witness.family}, address ${witness.address}`);
}

function cpp_test(witness) {
  const type = witness.precision === 'binary32' ? 'float' : 'double';
  const name = witness.id.replace(/[^A-Za-z0-9]/g, '_');
  const lines = ['a', 'b', 'c', 'p'].map((member) => `  const ${type} ${member}[3] = ${c_point(witness[member], witness.precision)};`);
  const right = witness.truth === 'contact' ? 'TRUE' : 'FALSE';
  const touching = witness.touching ? ' The distance is exactly r.' : '';
  return [
    `// ${origin(witness)}.`,
    `// Exact: ${one_line(witness.truth)}; that kernel: ${one_line(witness.computed)}.${touching} Replace in_contact by your own function.`,
    `TEST(SphereTriangle, Witness_${name}) {`, ...lines,
    `  const ${type} r = ${c_number(witness.r, witness.precision)};`,
    witness.truth === 'invalid' ? '  EXPECT_TRUE(is_refused(a, b, c, p, r));  // an input is not finite, or the radius negative'
      : `  EXPECT_${right}(in_contact(a, b, c, p, r));`,
    '}', ''].join('\n');
}

function c_array(witness) {
  const type = witness.precision === 'binary32' ? 'float' : 'double';
  const name = witness.id.replace(/[^A-Za-z0-9]/g, '_');
  const needs_math = [...witness.a, ...witness.b, ...witness.c, ...witness.p, witness.r].some((value) => /nan|inf/.test(value));
  return [
    ...(needs_math ? ['#include <math.h>'] : []),
    `/* ${origin(witness)}. Exact: ${one_line(witness.truth)}. A, B, C, P, then r. */`,
    `static const ${type} witness_${name}[13] = {`,
    ...['a', 'b', 'c', 'p'].map((member) => `    ${c_point(witness[member], witness.precision).slice(1, -1)},`),
    `    ${c_number(witness.r, witness.precision)}};`, ''].join('\n');
}

function json_line(witness) {
  const {id, precision, a, b, c, p, r} = witness;
  return JSON.stringify({id, precision, a, b, c, p, r});
}

const snippet_kinds = [['C++ test', cpp_test], ['C array', c_array], ['JSON line', json_line]];

function snippets(witness) {
  const shown = el('div', 'snippet');
  const show = (index) => shown.replaceChildren(command(snippet_kinds[index][1](witness)));
  show(0);
  return el('div', '', toggle('Code to paste', snippet_kinds.map(([label]) => label), show), shown);
}
