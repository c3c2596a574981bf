// Heat tables: comparisons and axes against families. A cell links to its witnesses.

const heat_steps = [1e-5, 1e-4, 1e-3, 1e-2, 1e-1];  // shares of the queries; the shade deepens at each

function heat_level(n, of) {
  if (n === 0 || of === 0) return 0;
  return 1 + heat_steps.filter((step) => n / of >= step).length;
}

function short_count(n) {
  for (const [unit, size] of [['M', 1e6], ['k', 1e3]]) if (n >= size) return `${Number((n / size).toPrecision(3))}${unit}`;
  return String(n);
}

// The record counts weight and kind separately, not their combinations: choosing one sets the other to all.
const heat_figures = [
  ['sign errors', (tally) => tally.judged === 0 ? null : tally.false_separation + tally.missed_separation, {}],
  ['decisive', (tally) => tally.decisive, {weight: 'decisive'}],
  ['masked', (tally) => tally.masked, {weight: 'masked'}],
  ['false_separation', (tally) => tally.false_separation, {kind: 'false_separation'}],
  ['missed_separation', (tally) => tally.missed_separation, {kind: 'missed_separation'}],
  ['tolerance failures', (tally) => tally.tolerance_failures, {tolerance: true}],
];

// A row of radio buttons, one for each of `options`; `change` is called with the index of the chosen one.
function toggle(label, options, change) {
  const group = el('fieldset', 'toggle', el('legend', '', label));
  const name = `toggle-${document.querySelectorAll('.toggle').length}-${label}`;
  options.forEach((text, i) => {
    const input = el('input');
    Object.assign(input, {type: 'radio', name, checked: i === 0});
    input.addEventListener('change', () => change(i));
    group.append(el('label', '', input, el('span', '', text)));
  });
  return group;
}

function heat_cell(data, {entry, family, result, name, tally, figure}) {
  const [label, of, filter] = figure;
  const n = of(tally);
  const cell = el('td', 'heat');
  if (n === null) {
    cell.append('·');
    cell.title = 'not checked: ' + (filter.tolerance ? 'no tolerance was given'
      : result.verdict.decided > 0 ? 'no decided answer had comparisons' : 'no query was decided');
    return cell;
  }
  const {trials, truth, verdict, base_triangles} = result;
  const looked_at = filter.tolerance ? trials - truth.invalid - (verdict.outside_limits?.trials ?? 0) : tally.judged;
  // As zero_limits: queries that share a triangle are not independent.
  const limit = n > 0 ? `(${amount(1e6 * n / looked_at, 3)} per million)`
    : `(< ${amount(-1e6 * Math.expm1(Math.log(0.05) / Math.min(base_triangles, looked_at)), 3)} per million, 95 %)`;
  const words = `${name} on ${family ?? 'all families'}: ${label} ${count(n)} of ${count(looked_at)} ${limit}`;
  cell.classList.add(`heat-${heat_level(n, looked_at)}`);
  if (n === 0 || filter.tolerance) {
    cell.append(n === 0 ? '0' : short_count(n));
    cell.title = words;
    return cell;
  }
  const button = el('button', '', short_count(n));
  button.type = 'button';
  button.title = words;
  button.setAttribute('aria-label', `${words}; show witnesses`);
  button.addEventListener('click', () => choose_witnesses({
    kernel: entry_name(entry), family: family ?? '', place: name, ...filter}));
  cell.append(button);
  return cell;
}

// Rows of a heat table: all families together where there is such a row, then the families under their headings.
function heat_rows(data, families, columns, cells_of) {
  return by_group(data, families, ([family]) => family ?? '').flatMap(([heading, some]) => [
    ...(heading === '' ? [] : [heading_row(heading, columns + 1)]),
    ...some.map(([family, result]) => {
      const th = el('th', '', el('span', 'name', family ?? 'all families'));
      th.scope = 'row';
      return el('tr', family === null ? 'total' : '', th, ...cells_of(family, result));
    })]);
}

function heat_head(corner, names) {
  return el('thead', '', el('tr', '', el('th', '', corner), ...names.map((name) => {
    const th = el('th', '', breakable(name, names.length > 7 ? /(?<=[._])/ : /(?<=[.])/));
    th.scope = 'col';
    return th;
  })));
}

const heat_columns = 16;  // that fit side by side

function heat_tables(data, entry, level, figure) {
  const names = Object.keys(entry.all[level]), parts = parts_of(names, heat_columns);
  const rows = [[null, entry.all], ...Object.entries(entry.families)];
  return parts.map((part, i) => {
    const body = heat_rows(data, rows, part.length, (family, result) => part.map((name) =>
      heat_cell(data, {entry, family, result, name, tally: result[level][name], figure})));
    const caption = `${names.length} ${level} by family: ${figure[0]}, ${entry_name(entry)}${parts.length > 1 ? `, ${i + 1} of ${parts.length}` : ''}`;
    return scroll_table(caption, 'heat-table', heat_head('family', part), el('tbody', '', ...body));
  });
}

function heat_legend() {
  const words = ['none', '< 10 per million', '10 to 100', '100 to 1,000', '0.1 % to 1 %', '1 % to 10 %', '10 % and more'];
  return el('p', 'legend', 'Share of the queries: ', ...words.map((text, i) => el('span', `heat-${i}`, text)));
}

function show_heat(data) {
  const place = document.getElementById('heat-tables');
  const shown = data.kernels.filter((entry) => entry.all !== null && entry.all.comparisons !== null);
  const silent = data.kernels.filter((entry) => entry.all?.comparisons === null);
  if (silent.length > 0) {
    const with_classes = silent.filter(({classes}) => classes !== null);  // a kernel with a reference has none
    document.getElementById('heat').append(
      el('p', 'lead', `${silent.map(entry_name).join('; ')}: only verdicts are shown, so no comparison can be named.` +
                      (with_classes.length > 0 ? ' By the class of the input:' : '')),
      ...with_classes.map((entry) => class_heat_table(data, entry)));
  }
  if (shown.length === 0) return;
  let entry = shown[0];
  let figure = heat_figures[0];
  const show = () => place.replaceChildren(...heat_tables(data, entry, 'comparisons', figure), heat_legend(),
                                           ...heat_tables(data, entry, 'axes', figure));
  document.getElementById('heat-controls').append(
    choice('Kernel', shown.map(entry_name), (index) => { entry = shown[index]; show(); }),
    toggle('Count', heat_figures.map(([label]) => label), (index) => { figure = heat_figures[index]; show(); }));
  show();
}
