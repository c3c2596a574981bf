// Witnesses of a predicate of motions: their picture, what was given beside what is exact, and code to paste.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test, {before} from 'node:test';

import {contrast_faults} from './contrast.mjs';
import {axiscert, folder, opened, record_of, work} from './pages.mjs';

let motions;

before(() => {
  motions = folder('motions');
  const families = ['general', 'approach', 'point', 'line_sweep', 'zero_d', 'scale'].flatMap((name) => ['--family', `moving-sphere/${name}`]);
  const kernels = ['rounded', 'fauerby', 'twenty'].flatMap((name) => ['--kernel', `moving-sphere/${name}`]);
  const run = spawnSync(axiscert, ['run', ...kernels, ...families, '--precision', 'binary32', '--trials', '60', '--seed', '8', '--out', motions],
                        {encoding: 'utf8'});
  assert.equal(run.status, 0, run.stderr);
});

// The first witness that passes, with its card open.
async function card_of(page, wanted) {
  const witness = record_of(motions).witnesses.find(wanted);
  await page.evaluate((id) => { location.hash = `#witness-${id}`; }, witness.id);
  const card = page.locator(`[id="witness-${witness.id}"]`);
  await card.locator('.body').waitFor();
  return {card, witness};
}

const is_missed = (one) => one.truth === 'contact' && one.computed === 'separated';
const is_phantom = (one) => one.truth === 'separated' && one.computed === 'contact' && one.measures?.given.time;

test('draws the capsule, the first contact and the reported one, each with words', async () => {
  const {page, close} = await opened(motions);
  const {card, witness} = await card_of(page, (one) => one.measures?.time === 'late' && one.measures.tunnel > 0.01 && one.family.endsWith('approach'));
  assert.equal(await card.locator('svg .capsule').count(), 2);  // and the legend's
  assert.equal(await card.locator('svg polygon.reported.late').count(), 1);
  assert.equal(await card.locator('svg polygon.ball').count(), 1);
  assert.match(await card.locator('.scene-legend').innerText(), /the path, from P to P \+ D[^]*first contact[^]*reported: late/);
  assert.match(await card.locator('figcaption').innerText(), /First contact after [^]*Reported: late, after [^]*Drawn in binary64 from the exact first contact/);
  const drawn = () => card.locator('svg polygon.triangle').getAttribute('points');
  for (const name of ['Whole', 'Contact', 'Triangle', 'Error of the time']) {
    const before_look = await drawn();
    await card.getByRole('button', {name}).click();
    if (name !== 'Whole') assert.notEqual(await drawn(), before_look, name);
  }
  await card.getByRole('button', {name: 'Whole'}).click();
  assert.match(await card.locator('.scene-note').innerText(), /^Not to scale in this view: the sphere is drawn as a dot, its radius is /);
  const text = await card.locator('table.contact').innerText();
  for (const part of [witness.measures.given.time, witness.exact_contact.time]) assert.ok(text.includes(part), part);
  assert.match(text, /late\s+by [^;]+; tunnel 0\.[0-9]+/);
  await close();
});

test('tells missed and phantom contacts by words as well', async () => {
  const {page, close} = await opened(motions);
  const missed = await card_of(page, is_missed);
  assert.match(await missed.card.locator('.scene-legend').innerText(), /first contact, which the kernel misses/);
  assert.match(await missed.card.locator('svg').first().innerHTML(), /first contact, missed/);
  assert.equal(await missed.card.locator('svg .reported').count(), 0);
  const phantom = await card_of(page, is_phantom);
  assert.match(await phantom.card.locator('.scene-legend').innerText(), /nearest approach: there is no contact[^]*reported: phantom contact/);
  await close();
});

test('has the first contact at a radius from the triangle, whatever the ratios', async () => {
  const {page, close} = await opened(motions);
  const worst = await page.evaluate(async () => {
    const {cards} = await unpacked(document.getElementById('witness-data').textContent.trim());
    return cards.map((card) => ({card, scene: motion_of(card)})).filter(({scene}) => scene?.is_known).map(({card, scene}) => {
      const {point} = closest_point(scene.triangle.map((vertex) => vec.sub(vertex, scene.centre)));
      const overlaps = card.exact_contact.start === 'overlap';
      const error = overlaps ? Math.max(0, vec.size(point) - scene.r) : Math.abs(vec.size(point) - scene.r);
      // The start of the way is as far from A as P is.
      const [a, p] = [card.a.map(parse_hex), card.p.map(parse_hex)];
      const away = vec.size(vec.sub(p, a)) / parse_hex(card.r), drawn = vec.size(vec.sub(scene.start, scene.triangle[0])) / scene.r;
      const misplaced = scene.r > 0 ? Math.abs(drawn - away) / (1 + away) : 0;
      return [Math.max(error / Math.max(scene.r, 1e-7), misplaced), card.id, card.family];
    }).sort(([x], [y]) => y - x)[0];
  });
  assert.ok(worst[0] < 1e-6, worst.join(' '));
  await close();
});

