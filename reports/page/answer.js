// The answer, before anything else: what was run, how often it is wrong, how deep, by which link, and the evidence for
// each comparison.

function failures_of(data, entry) {
  return data.requirement?.failures.filter((f) => f.kernel === entry.id &&
    (f.precision === '' || f.precision === entry.precision)) ?? [];
}

function outcomes_of(data, entry) {
  return data.requirement?.outcomes.filter((o) => o.kernel === entry.id &&
    (o.precision === null || o.precision === entry.precision)) ?? [];
}

// The outcome of one level for one kernel, or of all of them.
function outcome_chip(data, outcome) {
  const within = outcome.outside_limits?.length > 0
    ? ` within its limits, ${outcome.families - outcome.outside_limits.length} of ${outcome.families} families` : '';
  const text = `requirement ${outcome.level}${within}: `;
  if (outcome.state === 'not met') return chip(`${text}not met`, 'bad');
  if (outcome.state !== 'met') return chip(`${text}NOT CHECKED${outcome.allowed ? ', which is allowed' : ''}`, outcome.allowed ? 'warn' : 'bad');
  return data.complete ? chip(`${text}met`, 'good') : chip(`${text}met so far`, 'warn');
}

function status_chip(data) {
  if (!data.requirement) return chip('no requirement given');
  const {levels, outcomes, passes} = data.requirement;
  const level = levels.map((one) => one.level).join(', ');
  const state = passes ? 'met' : outcomes.some((o) => o.state === 'not met') ? 'not met' : 'NOT CHECKED';
  if (!passes) return outcome_chip(data, {level, state, allowed: false});
  return outcome_chip(data, {level, state: outcomes.every((o) => o.state === 'met') ? 'met' : 'NOT CHECKED', allowed: true});
}

// Lists how much each level looked at, what it says of a kernel, and what it does not.
function outcome_list(outcomes) {
  if (outcomes.length === 0) return '';
  return el('ul', 'sentences', ...outcomes.map((o) => el('li', '', el('strong', '', `${o.text}. `),
    o.state === 'met' ? `Covers ${o.covers}. Leaves out ${o.leaves_out}.` : '')));
}

function failure_item(data, failure) {
  const item = failure.family === '' ? el('li', '', failure.what)
    : el('li', '', el('span', 'name', failure.family), `: ${failure.what}: ${count(failure.count)}`);
  if (failure.witness !== '') item.append(', witness ', witness_link(data, failure.witness));
  return item;
}

// `links` is null where no query was decided.
function links_total(links) { return links && Object.values(links).reduce((x, y) => x + y, 0); }

function links_bar(links) {
  const total = links_total(links);
  if (!total) return null;
  const bar = el('div', 'bar');
  bar.setAttribute('aria-hidden', 'true');
  for (const [link, n] of Object.entries(links).filter(([, n]) => n > 0)) {
    const part = el('span', `link-${link}`);
    part.style.flexGrow = String(n / total);
    bar.append(part);
  }
  return bar;
}

function link_chips(counts) {
  if (counts === null) return '-';
  const broken = Object.entries(counts).filter(([, n]) => n > 0);
  if (broken.length === 0) return el('span', 'zero', 'none');
  return el('span', 'chips', ...broken.map(([link, n]) => chip(`${link} ${count(n)}`, `link-${link}`)));
}

// A link to the witness's card where the page has it, otherwise its name.
function witness_link(data, id) {
  if (!data.witnesses.cards.some((witness) => witness.id === id)) return el('span', 'name', id);
  const link = el('a', 'name', id);
  link.href = `#witness-${encodeURIComponent(id)}`;
  return link;
}

// The witnesses of wrong verdicts of that kind that the page has, in its order.
function wrong_witnesses(data, entry, kind) {
  return data.witnesses.cards.filter((witness) => witness.kernel === entry.id && witness.precision === entry.precision &&
    witness.flips.some((flip) => flip.level === 'verdict' && flip.kind === kind));
}

