import type { VNode } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { palette } from '../../theme/palette';
import type { Line, Plot, PlotSpec } from './plot';

export type { Line } from './plot';

interface ChartProps extends PlotSpec {
  title: string;
  description: string; // for screen readers; the values are in the table beside it
  mark_ms?: number | undefined;
}

/** A small chart over time with its unit and a legend. A click reports the time at that place. */
export function Chart({ title, description, mark_ms, ...spec }: ChartProps): VNode {
  const box = useRef<HTMLDivElement>(null);
  const [plot, setPlot] = useState<Plot | undefined>(undefined);
  const pick = useRef(spec.onPick);
  pick.current = spec.onPick;
  const colours = palette.value;
  const { times_s, lines } = spec;

  useEffect(() => {
    let made: Plot | undefined;
    let wanted = true;
    void import('./plot').then(({ makePlot }) => {
      if (!wanted || !box.current) return;
      made = makePlot(box.current, { ...spec, onPick: (time_s) => pick.current?.(time_s) }, colours);
      setPlot(made);
    });
    return () => {
      wanted = false;
      made?.destroy();
      setPlot(undefined);
    };
  }, [times_s, lines, colours]);

  useEffect(() => plot?.mark(mark_ms === undefined ? undefined : mark_ms / 1000), [plot, mark_ms]);

  return (
    <figure class="chart">
      <figcaption>
        <span>{title} <span class="unit">{spec.unit}</span></span>
        {lines.length > 1 && <span class="chart-key">{lines.filter(({ label }) => label !== '').map((line) => <Key key={line.label} line={line} />)}</span>}
      </figcaption>
      <div ref={box} class="chart-box" role="img" aria-label={description} style={{ height: `${spec.height_px}px` }} />
    </figure>
  );
}

function Key({ line }: { line: Line }): VNode {
  return (
    <span>
      <svg width="16" height="8" aria-hidden="true" focusable="false">
        {line.dots
          ? <circle cx="8" cy="4" r="3" fill={line.hollow ? 'none' : line.colour} stroke={line.colour} />
          : <line x1="0" y1="4" x2="16" y2="4" stroke={line.colour} stroke-width={line.width ?? 2} stroke-dasharray={line.dash?.join(' ')} />}
      </svg>
      {line.label}
    </span>
  );
}
