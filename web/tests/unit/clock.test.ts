import { beforeEach, describe, expect, it } from 'vitest';
import { advance, bracket, heldStep, playing, range, setSpan, setTime, slider, spans, speed, stepHours, time_ms, togglePlay, zoomSlider } from '../../src/model/clock';
import { duration, fieldOf, hour_ms, isoOf, parseTime, shortTime } from '../../src/model/time';

const start = Date.UTC(2026, 10, 20, 0);

describe('the clock', () => {
  beforeEach(() => {
    spans.value = {};
    playing.value = false;
    setSpan('currents', { start_ms: start, end_ms: start + 48 * hour_ms });
  });

  it('stays within what the data and the plans cover', () => {
    setTime(start - hour_ms);
    expect(time_ms.value).toBe(start);
    setSpan('plan', { start_ms: start, end_ms: start + 72 * hour_ms });
    setTime(start + 99 * hour_ms);
    expect(time_ms.value).toBe(start + 72 * hour_ms);
    setSpan('plan', undefined);
    expect(range.value.end_ms).toBe(start + 48 * hour_ms);
    expect(time_ms.value).toBe(start + 48 * hour_ms);
  });

  it('steps onto whole hours', () => {
    setTime(start + 2.4 * hour_ms);
    stepHours(1);
    expect(time_ms.value).toBe(start + 3 * hour_ms);
    setTime(start + 2.4 * hour_ms);
    stepHours(-1);
    expect(time_ms.value).toBe(start + 2 * hour_ms);
  });

  it('plays, stops at the end and then starts over', () => {
    setTime(start + 47 * hour_ms);
    speed.value = 6;
    togglePlay();
    advance(1);
    expect(time_ms.value).toBe(start + 48 * hour_ms);
    expect(playing.value).toBe(false);
    togglePlay();
    expect(time_ms.value).toBe(start);
  });

  it('shows a month of years at most, and moves on when the time leaves it', () => {
    expect(slider.value).toEqual(range.value);
    setSpan('track', { start_ms: start - 3 * 365 * 24 * hour_ms, end_ms: start });
    setTime(start);
    const width_ms = 31 * 24 * hour_ms;
    const holds = (): boolean => slider.value.start_ms <= time_ms.value && time_ms.value <= slider.value.end_ms;
    for (const at_ms of [start, range.value.start_ms, start - 200 * 24 * hour_ms, range.value.end_ms]) {
      setTime(at_ms);
      expect(slider.value.end_ms - slider.value.start_ms).toBe(width_ms);
      expect(holds()).toBe(true);
    }
    const before = slider.value;
    setTime(before.start_ms + width_ms / 2);
    expect(slider.value).toEqual(before);
  });

  it('zooms the slider about the time, from hours to everything', () => {
    setTime(start + 12 * hour_ms);
    zoomSlider(0.5);
    expect(slider.value).toEqual({ start_ms: start + 6 * hour_ms, end_ms: start + 30 * hour_ms });
    for (let i = 0; i < 10; ++i) zoomSlider(0.5);
    expect(slider.value.end_ms - slider.value.start_ms).toBe(6 * hour_ms);
    setTime(start + 47 * hour_ms);
    expect(slider.value.end_ms).toBe(start + 48 * hour_ms);
    for (let i = 0; i < 10; ++i) zoomSlider(2);
    expect(slider.value).toEqual(range.value);
  });

  it('finds the data steps on either side, and none outside', () => {
    const times = [start, start + 3 * hour_ms, start + 6 * hour_ms];
    expect(bracket(times, start + hour_ms * 1.5)).toEqual({ before: 0, after: 1, share: 0.5 });
    expect(bracket(times, start + 3 * hour_ms)).toEqual({ before: 1, after: 1, share: 0 });
    expect(bracket(times, start - 1)).toBeUndefined();
    expect(bracket(times, start + 7 * hour_ms)).toBeUndefined();
    const [before_ms = NaN, after_ms = NaN] = times;
    expect(bracket(times, (before_ms + after_ms) / 2, after_ms - before_ms)).toBeDefined();
    expect(bracket(times, (before_ms + after_ms) / 2, after_ms - before_ms - 1)).toBeUndefined();
    expect(bracket(times, after_ms, after_ms - before_ms - 1)).toEqual({ before: 1, after: 1, share: 0 });
  });
});

describe('times', () => {
  it('are UTC whatever is typed', () => {
    for (const text of ['2026-11-20 06:00', '2026-11-20T06:00:00Z', '2026-11-20 06', ' 2026-11-20 6:00Z ', '2026-11-20 0600']) {
      expect(parseTime(text)).toBe(start + 6 * hour_ms);
    }
    for (const text of ['', '20.11.2026', '2026-02-30', '2026-11-20 24:00', 'now']) expect(parseTime(text)).toBeUndefined();
  });

  it('are written short, long and for fields', () => {
    expect(isoOf(start)).toBe('2026-11-20T00:00:00Z');
    expect(fieldOf(start)).toBe('2026-11-20 00:00');
    expect(shortTime(start, start)).toBe('20 Nov 00:00Z');
    expect(shortTime(start, start + 300 * 24 * hour_ms)).toBe('20 Nov 2026 00:00Z');
    expect(shortTime(start, start - 300 * 24 * hour_ms)).toBe('20 Nov 2026 00:00Z');
    expect(duration(100 * 3600)).toBe('4 d 04 h');
    expect(duration(3600 * 5 + 1200)).toBe('5 h 20 min');
  });
});

describe('a step that is held', () => {
  it('is the first or the last, for so long beyond them and no longer', () => {
    expect(heldStep([10, 20], 22, 3)).toEqual({ before: 1, after: 1, share: 0 });
    expect(heldStep([10, 20], 24, 3)).toBeUndefined();
    expect(heldStep([10, 20], 8, 3)).toEqual({ before: 0, after: 0, share: 0 });
    expect(heldStep([10, 20], 15, 3)).toBeUndefined();
    expect(heldStep([], 15, 3)).toBeUndefined();
  });
});
