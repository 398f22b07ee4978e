// Titles of the words in the files. A word without a title is shown with spaces instead of underscores.
const TITLES = {
  lane_change: 'Lane change',
  opposite_direction: 'Opposite direction',
  rear_end: 'Rear end',
  junction_crossing: 'Junction crossing',
  ltap: 'Left turn across path',
  sideswipe_same_direction: 'Sideswipe, same direction',
  angle_same_direction: 'Angle, same direction',
  angle_opposite_direction: 'Angle, opposite direction',
  as_asked: 'Crash as requested',
  otherwise: 'Other contact',
  missed: 'No contact in the recording',
  generated: 'Generated',
  declined: 'Rejected',
  hit: 'Hit by the attacker',
  hit_other: 'Hit another agent',
  clear: 'No contact',
  failed: 'Planner failed',
  untested: 'Not tested',
};

// Outcomes in the order of charts and filters.
export const OUTCOMES = ['as_asked', 'otherwise', 'missed', 'generated', 'declined', 'hit', 'hit_other', 'clear',
  'failed', 'untested'];

// Explanations of the outcomes.
export const OUTCOME_NOTES = {
  as_asked: 'In the recording the attacker hits the ego at the requested time, as the requested type, within the limits.',
  otherwise: 'In the recording the attacker hits the ego, but not as requested: the ego drove unlike the prediction.',
  missed: 'In the recording the attacker does not hit the ego: the ego drove unlike the prediction.',
  generated: 'Verified against the predicted motion, not against the recording.',
  declined: 'No attack: see code and reason.',
};

export function title(word) {
  if (!word) return '';
  const plain = TITLES[word] || word.replace(/_/g, ' ');
  return plain[0].toUpperCase() + plain.slice(1);
}

/** Returns a number with its unit, or a dash if there is none. */
export function amount(value, digits, unit = '') {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  return value.toFixed(digits) + (unit && '\u202f' + unit);
}

export const degrees = (radians) => (radians === null ? null : radians * 180 / Math.PI);

/** Creates an element with properties and children; strings are inserted as text, never as markup. */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in made && !name.startsWith('aria')) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}
