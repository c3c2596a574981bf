// The predicates of which a page shows witnesses, by id; the script of a predicate's picture adds it. Each has the picture (`figure`), the groups of a
// query's numbers in the order in which people read them (`groups_of(query)`), the name of a suite of predicates in code to paste, what is so where
// the two touch, the name of its measure of time and the parts that its
// measure `feature` numbers, the commands that a page of it names, and kernels for a league. A predicate that is not here has
// its numbers alone.

const page_predicates = {};

// A query or a plan names its predicate unless that is implied.
const page_predicate_named = (of) => page_predicates[of.predicate ?? ''];
const page_has_command = (plan, command) => page_predicate_named(plan)?.commands?.includes(command) ?? false;

function page_predicate_of(query) {
  return page_predicate_named(query) ?? {groups_of: () => Object.keys(query.decimal ?? {}), figure: null, suite: 'Witness', touching: 'They touch.'};
}

function scene_figure(query) {
  const {figure} = page_predicate_of(query);
  if (figure === null) return el('p', 'empty', 'There is no picture for this predicate.');
  return figure(query) ?? el('p', 'empty', 'Not drawn: a number is not finite, or all are zero.');
}
