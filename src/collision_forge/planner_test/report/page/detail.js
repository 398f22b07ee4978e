// Details of one row: the top view, the timelines and the data in the files.
import {stateAt} from './geometry.js';
import {continued, motionOf} from './records.js';
import {avoidance, carefulEntries, severityEntries} from './severity.js';
import {Timelines} from './timelines.js';
import {TopView} from './top_view.js';
import {OUTCOME_NOTES, amount, degrees, element, title} from './words.js';

const SPEEDS = [0.25, 0.5, 1, 2, 4];
const FAR_LESS = 0.8; // share of the view's height

/** Returns "scenarios:3, Left turn across path, 4.0 s after t0, car, cut in"; a test has its planner second. */
export function headline(rows, row) {
  const parts = [rows.name(row), rows.text('planner', row), title(rows.text('type', row)) || 'Unreadable case'];
  if (rows.number('tta', row) !== null) parts.push(amount(rows.number('tta', row), 1, 's') + ' after t0');
  for (const key of ['class', 'manoeuvre']) parts.push(rows.text(key, row).replace(/_/g, ' '));
  return parts.filter((part) => part).join(', ');
}

/** Builds the data of the top view and the timelines from the records of a row. */
export function worldOf({now, tta, scene, attack, test}) {
  const world = {others: [], roles: [], begin: 0, end: (tta || 0) + 1, focus: [], map: scene && scene.map};
  const offset = scene && scene.origin - now;
  const drive = test && test.drive;
  const crash = drive ? drive.crash : attack && attack.crash;
  const withCrash = (motion, after) => (after ? continued(motion, motionOf(after)) : motion);
  const attackerId = attack && attack.attacker.id;
  const touchedId = drive && test.contact ? test.contact.other : attackerId;
  const touched = (id, motion) => withCrash(motion, crash && id === touchedId && crash.other);
  const size = attack ? {length: attack.ego_length, width: attack.ego_width} : scene;
  const supports = attack ? attack.supports : [];
  for (const support of supports) {
    world.others.push({...support, color: 'support', motion: touched(support.id, motionOf(support.motion))});
  }
  for (const agent of scene ? scene.agents : []) {
    if (supports.some((support) => support.id === agent.id)) continue;
    const role = {...agent, motion: motionOf(agent.motion, offset)};
    if (agent.id !== attackerId) world.others.push({...role, motion: touched(agent.id, role.motion)});
    else world.roles.push({...role, color: 'attacker', isPale: true, name: 'Attacker as recorded'});
  }
  if (scene && scene.ego.t.length) {
    const recorded = motionOf(scene.ego, offset);
    const isCrashed = crash && !drive;
    world.roles.push({motion: withCrash(recorded, isCrashed && crash.ego), length: scene.length, width: scene.width,
      color: 'ego', isPale: Boolean(drive), isEgo: true, isTimed: true, isFollowed: !drive,
      name: isCrashed ? 'Ego, recorded up to the contact' : 'Ego as recorded'});
    world.begin = Math.max(world.roles[world.roles.length - 1].motion.t[0], -3);
  }
  if (attack) addAttacker(world, attack, drive, (motion) => touched(attackerId, motion));
  if (drive) {
    world.roles.push({motion: withCrash(motionOf(drive.ego), crash && crash.ego), ...size, color: 'ego', isEgo: true,
      isTimed: true, isFollowed: true, isHeld: true, name: 'Ego as the planner drives it'});
    if (drive.evasion) {
      world.roles.push({motion: motionOf(drive.evasion), ...size, color: 'evasion', isPale: true,
        name: 'Evasive manoeuvre of the ego'});
    }
    if (crash) world.end = motionOf(crash.ego).t.slice(-1)[0];
  }
  // Without the recording the ego's motion is unknown, so nothing is shown after the predicted contact.
  if (attack && !attack.recorded && !drive && attack.report.contact) world.end = attack.report.contact_t;
  world.contact = contactOf(attack, test, world);
  for (const role of world.roles) {
    if (role.isPale && !role.isEgo) continue;
    role.motion.t.forEach((t, i) => {
      if (t >= -0.5 && t <= world.end) world.focus.push([role.motion.x[i], role.motion.y[i]]);
    });
  }
  world.rightwards = rightwardsOf(world);
  return world;
}

