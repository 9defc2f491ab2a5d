import type { VNode } from 'preact';
import { tracksAddress } from '../../actions/client';
import { playFlight } from '../../actions/simulating';
import type { Distribution, Interval, Run, Simulation } from '../../contract/simulation_types';
import { asSentence } from '../../model/page_words';
import { endTitles } from '../../model/plan/flight';
import { playedFlight } from '../../model/plan/simulations';
import { duration } from '../../model/time';
import { distance, energy, none } from '../../model/units';
import { Icon } from '../common/icon';
import { Messages } from '../common/messages';

const percent = (share: number): string => `${(100 * share).toFixed(share > 0 && share < 0.1 ? 1 : 0)} %`;
/** A number that stays on the same line as its unit. */
const whole = (text: string): string => text.replaceAll(' ', '\u00a0');
const between = ([low, high]: Interval, text: (value: number) => string): string => `${whole(text(low))} – ${whole(text(high))}`;

/** The summary of a simulation: how its flights ended, with 95 % intervals, and a list of the flights. */
export function SimulationView({ simulation }: { simulation: Simulation }): VNode {
  const { flights, runs, simulation_id, statistics, tracks } = simulation;
  return (
    <section class="simulation" aria-label="Simulation">
      <Messages of={simulation} about=" of the simulation" />
      {runs > 1 && (
        <ul class="ends" aria-label="How the flights ended">
          {statistics.ends.map(({ end, runs: count, share, share_interval_95 }) => (
            <li key={end}><b class={end === 'arrived' ? '' : 'bad'}>{endTitles[end]}</b> {count} of {runs}: {percent(share)} <span class="unit">({between(share_interval_95, percent)})</span></li>
          ))}
        </ul>
      )}
      {runs > 1 && (
        <div class="scroll-box" tabIndex={0} role="region" aria-label="Statistics">
          <table class="figures statistics">
            <thead><tr><th scope="col">Of {runs} flights</th><th scope="col">Mean</th><th scope="col">Median</th><th scope="col">p5 – p95</th></tr></thead>
            <tbody>
              <Spread title="Travel time" of={statistics.travel_time_s} text={duration} />
              <Spread title="Worst position error" of={statistics.worst_position_error_m} text={distance} />
              <Spread title="Clearance" of={statistics.clearance_m} text={distance} />
              <Spread title="Energy" of={statistics.energy_j} text={energy} />
            </tbody>
          </table>
        </div>
      )}
      <div class="scroll-box flight-list" tabIndex={0} role="region" aria-label="Flights">
        <table class="figures">
          <thead><tr><th scope="col">Flight</th><th scope="col">End</th><th scope="col">Time</th><th scope="col">Clearance</th><th scope="col">Worst error</th></tr></thead>
          <tbody>{flights.map((run) => <FlightRow key={run.run} id={simulation_id} run={run} kept={run.run < tracks} />)}</tbody>
        </table>
      </div>
      {runs > 1 && <p class="hint">Small figures and those in brackets are intervals of 95 % confidence.</p>}
      {tracks > 0 && (
        <p class="downloads">
          <a class="button" href={tracksAddress(simulation_id, 'nc')} download><Icon name="download" /> NetCDF</a>
          <a class="button" href={tracksAddress(simulation_id, 'geojson')} download><Icon name="download" /> GeoJSON</a>
        </p>
      )}
    </section>
  );
}

function Spread({ title, of, text }: { title: string; of: Distribution | null; text: (value: number) => string }): VNode | null {
  if (!of) return null;
  const at = (share: number) => of.quantiles.find((quantile) => Math.abs(quantile.share - share) < 1e-6);
  const [low, median, high] = [at(0.05), at(0.5), at(0.95)];
  return (
    <tr>
      <th scope="row">{title}</th>
      <td>{whole(text(of.mean))}{of.mean_interval_95 && <span class="difference">{between(of.mean_interval_95, text)}</span>}</td>
      <td>{median ? whole(text(median.value)) : none}{median?.interval_95 && <span class="difference">{between(median.interval_95, text)}</span>}</td>
      <td>{low && high ? between([low.value, high.value], text) : none}</td>
    </tr>
  );
}

function FlightRow({ id, run, kept }: { id: string; run: Run; kept: boolean }): VNode {
  const chosen = playedFlight.value?.run === run.run;
  return (
    <>
      <tr class={chosen ? 'selected' : ''}>
        <td>
          {kept
            ? <button type="button" class="row-choose" aria-pressed={chosen} aria-label={`Play flight ${run.run + 1}`} onClick={() => void playFlight(id, run.run)}>{run.run + 1}</button>
            : <abbr title="Its track was not kept">{run.run + 1}</abbr>}
        </td>
        <td class={run.end === 'arrived' ? '' : 'bad'}>{endTitles[run.end]}</td>
        <td>{duration(run.travel_time_s)}</td>
        <td>{distance(run.clearance_m)}</td>
        <td>{distance(run.worst_position_error_m)}</td>
      </tr>
      {run.why && (
        <tr class="why">
          <td />
          <td colSpan={4}><span class="difference">{asSentence(run.why)}{run.could_be_saved === false && ' Even with full knowledge of the ice, the vehicle could not have avoided this.'}</span></td>
        </tr>
      )}
    </>
  );
}
