import type { VNode } from 'preact';
import { draft, type Field } from '../../model/draft';
import { SelectField, TextField } from './field';
import { Part } from './part';

const fields: Field[] = [
  'uncertainty.members', 'uncertainty.current_error_m_s', 'uncertainty.length_scale_m', 'uncertainty.time_scale_s', 'uncertainty.seed',
  'uncertainty.objective', 'uncertainty.quantile', 'uncertainty.arrive_before',
];

/** How certain the currents are, and what is optimised over the members drawn. */
export function UncertaintyPart(): VNode {
  return (
    <Part title="Uncertainty of currents" fields={fields}>
      <div class="field-pair">
        <TextField name="uncertainty.members" label="Members" unit="2–64" inputMode="numeric" placeholder="none" />
        <TextField name="uncertainty.current_error_m_s" label="Error" unit="m/s" inputMode="decimal" />
      </div>
      <div class="field-pair">
        <TextField name="uncertainty.length_scale_m" label="Alike over" unit="km" inputMode="decimal" />
        <TextField name="uncertainty.time_scale_s" label="and over" unit="h" inputMode="decimal" />
      </div>
      <div class="field-pair">
        <SelectField name="uncertainty.objective" label="Optimise its" choices={[{ value: 'mean', title: 'Mean' }, { value: 'quantile', title: 'Quantile' }]} />
        {draft.value['uncertainty.objective'] === 'quantile'
          ? <TextField name="uncertainty.quantile" label="Quantile" unit="%" inputMode="decimal" placeholder="90" />
          : <TextField name="uncertainty.seed" label="Seed" inputMode="numeric" placeholder="0" />}
      </div>
      <TextField name="uncertainty.arrive_before" label="Chance to arrive before" unit="UTC" placeholder="not asked" />
    </Part>
  );
}
