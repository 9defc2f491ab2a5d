import type { ComponentChildren, VNode } from 'preact';
import type { DatasetKind } from '../../api/types';
import { ofKind, vehicles } from '../../model/datasets';
import { draft, emptyDraft, faults, type Field } from '../../model/draft';
import { AreasField } from './areas_field';
import { CheckField, SelectField, TextField, type Choice } from './field';
import { PlacesField } from './places_field';
import { ReachPart } from './reach_part';

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
      <Part title="Vehicle" fields={['objective', 'speed_m_s', 'dive_depth_m', 'pitch_deg', 'climb_to_m', 'altimeter_margin_m', 'battery_start_share', 'require_battery', 'thruster']}>
        <SelectField name="objective" label="Optimise" choices={[{ value: 'time', title: 'Travel time' }, { value: 'energy', title: 'Energy' }]} />
        <div class="field-pair">
          <TextField name="speed_m_s" label="Water speed" unit="m/s" inputMode="decimal" placeholder={vehicle?.speed_m_s.toString()} />
          <TextField name="dive_depth_m" label="Dive depth" unit="m" inputMode="decimal" placeholder={vehicle?.dive_depth_m.toString()} />
        </div>
        <div class="field-pair">
          <TextField name="climb_to_m" label="Climb to" unit="m" inputMode="decimal" placeholder={vehicle?.climb_to_m?.toString()} />
          <TextField name="altimeter_margin_m" label="Above bed" unit="m" inputMode="decimal" placeholder={vehicle?.altimeter_margin_m?.toString()} />
        </div>
        <div class="field-pair">
          <TextField name="pitch_deg" label="Pitch" unit="°" inputMode="decimal" placeholder={vehicle?.pitch_deg?.toString()} />
          <TextField name="battery_start_share" label="Battery" unit="%" inputMode="decimal" placeholder="100" />
        </div>
        <SelectField name="thruster" label="Thruster" choices={[{ value: 'auto', title: 'Where it helps' }, { value: 'on', title: 'Always' }, { value: 'off', title: 'Never' }]} />
        <CheckField name="require_battery" label="Only plans that the battery lasts for" />
      </Part>
      <Part title="Ice" fields={['icebergs_drift', 'max_inflation_m', 'max_sighting_age_days', 'icebergs_as_of', 'under_ice.max_concentration_to_surface', 'under_ice.margin_below_ice_m', 'under_ice.draft_if_unknown_m', 'under_ice.max_time_without_surfacing_s', 'under_ice.escape_plan']}>
        <CheckField name="icebergs_drift" label="Let icebergs drift and positions age" />
        <div class="field-pair">
          <TextField name="max_inflation_m" label="Most for errors" unit="m" inputMode="decimal" placeholder="5000" />
          <TextField name="max_sighting_age_days" label="Sightings up to" unit="days" inputMode="decimal" placeholder="3" />
        </div>
        <TextField name="icebergs_as_of" label="Icebergs as known at" unit="UTC" placeholder="departure" />
        <div class="field-pair">
          <TextField name="under_ice.max_concentration_to_surface" label="Surface up to" unit="% ice" inputMode="decimal" placeholder="10" />
          <TextField name="under_ice.max_time_without_surfacing_s" label="Longest below" unit="h" inputMode="decimal" placeholder="no limit" />
        </div>
        <div class="field-pair">
          <TextField name="under_ice.margin_below_ice_m" label="Below the ice" unit="m" inputMode="decimal" placeholder="10" />
          <TextField name="under_ice.draft_if_unknown_m" label="Unknown draft" unit="m" inputMode="decimal" placeholder="30" />
        </div>
        <CheckField name="under_ice.escape_plan" label="A way out from every waypoint" />
      </Part>
      <Part title="Uncertainty of currents" fields={['uncertainty.members', 'uncertainty.current_error_m_s', 'uncertainty.length_scale_m', 'uncertainty.time_scale_s']}>
        <div class="field-pair">
          <TextField name="uncertainty.members" label="Members" unit="2–64" inputMode="numeric" placeholder="none" />
          <TextField name="uncertainty.current_error_m_s" label="Error" unit="m/s" inputMode="decimal" />
        </div>
        <div class="field-pair">
          <TextField name="uncertainty.length_scale_m" label="Alike over" unit="km" inputMode="decimal" />
          <TextField name="uncertainty.time_scale_s" label="and over" unit="h" inputMode="decimal" />
        </div>
      </Part>
      <Part title="Advanced" fields={['name', 'method', 'sectors', 'spacing_m', 'max_waypoints', 'max_leg_m', 'refine', 'steady']}>
        <TextField name="name" label="Name of the plan" placeholder="optional" />
        <div class="field-pair">
          <SelectField name="method" label="Method" choices={methods} />
          <TextField name="sectors" label="Reach" unit="1–5" inputMode="numeric" />
        </div>
        <div class="field-pair">
          <TextField name="spacing_m" label="Grid spacing" unit="m" inputMode="decimal" placeholder="automatic" />
          <TextField name="max_waypoints" label="Most waypoints" inputMode="numeric" placeholder="no limit" />
        </div>
        <TextField name="max_leg_m" label="Longest leg" unit="km" inputMode="decimal" placeholder="no limit" />
        <CheckField name="refine" label="Refine the route beyond the grid" />
        <CheckField name="steady" label="Hold the currents at departure" />
      </Part>
      <Part title="Data" fields={['currents', 'bathymetry', 'ice', 'icebergs', 'coastline']}>
        <DataField kind="currents" label="Currents" />
        <DataField kind="bathymetry" label="Depths" />
        <DataField kind="ice" label="Sea ice" />
        <DataField kind="icebergs" label="Icebergs" />
        <DataField kind="coastline" label="Coastline" />
      </Part>
    </div>
  );
}

/** A part of the set-up that can be folded; says how much in it was changed. */
function Part({ title, fields, children }: { title: string; fields: Field[]; children: ComponentChildren }): VNode {
  const faulty = fields.some((field) => faults.value[field]);
  const changed = fields.filter((field) => JSON.stringify(draft.value[field]).replaceAll(' ', '') !== JSON.stringify(emptyDraft[field])).length;
  return (
    <details class="advanced" open={faulty || undefined}>
      <summary>
        {title}
        {changed > 0 && <span class="count" title={`${changed} changed`}>{changed}</span>}
      </summary>
      {children}
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