function addAttacker(world, attack, drive, withCrash) {
  const {attacker, aim} = attack;
  const motion = withCrash(motionOf(drive && drive.attacker.t.length ? drive.attacker : attacker.trajectory));
  const past = motionOf(attacker.past);
  const size = {length: attacker.length, width: attacker.width};
  world.end = motion.t[motion.t.length - 1];
  world.limits = attack.limits;
  if (past.t.length) {
    world.roles.push({motion: past, ...size, color: 'attacker', isPale: true, name: 'Attacker before t0'});
  }
  world.roles.push({motion, ...size, color: 'attacker', isAttacker: true, isTimed: true, name: 'Attacker'});
  world.aim = {ego: aim.ego, attacker: aim.attacker, attackerSize: size,
    egoSize: {length: attack.ego_length, width: attack.ego_width}};
}

/**
 * Returns the direction on the ground that points right in the view, radians from east, at most a quarter turn from it:
 * the heading of the ego at t0, or at the contact (else in the pattern) if the view is then far
 * less high, or the opposite.
 */
function rightwardsOf(world) {
  const ego = world.roles.find((role) => role.isFollowed);
  const poses = ego ? [stateAt(ego.motion, 0), world.contact && stateAt(ego.motion, world.contact.t)] : [];
  if (world.aim && !poses[1]) poses.push(world.aim.ego);
  const directions = poses.filter((pose) => pose).map(({yaw}) => Math.atan(Math.tan(yaw)));
  const heightOf = (direction) => {
    const heights = world.focus.map(([x, y]) => y * Math.cos(direction) - x * Math.sin(direction));
    return Math.max(...heights) - Math.min(...heights);
  };
  return directions.reduce((best, next) => (heightOf(next) < FAR_LESS * heightOf(best) ? next : best),
    directions[0] || 0);
}

/** Returns the contact of the planner, else in the recording, else the predicted one. */
function contactOf(attack, test, world) {
  if (test) {
    if (!test.contact || !test.drive) return null; // without the drive the place is unknown
    const ego = world.roles.find((role) => role.isFollowed);
    const state = ego && stateAt(ego.motion, Math.min(test.contact.t, ego.motion.t[ego.motion.t.length - 1]));
    const ahead = {front: [0.5, 0], rear: [-0.5, 0], left: [0, 0.5], right: [0, -0.5]}[test.contact.ego_side];
    return state && onBox(state, ego, ahead, test.contact.t);
  }
  if (!attack) return null;
  const report = attack.recorded || attack.report;
  if (!report.contact) return null;
  const [ego, attacker] = [report.ego_at_contact, report.attacker_at_contact];
  return {t: report.contact_t, x: (ego.x + attacker.x) / 2, y: (ego.y + attacker.y) / 2};
}

function onBox(state, {length, width}, [ahead, left], t) {
  const [c, s] = [Math.cos(state.yaw), Math.sin(state.yaw)];
  return {t, x: state.x + ahead * length * c - left * width * s, y: state.y + ahead * length * s + left * width * c};
}

const yesOrNo = (value) => (value ? 'yes' : 'no');
const percent = (share) => amount(100 * share, 0, '%');

function list(name, entries) {
  const lines = entries.filter((entry) => entry && entry[1] !== '' && entry[1] !== null)
    .flatMap(([term, text, kind]) => [element('dt', {}, term), element('dd', {className: kind || ''}, text)]);
  return lines.length ? element('section', {}, element('h3', {}, name), element('dl', {}, ...lines)) : null;
}

const held = (holds) => (holds ? 'passed' : 'missed');

