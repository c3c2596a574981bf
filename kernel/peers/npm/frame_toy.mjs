// An engine for frame_test.py, which needs no package. The number ax says what it does.
import {CONTACT, hit, SEPARATED, serve, UNDECIDED, verdictOf} from './engines/frame.mjs';

// A WebAssembly module whose function `trap` is one instruction, unreachable.
const trapping = new WebAssembly.Module(Uint8Array.of(
  0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 8, 1, 4, 116, 114, 97, 112, 0, 0, 10, 5, 1, 3, 0, 0, 11));

let made = 0;
async function make() {
  ++made;
  const {trap} = new WebAssembly.Instance(trapping).exports;
  const answer = (q) => {
    switch (q[0]) {
      case 0: return verdictOf(q[12] >= 1);
      case 1: throw new Error('this shape is refused');
      case 2: trap(); return CONTACT;
      case 3: console.log('a line for the console'); return SEPARATED;
      case 4: return verdictOf(made === 1);  // contact until it is made anew
      case 5: for (let i = 0; i < 10000; ++i) console.error('another line'); return CONTACT;
      case 6: throw 'Aborted(native code called abort())';
      case 7: return 'contact';
      default: return UNDECIDED;
    }
  };
  // A contact after half of the way for dz = 7, with a time that is none for dz = 8, and without a word on it for dz = 9.
  const moving = (q) => {
    switch (q[14]) {
      case 7: return hit(0.5, [0, 0, 1]);
      case 8: return hit(NaN);
      case 9: return CONTACT;
      default: return SEPARATED;
    }
  };
  const boxes = (q) => verdictOf(q[q.length - 1] === 7);
  return {'sphere-triangle': answer, 'moving-sphere': moving, 'box-triangle/centre': boxes, 'box-triangle/minmax': boxes,
          'box-box/quaternion': boxes};
}

await serve(make);
