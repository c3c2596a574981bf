// The figures of a page: the answer, tables, the heat table, margins, classes.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';

import {folder, opened, real, record_of, render, testdata} from './pages.mjs';

test('opens from disk without a network, an error or an empty section', async () => {
  const {page, close} = await opened(real);
  assert.equal(await page.title(), 'axiscert report');
  const empty = await page.$$eval('main > section:not([hidden])', (sections) =>
    sections.filter((section) => section.textContent.trim().length < 60).map((section) => section.id));
  assert.deepEqual(empty, []);
  const order = await page.$$eval('main > section', (sections) => sections.map((section) => section.id));
  assert.deepEqual(order, ['answer', 'findings', 'kernels', 'heat', 'bounds', 'origins', 'maps', 'witnesses', 'counts', 'others', 'reproduce', 'not-checked-part', 'words']);
  await close();
});

test('begins with the levels, the worst everyday scene and a few sentences', async () => {
  const {page, close} = await opened(real);
  const record = record_of(real);
  const rows = await page.locator('#first table tbody tr').allInnerTexts();
  assert.equal(rows.length, record.kernels.length);
  for (const row of rows) assert.match(row, /logic[^]*(not met|met|NOT CHECKED)[^]*[0-9,]+ of [0-9,]+ promised/);
  // The farthest of the everyday scenes, drawn, with its length.
  const everyday = record.witnesses.filter(({family, shows}) => family.startsWith('scene-') && shows.some((why) => why.startsWith('farthest ')));
  const worst = everyday.reduce((x, y) => (y.length > x.length ? y : x));
  const words = await page.locator('.worst-box > p').innerText();
  assert.match(words, /(misses|invents) a contact .* (um|mm|cm|m)\b.* in a scene of [0-9.]+ (cm|m|km): [0-9.e-]+ of the scene/);
  assert.ok(words.includes(`witness ${worst.id}.`), `${words} for ${worst.id}`);
  assert.equal(await page.locator('.worst-box svg .triangle').count(), 1);
  const sentences = await page.locator('#first .sentences').first().locator('li').allInnerTexts();
  // The cause, where one is known, stands before them.
  assert.ok(sentences.slice(0, 2).some((sentence) => /^[0-9,]+ everyday scenes: /.test(sentence)), sentences[0]);
  assert.ok(sentences.length >= 3);
  // What words mean comes after all results.
  assert.equal(await page.locator('#words #meanings').count(), 1);
  assert.equal(await page.locator('#words details').evaluate((fold) => fold.open), false);
  await close();
});

test('puts families under headings, with lengths where these mean something', async () => {
  const {page, close} = await opened(real);
  const rows = await page.locator('#families-table tbody tr').evaluateAll((all) => all.map((row) => [row.className, row.innerText.replaceAll('\t', ' ')]));
  assert.deepEqual(rows.filter(([kind]) => kind === 'heading').map(([, text]) => text.split(/[,:]/)[0].trim()), ['Everyday scenes', 'Exact', 'Others']);
  assert.match(rows[1][1], /^scene-edge/);
  assert.match(rows[1][1], / (um|mm|cm|m)\b/);
  assert.doesNotMatch(rows.find(([, text]) => text.startsWith('sliver'))[1], /[0-9] (um|mm|cm|m)\b/);
  assert.match(await page.locator('#families-table').innerText(), /0, or not checked, in every row, and left out: .*no answer/);
  await close();
});

test('says first what to do: look at one that is wrong, mend what was required, compare', async () => {
  const {page, close} = await opened(real);
  const steps = await page.locator('#next li').allInnerTexts();
  assert.equal(steps.length, 3);
  assert.match(steps[0], /Look at a wrong verdict of \S+: \S+, wrong by \S+ of the scene(, [0-9.]+ \S+)?\./);
  assert.match(steps[1], /Mend what the requirement names first|Say what has to hold|What was required is met/);
  assert.match(steps[2], /axiscert league --kernel \S+ --kernel \S+/);
  const link = page.locator('#next li a').first();
  const card = decodeURIComponent((await link.getAttribute('href')).slice(1));
  await link.click();
  await page.waitForFunction((id) => document.getElementById(id)?.open, card, {timeout: 20000});
  // Parts that a run did not do are one line, and take no room before it.
  const parts = (await page.locator('#not-checked li').allInnerTexts()).filter((text) => /Not run here/.test(text));
  assert.equal(parts.length, 1);
  for (const id of ['ladder', 'precision', 'maps-list', 'league', 'mutation']) assert.equal(await page.locator(`#${id}`).count(), 0, id);
  assert.doesNotMatch(await page.locator('main').innerText(), /NOT RUN/);
  await close();
});

