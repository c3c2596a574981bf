// Tests how report.html looks in Debian's Chromium, light, dark and on paper: contrast, widths, the keyboard. Arguments as of page_test.mjs.
import './appearance.mjs';
