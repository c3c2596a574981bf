// The motion of a query: the triangle, the sphere's path as a capsule, the sphere at the first contact and at the time that
// a kernel reported.

// A query has its displacement, or the end of its motion.
function motion_groups_of(query) {
  return ['a', 'b', 'c', 'p', query.p1 ? 'p1' : 'd', 'r'];
}

// The least distance of the motion, and the first contact where there is one, by bisection: for a query of which nothing
// exact is at hand. `triangle` is seen from P; `truth` is the exact verdict where that is known. The distance is convex
// over time, and falls as long as the nearest point is ahead.
function contact_by_bisection(triangle, d, r, truth) {
  const towards = (t) => closest_point(triangle.map((vertex) => vec.sub(vertex, vec.mul(d, t))));
  const first = (holds, end) => {
    let [before, after] = [0, end];
    if (holds(0)) return 0;
    for (let i = 0; i < 200; ++i) {
      const middle = (before + after) / 2;
      if (middle === before || middle === after) break;
      [before, after] = holds(middle) ? [before, middle] : [middle, after];
    }
    return after;
  };
  const least = first((t) => t >= 1 || vec.dot(towards(t).point, d) <= 0, 1);
  const is_within = vec.size(towards(least).point) <= r;
  const time = is_within && truth !== 'separated' ? first((t) => vec.size(towards(t).point) <= r, least) : least;
  const {point, vertices} = towards(time);
  return {is_contact: truth ? truth === 'contact' : is_within, time, vertices, to_centre: vec.mul(point, -1), point: vec.add(vec.mul(d, time), point)};
}

// The vertices of a part of the triangle by its name in a record, such as edge_ab.
function vertices_of(feature) {
  return feature === 'face' ? [0, 1, 2] : [...feature.split('_')[1]].map((letter) => 'abc'.indexOf(letter));
}

// The motion seen from X, the triangle's point that is touched first, or else comes nearest: what is near X keeps its
// digits however long the way and however far the origin. Scaled so that the greatest length is 1. Null where a number
// is not finite or all are zero.
function motion_of(witness) {
  const near = near_one(witness, motion_groups_of(witness));
  if (near === null) return null;
  const {a, b, c, p, r, unit} = near;
  const d = near.d ?? vec.sub(near.p1, p);
  const known = witness.exact_contact?.point ? witness.exact_contact : null;
  let x_from_a, to_centre, vertices, time, after = 0, is_contact = true;
  if (known) {
    x_from_a = known.point_from_a.map(unit);
    const overlaps = known.start === 'overlap';
    to_centre = overlaps ? vec.sub(vec.sub(p, a), x_from_a) : vec.mul(known.normal ?? [0, 0, 0], r);
    [time, after] = [parse_hex(known.time), known.after_time];
    vertices = vertices_of(known.features[0]);
  } else {
    const found = contact_by_bisection([a, b, c].map((vertex) => vec.sub(vertex, p)), d, r, witness.truth);
    ({time, vertices, to_centre, is_contact} = found);
    x_from_a = vec.sub(found.point, vec.sub(a, p));
  }
  const along = (t) => vec.add(to_centre, vec.mul(d, (t - time) - after));
  const scene = {r, d, vertices, is_contact, is_known: known !== null, time,
                 triangle: [a, b, c].map((vertex) => vec.sub(vec.sub(vertex, a), x_from_a)),
                 centre: to_centre, start: along(0), end: along(1), reported: null};
  const scale = Math.max(...scene.triangle.map(vec.size), vec.size(scene.start), vec.size(scene.end), vec.size(d), Math.abs(r));
  if (!(scale > 0)) return null;
  const given = witness.measures?.given ?? {};
  const told = parse_hex(given.time ?? '');
  if (Number.isFinite(told) && Math.abs(told) <= 4) {
    const verdict = witness.measures.time ?? 'phantom';
    const touched = ['point_x', 'point_y', 'point_z'].map((name) => unit(parse_hex(given[name] ?? '')));
    scene.reported = {time: told, verdict, centre: along(told), error: Math.abs((told - time) - after),
                      point: touched.every(Number.isFinite) ? vec.sub(vec.sub(touched, a), x_from_a) : null};
  }
  scene.is_missed = witness.truth === 'contact' && witness.computed === 'separated';
  const shrink = (v) => vec.mul(v, 1 / scale);
  for (const member of ['d', 'centre', 'start', 'end']) scene[member] = shrink(scene[member]);
  scene.triangle = scene.triangle.map(shrink);
  scene.r /= scale;
  if (scene.reported) {
    scene.reported.centre = shrink(scene.reported.centre);
    if (scene.reported.point) scene.reported.point = shrink(scene.reported.point);
  }
  return scene;
}

