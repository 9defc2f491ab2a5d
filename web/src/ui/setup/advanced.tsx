import type { VNode } from 'preact';
import { vehicles } from '../../model/datasets';
import { draft } from '../../model/draft';
import { AreasField } from './areas_field';
import { DataPart } from './data_part';
import { CheckField, SelectField, TextField, type Choice } from './field';
import { IcePart } from './ice_part';
import { Part } from './part';
import { PlacesField } from './places_field';
import { ReachPart } from './reach_part';
import { UncertaintyPart } from './uncertainty_part';

const methods: Choice[] = [
  { value: 'astar', title: 'A* (fastest)' },
  { value: 'dijkstra', title: 'Dijkstra' },
  { value: 'tve', title: 'TVE (as published)' },
  { value: 'frozen', title: 'Frozen at departure' },
  { value: 'direct', title: 'Straight line' },
];

/** What has a good default, by what it is about; a part opens by itself when a fault lies within. */
export function Advanced(): VNode {
  const vehicle = vehicles.value.find(({ name }) => name === draft.value.vehicle) ?? vehicles.value[0];
  return (
    <div class="parts">
      <Part title="Places and areas" fields={['via', 'via_order', 'areas']}>
        <PlacesField />
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
      <Part title="Vehicle" fields={['objective', 'objective.time', 'objective.energy', 'speed_m_s', 'dive_depth_m', 'pitch_deg', 'climb_to_m', 'altimeter_margin_m', 'battery_j', 'battery_start_share', 'require_battery', 'thruster']}>
        <SelectField name="objective" label="Optimise" choices={[{ value: 'time', title: 'Travel time' }, { value: 'energy', title: 'Energy' }, { value: 'both', title: 'Both, weighted' }]} />
        {draft.value.objective === 'both' && (
          <div class="field-pair">
            <TextField name="objective.time" label="A second weighs" inputMode="decimal" />
            <TextField name="objective.energy" label="A joule weighs" inputMode="decimal" />
          </div>
        )}
        <div class="field-pair">
          <TextField name="speed_m_s" label="Water speed" unit="m/s" inputMode="decimal" placeholder={vehicle?.speed_m_s.toString()} />
          <TextField name="dive_depth_m" label="Dive depth" unit="m" inputMode="decimal" placeholder={vehicle?.dive_depth_m.toString()} />
        </div>
        <div class="field-pair">
          <TextField name="climb_to_m" label="Climb to" unit="m" inputMode="decimal" placeholder={vehicle?.climb_to_m?.toString()} />
          <TextField name="altimeter_margin_m" label="Above bed" unit="m" inputMode="decimal" placeholder={vehicle?.altimeter_margin_m?.toString()} />
        </div>
        <div class="field-pair">
          <TextField name="battery_j" label="Battery" unit="MJ" inputMode="decimal" placeholder="as built" />
          <TextField name="battery_start_share" label="Charged" unit="%" inputMode="decimal" placeholder="100" />
        </div>
        <TextField name="pitch_deg" label="Pitch" unit="°" inputMode="decimal" placeholder={vehicle?.pitch_deg?.toString()} />
        <SelectField name="thruster" label="Thruster" choices={[{ value: 'auto', title: 'Where it helps' }, { value: 'on', title: 'Always' }, { value: 'off', title: 'Never' }]} />
        <CheckField name="require_battery" label="Only plans that the battery lasts for" />
      </Part>
      <IcePart />
      <UncertaintyPart />
      <Part title="Advanced" fields={['name', 'method', 'sectors', 'spacing_m', 'max_waypoints', 'max_leg_m', 'max_loiter_s', 'refine', 'refine_seconds', 'optimality_gap', 'steady']}>
        <TextField name="name" label="Name of the plan" placeholder="optional" />
        <div class="field-pair">
          <SelectField name="method" label="Method" choices={methods} />
          <TextField name="sectors" label="Reach" unit="1–5" inputMode="numeric" />
        </div>
        <div class="field-pair">
          <TextField name="spacing_m" label="Grid spacing" unit="m" inputMode="decimal" placeholder="automatic" />
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
