// What the page begins with: what came of each level, the worst wrong verdict drawn, and each kernel in a few sentences.

const state_kinds = {met: 'good', 'not met': 'bad', 'NOT CHECKED': 'warn'};

function levels_table(data) {
  const prose = {cell: (td, value) => { td.classList.add('prose'); td.append(value); }};
  const why = column.text('why', (row) => row.reason, {cell: (td, value, row) => {
    td.classList.add('prose');
    td.append(value);
    if (row.witness !== '') td.append(', witness ', witness_link(data, row.witness));
  }});
  return table(data.first.lead, [
    column.text('level', (row) => row.level, {cell: (th, value) => { th.classList.add('prose'); th.append(value); }}),
    column.text('kernel', (row) => row.kernel, {cell: (td, value, row) =>
      td.append(el('span', 'name', breakable(value)), el('small', '', row.precision))}),
    column.text('state', (row) => row.state, {cell: (td, value, row) =>
      td.append(chip(value, row.state === 'NOT CHECKED' && !row.allowed && data.requirement ? 'bad' : state_kinds[value]),
                row.allowed ? el('small', '', 'which is allowed') : '')}),
    column.text('looked at', (row) => row.looked_at.replace(' promised queries looked at', ' promised'), prose),
    ...(data.first.levels.some(({reason, witness}) => reason !== '' || witness !== '') ? [why] : []),
  ], data.first.levels);
}

const worst_headings = {everyday: 'The worst everyday scene', own: 'The worst of your own queries', exact: 'The deepest wrong verdict', other: 'The deepest wrong verdict'};

function worst_box(data) {
  const {worst} = data.first;
  if (worst === null) {
    const decided = data.kernels.some((entry) => entry.decided > 0);
    return el('div', '', el('h3', '', 'The worst'),
              el('p', 'empty', `${decided ? 'No verdict was wrong' : 'Nothing was decided'}: there is nothing to draw.`));
  }
  const witness = data.witnesses.cards.find(({id}) => id === worst.id);
  const words = el('p', '', el('span', 'name', worst.kernel), ` ${worst.precision} ${worst.words}. Family `, el('span', 'name', worst.family),
                   ', witness ', witness_link(data, worst.id), '.');
  const figure = witness ? scene_figure(witness) : '';
  return el('div', 'worst-box', el('h3', '', worst_headings[worst.group]), words, figure);
}

function sentences_list(data) {
  return data.kernels.flatMap((entry) => [el('h3', '', el('span', 'name', entry.id), ` ${entry.precision}`),
    el('ul', 'sentences', ...[entry.cause_text ?? [], entry.sentences].flat().map((sentence) => el('li', '', `${sentence[0].toUpperCase()}${sentence.slice(1)}.`)))]);
}

const kernels_at_once = 4;  // whose sentences are not folded

function show_first(data) {
  const sentences = sentences_list(data), shown = 2 * kernels_at_once;
  const more = sentences.slice(shown);
  document.getElementById('first').append(
    el('div', '', data.first.levels.length > 0 ? levels_table(data) : el('p', 'lead', data.first.lead), ...sentences.slice(0, shown),
       more.length > 0 ? el('details', '', el('summary', 'label', 'The other kernels'), ...more) : '', next_box(data)),
    worst_box(data));
}
