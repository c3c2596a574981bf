// The tests that an engine can be asked here, by their ids (`axiscert tests`): how many columns a query has, and which of
// them are lengths, which are not negative.
export const tests = {
  'sphere-triangle': {columns: 13, lengths: [12]},  // ax ay az bx by bz cx cy cz px py pz r
  'moving-sphere': {columns: 16, lengths: [15]},    // the same, with dx dy dz before r: the centre goes from p to p + d
};
