// Why a kernel is wrong whose links do not say it: its wrong verdicts by the class of the input.

function class_link(data, entry, address) {
  const shown = data.witnesses.cards.find((witness) => witness.address === address && witness.kernel === entry.id);
  return shown ? witness_link(data, shown.id) : el('code', '', address);
}

function classes_table(data, entry) {
  return table(`Wrong verdicts by the class of the input, ${entry_name(entry)}`, [
    column.text('class', (row) => row.class, {cell: (th, value) => th.append(el('span', 'name', value))}),
    column.text('what it says', (row) => row.meaning, {cell: (td, value) => {
      td.classList.add('prose');
      td.append(value);
    }}),
    column.count('missed contacts', (row) => row.missed, {alarm: 'bad'}),
    column.count('phantom contacts', (row) => row.phantom, {alarm: 'warn'}),
    column.amount('deepest', (row) => row.deepest, {digits: 4}),
    column.text('deepest on', (row) => row.family, {cell: (td, value) => td.append(el('span', 'name', value))}),
    column.text('deepest witness', (row) => row.witness,
                {cell: (td, value) => td.append(class_link(data, entry, value))}),
  ], entry.classes.rows);
}

// The table with the sentence about the nearest kernel.
function classes_box(data, entry) {
  if (entry.classes.rows.length === 0) {
    return el('p', 'lead', `${entry_name(entry)}: ${entry.decided > 0 ? `none of ${count(entry.decided)} verdicts is wrong` : 'it decided nothing'}.`);
  }
  const box = el('div', '', classes_table(data, entry));
  if (entry.classes.nearest !== '') box.append(el('p', 'lead', `${entry.classes.nearest}.`));
  return box;
}

// Classes against families, shaded like the heat tables: for a kernel without comparisons to show there.
function class_heat_table(data, entry) {
  const families = Object.entries(entry.families).filter(([, result]) => Object.keys(result.classes ?? {}).length > 0);
  if (families.length === 0) return el('p', 'empty', `${entry_name(entry)} shows only verdicts, and ${entry.decided > 0 ? 'none of them is wrong' : 'it gave none'}.`);
  const wrong = (tally) => (tally ? tally.false_separation + tally.false_contact : 0);
  const cell = (name, family, result) => {
    const n = wrong(result.classes[name]);
    const td = el('td', `heat heat-${heat_level(n, result.trials - result.truth.invalid)}`, n === 0 ? '0' : short_count(n));
    td.title = `${name} on ${family}: ${count(n)} wrong verdicts of ${count(result.trials - result.truth.invalid)}` +
      (n === 0 ? '' : `, deepest ${amount(result.classes[name].deepest, 4)} of the scene`);
    return td;
  };
  const names = entry.classes.rows.map((row) => row.class);
  const body = heat_rows(data, families, names.length, (family, result) => names.map((name) => cell(name, family, result)));
  const caption = `Classes of input by family: wrong verdicts, ${entry_name(entry)}`;
  return scroll_table(caption, 'heat-table', heat_head('family', names), el('tbody', '', ...body));
}

// How far the verdicts of a kernel without sides are off: the deepest of each class, as bars on a logarithmic scale.
function class_depths(data, entry) {
  if (entry.classes.rows.length === 0) return classes_box(data, entry);
  const depths = entry.classes.rows.map((row) => row.deepest);
  const scale = {...log_scale([1, ...depths]), end: 0};
  scale.low = Math.min(-1, Math.floor(Math.min(0, ...depths.filter((depth) => depth > 0).map(magnitude))));
  scale.at = (depth) => Math.max(0, 100 * (magnitude(depth) - scale.low) / -scale.low);
  const body = el('tbody', '', ...entry.classes.rows.map((row) => {
    const th = el('th', '', el('span', 'name', row.class));
    th.scope = 'row';
    const value = el('td', 'n', row.deepest === 0 ? el('span', 'zero', '0') : amount(row.deepest, 4));
    return el('tr', '', th, value, el('td', 'wide', log_bar({...scale, beyond: () => false}, row.deepest, null)),
              el('td', '', class_link(data, entry, row.witness)));
  }));
  const caption = `Depth of wrong verdicts, ${entry_name(entry)}`;
  const head = el('tr', '', el('th', '', 'input is'), el('th', 'n', 'deepest, share of the scene'),
                  el('th', 'wide', 'of the scene', log_ticks(scale)), el('th', '', 'witness'));
  return scroll_table(caption, 'bounds', el('thead', '', head), body);
}
