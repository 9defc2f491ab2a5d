import type { VNode } from 'preact';
import { draft } from '../../model/setup/draft';
import { CheckField, TextField } from './field';
import { Part } from './part';

/** The keep-out distance of icebergs, and the rules under sea ice. */
export function IcePart(): VNode {
  const passesUnder = draft.value.pass_under_icebergs;
  return (
    <Part title="Icebergs and sea ice">
      <CheckField name="icebergs_drift" />
      <div class="field-pair">
        <TextField name="max_inflation_m" />
        <TextField name="max_sighting_age_days" />
      </div>
      <TextField name="icebergs_as_of" />
      <TextField name="encounter_weight_s" />
      <CheckField name="pass_under_icebergs" />
      {passesUnder && (
        <div class="field-pair">
          <TextField name="keel_clearance_m" />
          <TextField name="draft_uncertainty" />
        </div>
      )}
      <div class="field-pair">
        <TextField name="under_ice.max_concentration_to_surface" />
        <TextField name="under_ice.max_time_without_surfacing_s" />
      </div>
      <div class="field-pair">
        <TextField name="under_ice.margin_below_ice_m" />
        <TextField name="under_ice.draft_if_unknown_m" />
      </div>
      <div class="field-pair">
        <TextField name="under_ice.surfacing_interval_s" />
        <TextField name="under_ice.dead_reckoning_share" />
      </div>
      <TextField name="under_ice.current_uncertainty_m_s" />
      <CheckField name="under_ice.escape_plan" />
    </Part>
  );
}
