import { destination } from '../geo/geodesic';
import { selectedWaypoint, waypointLabel } from '../model/plan/plans';
import { insertAfter, moveWaypoint, openEdit, removeWaypoint } from '../model/plan/route_edit';
import { announce } from '../model/screen';
import { tool, view } from '../model/view';

const step_m = { plain: 100, shift: 1000, alt: 10 };

/** Directions of the arrow keys on the screen, clockwise from up. */
const arrows_deg: Record<string, number> = { ArrowUp: 0, ArrowRight: 90, ArrowDown: 180, ArrowLeft: 270 };

/** Handles keys for the edited route; true if the key was used. */
export function editByKey(event: KeyboardEvent): boolean {
  const edit = openEdit.peek();
  if (!edit || event.ctrlKey || event.metaKey) return false;
  const chosen = selectedWaypoint.peek();
  if (tool.peek() !== 'pan') return false;
  if (!(event.target instanceof Element) || event.target.id !== 'map') return false;
  const last = edit.route.length - 1;
  if (event.key === 'Tab') return nextByKey(event, chosen, last);
  if (chosen === undefined) return false;

  const place = edit.route[chosen];
  const arrow_deg = arrows_deg[event.key];
  if (arrow_deg !== undefined && place) {
    const size_m = event.shiftKey ? step_m.shift : event.altKey ? step_m.alt : step_m.plain;
    moveWaypoint(chosen, destination(place, arrow_deg - (view.peek()?.north_deg ?? 0), size_m));
    return true;
  }
  if (event.key === 'Insert') insertAfter(chosen);
  else if (event.key === 'Delete') removeWaypoint(chosen);
  else return false;
  return true;
}

/** Tab selects the next waypoint; after the last or before the first it leaves the map as usual. */
function nextByKey(event: KeyboardEvent, chosen: number | undefined, last: number): boolean {
  const next = chosen === undefined ? undefined : chosen + (event.shiftKey ? -1 : 1);
  if (next === undefined || next < 0 || next > last) return false;
  selectedWaypoint.value = next;
  announce(`Waypoint ${waypointLabel(next)}`);
  return true;
}
