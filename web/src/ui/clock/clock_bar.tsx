import { computed } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { VNode } from 'preact';
import { advance, playing, range, setTime, slider, speed, speeds, stepHours, time_ms, togglePlay, zoomSlider, type Span } from '../../model/clock';
import { coveredDatasets } from '../../model/coverage';
import { chosenCurrents, currentTimes_ms } from '../../model/datasets';
import { draft } from '../../model/setup/draft';
import { laneCount, lanesOf } from '../../model/plan/lanes';
import { selectedId, selectedPlan, shownPlans, titleOf } from '../../model/plan/plans';
import { hour_ms, parseTime, shortTime, spokenTime } from '../../model/time';
import { hueOf } from '../../theme/palette';
import { IconButton } from '../common/icon';

/** The one clock: playback, slider, and under it the steps of the currents and the plans' durations. */
export function ClockBar(): VNode {
  usePlayback();
  const whole = range.value;
  const { start_ms, end_ms } = slider.value;
  const now_ms = time_ms.value;
  return (
    <footer class="clock" aria-label="Clock">
      <div class="clock-buttons">
        <IconButton icon="skipBack" label="To the start (Home)" onClick={() => setTime(whole.start_ms)} />
        <IconButton icon="stepBack" label="One hour back (,)" onClick={() => stepHours(-1)} />
        <IconButton icon={playing.value ? 'pause' : 'play'} label={playing.value ? 'Pause (Space)' : 'Play (Space)'} onClick={togglePlay} class="play" />
        <IconButton icon="stepForward" label="One hour on (.)" onClick={() => stepHours(1)} />
        <IconButton icon="skipForward" label="To the end (End)" onClick={() => setTime(whole.end_ms)} />
        <select
          aria-label="Playback speed, hours in a second" value={speed.value}
          onChange={(event) => {
            speed.value = speeds.find((candidate) => candidate === Number(event.currentTarget.value)) ?? 3;
          }}
        >
          {speeds.map((value) => <option key={value} value={value}>{value} h/s</option>)}
        </select>
      </div>
      <div class="clock-track" onWheel={zoomByWheel}>
        <input
          type="range" min={start_ms} max={end_ms} step={hour_ms / 6} value={now_ms} aria-label="Time"
          aria-valuetext={`${spokenTime(now_ms)}${sinceDeparture(now_ms, ', T plus ')}`}
          onInput={(event) => setTime(Number(event.currentTarget.value))}
        />
        <Timeline span={slider.value} />
        <MoreBars />
        <div class="clock-ends">
          <span>{start_ms > whole.start_ms && '‹ '}{shortTime(start_ms)}</span>
          <span class="clock-zoom" role="group" aria-label="Time on the slider">
            <IconButton icon="minus" label="More time on the slider" disabled={end_ms - start_ms >= whole.end_ms - whole.start_ms} onClick={() => zoomSlider(2)} />
            <IconButton icon="plus" label="Less time on the slider" onClick={() => zoomSlider(0.5)} />
          </span>
          <span>{shortTime(end_ms)}{end_ms < whole.end_ms && ' ›'}</span>
        </div>
      </div>
      {/* While it runs, each step would be spoken. */}
      <output class="clock-now" aria-live={playing.value ? 'off' : undefined}>
        <b>{shortTime(now_ms)}</b>
        <span>{sinceDeparture(now_ms, 'T+') || 'UTC'}</span>
      </output>
    </footer>
  );
}

function zoomByWheel(event: WheelEvent): void {
  event.preventDefault();
  zoomSlider(event.deltaY > 0 ? 1.25 : 0.8);
}

/** Hours since the departure of the selected plan, or of the set-up if none is selected; empty before it. */
function sinceDeparture(now_ms: number, lead: string): string {
  const depart_ms = selectedPlan.value ? Date.parse(selectedPlan.value.departure) : parseTime(draft.value.depart);
  if (depart_ms === undefined || now_ms < depart_ms) return '';
  return `${lead}${Math.floor((now_ms - depart_ms) / hour_ms)} h`;
}

const lanes = computed(() => lanesOf(shownPlans.value, selectedId.value));

/** The number of plans on the map that have no bar, because there is no room. */
function MoreBars(): VNode | null {
  const { left } = lanes.value;
  if (left.length === 0) return null;
  return (
    <span class="clock-more" title={`No room for a bar: ${left.map(({ letter, plan }) => `${letter} ${titleOf(plan)}`).join(', ')}`}>
      +{left.length}<span class="visually-hidden"> more plans</span>
    </span>
  );
}

/** Ticks of the data's steps, frames of covered spans, bars of the plans, hatching where there are no currents. */
function Timeline({ span }: { span: Span }): VNode {
  const [width, height] = [1000, 5 + 3 * laneCount];
  const x = (value_ms: number): number => ((value_ms - span.start_ms) / (span.end_ms - span.start_ms)) * width;
  const times = currentTimes_ms.value;
  const seen = times.filter((time) => time >= span.start_ms && time <= span.end_ms);
  const [first, last] = [times[0], times.at(-1)];
  const every = Math.ceil(seen.length / 200);
  const covered = coveredDatasets.value.flatMap(({ id, time_start, time_end }) =>
    time_start && time_end ? [{ id, from: x(Date.parse(time_start)), to: x(Date.parse(time_end)) }] : [],
  );
  return (
    <svg class="timeline" viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" aria-hidden="true" focusable="false">
      <defs>
        <pattern id="no-data" width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
          <line class="hatch" x1="0" y1="0" x2="0" y2="5" />
        </pattern>
      </defs>
      {chosenCurrents.value && first !== undefined && last !== undefined && (
        <>
          <rect x={0} y={0} width={Math.max(0, x(first))} height={height} fill="url(#no-data)" />
          <rect x={Math.max(0, x(last))} y={0} width={Math.max(0, width - Math.max(0, x(last)))} height={height} fill="url(#no-data)" />
        </>
      )}
      {seen.filter((_, i) => i % every === 0).map((time) => (
        <line key={time} class="step" x1={x(time)} x2={x(time)} y1={0} y2={4} vector-effect="non-scaling-stroke" />
      ))}
      {covered.map(({ id, from, to }) => (
        <rect key={id} class="coverage" x={from} y={0} width={Math.max(2, to - from)} height={4} vector-effect="non-scaling-stroke" />
      ))}
      {lanes.value.bars.map(({ shown: { plan, style }, lane }) => (
        <rect
          key={plan.plan_id} class={`plan-bar plan-${hueOf(style)}`} fill="currentColor" x={x(Date.parse(plan.departure))} y={5 + 3 * lane} height={2}
          width={Math.max(2, x(Date.parse(plan.arrival)) - x(Date.parse(plan.departure)))}
        />
      ))}
    </svg>
  );
}

/** Moves the clock during playback; in steps of an hour if the user prefers reduced motion. */
function usePlayback(): void {
  const on = playing.value;
  useEffect(() => {
    if (!on) return;
    if (window.matchMedia('(prefers-reduced-motion: reduce)').matches) {
      const timer = setInterval(() => {
        stepHours(1);
        if (time_ms.peek() >= range.peek().end_ms) playing.value = false;
      }, 1000);
      return () => clearInterval(timer);
    }
    let before = performance.now();
    let frame = requestAnimationFrame(function run(now) {
      advance(Math.min(0.1, (now - before) / 1000));
      before = now;
      frame = requestAnimationFrame(run);
    });
    return () => cancelAnimationFrame(frame);
  }, [on]);
}
