// Elements, numbers and tables. All text is set through textContent: nothing in the data becomes markup.

function el(tag, className, ...children) {
  const node = document.createElement(tag);
  if (className) node.className = className;
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

function count(n) { return n.toLocaleString('en-US'); }

// The number as stored, or rounded to `digits` significant digits.
function amount(x, digits) {
  const value = digits ? Number(x.toPrecision(digits)) : x;
  if (value !== 0 && (value < 1e-3 || value >= 1e15)) return value.toExponential();
  return value.toLocaleString('en-US', {maximumSignificantDigits: 17});
}

// `data` is the page's data; a kernel entry is one kernel in one precision.
function entry_name(entry) { return `${entry.id}, ${entry.precision}`; }

// An error in u: a number, or its text where a number cannot hold it.
// An error that was not measured is null.
function error_amount(error) { return error === null ? 'not measured' : typeof error === 'number' ? amount(error) : error; }
function magnitude(error) {
  if (error === null) return -Infinity;
  if (typeof error === 'number') return Math.log10(error);
  const [mantissa, exponent] = error.split('e');
  return Number(exponent) + Math.log10(Number(mantissa));
}

// "0 (< 11.4 per million, 95 %)": `family` contains its trials, its truth and its limits for zero failures; `wrong` is a
// kind of wrong verdict, which not every query can be.
function rate(n, family, wrong) {
  if (n > 0) {
    const valid = family.trials - family.truth.invalid - (family.verdict.outside_limits?.trials ?? 0);
    return [count(n), `(${amount(1e6 * n / valid, 3)} per million)`];
  }
  const limit = wrong ? family.zero_limits[wrong] : family.zero_limit_per_million;
  return limit === null ? ['not checked', ''] : ['0', `(< ${amount(limit, 3)} per million, 95 %)`];
}

// A record's name, which may wrap after an underscore or a slash, or elsewhere.
function breakable(name, places = /(?<=[_/])/) {
  const node = el('span');
  name.split(places).forEach((part, i) => node.append(...(i ? [el('wbr'), part] : [part])));
  return node;
}

// Columns. `get` maps a row to its value, `key` that value to the number by which it is sorted; `cell` fills the cell.
// `alarm`: a number above zero is bad news. `left`: sorted as a number, but aligned as text.
const column = {
  text: (label, get, more) => ({label, get, cell: (td, value) => td.append(value), ...more}),
  count: (label, get, more) => ({label, get, numeric: true, ...more, cell: (td, value) => {
    td.append(value === null || value === undefined ? more?.none ?? 'not checked' : count(value));
    if (value === 0) td.classList.add('zero');
    if (value > 0 && more?.alarm) td.classList.add(more.alarm);
  }}),
  amount: (label, get, more) => ({label, get, numeric: true, ...more, cell: (td, value) => {
    if (value === null || value === undefined) return td.append(more?.none ?? 'none');
    td.append(amount(value, more?.digits));
    if (more?.digits) td.title = String(value);
    if (value === 0) td.classList.add('zero');
  }}),
  error: (label, get, more) => ({label, get, numeric: true, key: magnitude, ...more, cell: (td, value) => {
    td.append(error_amount(value));
    if (value === 0) td.classList.add('zero');
  }}),
  rate: (wrong, get, family, more) => ({label: wrong, get, numeric: true, ...more, cell: (td, value, row) => {
    const [number, limit] = rate(value, family(row), wrong);
    td.append(number, el('small', '', limit));
    td.classList.add('rate', value > 0 ? more?.alarm ?? 'bad' : 'zero');
  }}),
};

function header_rows(columns, sort) {
  const groups = el('tr', 'groups');
  const names = el('tr');
  for (let i = 0; i < columns.length;) {
    let span = 1;
    while (i + span < columns.length && columns[i + span].group === columns[i].group) ++span;
    const th = el('th', columns[i].group ? 'group' : '', columns[i].group ?? '');
    th.colSpan = span;
    if (columns[i].group) th.scope = 'colgroup';
    groups.append(th);
    i += span;
  }
  for (const c of columns) {
    const button = el('button', '', breakable(c.label));
    button.type = 'button';
    const th = el('th', c.numeric && !c.left ? 'n' : '', button);
    th.scope = 'col';
    if (c.note) button.title = c.note;
    button.addEventListener('click', () => sort(c, th));
    names.append(th);
  }
  return columns.some((c) => c.group) ? [groups, names] : [names];
}

// A table that scrolls by itself where it is too wide, also from the keyboard. `parts` follow its caption.
function scroll_table(caption, className, ...parts) {
  const scroll = el('div', 'scroll', el('table', className, el('caption', '', caption), ...parts));
  scroll.tabIndex = 0;
  scroll.setAttribute('role', 'region');
  scroll.setAttribute('aria-label', caption);
  // Its caption says so where a part of it is out of sight.
  new ResizeObserver(() => scroll.classList.toggle('wide', scroll.scrollWidth > scroll.clientWidth)).observe(scroll);
  return scroll;
}

// The families of the plan by group: [heading, what the list has of them], without empty groups and in the page's order.
// What is of no family comes first, without a heading.
function by_group(data, list, family_of) {
  const of = (families) => list.filter((each) => families.includes(family_of(each)));
  const known = new Set(data.groups.flatMap(({families}) => families));
  return [['', list.filter((each) => !known.has(family_of(each)))],
          ...data.groups.map(({heading, families}) => [heading, of(families)])].filter(([, some]) => some.length > 0);
}

function heading_row(heading, columns) {
  const th = el('th', '', heading);
  th.colSpan = columns;
  th.scope = 'rowgroup';
  return el('tr', 'heading', th);
}

// Lists of columns that fit on a page side by side.
function parts_of(columns, most) {
  const parts = Math.ceil(columns.length / most), size = Math.ceil(columns.length / parts);
  return Array.from({length: parts}, (_, i) => columns.slice(i * size, (i + 1) * size));
}

// A table whose header cells sort it: numbers largest first, then smallest first; texts the other way round. `groups`, from
// by_group, puts rows under headings until they are sorted. A column that `may_go` does so where it is 0 in every row.
function table(caption, all_columns, rows, {row_class, groups} = {}) {
  const columns = all_columns.filter((c) => !c.may_go || rows.some((row) => c.get(row)));
  const gone = all_columns.filter((c) => !columns.includes(c));
  const body = el('tbody');
  const fill = (ordered) => {
    body.replaceChildren(...ordered.map((row) => {
      if (row.is_heading) return heading_row(row.heading, columns.length);
      const tr = el('tr', row_class ? row_class(row) : '');
      columns.forEach((c, i) => {
        const cell = el(i === 0 ? 'th' : 'td', c.numeric && !c.left ? 'n' : '');
        if (i === 0) cell.scope = 'row';
        else cell.dataset.label = c.label;
        c.cell(cell, c.get(row), row);
        tr.append(cell);
      });
      return tr;
    }));
  };
  const head = el('thead');
  head.append(...header_rows(columns, (c, th) => {
    const descending = th.getAttribute('aria-sort') === null ? Boolean(c.numeric)
                                                             : th.getAttribute('aria-sort') === 'ascending';
    head.querySelectorAll('[aria-sort]').forEach((other) => other.removeAttribute('aria-sort'));
    th.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
    const key = (row) => (c.key ? c.key(c.get(row)) : c.numeric ? c.get(row) ?? -1 : String(c.get(row)));
    const order = (x, y) => (key(x) < key(y) ? -1 : key(x) > key(y) ? 1 : 0);
    fill([...rows].sort((x, y) => (descending ? order(y, x) : order(x, y))));
  }));
  fill(groups ? groups.flatMap(([heading, some]) => (heading === '' ? some : [{heading, is_heading: true}, ...some])) : rows);
  const scroll = scroll_table(caption, '', head, body);
  if (gone.length === 0) return scroll;
  const names = gone.map(({label, group}) => (group ? `${label} (${group})` : label));
  return el('div', '', scroll, el('p', 'label', `0, or not checked, in every row, and left out: ${names.join(', ')}.`));
}

// A labelled choice; `change` is called with the index of the chosen option.
function choice(label, options, change) {
  const select = el('select');
  options.forEach((text) => select.append(el('option', '', text)));
  select.addEventListener('change', () => change(select.selectedIndex));
  return el('label', '', label, select);
}

function copy_button(text) {
  const button = el('button', 'copy', 'Copy');
  button.type = 'button';
  button.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = 'Copied';
    } catch {
      button.textContent = 'Select it by hand';
    }
    setTimeout(() => { button.textContent = 'Copy'; }, 1500);
  });
  return button;
}

// A word of a shell's command, quoted where it needs to be, like shell_word in reports/wording/reproduce.cpp. A page's
// text is Unicode, so bytes need no other form; control characters are written as numbers.
function shell_word(text) {
  if (/^[A-Za-z0-9_.\/:=,-]+$/.test(text)) return text;
  if (!/[\u0000-\u001f\u007f]/.test(text)) return `'${text.replaceAll("'", "'\\''")}'`;
  const code = (c) => `\\${c.codePointAt(0).toString(8).padStart(3, '0')}`;
  return `$'${text.replace(/['\\]/g, '\\$&').replace(/[\u0000-\u001f\u007f]/g, code)}'`;
}

function command(text) { return el('div', 'command', el('pre', '', el('code', '', text)), copy_button(text)); }

function chip(text, kind) { return el('span', `chip ${kind ?? ''}`, text); }

// On paper nothing that `folds` selects is folded.
function unfold_on_paper(folds) {
  let opened = [];
  addEventListener('beforeprint', () => {
    opened = [...document.querySelectorAll(folds)].filter((fold) => !fold.open);
    for (const fold of opened) fold.open = true;
  });
  addEventListener('afterprint', () => { for (const fold of opened) fold.open = false; });
}
