// Parts that the tests of a page share: the browser, a real run, and pages opened from disk without a network.
// Arguments of the program: AXISCERT, the command; TESTDATA, reports/testing; WORK, a folder of the build tree.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';

export const [axiscert, testdata, work] = process.argv.slice(2).map((given) => path.resolve(given));
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
                    'the report is NOT tested in a browser. Give npm a registry that it can reach, and run this predicate again.');
  }
  return require('playwright-core');
}

function chromium_path() {
  const found = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find((file) => fs.existsSync(file));
  if (!found) throw new Error('no /usr/bin/chromium: install the Debian package chromium');
  return found;
}

export function folder(name) {
  const made = path.join(work, name);
  fs.rmSync(made, {recursive: true, force: true});
  fs.mkdirSync(made, {recursive: true});
  return made;
}

export function render(into) { execFileSync(axiscert, ['report', into], {stdio: ['ignore', 'ignore', 'inherit']}); }

// A real run: three kernels, and families that break every link but the implementation's.
const plan = ['--kernel', 'published', '--kernel', 'nonstrict', '--kernel', 'published+fma', '--precision', 'binary32',
              '--trials', '2000', '--seed', '8', '--tolerance', '50', '--require', 'logic'];
const families = ['general', 'tangent', 'sliver', 'repeated', 'scale', 'nonfinite', 'lattice', 'scene-edge'].flatMap((name) => ['--family', name]);

// The browser, and the folder of the real run: set before the first test.
export let browser, real;

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

// A page that waits: a machine may be busy.
export async function patient_page(context) {
  const page = await context.newPage();
  page.setDefaultTimeout(120000);
  return page;
}

// Opens a page without a network; the test fails on any error, error message, or request other than for the file.
export async function opened(into, options = {}, file = 'report.html') {
  const context = await browser.newContext({viewport: {width: 1440, height: 900}, ...options});
  await context.setOffline(true);
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const page = await patient_page(context);
  const problems = [];
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) problems.push(message.text()); });
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) problems.push(`asks for ${request.url()}`); });
  await page.goto(pathToFileURL(path.join(into, file)).href);
  if (file === 'report.html') await page.waitForSelector('body.ready');
  return {page, close: async () => {
    await context.close();
    assert.deepEqual(problems, []);
  }};
}

export const record_of = (into) => JSON.parse(fs.readFileSync(path.join(into, 'record.json'), 'utf8'));

// The first card that the page lists.
export async function first_card(page) {
  const card = page.locator('#witnesses-list > details').first();
  await card.locator('summary').first().focus();
  await page.keyboard.press('Enter');
  await card.locator('.body').waitFor();
  const id = (await card.getAttribute('id')).replace('witness-', '');
  return {card, witness: record_of(real).witnesses.find((one) => one.id === id)};
}