const reported_words = {late: 'late', early: 'early', best: 'at the best time', invalid: 'outside [0, 1]', phantom: 'phantom contact'};

class MovingSphereView extends SceneView {
  constructor(scene) { super(scene, 'Triangle, path of the sphere, first contact and reported contact'); }

  // The contact comes first where the whole would show it as a dot.
  looks() {
    const {triangle, r, d, start, end, centre, reported} = this.scene;
    const corners = [...triangle, start, end];
    const range = [0, 1, 2].map((k) => [Math.min(...corners.map((v) => v[k])), Math.max(...corners.map((v) => v[k]))]);
    const middle = range.map(([low, high]) => (low + high) / 2);
    const whole = [middle, 1.15 * (r + Math.max(...corners.map((v) => vec.size(vec.sub(v, middle)))))];
    const size = Math.max(...triangle.map((vertex) => vec.size(vec.sub(vertex, triangle[0]))));
    const contact = [vec.mul(centre, 0.5), 2.2 * r || 0.7 * size || 0.2 * vec.size(d) || whole[1]];
    const looks = whole[1] > 15 * contact[1] ? {Contact: contact, Whole: whole} : {Whole: whole, Contact: contact};
    if (size > 0) looks.Triangle = [vec.mul(triangle.reduce(vec.add), 1 / 3), 1.3 * size];
    const error = reported ? reported.error * vec.size(d) : 0;
    if (error > 0) looks['Error of the time'] = [[0, 0, 0], 3 * error];
    return looks;
  }

  // Around X there is no limit but that of binary64's range.
  limits() { return {least: 1e-30, greatest: 8}; }

  // The way from P to P + D, but for what is so far outside the picture that its digits would be lost.
  way() {
    const {d, centre, start, end} = this.scene;
    const dd = vec.dot(d, d);
    if (!(dd > 0)) return {from: start, to: start, is_whole: true};
    const reach = 30 * this.extent / Math.sqrt(dd), here = vec.dot(vec.sub(this.middle, centre), d) / dd;
    const [back, ahead] = [-vec.dot(vec.sub(centre, start), d) / dd, vec.dot(vec.sub(end, centre), d) / dd];
    const within = (s) => Math.min(ahead, Math.max(back, s));
    const [from, to] = [within(here - reach), within(here + reach)];
    const at = (s, whole, point) => (s === whole ? point : vec.add(centre, vec.mul(d, s)));
    return {from: at(from, back, start), to: at(to, ahead, end), is_whole: from === back && to === ahead};
  }

  capsule(from, to) {
    const radius = this.scene.r * this.scale();
    if (radius === 0) return [];
    const [u, v] = [this.place(from), this.place(to)];
    const turned = Math.atan2(v[1] - u[1], v[0] - u[0]);
    const half = Math.PI / 2;
    return [this.shape('polygon', [...arc(v, radius, turned - half, turned + half), ...arc(u, radius, turned + half, turned + 3 * half)],
                       'capsule')];
  }

  arrow(from, to) {
    const [u, v] = [this.place(from), this.place(to)];
    const length = Math.hypot(v[0] - u[0], v[1] - u[1]);
    if (length < 12) return [];
    const [x, y] = [(v[0] - u[0]) / length, (v[1] - u[1]) / length];
    const wing = (side) => [v[0] - 9 * x + side * 4 * y, v[1] - 9 * y - side * 4 * x];
    return [this.shape('polyline', [wing(1), v, wing(-1)], 'way-head')];
  }

  shapes() {
    const {triangle, r, centre, start, end, vertices, reported, is_contact, is_missed} = this.scene;
    const {from, to, is_whole} = this.way();
    const names = [...triangle.map((point, i) => [point, 'ABC'[i]]), [start, 'P'], [end, 'P+D'],
                   [centre, is_missed ? 'first contact, missed' : is_contact ? 'first contact' : 'nearest']];
    const told = reported === null ? [] : [
      ...this.sphere(reported.centre, r, `reported ${reported.verdict}`, false), this.dot(reported.centre, `reported-centre ${reported.verdict}`),
      ...(reported.point ? [this.dot(reported.point, 'reported-point', 6)] : [])];
    if (reported) names.push([reported.centre, reported_words[reported.verdict]]);
    return [...this.capsule(from, to), ...(is_whole ? [start, end] : []).flatMap((point) => this.sphere(point, r, 'end', false)),
            this.line([from, to], 'way'), ...this.arrow(from, to), this.area(triangle, 'triangle'),
            this.feature(vertices.map((i) => triangle[i])), ...this.sphere(centre, r, is_missed ? 'ball missed' : 'ball'),
            this.line([centre, [0, 0, 0]], 'gap'), ...told, ...triangle.map((vertex) => this.dot(vertex, 'vertex')),
            this.dot(start, 'centre'), this.dot(centre, 'centre'), this.dot([0, 0, 0], 'nearest'), ...this.labels(names)];
  }

