// The cards of witnesses, and commands and code to paste.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';

import {first_card, folder, opened, real} from './pages.mjs';

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

test('quotes names in commands as a shell reads them', async () => {
  const {page, close} = await opened(real);
  const names = ['published', 'plugin:/my kernel.so', "it's", '$(touch x)', 'a\nb\'\\', '<script>', '*', ''];
  for (const name of names) {
    const word = await page.evaluate((text) => shell_word(text), name);
    assert.equal(execFileSync('bash', ['-c', `printf %s ${word}`], {encoding: 'utf8'}), name);
  }
  assert.match(await page.locator('#not-checked').innerText(), /axiscert search --kernel published --precision binary32 --out DIR/);
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
