// The tests of which a page shows witnesses: the groups of a query's numbers in the order in which people read them, the
// picture, and the name of a suite of tests in code to paste. A test that is not here has its numbers alone.

const page_tests = {
  'sphere-triangle': {groups: ['a', 'b', 'c', 'p', 'r'], figure: sphere_triangle_figure, suite: 'SphereTriangle'},
  'moving-sphere': {groups: motion_groups, figure: moving_sphere_figure, suite: 'MovingSphere', time: 'time_of_contact'},
};

// A query names its test unless that is the first.
function page_test_of(query) {
  return page_tests[query.test ?? 'sphere-triangle'] ?? {groups: Object.keys(query.decimal ?? {}), figure: null, suite: 'Witness'};
}

function scene_figure(query) {
  const {figure} = page_test_of(query);
  if (figure === null) return el('p', 'empty', 'There is no picture for this test.');
  return figure(query) ?? el('p', 'empty', 'Not drawn: a number is not finite, or all are zero.');
}
