// The top view: map, traffic, ego and attacker at one time, drawn on a canvas.
import {corners, heldAt, stateAt} from './geometry.js';
import {summed} from './records.js';

const GHOST_STEP = 1; // s between the pale boxes from t0 to the end
const ARROW_SPACING = 18; // m along a centreline
const SMALL = ['pedestrian', 'child', 'runner', 'bicycle', 'scooter', 'animal'];

const lineOf = (packed) => [summed(packed.x, 1e-2), summed(packed.y, 1e-2)];

function addLine(path, [x, y], isRing) {
  x.forEach((value, i) => (i ? path.lineTo(value, y[i]) : path.moveTo(value, y[i])));
  if (isRing) path.closePath();
}

/** The outlines and lines of a map, created once and drawn at any zoom. */
class MapPaths {
  constructor(map) {
    this.drivable = map.drivable.map((area) => this.areaOf(area));
    this.walkways = map.walkways.map((area) => this.areaOf(area));
    this.outlines = new Path2D();
    map.outlines.forEach((ring) => addLine(this.outlines, lineOf(ring), true));
    this.lanes = new Path2D();
    this.connectors = new Path2D();
    this.arrows = [];
    map.lanes.forEach((lane) => {
      const line = lineOf(lane);
      addLine(lane.connector ? this.connectors : this.lanes, line, false);
      if (!lane.connector) this.addArrows(line);
    });
  }

  areaOf(area) {
    const path = new Path2D();
    area.rings.forEach((ring) => addLine(path, lineOf(ring), true));
    return path;
  }

  addArrows([x, y]) {
    let next = ARROW_SPACING / 2;
    let way = 0;
    for (let i = 1; i < x.length; ++i) {
      const step = Math.hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
      for (; step > 0 && next < way + step; next += ARROW_SPACING) {
        const share = (next - way) / step;
        this.arrows.push({
          x: x[i - 1] + share * (x[i] - x[i - 1]), y: y[i - 1] + share * (y[i] - y[i - 1]),
          yaw: Math.atan2(y[i] - y[i - 1], x[i] - x[i - 1]),
        });
      }
      way += step;
    }
  }
}

