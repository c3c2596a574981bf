// How a page looks, prints and is reached: contrast, screenshots, keyboard.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';

import {contrast_faults} from './contrast.mjs';
import {axiscert, first_card, folder, opened, real, work} from './pages.mjs';

for (const scheme of ['light', 'dark']) {
  test(`has the contrast of WCAG AA, ${scheme}, on screen and on paper`, async () => {
    const {page, close} = await opened(real, {colorScheme: scheme});
    await page.evaluate(() => document.querySelectorAll('details').forEach((some) => { some.open = true; }));
    await page.waitForTimeout(300);
    assert.deepEqual(await page.evaluate(contrast_faults), []);
    await page.emulateMedia({media: 'print', colorScheme: scheme});
    assert.deepEqual(await page.evaluate(contrast_faults), []);
    assert.equal(await page.locator('nav').isVisible(), false);
    // Paper does not scroll: no table has a shade at its edge, or says that it goes on.
    assert.deepEqual(await page.locator('.scroll').evaluateAll((all) => all.filter((box) => {
      const caption = box.querySelector('caption');
      return getComputedStyle(box).backgroundImage !== 'none' || (caption && getComputedStyle(caption, '::after').content.includes('scroll'));
    }).length), 0);
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
    for (const width of [1440, 1280, 400]) {
      await page.setViewportSize({width, height: 800});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} wide`);
    }
    await close();
  });
}

test('cuts no table on a screen of 1,280 pixels, whatever is unfolded', async () => {
  const {page, close} = await opened(real, {viewport: {width: 1280, height: 800}});
  await page.evaluate(() => document.querySelectorAll('details').forEach((some) => { some.open = true; }));
  await page.waitForTimeout(500);
  const tables = page.locator('.scroll:has(> table)');
  assert.ok(await tables.count() > 20);
  assert.deepEqual(await tables.evaluateAll((all) => all.filter((box) => box.scrollWidth > box.clientWidth).map((box) => box.innerText.slice(0, 200))), []);
  await close();
});

// The pages of instruments, each with what it is made by.
for (const [name, ...words] of [['certificate', 'certify', 'published', '--effort', 'smoke', '--quiet'], ['league', 'league', 'published', 'certified', '--trials', '256', '--no-speed'],
                                ['ladder', 'ladder', '--trials', '64', '--no-speed']]) {
  test(`shows a ${name} whole on screens of 1,440, 1,280 and 400 pixels`, async () => {
    const into = folder(name);
    execFileSync(axiscert, [...words, '--out', into], {stdio: ['ignore', 'ignore', 'inherit']});
    const {page, close} = await opened(into, {}, `${name}.html`);
    const boxes = async (which) => page.locator(which).evaluateAll((all) => all.filter((box) => box.scrollWidth > box.clientWidth).map((box) => box.innerText.slice(0, 200)));
    for (const width of [1440, 1280, 400]) {
      await page.setViewportSize({width, height: 800});
      await page.waitForTimeout(1000);  // plots are drawn anew
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width} wide`);
      assert.deepEqual(await boxes('.first .scroll'), [], `the first table, ${width} wide`);
    }
    await page.screenshot({path: path.join(work, `${name}.png`)});
    await page.setViewportSize({width: 1280, height: 800});
    await page.evaluate(() => document.querySelectorAll('details').forEach((some) => { some.open = true; }));
    assert.deepEqual(await boxes('.scroll'), []);
    await close();
  });
}

test('says of each table that is cut on a narrow screen that it goes on', async () => {
  const {page, close} = await opened(real, {viewport: {width: 400, height: 800}});
  await page.waitForTimeout(300);
  const tables = await page.locator('.scroll[aria-label]:has(> table)').evaluateAll((all) => all.filter((box) => !box.closest('details:not([open])')).map((box) => ({
    name: box.getAttribute('aria-label'), is_cut: box.scrollWidth > box.clientWidth,
    says_so: getComputedStyle(box.querySelector('caption'), '::after').content.includes('goes on to the right')})));
  assert.ok(tables.some(({is_cut}) => is_cut));
  assert.deepEqual(tables.filter(({is_cut, says_so}) => is_cut !== says_so), []);
  await close();
});

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

test('prints, with everything unfolded but the cards of witnesses', async () => {
  const {page, close} = await opened(real);
  const open = () => page.locator('details:not(.witness)').evaluateAll((all) => all.filter((fold) => fold.open).length);
  const before = await open();
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.equal(await open(), await page.locator('details:not(.witness)').count());
  assert.equal(await page.locator('details.witness[open]').count(), 0);
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await open(), before);
  const file = path.join(work, 'report.pdf');
  await page.pdf({path: file, preferCSSPageSize: true});
  assert.ok(fs.statSync(file).size > 20000);
  await close();
});