test('says the answer: counts, depth, a sentence a link, a badge a comparison', async () => {
  const {page, close} = await opened(real);
  const card = page.locator('#answer-cards .card').first();
  const text = await card.innerText();
  const kernel = record_of(real).kernels[0];
  const missed = Object.values(kernel.families).reduce((sum, family) => sum + family.verdict.false_separation, 0);
  assert.match(text, new RegExp(missed.toLocaleString('en-US')));
  for (const link of ['specification', 'rounding', 'range']) assert.match(text, new RegExp(`${link}\\s+in [0-9,]+ wrong verdicts, most on`));
  assert.match(text, /open\s+all 16/i);
  assert.match(await page.locator('#not-checked').innerText(), /axiscert prove/);
  await close();
});

test('lists first one witness of each cause, ordinary numbers before exotic ones', async () => {
  const {page, close} = await opened(real);
  const ids = await page.$$eval('#witnesses-list > details', (all) => all.map((card) => card.id.replace('witness-', '')));
  const witnesses = ids.map((id) => record_of(real).witnesses.find((one) => one.id === id));
  const flip_of = (witness) => witness.flips.find((flip) => flip.level === 'verdict');
  const cause_of = (witness) => JSON.stringify([witness.kernel, flip_of(witness).kind, flip_of(witness).links]);
  const causes = new Set(record_of(real).witnesses.filter(flip_of).map(cause_of));
  assert.ok(causes.size > 3);
  assert.deepEqual(new Set(witnesses.slice(0, causes.size).map(cause_of)), causes);
  assert.ok(!['scale', 'nonfinite'].includes(witnesses[0].family), witnesses[0].family);
  await close();
});

test('sorts a table by pointer and by keyboard', async () => {
  const {page, close} = await opened(real);
  const header = page.locator('#families-table th:has(button)', {hasText: 'false_separation'}).first();
  const place = (await page.locator('#families-table thead tr').last().locator('th').allInnerTexts()).findIndex((name) => name.includes('separation'));
  const column = () => page.$$eval('#families-table tbody tr', (rows, at) => rows.map((row) => Number(row.cells[at].firstChild.textContent.replace(/,/g, ''))), place);
  await header.locator('button').click();
  assert.equal(await header.getAttribute('aria-sort'), 'descending');
  const descending = await column();
  assert.ok(descending[0] > 0);
  assert.deepEqual(descending, [...descending].sort((x, y) => y - x));
  await header.locator('button').focus();
  await page.keyboard.press('Enter');
  assert.equal(await header.getAttribute('aria-sort'), 'ascending');
  assert.deepEqual(await column(), [...descending].reverse().sort((x, y) => x - y));
  await close();
});

// The full text of the heat table's cell for a comparison and a family.
const heat_words = (page, name, family) => page.locator('#heat-tables table').first().evaluate((table, [of, on]) =>
  [...table.querySelectorAll('td')].map((cell) => (cell.querySelector('button') ?? cell).title).find((words) => words.startsWith(`${of} on ${on}: `)), [name, family]);

test('toggles the heat table between figures and kernels', async () => {
  const {page, close} = await opened(real);
  const kernels = record_of(real).kernels;
  const tallies = kernels.map((kernel) => kernel.families.sliver.comparisons['plane.radius']);
  const shows = async (figure, n) => {
    const words = await heat_words(page, 'plane.radius', 'sliver');
    assert.match(words, new RegExp(`^plane.radius on sliver: ${figure} ${n.toLocaleString('en-US')} of 2,000 `));
  };
  assert.ok(tallies[0].masked > 0 && tallies[0].decisive > 0);
  await shows('sign errors', tallies[0].false_separation + tallies[0].missed_separation);
  for (const [label, member] of [['masked', 'masked'], ['decisive', 'decisive'], ['missed_separation', 'missed_separation'], ['tolerance failures', 'tolerance_failures']]) {
    await page.locator('#heat-controls label', {hasText: label}).last().click();
    await shows(label, tallies[0][member]);
  }
  // By keyboard: radio buttons move with the arrows.
  await page.keyboard.press('ArrowLeft');
  await shows('missed_separation', tallies[0].missed_separation);
  await page.locator('#heat-controls select').selectOption({index: 2});
  await shows('missed_separation', tallies[2].missed_separation);
  await close();
});

