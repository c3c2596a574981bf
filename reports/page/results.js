// Tables of all counts. A kernel entry is one kernel in one precision.

// One row for each family of each of these kernel entries.
function family_rows(entries) {
  return entries.flatMap((entry) =>
    Object.entries(entry.families).map(([family, result]) => ({entry, family, result})));
}

function grouped(data, rows) { return {groups: by_group(data, rows, (row) => row.family)}; }

// The kernel's column only where there is more than one.
function family_columns(rows) {
  const kernel = column.text('kernel', (row) => entry_name(row.entry), {cell: (td, value, row) =>
    td.append(el('span', 'name', row.entry.id), el('small', '', row.entry.precision))});
  return [
    column.text('family', (row) => row.family, {cell: (th, value) => th.append(el('span', 'name', value))}),
    ...(new Set(rows.map((row) => row.entry)).size > 1 ? [kernel] : []),
  ];
}

// Shares of the scene with the farthest length below, where the family's queries have a unit.
function depth_column(label, member, more) {
  return column.text(label, (row) => row.result.verdict[`deepest_${member}`], {numeric: true, ...more, cell: (td, value, row) => {
    td.append(value === null || (value === 0 && row.result.zero_limits[member] === null) ? '-' : amount(value, 4));
    td.title = String(value ?? '');
    if (value === 0) td.classList.add('zero');
    if (row.result.lengths[member]) td.append(el('small', '', row.result.lengths[member]));
  }});
}

function families_table(data, rows) {
  const {truth, verdict, family} = data.notes;
  const truth_count = (member) =>
    column.count(member, (row) => row.result.truth[member], {group: 'truth', note: truth[member], may_go: true});
  const wrong = (member, group, alarm) => [
    column.rate(member, (row) => row.result.verdict[member], (row) => row.result,
                {group, alarm, note: verdict[member]}),
    depth_column('deepest', member, {group, note: verdict[`deepest_${member}`]}),
  ];
  const answers = (member, label, alarm) => column.count(label ?? member, (row) => row.result.verdict[member],
                                                         {group: 'other verdicts', note: verdict[member], alarm, may_go: true});
  return table('Verdicts by family', [
    ...family_columns(rows),
    column.count('trials', (row) => row.result.trials, {note: family.trials}),
    ...['separated', 'contact', 'touching', 'invalid'].map(truth_count),
    ...wrong('false_separation', 'missed contacts', 'bad'),
    ...wrong('false_contact', 'phantom contacts', 'warn'),
    answers('touching_flips', null, 'warn'), answers('undecided'), answers('invalid', 'invalid answers', 'warn'),
    answers('unanswered', 'no answer', 'bad'),
    column.text('broken links', (row) => links_total(row.result.verdict.links),
                {numeric: true, left: true, note: verdict.links,
                 cell: (td, value, row) => td.append(link_chips(row.result.verdict.links))}),
  ], rows, grouped(data, rows));
}

// Counted apart: queries outside the limits that a kernel declares, and answers to images of queries.
function apart_tables(data, rows) {
  const made = [];
  const limited = rows.filter((row) => row.result.verdict.outside_limits !== null);
  if (limited.length > 0) {
    made.push(el('h3', '', 'Outside its limits'), table('Outside its limits', [...family_columns(rows),
      ...['trials', 'decided_contacts', 'decided_separations', 'false_separation', 'false_contact', 'unanswered'].map((member) => column.count(
        member, (row) => row.result.verdict.outside_limits[member], {note: data.notes.outside_limits[member]}))], limited, grouped(data, limited)));
  }
  const imaged = rows.filter((row) => row.result.asymmetry);
  if (imaged.length > 0) {
    made.push(el('h3', '', 'Asymmetry'), table('Asymmetry: other answers to images of queries', [...family_columns(rows),
      ...['images', 'verdicts', 'images_with_comparisons', 'comparisons'].map((member) => column.count(member,
        (row) => row.result.asymmetry[member],
        {note: data.notes.asymmetry[member], alarm: ['verdicts', 'comparisons'].includes(member) ? 'warn' : undefined}))], imaged, grouped(data, imaged)));
  }
  return el('div', '', ...made);
}

