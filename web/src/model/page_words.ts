import { shortTime } from './time';

/** Flags of the command line that the server's sentences name, and the fields of the set-up that ask for the same. */
const fields: Record<string, string> = {
  '--bathymetry': 'Depths', '--currents': 'Currents', '--depart': 'Departure', '--depart-until': 'Latest departure',
  '--dive-depth': 'Dive depth', '--escape-plan': 'A way out from every waypoint', '--margin': 'Ice margin',
  '--max-concentration-to-surface': 'Surface up to', '--max-inflation': 'Most for errors', '--max-loiter': 'Longest wait',
  '--max-sighting-age': 'Sightings up to', '--max-time-without-surfacing': 'Longest below', '--objective': 'Optimise',
  '--spacing': 'Grid spacing', '--steady': 'Hold the currents at departure', '--thruster': 'Thruster',
};

const instant = /\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ/g;

/** The order of the request's numbers; on this page latitude comes first, and letters may say which is which. */
const orderOfNumbers = /; longitude comes first$/;

/** Words of the server that follow on from nothing, as a sentence. */
export const asSentence = (text: string): string => {
  const words = inPageWords(text);
  const isOpen = words !== '' && !/[.!?…]$/.test(words);
  return words.charAt(0).toUpperCase() + words.slice(1) + (isOpen ? '.' : '');
};

/** A sentence of the server in the words of this page: “Longest wait” where it says --max-loiter. */
export const inPageWords = (text: string): string =>
  text
    .replace(orderOfNumbers, '')
    .replace(instant, (time) => shortTime(Date.parse(time)))
    .replace(/--[a-z]+(-[a-z]+)*/g, (flag) => (fields[flag] ? `“${fields[flag]}”` : flag));
