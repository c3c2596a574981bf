// Tests report.html in Debian's Chromium, from disk and without a network: node page_test.mjs AXISCERT TESTDATA WORK
//   AXISCERT  the command; TESTDATA  reports/testdata; WORK  a folder of the build tree, for runs, npm's packages, screenshots
// Every test opens pages that the command rendered; the run's seed is in the plan below.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';

import {contrast_faults} from './contrast.mjs';

const [axiscert, testdata, work] = process.argv.slice(2).map((given) => path.resolve(given));
const here = path.dirname(new URL(import.meta.url).pathname);

// Installs the packages of package-lock.json in the build tree. Where they are not available the tests fail: nothing is
// skipped.
function browser_driver() {
  const packages = path.join(work, 'npm');
  fs.mkdirSync(packages, {recursive: true});
  for (const file of ['package.json', 'package-lock.json']) fs.copyFileSync(path.join(here, file), path.join(packages, file));
  const require = createRequire(path.join(packages, 'package.json'));
  const wanted = JSON.parse(fs.readFileSync(path.join(here, 'package.json'), 'utf8')).devDependencies['playwright-core'];
  try {
    if (require('playwright-core/package.json').version === wanted) return require('playwright-core');
  } catch { /* not there yet */ }
  const npm = spawnSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {cwd: packages, encoding: 'utf8', timeout: 120000});
  if (npm.status !== 0) {
    throw new Error(`playwright-core ${wanted} could not be installed into ${packages} (npm ci: ${npm.error?.message ?? npm.stderr.trim()}); ` +
                    'the report is NOT tested in a browser. Give npm a registry that it can reach, and run this test again.');
  }
  return require('playwright-core');
}

function chromium_path() {
  const found = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find((file) => fs.existsSync(file));
  if (!found) throw new Error('no /usr/bin/chromium: install the Debian package chromium');
  return found;
}

function folder(name) {
  const made = path.join(work, name);
  fs.rmSync(made, {recursive: true, force: true});
  fs.mkdirSync(made, {recursive: true});
  return made;
}

function render(into) { execFileSync(axiscert, ['report', into], {stdio: ['ignore', 'ignore', 'inherit']}); }

// A real run: three kernels, and families that break every link but the implementation's.
const plan = ['--kernel', 'published', '--kernel', 'nonstrict', '--kernel', 'published+fma', '--precision', 'binary32',
              '--trials', '2000', '--seed', '8', '--tolerance', '50', '--require', 'logic'];
const families = ['general', 'tangent', 'sliver', 'repeated', 'scale', 'nonfinite'].flatMap((name) => ['--family', name]);

let browser, real;

before(async () => {
  const {chromium} = browser_driver();
  real = folder('real');
  const run = spawnSync(axiscert, ['run', ...plan, ...families, '--out', real], {encoding: 'utf8'});
  assert.equal(run.status, 1, `the run has wrong verdicts by specification, so exits 1: ${run.stderr}`);
  // A container's root has no user namespaces for the sandbox; the page that is opened is our own file.
  const args = process.getuid() === 0 ? ['--no-sandbox'] : [];
  browser = await chromium.launch({executablePath: chromium_path(), args, headless: true});
});

after(async () => { await browser?.close(); });

// Opens a page without a network; the test fails on any error, error message, or request other than for the file.
async function opened(into, options = {}) {
  const context = await browser.newContext({viewport: {width: 1440, height: 900}, ...options});
  await context.setOffline(true);
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const page = await context.newPage();
  page.setDefaultTimeout(120000);  // a machine may be busy
  const problems = [];
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) problems.push(message.text()); });
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) problems.push(`asks for ${request.url()}`); });
  await page.goto(pathToFileURL(path.join(into, 'report.html')).href);
  await page.waitForSelector('body.ready');
  return {page, close: async () => {
    await context.close();
    assert.deepEqual(problems, []);
  }};
}