function link_counts_table(data, rows) {
  const links = Object.keys(data.links);
  const group = (label, member) => links.map((link) => column.count(link, (row) => row.result.verdict[member]?.[link], {
    group: label, note: data.links[link], alarm: member === 'links' ? 'bad' : undefined, may_go: true}));
  return table('Broken links', [
    ...family_columns(rows), ...group('wrong verdicts', 'links'),
    ...links.filter((link) => rows.some((row) => row.result.verdict.links?.[link] > 0)).map((link) =>
      column.count(link, (row) => row.result.verdict.first_by_link[link],
                   {group: 'first query with it', note: data.notes.verdict.first_by_link, none: 'none'})),
    ...group('cancelled: the verdict is right', 'masked_links'),
  ], rows, grouped(data, rows));
}

function radius_table(data, entries) {
  const rows = entries.flatMap((entry) => [
    {entry, family: 'all families', result: entry, total: true},
    ...Object.entries(entry.families).map(([family, result]) => ({entry, family, result}))]);
  const note = data.notes.critical_radius;
  const of = (member, type, more) =>
    column[type](member, (row) => row.result.critical_radius[member], {note: note[member], ...more});
  return table('Critical radius error, in ulps', [
    ...family_columns(rows), of('sampled', 'count'), of('median_ulps', 'amount', {digits: 6}),
    of('largest_ulps', 'amount', {digits: 6}), of('unbounded', 'count', {alarm: 'warn', may_go: true}),
    of('unanswered', 'count', {alarm: 'bad', may_go: true}), of('undecided', 'count', {may_go: true}),
    of('invalid', 'count', {alarm: 'bad', may_go: true}),
  ], rows, {row_class: (row) => (row.total ? 'total' : ''), ...grouped(data, rows)});
}

// What kernels say beside their verdicts; nothing where they say nothing.
function contact_tables(data, rows) {
  const said = rows.filter((row) => row.result.contacts);
  if (said.length === 0) return el('div');
  return said[0].result.contacts.decided !== null ? motion_tables(data, said) : body_tables(data, said);
}

const not_given = {none: 'not given'};

// One figure of a part of what is said; null where the part is not given, or the figure was judged on no answer.
function figure_of(contacts, part, member) {
  const told = contacts[part];
  if (!told) return null;
  return told[member];
}
function of_part(part, member, type, label, more) {
  return column[type](label, (row) => figure_of(row.result.contacts, part, member), {...not_given, ...more});
}

// A size that may be beyond binary64.
function size_column(label, get, more) {
  return column.text(label, get, {numeric: true, key: (value) => (value === null ? -Infinity : magnitude(value)), ...more,
    cell: (td, value) => td.append(value === null ? not_given.none : error_amount(value))});
}

