// The two boxes of a query, given by matrices or by quaternions.

const box_groups = {matrix: ['m', 's', 'b.0', 'b.1', 'b.2'], quaternion: ['m', 's', 'q']};

function boxes_entry(query) { return (query['a.q'] ?? query.decimal?.['a.q']) ? 'quaternion' : 'matrix'; }
function boxes_groups_of(query) {
  return ['a', 'b'].flatMap((box) => box_groups[boxes_entry(query)].map((group) => `${box}.${group}`));
}

// The columns of the rotation by a quaternion of any length.
function columns_of_quaternion([w, x, y, z]) {
  const n = w * w + x * x + y * y + z * z;
  return [[w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)],
          [2 * (x * y - w * z), w * w + y * y - x * x - z * z, 2 * (y * z + w * x)],
          [2 * (x * z + w * y), 2 * (y * z - w * x), w * w + z * z - x * x - y * y]].map((v) => vec.mul(v, 1 / n));
}

// Both boxes seen from the middle between their centres, each as its centre and its three half edges, scaled so that
// the farthest corner is at 1; null where a number is not finite or all are zero.
function boxes_of(query) {
  const near = near_one(query, ['a.m', 'a.s', 'b.m', 'b.s']);
  if (near === null) return null;
  const numbers = (group) => query[group].map(parse_hex);
  const box = (name) => {
    const columns = boxes_entry(query) === 'quaternion' ? columns_of_quaternion(numbers(`${name}.q`))
      : ['b.0', 'b.1', 'b.2'].map((group) => numbers(`${name}.${group}`));
    return {centre: near[`${name}.m`], edges: columns.map((column, k) => vec.mul(column, near[`${name}.s`][k]))};
  };
  const [a, b] = [box('a'), box('b')];
  const half = vec.mul(vec.sub(b.centre, a.centre), 0.5);
  [a.centre, b.centre] = [vec.mul(half, -1), half];
  const reach = ({centre, edges}) => vec.size(centre) + edges.map(vec.size).reduce((x, y) => x + y);
  const scale = Math.max(reach(a), reach(b));
  if (!(scale > 0 && scale < Infinity)) return null;
  return [a, b].map(({centre, edges}) => ({centre: vec.mul(centre, 1 / scale), edges: edges.map((e) => vec.mul(e, 1 / scale))}));
}

// The six facets, each by its four corners.
function facets_of({centre, edges}) {
  return [0, 1, 2].flatMap((k) => [-1, 1].map((side) => {
    const [u, v] = [edges[(k + 1) % 3], edges[(k + 2) % 3]];
    const middle = vec.add(centre, vec.mul(edges[k], side));
    return [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([s, t]) => vec.add(middle, vec.add(vec.mul(u, s), vec.mul(v, t))));
  }));
}

class BoxesView extends SceneView {
  constructor(scene) { super(scene, 'Two boxes'); }

  looks() {
    const around = ({centre, edges}) => [centre, 1.3 * Math.max(1e-9, edges.map(vec.size).reduce((x, y) => x + y))];
    return {Whole: [[0, 0, 0], 1.05], 'Box A': around(this.scene[0]), 'Box B': around(this.scene[1])};
  }

  shapes() {
    const [a, b] = this.scene;
    return [...facets_of(a).map((facet) => this.area(facet, 'triangle')), ...facets_of(b).map((facet) => this.area(facet, 'ball')),
            ...facets_of(b).map((facet) => this.line([...facet, facet[0]], 'ring')),
            this.dot(a.centre, 'vertex'), this.dot(b.centre, 'centre'), ...this.labels([[a.centre, 'A'], [b.centre, 'B']])];
  }
}

function boxes_figure(query) {
  const scene = boxes_of(query);
  return scene === null ? null : scene_box(new BoxesView(scene), 'Drawn in binary64; the truth next to it is exact.');
}

page_predicates['box-box'] = {groups_of: boxes_groups_of, figure: boxes_figure, suite: 'BoxBox', touching: 'They touch.'};
