// Severity of a contact, evasive manoeuvres and careful drivers, as entries of the lists in the details.
import {amount} from './words.js';

const HOURS = 12;

/** Returns the clock hour of a principal direction of force: 12 from ahead, 3 from the right. */
function clockHour(forceFrom) {
  return ((Math.round(-forceFrom * HOURS / (2 * Math.PI)) + HOURS - 1) % HOURS) + 1;
}

function classText({least_class: least, most_class: most}) {
  return least === most ? `S${least}` : `S${least} to S${most}`;
}

function effectText(effect) {
  const parts = [`delta-v ${amount(effect.delta_v, 1, 'm/s')} from ${clockHour(effect.force_from)} o'clock`];
  if (effect.curve) {
    parts.push(`MAIS 2+ ${amount(100 * effect.mais2, 1, '%')}, MAIS 3+ ${amount(100 * effect.mais3, 1, '%')} `
      + `(${effect.curve})`, classText(effect));
  }
  return parts.join('; ');
}

/** `severity` as in the files, or null; `other` names the second party. */
export function severityEntries(severity, other) {
  if (!severity) return [];
  return [
    ['Severity for the ego', effectText(severity.ego)],
    [`Severity for the ${other}`, effectText(severity.other)],
  ];
}

/** `drives`: the field careful_drivers of the files. */
export function carefulEntries(drives) {
  return drives.map(({driver, avoids, brakes_t: brakes}) => [driver, (avoids ? 'avoids it' : 'does not avoid it')
    + (brakes === null ? ', does not brake' : `, brakes at ${amount(brakes, 2, 's')}`)]);
}

/** Returns the text of an avoidability in the files. */
export function avoidance(summary) {
  const {last} = summary;
  return last ? `by ${last.manoeuvre}, up to ${amount(last.start_t, 1, 's')} after t0` : 'none found';
}
