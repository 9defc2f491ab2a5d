import type { VNode } from 'preact';
import { severalIn } from '../../model/data_choice';
import { draft, isEnsemble, type Field } from '../../model/draft';
import { SelectField, TextField } from './field';
import { Part } from './part';

const fields: Field[] = [
  'uncertainty.members', 'uncertainty.current_error_m_s', 'uncertainty.length_scale_m', 'uncertainty.time_scale_s', 'uncertainty.seed',
  'uncertainty.objective', 'uncertainty.quantile', 'uncertainty.arrive_before',
];

/** How certain the currents are, and what is optimised over their members: drawn from an error model, or chosen under Data. */
export function UncertaintyPart(): VNode {
  return (
    <Part title="Uncertainty of currents" fields={fields}>
      {isEnsemble(draft.value) ? (
        <p class="hint">The members are the {severalIn(draft.value.currents)?.length} currents chosen under Data; the first is the forecast.</p>
      ) : (
        <ErrorModel />
      )}
      <div class="field-pair">
        <SelectField
          name="uncertainty.objective" label="Plan for"
          choices={[{ value: 'first', title: 'The forecast' }, { value: 'mean', title: 'The mean' }, { value: 'quantile', title: 'A quantile' }]}
        />
        {draft.value['uncertainty.objective'] === 'quantile' && (
          <TextField name="uncertainty.quantile" label="Quantile" unit="%" inputMode="decimal" placeholder="90" />
        )}
      </div>
      <TextField name="uncertainty.arrive_before" label="Chance to arrive before" unit="UTC" placeholder="not asked" />
    </Part>
  );
}

function ErrorModel(): VNode {
  return (
    <>
      <div class="field-pair">
        <TextField name="uncertainty.members" label="Members" unit="2–64" inputMode="numeric" placeholder="none" />
        <TextField name="uncertainty.seed" label="Seed" inputMode="numeric" placeholder="1" />
      </div>
      <div class="field-pair">
        <TextField name="uncertainty.length_scale_m" label="Alike over" unit="km" inputMode="decimal" />
        <TextField name="uncertainty.time_scale_s" label="and over" unit="h" inputMode="decimal" />
      </div>
      <TextField name="uncertainty.current_error_m_s" label="Error of each component" unit="m/s" inputMode="decimal" />
    </>
  );
}