/** Returns "ego touches AGENT 1.2 s after the contact; ...", or "" if neither vehicle touches another agent. */
function secondaryContacts(crash, contactT) {
  return (crash ? crash.secondary_contacts : []).map(({t, is_ego: isEgo, agent}) =>
    `${isEgo ? 'ego' : 'other'} touches ${agent} ${amount(t - contactT, 1, 's')} after the contact`).join('; ');
}

/** Returns the measured conditions; none in a file unless the request asks for one. */
function conditionEntries(conditions) {
  if (!conditions) return [];
  return [
    ['Attacker', `from the ${conditions.from_side}, ${amount(conditions.attacker_speed, 1, 'm/s')}, `
      + `across ${amount(conditions.lateral_speed, 1, 'm/s')}, braking ${amount(conditions.deceleration, 1, 'm/s²')}`],
    ['At t0', `gap ${amount(conditions.gap, 1, 'm')}, headway ${amount(conditions.headway, 1, 's')}`],
    ...(conditions.departure_time >= 0
      ? [['Starts to move', `${amount(conditions.departure_time, 1, 's')} after t0`]] : []),
    ['Place on the front', percent(conditions.impact_location) + ' from its left edge'],
    ['Seen by the ego', conditions.hidden_by_id
      ? `for ${amount(conditions.visible_for, 1, 's')}, before hidden by ${conditions.hidden_by_id}` : 'since t0'],
  ];
}

function reportList(name, report, crash) {
  if (!report.contact) {
    return list(name, [['Contact', 'none', 'missed'], ['Broken limit', report.broken_limit, 'missed']]);
  }
  return list(name, [
    ['Contact', amount(report.contact_t, 2, 's') + ' after t0', held(report.on_time)],
    ['Heading', amount(degrees(report.relative_heading), 0, '°') + ' to the ego', held(report.type_kept)],
    ['Sides', `ego ${report.ego_side}, attacker ${report.attacker_side}, overlap ${percent(report.overlap)}`],
    ['Impact speed', amount(report.impact_speed, 1, 'm/s')],
    ...conditionEntries(report.conditions),
    ...severityEntries(report.severity, 'attacker'),
    ['Manoeuvre', title(report.manoeuvre) + ' from ' + amount(report.manoeuvre_begin_t, 1, 's')],
    ['Limits', report.limits_kept ? 'all kept' : report.broken_limit, held(report.limits_kept)],
    ['Other agents touched', report.first_other || 'none', held(!report.first_other)],
    ['After the contact', secondaryContacts(crash, report.contact_t)],
    ['Plausible', report.unbelievable || 'yes', held(!report.unbelievable)],
    ['Use of the road', `on a lane ${percent(report.on_lane)}, wrong way ${percent(report.wrong_way)}, `
      + `walkway ${percent(report.on_walkway)}, off the road ${percent(report.off_road_share)}`],
  ]);
}

/** Lists the largest values of the attacker's motion with their limits. */
function limitList(attack, world) {
  const {limits} = attack;
  const attacker = world.roles.find((role) => role.isAttacker).motion;
  const until = world.contact ? world.contact.t : world.end;
  const values = {max_forward_acceleration: 0, max_braking: 0, max_lateral_acceleration: 0, max_speed: 0};
  attacker.t.forEach((t, i) => {
    if (t > until || i === 0) return;
    const turned = attacker.yaw[i] - attacker.yaw[i - 1];
    const rate = Math.atan2(Math.sin(turned), Math.cos(turned)) / (t - attacker.t[i - 1]);
    const speedsUp = attacker.v[i] < 0 ? -attacker.a[i] : attacker.a[i];
    values.max_speed = Math.max(values.max_speed, Math.abs(attacker.v[i]));
    values.max_forward_acceleration = Math.max(values.max_forward_acceleration, speedsUp);
    values.max_braking = Math.max(values.max_braking, -speedsUp);
    values.max_lateral_acceleration = Math.max(values.max_lateral_acceleration, Math.abs(attacker.v[i] * rate));
  });
  const names = {max_forward_acceleration: 'Speeds up', max_braking: 'Brakes', max_lateral_acceleration: 'Sideways',
    max_speed: 'Speed'};
  return list('Limits of a ' + limits.of.replace(/_/g, ' '), Object.entries(names).map(([key, name]) => {
    const meter = element('meter', {min: 0, max: limits[key], value: values[key], 'aria-label': name});
    const unit = key === 'max_speed' ? 'm/s' : 'm/s²';
    return [name, element('span', {}, meter, ` ${amount(values[key], 1)} of ${amount(limits[key], 1, unit)}`)];
  }));
}

