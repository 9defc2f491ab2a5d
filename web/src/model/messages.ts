import { signal } from '@preact/signals';
import type { Message, Told } from '../contract/types';
import type { Position } from '../contract/data_types';
import { circle } from '../geo/geodesic';
import { ask } from './view';

export type Rank = Message['rank'];

/** Ranks, the most serious first. Danger: the vehicle may be lost. Caution: the plan may fail. Note: good to know. */
export const ranks: readonly Rank[] = ['danger', 'caution', 'note'];

/** The server's mark of a danger in places that show no rank. */
const mark = /^Danger: /;

/** A sentence without a known code. Answers that were stored before messages had codes hold such sentences. */
export const bareMessage = (rank: Rank, text: string): Message => ({ code: '', rank, place: null, values: {}, text: text.replace(mark, '') });

/** The messages of an answer for the pilot, the most serious first. */
export function messagesOf({ messages, dangers = [], warnings }: Told): Message[] {
  if (messages) return messages;
  return [
    ...dangers.map((text) => bareMessage('danger', text)),
    ...warnings.filter((text) => !mark.test(text)).map((text) => bareMessage('caution', text)),
  ];
}

export const ofRank = (told: Told, rank: Rank): Message[] => messagesOf(told).filter((message) => message.rank === rank);

/** "1 danger", "3 cautions" */
export const countOf = (count: number, rank: Rank): string => `${count} ${rank}${count === 1 ? '' : 's'}`;

/**
 * The text for screen readers after a result: " 1 danger. 2 cautions."; empty if there are none. Notes are not
 * announced.
 */
export function warnedOf(told: Told): string {
  const counted = (['danger', 'caution'] as const).map((rank) => ({ rank, count: ofRank(told, rank).length }));
  return counted.filter(({ count }) => count > 0).map(({ rank, count }) => ` ${countOf(count, rank)}.`).join('');
}

export const placeOf = ({ place }: Message): Position | undefined => (place ? [place.lon, place.lat] : undefined);

/** The message whose place was asked for last. The map marks the place. */
export const shownMessage = signal<Message | undefined>(undefined);

/** The size of the area that comes into view around the place of a message. */
const around_m = 5000;

/** Moves the map to the place of a message. */
export function showMessage(message: Message): void {
  const place = placeOf(message);
  if (!place) return;
  shownMessage.value = message;
  ask({ do: 'fit', places: circle(place, around_m) });
}