  caution() {
    const {r, d, triangle} = this.scene;
    const said = [];
    const size = Math.max(...triangle.map((vertex) => vec.size(vec.sub(vertex, triangle[0]))));
    const share = (length) => amount(length / (2 * this.extent), 2);
    const is_dot = (length) => length > 0 && length * this.scale() < 3;
    if (is_dot(r)) said.push(`the sphere is drawn as a dot, its radius is ${share(r)} of the picture's width`);
    if (is_dot(size)) said.push(`the triangle is drawn as a dot, its size is ${share(size)} of the picture's width`);
    if (!this.way().is_whole) said.push(`the way is cut off, it is ${share(vec.size(d))} times as long as the picture is wide`);
    return said.length === 0 ? '' : `Not to scale in this view: ${said.join('; ')}.`;
  }
}

// Every sphere of the picture with the look of its outline and its meaning in words: no colour stands alone.
function motion_legend({is_contact, is_missed, reported}) {
  const item = (className, words) => el('li', '', svg('svg', {class: 'scene scene-key', viewBox: '0 0 30 14', 'aria-hidden': 'true'},
    svg('line', {x1: 1, y1: 7, x2: 29, y2: 7, class: className})), words);
  const items = [item('capsule', 'the path, from P to P + D'),
                 is_missed ? item('ball missed', 'first contact, which the kernel misses')
                   : item('ball', is_contact ? 'first contact' : 'nearest approach: there is no contact')];
  if (reported) items.push(item(`reported ${reported.verdict}`, `reported: ${reported_words[reported.verdict]}`));
  if (reported?.point) items.push(el('li', '', svg('svg', {class: 'scene scene-key', viewBox: '0 0 30 14', 'aria-hidden': 'true'},
    svg('circle', {cx: 15, cy: 7, r: 5, class: 'reported-point'})), 'reported point of the triangle'));
  return el('ul', 'scene-legend', ...items);
}

function motion_words({is_contact, is_known, time, r, d, vertices, reported, is_missed}, measures) {
  const letters = vertices.map((i) => 'ABC'[i]).sort().join('');
  const part = vertices.length === 3 ? 'the face' : `${vertices.length === 1 ? 'vertex' : 'edge'} ${letters}`;
  const at = `after ${amount(time, 6)} of the way, ${is_contact ? 'with' : 'to'} ${part}`;
  const words = [is_contact ? `First contact ${at}.` : `No contact; nearest ${at}.`];
  if (reported) words.push(`Reported: ${reported_words[reported.verdict]}, after ${amount(reported.time, 6)} of it.`);
  else if (is_missed) words.push('Reported: no contact.');
  else if (measures?.time === 'none') words.push('Reported: a contact without a time.');
  else if (measures?.time === 'invalid') words.push('Reported: a time far outside [0, 1].');
  if (measures?.tunnel) words.push(`${is_missed ? 'On its way' : 'Until then'} the sphere goes in by ${error_amount(measures.tunnel)} of its radius.`);
  words.push(r > 0 ? `|D| is ${amount(vec.size(d) / r, 3)} r.` : 'r is 0: a point.');
  words.push(is_known ? 'Drawn in binary64 from the exact first contact.' : 'Drawn in binary64; the times are computed there as well.');
  return words.join(' ');
}

function moving_sphere_figure(witness) {
  const scene = motion_of(witness);
  return scene === null ? null
    : scene_box(new MovingSphereView(scene), motion_legend(scene), motion_words(scene, witness.measures));
}

page_predicates['moving-sphere'] = {
  groups_of: motion_groups_of, figure: moving_sphere_figure, suite: 'MovingSphere', touching: 'The least distance is exactly r.',
  parts: ['vertex_a', 'vertex_b', 'vertex_c', 'edge_ab', 'edge_bc', 'edge_ca', 'face'], time: 'time_of_contact',
  commands: ['search', 'map', 'mutate'],
};
