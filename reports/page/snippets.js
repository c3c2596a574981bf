// A witness as code to paste. Names from a record appear only in comments, on one line: no line break, and no backslash
// that would continue it.

function one_line(text) { return text.replace(/[\u0000-\u001f\u007f\u2028\u2029\\]/g, ' ').replace(/\*\//g, '* /').replace(/\?\?/g, '? ?'); }

function c_number(text, precision) {
  const special = {nan: 'NAN', inf: 'INFINITY', '-inf': '-INFINITY'};
  return special[text] ?? text + (precision === 'binary32' ? 'f' : '');
}

function c_point(values, precision) { return `{${values.map((value) => c_number(value, precision)).join(', ')}}`; }

// The name of a group as a variable's.
function variable(group) { return group.replace(/[^A-Za-z0-9]/g, '_'); }

function c_type(witness) { return witness.precision === 'binary32' ? 'float' : 'double'; }
function c_name(witness) { return witness.id.replace(/[^A-Za-z0-9]/g, '_'); }

function origin(witness) {
  return one_line(`${witness.id}: ${witness.kernel}, ${witness.precision}, family ${witness.family}, address ${witness.address}`);
}

// The time of contact as it has to be, where the witness shows that it is not; nothing for a predicate without times.
function time_lines(witness, name, numbers) {
  const best = witness.exact_contact?.time;
  const said = witness.measures?.time;
  if (!name || !best || !said || said === 'best') return [];
  const call = `${name}(${numbers})`;
  if (said === 'late' || said === 'early') {
    return [`  // The best time is the greatest ${c_type(witness)} that is not after the first contact; that kernel: ${said}.`,
            `  EXPECT_TRUE(${call} ${said === 'late' ? '<=' : '>='} ${c_number(best, witness.precision)});`];
  }
  return [`  EXPECT_TRUE(${call} >= 0 && ${call} <= 1);  // that kernel: ${said === 'none' ? 'no time' : 'a time outside [0, 1]'}`];
}

function cpp_test(witness) {
  const type = c_type(witness);
  const {groups_of, suite, time, touching: touches} = page_predicate_of(witness), groups = groups_of(witness);
  const line = (group) => {
    const value = witness[group];
    return Array.isArray(value) ? `  const ${type} ${variable(group)}[${value.length}] = ${c_point(value, witness.precision)};`
                                : `  const ${type} ${variable(group)} = ${c_number(value, witness.precision)};`;
  };
  const numbers = groups.map(variable).join(', ');
  const right = witness.truth === 'contact' ? 'TRUE' : 'FALSE';
  const touching = witness.touching ? ` ${touches}` : '';
  const times = time_lines(witness, time, numbers);
  return [
    `// ${origin(witness)}.`,
    `// Exact: ${one_line(witness.truth)}; that kernel: ${one_line(witness.computed)}.${touching} Replace in_contact` +
      `${times.length > 0 ? ` and ${time}` : ''} by your own function${times.length > 0 ? 's' : ''}.`,
    `TEST(${suite}, Witness_${c_name(witness)}) {`, ...groups.map(line),
    witness.truth === 'invalid' ? `  EXPECT_TRUE(is_refused(${numbers}));  // an input is not finite, or the radius negative`
      : `  EXPECT_${right}(in_contact(${numbers}));`,
    ...times, '}', ''].join('\n');
}

function c_array(witness) {
  const groups = page_predicate_of(witness).groups_of(witness);
  const values = groups.map((group) => [witness[group]].flat());
  const count_of_numbers = values.flat().length;
  const needs_math = values.flat().some((value) => /nan|inf/.test(value));
  const names = groups.map((group) => group.toUpperCase()).slice(0, -1).join(', ');
  const text = values.map((some) => `    ${some.map((value) => c_number(value, witness.precision)).join(', ')}`).join(',\n');
  return [
    ...(needs_math ? ['#include <math.h>'] : []),
    `/* ${origin(witness)}. Exact: ${one_line(witness.truth)}. ${names}, then ${groups.at(-1)}. */`,
    `static const ${c_type(witness)} witness_${c_name(witness)}[${count_of_numbers}] = {`, `${text}};`, ''].join('\n');
}

// A line of a query file, as witnesses.jsonl has it.
function json_line(witness) {
  const {id, precision, predicate, entry, address} = witness;
  const numbers = {};
  // A group whose name has dots is nested; what is named by digits is an element of an array.
  for (const group of page_predicate_of(witness).groups_of(witness)) {
    const names = group.split('.');
    let at = numbers;
    names.forEach((name, i) => {
      if (i + 1 === names.length) at[name] = witness[group];
      else at = at[name] ??= /^[0-9]+$/.test(names[i + 1]) ? [] : {};
    });
  }
  return JSON.stringify({id, precision, ...(predicate ? {predicate} : {}), ...(entry ? {entry} : {}), ...numbers, address});
}

const snippet_kinds = [['C++ test', cpp_test], ['C array', c_array], ['JSON line', json_line]];

function snippets(witness) {
  const shown = el('div', 'snippet');
  const show = (index) => shown.replaceChildren(command(snippet_kinds[index][1](witness)));
  show(0);
  return el('div', '', toggle('Code to paste', snippet_kinds.map(([label]) => label), show), shown);
}
