import { Fragment, type VNode } from 'preact';
import type { Plan } from '../../contract/types';
import { formatLat, formatLon } from '../../geo/coordinates';
import { setTime } from '../../model/clock';
import { hold_s, holdText } from '../../model/plan/holds';
import { legUnderWay, selectedWaypoint, waypointLabel } from '../../model/plan/plans';
import { settings } from '../../model/settings';
import { isLegBelowIce, maySurface, turnFigure } from '../../model/ice/under_ice';
import { shortTime } from '../../model/time';
import { course, distanceFigure, distanceUnit, speedFigure, speedUnit, wholeMetres } from '../../model/units';
import { ask } from '../../model/view';

/** The table of waypoints; the leg under way at the clock's time is marked. */
export function WaypointTable({ plan }: { plan: Plan }): VNode {
  const leg = legUnderWay.value;
  return (
    <div class="scroll-box" tabIndex={0} role="region" aria-label="Waypoints">
      <table class="figures waypoints">
        <thead>
          <tr>
            <th scope="col"><abbr title="Number">#</abbr></th>
            <th scope="col">Position</th>
            <th scope="col">Leg <span class="unit">{distanceUnit()}</span> <abbr class="second" title="Course over ground, from true north">Crs</abbr></th>
            <th scope="col"><abbr title="Speed over ground">SOG</abbr> <span class="unit">{speedUnit()}</span></th>
            <th scope="col"><abbr title="Estimated time of arrival, UTC">ETA</abbr></th>
            <th scope="col"><abbr title="Depth of the sea bed">Depth</abbr> <span class="unit">m</span></th>
            <th scope="col" class="surface">
              <abbr title="Whether the vehicle may surface here; –: no data on sea ice">May surface</abbr>{' '}
              <span class="second">
                <abbr title="How deep the dives on the leg must turn to pass below sea ice and icebergs">Turn</abbr> <span class="unit">m</span>
              </span>
            </th>
          </tr>
        </thead>
        <tbody>
          {plan.waypoints.map((waypoint) => {
            const chosen = selectedWaypoint.value === waypoint.index;
            const choose = (): void => {
              selectedWaypoint.value = waypoint.index;
              setTime(Date.parse(waypoint.eta));
              ask({ do: 'centre', place: [waypoint.lon, waypoint.lat] });
            };
            return (
              <Fragment key={waypoint.index}>
                <tr class={`${chosen ? 'selected' : ''} ${leg === waypoint.index ? 'under-way' : ''}`} onClick={choose}>
                  <td>
                    <button type="button" class="row-choose" aria-pressed={chosen} aria-label={`Waypoint ${waypointLabel(waypoint.index)}`} onClick={(event) => { event.stopPropagation(); choose(); }}>
                      {waypointLabel(waypoint.index)}
                    </button>
                  </td>
                  <td class="position">
                    {formatLat(waypoint.lat, settings.value.coordinates)}
                    <br />
                    {formatLon(waypoint.lon, settings.value.coordinates)}
                  </td>
                  <td>
                    {distanceFigure(waypoint.leg_m)}
                    <br />
                    {course(waypoint.course_deg)}
                  </td>
                  <td>{speedFigure(waypoint.speed_over_ground_m_s)}</td>
                  <td class="time">{shortTime(Date.parse(waypoint.eta), Date.parse(plan.departure)).replace(/ (?=\d\d:)/, '\n')}</td>
                  <td>{wholeMetres(waypoint.depth_m)}</td>
                  <td class={waypoint.may_surface === false ? 'closed' : ''}>
                    {maySurface(waypoint)}
                    {isLegBelowIce(waypoint) && <><br />{turnFigure(waypoint.leg_upper_turn_m)}</>}
                  </td>
                </tr>
                {hold_s(waypoint) > 0 && (
                  <tr class="hold">
                    <td colSpan={7}>
                      {holdText(waypoint)} at waypoint {waypointLabel(waypoint.index)}, until{' '}
                      {shortTime(Date.parse(waypoint.eta) + 1000 * hold_s(waypoint), Date.parse(plan.departure))}
                    </td>
                  </tr>
                )}
              </Fragment>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
