// Witness cards: closed, the deepest first.

const kind_words = {
  false_separation: 'missed contact', false_contact: 'phantom contact', missed_separation: 'missed separation',
};

function inputs_table(witness) {
  const points = ['a', 'b', 'c', 'p'].map((member) => [member.toUpperCase(), witness[member], witness.decimal[member]]);
  const rows = [...points, ['r', [witness.r], [witness.decimal.r]]];
  const body = el('tbody', '', ...rows.map(([name, hex, decimal]) => {
    const tr = el('tr', '', el('th', '', name));
    hex.forEach((value, i) => tr.append(el('td', 'n', el('code', '', value), el('small', '', decimal[i]))));
    return tr;
  }));
  return el('div', 'scroll', el('table', 'inputs', el('caption', '', 'Inputs, hex and decimal'), body));
}

// The sixteen bits under their names, exact over computed.
function bits_table(witness, names) {
  if (witness.exact_comparisons === null || witness.computed_comparisons === null) {
    return el('p', 'empty', 'Comparisons: not exposed, or none on an invalid query.');
  }
  const axes = el('tr', 'groups', el('th'));
  const kinds = el('tr', '', el('th'));
  const line = ([label, bits]) => {
    const tr = el('tr', '', el('th', '', label));
    tr.append(...[...bits].map((bit, i) => {
      const differs = witness.exact_comparisons[i] !== witness.computed_comparisons[i];
      return el('td', differs ? 'bit bad' : 'bit', bit);
    }));
    return tr;
  };
  const lines = [['exact', witness.exact_comparisons], ['computed', witness.computed_comparisons]].map(line);
  const marks = el('tr', 'marks', el('th', '', 'differs'));
  names.forEach((name, i) => {
    const [axis, kind] = name.split('.');
    if (kind === 'radius') {
      const th = el('th', 'group', axis);
      th.colSpan = names.filter((other) => other.startsWith(`${axis}.`)).length;
      axes.append(th);
    }
    kinds.append(el('th', 'bit', kind));
    marks.append(el('td', 'bit', witness.exact_comparisons[i] === witness.computed_comparisons[i] ? '' : '≠'));
  });
  return el('div', 'scroll', el('table', 'bits', el('caption', '', 'Comparisons: the kernel\'s own formulae in exact ' +
    'arithmetic, and what it computed'), el('thead', '', axes, kinds), el('tbody', '', ...lines, marks)));
}

function flips_table(witness) {
  if (witness.flips.length === 0) return el('p', 'empty', 'No flip: kept for an extreme.');
  const body = el('tbody', '', ...witness.flips.map((flip) => el('tr', '',
    el('td', '', flip.level), el('td', '', el('span', 'name', flip.name)), el('td', '', flip.kind),
    el('td', '', flip.level === 'verdict' ? '' : flip.decisive ? 'decisive' : 'masked'),
    el('td', '', el('span', 'chips', ...flip.links.map((link) => chip(link, `link-${link}`)))))));
  const head = el('tr', '', ...['level', 'name', 'kind', 'weight', 'broken links'].map((name) => el('th', '', name)));
  return el('div', 'scroll', el('table', 'flips', el('caption', '', 'Flips'), el('thead', '', head), body));
}

function witness_card(witness, names) {
  const verdict = witness.flips.find((flip) => flip.level === 'verdict');
  const title = verdict ? kind_words[verdict.kind] : 'verdict right';
  const card = el('details', 'witness', el('summary', '',
    el('span', 'name id', witness.id),
    chip(title, !verdict ? 'good' : verdict.kind === 'false_separation' ? 'bad' : 'warn'),
    el('span', '', el('span', 'name', witness.kernel), `, ${witness.precision}`),
    el('span', 'name', witness.family),
    el('span', 'chips', ...(verdict?.links ?? []).map((link) => chip(link, `link-${link}`))),
    el('span', 'depth', witness.depth === null ? '' : `depth ${amount(witness.depth, 4)}`)));
  card.id = `witness-${witness.id}`;
  const facts = el('dl', 'facts');
  const fact = (label, text) => facts.append(el('dt', '', label), el('dd', '', text));
  fact('truth', witness.truth + (witness.touching ? ', touching' : ''));
  fact('computed', witness.computed);
  fact('depth', witness.depth === null ? 'none: the verdict is right' : String(witness.depth));
  fact('address', el('code', '', witness.address));
  fact('kept for', witness.shows.join('; '));
  card.append(el('div', 'body', el('div', 'columns', inputs_table(witness), facts), bits_table(witness, names),
                 flips_table(witness), el('p', 'label', 'Make it again and judge it'), command(witness.command)));
  return card;
}

// Choices that hide the other cards.
function witness_filters(shown) {
  const kernel_of = (witness) => `${witness.kernel}, ${witness.precision}`;
  const kernels = [...new Set(shown.map(({witness}) => kernel_of(witness)))];
  const families = [...new Set(shown.map(({witness}) => witness.family))].sort();
  let kernel = 0;
  let family = 0;
  const filter = () => shown.forEach(({witness, card}) => {
    card.hidden = (kernel > 0 && kernel_of(witness) !== kernels[kernel - 1]) ||
                  (family > 0 && witness.family !== families[family - 1]);
  });
  return [choice('Kernel', ['all kernels', ...kernels], (index) => { kernel = index; filter(); }),
          choice('Family', ['all families', ...families], (index) => { family = index; filter(); })];
}

function show_witnesses(data) {
  const {total, cards} = data.witnesses;
  document.getElementById('witnesses-count').textContent = total === 0
    ? 'None were kept.'
    : `${count(cards.length)} of ${count(total)} shown: the deepest of each kernel, family and kind, deepest first. ` +
      `witnesses.jsonl has all ${count(total)}, as a query file.`;
  const names = Object.keys(data.notes.comparisons);
  const shown = cards.map((witness) => ({witness, card: witness_card(witness, names)}));
  document.getElementById('witnesses-list').append(...shown.map(({card}) => card));
  if (cards.length > 1) document.getElementById('witnesses-controls').append(...witness_filters(shown));
  // A link to a witness opens it.
  const open = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target?.tagName !== 'DETAILS') return;
    target.hidden = false;
    target.open = true;
  };
  window.addEventListener('hashchange', open);
  open();
}
