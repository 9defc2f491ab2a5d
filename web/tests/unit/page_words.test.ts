import { expect, it } from 'vitest';
import { readFileSync } from 'node:fs';
import { inWords } from '../../src/model/ingest_options';
import { requestFields } from '../../src/contract/request_fields';
import { formOf } from '../../src/model/fields';
import { asSentence, inPageWords } from '../../src/model/page_words';

it('flags of the command line become the fields of the page, whole ones only', () => {
  expect(inPageWords('Allow a hold (--max-hold), or depart later')).toBe('Allow a hold (“Longest hold”), or depart later');
  expect(inPageWords('save energy (--objective energy)')).toBe('save energy (“Optimise” energy)');
  expect(inPageWords('--depart-until 12Z')).toBe('“Latest departure” 12Z');
  expect(inPageWords('move it into the water; longitude comes first')).toBe('move it into the water');
  expect(inPageWords('did you mean --from=-53.2,69.2?')).toBe('did you mean 69°12.0′N 053°12.0′W?');
  expect(inPageWords('closed until 2026-11-22T19:24:33Z')).toBe('closed until 22 Nov 19:24Z');
  expect(inPageWords('/depart 2026-11-20T00:00:00Z is outside')).toBe('Departure 20 Nov 00:00Z is outside');
  expect(inPageWords('/under_ice/escape_plan must be true')).toBe('Escape route from every waypoint must be true');
  expect(inPageWords('/remarks must be short')).toBe('/remarks must be short');
  expect(inPageWords('plan again with a climb_to_m of 22, as goto_l10.ma says')).toBe('plan again with a “Climb to” of 22, as goto_l10.ma says');
  expect(inPageWords('a well-known --thing -- and more')).toBe('a well-known --thing -- and more');
});

const ofTheTree = (path: string): string => readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8');

it('turns every flag of the messages that reach the page into a field', () => {
  const ofTheCommandLine = new Set([...ofTheTree('engine/messages/command_messages.hpp').matchAll(/\.code = "([^"]+)"/g)].map(([, code]) => code));
  const rows = ofTheTree('tests/golden/messages.txt').split(/^(?=(?:danger|caution|note) )/m);
  const reaching = rows.filter((row) => !ofTheCommandLine.has(row.split(' ')[1]?.trim()));
  expect(reaching.length).toBeGreaterThan(500);
  const told = inWords(inPageWords(reaching.join(''))).replaceAll('--allow-weak-sandbox', ''); // of the server, for whoever runs it
  expect(told).not.toMatch(/--[a-z]/);
  const named = Object.keys(requestFields).filter((name) => name.includes('_') && formOf(name).label);
  expect(named.filter((name) => new RegExp(`\\b${name}\\b`).test(told))).toEqual([]);
});

it('gives times the form of the figures of the page', () => {
  expect(inPageWords('no place to surface for 57.1 h, not for 17 h')).toBe('no place to surface for 2 d 09 h, not for 17 h');
  expect(inPageWords('for 57 h 05 min, at most 14 h 44 min')).toBe('for 2 d 09 h, at most 14 h 44 min');
  expect(inPageWords('the limit of 12.0 h')).toBe('the limit of 12 h');
  expect(inPageWords('This route takes 0.1 h more')).toBe('This route takes 6 min more');
  expect(inPageWords('takes 3.2 h more')).toBe('takes 3 h 12 min more');
  expect(inPageWords('hold 2 h 40 min, at 10 km/h')).toBe('hold 2 h 40 min, at 10 km/h');
});

it('makes what stands alone a sentence', () => {
  expect(asSentence('the route comes too close at 2026-11-22T23:51:00Z')).toMatch(/^The route comes too close at 22 Nov.*\.$/);
  expect(asSentence('Depart later.')).toBe('Depart later.');
  expect(asSentence('goto_l10.ma holds no waypoint')).toBe('goto_l10.ma holds no waypoint.');
  expect(asSentence('the position error of 6.2 km at -52.4026, 68.9388 reaches ice')).toBe('The position error of 6.2 km at 68°56.3′N 052°24.2′W reaches ice.');
  expect(asSentence('')).toBe('');
});
