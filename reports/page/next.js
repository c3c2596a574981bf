// Three things to do, by what the run found, below the levels and before the cards.

// The kernel that a reader wants to hear of: the first that fails what was required, otherwise the first that is wrong.
function kernel_to_mend(data) {
  const wrong = (entry) => entry.all !== null && entry.all.verdict.false_separation + entry.all.verdict.false_contact > 0;
  return data.kernels.find((entry) => failures_of(data, entry).length > 0) ?? data.kernels.find(wrong) ?? null;
}

// The witness to look at: the first of that kernel, a missed contact before an invented one. It is of ordinary numbers where there is one.
function look_step(data, entry) {
  if (entry === null) {
    const decided = data.kernels.reduce((sum, one) => sum + (one.decided ?? 0), 0);
    if (decided === 0) return el('li', '', 'Nothing was decided, so that nothing is known: read why, above.');
    return el('li', '', `Nothing was wrong among ${count(decided)} verdict${decided === 1 ? '' : 's'}. Look for the worst there is: `,
              el('code', '', `axiscert search --kernel ${data.plan.kernels[0]}`), '.');
  }
  const wrong = [...wrong_witnesses(data, entry, 'false_separation'), ...wrong_witnesses(data, entry, 'false_contact')];
  const witness = wrong.find(({id}) => id === data.first.worst?.id) ?? wrong[0];
  if (!witness) return el('li', '', 'Look at where ', el('span', 'name', entry.id), ' is wrong, below.');
  return el('li', '', 'Look at a wrong verdict of ', el('span', 'name', entry.id), ': ', witness_link(data, witness.id),
            witness.depth > 0 ? `, wrong by ${depth_text(witness, 3)}` : '', '.');
}

// Advice: a fault to mend, or a level to require.
function mend_step(data, entry) {
  if (!data.requirement) {
    const {level, advice} = data.advised_level;
    return el('li', '', 'Say what has to hold: ', el('code', '', `axiscert run --require ${level}`), ` ${advice}.`);
  }
  if (data.requirement.passes) {
    return el('li', '', 'What was required is met. Keep it so: ', el('code', '', 'axiscert run --preset ci --ratchet FILE'), ' in CI.');
  }
  const unchecked = data.requirement.outcomes.find((outcome) => outcome.state === 'NOT CHECKED' && !outcome.allowed);
  const [first] = entry === null ? [] : failures_of(data, entry);
  if (first) {
    const item = el('li', '', 'Mend what the requirement names first: ', el('span', 'name', first.family), ` ${first.what}`);
    if (first.witness !== '') item.append(', witness ', witness_link(data, first.witness));
    item.append('.');
    return item;
  }
  return el('li', '', unchecked ? `Run what ${unchecked.level} needs: ${unchecked.reason}.` : 'Read why the requirement is not met, below.');
}

function compare_step(data, entry) {
  const id = entry?.id ?? data.plan.kernels[0];
  const word = ['A word that is not clear: ', el('code', '', 'axiscert explain WORD'), '.'];
  const beside = page_predicate_named(data.plan)?.league;
  if (beside === undefined) return el('li', '', ...word);
  return el('li', '', 'Compare it with what else there is, production libraries among it: ',
            el('code', '', `axiscert league ${[...new Set([id, ...beside])].map((each) => `--kernel ${each}`).join(' ')}`),
            '. ', ...word);
}

function next_box(data) {
  const box = el('div', '');
  box.id = 'next';
  if (data.kernels.length === 0) return box;
  const entry = kernel_to_mend(data);
  box.append(el('h3', '', 'Next'), el('ol', 'sentences', look_step(data, entry), mend_step(data, entry), compare_step(data, entry)));
  return box;
}
