// The tests of which a page shows witnesses: the groups of a query's numbers in the order in which people read them, the
// picture, the name of a suite of tests in code to paste, and the commands that a page of it names. `groups_of` is for a test with several entries.
// A test that is not here has its numbers alone.

const page_tests = {
  'sphere-triangle': {groups: ['a', 'b', 'c', 'p', 'r'], figure: sphere_triangle_figure, suite: 'SphereTriangle',
                      commands: ['prove', 'search', 'map', 'ladder', 'precision', 'league', 'mutate']},
  'box-box': {groups_of: boxes_groups_of, figure: boxes_figure, suite: 'BoxBox', touching: 'They touch.'},
  'moving-sphere': {groups_of: motion_groups_of, figure: moving_sphere_figure, suite: 'MovingSphere', time: 'time_of_contact',
                    commands: ['search', 'map', 'mutate']},
};

// A query or a plan names its test unless that is implied.
const page_test_named = (of) => page_tests[of.test ?? 'sphere-triangle'];
const page_has_command = (plan, command) => page_test_named(plan)?.commands?.includes(command) ?? false;

function page_test_of(query) {
  const test = page_test_named(query) ?? {groups: Object.keys(query.decimal ?? {}), figure: null, suite: 'Witness'};
  return test.groups_of ? {...test, groups: test.groups_of(query)} : test;
}

function scene_figure(query) {
  const {figure} = page_test_of(query);
  if (figure === null) return el('p', 'empty', 'There is no picture for this test.');
  return figure(query) ?? el('p', 'empty', 'Not drawn: a number is not finite, or all are zero.');
}