// How far two bodies are apart or in each other.
function body_tables(data, told) {
  const size = (part, member, label, more) => size_column(label, (row) => figure_of(row.result.contacts, part, member), more);
  const points = ['point', 'point_a', 'point_b', 'points'].filter((part) => told.some((row) => row.result.contacts[part]));
  const labels = {point: 'point', point_a: 'first point', point_b: 'second point', points: 'points and separation'};
  return el('div', 'contacts', el('h3', '', 'Contacts'), el('p', 'lead', data.contact_note), table('Separations', [
    ...family_columns(told),
    column.count('answers', (row) => row.result.contacts.answers),
    of_part('separation', 'judged', 'count', 'given', {group: 'separation'}),
    of_part('separation', 'largest_error', 'amount', 'off by', {digits: 3, group: 'separation'}),
    of_part('separation', 'largest_length', 'amount', 'length', {digits: 3, group: 'separation'}),
    size('separation', 'largest_ulps', 'ulps', {group: 'separation'}),
    of_part('consistency', 'positive', 'count', 'contacts above 0', {group: 'contradictions', alarm: 'bad'}),
    of_part('consistency', 'negative', 'count', 'separated below 0', {group: 'contradictions', alarm: 'bad'}),
    of_part('consistency', 'missing', 'count', 'not given', {group: 'contradictions', alarm: 'bad'}),
  ], told, grouped(data, told)), table('Normals and points', [
    ...family_columns(told),
    of_part('feature', 'judged', 'count', 'given', {group: 'feature'}),
    of_part('feature', 'wrong', 'count', 'wrong', {group: 'feature', alarm: 'warn'}),
    of_part('pushed', 'judged', 'count', 'of overlaps', {group: 'normal'}),
    of_part('pushed', 'flips', 'count', 'flips', {group: 'normal', alarm: 'bad'}),
    size('pushed', 'largest_left', 'left', {group: 'normal'}),
    of_part('normal', 'judged', 'count', 'compared', {group: 'normal'}),
    of_part('normal', 'largest_angle', 'amount', 'off by', {digits: 3, group: 'normal'}),
    of_part('normal', 'lengths', 'count', 'with a length', {group: 'normal'}),
    of_part('normal', 'largest_length_error', 'amount', 'its length off by', {digits: 3, group: 'normal'}),
    ...points.flatMap((part) => [
      of_part(part, 'judged', 'count', 'compared', {group: labels[part]}),
      of_part(part, 'largest_error', 'amount', 'off by', {digits: 3, group: labels[part]}),
    ]),
  ], told, grouped(data, told)));
}

// The first contacts of a predicate of motions.
function motion_tables(data, rows) {
  const told = rows.filter((row) => row.result.contacts.time || row.result.contacts.missed?.deepest_tunnel > 0);
  if (told.length === 0) return el('div');
  const none = not_given;
  const time = (label, get, type, more) => column[type](label, (row) => row.result.contacts.time && get(row.result.contacts.time), {...none, ...more});
  const judged = (get) => (t) => (t.judged === 0 ? null : get(t));
  const size = (label, get, more) => time(label, get, 'text', {numeric: true, key: (value) => (value === null ? -Infinity : magnitude(value)), ...more,
    cell: (td, value) => td.append(value === null ? none.none : error_amount(value))});
  const side = (name, alarm) => [
    time('times', judged((t) => t[name]), 'count', {group: name, alarm}),
    size('largest, ulps', judged((t) => t[`${name}_errors`].largest_ulps), {group: name}),
    size('largest, u', judged((t) => t[`${name}_errors`].largest_in_u), {group: name}),
    time('of the way', judged((t) => t[`${name}_errors`].largest_share), 'amount', {digits: 3, group: name}),
    time('length', judged((t) => t[`${name}_errors`].largest_length), 'amount', {digits: 3, group: name}),
  ];
  const of = of_part;
  return el('div', 'motions', el('h3', '', 'First contacts'), el('p', 'lead', data.contact_note), table('First contacts', [
    ...family_columns(told),
    column.count('contacts', (row) => row.result.contacts.answers),
    ...side('late', 'bad'),
    size('tunnel', judged((t) => t.late_tunnels.deepest_tunnel), {group: 'late'}),
    ...side('early'),
    time('no time', (t) => t.none + t.invalid, 'count', {alarm: 'bad'}),
  ], told, grouped(data, told)), table('Where contacts are, and missed contacts', [
    ...family_columns(told),
    of('feature', 'judged', 'count', 'given', {group: 'feature'}),
    of('feature', 'wrong', 'count', 'wrong', {group: 'feature', alarm: 'warn'}),
    of('normal', 'judged', 'count', 'compared', {group: 'normal'}),
    of('normal', 'largest_angle', 'amount', 'off by', {digits: 3, group: 'normal'}),
    of('point', 'judged', 'count', 'compared', {group: 'point'}),
    of('point', 'largest_error', 'amount', 'off by', {digits: 3, group: 'point'}),
    of('missed', 'through', 'count', 'through', {group: 'missed contacts', alarm: 'bad'}),
    size_column('tunnel', (row) => figure_of(row.result.contacts, 'missed', 'deepest_tunnel'), {group: 'missed contacts'}),
  ], told, grouped(data, told)));
}

