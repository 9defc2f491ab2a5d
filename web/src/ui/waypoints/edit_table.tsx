import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import type { Position } from '../../contract/data_types';
import type { Waypoint } from '../../contract/types';
import { editablePosition } from '../../geo/coordinates';
import { readPosition } from '../../model/position';
import { selectedWaypoint, waypointLabel } from '../../model/plan/plans';
import { insertAfter, moveWaypoint, removeWaypoint, type RouteEdit } from '../../model/plan/route_edit';
import { announce } from '../../model/screen';
import { shortTime } from '../../model/time';
import { distanceFigure, distanceUnit, none } from '../../model/units';
import { ask } from '../../model/view';
import { IconButton } from '../common/icon';

/** The edited route as a table: everything that can be dragged can also be typed. */
export function EditTable({ edit }: { edit: RouteEdit }): VNode {
  const route = edit.route;
  const figures = edit.verdict.state === 'ok' ? edit.verdict.plan.waypoints : [];
  return (
    <div class="scroll-box" role="region" aria-label="Waypoints" tabIndex={0}>
      <table class="figures waypoints edit-table">
        <thead>
          <tr>
            <th scope="col"><abbr title="Number">#</abbr></th>
            <th scope="col">Position</th>
            <th scope="col">Leg <span class="unit">{distanceUnit()}</span></th>
            <th scope="col"><abbr title="Estimated time of arrival, UTC">ETA</abbr></th>
            <th scope="col"><span class="visually-hidden">Change</span></th>
          </tr>
        </thead>
        <tbody>
          {route.map((place, i) => (
            <Row key={i} index={i} place={place} figures={figures[i]} depart_ms={Date.parse(edit.origin.departure)} removable={route.length > 2} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

interface RowProps {
  index: number;
  place: Position;
  figures: Waypoint | undefined;
  depart_ms: number; // times in the year of this departure are shown without the year
  removable: boolean;
}

function Row({ index, place, figures, depart_ms, removable }: RowProps): VNode {
  const chosen = selectedWaypoint.value === index;
  const label = waypointLabel(index);
  const choose = (): void => {
    selectedWaypoint.value = index;
    ask({ do: 'centre', place });
  };
  return (
    <tr class={chosen ? 'selected' : ''}>
      <td>
        <button type="button" class="row-choose" aria-pressed={chosen} aria-label={`Waypoint ${label}`} onClick={choose}>{label}</button>
      </td>
      <td class="position"><PositionInput index={index} place={place} /></td>
      <td>{distanceFigure(figures?.leg_m)}</td>
      <td class="time">{figures ? shortTime(Date.parse(figures.eta), depart_ms).replace(/ (?=\d\d:)/, '\n') : none}</td>
      <td class="row-tools">
        <IconButton icon="plus" label={`Insert a waypoint after ${label}`} onClick={() => insertAfter(index)} />
        <IconButton icon="x" label={`Remove waypoint ${label}`} disabled={!removable} onClick={() => removeWaypoint(index)} />
      </td>
    </tr>
  );
}

/**
 * A field that takes effect when it loses the focus or Enter is pressed; a text that cannot be read stays, with its
 * fault, and changes nothing. Passing it by Tab does not select the waypoint: on the map, keys would move another one than
 * the one that was chosen.
 */
function PositionInput({ index, place }: { index: number; place: Position }): VNode {
  const written = editablePosition(place);
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const [fault, setFault] = useState<string | undefined>(undefined);
  const take = (text: string): void => {
    if (text === written) {
      setTyped(undefined);
      setFault(undefined);
      return;
    }
    const parsed = readPosition(text);
    setFault(parsed.ok ? undefined : parsed.fault);
    if (!parsed.ok) {
      announce(parsed.fault);
      return;
    }
    setTyped(undefined);
    moveWaypoint(index, parsed.value);
  };
  return (
    <>
      <input
        type="text" aria-label={`Position of waypoint ${waypointLabel(index)}`} value={typed ?? written} autocomplete="off" spellcheck={false}
        aria-invalid={fault ? true : undefined} aria-describedby={fault ? `waypoint-fault-${index}` : undefined}
        onPointerDown={() => { selectedWaypoint.value = index; }}
        onInput={(event) => {
          selectedWaypoint.value = index;
          setTyped(event.currentTarget.value);
        }}
        onChange={(event) => take(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === 'Escape') {
            setTyped(undefined);
            setFault(undefined);
          }
        }}
      />
      {fault && <p class="fault" id={`waypoint-fault-${index}`}>{fault}</p>}
    </>
  );
}
