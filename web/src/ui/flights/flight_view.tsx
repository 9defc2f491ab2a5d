import type { VNode } from 'preact';
import { useMemo } from 'preact/hooks';
import type { Flight } from '../../contract/simulation_types';
import type { Plan } from '../../contract/types';
import { setTime, time_ms } from '../../model/clock';
import { asSentence } from '../../model/page_words';
import { crossTrackErrors_m, crossTrackOf, endTitles, isEcho, modeTitles, momentOf, returnsOf, sonarAt, sonarShown_s, stretchesOf } from '../../model/plan/flight';
import { routeOf } from '../../model/plan/plans';
import { duration, shortTime } from '../../model/time';
import { depth, distance, none } from '../../model/units';
import { ask } from '../../model/view';
import { palette } from '../../theme/palette';
import { Chart, type Line } from '../charts/chart';

const signed = (metres: number): string => `${distance(Math.abs(metres))} ${metres < 0 ? 'left' : 'right'}`;

/** A flight played back by the clock: present state, errors and depths over time, and events. */
export function FlightView({ plan, flight }: { plan: Plan; flight: Flight }): VNode {
  return (
    <section class="flight" aria-label={`Flight ${flight.run + 1}`}>
      <h3>Flight {flight.run + 1}: {endTitles[flight.end]} after {duration(flight.travel_time_s)}</h3>
      <p class={flight.end === 'arrived' ? 'hint' : 'fault'}>{asSentence(flight.end_reason)}</p>
      <Key />
      <Now plan={plan} flight={flight} />
      <Charts plan={plan} flight={flight} />
      <Happenings flight={flight} />
    </section>
  );
}

/** The legend of a flight on the map. */
function Key(): VNode {
  return (
    <ul class="flight-key">
      <li><svg width="22" height="10" aria-hidden="true"><path class="flown" d="M1 5 H21" /></svg> flown</li>
      <li><svg width="22" height="10" aria-hidden="true"><path class="believed" d="M1 5 H21" /></svg> believed</li>
      <li><svg width="22" height="10" aria-hidden="true"><path class="evading" d="M1 5 H21" /></svg> manoeuvre</li>
      <li><svg width="22" height="10" aria-hidden="true"><circle class="surfaced" cx="11" cy="5" r="4" /></svg> surfaced</li>
      <li><svg width="22" height="10" aria-hidden="true"><path class="contact" d="M7 1 L15 9 M15 1 L7 9" /></svg> contact</li>
    </ul>
  );
}

function Now({ plan, flight }: { plan: Plan; flight: Flight }): VNode {
  const crossTrack = useMemo(() => crossTrackOf(routeOf(plan)), [plan]);
  const now = momentOf(flight, time_ms.value);
  const echo = sonarAt(flight, time_ms.value, sonarShown_s);
  const figures = [
    ['Cross-track', now ? signed(crossTrack(now.place)) : none],
    ['Depth', now ? (now.atSurface ? 'surface' : depth(now.depth_m)) : none],
    ['Believed within', now ? distance(now.sigma_m) : none],
    ['Sonar, nearest', echo ? `${distance(echo.nearest_m)}${isEcho(echo.returns) ? '' : ', lone'}` : none],
    ['Guidance', now ? modeTitles[now.mode] : none],
  ];
  return (
    <dl class="figures-grid flight-now">
      {figures.map(([title, text]) => <div key={title}><dt>{title}</dt><dd>{text}</dd></div>)}
    </dl>
  );
}

function Charts({ plan, flight }: { plan: Plan; flight: Flight }): VNode {
  const colours = palette.value;
  const start_s = Date.parse(flight.departure) / 1000;
  const { track, sensors } = flight;
  const times_s = useMemo(() => track.time_s.map((time_s) => start_s + time_s), [flight]);
  const sonar_s = useMemo(() => sensors.sonar.time_s.map((time_s) => start_s + time_s), [flight]);
  const errors = useMemo((): Line[] => [
    { label: 'cross-track', values: crossTrackErrors_m(flight, plan).map(Math.round), colour: colours.plans[0] },
    { label: 'believed within', values: track.sigma_m, colour: colours.label, dash: [4, 4] },
  ], [flight, plan, colours]);
  const depths = useMemo((): Line[] => [{ label: 'depth', values: track.depth_m, colour: colours.currents[1], width: 1.2 }], [flight, colours]);
  const pings = useMemo((): Line[] => {
    const { echoes, lone } = returnsOf(flight);
    return [{ label: 'lone return', values: lone, colour: colours.graticule, dots: 2 }, { label: 'echo', values: echoes, colour: colours.danger, dots: 3 }];
  }, [flight, colours]);
  const common = { mark_ms: time_ms.value, onPick: (time_s: number) => setTime(1000 * time_s) };
  return (
    <>
      <Chart {...common} times_s={times_s} title="Cross-track error" unit="m" lines={errors} height_px={104} fromZero description="How far the vehicle is from the planned route, positive to its right, and one sigma of where it believes to be." />
      <Chart {...common} times_s={times_s} title="Depth" unit="m" lines={depths} height_px={90} downward fromZero description="Depth of the vehicle." />
      {sonar_s.length > 0 && <Chart {...common} times_s={sonar_s} title="Sonar, nearest return" unit="m" lines={pings} height_px={90} fromZero description="Distance of the nearest return of each ping that had one; a lone return may be a false alarm." />}
    </>
  );
}

interface Happening {
  at_ms: number;
  text: string;
  lon: number;
  lat: number;
}

function Happenings({ flight }: { flight: Flight }): VNode {
  const happened = useMemo(() => happeningsOf(flight), [flight]);
  return (
    <details class="happenings">
      <summary>What happened <span class="unit">{happened.length}</span></summary>
      <ol>
        {happened.map(({ at_ms, text, lon, lat }, i) => (
          <li key={i}>
            <button type="button" class="link" onClick={() => { setTime(at_ms); ask({ do: 'centre', place: [lon, lat] }); }}>{shortTime(at_ms)}</button> {text}
          </li>
        ))}
      </ol>
    </details>
  );
}

const titles: Partial<Record<Flight['events'][number]['kind'], string>> = {
  surfacing: 'Surfaced', waypoint: 'Waypoint reached', contact: 'Contact', end: 'End',
};

/** Surfacings, waypoints, contacts, the closest approaches and each manoeuvre, by time. */
function happeningsOf({ approaches, track, events, departure }: Flight): Happening[] {
  const told = events.flatMap(({ kind, text, time, lon, lat }): Happening[] => {
    const title = titles[kind];
    return title ? [{ at_ms: Date.parse(time), text: text ? `${title}: ${text}` : title, lon, lat }] : [];
  });
  const manoeuvres = stretchesOf(track.mode).filter(({ mode }) => mode !== 'mission').map(({ mode, first, last }): Happening => {
    const took_s = (track.time_s[last] ?? 0) - (track.time_s[first] ?? 0);
    return {
      at_ms: Date.parse(departure) + 1000 * (track.time_s[first] ?? 0), text: `Manoeuvre, ${modeTitles[mode]}, ${duration(took_s)}`,
      lon: track.lon[first] ?? 0, lat: track.lat[first] ?? 0,
    };
  });
  const closest = approaches.map(({ distance_m, to, time, lon, lat }): Happening => (
    { at_ms: Date.parse(time), text: `Closest to ${to}: ${distance(distance_m)}`, lon, lat }
  ));
  return [...told, ...closest, ...manoeuvres].sort((a, b) => a.at_ms - b.at_ms);
}
