// What the words of the files are called for people. A word that is not here is shown as it is, with spaces.
const TITLES = {
  lane_change: 'Lane change',
  opposite_direction: 'Opposite direction',
  rear_end: 'Rear end',
  junction_crossing: 'Junction crossing',
  ltap: 'Left turn across path',
  as_asked: 'Crash as asked',
  otherwise: 'Other contact',
  missed: 'No contact as recorded',
  generated: 'Generated',
  declined: 'Declined',
  hit: 'Hit by the attacker',
  hit_other: 'Touched somebody else',
  clear: 'No contact',
  failed: 'Planner failed',
  untested: 'Not tested',
};

// The order in which outcomes are stacked and listed.
export const OUTCOMES = ['as_asked', 'otherwise', 'missed', 'generated', 'declined', 'hit', 'hit_other', 'clear',
  'failed', 'untested'];

// What outcomes mean, beside their names.
export const OUTCOME_NOTES = {
  as_asked: 'In the recording the attacker touches the ego at the time, in the way and within the limits asked for.',
  otherwise: 'In the recording the attacker touches the ego, but not as asked: the ego drove otherwise than predicted.',
  missed: 'In the recording the attacker does not touch the ego: the ego drove otherwise than predicted.',
  generated: 'Verified against the predicted motion. Whether it holds in the recording was not looked at.',
  declined: 'There is no attack: see code and reason.',
};

export function title(word) {
  if (!word) return '';
  const plain = TITLES[word] || word.replace(/_/g, ' ');
  return plain[0].toUpperCase() + plain.slice(1);
}

/** A number with its unit, or a dash where there is none. */
export function amount(value, digits, unit = '') {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  return value.toFixed(digits) + (unit && '\u202f' + unit);
}

export const degrees = (radians) => (radians === null ? null : radians * 180 / Math.PI);

/** An element with properties and children; texts become text, never markup. */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in made && !name.startsWith('aria')) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}
