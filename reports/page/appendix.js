// League, mutants, the matrix of arithmetics, filter statistics, and the list of raw files.

function show_league(data) {
  const place = document.getElementById('league');
  const {league} = data.attached;
  if (league === null) return leave_out(place);
  const name = column.text('kernel', (row) => row.id, {cell: (th, value, row) => {
    th.append(el('span', 'name', value));
    th.title = row.summary ?? '';
  }});
  const precision = column.text('precision', (row) => row.precision);
  const wrong = (member, label, alarm) => [
    column.count(label, (row) => row[member], {alarm, group: label, none: 'not measured'}),
    column.amount('per million', (row) => (row[member] === null ? null : 1e6 * row[member] / row.decided), {digits: 3, group: label}),
    column.amount('deepest', (row) => row[`deepest_${member}`], {digits: 3, group: label})];
  const contenders = league.kernels.filter((row) => !row.has_planted_fault);
  const faults = league.kernels.filter((row) => row.has_planted_fault);
  place.append(table('League: all families together', [
    name, precision, column.count('decided', (row) => row.decided), ...wrong('false_separation', 'missed contacts', 'bad'),
    ...wrong('false_contact', 'phantom contacts', 'warn'), column.count('declined', (row) => row.undecided),
    column.count('invalid', (row) => row.invalid, {alarm: 'bad'}), column.count('no answer', (row) => row.unanswered, {alarm: 'bad'}),
    column.count('outside limits', (row) => row.outside_limits),
    column.amount('ns a query', (row) => row.ns, {digits: 3, none: 'not timed'})], contenders));
  if (faults.length > 0) {
    place.append(table('Planted faults: how soon each is caught', [
      name, precision, column.count('queries until caught', (row) => row.caught_after, {none: 'never'}),
      column.text('first by family', (row) => row.caught_by ?? 'none')], faults));
  }
}

function show_mutation(data) {
  const place = document.getElementById('mutation');
  const {mutation} = data.attached;
  if (mutation === null) return leave_out(place);
  const is_equivalent = (row) => Boolean(row.equivalent);
  // One sentence for each precision: in another precision a mutant is another kernel.
  const score = (rows) => {
    const real = rows.filter((row) => !is_equivalent(row));
    const caught = real.filter((row) => row.caught === true);
    if (real.length > 0 && real.every((row) => row.caught === null)) return `${count(real.length)} mutants not judged: no query was valid.`;
    return `${count(caught.length)} of ${count(real.length)} mutants caught; ${count(rows.length - real.length)} equivalent ones are not counted.`;
  };
  const precisions = [...new Set(mutation.mutants.map((row) => cell_words(row.precision)))];
  if (mutation.complete === false) place.append(el('p', '', chip('INCOMPLETE', 'warn'), ' It was interrupted: mutants that were not run yet count as not caught.'));
  place.append(...precisions.map((precision) => el('p', 'lead', precision === '' ? '' : `${precision}: `,
    score(mutation.mutants.filter((row) => cell_words(row.precision) === precision)))), table('Mutants', [
    column.text('mutant', (row) => cell_words(row.name), {cell: (th, value) => th.append(el('span', 'name', value))}),
    column.text('precision', (row) => cell_words(row.precision)),
    column.text('caught', (row) => (is_equivalent(row) ? 'equivalent' : {true: 'yes', false: 'no', null: 'not judged'}[row.caught]), {cell: (td, value) =>
      td.append(chip(value, {yes: 'good', no: 'bad'}[value]))}),
    column.text('first by family', (row) => cell_words(row.family)),
    column.count('after queries', (row) => (typeof row.queries === 'number' ? row.queries : null), {none: '-'}),
    column.text('why equivalent', (row) => (typeof row.equivalent === 'string' ? row.equivalent : ''), {cell: (td, value) => {
      td.classList.add('prose');
      td.append(value);
    }})], mutation.mutants));
  if (mutation.controls.length === 0) {
    place.append(el('p', 'empty', 'No controls in mutation.json: it did not check whether correct kernels pass.'));
    return;
  }
  place.append(table('Controls: correct kernels written in another way, none of which may be flagged', [
    column.text('kernel', (row) => cell_words(row.kernel), {cell: (th, value) => th.append(el('span', 'name', value))}),
    column.text('precision', (row) => cell_words(row.precision)), column.text('claims', (row) => cell_words(row.claims)),
    column.count('queries', (row) => row.queries), column.count('flagged', (row) => row.flagged, {alarm: 'bad', none: 'not judged'})], mutation.controls));
}

