import { effect, untracked } from '@preact/signals';
import { byHand, datasets, takeStored } from '../model/datasets';
import {
  bergsByHand, changeForm, featureOf, formOf, handChanges, handFault, nameOf, openForm, renumber, zones,
  type HandChange, type HandMade, type HandMadeKind,
} from '../model/hand_made';
import { forbids } from '../model/login';
import { announce } from '../model/screen';
import { remember } from '../model/undo';
import { tool } from '../model/view';
import * as api from './client';
import type { NewFeature } from '../contract/data_types';

const gone = 404;
const changedMeanwhile = 412;

const statusOf = (error: unknown): number => (error instanceof api.ApiError ? error.problem.status : 0);

/** Reads the lists of manual entries again whenever their datasets in the store have changed. Call once. */
export function followHandMade(): void {
  let known = '';
  effect(() => {
    const held = (datasets.value ?? []).filter(({ id, kind }) => id === byHand('icebergs') || kind === 'zones');
    const now = held.map(({ id, sha256 }) => id + sha256).join();
    if (now === known) return;
    known = now;
    untracked(() => void readLists(held.some(({ kind }) => kind === 'icebergs'), held.some(({ kind }) => kind === 'zones')));
  });
}

async function readLists(hasBergs: boolean, hasZones: boolean): Promise<void> {
  try {
    const [reported, stored] = await Promise.all([hasBergs ? api.icebergsOf(byHand('icebergs')) : undefined, hasZones ? api.zones() : undefined]);
    bergsByHand.value = reported?.features ?? [];
    zones.value = stored?.features ?? [];
  } catch (error) {
    handFault.value = `The manual entries could not be read: ${api.wordsOf(error)}`;
  }
}

/**
 * Reads the list of datasets after a change: the changed dataset has another digest, so everything that shows it is
 * updated.
 */
async function readStore(): Promise<void> {
  takeStored(await api.datasets());
}

/** Opens the form with the entry as it is in the store now, which may be newer than the list. */
export async function openExisting(kind: HandMadeKind, feature: HandMade): Promise<void> {
  handFault.value = undefined;
  try {
    const now = await api.feature(kind, feature.id);
    openForm.value = formOf(kind, now.feature, now.tag);
  } catch (error) {
    handFault.value = `${nameOf(feature)}: ${api.wordsOf(error)}`;
    if (statusOf(error) === gone) await readStore();
  }
}

export function closeForm(): void {
  openForm.value = undefined;
  if (tool.peek() === 'berg' || tool.peek() === 'zone') tool.value = 'pan';
}

/** Stores what the form asks for, unless somebody else has changed the same feature since the form was opened. */
export async function saveForm(): Promise<void> {
  const form = openForm.value;
  if (!form || form.state === 'saving' || forbids('pilot', 'Reporting icebergs and zones')) return;
  const wanted = featureOf(form);
  if ('faults' in wanted) {
    changeForm({ faults: wanted.faults });
    return;
  }
  changeForm({ state: 'saving', faults: {} });
  const { before, kind } = form;
  const { feature } = wanted;
  try {
    const anew = !before || form.state === 'removed';
    const stored = anew ? await api.createFeature(kind, feature) : await api.replaceFeature(kind, String(before.id), feature, form.tag);
    const name = nameOf(feature as HandMade);
    note({ kind, ...stored, title: `${anew ? 'adding' : 'changing'} ${name}`, ...(anew ? {} : { before: bare(before) }), after: feature });
    closeForm();
    announce(`${name} is stored.`);
    await readStore();
  } catch (error) {
    changeForm(faultOf(error));
  }
}

function faultOf(error: unknown): { state: 'conflict' | 'removed' | 'failed'; detail: string } {
  switch (statusOf(error)) {
    case changedMeanwhile: return { state: 'conflict', detail: 'Somebody else has changed it since you opened it.' };
    case gone: return { state: 'removed', detail: 'Somebody else has removed it since you opened it.' };
    default: return { state: 'failed', detail: api.wordsOf(error) };
  }
}

/** After a conflict: overwrites the other user's change with the form's content. */
export async function saveOverTheirs(): Promise<void> {
  const form = openForm.value;
  if (!form?.before) return;
  try {
    const now = await api.feature(form.kind, form.before.id);
    changeForm({ before: now.feature, state: 'typing', ...(now.tag === undefined ? {} : { tag: now.tag }) });
    await saveForm();
  } catch (error) {
    changeForm(faultOf(error));
  }
}

/** Removes an entry from the store, if it is still the same as in the list. */
export async function retire(kind: HandMadeKind, shown: HandMade): Promise<void> {
  if (forbids('pilot', 'Retiring icebergs and zones')) return;
  handFault.value = undefined;
  try {
    const now = await api.feature(kind, shown.id);
    if (JSON.stringify(bare(now.feature)) !== JSON.stringify(bare(shown))) {
      handFault.value = `${nameOf(shown)} was changed meanwhile and is still there; look at it again first.`;
    } else {
      await api.removeFeature(kind, String(shown.id), now.tag);
      note({ kind, id: String(shown.id), tag: undefined, title: `retiring ${nameOf(shown)}`, before: bare(shown) });
      announce(`${nameOf(shown)} is retired.`);
    }
  } catch (error) {
    handFault.value = `${nameOf(shown)}: ${api.wordsOf(error)}`;
  }
  await readStore();
}

/** The entry without members that the server adds. */
function bare(feature: HandMade): NewFeature {
  const { geometry, properties } = feature;
  const stated = Object.entries(properties).filter(([name, value]) => value !== null && value !== '' && name !== 'dataset_id' && name !== 'safe_length_m');
  return { type: 'Feature', geometry, properties: Object.fromEntries(stated) };
}

/** Records a change for undo in this list and in the list of all changes of the page. */
function note(change: HandChange): void {
  handChanges.value = { done: [...handChanges.value.done, change], undone: [] };
  remember({ title: change.title, back: () => turn('done', 'undone'), again: () => turn('undone', 'done') });
}

/** Reverts the newest change of one stack and puts its reverse on the other stack. */
async function turn(from: 'done' | 'undone', to: 'done' | 'undone'): Promise<void> {
  const change = handChanges.value[from].at(-1);
  if (!change || forbids('pilot', 'Changing icebergs and zones')) return;
  handFault.value = undefined;
  try {
    const { id, tag } = await unmade(change);
    const { before, after, ...rest } = change;
    const reverse: HandChange = { ...rest, id, tag, ...(after ? { before: after } : {}), ...(before ? { after: before } : {}) };
    const piles = handChanges.value;
    const follow = (pile: HandChange[]): HandChange[] => renumber(pile, change.id, id, change.kind, tag);
    handChanges.value = { ...piles, [from]: follow(piles[from].slice(0, -1)), [to]: [...follow(piles[to]), reverse] };
  } catch (error) {
    const why = statusOf(error) === changedMeanwhile ? 'somebody else has changed it since' : api.wordsOf(error);
    handFault.value = `${change.title} cannot be ${from === 'done' ? 'undone' : 'done again'}: ${why}.`;
    handChanges.value = { ...handChanges.value, [from]: handChanges.value[from].slice(0, -1) };
  }
  await readStore();
}

async function unmade({ kind, id, tag, before, after }: HandChange): Promise<{ id: string; tag: string | undefined }> {
  if (!before) {
    await api.removeFeature(kind, id, tag);
    return { id, tag: undefined };
  }
  return after ? api.replaceFeature(kind, id, before, tag) : api.createFeature(kind, before);
}

