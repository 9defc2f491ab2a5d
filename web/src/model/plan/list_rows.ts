import type { MissionPreview } from '../../contract/types';
import { waypointLabel } from './plans';

/** A waypoint's label, its index in JSON documents, and its row in a waypoint list. */
export interface ListRow {
  label: string;
  index: number;
  file: string; // empty: the start, which the lists leave out
  row: number | undefined; // from 0, as the vehicle counts
  holds: boolean; // the file keeps the vehicle at the waypoint
}

/** The line of a list's head that says which waypoints of the plan it holds. */
const held = /^# .*: waypoints (\d+) to (\d+) of \d+$/m;

/** The line of the head of a list that keeps the vehicle at a waypoint. */
const heldAt = /^# .*: hold at waypoint (\d+) of \d+$/m;

/** Every waypoint of a plan with its row in the files. Empty if a file does not say which waypoints it holds. */
export function listRows(files: MissionPreview['files']): ListRow[] {
  const rows = files.flatMap(({ name, text }): ListRow[] => {
    const hold = heldAt.exec(text)?.[1];
    if (hold !== undefined) return [{ label: waypointLabel(Number(hold)), index: Number(hold), file: name, row: undefined, holds: true }];
    const [first, last] = (held.exec(text) ?? []).slice(1).map(Number);
    if (first === undefined || last === undefined) return [];
    return Array.from({ length: last - first + 1 }, (_, row) => ({ label: waypointLabel(first + row), index: first + row, file: name, row, holds: false }));
  });
  return rows.length > 0 ? [{ label: waypointLabel(0), index: 0, file: '', row: undefined, holds: false }, ...rows] : [];
}