// The contraction or rounding of an arithmetic, by its name in `axiscert kernels`.
const contracted = {fma: 'dot and cross products', kahan: 'Kahan\'s products'};
const roundings = {up: 'toward +∞', down: 'toward −∞', chop: 'toward zero', spu: 'toward zero, flushed'};

function show_matrix(data) {
  const place = document.getElementById('matrix');
  const asked = data.kernels.filter((entry) => entry.all !== null && entry.formulae !== null);
  const target = data.target?.dispatched ?? 'not recorded';
  if (asked.length > 0) {
    const wrong = (member, alarm) => column.rate(member, (row) => row.all.verdict[member], (row) => row.all, {alarm});
    place.append(table('Wrong verdicts by instruction set, contraction and rounding', [
      column.text('kernel', (row) => row.id, {cell: (th, value) => th.append(el('span', 'name', value))}),
      column.text('precision', (row) => row.precision),
      column.text('formulae', (row) => row.formulae, {cell: (td, value) => td.append(el('span', 'name', value))}),
      column.text('instruction set', () => target),
      column.text('contraction', (row) => contracted[row.arithmetic] ?? 'none'),
      column.text('rounding', (row) => roundings[row.arithmetic] ?? 'to nearest'),
      column.text('arithmetic', (row) => row.arithmetic),
      wrong('false_separation', 'bad'), wrong('false_contact', 'warn')], asked));
  }
  place.append(el('p', 'lead', `One instruction set ran: ${target}. A kernel that equals its scalar reference has the same record on every ` +
    'other. ', el('code', '', '--target'), ' chooses one, ', el('code', '', '--kernel KERNEL+ARITHMETIC'), ' runs a kernel in another arithmetic.'));
}

// The record's files hold everything, including what the page has no room for.
function show_files(data) {
  document.getElementById('files').append(...data.files.map((file) => {
    const link = el('a', 'name', file.name);
    link.href = file.name;
    return el('li', '', link, `: ${file.meaning}`);
  }));
}

function show_filters(data) {
  const place = document.getElementById('filters');
  if (data.steps.length === 0) {
    place.append(el('p', 'empty', 'Not recorded: no run.json, or nothing was judged.'));
    return;
  }
  const names = Object.keys(data.steps[0].queries);
  const total = (row) => Object.values(row.queries).reduce((x, y) => x + y, 0);
  const nanoseconds = Object.keys(data.steps[0].nanoseconds_per_query);
  const family = column.text('family', (row) => row.family, {cell: (th, value, row) =>
    th.append(el('span', 'name', value), el('small', '', row.precision))});
  place.append(table('Queries decided by each step', [
    family,
    column.text('share of each step', (row) => row.queries[names[0]] / (total(row) || 1), {numeric: true, left: true, cell: (td, value, row) => {
      td.classList.add('wide');
      const bar = el('div', 'bar steps');
      bar.setAttribute('aria-hidden', 'true');
      names.forEach((name, i) => {
        if (row.queries[name] === 0) return;
        const part = el('span', `step-${i}`);
        part.style.flexGrow = String(row.queries[name] / total(row));
        part.title = `${name}: ${count(row.queries[name])}`;
        bar.append(part);
      });
      td.append(bar);
    }}),
    ...names.map((name) => column.count(name, (row) => row.queries[name], {group: 'queries decided by', may_go: true})),
    column.count('checked again', (row) => row.checked, {may_go: true}),
    column.count('by CGAL itself', (row) => row.decided_by_cgal, {may_go: true}),
  ], data.steps, grouped(data, data.steps)), el('details', '', el('summary', 'label', 'Time of each step'),
    table('Nanoseconds a query', [family, ...nanoseconds.map((name) =>
      column.amount(name, (row) => row.nanoseconds_per_query[name], {digits: 3, may_go: true}))], data.steps, grouped(data, data.steps))));
}

function show_appendix(data) {
  show_league(data);
  show_mutation(data);
  show_matrix(data);
  show_filters(data);
  show_files(data);
}
