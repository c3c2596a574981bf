// Tests report.html in Debian's Chromium, from disk and without a network: node page_test.mjs AXISCERT TESTDATA WORK
//   AXISCERT  the command; TESTDATA  reports/testing; WORK  a folder of the build tree, for runs, npm's packages, screenshots
// How it looks is in looks_test.mjs. Every test opens pages that the command rendered; the run's seed is in the plan in pages.mjs.
import './figures.mjs';
import './cards.mjs';
import './motions.mjs';
import './strangers.mjs';
