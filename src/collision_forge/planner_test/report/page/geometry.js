// Boxes and motions: m, rad, s after t0; x ahead, y to the left.

/** Returns the index of the last element of `times` at or before `t`; -1 before the first. */
function placeOf(times, t) {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

const turn = (from, to) => Math.atan2(Math.sin(to - from), Math.cos(to - from));

/** Returns the pose of a motion at `t`, interpolated linearly; null before, after and in gaps. */
export function stateAt(motion, t, maxGap = 1.1) {
  const count = motion ? motion.t.length : 0;
  if (!count || t < motion.t[0] - 1e-6 || t > motion.t[count - 1] + 1e-6) return null;
  const i = Math.min(Math.max(placeOf(motion.t, t), 0), count - 1);
  const j = Math.min(i + 1, count - 1);
  const span = motion.t[j] - motion.t[i];
  if (span > maxGap) return null;
  const share = span > 0 ? (t - motion.t[i]) / span : 0;
  const between = (values) => values[i] + share * (values[j] - values[i]);
  return {
    x: between(motion.x),
    y: between(motion.y),
    yaw: motion.yaw[i] + share * turn(motion.yaw[i], motion.yaw[j]),
    v: motion.v ? between(motion.v) : null,
    a: motion.a ? between(motion.a) : null,
  };
}

/** As above, but at rest before the first and after the last state. */
export function heldAt(motion, t) {
  const count = motion.t.length;
  return stateAt(motion, Math.min(Math.max(t, motion.t[0]), motion.t[count - 1]));
}

/** Returns the part of [t - width / 2, t + width / 2] in the motion; the joint of continued() bounds it. */
function windowAt(motion, t, width) {
  const last = motion.t[motion.t.length - 1];
  const [begin, end] = motion.joint === undefined ? [motion.t[0], last]
    : t < motion.joint ? [motion.t[0], motion.joint] : [motion.joint, last];
  return [Math.max(t - width / 2, begin), Math.min(t + width / 2, end)];
}

/** Returns the mean speed along the heading over `width` seconds around t, m/s. */
export function speedAt(motion, t, width = 0.6) {
  const state = stateAt(motion, t);
  if (!state || state.v !== null) return state && state.v;
  const [begin, end] = windowAt(motion, t, width);
  const from = stateAt(motion, begin);
  const to = stateAt(motion, end);
  const span = end - begin;
  if (!from || !to || span <= 0) return null;
  return ((to.x - from.x) * Math.cos(state.yaw) + (to.y - from.y) * Math.sin(state.yaw)) / span;
}

export function accelerationAt(motion, t, width = 1.0) {
  const state = stateAt(motion, t);
  if (!state || state.a !== null) return state && state.a;
  const [from, to] = windowAt(motion, t, width);
  const before = speedAt(motion, from);
  const after = speedAt(motion, to);
  return before === null || after === null || to <= from ? null : (after - before) / (to - from);
}

export function corners(pose, length, width) {
  const c = Math.cos(pose.yaw);
  const s = Math.sin(pose.yaw);
  return [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([ahead, left]) => [
    pose.x + (ahead * length * c - left * width * s) / 2,
    pose.y + (ahead * length * s + left * width * c) / 2]);
}

function distanceToSegment([x, y], [ax, ay], [bx, by]) {
  const length = (bx - ax) ** 2 + (by - ay) ** 2;
  const share = length > 0 ? Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length, 0), 1) : 0;
  return Math.hypot(x - ax - share * (bx - ax), y - ay - share * (by - ay));
}

function areApart(a, b) {
  for (const box of [a, b]) {
    for (let i = 0; i < 2; ++i) {
      const axis = [box[i + 1][0] - box[i][0], box[i + 1][1] - box[i][1]];
      const along = (points) => points.map(([x, y]) => x * axis[0] + y * axis[1]);
      const first = along(a);
      const second = along(b);
      if (Math.max(...first) < Math.min(...second) || Math.max(...second) < Math.min(...first)) return true;
    }
  }
  return false;
}

/** Returns the distance between two boxes given by their corners, m; 0 if they overlap. */
export function gapBetween(a, b) {
  if (!areApart(a, b)) return 0;
  let least = Infinity;
  for (const [points, ring] of [[a, b], [b, a]]) {
    for (const point of points) {
      for (let i = 0; i < 4; ++i) least = Math.min(least, distanceToSegment(point, ring[i], ring[(i + 1) % 4]));
    }
  }
  return least;
}
