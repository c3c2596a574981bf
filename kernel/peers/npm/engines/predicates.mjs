// The predicates that an engine can be asked here, by their ids (`axiscert predicates`), and where one has several entries by
// PREDICATE/ENTRY: how many columns a query has, which of them are lengths, which are not negative, and how many measures
// there are beside the verdict. `isNone` says of finite numbers whether they are no query for another reason; a box
// whose axes are no basis is left to those who are asked.
const isZero = (q, from, to) => q.subarray(from, to).every((x) => x === 0);

export const predicates = {
  'sphere-triangle': {columns: 13, lengths: [12], measures: 8},  // ax ay az bx by bz cx cy cz px py pz r
  'moving-sphere': {columns: 16, lengths: [15], measures: 8},    // the same, with dx dy dz before r: the centre goes from p to p + d
  // Each box: the centre, three half extents, then three axes or w x y z.
  'box-box/matrix': {columns: 30, lengths: [3, 4, 5, 18, 19, 20], measures: 10},
  'box-box/quaternion': {columns: 20, lengths: [3, 4, 5, 13, 14, 15], measures: 10, isNone: (q) => isZero(q, 6, 10) || isZero(q, 16, 20)},
  // The box, then ax ay az bx by bz cx cy cz. minmax: the box is its least and its greatest corner.
  'box-triangle/centre': {columns: 15, lengths: [3, 4, 5], measures: 10},
  'box-triangle/minmax': {columns: 15, lengths: [], measures: 10, isNone: (q) => q[0] > q[3] || q[1] > q[4] || q[2] > q[5]},
  'box-triangle/matrix': {columns: 24, lengths: [3, 4, 5], measures: 10},
};
