// The tests that an engine can be asked here, by their ids (`axiscert tests`): how many columns a query has, which of
// them are lengths, which are not negative, and how many measures there are beside the verdict.
export const tests = {
  'sphere-triangle': {columns: 13, lengths: [12], measures: 0},  // ax ay az bx by bz cx cy cz px py pz r
  'moving-sphere': {columns: 16, lengths: [15], measures: 8},    // the same, with dx dy dz before r: the centre goes from p to p + d
};
