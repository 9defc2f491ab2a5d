import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Palette } from '../../theme/palette';

/** A line over time; undefined values leave a gap. */
export interface Line {
  label: string; // none: not named in the key
  values: (number | null)[];
  colour: string;
  width?: number;
  dash?: number[];
  fill?: string; // from the line to the lower edge
  stepped?: boolean; // each value holds since the one before
  dots?: number; // marks of this diameter in pixels, without a line
  hollow?: boolean; // the marks are rings
}

export interface PlotSpec {
  times_s: number[]; // since 1970, ascending
  lines: Line[];
  unit: string;
  height_px: number;
  downward?: boolean; // depth grows downwards
  fromZero?: boolean;
  onPick?: (time_s: number) => void;
}

export interface Plot {
  mark: (time_s: number | undefined) => void;
  destroy: () => void;
}

/**
 * Draws a chart with the width of `box` and adapts it when that changes. This module is loaded with the first chart.
 */
export function makePlot(box: HTMLElement, spec: PlotSpec, colours: Palette): Plot {
  const plot = new uPlot(optionsOf(box, spec, colours), [spec.times_s, ...spec.lines.map(({ values }) => values)], box);
  const marker = document.createElement('div');
  marker.className = 'chart-marker';
  marker.hidden = true;
  plot.over.append(marker);
  let marked_s: number | undefined;
  const place = (): void => {
    const { min = 0, max = 0 } = plot.scales['x'] ?? {};
    marker.hidden = marked_s === undefined || marked_s < min || marked_s > max;
    if (marked_s !== undefined && !marker.hidden) marker.style.left = `${plot.valToPos(marked_s, 'x')}px`;
  };
  plot.over.addEventListener('click', (event) => spec.onPick?.(plot.posToVal(event.offsetX, 'x')));
  const observer = new ResizeObserver(() => {
    if (box.clientWidth > 0) plot.setSize({ width: box.clientWidth, height: spec.height_px });
    place();
  });
  observer.observe(box);
  return {
    mark: (time_s) => {
      marked_s = time_s;
      place();
    },
    destroy: () => {
      observer.disconnect();
      plot.destroy();
    },
  };
}

const stepped = uPlot.paths.stepped?.({ align: -1 });

function optionsOf(box: HTMLElement, spec: PlotSpec, colours: Palette): uPlot.Options {
  const axis = { stroke: colours.label, font: '11px system-ui, sans-serif', grid: { stroke: colours.graticule, width: 1 }, ticks: { show: false } };
  return {
    width: Math.max(100, box.clientWidth),
    height: spec.height_px,
    tzDate: (time_s) => uPlot.tzDate(new Date(1000 * time_s), 'Etc/UTC'),
    legend: { show: false },
    cursor: { drag: { x: false, y: false }, points: { size: 6 } },
    scales: {
      y: { dir: spec.downward ? -1 : 1, range: (_plot, low, high) => rangeOf(low, high, spec.fromZero ?? false) },
    },
    axes: [
      {
        ...axis, size: 22, space: 68,
        values: (_plot, times) => times.map((time_s, i) => tickText(time_s, times[i - 1])),
      },
      { ...axis, size: 44, space: 16, values: (_plot, values) => values.map((value) => String(Number(value.toPrecision(6)))) },
    ],
    series: [
      {},
      ...spec.lines.map((line): uPlot.Series => ({
        label: line.label,
        stroke: line.colour,
        width: line.dots ? 0 : (line.width ?? 2),
        ...(line.dash ? { dash: line.dash } : {}),
        ...(line.fill ? { fill: line.fill, fillTo: (_plot, _index, low, high) => (spec.downward ? high : low) } : {}),
        ...(line.stepped && stepped ? { paths: stepped } : {}),
        points: { show: line.dots !== undefined, size: line.dots ?? 0, stroke: line.colour, fill: line.hollow ? 'transparent' : line.colour },
        spanGaps: false,
      })),
    ],
  };
}

/** The ends of an axis with a little space; nearly equal values are not magnified. */
export function rangeOf(low: number | null, high: number | null, fromZero: boolean): [number, number] {
  if (low === null || high === null) return [0, 1];
  const start = fromZero ? Math.min(0, low) : low;
  const least = Math.max(0.02 * Math.abs(high), 1e-3);
  const room = Math.max(0.06 * (high - start), 0.5 * (least - (high - start)));
  return [fromZero && low >= 0 ? 0 : start - room, high + room];
}

const months = ['Jan', 'Feb', 'Mar', 'Apr', 'May', 'Jun', 'Jul', 'Aug', 'Sep', 'Oct', 'Nov', 'Dec'];

/** Tick label "06Z", with the day where it changes or the axis begins. */
function tickText(time_s: number, before_s: number | undefined): string {
  const date = new Date(1000 * time_s);
  const newDay = before_s === undefined || new Date(1000 * before_s).getUTCDate() !== date.getUTCDate();
  const minutes = date.getUTCMinutes();
  const clock = `${String(date.getUTCHours()).padStart(2, '0')}${minutes ? `:${String(minutes).padStart(2, '0')}` : ''}Z`;
  if (!newDay) return clock;
  const day = `${date.getUTCDate()} ${months[date.getUTCMonth()] ?? ''}`;
  return clock === '00Z' ? day : `${day} ${clock}`;
}