function pictureList(pictures) {
  if (!pictures.length) return null;
  return element('section', {}, element('h3', {}, 'Pictures'), ...pictures.map(({name, link}) =>
    element('p', {}, element('a', {href: link}, name))));
}

/** Shows commands with a button that copies them, or selects them if the browser forbids copying. */
function commandList(commands) {
  if (!commands.length) return null;
  return element('section', {}, element('h3', {}, 'Reproduce this row'), ...commands.map(({title: name, lines}) => {
    // A line may not end at the hyphens of an option.
    const words = lines.split(/([ \n])/).map((word) => (word.startsWith('--') ? element('span', {}, word) : word));
    const text = element('pre', {tabIndex: 0}, ...words);
    const button = element('button', {type: 'button', className: 'copy', onclick: async () => {
      try {
        await navigator.clipboard.writeText(lines);
        button.textContent = 'Copied';
      } catch (error) {
        getSelection().selectAllChildren(text);
        button.textContent = 'Selected';
      }
    }}, 'Copy');
    return element('div', {className: 'commands'}, element('p', {}, name, button), text);
  }));
}

function planList(plans) {
  if (plans.length < 2) return null;
  return list('Plans of the attacker', plans.map((plan) => [amount(plan.from_t, 1, 's'),
    title(plan.phase) + (plan.reason ? ': ' + plan.reason : '')]));
}

function testList(test) {
  const {contact} = test;
  return list('Planner', [
    test.failure !== 'none' && ['Failure', title(test.failure) + ': ' + test.message, 'missed'],
    ['Contact', contact ? `${contact.attacker ? 'with the attacker' : 'with ' + contact.other} at `
      + amount(contact.t, 2, 's') : 'none', held(!contact)],
    contact && ['Where', `ego ${contact.ego_side}, other ${contact.other_side}, ${contact.place}`],
    contact && ['Impact speed', amount(contact.impact_speed, 1, 'm/s')],
    ...(contact ? severityEntries(contact.severity, 'other agent') : []),
    contact && ['After the contact', secondaryContacts(test.drive && test.drive.crash, contact.t)],
    contact && ['Speed of the ego', amount(contact.ego_speed, 1, 'm/s')],
    contact && ['At fault', `${yesOrNo(contact.at_fault)} (${contact.cause})`, held(!contact.at_fault)],
    ['Avoidable', avoidance(test.avoidability)],
    test.evasion && ['Evasive manoeuvre', avoidance(test.evasion)],
    test.evasion && ['Fair', yesOrNo(test.fair)],
    ['Hardest braking', amount(test.max_braking, 1, 'm/s²')],
    ['Progress', `${amount(test.progress, 0, 'm')}, recorded ${amount(test.recorded_progress, 0, 'm')}`],
    ['nuPlan score', amount(test.nuplan.score, 2)],
    ['Attacker', title(test.attacker.phase)
      + (test.attacker.broken_limit ? ', violated ' + test.attacker.broken_limit : '')],
    !test.drive && ['Motion', 'not in this page: see docs/report.md'],
  ]);
}