function deepest_witness(data, entry, kind) {
  return wrong_witnesses(data, entry, kind).reduce((x, y) => (x === null || y.depth > x.depth ? y : x), null);
}

function metric(data, entry, label, member, alarm) {
  const total = entry.all;
  const [number, limit] = rate(total.verdict[member], total, member);
  const deepest = total.verdict[`deepest_${member}`];
  const witness = deepest_witness(data, entry, member);
  const none = total.zero_limits[member] === null ? 'deepest: -' : 'deepest: 0';
  const depth = el('small', '', deepest > 0 ? `deepest ${amount(deepest, 4)} of the scene` : none,
                   witness?.depth === deepest && witness.length_text ? `, ${witness.length_text}` : '');
  if (witness) depth.append(', witness ', witness_link(data, witness.id));
  return el('div', `metric ${total.verdict[member] > 0 ? alarm : ''}`, el('span', 'label', label),
            el('strong', '', number), el('small', '', limit), depth);
}

// One sentence for each broken link: how often, where most often, and how soon it shows.
function link_sentences(data, entry) {
  const list = el('ul', 'sentences');
  for (const [link, n] of Object.entries(entry.all.verdict.links ?? {})) {
    if (n === 0) continue;
    const families = Object.entries(entry.families).map(([family, result]) => ({family, n: result.verdict.links?.[link] ?? 0,
      first: result.verdict.first_by_link[link]})).filter((where) => where.n > 0).sort((x, y) => y.n - x.n);
    const soonest = families.filter(({first}) => first !== null).sort((x, y) => x.first - y.first)[0];
    const item = el('li', '', chip(link, `link-${link}`), ` in ${count(n)} wrong verdicts, most on `,
                    el('span', 'name', families[0].family), ` (${count(families[0].n)})`,
                    families.length > 1 ? ` and on ${count(families.length - 1)} other famil${families.length === 2 ? 'y' : 'ies'}` : '');
    if (soonest) item.append('; first at query ', count(soonest.first), ' of ', el('span', 'name', soonest.family));
    item.append('.');
    item.title = data.links[link];
    list.append(item);
  }
  return list.children.length > 0 ? list
    : el('p', 'lead', entry.all.verdict.false_separation + entry.all.verdict.false_contact > 0
      ? 'Every wrong verdict is on a query without a link to blame.'
      : entry.decided === 0 ? 'Without a verdict no link shows.' : `No link broke one of its ${count(entry.decided)} verdicts.`);
}

const badge_meanings = {
  proved: 'a checker accepted a bound on its error',
  exhaustive: 'every query of a reduced space was tried',
  searched: 'a search looked for its worst error, which was confirmed exactly',
  open: 'only these queries give evidence about it',
};
const badge_kinds = {proved: 'good', exhaustive: 'good', searched: 'note', open: ''};

// The evidence about a comparison of a kernel entry, the strongest first.
function bound_of(data, entry, name) {
  // A bound holds for the kernel that it names, and for kernels with the same formulae, arithmetic and order of
  // operations.
  const own = (row) => row.name === name && (row.precision === null || row.precision === entry.precision) &&
    (row.formulae === entry.id ||
     (entry.reference && row.formulae === entry.formulae && (row.arithmetic ?? 'plain') === entry.arithmetic));
  const {proofs, search} = data.attached;
  const proof = proofs?.comparisons.find(own) ?? null;
  const hunted = search !== null && search.kernel === entry.id && search.precision === entry.precision
    ? search.comparisons.find((row) => row.name === name) ?? null : null;
  const is_searched = hunted !== null && hunted.attained_u !== null;
  const badge = proof?.status === 'proved' || proof?.status === 'exhaustive' ? proof.status
    : is_searched ? 'searched' : 'open';
  return {badge, proof, attained: hunted?.attained_u ?? proof?.attained_u ?? null,
          proved: badge === 'proved' ? proof.proved_u : null, observed: entry.all?.comparisons?.[name]?.max_error_u ?? null};
}

