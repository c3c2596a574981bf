// What a kernel gave beside its verdict, on the card of a witness: what is exact, and how it is judged. Of a predicate of motions it is the first contact.

const time_chips = {late: ['late', 'bad'], early: ['early', 'note'], best: ['best time', 'good'], none: ['no time', 'bad'],
                    invalid: ['time outside [0, 1]', 'bad']};

const contradictions = {positive: 'contact with a separation above 0', negative: 'separated with a separation below 0', missing: 'a number is not given'};

function contact_chip(witness) {
  const measures = witness.measures ?? {};
  const [words, kind] = time_chips[measures.time] ?? [];
  if (words !== undefined) return chip(words, kind);
  if (measures.is_flip) return chip('normal flipped', 'bad');
  return contradictions[measures.consistency] ? chip('contradicts itself', 'bad') : '';
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

// As fuzz/record/contact_tally.h tells it: in ulps up to 2^13 of them, else of the way and as a length.
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

// What was wrong with a time, or why there is none to judge.
function time_row(witness, given, exact, no_exact) {
  const is_missed = witness.truth === 'contact' && witness.computed === 'separated';
  const is_phantom = witness.truth === 'separated' && witness.computed === 'contact';
  const measures = witness.measures ?? {};
  const said = is_missed ? [chip('missed contact', 'bad'), ` tunnel ${error_amount(measures.tunnel ?? 0)}`]
    : is_phantom ? [chip('phantom contact', 'warn')] : time_judged(measures);
  return ['time', given.time !== undefined ? number_cell(given.time, witness.precision) : [is_missed ? 'no contact' : 'not given'],
          exact?.time ? number_cell(exact.time, witness.precision) : no_exact, said];
}

function separation_row(witness, given, exact, no_exact) {
  const {separation_error: error, separation_length: length, separation_ulps: ulps, consistency} = witness.measures ?? {};
  const judged = [];
  if (contradictions[consistency]) judged.push(chip(contradictions[consistency], 'bad'), ' ');
  if (typeof error === 'number') judged.push(`off by ${amount(error, 4)} of the scene, length ${amount(length, 4)}, ${error_amount(ulps)} ulps`);
  return ['separation', given.separation !== undefined ? number_cell(given.separation, witness.precision) : ['not given'],
          exact?.separation !== undefined ? [signed_amount(exact.separation, 17)] : no_exact, judged.length > 0 ? judged : ['not judged']];
}

// Rows of [what, given, exact, judged], each but the first a list of nodes.
function contact_rows(witness) {
  const {measures, exact_contact: exact} = witness;
  const given = measures?.given ?? {};
  const moves = exact?.start !== undefined || measures?.tunnel !== undefined;
  const has_place = !moves || Boolean(exact?.time);
  const no_exact = [exact === undefined ? 'not in this record' : has_place ? 'none' : 'no contact'];
  const is_number = (amount_off) => amount_off !== null && amount_off !== undefined;
  const off = (amount_off, unit) => (is_number(amount_off) ? `off by ${amount(amount_off, 4)} ${unit}` : '');
  const judged = (...texts) => [texts.filter((text) => text !== '').join('; ') || 'not judged'];
  const vector = (name) => ['x', 'y', 'z'].map((axis) => {
    const hex = given[`${name}_${axis}`];
    return hex === undefined ? undefined : parse_hex(hex);
  });
  const rows = [moves ? time_row(witness, given, exact, no_exact) : separation_row(witness, given, exact, no_exact)];
  const has_feature = moves || measures?.feature_is_right !== undefined || exact?.features !== undefined;
  if (has_feature) {
    const part = given.feature !== undefined ? page_predicate_of(witness).parts?.[parse_hex(given.feature)] : undefined;
    const right = measures?.feature_is_right;
    rows.push(['feature', [given.feature !== undefined ? part === undefined ? 'none' : part_words(part) : 'not given'],
               exact?.features ? [exact.features.map(part_words).join(', ')] : no_exact,
               right === true ? [chip('right', 'good')] : right === false ? [chip('wrong', 'bad')] : ['not judged']]);
  }
  const left = is_number(measures?.left) ? `${error_amount(measures.left)} of the depth is left along it` : '';
  const turned = judged(off(measures?.normal_angle, 'radians'), left);
  rows.push(['normal', vector_cell(vector('normal')), exact?.normal ? vector_cell(exact.normal) : no_exact,
             measures?.is_flip ? [chip('flipped', 'bad'), ' ', ...turned] : turned]);
  for (const [name, error] of [['point', 'point_error'], ['point_a', 'point_a_error'], ['point_b', 'point_b_error']]) {
    const is_pair = measures?.point_b_error !== undefined;
    if (is_pair === (name === 'point')) continue;
    const place = exact?.[name === 'point_a' ? 'point' : name];
    rows.push([name.replace('_', ' '), vector_cell(vector(name)), place ? vector_cell(place) : no_exact, judged(off(measures?.[error], 'of the scene'))]);
  }
  return rows;
}

// Empty for a kernel that says nothing beside its verdicts.
function contact_table(witness) {
  if (witness.measures === undefined && witness.exact_contact === undefined) return '';
  const moves = witness.exact_contact?.start !== undefined || witness.measures?.tunnel !== undefined;
  if (!witness.measures && !witness.exact_contact) {
    return el('p', 'empty', `Contact: none${witness.truth === 'invalid' ? ', because the query is invalid' : ' in this record'}.`);
  }
  const head = el('tr', '', ...['', 'the kernel', 'exact', 'judged'].map((name) => el('th', '', name)));
  const body = contact_rows(witness).map(([name, ...cells]) =>
    el('tr', '', el('th', '', name), ...cells.map((nodes) => el('td', '', ...nodes))));
  const start = moves && witness.exact_contact ? ` Before the motion: ${witness.exact_contact.start}.` : '';
  const caption = moves ? `First contact. The exact time is the best one, the greatest number of the precision that is not late.${start}`
    : 'Contact. The separation is the distance where the two are apart, less their penetration where not.';
  return scroll_table(caption, 'contact', el('thead', '', head), el('tbody', '', ...body));
}
