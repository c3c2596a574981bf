// The tests of which a page shows witnesses, by id; the script of a test's picture adds it. Each has the picture (`figure`), the groups of a
// query's numbers in the order in which people read them (`groups_of(query)`), the name of a suite of tests in code to paste, what is so where
// the two touch, the name of its measure of time and the parts that its
// measure `feature` numbers, the commands that a page of it names, and kernels for a league. A test that is not here has
// its numbers alone.

const page_tests = {};

// A query or a plan names its test unless that is implied.
const page_test_named = (of) => page_tests[of.test ?? ''];
const page_has_command = (plan, command) => page_test_named(plan)?.commands?.includes(command) ?? false;

function page_test_of(query) {
  return page_test_named(query) ?? {groups_of: () => Object.keys(query.decimal ?? {}), figure: null, suite: 'Witness', touching: 'They touch.'};
}

function scene_figure(query) {
  const {figure} = page_test_of(query);
  if (figure === null) return el('p', 'empty', 'There is no picture for this test.');
  return figure(query) ?? el('p', 'empty', 'Not drawn: a number is not finite, or all are zero.');
}
