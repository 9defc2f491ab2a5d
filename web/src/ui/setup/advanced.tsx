import type { VNode } from 'preact';
import type { DatasetKind } from '../../api/types';
import { ofKind, vehicles } from '../../model/datasets';
import { draft, faults, type Field } from '../../model/draft';
import { AreaField, CheckField, SelectField, TextField, type Choice } from './field';

const methods: Choice[] = [
  { value: 'astar', title: 'A* (fastest)' },
  { value: 'dijkstra', title: 'Dijkstra' },
  { value: 'tve', title: 'TVE (as published)' },
  { value: 'frozen', title: 'Frozen at departure' },
  { value: 'direct', title: 'Straight line' },
];

const inside: Field[] = [
  'name', 'via', 'method', 'speed_m_s', 'dive_depth_m', 'spacing_m', 'sectors', 'max_waypoints', 'refine', 'steady', 'currents',
  'bathymetry', 'ice', 'icebergs', 'coastline', 'icebergs_as_of',
];

/** What has a good default; opens by itself when a fault lies within. */
export function Advanced(): VNode {
  const vehicle = vehicles.value.find(({ name }) => name === draft.value.vehicle) ?? vehicles.value[0];
  const faulty = inside.some((field) => faults.value[field]);
  return (
    <details class="advanced" open={faulty || undefined}>
      <summary>Advanced</summary>
      <TextField name="name" label="Name of the plan" placeholder="optional" />
      <AreaField name="via" label="Places to pass, one on each line" placeholder="69°05.0′N 52°00.0′W" rows={2} />
      <div class="field-pair">
        <SelectField name="method" label="Method" choices={methods} />
        <TextField name="sectors" label="Reach" unit="1–5" inputMode="numeric" />
      </div>
      <div class="field-pair">
        <TextField
          name="speed_m_s" label="Water speed" unit="m/s" inputMode="decimal"
          placeholder={vehicle?.speed_m_s.toString()}
        />
        <TextField name="dive_depth_m" label="Dive depth" unit="m" inputMode="decimal" placeholder={vehicle?.dive_depth_m.toString()} />
      </div>
      <div class="field-pair">
        <TextField name="spacing_m" label="Grid spacing" unit="m" inputMode="decimal" placeholder="automatic" />
        <TextField name="max_waypoints" label="Most waypoints" inputMode="numeric" placeholder="no limit" />
      </div>
      <CheckField name="refine" label="Refine the route beyond the grid" />
      <CheckField name="steady" label="Hold the currents at departure" />
      <DataField kind="currents" label="Currents" />
      <DataField kind="bathymetry" label="Depths" />
      <DataField kind="ice" label="Sea ice" />
      <DataField kind="icebergs" label="Icebergs" />
      <TextField name="icebergs_as_of" label="Icebergs as known at" unit="UTC" placeholder="departure" />
      <DataField kind="coastline" label="Coastline" />
    </details>
  );
}

function DataField({ kind, label }: { kind: DatasetKind; label: string }): VNode {
  const stored = ofKind(kind).map(({ id, name }) => ({ value: id, title: name }));
  const newest = stored[0] ? `Newest (${stored[0].title})` : 'Newest (none stored)';
  return (
    <SelectField name={kind} label={label} choices={[{ value: 'newest', title: newest }, ...stored, { value: 'none', title: 'None' }]} />
  );
}