export class Detail {
  /** `dialog` has the elements of the page; `onStep` is called to open another row. */
  constructor(dialog, rows, records, files, colors, onStep) {
    Object.assign(this, {dialog, rows, records, files, onStep});
    const find = (name) => dialog.querySelector('#' + name);
    Object.assign(this, {heading: find('detail-title'), facts: find('facts'), slider: find('time'),
      contactButton: find('to-contact'),
      clock: find('clock'), playButton: find('play'), followButton: find('follow'), speed: find('speed'),
      legend: find('legend'), notice: find('notice')});
    this.view = new TopView(find('view'), colors);
    this.timelines = new Timelines(find('plots'), (time) => this.seek(time));
    this.speed.append(...SPEEDS.map((speed) => element('option', {value: speed, selected: speed === 1}, speed + '×')));
    this.slider.addEventListener('input', () => this.seek(Number(this.slider.value)));
    const onClick = {play: () => this.play(!this.isPlaying), 'to-contact': () => this.seekContact(),
      follow: () => this.follow(!this.view.isFollowing),
      'zoom-in': () => this.view.zoom(1.3), 'zoom-out': () => this.view.zoom(1 / 1.3), fit: () => this.fit(),
      previous: () => this.onStep(-1), next: () => this.onStep(1), close: () => dialog.close()};
    for (const [name, action] of Object.entries(onClick)) find(name).addEventListener('click', action);
    dialog.addEventListener('keydown', (event) => this.onKey(event));
    dialog.addEventListener('close', () => this.play(false));
  }

  async open(row) {
    this.row = row;
    const [scene, attack, test, shell] = await Promise.all(['place', 'attack', 'test', 'commands'].map(
      (key) => this.records.at(this.rows.number(key, row))));
    if (this.row !== row) return; // another row was opened in the meantime
    this.play(false);
    const now = this.rows.number('now', row);
    this.world = worldOf({now, tta: this.rows.number('tta', row), scene, attack, test});
    this.heading.textContent = headline(this.rows, row);
    if (!this.dialog.open) this.dialog.showModal();
    this.slider.min = this.world.begin;
    this.slider.max = this.world.end;
    this.slider.disabled = this.world.roles.length === 0;
    this.contactButton.disabled = !this.world.contact;
    this.notice.textContent = this.noticeFor(scene);
    this.view.show(this.world);
    this.timelines.show(this.world);
    this.legend.replaceChildren(...this.legendEntries());
    this.facts.replaceChildren(...this.factsOf(row, attack, test, shell).filter((part) => part));
    this.facts.scrollTop = 0;
    this.seek(this.world.contact ? Math.max(this.world.contact.t - 2, this.world.begin) : 0);
  }

  noticeFor(scene) {
    if (!this.world.roles.length) return 'These results hold no motion.';
    return scene ? '' : 'Made without --source: no map, no traffic, no recorded ego.';
  }

  legendEntries() {
    const entry = (name, kind) => element('span', {}, element('i', {className: 'swatch ' + kind}), name);
    const entries = this.world.roles.map((role) => entry(role.name, 'of-' + role.color + (role.isPale ? ' pale' : '')));
    if (this.world.others.some(({role}) => role)) entries.push(entry('Support vehicle', 'of-support'));
    if (this.world.aim) entries.push(entry('Pattern: ego', 'of-aim-ego'), entry('attacker', 'of-aim-attacker'));
    if (this.world.contact) entries.push(entry('Contact', 'of-contact'));
    return entries;
  }