function badge_chip(badge) {
  const node = chip(badge, badge_kinds[badge]);
  node.title = badge_meanings[badge];
  return node;
}

function badges(data, entry) {
  if (entry.all.comparisons === null) return el('p', 'empty', 'Comparisons are not exposed: none has a badge.');
  const names = Object.keys(entry.all.comparisons);
  const by_badge = Object.keys(badge_meanings).map((badge) =>
    [badge, names.filter((name) => bound_of(data, entry, name).badge === badge)]).filter(([, some]) => some.length > 0);
  return el('dl', 'facts badges', ...by_badge.flatMap(([badge, some]) => [
    el('dt', '', badge_chip(badge)),
    el('dd', '', el('span', '', `${some.length === names.length ? `all ${names.length}` : some.length} · `),
       el('span', 'name', some.length === names.length ? '' : some.join(' ')), el('small', '', ` ${badge_meanings[badge]}`))]));
}

function tolerance_fact(total) {
  if (total.comparisons === null) return 'not exposed';
  const counts = Object.values(total.comparisons).map((tally) => tally.tolerance_failures).filter((n) => n !== null);
  return counts.length === 0 ? 'not checked' : count(counts.reduce((x, y) => x + y, 0));
}

function largest_error(total) {
  if (total.comparisons === null) return 'not exposed';
  if (Object.values(total.comparisons).every((tally) => tally.max_error_u === null)) return 'not measured: it shows no sides';
  const [name, tally] = Object.entries(total.comparisons).reduce(
    (x, y) => (magnitude(y[1].max_error_u) > magnitude(x[1].max_error_u) ? y : x));
  return `${error_amount(tally.max_error_u)} u, ${name}`;
}

// The card of a kernel of the plan that could not be loaded.
function not_judged_card(data, id) {
  const why = data.findings.filter((finding) => finding.kernel === id);
  return el('article', 'card', el('h3', '', el('span', 'name', id)), el('p', 'status', chip('not judged', 'bad')),
            el('p', 'lead', 'It could not be loaded, so it was not judged.'),
            el('ul', 'failures', ...why.map((finding) => el('li', '', `${finding.kind}: ${finding.detail}`))));
}

// Wrong verdicts by depth, a row for each direction, where there are any.
function depths_table(entry) {
  const rows = [['missed', 'false_separation'], ['phantom', 'false_contact']].filter(([, kind]) => entry.all.verdict[kind] > 0);
  if (!entry.depths || rows.length === 0) return '';
  const column = (name) => { const th = el('th', 'n', name); th.scope = 'col'; return th; };
  const row = ([label, kind]) => {
    const th = el('th', '', label);
    th.scope = 'row';
    return el('tr', '', th, ...entry.depths[kind].map((n) => el('td', n > 0 ? 'n' : 'n zero', count(n))));
  };
  const head = el('tr', '', el('th', '', 'wrong by'), ...entry.depths.columns.map(column));
  const caption = 'Wrong verdicts by depth, as a share of the scene: each column from its depth to that of the next one';
  return scroll_table(caption, 'depths', el('thead', '', head), el('tbody', '', ...rows.map(row)));
}

function more_facts(entry) {
  const total = entry.all;
  const facts = el('dl', 'facts numbers');
  const fact = (label, value) => facts.append(el('dt', '', label), el('dd', '', value));
  const radius = entry.critical_radius;
  fact('declares', entry.touching_text);
  fact('limits', entry.limits_text);
  const outside = total.verdict.outside_limits;
  if (outside !== null) {
    const told = (wrong) => (wrong === null ? '-' : count(wrong));  // null: none of the kind was decided
    fact('outside its limits', `${count(outside.trials)} queries, ` +
         (outside.decided === 0 ? 'none decided' : `${told(outside.false_separation)} missed and ${told(outside.false_contact)} phantom contacts, counted separately`));
  }
  if (entry.engine_text) fact('engine-like', entry.engine_text);
  if (entry.bias_text) fact('errs', entry.bias_text);
  fact('wrong on touching', total.verdict.touching_flips === null ? '-'
       : `${count(total.verdict.touching_flips)} of ${count(total.verdict.decided_touching)}`);
  fact('tolerance failures', tolerance_fact(total));
  fact('largest error', largest_error(total));
  fact('critical radius', radius.largest_ulps === null ? 'not sampled'
       : `median ${amount(radius.median_ulps, 3)}, largest ${amount(radius.largest_ulps, 3)} ulps`);
  return el('details', '', el('summary', 'label', 'More about it'), facts);
}

