import { computed, signal } from '@preact/signals';
import { hour_ms } from './time';

/** The one clock: currents, icebergs, vehicle markers and table highlights all follow it. */
export const time_ms = signal(Math.floor(Date.now() / hour_ms) * hour_ms);
export const playing = signal(false);

/** Hours of the mission that pass in one second of playback. */
export const speeds = [1, 3, 6, 12] as const;
export const speed = signal<(typeof speeds)[number]>(3);

export interface Span {
  start_ms: number;
  end_ms: number;
}

/** Spans the clock should cover, by who asks for it: the currents, each plan shown. */
export const spans = signal<Record<string, Span>>({});

/** What the slider runs over, on whole hours; a day around the clock when nobody asks for more. */
export const range = computed<Span>(() => {
  const all = Object.values(spans.value);
  if (all.length === 0) return { start_ms: emptyStart_ms, end_ms: emptyStart_ms + 24 * hour_ms };
  const start = Math.min(...all.map((span) => span.start_ms));
  const end = Math.max(...all.map((span) => span.end_ms));
  return { start_ms: Math.floor(start / hour_ms) * hour_ms, end_ms: Math.max(Math.ceil(end / hour_ms) * hour_ms, start + hour_ms) };
});
const emptyStart_ms = time_ms.peek();

const within = (value: number, { start_ms, end_ms }: Span): number => Math.min(Math.max(value, start_ms), end_ms);

export function setTime(value_ms: number): void {
  time_ms.value = within(value_ms, range.peek());
}

export function setSpan(name: string, span: Span | undefined): void {
  const others = Object.entries(spans.peek()).filter(([other]) => other !== name);
  spans.value = Object.fromEntries(span ? [...others, [name, span]] : others);
  setTime(time_ms.peek());
}

/** Moves by whole hours, landing on the hour. */
export function stepHours(hours: number): void {
  const grid = hours > 0 ? Math.floor(time_ms.peek() / hour_ms) : Math.ceil(time_ms.peek() / hour_ms);
  setTime((grid + hours) * hour_ms);
}

/** Lets `elapsed_s` seconds of playback pass; stops at the end of the range. */
export function advance(elapsed_s: number): void {
  const next = time_ms.peek() + elapsed_s * speed.peek() * hour_ms;
  setTime(next);
  if (next >= range.peek().end_ms) playing.value = false;
}

/** Starts playback, from the beginning when the clock stands at the end. */
export function togglePlay(): void {
  if (!playing.peek() && time_ms.peek() >= range.peek().end_ms) time_ms.value = range.peek().start_ms;
  playing.value = !playing.peek();
}

/**
 * The stored steps on either side of a moment and the share of the later one; undefined outside the stored period and between
 * two steps further apart than `longestGap_ms`.
 */
export function bracket(times_ms: number[], at_ms: number, longestGap_ms = Infinity): { before: number; after: number; share: number } | undefined {
  const after = times_ms.findIndex((time) => time >= at_ms);
  if (after < 0) return undefined;
  const afterTime = times_ms[after];
  const beforeTime = times_ms[after - 1];
  if (afterTime === undefined) return undefined;
  if (afterTime === at_ms) return { before: after, after, share: 0 };
  if (beforeTime === undefined || afterTime - beforeTime > longestGap_ms) return undefined;
  return { before: after - 1, after, share: (at_ms - beforeTime) / (afterTime - beforeTime) };
}