// For one kernel entry, or for all.
function show_families(data) {
  const {kernels} = data;
  if (kernels.length === 0) return;
  const show = (index) => {
    const chosen = index < kernels.length ? [kernels[index]] : kernels;
    const rows = family_rows(chosen);
    for (const [id, made] of [['families-table', families_table(data, rows)], ['apart-tables', apart_tables(data, rows)], ['contact-tables', contact_tables(data, rows)],
                              ['link-counts', link_counts_table(data, rows)],
                              ['radius-table', radius_table(data, chosen)]]) {
      document.getElementById(id).replaceChildren(made);
    }
  };
  document.getElementById('families-controls').append(choice('Kernel', [...kernels.map(entry_name), 'all kernels'], show));
  show(0);
}

function sign_columns(notes, level) {
  const of = (member, more) => column.count(member, (row) => row.tally[member], {note: notes[level][member], ...more});
  const links = Object.keys(notes.formula_links).map((link) =>
    column.count(link, (row) => row.tally.links?.[link], {group: 'links broken by flips', note: notes.formula_links[link], may_go: true}));
  return [
    column.text(level, (row) => row.name, {cell: (th, value) => th.append(el('span', 'name', value))}),
    of('judged'), of('false_separation', {group: 'flips', alarm: 'bad'}), of('missed_separation', {group: 'flips', alarm: 'warn'}),
    of('decisive', {group: 'flips'}), of('masked', {group: 'flips'}),
    ...links,
  ];
}

function error_columns(notes, level) {
  const group = 'error, in u';
  return [
    column.count('tolerance_failures', (row) => row.tally.tolerance_failures,
                 {group, alarm: 'bad', note: notes[level].tolerance_failures, may_go: true}),
    // It is the smallest tolerance that passes, too.
    column.error('max_error_u', (row) => row.tally.max_error_u, {group, note: notes[level].max_error_u}),
  ];
}

function show_signs(data) {
  let entry = 0;
  let family = 0;
  const controls = document.getElementById('signs-controls');
  const family_names = () => ['all families', ...Object.keys(data.kernels[entry].families)];
  const rows_of = (level, result) => Object.entries(result[level]).map(([name, tally]) => ({name, tally}));
  const show = () => {
    const chosen = data.kernels[entry];
    const result = family === 0 ? chosen.all : Object.values(chosen.families)[family - 1];
    const title = `${entry_name(chosen)}, ${family_names()[family]}`;
    const axes = document.getElementById('axes-table');
    const comparisons = document.getElementById('comparisons-table');
    if (!result || result.axes === null) {
      const why = result ? 'Not exposed: this kernel shows only verdicts.' : 'Not checked: no family ran.';
      axes.replaceChildren(el('p', 'empty', why));
      comparisons.replaceChildren(el('p', 'empty', why));
      return;
    }
    axes.replaceChildren(table(`Axes: ${title}`, [
      ...sign_columns(data.notes, 'axis'), ...error_columns(data.notes, 'axis'),
      column.count('sole_separator', (row) => row.tally.sole_separator, {note: data.notes.axis.sole_separator}),
    ], rows_of('axes', result)));
    comparisons.replaceChildren(table(`Comparisons: ${title}`, [
      ...sign_columns(data.notes, 'comparison'),
      column.text('tolerance', (row) => data.plan.tolerance[row.name],
                  {group: 'error, in u', numeric: true, key: (value) => Number(value) || 0, may_go: true,
                   cell: (td, value) => td.append(value ?? 'not given')}),
      ...error_columns(data.notes, 'comparison'),
      ...['ties', 'range_events', 'error_without_scale'].map((member) =>
        column.count(member, (row) => row.tally[member], {group: 'events', note: data.notes.comparison[member], may_go: true})),
    ], rows_of('comparisons', result)));
  };
  const choose_family = () => choice('Family', family_names(), (index) => { family = index; show(); });
  const choose_kernel = choice('Kernel', data.kernels.map(entry_name), (index) => {
    entry = index;
    family = 0;
    controls.replaceChildren(choose_kernel, choose_family());
    show();
  });
  if (data.kernels.length === 0) return;
  controls.append(choose_kernel, choose_family());
  show();
}
