// The data of the page: an index that is read at the start, and records that are decompressed on demand.

async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
}

/** Decodes a list of integer differences to values in units. */
export function summed(steps, unit) {
  let sum = 0;
  return Float64Array.from(steps, (step) => (sum += step) * unit);
}

/** Decodes a motion of the files; adds `offset` seconds to its times. */
export function motionOf(packed, offset = 0) {
  const motion = {
    t: summed(packed.t, 1e-3).map((t) => t + offset),
    x: summed(packed.x, 1e-2),
    y: summed(packed.y, 1e-2),
    yaw: summed(packed.yaw, 1e-3),
  };
  if (packed.v) motion.v = summed(packed.v, 1e-2);
  if (packed.a) motion.a = summed(packed.a, 1e-2);
  return motion;
}

/** Joins `motion` up to the first time of `next` (the joint) with `next` from then on. */
export function continued(motion, next) {
  const place = motion.t.findIndex((t) => t >= next.t[0] - 1e-6);
  const count = place < 0 ? motion.t.length : place;
  return Object.assign(Object.fromEntries(Object.entries(motion).map(
    ([key, values]) => [key, Float64Array.of(...values.subarray(0, count), ...next[key])])), {joint: next.t[0]});
}

const stemOf = (path) => path.split('/').pop().replace(/\.[a-z]+$/, '');

/** Returns the names of files in rows: the stem, or the path if the stem is not unique. */
function namesOf(files) {
  const stems = files.map(({path}) => stemOf(path));
  return stems.map((stem, i) => (stems.indexOf(stem) === stems.lastIndexOf(stem) ? stem : files[i].path));
}

/** The rows of the table, stored as columns of texts and numbers. */
export class Rows {
  constructor(index) {
    this.length = index.rows;
    this.columns = index.columns;
    this.files = index.files;
    this.fileNames = namesOf(index.files);
    this.parts = new Int32Array(this.length); // number of a row among the rows of its line, from 1 on
    for (let row = 0; row < this.length; ++row) {
      const isSame = row > 0 && ['file', 'line'].every((key) => this.number(key, row) === this.number(key, row - 1));
      this.parts[row] = isSame ? this.parts[row - 1] + 1 : 1;
    }
  }

  isTest(row) {
    return this.files[this.number('file', row)].has_tests;
  }

  /** Returns "scenarios:11", or "scenarios:11.2" for the second row of that line. */
  name(row) {
    return `${this.fileNames[this.number('file', row)]}:${this.line(row)}`;
  }

  /** Returns "11" or "11.2". */
  line(row) {
    return this.number('line', row) + (this.parts[row] > 1 ? '.' + this.parts[row] : '');
  }

  /** Returns the row with a name, or of a line of the first file; null if there is none. */
  named(name) {
    for (let row = 0; row < this.length; ++row) {
      if (this.name(row) === name || (this.number('file', row) === 0 && this.line(row) === name)) return row;
    }
    return null;
  }

  text(name, row) {
    const column = this.columns[name];
    return column.words[column.values[row]];
  }

  /** Returns null for a missing number. */
  number(name, row) {
    const column = this.columns[name];
    const value = column.values[row];
    return value === column.missing ? null : value * column.unit;
  }
}

export class Records {
  constructor(text) {
    this.text = text;
    this.lines = null;
    this.read = new Map();
  }

  /** Returns the record with an index; null for the index null. */
  async at(place) {
    if (place === null) return null;
    this.lines = this.lines || this.text.trim().split('\n');
    if (!this.read.has(place)) this.read.set(place, unpacked(this.lines[place]));
    return this.read.get(place);
  }
}

export const readIndex = () => unpacked(document.getElementById('index').textContent);
