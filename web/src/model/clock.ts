import { computed, signal } from '@preact/signals';
import { day_ms, hour_ms } from './time';

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

/** Periods that the clock should cover, by what needs them: the currents, each plan on the map. */
export const spans = signal<Record<string, Span>>({});

const emptyStart_ms = time_ms.peek();

/** The period that the clock covers, in whole hours; a day around its time if nothing needs more. */
export const range = computed<Span>(() => {
  const all = Object.values(spans.value);
  if (all.length === 0) return { start_ms: emptyStart_ms, end_ms: emptyStart_ms + 24 * hour_ms };
  const start = Math.min(...all.map((span) => span.start_ms));
  const end = Math.max(...all.map((span) => span.end_ms));
  return { start_ms: Math.floor(start / hour_ms) * hour_ms, end_ms: Math.max(Math.ceil(end / hour_ms) * hour_ms, start + hour_ms) };
});
/** The slider spans at most this until the user zooms out, although a track or a model may last for years. */
const usual_ms = 31 * day_ms;
const narrowest_ms = 6 * hour_ms;

const wanted = signal({ left_ms: emptyStart_ms, width_ms: usual_ms });

/** The part of the range that the slider runs over. The clock's time lies in it. */
export const slider = computed<Span>(() => {
  const { start_ms, end_ms } = range.value;
  const width_ms = Math.min(wanted.value.width_ms, end_ms - start_ms);
  const left_ms = within(wanted.value.left_ms, { start_ms, end_ms: end_ms - width_ms });
  return { start_ms: left_ms, end_ms: left_ms + width_ms };
});

/** Makes the slider span more or less time. The clock's time keeps its place on it. */
export function zoomSlider(factor: number): void {
  const [{ start_ms, end_ms }, whole] = [slider.peek(), range.peek()];
  const now_ms = time_ms.peek();
  const whole_ms = whole.end_ms - whole.start_ms;
  const width_ms = Math.min(Math.max(Math.round((factor * (end_ms - start_ms)) / hour_ms) * hour_ms, narrowest_ms), whole_ms);
  const share = (now_ms - start_ms) / (end_ms - start_ms);
  wanted.value = { left_ms: Math.round((now_ms - share * width_ms) / hour_ms) * hour_ms, width_ms };
  bringIntoSlider();
}

/** Moves the slider when the clock's time has left it. Most of its length then lies ahead, in the direction of the move. */
function bringIntoSlider(): void {
  const [now_ms, { start_ms, end_ms }] = [time_ms.peek(), slider.peek()];
  if (now_ms >= start_ms && now_ms <= end_ms) return;
  const width_ms = end_ms - start_ms;
  const left_ms = now_ms - (now_ms > end_ms ? 0.1 : 0.9) * width_ms;
  wanted.value = { ...wanted.peek(), left_ms: Math.round(left_ms / hour_ms) * hour_ms };
}

const within = (value: number, { start_ms, end_ms }: Span): number => Math.min(Math.max(value, start_ms), end_ms);

export function setTime(value_ms: number): void {
  time_ms.value = within(value_ms, range.peek());
  bringIntoSlider();
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
  if (!playing.peek() && time_ms.peek() >= range.peek().end_ms) setTime(range.peek().start_ms);
  playing.value = !playing.peek();
}

/**
 * The stored steps before and after a moment, and the weight of the later one. Undefined outside the stored period and between two
 * steps that are further apart than `longestGap_ms`.
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

/** The first or last step, for a moment outside the steps that is no further from it than `longestHold_ms`; undefined otherwise. */
export function heldStep(times_ms: number[], at_ms: number, longestHold_ms: number): { before: number; after: number; share: number } | undefined {
  const last = times_ms.length - 1;
  const end = at_ms > (times_ms[last] ?? Infinity) ? last : at_ms < (times_ms[0] ?? -Infinity) ? 0 : undefined;
  if (end === undefined || Math.abs(at_ms - (times_ms[end] ?? NaN)) > longestHold_ms) return undefined;
  return { before: end, after: end, share: 0 };
}
