// The first contact on the card of a witness of a predicate of motions: what the kernel gave, what is exact, how it is judged.

const time_chips = {late: ['late', 'bad'], early: ['early', 'note'], best: ['best time', 'good'], none: ['no time', 'bad'],
                    invalid: ['time outside [0, 1]', 'bad']};

function time_chip(witness) {
  const [words, kind] = time_chips[witness.measures?.time] ?? [];
  return words === undefined ? '' : chip(words, kind);
}

// vertex_a and the like as people write it.
function part_words(name) {
  const [kind, letters] = name.split('_');
  return letters ? `${kind} ${letters.toUpperCase()}` : kind;
}

// `amount` of a number of either sign.
function signed_amount(x, digits) { return (x < 0 ? '−' : '') + amount(Math.abs(x), digits); }

// A number given as hex, and beneath it in decimal.
function number_cell(hex, precision) {
  const value = parse_hex(hex);
  const digits = precision === 'binary32' ? 9 : 17;
  return [el('code', '', hex), el('small', '', Number.isFinite(value) ? signed_amount(value, digits) : '')];
}

// Three numbers, of which some may be missing.
function vector_cell(values) {
  return values.some((value) => value === undefined) ? ['not given']
    : values.map((value) => el('small', 'coordinate', Number.isFinite(value) ? signed_amount(value, 9) : String(value)));
}

// As fuzz/record/motion_tally.h tells it: in ulps up to 2^13 of them, else of the way and as a length.
function time_error_text({ulps, share, length}) {
  if (typeof ulps === 'number' && ulps <= 8192) return `${amount(ulps)} ulps`;
  return `${share < 1e-3 ? amount(share, 3) : `${amount(100 * share, 3)} %`} of the way, length ${amount(length, 3)}`;
}

function time_judged({time, ulps, share, length, tunnel, gap}) {
  const parts = [];
  if (ulps !== null && ulps !== undefined) parts.push(`by ${time_error_text({ulps, share, length})}`);
  if (tunnel !== null && tunnel !== undefined) parts.push(`tunnel ${error_amount(tunnel)}`);
  if (gap !== null && gap !== undefined) parts.push(`gap ${amount(gap, 6)} of the scene`);
  const [words, kind] = time_chips[time] ?? [];
  return [...(words === undefined ? [] : [chip(words, kind), ' ']), parts.join('; ')];
}

// Rows of [what, given, exact, judged], each but the first a list of nodes.
function contact_rows(witness) {
  const {measures, first_contact: exact, precision} = witness;
  const given = measures?.given ?? {};
  const says = (name) => given[name] !== undefined;
  const has_contact = Boolean(exact?.time);
  const no_exact = [exact === undefined ? 'not in this record' : has_contact ? 'none' : 'no contact'];
  const off = (amount_off, unit) => (amount_off === null || amount_off === undefined ? ['not judged'] : [`off by ${amount(amount_off, 4)} ${unit}`]);
  const vector = (name) => ['x', 'y', 'z'].map((axis) => (says(`${name}_${axis}`) ? parse_hex(given[`${name}_${axis}`]) : undefined));
  const is_missed = witness.truth === 'contact' && witness.computed === 'separated';
  const is_phantom = witness.truth === 'separated' && witness.computed === 'contact';
  const said = is_missed ? [chip('missed contact', 'bad'), ` tunnel ${error_amount(measures?.tunnel ?? 0)}`]
    : is_phantom ? [chip('phantom contact', 'warn')] : time_judged(measures ?? {});
  const part = says('feature') ? page_predicate_of(witness).parts?.[parse_hex(given.feature)] : undefined;
  const right = measures?.feature_is_right;
  const rows = [['time', says('time') ? number_cell(given.time, precision) : [is_missed ? 'no contact' : 'not given'],
                 has_contact ? number_cell(exact.time, precision) : no_exact, said]];
  rows.push(['feature', [says('feature') ? part === undefined ? 'none' : part_words(part) : 'not given'],
             exact?.features ? [exact.features.map(part_words).join(', ')] : no_exact,
             right === true ? [chip('right', 'good')] : right === false ? [chip('wrong', 'bad')] : ['not judged']]);
  rows.push(['normal', vector_cell(vector('normal')), exact?.normal ? vector_cell(exact.normal) : no_exact, off(measures?.normal_angle, 'radians')]);
  rows.push(['point', vector_cell(vector('point')), exact?.point ? vector_cell(exact.point) : no_exact, off(measures?.point_error, 'of the scene')]);
  return rows;
}

// Empty for a predicate without times.
function contact_table(witness) {
  if (witness.measures === undefined && witness.first_contact === undefined) return '';
  if (!witness.measures && !witness.first_contact) {
    return el('p', 'empty', `First contact: none${witness.truth === 'invalid' ? ', because the query is invalid' : ' in this record'}.`);
  }
  const head = el('tr', '', ...['', 'the kernel', 'exact', 'judged'].map((name) => el('th', '', name)));
  const body = contact_rows(witness).map(([name, ...cells]) =>
    el('tr', '', el('th', '', name), ...cells.map((nodes) => el('td', '', ...nodes))));
  const start = witness.first_contact ? ` Before the motion: ${witness.first_contact.start}.` : '';
  return scroll_table(`First contact. The exact time is the best one, the greatest number of the precision that is not late.${start}`,
                      'contact', el('thead', '', head), el('tbody', '', ...body));
}
