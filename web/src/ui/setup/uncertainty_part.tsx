import type { VNode } from 'preact';
import { severalIn } from '../../model/setup/data_choice';
import { draft, isEnsemble } from '../../model/setup/draft';
import { SelectField, TextField } from './field';
import { Part } from './part';

/** The uncertainty of the currents, and what is optimised over their members. Members are drawn from an error model or chosen under Data. */
export function UncertaintyPart(): VNode {
  return (
    <Part title="Uncertainty of currents">
      {isEnsemble(draft.value) ? (
        <p class="hint">The members are the {severalIn(draft.value.currents)?.length} currents chosen under Data; the first is the forecast.</p>
      ) : (
        <ErrorModel />
      )}
      <div class="field-pair">
        <SelectField
          name="uncertainty.objective"
          choices={[{ value: 'first', title: 'The forecast' }, { value: 'mean', title: 'The mean' }, { value: 'quantile', title: 'A quantile' }]}
        />
        {draft.value['uncertainty.objective'] === 'quantile' && (
          <TextField name="uncertainty.quantile" />
        )}
      </div>
      <TextField name="uncertainty.arrive_before" />
    </Part>
  );
}

function ErrorModel(): VNode {
  return (
    <>
      <div class="field-pair">
        <TextField name="uncertainty.members" />
        <TextField name="uncertainty.seed" />
      </div>
      <div class="field-pair">
        <TextField name="uncertainty.length_scale_m" />
        <TextField name="uncertainty.time_scale_s" />
      </div>
      <TextField name="uncertainty.current_error_m_s" />
    </>
  );
}