  factsOf(row, attack, test, shell) {
    const {rows} = this;
    const outcome = rows.text('outcome', row);
    const file = this.files[rows.number('file', row)];
    const status = rows.text('status', row);
    const now = rows.number('now_in_recording', row);
    return [
      element('p', {className: 'verdict'}, element('i', {className: 'dot outcome-' + outcome}), title(outcome)),
      OUTCOME_NOTES[outcome] ? element('p', {className: 'note'}, OUTCOME_NOTES[outcome]) : null,
      list('Why', [['Code', status === 'OK' ? '' : status], ['Reason', rows.text('message', row)]]),
      list('Request', [
        ['Scene', rows.text('scene', row)],
        ['t0', now === null ? '' : amount(now, 2, 's') + ' into the scene'],
        ['Clock', rows.number('now', row) === null ? '' : amount(rows.number('now', row), 6, 's')],
        ['Time to attack', rows.number('tta', row) === null ? '' : amount(rows.number('tta', row), 1, 's')],
        ['Mode', title(rows.text('mode', row))],
        ['Planner, method', rows.text('planner', row)],
        ['Attacker', attack ? `${rows.text('origin', row)}, ${attack.attacker.id}` : ''],
        ['Confidence', rows.number('confidence', row) === null ? '' : percent(rows.number('confidence', row))],
        attack && ['Distance to the pattern', amount(attack.aim.miss_distance, 2, 'm')],
        attack && ['Seed', String(attack.request.seed)],
      ]),
      test && testList(test),
      attack && attack.recorded ? reportList('In the recording', attack.recorded, attack.crash) : null,
      attack && reportList(attack.recorded ? 'As generated' : 'Attack', attack.report),
      list('Careful drivers in the ego\'s place',
        carefulEntries(test ? test.careful_drivers : attack ? attack.report.careful_drivers : [])),
      attack && limitList(attack, this.world),
      attack && planList((test && test.drive && test.drive.plans) || attack.plans),
      shell && commandList(shell.commands),
      test && pictureList(test.pictures),
      element('section', {}, element('h3', {}, 'File'), element('p', {},
        element('a', {href: file.link}, file.path), `, line ${rows.number('line', row)}`)),
    ];
  }

  seek(time) {
    this.time = Math.min(Math.max(time, this.world.begin), this.world.end);
    this.slider.value = this.time;
    this.clock.textContent = amount(this.time, 2, 's');
    this.slider.setAttribute('aria-valuetext', this.clock.textContent + ' after t0');
    this.view.at(this.time);
    this.timelines.at(this.time);
  }

  seekContact() {
    if (!this.world.contact) return;
    this.play(false);
    this.seek(this.world.contact.t);
  }

  play(isPlaying) {
    this.isPlaying = isPlaying;
    this.playButton.textContent = isPlaying ? '❚❚' : '▶';
    this.playButton.setAttribute('aria-label', isPlaying ? 'Pause' : 'Play');
    if (!isPlaying) return;
    if (this.time >= this.world.end - 1e-6) this.seek(this.world.begin);
    let before = performance.now();
    const step = (instant) => {
      if (!this.isPlaying) return;
      const passed = Math.max(instant - before, 0) / 1000;
      before = instant;
      this.seek(this.time + passed * Number(this.speed.value));
      if (this.time >= this.world.end) this.play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  follow(isFollowing) {
    this.view.isFollowing = isFollowing;
    this.followButton.setAttribute('aria-pressed', String(isFollowing));
    this.view.draw();
  }

  fit() {
    this.follow(false);
    this.view.fit();
  }

  /** Plays faster or slower. */
  changeSpeed(step) {
    this.speed.selectedIndex = Math.min(Math.max(this.speed.selectedIndex + step, 0), SPEEDS.length - 1);
  }

  onKey(event) {
    const tag = event.target.tagName;
    if (event.ctrlKey || event.altKey || event.metaKey || tag === 'SELECT') return;
    if (event.key === ' ' && (tag === 'BUTTON' || tag === 'A')) return; // presses it
    const scrub = event.shiftKey ? 1 : 0.1;
    const actions = {
      ' ': () => this.play(!this.isPlaying),
      ArrowLeft: () => this.seek(this.time - scrub),
      ArrowRight: () => this.seek(this.time + scrub),
      Home: () => this.seek(this.world.begin),
      End: () => this.seek(this.world.end),
      c: () => this.seekContact(),
      f: () => this.follow(!this.view.isFollowing),
      '+': () => this.view.zoom(1.3),
      '=': () => this.view.zoom(1.3),
      '-': () => this.view.zoom(1 / 1.3),
      0: () => this.fit(),
      n: () => this.onStep(1),
      p: () => this.onStep(-1),
      '<': () => this.changeSpeed(-1),
      '>': () => this.changeSpeed(1),
    };
    if (!(event.key in actions)) return;
    event.preventDefault();
    actions[event.key]();
  }
}
