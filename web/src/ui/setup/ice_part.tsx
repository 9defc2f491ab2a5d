import type { VNode } from 'preact';
import { draft, type Field } from '../../model/draft';
import { CheckField, TextField } from './field';
import { Part } from './part';

const fields: Field[] = [
  'icebergs_drift', 'max_inflation_m', 'max_sighting_age_days', 'icebergs_as_of', 'encounter_weight_s', 'pass_under_icebergs',
  'keel_clearance_m', 'draft_uncertainty', 'under_ice.max_concentration_to_surface', 'under_ice.margin_below_ice_m',
  'under_ice.draft_if_unknown_m', 'under_ice.max_time_without_surfacing_s', 'under_ice.surfacing_interval_s',
  'under_ice.dead_reckoning_share', 'under_ice.current_uncertainty_m_s', 'under_ice.escape_plan',
];

/** What is kept from icebergs, and the rules under sea ice. */
export function IcePart(): VNode {
  const passesUnder = draft.value.pass_under_icebergs;
  return (
    <Part title="Ice" fields={fields}>
      <CheckField name="icebergs_drift" label="Let icebergs drift and positions age" />
      <div class="field-pair">
        <TextField name="max_inflation_m" label="Most for errors" unit="m" inputMode="decimal" placeholder="5000" />
        <TextField name="max_sighting_age_days" label="Sightings up to" unit="days" inputMode="decimal" placeholder="3" />
      </div>
      <TextField name="icebergs_as_of" label="Icebergs as known at" unit="UTC" placeholder="departure" />
      <TextField name="encounter_weight_s" label="An expected encounter counts as" unit="h" inputMode="decimal" placeholder="0" hint="Longer travel that is worth one encounter less." />
      <CheckField name="pass_under_icebergs" label="Pass under icebergs of known draft" />
      {passesUnder && (
        <div class="field-pair">
          <TextField name="keel_clearance_m" label="Below the keel" unit="m" inputMode="decimal" placeholder="20" />
          <TextField name="draft_uncertainty" label="Draft error" unit="%" inputMode="decimal" placeholder="25" />
        </div>
      )}
      <div class="field-pair">
        <TextField name="under_ice.max_concentration_to_surface" label="Surface up to" unit="% ice" inputMode="decimal" placeholder="10" />
        <TextField name="under_ice.max_time_without_surfacing_s" label="Longest below" unit="h" inputMode="decimal" placeholder="no limit" />
      </div>
      <div class="field-pair">
        <TextField name="under_ice.margin_below_ice_m" label="Below the ice" unit="m" inputMode="decimal" placeholder="10" />
        <TextField name="under_ice.draft_if_unknown_m" label="Unknown draft" unit="m" inputMode="decimal" placeholder="30" />
      </div>
      <div class="field-pair">
        <TextField name="under_ice.surfacing_interval_s" label="Surface every" unit="h" inputMode="decimal" placeholder="no need" />
        <TextField name="under_ice.dead_reckoning_share" label="Lost way" unit="%" inputMode="decimal" placeholder="6" />
      </div>
      <TextField name="under_ice.current_uncertainty_m_s" label="Current error below" unit="m/s" inputMode="decimal" placeholder="0.05" />
      <CheckField name="under_ice.escape_plan" label="A way out from every waypoint" />
    </Part>
  );
}
