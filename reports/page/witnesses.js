// Witness cards: closed, in the order of reports/formats/witness_order.h; each is filled when it is opened.

const kind_words = {
  false_separation: 'missed contact', false_contact: 'phantom contact', missed_separation: 'missed separation',
};

function inputs_table(witness) {
  const groups = page_predicate_of(witness).groups_of(witness);
  const body = el('tbody', '', ...groups.map((group) => {
    const [hex, decimal] = [[witness[group]].flat(), [witness.decimal[group]].flat()];
    const tr = el('tr', '', el('th', '', hex.length === 1 ? group : group.toUpperCase()));
    hex.forEach((value, i) => tr.append(el('td', 'n', el('code', '', decimal[i]), el('small', '', value))));
    return tr;
  }));
  return el('div', 'scroll', el('table', 'inputs', el('caption', '', 'Inputs, decimal and hex'), body));
}

const bits_at_once = 16;

// The bits of the comparisons under their names, exact above computed; `clauses` has the axis of each.
function bits_table(witness, clauses) {
  if (witness.exact_comparisons === null || witness.computed_comparisons === null) {
    return el('p', 'empty', 'Comparisons: not exposed, or none on an invalid query.');
  }
  const differs = (i) => witness.exact_comparisons[i] !== witness.computed_comparisons[i];
  const every = Object.entries(clauses).map(([name, axis], i) => ({name, axis, i}));
  const differing = every.filter(({i}) => differs(i));
  const all = every.length <= bits_at_once ? every : differing.slice(0, bits_at_once);
  if (all.length === 0) return el('p', 'empty', `Comparisons: all ${every.length} are as in exact arithmetic.`);
  const axes = el('tr', 'groups', el('th'));
  const kinds = el('tr', '', el('th'));
  const line = ([label, bits]) => el('tr', '', el('th', '', label),
    ...all.map(({i}) => el('td', differs(i) ? 'bit bad' : 'bit', bits[i])));
  const lines = [['exact', witness.exact_comparisons], ['computed', witness.computed_comparisons]].map(line);
  const marks = el('tr', 'marks', el('th', '', 'differs'));
  all.forEach(({name, axis, i}, at) => {
    if (at === 0 || all[at - 1].axis !== axis) {
      const th = el('th', 'group', axis);
      th.colSpan = all.filter((other) => other.axis === axis).length;
      axes.append(th);
    }
    kinds.append(el('th', 'bit', name.startsWith(`${axis}.`) ? name.slice(axis.length + 1) : name));
    marks.append(el('td', 'bit', differs(i) ? '≠' : ''));
  });
  return el('div', 'scroll', el('table', 'bits', el('caption', '', 'Comparisons: the kernel\'s own formulae in exact ' +
    'arithmetic, and as computed' + (all.length < every.length ? `; ${all.length} of the ${differing.length} that differ, of ${every.length}` : '')), el('thead', '', axes, kinds), el('tbody', '', ...lines, marks)));
}

function computed_side(text) {
  const value = parse_hex(text);
  return el('td', 'n', el('code', '', text), el('small', '', Number.isNaN(value) ? '' : String(value)));
}

function error_text(error) { return error === null ? 'none' : error_amount(error); }

// Exact and computed sides of the comparisons that matter for this witness.
function sides_table(witness) {
  if (witness.sides === undefined) return el('p', 'empty', 'Sides: this record was made by a version that did not keep them.');
  if (witness.sides === null) return el('p', 'empty', 'Sides: none, because the query is invalid or the kernel has no formulae of its own.');
  const rows = Object.entries(witness.sides);
  if (rows.length === 0) return el('p', 'empty', 'Sides: no comparison differs here.');
  const hidden = 'not shown';
  const body = rows.flatMap(([name, {exact, computed, lhs_ulps, rhs_ulps, error_u}]) => {
    const th = el('th', '', el('span', 'name', name));
    th.rowSpan = 2;
    const exact_cell = (text) => el('td', 'n', el('code', '', text));
    const margin = computed === null ? NaN : parse_hex(computed.lhs) - parse_hex(computed.rhs);
    return [
      el('tr', '', th, el('td', '', 'exact'), ...(exact === null ? [0, 1, 2].map(() => el('td', 'n', 'undefined'))
        : [exact_cell(exact.lhs), exact_cell(exact.rhs), exact_cell(exact.margin)]), el('td'), el('td'), el('td')),
      el('tr', 'second', el('td', '', 'computed'), ...(computed === null ? [0, 1, 2].map(() => el('td', 'n', hidden))
        : [computed_side(computed.lhs), computed_side(computed.rhs),
           el('td', 'n', Number.isNaN(margin) ? 'not finite' : String(margin))]),
         ...[lhs_ulps, rhs_ulps, error_u].map((error) => el('td', 'n', error_text(error)))),
    ];
  });
  const head = el('tr', '', ...['comparison', '', 'lhs', 'rhs', 'margin lhs − rhs', 'lhs off, ulps', 'rhs off, ulps', 'error, u']
    .map((name, i) => el('th', i > 1 ? 'n' : '', name)));
  return el('div', 'scroll', el('table', 'sides', el('caption', '', 'Sides: exact to 17 digits; the computed margin is ' +
    'their difference, rounded to binary64'), el('thead', '', head), el('tbody', '', ...body)));
}