test('leads from a cell of the heat table to its witnesses', async () => {
  const {page, close} = await opened(real);
  await page.locator('#heat-controls label', {hasText: 'masked'}).click();
  await page.locator('#heat-tables button[aria-label*="plane.radius on sliver"]').click();
  const cards = await page.$$eval('#witnesses-list > details', (all) => all.map((card) => card.id.replace('witness-', '')));
  assert.ok(cards.length > 0);
  const record = record_of(real);
  for (const id of cards) {
    const witness = record.witnesses.find((one) => one.id === id);
    assert.equal(witness.family, 'sliver');
    assert.equal(witness.kernel, 'published');
    assert.ok(witness.flips.some((flip) => flip.name === 'plane.radius' && !flip.decisive), id);
  }
  assert.ok(await page.locator('#witnesses-list > details').first().evaluate((card) => card.open));
  // A card that the filter hides still opens by its address.
  const other = record.witnesses.find((one) => one.family === 'repeated' && one.flips.some((flip) => flip.level === 'verdict'));
  await page.evaluate((id) => { location.hash = `#witness-${id}`; }, other.id);
  await page.waitForSelector(`[id="witness-${other.id}"][open] .body`);
  await close();
});

test('draws the margins of each comparison with the band that errors reach', async () => {
  const {page, close} = await opened(real);
  const figures = page.locator('#margins figure');
  assert.equal(await figures.count(), 16);
  const record = record_of(real);
  const [kernel] = record.kernels;
  const sum = (counts) => Object.values(counts).reduce((x, y) => x + y, 0);
  const shown = async (families) => {
    const tallies = families.map((family) => family.comparisons['plane.radius']);
    const [right, wrong] = ['right', 'wrong'].map((side) => tallies.reduce((n, tally) => n + sum(tally.margins[side]), 0));
    const words = await figures.first().locator('[role="img"]').getAttribute('aria-label');
    assert.match(words, new RegExp(`plane.radius: ${(right + wrong).toLocaleString('en-US')} measured, ${wrong} wrong`));
    return {right, wrong};
  };
  const all = await shown(Object.values(kernel.families));
  assert.ok(all.wrong > 0 && all.right + all.wrong <= 8 * record.plan.margin_queries);
  await page.locator('#margins-controls select').nth(1).selectOption('general');
  assert.equal((await shown([kernel.families.general])).right, record.plan.margin_queries);
  // The band ends where the largest error does: its share of the axis, from the tie's bin on.
  await page.locator('#margins-controls select').nth(1).selectOption('sliver');
  const {band, bins} = await figures.first().evaluate((figure) => ({band: parseFloat(figure.querySelector('.band').style.width), bins: figure.querySelectorAll('.bin').length}));
  const error = kernel.families.sliver.comparisons['plane.radius'].max_error_u;
  assert.ok(Math.abs(band - 100 * Math.min(1, (1 + Math.log2(error) + bins - 25) / bins)) < 0.01, `${band} of ${bins} for ${error}`);
  await page.locator('#margins details summary').click();
  assert.equal(await page.locator('#margins table thead th').count(), 1 + 16);
  assert.doesNotMatch(await page.locator('#not-checked').innerText(), /margins/);
  await close();
});

test('says so where a record has no margins', async () => {
  const older = folder('older');
  fs.copyFileSync(path.join(testdata, 'record.json'), path.join(older, 'record.json'));
  render(older);
  const {page, close} = await opened(older);
  assert.match(await page.locator('#margins').innerText(), /^Not counted/);
  assert.match(await page.locator('#not-checked').innerText(), /Distribution of margins/);
  await close();
});

test('says of the heat table on how many answers a cell rests', async () => {
  const part = folder('part');
  const record = JSON.parse(fs.readFileSync(path.join(testdata, 'record.json'), 'utf8'));
  record.plan.seed = 1;  // the stored one is no number of JavaScript
  const {comparisons} = record.kernels.find(({id}) => id === 'published').families.lattice;
  comparisons['plane.radius'].judged = 100;
  Object.assign(comparisons['vertex_a.radius'], {judged: 0, ...Object.fromEntries(
    ['false_separation', 'missed_separation', 'masked', 'decisive', 'links'].map((figure) => [figure, null]))});
  fs.writeFileSync(path.join(part, 'record.json'), JSON.stringify(record));
  render(part);
  const {page, close} = await opened(part);
  assert.match(await heat_words(page, 'plane.radius', 'lattice'), /sign errors 0 of 100 \(< 29,500 per million, 95 %\)/);
  assert.equal(await page.locator('#heat-tables td[title="not checked: no decided answer had comparisons"]').count(), 1);
  await close();
});

