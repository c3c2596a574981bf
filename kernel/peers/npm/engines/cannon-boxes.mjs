// cannon-es, in double.
//   box   Narrowphase.getContacts of two Boxes
//   axes  ConvexPolyhedron.findSeparatingAxis of theirs, without the clipping that follows it
import {Body, Box, Quaternion, Vec3, World} from 'cannon-es';

import {deepest, pair, serve, verdictOf} from './frame.mjs';
import {said} from './cannon-loaded.mjs';
import {form} from './triangle.mjs';
import {quaternions} from './box.mjs';

const world = new World();
const vector = (v) => new Vec3(v[0], v[1], v[2]);
const turnOf = ({x, y, z, w}) => new Quaternion(x, y, z, w);
const bodyOf = ({m, s, turn}) => new Body({mass: 0, shape: new Box(vector(s)), position: vector(m), quaternion: turnOf(turn)});

function touches(a, b) {
  const contacts = [], first = bodyOf(a);
  world.narrowphase.getContacts([first], [bodyOf(b)], world, contacts, [], [], []);
  return pair(verdictOf(contacts.length > 0), deepest(contacts.map((one) => said(one, first))));
}

function meets(a, b) {
  const [hullA, hullB] = [a, b].map(({s}) => new Box(vector(s)).convexPolyhedronRepresentation);
  return verdictOf(hullA.findSeparatingAxis(hullB, vector(a.m), turnOf(a.turn), vector(b.m), turnOf(b.turn), new Vec3()));
}

const asked = form({'box': touches, 'axes': meets});
await serve(async () => quaternions(asked));
