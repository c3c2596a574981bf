// Findings, the reproduction, and the start.

function finding_card(data, finding) {
  const where = finding.family === null ? 'while loading'
    : el('span', '', 'on ', el('span', 'name', finding.family), finding.count === 1 ? ', once' : `, ${count(finding.count)} times`);
  const kind = chip(finding.kind, 'bad');
  kind.title = data.notes.finding.kind;
  const card = el('article', 'finding', el('p', 'status', kind, ' ', el('span', 'name', finding.kernel),
                  finding.precision === null ? '' : ` ${finding.precision} `, ' ', where), el('p', '', finding.detail));
  if (finding.others !== '') card.append(el('p', 'label', finding.others));
  if (finding.address !== null) {
    card.append(el('p', 'label', 'First at ', el('code', '', finding.address)), command(finding.command));
  }
  return card;
}

function show_findings(data) {
  if (data.findings.length === 0) return;
  document.getElementById('findings').hidden = false;
  document.getElementById('findings-link').hidden = false;
  document.getElementById('findings-list').append(...data.findings.map((finding) => finding_card(data, finding)));
}

function show_reproduction(data) {
  const {plan} = data;
  document.getElementById('run-command').append(data.command !== '' ? command(data.command)
    : el('p', 'lead', 'The number of trials depended on the time available; the table below has the units done.'));
  for (const [label, value] of data.facts) {
    document.getElementById('facts').append(el('dt', '', label), el('dd', '', value));
  }
  document.getElementById('not-checked').append(...data.not_checked.map((sentence) => el('li', '', sentence)));
  const per_precision = (label, counts) => plan.precisions.map((precision) =>
    column.count(precision, (family) => counts[family]?.[precision] ?? 0, {group: label}));
  document.getElementById('plan-table').append(table('Families of the plan', [
    column.text('family', (family) => family, {cell: (th, family) => {
      th.append(el('span', 'name', family));
      if (plan.generators[family]?.exact_arithmetic) th.append(' ', chip('exact_arithmetic'));
    }}),
    column.text('purpose', (family) => plan.generators[family]?.purpose ?? '', {cell: (td, value) => {
      td.classList.add('prose');
      td.append(value);
    }}),
    column.count('generator version', (family) => plan.generators[family]?.version ?? null),
    ...per_precision('trials', plan.trials),
    ...(plan.units_done === null ? [] : per_precision('units done', plan.units_done)),
  ], plan.families, {groups: by_group(data, plan.families, (family) => family)}));
  if (data.throughput.length === 0) {
    document.getElementById('speed-title').remove();
    return;
  }
  document.getElementById('speed-table').append(table('Throughput of the whole chain, judge included', [
    column.text('family', (row) => row.family, {cell: (th, value) => th.append(el('span', 'name', value))}),
    column.text('precision', (row) => row.precision),
    column.count('queries', (row) => row.queries),
    column.amount('seconds of core', (row) => row.seconds_of_core, {digits: 3}),
    column.amount('queries a second and core', (row) => row.queries_per_second_and_core,
                  {digits: 3, none: 'not measured'}),
  ], data.throughput, grouped(data, data.throughput)));
}

// The commands whose files this folder could hold and does not, with what each would add to the page; those that serve the
// run's predicate, about its first kernel.
function parts_not_run(data) {
  const {proofs, search, maps, ladder, precision, league, mutation} = data.attached;
  const entry = data.kernels.find((each) => each.all !== null), worst = data.witnesses.cards[0];
  const about = entry === undefined ? '' : ` --kernel ${shell_word(entry.id)} --precision ${entry.precision}`;
  const around = worst === undefined ? 'ADDRESS' : `${shell_word(worst.address)} --kernel ${shell_word(worst.kernel)}`;
  return [
    [proofs, 'prove', 'bounds that a checker accepted'],
    [search, `search${about}`, 'the worst errors there are'],
    [maps, `map ${around}`, 'pictures of where it is wrong around a witness'],
    [ladder, 'ladder', 'accuracy against speed of each form of the predicate'],
    [precision, 'precision', 'wrong verdicts against the bits of precision'],
    [league, 'league', 'libraries and other kernels on the same queries'],
    [mutation, 'mutate', 'which planted faults would be caught'],
  ].filter(([attached, command]) => attached === null && page_has_command(data.plan, command.split(' ')[0]));
}

// The line that says what belongs to this page and was not done.
function missing_parts(data) {
  const counts_margins = data.kernels.length === 0 || data.kernels.some(has_margins);
  const commands = parts_not_run(data).flatMap(([, command, meaning], i) => [i === 0 ? '' : '; ', el('code', '', `axiscert ${command} --out DIR`), `: ${meaning}`]);
  return [...(commands.length === 0 ? [] : [el('span', '', 'Not run here, and added to this page by ', el('code', '', 'axiscert report DIR'),
                                               ' where DIR is its folder: ', ...commands, '.')]),
          ...(counts_margins ? [] : ['Distribution of margins: no kernel here shows comparisons, or none was measured.'])];
}

// The data as the page holds them: compressed, in base64.
async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
}

async function show_report() {
  let data;
  try {
    data = await unpacked(document.getElementById('data').textContent.trim());
    data.witnesses = await unpacked(document.getElementById('witness-data').textContent.trim());
  } catch (problem) {
    document.getElementById('banner').append(el('p', 'banner bad', 'This page cannot read its own data: the file was cut off or ' +
      `edited, or the browser is older than 2023 (${problem.message}). report.md next to it is a short version.`));
    return;
  }
  data.not_checked.push(...missing_parts(data));
  show_first(data);
  show_findings(data);
  show_answer(data);
  show_heat(data);
  show_bounds(data);
  show_origins(data);
  show_maps(data);
  show_margins(data);
  show_witnesses(data);
  show_families(data);
  show_signs(data);
  show_appendix(data);
  show_reproduction(data);
  document.body.classList.add('ready');
}

// The witnesses' cards stay folded: each has its line.
unfold_on_paper('details:not(.witness)');
show_report();
