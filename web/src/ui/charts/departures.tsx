import type { VNode } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import { planAt } from '../../actions/planning';
import type { Departure, Plan } from '../../contract/types';
import { afterCurve } from '../../model/plan/departures';
import { running } from '../../model/job';
import { may } from '../../model/login';
import { duration, shortTime } from '../../model/time';
import { palette } from '../../theme/palette';
import { Icon } from '../common/icon';
import { Chart, type Line } from './chart';

/**
 * The travel time for each departure of the window; a departure is chosen by a click or in the table, and then planned.
 */
export function Departures({ plan, departures }: { plan: Plan; departures: Departure[] }): VNode {
  const planned = nearest(departures, Date.parse(plan.departure));
  const [chosen, choose] = useState<Departure | undefined>(undefined);
  const shown = chosen ?? planned;
  const colours = palette.value;
  const times_s = useMemo(() => departures.map(({ departure }) => Date.parse(departure) / 1000), [departures]);
  const lines = useMemo((): Line[] => {
    const hours = departures.map(({ travel_time_s }) => (travel_time_s === null ? null : travel_time_s / 3600));
    const known = hours.filter((value) => value !== null);
    const low = known.length > 0 ? Math.min(...known) : 0;
    const closed = departures.some(({ status }) => status !== 'ok');
    return [
      { label: '', values: hours, colour: colours.plans[0] },
      { label: closed ? 'route found' : '', values: hours, colour: colours.plans[0], dots: 8 },
      ...(closed ? [{ label: 'no route', values: departures.map(({ status }) => (status === 'ok' ? null : low)), colour: colours.danger, dots: 8, hollow: true }] : []),
    ];
  }, [departures, colours]);

  return (
    <section class="departures" aria-label="Departure window">
      <Chart
        title={plan.refinement ? 'Travel time by departure, before refinement' : 'Travel time by departure'} unit="h" height_px={130} times_s={times_s} lines={lines}
        description={describe(departures)} mark_ms={shown && Date.parse(shown.departure)}
        onPick={(time_s) => choose(nearest(departures, 1000 * time_s))}
      />
      {shown && <Choice plan={plan} shown={shown} isPlanned={shown === planned} />}
      <details>
        <summary>Departures in figures</summary>
        <div class="scroll-box" tabIndex={0} role="region" aria-label="Departures">
          <table class="figures">
            <thead><tr><th scope="col">Departure</th><th scope="col">Travel time</th><th scope="col">Arrival</th><th scope="col"><span class="visually-hidden">Choose</span></th></tr></thead>
            <tbody>
              {departures.map((one) => (
                <tr key={one.departure} class={one === shown ? 'selected' : ''}>
                  <td>{shortTime(Date.parse(one.departure))}</td>
                  <td>{one.travel_time_s === null ? 'no route' : duration(one.travel_time_s)}</td>
                  <td>{one.arrival === null ? '–' : shortTime(Date.parse(one.arrival))}</td>
                  <td><button type="button" class="link" aria-pressed={one === shown} onClick={() => choose(one)}>Choose</button></td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </details>
    </section>
  );
}

function Choice({ plan, shown, isPlanned }: { plan: Plan; shown: Departure; isPlanned: boolean }): VNode {
  const when = shortTime(Date.parse(shown.departure));
  const after = afterCurve(plan, shown);
  return (
    <div class="departure-choice" role="status">
      <p>
        <b>{when}</b>
        {shown.travel_time_s !== null && <> · {duration(shown.travel_time_s)}</>}
        {shown.arrival !== null && <> · arrives {shortTime(Date.parse(shown.arrival))}</>}
        {isPlanned && ` · this plan${after && `, ${after}`}`}
        {shown.status !== 'ok' && <span class="fault"> {shown.explanation}</span>}
      </p>
      {!isPlanned && (
        <button type="button" disabled={running.value !== undefined || shown.status !== 'ok' || !may('pilot')} onClick={() => void planAt(plan, shown.departure)}>
          <Icon name="route" /> Plan this departure
        </button>
      )}
    </div>
  );
}

function nearest(departures: Departure[], at_ms: number): Departure | undefined {
  const away = ({ departure }: Departure): number => Math.abs(Date.parse(departure) - at_ms);
  return [...departures].sort((a, b) => away(a) - away(b))[0];
}

function describe(departures: Departure[]): string {
  const open = departures.filter(({ travel_time_s }) => travel_time_s !== null);
  const best = [...open].sort((a, b) => (a.travel_time_s ?? 0) - (b.travel_time_s ?? 0))[0];
  if (!best) return `Chart of ${departures.length} departures, none with a route.`;
  return `Chart of the travel time of ${departures.length} departures; the shortest, ${duration(best.travel_time_s ?? 0)}, leaves ${shortTime(Date.parse(best.departure))}.`;
}