// The stored kernel of verdicts, without a wrong one: it declines all contacts, and the separations too or not.
function declining(name, separations) {
  const into = folder(name);
  const record = JSON.parse(fs.readFileSync(path.join(testdata, 'record.json'), 'utf8'));
  record.kernels = record.kernels.filter(({id}) => id === '<script>');
  Object.assign(record.plan, {kernels: ['<script>'], seed: 1, require: null});
  record.witnesses = [];
  const cleared = (figures) => {
    for (const [member, value] of Object.entries(figures)) {
      if (typeof value === 'number') figures[member] = 0;
      else if (value !== null && typeof value === 'object') cleared(value);
    }
  };
  for (const family of Object.values(record.kernels[0].families)) {
    const {truth, verdict} = family;
    cleared(verdict);
    for (const [link, first] of Object.entries(verdict.first_by_link)) if (first === 0) verdict.first_by_link[link] = null;
    if (family.classes) family.classes = {};
    verdict.undecided_contact = truth.contact;
    verdict.undecided_touching = truth.touching;
    verdict.undecided = truth.contact + (separations ? truth.separated : 0);
    verdict.decided = verdict.decided_separations = separations ? 0 : truth.separated;
  }
  fs.writeFileSync(path.join(into, 'record.json'), JSON.stringify(record));
  render(into);
  return into;
}

test('says nothing of a kind of query that got no verdict', async () => {
  for (const separations of [true, false]) {
    const {page, close} = await opened(declining(`declining-${separations}`, separations));
    const metrics = await page.locator('#answer-cards .metric').allInnerTexts();
    assert.match(metrics[0], /missed contacts\s*not checked\s*deepest: -/i);
    assert.match(metrics[1], separations ? /phantom contacts\s*not checked\s*deepest: -/i : /phantom contacts\s*0\s*\(< [^]*deepest: 0/i);
    const text = await page.locator('main').innerText();
    assert.match(text, separations ? /Nothing was decided, so that nothing is known/ : /Nothing was wrong among 600 verdicts\./);
    if (separations) assert.match(text, /Nothing was decided: there is nothing to draw\./);
    assert.match(text, separations ? /Without a verdict no link shows\./ : /No link broke one of its 600 verdicts\./);
    assert.match(await page.locator('#answer-cards').evaluate((cards) => cards.textContent), /wrong on touching-/);
    await close();
  }
});

test('says by the class of the input why a kernel is wrong that shows only verdicts', async () => {
  const silent = folder('silent');
  const record = JSON.parse(fs.readFileSync(path.join(testdata, 'record.json'), 'utf8'));
  record.kernels = record.kernels.filter(({id}) => id === '<script>');
  record.plan.kernels = ['<script>'];
  record.plan.seed = 1;  // the stored one is no number of JavaScript
  record.witnesses = record.witnesses.filter(({kernel}) => kernel === '<script>');
  fs.writeFileSync(path.join(silent, 'record.json'), JSON.stringify(record));
  render(silent);
  const {page, close} = await opened(silent);
  const why = await page.locator('#links-table').innerText();
  for (const part of ['near_tie', 'sliver', 'ordinary', 'rounding alone may explain it', 'published, wrong on 60 % of the queries']) assert.ok(why.includes(part), `${part}: ${why}`);
  assert.equal(await page.locator('#links-table a[href="#witness-w5"]').count(), 1);
  const where = page.locator('#heat table');
  const names = await where.locator('thead th').allInnerTexts();
  assert.equal(await where.locator('tbody tr', {hasText: 'lattice'}).locator('td').nth(names.indexOf('ordinary') - 1).innerText(), '2');
  assert.match(await page.locator('#bounds table').innerText(), /sliver\s+0.001/);
  for (const section of ['#heat', '#bounds', '#origins']) assert.doesNotMatch(await page.locator(section).innerText(), /unattributed/);
  await close();
});
