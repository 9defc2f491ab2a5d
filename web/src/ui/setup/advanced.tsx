import type { VNode } from 'preact';
import { draft, hasGoalsFile } from '../../model/setup/draft';
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

/** Fields with a good default, in parts by subject. A part opens by itself when a field in it has a fault. */
export function Advanced(): VNode {
  return (
    <div class="parts">
      <Part title="Places and areas">
        {hasGoalsFile(draft.value) ? <p class="hint">The via points come from {draft.value.goals_file.name}.</p> : <PlacesField />}
        <AreasField />
      </Part>
      <Part title="Departure window">
        <div class="field-pair wide-first">
          <TextField name="depart_until" />
          <TextField name="depart_step" inputMode="decimal" />
        </div>
        <TextField name="arrive_by" />
      </Part>
      <ReachPart />
      <VehiclePart />
      <IcePart />
      <UncertaintyPart />
      <Part title="Advanced">
        <TextField name="name" />
        <div class="field-pair">
          <SelectField name="method" choices={methods} />
          <TextField name="sectors" />
        </div>
        <div class="field-pair">
          <TextField name="spacing_m" />
          <TextField name="max_waypoints" />
        </div>
        <div class="field-pair">
          <TextField name="max_leg_m" />
          <TextField name="max_loiter_s" />
          <TextField name="hold_radius_m" />
        </div>
        <CheckField name="refine" />
        {draft.value.refine && (
          <div class="field-pair">
            <TextField name="leg_tolerance" />
            <TextField name="refine_seconds" />
          </div>
        )}
        <CheckField name="optimality_gap" />
        <CheckField name="steady" />
      </Part>
      <DataPart />
    </div>
  );
}
