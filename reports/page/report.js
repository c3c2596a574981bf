// The summary, the reproduction, and the start.

function failures_of(data, entry) {
  return data.requirement?.failures.filter((f) => f.kernel === entry.id &&
    (f.precision === '' || f.precision === entry.precision)) ?? [];
}

function status_chip(data, failures, ran) {
  if (!data.requirement) return chip('no requirement asked');
  const level = data.requirement.level;
  if (failures.length > 0) return chip(`requirement ${level}: not met`, 'bad');
  if (!ran) return chip(`requirement ${level}: not checked`, 'warn');
  return data.complete ? chip(`requirement ${level}: met`, 'good') : chip(`requirement ${level}: met so far`, 'warn');
}

function failure_item(data, failure) {
  const shown = data.witnesses.cards.some((witness) => witness.id === failure.witness);
  const item = failure.family === '' ? el('li', '', failure.what)
    : el('li', '', el('span', 'name', failure.family), `: ${failure.what}: ${count(failure.count)}`);
  if (failure.witness === '') return item;
  const link = el(shown ? 'a' : 'span', 'name', failure.witness);
  if (shown) link.href = `#witness-${encodeURIComponent(failure.witness)}`;
  item.append(', witness ', link);
  return item;
}

function links_bar(links) {
  const total = Object.values(links).reduce((x, y) => x + y, 0);
  const bar = el('div', 'bar');
  bar.setAttribute('aria-hidden', 'true');
  for (const [link, n] of Object.entries(links)) {
    if (n === 0) continue;
    const part = el('span', `link-${link}`);
    part.style.flexGrow = String(n / total);
    bar.append(part);
  }
  return total === 0 ? null : bar;
}

function metric(label, member, total, alarm) {
  const [number, limit] = rate(total.verdict[member], total);
  const deepest = total.verdict[`deepest_${member}`];
  return el('div', `metric ${total.verdict[member] > 0 ? alarm : ''}`, el('span', 'label', label),
            el('strong', '', number), el('small', '', limit),
            el('small', '', deepest > 0 ? `deepest ${amount(deepest, 4)} of the scene` : 'deepest: 0'));
}

function tolerance_fact(total) {
  if (total.comparisons === null) return 'not exposed';
  const counts = Object.values(total.comparisons).map((tally) => tally.tolerance_failures).filter((n) => n !== null);
  return counts.length === 0 ? 'not checked' : count(counts.reduce((x, y) => x + y, 0));
}

function largest_error(total) {
  if (total.comparisons === null) return 'not exposed';
  const [name, tally] = Object.entries(total.comparisons).reduce(
    (x, y) => (magnitude(y[1].max_error_u) > magnitude(x[1].max_error_u) ? y : x));
  return `${error_amount(tally.max_error_u)} u, ${name}`;
}

// A kernel of the plan that could not be loaded.
function not_judged_card(data, id) {
  const why = data.findings.filter((finding) => finding.kernel === id);
  return el('article', 'card', el('h3', '', el('span', 'name', id)), el('p', 'status', chip('not judged', 'bad')),
            el('p', 'lead', 'It could not be loaded, so nothing of it was judged.'),
            el('ul', 'failures', ...why.map((finding) => el('li', '', `${finding.kind}: ${finding.detail}`))));
}

function summary_card(data, entry) {
  const failures = failures_of(data, entry);
  const total = entry.all;
  const card = el('article', 'card', el('h3', '', el('span', 'name', entry.id), ' ', chip(entry.precision)),
                  el('p', 'status', status_chip(data, failures, total !== null)), el('p', 'lead', entry.summary));
  if (total === null) {
    card.append(el('p', 'empty', 'Not checked: no family ran.'));
    return card;
  }
  card.append(el('div', 'metrics', metric('missed contacts', 'false_separation', total, 'bad'),
                 metric('phantom contacts', 'false_contact', total, 'warn')));
  const facts = el('dl', 'facts numbers');
  const fact = (label, value) => facts.append(el('dt', '', label), el('dd', '', value));
  const radius = entry.critical_radius;
  fact('trials', `${count(total.trials)} in ${count(Object.keys(entry.families).length)} families`);
  fact('undecided', count(total.verdict.undecided));
  fact('invalid answers', count(total.verdict.invalid));
  fact('without an answer', count(total.verdict.unanswered));
  fact('says of itself', entry.touching_text);
  fact('limits', entry.limits_text);
  const outside = total.verdict.outside_limits;
  if (outside !== null) {
    fact('outside its limits', `${count(outside.trials)} queries, ` +
         `${count(outside.false_separation + outside.false_contact)} wrong, counted apart`);
  }
  fact('wrong on touching', count(total.verdict.touching_flips));
  fact('tolerance failures', tolerance_fact(total));
  fact('largest error', largest_error(total));
  fact('critical radius', radius.largest_ulps === null ? 'not sampled'
       : `median ${amount(radius.median_ulps, 3)}, largest ${amount(radius.largest_ulps, 3)} ulps`);
  card.append(facts, el('p', 'label', 'Broken links of wrong verdicts'),
              el('div', 'links', links_bar(total.verdict.links), link_chips(total.verdict.links)));
  if (failures.length > 0) {
    const list = el('details', '',
                    el('summary', 'label', `Where the requirement is not met: ${count(failures.length)}`),
                    el('ul', 'failures', ...failures.map((failure) => failure_item(data, failure))));
    list.open = failures.length <= 8;
    card.append(list);
  }
  return card;
}

function show_summary(data) {
  const {plan} = data;
  const seed = data.facts.find(([label]) => label === 'seed')[1];
  document.getElementById('subtitle').textContent =
    `${plan.kernels.join(', ')} · ${plan.precisions.join(', ')} · ${count(plan.families.length)} families · ` +
    `seed ${seed} · axiscert ${plan.axiscert}`;
  const any = data.kernels.some((entry) => entry.all !== null);
  document.getElementById('status').append(status_chip(data, data.requirement?.failures ?? [], any));
  const banner = document.getElementById('banner');
  if (!data.complete) {
    banner.append(el('p', 'banner warn', el('strong', '', 'Incomplete. '), 'The run was interrupted before its plan ' +
      'was done: what follows is about the queries that were asked.'));
  }
  if (data.requirement) {
    const {level, sentence} = data.requirement;
    const text = el('p', 'lead', 'Required: ', el('strong', '', level), `, ${sentence}.`);
    document.getElementById('summary-title').after(text);
  }
  document.getElementById('summary-cards').append(...data.not_judged.map((id) => not_judged_card(data, id)));
  document.getElementById('summary-cards').append(...data.kernels.map((entry) => summary_card(data, entry)));
  for (const [link, meaning] of Object.entries(data.links)) {
    document.getElementById('meanings').append(el('dt', '', chip(link, `link-${link}`)), el('dd', '', meaning));
  }
}

function finding_card(data, finding) {
  const where = finding.family === null ? 'in loading'
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
    : el('p', 'lead', 'The trials depended on the time the run had; the table below has the units done.'));
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
  ], plan.families));
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
  ], data.throughput));
}

function show_report() {
  const data = JSON.parse(document.getElementById('data').textContent);
  show_findings(data);
  show_summary(data);
  show_families(data);
  show_signs(data);
  show_links(data);
  show_witnesses(data);
  show_radius(data);
  show_reproduction(data);
}

show_report();