export class TopView {
  /** `colors` returns the current colour of a name. */
  constructor(canvas, colors) {
    this.canvas = canvas;
    this.colors = colors;
    this.world = null;
    this.isFollowing = false;
    this.pointers = new Map();
    this.context = canvas.getContext('2d');
    new ResizeObserver(() => this.resize()).observe(canvas);
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY);
    }, {passive: false});
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    });
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    for (const end of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
  }

  /** `world`: map, others, roles ({motion, length, width, color, ...}), aim, contact, focus, rightwards. */
  show(world) {
    this.world = world;
    this.cos = Math.cos(world.rightwards);
    this.sin = Math.sin(world.rightwards);
    this.paths = world.map && new MapPaths(world.map);
    this.resize();
    this.fit();
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(this.height * ratio);
    if (this.world && !this.scale && this.width) this.fit();
    this.draw();
  }

  /** Returns the displacement on the ground of a step to the right and up in the rotated view. */
  turned([x, y]) {
    return [this.cos * x + this.sin * y, this.cos * y - this.sin * x];
  }

  turnedBack([x, y]) {
    return [this.cos * x - this.sin * y, this.cos * y + this.sin * x];
  }

  /** Fits all paths from t0 on into the view. */
  fit() {
    const places = this.world.focus.map((place) => this.turned(place));
    if (!places.length || !this.width) return;
    const range = (k) => [Math.min(...places.map((place) => place[k])), Math.max(...places.map((place) => place[k]))];
    const [left, right] = range(0);
    const [bottom, top] = range(1);
    this.middle = this.turnedBack([(left + right) / 2, (bottom + top) / 2]);
    this.scale = Math.min(this.width / (right - left + 24), this.height / (top - bottom + 24), 18);
    this.draw();
  }

  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const before = this.placeAt(x, y);
    this.scale = Math.min(Math.max(this.scale * factor, 0.8), 80);
    if (!this.isFollowing) {
      const after = this.placeAt(x, y);
      this.middle = [this.middle[0] + before[0] - after[0], this.middle[1] + before[1] - after[1]];
    }
    this.draw();
  }

  placeAt(x, y) {
    const step = this.turnedBack([(x - this.width / 2) / this.scale, (this.height / 2 - y) / this.scale]);
    return [this.middle[0] + step[0], this.middle[1] + step[1]];
  }

  /** Moves the map with one finger or the mouse, zooms with two fingers. */
  onMove(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.offsetX, event.offsetY];
    const other = [...this.pointers.entries()].find(([id]) => id !== event.pointerId);
    this.pointers.set(event.pointerId, now);
    if (other) {
      const reach = (point) => Math.hypot(point[0] - other[1][0], point[1] - other[1][1]);
      this.zoom(reach(now) / Math.max(reach(before), 1), ...other[1]);
      return;
    }
    const step = this.turnedBack([(before[0] - now[0]) / this.scale, (now[1] - before[1]) / this.scale]);
    this.middle = [this.middle[0] + step[0], this.middle[1] + step[1]];
    this.draw();
  }

  at(time) {
    this.time = time;
    this.draw();
  }

  draw() {
    if (!this.world || !this.width || !this.scale) return;
    const {context} = this;
    const ratio = window.devicePixelRatio || 1;
    const followed = this.world.roles.find((role) => role.isFollowed);
    if (this.isFollowing && followed) {
      const state = heldAt(followed.motion, this.time);
      this.middle = [state.x, state.y];
    }
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = this.colors('ground');
    context.fillRect(0, 0, this.width, this.height);
    const zoom = ratio * this.scale;
    const [right, up] = this.turned(this.middle);
    context.setTransform(zoom * this.cos, zoom * this.sin, zoom * this.sin, -zoom * this.cos,
      ratio * (this.width / 2 - right * this.scale), ratio * (this.height / 2 + up * this.scale));
    this.pixel = 1 / this.scale; // m
    if (this.paths) this.drawMap();
    this.drawOthers();
    this.drawAim();
    this.world.roles.forEach((role) => this.drawWay(role));
    this.world.roles.forEach((role) => this.drawRole(role));
    this.drawContact();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.drawScaleBar();
    this.drawNorth();
  }

  drawMap() {
    const {context, paths} = this;
    const fill = (areas, color) => {
      context.fillStyle = this.colors(color);
      areas.forEach((area) => context.fill(area, 'evenodd'));
    };
    const stroke = (path, color, width, dashes) => {
      context.strokeStyle = this.colors(color);
      context.lineWidth = width;
      context.setLineDash(dashes);
      context.stroke(path);
      context.setLineDash([]);
    };
    fill(paths.walkways, 'walkway');
    fill(paths.drivable, 'drivable');
    stroke(paths.outlines, 'ground', 1.2 * this.pixel, []);
    stroke(paths.connectors, 'connector', this.pixel, []);
    stroke(paths.lanes, 'lane', this.pixel, [6 * this.pixel, 6 * this.pixel]);
    context.fillStyle = this.colors('lane');
    for (const arrow of paths.arrows) {
      const c = Math.cos(arrow.yaw);
      const s = Math.sin(arrow.yaw);
      context.beginPath();
      for (const [ahead, left] of [[0.9, 0], [-0.9, 0.65], [-0.45, 0], [-0.9, -0.65]]) {
        context.lineTo(arrow.x + ahead * c - left * s, arrow.y + ahead * s + left * c);
      }
      context.fill();
    }
  }

  drawOthers() {
    for (const other of this.world.others) {
      const state = stateAt(other.motion, this.time);
      if (!state) continue;
      this.drawBox(state, other, this.colors(other.color || 'agent'), SMALL.includes(other.class) ? 0.9 : 0.75);
    }
  }

  /** Draws a filled box with a mark at its front. */
  drawBox(state, {length, width}, color, opacity, isOutline = false) {
    const {context} = this;
    const points = corners(state, length, width);
    context.globalAlpha = opacity;
    context.beginPath();
    points.forEach(([x, y]) => context.lineTo(x, y));
    context.closePath();
    context.fillStyle = context.strokeStyle = color;
    context.lineWidth = 1.5 * this.pixel;
    if (isOutline) {
      context.stroke();
    } else {
      context.fill();
      this.drawFront(state, length, width);
    }
    context.globalAlpha = 1;
  }

  drawFront(state, length, width) {
    const {context} = this;
    const c = Math.cos(state.yaw);
    const s = Math.sin(state.yaw);
    const at = (ahead, left) => [state.x + ahead * c - left * s, state.y + ahead * s + left * c];
    context.beginPath();
    context.moveTo(...at(0.46 * length, 0));
    context.lineTo(...at(0.24 * length, 0.34 * width));
    context.lineTo(...at(0.24 * length, -0.34 * width));
    context.closePath();
    context.fillStyle = this.colors('mark');
    context.fill();
  }

  drawAim() {
    const {aim} = this.world;
    if (!aim) return;
    this.drawBox(aim.ego, aim.egoSize, this.colors('aim-ego'), 0.9, true);
    this.drawBox(aim.attacker, aim.attackerSize, this.colors('aim-attacker'), 0.9, true);
  }

  /** Draws the path of a role from t0 on, and its ghosts. */
  drawWay(role) {
    const {context} = this;
    const {motion} = role;
    context.beginPath();
    for (let i = 0; i < motion.t.length; ++i) {
      if (motion.t[i] >= -1e-6) context.lineTo(motion.x[i], motion.y[i]);
    }
    context.strokeStyle = this.colors(role.color);
    context.lineWidth = (role.isPale ? 1 : 2) * this.pixel;
    context.globalAlpha = role.isPale ? 0.4 : 0.75;
    context.stroke();
    context.globalAlpha = 1;
    if (role.isPale) return;
    for (let t = 0; t <= this.world.end; t += GHOST_STEP) {
      const state = stateAt(motion, t);
      if (state) this.drawBox(state, role, this.colors(role.color), 0.13);
    }
  }

  drawRole(role) {
    const state = role.isHeld ? heldAt(role.motion, this.time) : stateAt(role.motion, this.time);
    if (!state) return;
    this.drawBox(state, role, this.colors(role.color), role.isPale ? 0.35 : 1);
    if (role.isPale) this.drawBox(state, role, this.colors(role.color), 0.8, true);
  }

  drawContact() {
    const {contact} = this.world;
    if (!contact) return;
    const {context} = this;
    const isPast = this.time >= contact.t - 0.02;
    const radius = (isPast ? 11 : 8) * this.pixel;
    context.beginPath();
    for (let i = 0; i < 10; ++i) {
      const reach = i % 2 ? 0.45 * radius : radius;
      context.lineTo(contact.x + reach * Math.sin(Math.PI * i / 5), contact.y + reach * Math.cos(Math.PI * i / 5));
    }
    context.closePath();
    context.globalAlpha = isPast ? 1 : 0.6;
    context.fillStyle = this.colors('contact');
    context.strokeStyle = this.colors('text');
    context.lineWidth = this.pixel;
    context.fill();
    context.stroke();
    context.globalAlpha = 1;
  }

  drawNorth() {
    const {context} = this;
    const [x, y] = [this.width - 22, this.height - 34];
    const [right, up] = this.turned([0, 1]);
    context.fillStyle = this.colors('text');
    context.beginPath();
    for (const [ahead, aside] of [[10, 0], [-10, 7], [-5, 0], [-10, -7]]) {
      context.lineTo(x + ahead * right + aside * up, y - ahead * up + aside * right);
    }
    context.fill();
    context.font = '12px system-ui, sans-serif';
    context.fillText('N', x - 4, this.height - 8);
  }

  drawScaleBar() {
    const {context} = this;
    const length = [1, 2, 5, 10, 20, 50, 100].find((metres) => metres * this.scale >= 50) || 100;
    const y = this.height - 14;
    context.strokeStyle = context.fillStyle = this.colors('text');
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(12, y);
    context.lineTo(12 + length * this.scale, y);
    context.stroke();
    context.font = '12px system-ui, sans-serif';
    context.fillText(length + ' m', 12, y - 5);
  }
}
