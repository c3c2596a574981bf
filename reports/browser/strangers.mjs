// Text that comes from others: names from plug-ins, meshes and queries, files that other commands left, a file cut off.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import {pathToFileURL} from 'node:url';

import {browser, folder, opened, patient_page, real, render, testdata} from './pages.mjs';

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
  write('mutation.json', {complete: false, score: {binary16: {not_judged: 1}},
    mutants: [mutant('<i>published~swap:17</i>', 'binary32', {caught: true, family: 'lattice', queries: 12}), mutant('published~drop:3', 'binary32'),
              mutant('published~same:1', 'binary32', {equivalent: 'a + b is b + a'}), mutant('published~drop:3', 'binary64', {caught: true}), mutant('published~drop:3', 'binary16')],
    controls: [{kernel: 'packed', precision: 'binary64', claims: 'formulae', queries: 1000, flagged: 3}]});
  const figures = (worst) => Object.fromEntries(['plane', 'vertex_a', 'vertex_b', 'vertex_c', 'edge_ab', 'edge_bc', 'edge_ca']
    .map((axis) => [axis, {false_separation: 1, missed_separation: 2, p99_u: 3, worst_u: worst}]));
  write('ladder.json', {precision: 'binary32', trials: 100, kernels: [['slow', 2], ['fast', 200], ['beaten', 300]].map(([id, worst]) =>
    ({id, families: {general: {queries: 1000, axes: figures(worst)}}})), speed: {kernels: {slow: {scalar: 30}, fast: {scalar: 10}, beaten: {scalar: 20}}}});
  const at = (n) => ({verdict: {false_separation: n, false_contact: n}});
  write('precision.json', {precision: 'binary32', all: {queries: 100, kernels: {published: {precisions: [[8, 40], [24, 5], [64, 0]].map(([bits, n]) =>
    ({bits, unlimited: at(n), limited: at(n + 1)}))}}}});
  write('league.json', {kernels: [{id: 'peer/x', precision: 'binary32', touching: 'either', has_planted_fault: false, ns: 20, families: {general:
    {trials: 10, decided: 10, false_separation: 1, false_contact: 2, undecided: 0, invalid: 0, unanswered: 0, outside_limits: 0, deepest_false_separation: 0.5, deepest_false_contact: 0.25, caught_after: null}}}]});
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
  assert.match(mutation, /binary16: 1 mutants not judged: no query was valid/);
  assert.match(mutation, /published~drop:3\s+binary16\s+not judged/);
  assert.match(mutation, /packed\s+binary64\s+formulae\s+1,000\s+3/);
  assert.equal(await page.locator('.plot canvas').count(), 2);
  await page.locator('#ladder details summary').click();
  assert.match(await page.locator('#ladder table').innerText(), /beaten\s+20\s+3,000/);
  assert.match(await page.locator('#league').innerText(), /peer\/x/);
  assert.doesNotMatch(await page.locator('#not-checked').innerText(), /Not run here/);
  await close();
});

test('says so where the file was cut off', async () => {
  const cut = folder('cut');
  const html = fs.readFileSync(path.join(real, 'report.html'), 'utf8');
  const at = html.indexOf('id="data">') + 1000;
  fs.writeFileSync(path.join(cut, 'report.html'), html.slice(0, at) + html.slice(html.indexOf('</script>', at)));
  const context = await browser.newContext();
  const page = await patient_page(context);
  await page.goto(pathToFileURL(path.join(cut, 'report.html')).href);
  await page.waitForSelector('.banner.bad');
  assert.match(await page.locator('#banner').innerText(), /cannot read its own data: the file was cut off or edited/);
  await context.close();
});