test('finds first contacts that are known without a record', async () => {
  const {page, close} = await opened(motions);
  const found = await page.evaluate(() => [
    contact_by_bisection([[-1, -1, -3], [3, -1, -3], [-1, 3, -3]], [0, 0, -4], 1),
    contact_by_bisection([[2, 1, 0], [6, 1, 0], [2, 5, 0]], [4, 0, 0], 2),
    contact_by_bisection([[-1, -1, -3], [3, -1, -3], [-1, 3, -3]], [0, 0, 4], 1),
  ].map(({is_contact, time, vertices}) => [is_contact, time.toFixed(12), vertices.join('')]));
  assert.deepEqual(found, [[true, '0.500000000000', '012'], [true, (0.5 - Math.sqrt(3) / 4).toFixed(12), '0'], [false, '0.000000000000', '012']]);
  await close();
});

test('gives code with D and times that compiles, and lines that are the witness', async () => {
  const {page, close} = await opened(motions);
  const code = await page.evaluate(async () => {
    const {cards} = await unpacked(document.getElementById('witness-data').textContent.trim());
    return cards.map((card) => [cpp_test(card), c_array(card), json_line(card), card.measures?.time, card.exact_contact?.time]);
  });
  const lines = fs.readFileSync(path.join(motions, 'witnesses.jsonl'), 'utf8').split('\n');
  for (const [, , line] of code) assert.ok(lines.includes(line), line);
  for (const [said, sign] of [['late', '<='], ['early', '>=']]) {
    const asked = code.filter(([, , , time]) => time === said);
    assert.ok(asked.length > 0, said);
    for (const [tests, , , , best] of asked) assert.ok(tests.includes(`time_of_contact(a, b, c, p, d, r) ${sign} ${best}f)`), tests);
  }
  const source = folder('motion_snippets');
  fs.writeFileSync(path.join(source, 'arrays.c'), code.map(([, array]) => array).join('\n') + 'int main(void) { return 0; }\n');
  fs.writeFileSync(path.join(source, 'tests.cpp'), '#define TEST(suite, name) void name()\n#define EXPECT_TRUE(x) (void)(x)\n#define EXPECT_FALSE(x) (void)(x)\n' +
    ['bool in_contact', 'T time_of_contact'].map((name) => `template <class T> ${name}(const T*, const T*, const T*, const T*, const T*, T);\n`).join('') +
    code.map(([tests]) => tests).join('\n'));
  execFileSync('cc', ['-std=c99', '-fsyntax-only', path.join(source, 'arrays.c')], {stdio: 'inherit'});
  execFileSync('c++', ['-std=c++17', '-fsyntax-only', path.join(source, 'tests.cpp')], {stdio: 'inherit'});
  await close();
});

test('chooses witnesses by time, and names comparisons of the predicate', async () => {
  const {page, close} = await opened(motions);
  await page.locator('#witnesses-controls label', {hasText: /^Time/}).locator('select').selectOption({label: 'late'});
  const late = record_of(motions).witnesses.filter((one) => one.measures?.time === 'late').length;
  assert.match(await page.locator('#witnesses-shown').innerText(), new RegExp(`^${late} match`));
  const {card} = await card_of(page, (one) => one.kernel.endsWith('twenty') && one.computed_comparisons
    && one.computed_comparisons !== one.exact_comparisons);
  assert.match(await card.locator('table.bits').innerText(), /(start|end|sweep)\.[a-z_]+/);
  await close();
});

test('draws a motion by its ends, and gives code with them', async () => {
  const ends = folder('ends');
  const run = spawnSync(axiscert, ['run', '--kernel', 'moving-sphere/ends-gated', '--family', 'moving-sphere/ends_approach', '--precision', 'binary32',
                                   '--trials', '60', '--out', ends], {encoding: 'utf8'});
  assert.equal(run.status, 0, run.stderr);
  const {page, close} = await opened(ends);
  const drawn = await page.evaluate(async () => {
    const {cards} = await unpacked(document.getElementById('witness-data').textContent.trim());
    return cards.filter((card) => card.exact_contact?.point).map((card) => {
      const {point} = closest_point(motion_of(card).triangle.map((vertex) => vec.sub(vertex, motion_of(card).centre)));
      return [Math.abs(vec.size(point) - motion_of(card).r) < 1e-6, cpp_test(card), json_line(card)];
    });
  });
  assert.ok(drawn.length > 0);
  const lines = fs.readFileSync(path.join(ends, 'witnesses.jsonl'), 'utf8').split('\n');
  for (const [is_at_r, tests, line] of drawn) {
    assert.ok(is_at_r, line);
    assert.match(tests, /const float p1\[3\][^]*in_contact\(a, b, c, p, p1, r\)/);
    assert.ok(lines.includes(line), line);
  }
  await close();
});

for (const [scheme, width] of [['light', 1400], ['dark', 400]]) {
  test(`shows a motion as it should, ${scheme}, ${width} wide`, async () => {
    const {page, close} = await opened(motions, {colorScheme: scheme, viewport: {width, height: 900}});
    const {card} = await card_of(page, (one) => one.measures?.time === 'late');
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    assert.deepEqual(await page.evaluate(contrast_faults), []);
    await card.screenshot({path: path.join(work, `motion-${scheme}-${width}.png`)});
    await close();
  });
}
