// Speed, distance and acceleration over time, with a line at the shown time.
import {accelerationAt, corners, gapBetween, speedAt, stateAt} from './geometry.js';
import {amount, element} from './words.js';

const STEP = 0.1; // s between values
const WIDTH = 600; // of the drawing, which is stretched to the available width
const HEIGHT = 110;

const svg = (tag, attributes = {}) => {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
};

/** Returns round numbers that divide a range into a few parts. */
function ticksOf(least, greatest) {
  const rough = (greatest - least) / 3;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((candidate) => candidate >= rough);
  const ticks = [];
  for (let tick = Math.ceil(least / step) * step; tick <= greatest + 1e-9; tick += step) ticks.push(tick);
  return ticks;
}

export class Timelines {
  constructor(place, onScrub) {
    this.place = place;
    this.onScrub = onScrub;
    place.addEventListener('pointerdown', (event) => {
      place.setPointerCapture(event.pointerId);
      this.scrubTo(event);
    });
    place.addEventListener('pointermove', (event) => event.buttons && this.scrubTo(event));
  }

  scrubTo(event) {
    const box = this.plots[0].drawing.getBoundingClientRect();
    this.onScrub(this.begin + (event.clientX - box.left) / box.width * (this.end - this.begin));
  }

  show(world) {
    this.begin = world.begin;
    this.end = world.end;
    const times = [];
    for (let t = world.begin; t <= world.end + 1e-9; t += STEP) times.push(t);
    const over = (role, value) => ({role, times, values: times.map((t) => value(role.motion, t))});
    const roles = world.roles.filter((role) => role.isTimed);
    this.plots = [
      this.plot('Speed', 'm/s', roles.map((role) => over(role, speedAt)), world),
      this.plot('Distance between the boxes', 'm', this.distances(world, times), world),
      this.plot('Acceleration', 'm/s²', roles.map((role) => over(role, accelerationAt)), world, this.limits(world)),
    ].filter((plot) => plot);
    this.place.replaceChildren(...this.plots.map(({figure}) => figure));
  }

  /** Returns the distances between the attacker and every shown ego. */
  distances(world, times) {
    const attacker = world.roles.find((role) => role.isAttacker);
    if (!attacker) return [];
    const boxAt = (role, t) => {
      const state = stateAt(role.motion, t);
      return state && corners(state, role.length, role.width);
    };
    return world.roles.filter((role) => role.isEgo).map((role) => ({role, times, values: times.map((t) => {
      const boxes = [boxAt(role, t), boxAt(attacker, t)];
      return boxes.includes(null) ? null : gapBetween(...boxes);
    })}));
  }

  limits(world) {
    if (!world.limits) return [];
    return [world.limits.max_forward_acceleration, -world.limits.max_braking];
  }

  plot(name, unit, series, world, limits = []) {
    const values = series.flatMap((one) => one.values).filter((value) => value !== null);
    if (!values.length) return null;
    const least = Math.min(0, ...values, ...limits);
    const greatest = Math.max(1, ...values, ...limits) * 1.05;
    const drawing = svg('svg', {viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none'});
    const x = (t) => WIDTH * (t - this.begin) / (this.end - this.begin);
    const y = (value) => HEIGHT - HEIGHT * (value - least) / (greatest - least);
    const labels = ticksOf(least, greatest).map((tick) => {
      drawing.append(svg('line', {x1: 0, x2: WIDTH, y1: y(tick), y2: y(tick), class: 'grid'}));
      const label = element('span', {className: 'tick'}, String(Math.round(tick * 100) / 100));
      label.style.top = 100 * y(tick) / HEIGHT + '%';
      return label;
    });
    for (const limit of limits) {
      drawing.append(svg('line', {x1: 0, x2: WIDTH, y1: y(limit), y2: y(limit), class: 'limit'}));
    }
    drawing.append(svg('line', {x1: x(0), x2: x(0), y1: 0, y2: HEIGHT, class: 'now'}));
    if (world.contact) {
      drawing.append(svg('line', {x1: x(world.contact.t), x2: x(world.contact.t), y1: 0, y2: HEIGHT, class: 'hit'}));
    }
    series.forEach((one) => drawing.append(this.curve(one, x, y)));
    const cursor = svg('line', {y1: 0, y2: HEIGHT, class: 'cursor'});
    drawing.append(cursor);
    const reading = element('span', {className: 'reading'});
    const figure = element('figure', {className: 'plot'},
      element('figcaption', {}, element('b', {}, name + ' [' + unit + ']'), reading),
      element('div', {className: 'canvas'}, drawing, ...labels));
    return {figure, drawing, cursor, series, reading, x, unit};
  }

  curve({role, times, values}, x, y) {
    let path = '';
    values.forEach((value, i) => {
      if (value === null) return;
      path += (path && values[i - 1] !== null ? 'L' : 'M') + x(times[i]).toFixed(1) + ' ' + y(value).toFixed(1);
    });
    return svg('path', {d: path, class: 'curve of-' + role.color + (role.isPale ? ' pale' : '')});
  }

  at(time) {
    const place = Math.round((time - this.begin) / STEP);
    for (const plot of this.plots) {
      plot.cursor.setAttribute('x1', plot.x(time));
      plot.cursor.setAttribute('x2', plot.x(time));
      plot.reading.replaceChildren(...plot.series.map(({role, values}) => element('span',
        {className: 'of-' + role.color + (role.isPale ? ' pale' : '')},
        amount(values[Math.min(place, values.length - 1)], 1))));
    }
  }
}
