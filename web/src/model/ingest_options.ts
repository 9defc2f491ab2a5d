import type { IngestOptions, Position } from '../contract/data_types';
import { parsePosition } from '../geo/coordinates';

/** The form of options for files, as texts; empty: the file decides. */
export type IngestForm = Record<OptionName, string>;
export type OptionName = keyof IngestOptions;

interface Option {
  title: string;
  choices?: [value: string, title: string][]; // if missing, free text
  placeholder?: string;
}

export const ingestOptions: Record<OptionName, Option> = {
  name: { title: 'Name', placeholder: 'as the file' },
  kind: {
    title: 'Kind',
    choices: [
      ['bathymetry', 'depths'], ['currents', 'currents'], ['ice', 'sea ice'], ['icebergs', 'icebergs'], ['coastline', 'coastline'],
      ['tides', 'tides'], ['water-levels', 'water levels'], ['wind', 'wind'], ['zones', 'zones'], ['glider-tracks', 'tracks of gliders'],
    ],
  },
  positive: { title: 'Positive', choices: [['up', 'up: elevations'], ['down', 'down: depths']] },
  crs: { title: 'Reference system', placeholder: 'EPSG:4326' },
  variable: { title: 'Variable', placeholder: 'its name in the file' },
  missing: { title: 'Mark of missing values', placeholder: '-99.99' },
  time: { title: 'Holds at', placeholder: '2026-11-20T18:00:00Z' },
  at: { title: 'Station at', placeholder: '69°13.2′N 51°06.0′W' },
  unit: {
    title: 'Unit',
    choices: [
      ['m', 'tide: metres'], ['cm', 'tide: centimetres'], ['mm', 'tide: millimetres'], ['ft', 'tide: feet'],
      ['share', 'sea ice: shares of 1'], ['percent', 'sea ice: percent'],
    ],
  },
  zone_kind: { title: 'Rule of the zones', choices: [['no_go', 'keep out'], ['stay_in', 'stay in']] },
};

export const optionNames = Object.keys(ingestOptions) as OptionName[];
export const emptyForm = Object.fromEntries(optionNames.map((name) => [name, ''])) as IngestForm;

const optionNamed = (flag: string): OptionName | undefined => optionNames.find((name) => name === flag.replaceAll('-', '_'));
const flags = /--([a-z-]+[a-z])(?: ([a-z_-]+))?/g;

/** The options that a refusal asks for; it names them by their command line flags. */
export function askedFor(errors: string[]): OptionName[] {
  const named = errors.flatMap((text) => [...text.matchAll(flags)].flatMap(([, flag = '']) => optionNamed(flag) ?? []));
  return optionNames.filter((name) => named.includes(name));
}

/** A message about a file with the form's names of the options and of their choices. */
export const inWords = (text: string): string =>
  text.replace(flags, (whole, flag: string, value?: string) => {
    const option = optionNamed(flag);
    if (!option) return whole;
    const { title, choices } = ingestOptions[option];
    const choice = choices?.find(([name, words]) => name === value && !words.includes(':')); // not “up: elevations” for up
    if (choice) return `“${title}: ${choice[1]}”`;
    return value === undefined ? `“${title}”` : `“${title}” ${value}`;
  });

/** The options in the form of the request, or the faults in them. */
export function optionsOf(form: IngestForm): { options: IngestOptions } | { fault: string } {
  const isText = (name: OptionName) => name !== 'at' && name !== 'missing';
  const stated = optionNames.filter((name) => isText(name) && form[name].trim() !== '').map((name) => [name, form[name].trim()]);
  const options = Object.fromEntries(stated) as IngestOptions;
  if (form.missing.trim() !== '') {
    options.missing = Number(form.missing);
    if (!Number.isFinite(options.missing)) return { fault: `${ingestOptions.missing.title}: a number is needed, such as -99.99` };
  }
  if (form.at.trim() === '') return { options };
  const place = parsePosition(form.at);
  if (!place.ok) return { fault: `${ingestOptions.at.title}: ${place.fault}` };
  const at: Position = place.value;
  return { options: { ...options, at } };
}