function flips_table(witness) {
  if (witness.flips.length === 0) return el('p', 'empty', 'No flip: kept as an extreme.');
  const body = el('tbody', '', ...witness.flips.map((flip) => el('tr', '',
    el('td', '', flip.level), el('td', '', el('span', 'name', flip.name)), el('td', '', flip.kind),
    el('td', '', flip.level === 'verdict' ? '' : flip.decisive ? 'decisive' : 'masked'),
    el('td', '', el('span', 'chips', ...flip.links.map((link) => chip(link, `link-${link}`)))))));
  const head = el('tr', '', ...['level', 'name', 'kind', 'weight', 'broken links'].map((name) => el('th', '', name)));
  return el('div', 'scroll', el('table', 'flips', el('caption', '', 'Flips'), el('thead', '', head), body));
}

function verdict_flip(witness) { return witness.flips.find((flip) => flip.level === 'verdict'); }

function witness_body(witness, clauses) {
  const facts = el('dl', 'facts');
  const fact = (label, text) => facts.append(el('dt', '', label), el('dd', '', text));
  fact('truth', witness.truth + (witness.touching ? ', touching' : ''));
  fact('computed', witness.computed);
  fact('depth', witness.depth === null ? 'none: the verdict is right' : depth_text(witness));
  fact('address', el('code', '', witness.address));
  fact('kept for', witness.shows.join('; '));
  return el('div', 'body',
    el('div', 'columns', scene_figure(witness), el('div', 'stack', facts, inputs_table(witness))),
    contact_table(witness), sides_table(witness), bits_table(witness, clauses), flips_table(witness),
    el('p', 'label', 'Reproduce it and judge it'), command(witness.command), snippets(witness));
}

// A wrong verdict's share of the scene and, on an everyday scene and on one's own queries, its length.
function depth_text({depth, length_text}, digits) {
  return `${amount(depth, digits)} of the scene${length_text ? `, ${length_text}` : ''}`;
}

// How deep a wrong verdict is, or how deep the sphere goes in until a late time.
function depth_words(witness) {
  const {depth, measures} = witness;
  if (depth !== null) return depth_text(witness, 4);
  return measures?.tunnel ? `tunnel ${error_amount(measures.tunnel)}` : '';
}

function witness_card(witness, clauses) {
  const verdict = verdict_flip(witness);
  const title = verdict ? kind_words[verdict.kind] : 'verdict right';
  const card = el('details', 'witness', el('summary', '',
    el('span', 'name id', witness.id),
    chip(title, !verdict ? 'good' : verdict.kind === 'false_separation' ? 'bad' : 'warn'),
    contact_chip(witness),
    el('span', '', el('span', 'name', witness.kernel), `, ${witness.precision}`),
    el('span', 'name', witness.family),
    witness.class ? chip(witness.class) : '',
    el('span', 'chips', ...(verdict?.links ?? []).map((link) => chip(link, `link-${link}`))),
    el('span', 'depth', depth_words(witness))));
  card.id = `witness-${witness.id}`;
  card.addEventListener('toggle', () => {
    if (card.open && card.children.length === 1) card.append(witness_body(witness, clauses));
  });
  return card;
}

// Whether a witness shows what a cell of the heat table counts.
function shows(witness, {kernel, family, place, weight, kind, verdict, time}) {
  if (kernel && `${witness.kernel}, ${witness.precision}` !== kernel) return false;
  if (family && witness.family !== family) return false;
  if (verdict && (verdict_flip(witness)?.kind ?? 'right') !== verdict) return false;
  if (time && (witness.measures?.time ?? '') !== time) return false;
  if (!place) return true;
  return witness.flips.some((flip) => flip.name === place && (!kind || flip.kind === kind) &&
    (!weight || flip.decisive === (weight === 'decisive')));
}

