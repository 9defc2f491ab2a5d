import type { VNode } from 'preact';
import { draft, hasGoalsFile } from '../../model/draft';
import { AreasField } from './areas_field';
import { DataPart } from './data_part';
import { CheckField, SelectField, TextField, type Choice } from './field';
import { IcePart } from './ice_part';
import { Part } from './part';
import { PlacesField } from './places_field';
import { ReachPart } from './reach_part';
import { UncertaintyPart } from './uncertainty_part';
import { VehiclePart } from './vehicle_part';

const methods: Choice[] = [
  { value: 'astar', title: 'A* (fastest)' },
  { value: 'dijkstra', title: 'Dijkstra' },
  { value: 'tve', title: 'TVE (as published)' },
  { value: 'frozen', title: 'Frozen at departure' },
  { value: 'direct', title: 'Straight line' },
];

/** What has a good default, by what it is about; a part opens by itself when a fault lies within. */
export function Advanced(): VNode {
  return (
    <div class="parts">
      <Part title="Places and areas" fields={['via', 'via_order', 'areas']}>
        {hasGoalsFile(draft.value) ? <p class="hint">The places to pass come from {draft.value.goals_file.name}.</p> : <PlacesField />}
        <AreasField />
      </Part>
      <Part title="Departure window" fields={['depart_until', 'arrive_by']}>
        <div class="field-pair wide-first">
          <TextField name="depart_until" label="Latest departure" unit="UTC" placeholder="one departure only" />
          <TextField name="depart_step" label="Every" unit="h" inputMode="decimal" />
        </div>
        <TextField name="arrive_by" label="Latest arrival" unit="UTC" placeholder="any" hint="With it the latest departure that arrives in time is found." />
      </Part>
      <ReachPart />
      <VehiclePart />
      <IcePart />
      <UncertaintyPart />
      <Part title="Advanced" fields={['name', 'method', 'sectors', 'spacing_m', 'max_waypoints', 'max_leg_m', 'max_loiter_s', 'refine', 'refine_seconds', 'optimality_gap', 'steady']}>
        <TextField name="name" label="Name of the plan" placeholder="optional" />
        <div class="field-pair">
          <SelectField name="method" label="Method" choices={methods} />
          <TextField name="sectors" label="Reach" unit="1–5" inputMode="numeric" />
        </div>
        <div class="field-pair">
          <TextField name="spacing_m" label="Grid spacing" unit="m" placeholder="automatic" />
          <TextField name="max_waypoints" label="Most waypoints" inputMode="numeric" placeholder="no limit" />
        </div>
        <div class="field-pair">
          <TextField name="max_leg_m" label="Longest leg" unit="km" inputMode="decimal" placeholder="no limit" />
          <TextField name="max_loiter_s" label="Longest wait" unit="h" inputMode="decimal" placeholder="never" />
        </div>
        <CheckField name="refine" label="Refine the route beyond the grid" />
        {draft.value.refine && <TextField name="refine_seconds" label="Refine for at most" unit="s" inputMode="decimal" placeholder="1" />}
        <CheckField name="optimality_gap" label="Compare with the best way in open water" />
        <CheckField name="steady" label="Hold the currents at departure" />
      </Part>
      <DataPart />
    </div>
  );
}