// Why it is wrong, in one sentence before all figures.
function cause_line(entry) {
  if (entry.cause_text === null) return '';
  const line = el('p', 'cause', el('strong', '', `${entry.cause_text}.`));
  if (entry.cause_witness_text !== '') line.append(` The shortest witness: ${entry.cause_witness_text}.`);
  return line;
}

function answer_card(data, entry) {
  const failures = failures_of(data, entry), outcomes = outcomes_of(data, entry);
  const total = entry.all;
  const chips = outcomes.length > 0 ? outcomes.map((o) => outcome_chip(data, o)) : [chip('nothing required')];
  const card = el('article', 'card', el('h3', '', el('span', 'name', entry.id), ' ', chip(entry.precision), ' ', ...chips),
                  cause_line(entry), el('p', 'lead', entry.summary), outcome_list(outcomes));
  if (total === null) {
    card.append(el('p', 'empty', 'Not checked: no family ran.'));
    return card;
  }
  card.append(el('p', 'asked', `${count(total.trials)} queries in ${count(Object.keys(entry.families).length)} families: ` +
                               `${count(total.truth.contact)} contacts, ${count(total.truth.separated)} separations, ` +
                               `${count(total.truth.invalid)} invalid.`),
              el('p', entry.decided === 0 ? 'asked bad' : 'asked', `${entry.evidence_text}.`),
              el('div', 'metrics', metric(data, entry, 'missed contacts', 'false_separation', 'bad'),
                 metric(data, entry, 'phantom contacts', 'false_contact', 'warn')),
              depths_table(entry), links_bar(total.verdict.links) ?? '', link_sentences(data, entry), badges(data, entry), more_facts(entry));
  if (failures.length > 0) {
    const list = el('details', '',
                    el('summary', 'label', `Where the requirement is not met: ${count(failures.length)}`),
                    el('ul', 'failures', ...failures.map((failure) => failure_item(data, failure))));
    list.open = failures.length <= 8;
    card.append(list);
  }
  return card;
}

function show_answer(data) {
  const {plan} = data;
  const seed = data.facts.find(([label]) => label === 'seed')[1];
  document.getElementById('subtitle').textContent =
    `${plan.kernels.join(', ')} · ${plan.precisions.join(', ')} · ${count(plan.families.length)} families · ` +
    `seed ${seed} · axiscert ${plan.axiscert}`;
  document.getElementById('status').append(status_chip(data));
  if (!data.complete) {
    document.getElementById('banner').append(el('p', 'banner warn', el('strong', '', 'Incomplete. '),
      `The run was ${data.interrupted}: the figures below cover only these.`));
  }
  for (const sentence of data.unjudged) {
    document.getElementById('banner').append(el('p', 'banner bad', `${sentence}.`));
  }
  if (data.requirement) {
    document.getElementById('asked-levels').append(...data.requirement.levels.map(({level, sentence}) =>
      el('p', 'lead', 'Required: ', el('strong', '', level), `, ${sentence}.`)));
  }
  document.getElementById('answer-cards').append(...data.not_judged.map((id) => not_judged_card(data, id)),
                                                 ...data.kernels.map((entry) => answer_card(data, entry)));
  for (const [link, meaning] of Object.entries(data.links)) {
    document.getElementById('meanings').append(el('dt', '', chip(link, `link-${link}`)), el('dd', '', meaning));
  }
}
