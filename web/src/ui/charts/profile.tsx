import type { VNode } from 'preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import { profileOf } from '../../actions/profile';
import type { Plan } from '../../contract/types';
import { setTime, time_ms } from '../../model/clock';
import { vehicles } from '../../model/datasets';
import { currentAlong_m_s, iceDraft_m, iceKeel_m, nearestBerg_m, type ProfilePoint } from '../../model/plan/profile';
import { requestOf } from '../../model/setup/requests';
import { shortTime } from '../../model/time';
import { turnFigure } from '../../model/ice/under_ice';
import { depth, distanceFigure, distanceUnit, none, speedFigure, speedUnit } from '../../model/units';
import { palette } from '../../theme/palette';
import { Chart, type Line } from './chart';

/** The data along a plan over time, with the clock's time marked; a click sets the clock. */
export function Profile({ plan }: { plan: Plan }): VNode {
  const [points, setPoints] = useState<ProfilePoint[] | undefined>(undefined);
  const [fault, setFault] = useState<string | undefined>(undefined);
  useEffect(() => {
    let wanted = true;
    setPoints(undefined);
    setFault(undefined);
    profileOf(plan)
      .then((found) => {
        if (wanted) setPoints(found);
      })
      .catch((error: unknown) => {
        if (wanted) setFault(error instanceof Error ? error.message : String(error));
      });
    return () => {
      wanted = false;
    };
  }, [plan.plan_id]);
  if (fault) return <p class="fault" role="alert">{fault}</p>;
  if (!points) return <p class="quiet" role="status">Reading the sea along the route …</p>;
  return <Charts plan={plan} points={points} />;
}

function Charts({ plan, points }: { plan: Plan; points: ProfilePoint[] }): VNode {
  const colours = palette.value;
  const times_s = useMemo(() => points.map((point) => point.time_ms / 1000), [points]);
  const dive_m = diveDepthOf(plan);
  const figure = (text: string): number | null => (Number.isFinite(Number(text)) ? Number(text) : null);
  const units = `${speedUnit()} ${distanceUnit()}`;

  const depths = useMemo((): Line[] => {
    const bed = points.map(({ probe }) => probe?.depth_m ?? null);
    const dives = points.map(({ probe }) => (dive_m === undefined ? null : Math.min(dive_m, probe?.depth_m ?? dive_m)));
    return [
      { label: 'sea bed', values: bed, colour: colours.coast, fill: colours.land },
      { label: 'dives to', values: dives, colour: colours.plans[0], dash: [5, 4] },
    ];
  }, [points, colours, dive_m]);
  const above = useMemo((): Line[] => [
    { label: 'ice draft', values: points.map(iceDraft_m), colour: colours.seaIce.edge, width: 3 },
    { label: 'deepest keel', values: points.map(iceKeel_m), colour: colours.seaIce.edge, dash: [2, 3] },
    { label: 'upper turn, leg', values: points.map(({ turn_m }) => turn_m), colour: colours.plans[0], stepped: true },
  ], [points, colours]);
  const speeds = useMemo((): Line[] => [
    { label: 'over ground, leg mean', values: points.map((point) => figure(speedFigure(point.speed_over_ground_m_s))), colour: colours.plans[0], stepped: true },
    { label: 'current along', values: points.map((point) => figure(speedFigure(currentAlong_m_s(point)))), colour: colours.currents[1], dash: [5, 4] },
  ], [points, colours, units]);
  const ice = useMemo((): Line[] => [
    { label: 'nearest berg', values: points.map((point) => figure(distanceFigure(nearestBerg_m(point)))), colour: colours.danger },
  ], [points, colours, units]);

  const common = { times_s, mark_ms: time_ms.value, onPick: (time_s: number) => setTime(1000 * time_s) };
  const isBelowIce = above.some(({ values }) => values.some((value) => value !== null && value > 0));
  const hasIce = ice[0]?.values.some((value) => value !== null) ?? false;
  return (
    <div class="profile">
      <Chart {...common} title="Depth" unit="m" lines={depths} height_px={120} downward fromZero description={`Depth of the sea bed along the route${dive_m === undefined ? '' : `; dives to ${dive_m} m`}.`} />
      {isBelowIce && <Chart {...common} title="Below the ice" unit="m" lines={above} height_px={96} downward fromZero description="Draft of the sea ice above the route, its deepest keels, and how deep the dives of each leg turn, below icebergs too." />}
      <Chart {...common} title="Speed" unit={speedUnit()} lines={speeds} height_px={100} fromZero description="Speed over ground and the current along the course, positive when it pushes." />
      {hasIce && <Chart {...common} title="To the nearest iceberg as sighted" unit={distanceUnit()} lines={ice} height_px={86} fromZero description="Distance to the nearest iceberg where it was last sighted." />}
      <details>
        <summary>Profile in figures</summary>
        <Twin points={points} />
      </details>
    </div>
  );
}

/** The planned dive depth, if it is known. */
function diveDepthOf(plan: Plan): number | undefined {
  const vehicle = vehicles.value.find(({ name }) => name === plan.vehicle);
  return requestOf(plan.plan_id)?.dive_depth_m ?? vehicle?.dive_depth_m;
}

const percent = (share: number | null | undefined): string => (typeof share === 'number' ? `${Math.round(100 * share)} %` : none);
const metres = (value: number | null): string => (value === null ? none : `${value.toFixed(1)} m`);

function Twin({ points }: { points: ProfilePoint[] }): VNode {
  return (
    <div class="scroll-box profile-table" tabIndex={0} role="region" aria-label="Profile">
      <table class="figures">
        <thead>
          <tr>
            <th scope="col">Time</th><th scope="col">Sea bed</th><th scope="col">Sea ice</th><th scope="col">Draft</th><th scope="col">Keel</th><th scope="col">Turn <span class="unit">m</span></th>
            <th scope="col">SOG <span class="unit">{speedUnit()}</span></th>
            <th scope="col">Current along <span class="unit">{speedUnit()}</span></th>
            <th scope="col">Berg <span class="unit">{distanceUnit()}</span></th>
          </tr>
        </thead>
        <tbody>
          {points.map((point) => (
            <tr key={point.time_ms}>
              <td><button type="button" class="link" onClick={() => setTime(point.time_ms)}>{shortTime(point.time_ms)}</button></td>
              <td>{depth(point.probe?.depth_m)}</td>
              <td>{percent(point.probe?.ice_concentration)}</td>
              <td>{metres(iceDraft_m(point))}</td>
              <td>{metres(iceKeel_m(point))}</td>
              <td>{turnFigure(point.turn_m)}</td>
              <td>{speedFigure(point.speed_over_ground_m_s)}</td>
              <td>{speedFigure(currentAlong_m_s(point))}</td>
              <td>{distanceFigure(nearestBerg_m(point))}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