const witness_page = 40;  // cards made at a time

// Set by show_witnesses: shows the witnesses that pass a filter.
let choose_witnesses = () => {};

function show_witnesses(data) {
  const {total, cards} = data.witnesses;
  const clauses = data.comparisons;
  const left_out = total - cards.length;
  document.getElementById('witnesses-count').textContent = total === 0 ? 'None were kept.'
    : `${count(cards.length)} of ${count(total)} are in this file: first the shortest of each cause and class of input, then the deepest; ordinary ` +
      'numbers before exotic ones. ' +
      (left_out > 0 ? `${count(left_out)} are left out for its size: the deepest of each kernel, family and kind stay, and one for each ` +
        'place of a flip. ' : '') + `witnesses.jsonl next to it has all ${count(total)}, as a query file.`;
  const list = document.getElementById('witnesses-list');
  const said = document.getElementById('witnesses-shown');
  const more = document.getElementById('witnesses-more');
  const some = (key) => [...new Set(cards.map(key))].sort();
  const options = {
    kernel: some((witness) => `${witness.kernel}, ${witness.precision}`), family: some((witness) => witness.family),
    verdict: ['false_separation', 'false_contact', 'right'],
    place: [...new Set(Object.values(clauses)), ...Object.keys(clauses)],
    time: Object.keys(time_chips),
  };
  const has_times = cards.some((witness) => witness.measures?.tunnel !== undefined);
  const labels = {kernel: 'Kernel', family: 'Family', verdict: 'Verdict', place: 'Flip at', ...(has_times ? {time: 'Time'} : {})};
  const words = (key, value) => (key === 'verdict' ? kind_words[value] ?? 'right' : key === 'time' ? time_chips[value][0] : value);
  let filter = {};
  let matching = [];
  let made = 0;
  const selects = {};
  const grow = (to) => {
    list.append(...matching.slice(made, to).map((witness) => witness_card(witness, clauses)));
    made = Math.min(to, matching.length);
    more.hidden = made >= matching.length;
    more.textContent = `Show more: ${count(matching.length - made)} left`;
  };
  const refresh = () => {
    matching = cards.filter((witness) => shows(witness, filter));
    const extra = [filter.weight, filter.kind].filter(Boolean).map((word) => `, ${word}`).join('');
    said.textContent = total === 0 ? '' : `${count(matching.length)} match${extra}.` +
      (matching.length === 0 && left_out > 0 ? ' Others may be among those left out: see witnesses.jsonl.' : '');
    list.replaceChildren();
    made = 0;
    grow(witness_page);
  };
  const fit = () => {
    for (const [key, label] of Object.entries(selects)) {
      label.querySelector('select').selectedIndex = filter[key] ? 1 + options[key].indexOf(filter[key]) : 0;
    }
  };
  for (const [key, label] of Object.entries(labels)) {
    selects[key] = choice(label, ['all', ...options[key].map((value) => words(key, value))], (index) => {
      const {weight, kind, ...rest} = filter;  // belongs to one cell; dropped with the next choice
      filter = {...rest, [key]: index === 0 ? '' : options[key][index - 1]};
      refresh();
    });
  }
  if (cards.length > 1) document.getElementById('witnesses-controls').append(...Object.values(selects));
  more.addEventListener('click', () => grow(made + witness_page));
  choose_witnesses = (wanted) => {
    filter = wanted;
    fit();
    refresh();
    document.getElementById('witnesses').scrollIntoView();
    const first = list.querySelector('details');
    if (first) {
      first.open = true;
      first.querySelector('summary').focus({preventScroll: true});
    }
  };
  refresh();
  // A link to a witness opens it, whatever the filter.
  const open = () => {
    let id = location.hash.slice(1);
    try {
      id = decodeURIComponent(id);
    } catch {
      return;  // not a link to a witness
    }
    const place = cards.findIndex((witness) => `witness-${witness.id}` === id);
    if (place < 0) return;
    if (!document.getElementById(id)) {
      filter = {};
      fit();
      refresh();
      grow(place + 1);
    }
    const card = document.getElementById(id);
    card.open = true;
    card.scrollIntoView();
  };
  window.addEventListener('hashchange', open);
  open();
}