const record_of = (into) => JSON.parse(fs.readFileSync(path.join(into, 'record.json'), 'utf8'));

test('opens from disk without a network, an error or an empty section', async () => {
  const {page, close} = await opened(real);
  assert.equal(await page.title(), 'axiscert report');
  const empty = await page.$$eval('main > section:not([hidden])', (sections) =>
    sections.filter((section) => section.textContent.trim().length < 60).map((section) => section.id));
  assert.deepEqual(empty, []);
  const order = await page.$$eval('main > section', (sections) => sections.map((section) => section.id));
  assert.deepEqual(order, ['findings', 'answer', 'heat', 'bounds', 'origins', 'maps', 'witnesses', 'counts', 'others', 'reproduce', 'not-checked-part']);
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

test('sorts a table by pointer and by keyboard', async () => {
  const {page, close} = await opened(real);
  const header = page.locator('#families-table th:has(button)', {hasText: 'false_separation'}).first();
  const column = () => page.$$eval('#families-table tbody tr', (rows) => rows.map((row) => Number(row.cells[7].firstChild.textContent.replace(/,/g, ''))));
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
const heat_words = (page, name, place) => page.locator('#heat-tables table').first().locator('tr', {hasText: name})
  .locator('td').nth(place).evaluate((cell) => (cell.querySelector('button') ?? cell).title);

test('toggles the heat table between figures and kernels', async () => {
  const {page, close} = await opened(real);
  const kernels = record_of(real).kernels;
  const tallies = kernels.map((kernel) => kernel.families.sliver.comparisons['plane.radius']);
  const place = 1 + Object.keys(kernels[0].families).indexOf('sliver');
  const shows = async (figure, n) => {
    const words = await heat_words(page, 'plane.radius', place);
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

// The card of the deepest witness that the page has.
async function first_card(page) {
  const card = page.locator('#witnesses-list > details').first();
  await card.locator('summary').first().focus();
  await page.keyboard.press('Enter');
  await card.locator('.body').waitFor();
  const id = (await card.getAttribute('id')).replace('witness-', '');
  return {card, witness: record_of(real).witnesses.find((one) => one.id === id)};
}

test('draws a witness that turns, and marks its nearest feature', async () => {
  const {page, close} = await opened(real);
  const {card} = await first_card(page);
  const drawn = () => card.locator('svg .triangle').getAttribute('points');
  const before_turn = await drawn();
  assert.ok(await card.locator('svg .feature').count() === 1);
  assert.match(await card.locator('figcaption').innerText(), /^Nearest feature: (the face|edge [A-C]{2}|vertex [A-C])\./);
  await card.locator('svg').focus();
  await page.keyboard.press('ArrowRight');
  const turned = await drawn();
  assert.notEqual(turned, before_turn);
  const box = await card.locator('svg').boundingBox();
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 160, box.y + 130, {steps: 4});
  await page.mouse.up();
  assert.notEqual(await drawn(), turned);
  await card.getByRole('button', {name: 'Nearest point'}).click();
  assert.match(await drawn(), /^-?[0-9.]+,/);
  await close();
});

test('finds the nearest feature of triangles whose nearest feature is known', async () => {
  const {page, close} = await opened(real);
  const found = await page.evaluate(() => [
    [[-1, -1, 1], [1, -1, 1], [0, 2, 1]], [[1, -1, 0], [1, 1, 0], [3, 0, 0]], [[1, 0, 0], [2, 1, 0], [2, -1, 0]],
    [[1, -1, 0], [1, 1, 0], [1, 3, 0]], [[2, 2, 2], [2, 2, 2], [2, 2, 2]],
  ].map((triangle) => { const {feature, vertices, point} = closest_point(triangle); return [feature, vertices.join(''), point.map((x) => x + 0)]; }));
  assert.deepEqual(found, [['face', '012', [0, 0, 1]], ['edge', '01', [1, 0, 0]], ['vertex', '0', [1, 0, 0]],
                           ['edge', '01', [1, 0, 0]], ['vertex', '0', [2, 2, 2]]]);
  const numbers = await page.evaluate(() => ['0x1.99999ap-3', '-0x1p+0', '0x0.0000000000001p-1022', '0x1.fffffffffffffp+1023', '-0x0p+0', 'nan'].map(parse_hex).map(String));
  assert.deepEqual(numbers, ['0.20000000298023224', '-1', '5e-324', '1.7976931348623157e+308', '0', 'NaN']);
  await close();
});

test('shows exact and computed sides, hex and decimal, links and the command', async () => {
  const {page, close} = await opened(real);
  const {card, witness} = await first_card(page);
  const text = await card.innerText();
  for (const value of [...witness.a, ...witness.p, witness.r, witness.address]) assert.ok(text.includes(value), value);
  for (const [name, {exact, computed, error_u}] of Object.entries(witness.sides)) {
    const rows = await card.locator('table.sides tbody').innerText();
    assert.ok(rows.includes(name) && rows.includes(exact.margin) && rows.includes(computed.lhs), name);
    assert.ok(error_u === null || typeof error_u === 'number' || typeof error_u === 'string');
  }
  assert.match(text, /axiscert query '8:/);
  await close();
});

test('gives code that compiles and lines that are the witness', async () => {
  const {page, close} = await opened(real);
  const code = await page.evaluate(async () => {
    const {cards} = await unpacked(document.getElementById('witness-data').textContent.trim());
    const chosen = [...cards.slice(0, 20), ...cards.filter((card) => card.family === 'nonfinite').slice(0, 5)];
    const evil = {...cards[0], id: 'w"*/\\', kernel: '*/ #error\n#error \\', family: '\\\n#error', address: '??/\n#error'};
    return [...chosen, evil].map((card) => [cpp_test(card), c_array(card), json_line(card), card.id]);
  });
  const lines = fs.readFileSync(path.join(real, 'witnesses.jsonl'), 'utf8').split('\n');
  for (const [, , line] of code.slice(0, -1)) assert.ok(lines.includes(line), line);
  const source = folder('snippets');
  fs.writeFileSync(path.join(source, 'arrays.c'), code.map(([, array]) => array).join('\n') + 'int main(void) { return 0; }\n');
  fs.writeFileSync(path.join(source, 'tests.cpp'), '#include <cmath>\n#define TEST(suite, name) void name()\n#define EXPECT_TRUE(x) (void)(x)\n#define EXPECT_FALSE(x) (void)(x)\n' +
    'template <class T> bool in_contact(const T*, const T*, const T*, const T*, T);\ntemplate <class T> bool is_refused(const T*, const T*, const T*, const T*, T);\n' +
    code.map(([tests]) => tests).join('\n'));
  execFileSync('cc', ['-std=c99', '-fsyntax-only', '-trigraphs', path.join(source, 'arrays.c')], {stdio: 'inherit'});
  execFileSync('c++', ['-std=c++17', '-fsyntax-only', path.join(source, 'tests.cpp')], {stdio: 'inherit'});
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
  assert.ok(all.wrong > 0 && all.right + all.wrong <= 6 * record.plan.margin_queries);
  await page.locator('#margins-controls select').nth(1).selectOption('general');
  assert.equal((await shown([kernel.families.general])).right, record.plan.margin_queries);
  // The band ends where the largest error does: its share of the axis, from the tie's bin on.
  await page.locator('#margins-controls select').nth(1).selectOption('sliver');
  const {band, bins} = await figures.first().evaluate((figure) => ({band: parseFloat(figure.querySelector('.band').style.width), bins: figure.querySelectorAll('.bin').length}));
  const error = kernel.families.sliver.comparisons['plane.radius'].max_error_u;
  assert.ok(Math.abs(band - 100 * Math.min(1, (1 + Math.log2(error) + bins - 25) / bins)) < 0.01, `${band} of ${bins} for ${error}`);
  await page.locator('#margins details summary').click();
  assert.equal(await page.locator('#margins table tbody tr').count(), 16);
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
  assert.match(await where.locator('tr', {hasText: 'ordinary'}).innerText(), /0\s+2/);
  assert.match(await page.locator('#bounds table').innerText(), /sliver\s+0.001/);
  for (const section of ['#heat', '#bounds', '#origins']) assert.doesNotMatch(await page.locator(section).innerText(), /unattributed/);
  await close();
});

test('quotes names in commands as a shell reads them', async () => {
  const {page, close} = await opened(real);
  const names = ['published', 'plugin:/my kernel.so', "it's", '$(touch x)', 'a\nb\'\\', '<script>', '*', ''];
  for (const name of names) {
    const word = await page.evaluate((text) => shell_word(text), name);
    assert.equal(execFileSync('bash', ['-c', `printf %s ${word}`], {encoding: 'utf8'}), name);
  }
  assert.match(await page.locator('#bounds-missing').innerText(), /--kernel published /);
  await page.locator('#bounds-controls select').selectOption({index: 2});
  assert.match(await page.locator('#bounds-missing').innerText(), /--kernel 'published\+fma' /);
  await close();
});

test('copies a command', async () => {
  const {page, close} = await opened(real);
  const place = page.locator('#run-command');
  await place.getByRole('button').click();
  await page.waitForFunction(() => document.querySelector('#run-command button').textContent === 'Copied');
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(copied, await place.locator('code').innerText());
  assert.match(copied, /^axiscert run --kernel published --kernel nonstrict --kernel 'published\+fma'/);
  await close();
});

test('shows names from plug-ins, meshes and queries as text', async () => {
  const evil = folder('evil');
  const name = '<script>window.evil = 1</script><img src=x onerror="window.evil = 1">';
  const text = fs.readFileSync(path.join(testdata, 'record.json'), 'utf8');
  fs.writeFileSync(path.join(evil, 'record.json'), text.replaceAll('<script>', JSON.stringify(name).slice(1, -1)).replaceAll('a|b.obj', '<b onclick=evil()>.obj'));
  attach(evil);
  render(evil);
  const {page, close} = await opened(evil);
  assert.equal(await page.locator('#answer-cards h3 .name').nth(1).innerText(), name);
  for (const card of await page.locator('#witnesses-list > details').all()) await card.locator('summary').first().click();
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => window.evil), undefined);
  assert.equal(await page.evaluate(() => document.scripts.length), 3);
  assert.equal(await page.evaluate(() => document.querySelectorAll('img:not(.map-picture img), b, [onclick], [onerror]').length), 0);
  await close();
});

// Writes the files that other commands leave in a run's folder, in the forms that attachments.h describes, with names
// that would be markup.
function attach(into) {
  const write = (file, value) => fs.writeFileSync(path.join(into, file), typeof value === 'string' ? value : JSON.stringify(value));
  const png = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==', 'base64');
  fs.mkdirSync(path.join(into, 'maps'));
  fs.writeFileSync(path.join(into, 'maps', 'plane.png'), png);
  fs.writeFileSync(path.join(into, 'maps', 'large.png'), Buffer.concat([png, Buffer.alloc(1_100_000)]));
  const side = (numbers) => ({numbers, pixels: 1, origin: 0, step: 1});
  const picture = (level, name, wrong) => ({level, name, file: `${level}.png`, counts: {false_separation: wrong, yes: 1}});
  for (const file of ['verdict', 'axis']) fs.copyFileSync(path.join(into, 'maps', 'plane.png'), path.join(into, 'maps', `${file}.png`));
  fs.renameSync(path.join(into, 'maps', 'large.png'), path.join(into, 'maps', 'comparison.png'));
  write('maps/index.json', {
    legend: [{class: 'false_separation', colour: '#d55e00', meaning: '<b>yes wrongly</b>'}, {class: 'yes', colour: 'red;background:url(x)', meaning: 'yes'}],
    maps: [{name: 'plane', kernel: '<script>', precision: 'binary32', kind: 'ulps', along: side('p.x'), across: side('r'), command: 'axiscert map w1',
            witness: {id: 'w1'}, pictures: [picture('verdict', 'verdict', 0), picture('axis', 'plane', 3), picture('comparison', 'plane.radius', 2)]}]});
  write('proofs.json', {comparisons: [{name: 'plane.radius', formulae: 'published', precision: 'binary32', status: 'proved', proved_u: 640, attained_u: 346.2},
                                      {name: 'vertex_a.radius', formulae: 'published', precision: 'binary32', status: 'open'}]});
  write('search.json', {kernel: 'published', precision: 'binary32', comparisons: [{name: 'plane.radius', attained_u: 350, proved_u: null}, {name: 'vertex_a.radius', attained_u: 7.9, proved_u: null}]});
  const mutant = (name, precision, more) => ({name, precision, caught: false, ...more});
  write('mutation.json', {complete: false,
    mutants: [mutant('<i>published~swap:17</i>', 'binary32', {caught: true, family: 'lattice', queries: 12}), mutant('published~drop:3', 'binary32'),
              mutant('published~same:1', 'binary32', {equivalent: 'a + b is b + a'}), mutant('published~drop:3', 'binary64', {caught: true})],
    controls: [{kernel: 'packed', precision: 'binary64', claims: 'formulae', queries: 1000, flagged: 3}]});
  const figures = (worst) => Object.fromEntries(['plane', 'vertex_a', 'vertex_b', 'vertex_c', 'edge_ab', 'edge_bc', 'edge_ca']
    .map((axis) => [axis, {false_separation: 1, missed_separation: 2, p99_u: 3, worst_u: worst}]));
  write('ladder.json', {precision: 'binary32', trials: 100, kernels: [['slow', 2], ['fast', 200], ['beaten', 300]].map(([id, worst]) =>
    ({id, queries: 1000, axes: figures(worst)})), speed: {kernels: {slow: {scalar: 30}, fast: {scalar: 10}, beaten: {scalar: 20}}}});
  const at = (n) => ({verdict: {false_separation: n, false_contact: n}});
  write('precision.json', {precision: 'binary32', all: {queries: 100, kernels: {published: {precisions: [[8, 40], [24, 5], [64, 0]].map(([bits, n]) =>
    ({bits, unlimited: at(n), limited: at(n + 1)}))}}}});
  write('league.json', {kernels: [{id: 'peer/x', precision: 'binary32', touching: 'either', has_planted_fault: false, ns: 20, families: {general:
    {trials: 10, answered: 10, false_separation: 1, false_contact: 2, unanswered: 0, deepest_false_separation: 0.5, deepest_false_contact: 0.25, caught_after: null}}}]});
}

test('shows what other commands left in the folder, and links what it leaves out', async () => {
  const full = folder('full');
  fs.copyFileSync(path.join(testdata, 'record.json'), path.join(full, 'record.json'));
  attach(full);
  render(full);
  const {page, close} = await opened(full);
  const bounds = await page.locator('#bounds-table').innerText();
  assert.match(bounds, /plane\.radius\s+proved\s+3\.5\s+350\s+640\s+× 1\.83/);
  assert.match(bounds, /vertex_a\.radius\s+searched\s+1\.25\s+7\.9\s+none\s+open/);
  const maps = page.locator('#maps-list');
  assert.ok(await maps.locator('img').evaluate((image) => image.decode().then(() => image.naturalWidth === 1)));
  assert.match(await maps.innerText(), /to the right p\.x, one ulp a pixel, upwards r/);
  assert.match(await maps.locator('.map-picture').innerText(), /^plane maps\/axis\.png/);
  await maps.locator('select').selectOption({label: 'plane.radius: 2 wrong'});
  assert.match(await maps.innerText(), /Left out of this file for its size, 1,100,0[0-9]{2} bytes/);
  assert.equal(await maps.locator('a[href="maps/comparison.png"]').count(), 1);
  const mutation = await page.locator('#mutation').innerText();
  assert.match(mutation, /INCOMPLETE/);
  assert.match(mutation, /binary32: 1 of 2 mutants caught; 1 equivalent/);
  assert.match(mutation, /binary64: 1 of 1 mutants caught; 0 equivalent/);
  assert.match(mutation, /published~drop:3\s+binary64\s+yes/);
  assert.match(mutation, /packed\s+binary64\s+formulae\s+1,000\s+3/);
  assert.equal(await page.locator('.plot canvas').count(), 2);
  await page.locator('#ladder details summary').click();
  assert.match(await page.locator('#ladder table').innerText(), /beaten\s+20\s+3,000/);
  assert.match(await page.locator('#league').innerText(), /peer\/x/);
  assert.doesNotMatch(await page.locator('#not-checked').innerText(), /not run here/);
  await close();
});

for (const scheme of ['light', 'dark']) {
  test(`has the contrast of WCAG AA, ${scheme}, on screen and on paper`, async () => {
    const {page, close} = await opened(real, {colorScheme: scheme});
    await page.evaluate(() => document.querySelectorAll('details').forEach((some) => { some.open = true; }));
    await page.waitForTimeout(300);
    assert.deepEqual(await page.evaluate(contrast_faults), []);
    await page.emulateMedia({media: 'print', colorScheme: scheme});
    assert.deepEqual(await page.evaluate(contrast_faults), []);
    assert.equal(await page.locator('nav').isVisible(), false);
    await close();
  });

  test(`looks as it should, ${scheme}: screenshots for people`, async () => {
    const {page, close} = await opened(real, {colorScheme: scheme});
    await first_card(page);
    await page.evaluate(() => document.activeElement.blur());
    const into = path.join(work, `report-${scheme}.png`);
    await page.screenshot({path: into, fullPage: true});
    assert.ok(fs.statSync(into).size > 50000);
    // Nothing extends beyond the sides of a wide or of a narrow screen.
    for (const width of [1440, 420]) {
      await page.setViewportSize({width, height: 800});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} wide`);
    }
    await close();
  });
}

test('reaches everything by keyboard', async () => {
  const {page, close} = await opened(real);
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.className), 'skip');
  // Every element that answers a click is reached by the keyboard and has a name that can be read out.
  const nameless = await page.$$eval('button, a, select, summary, input, [tabindex="0"]', (all) => all.filter((node) =>
    !(node.textContent.trim() || node.getAttribute('aria-label') || node.labels?.[0]?.innerText || node.hidden || node.closest('[hidden]'))).map((node) => node.outerHTML.slice(0, 120)));
  assert.deepEqual(nameless, []);
  await close();
});

test('prints', async () => {
  const {page, close} = await opened(real);
  const file = path.join(work, 'report.pdf');
  await page.pdf({path: file, preferCSSPageSize: true});
  assert.ok(fs.statSync(file).size > 20000);
  await close();
});

test('says so where the file was cut off', async () => {
  const cut = folder('cut');
  const html = fs.readFileSync(path.join(real, 'report.html'), 'utf8');
  const at = html.indexOf('id="data">') + 1000;
  fs.writeFileSync(path.join(cut, 'report.html'), html.slice(0, at) + html.slice(html.indexOf('</script>', at)));
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(pathToFileURL(path.join(cut, 'report.html')).href);
  await page.waitForSelector('.banner.bad');
  assert.match(await page.locator('#banner').innerText(), /cannot read its own data: the file was cut off or edited/);
  await context.close();
});
