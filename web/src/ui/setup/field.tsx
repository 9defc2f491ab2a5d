import type { ComponentChildren, VNode } from 'preact';
import { checkPlaces, draft, edit, faults, type Draft, type Field } from '../../model/setup/draft';
import { formOf, type FormTexts } from '../../model/fields';

type TextField = { [K in Field]: Draft[K] extends string ? K : never }[Field];
type CheckFieldName = { [K in Field]: Draft[K] extends boolean ? K : never }[Field];

interface FieldProps extends Partial<FormTexts> {
  name: TextField;
  children?: ComponentChildren; // buttons beside the field
}

/** A labelled text field of the set-up, with its fault below. Texts that are not given come from the table of request fields. */
export function TextField({ name, children, ...given }: FieldProps): VNode {
  const { label, unit, placeholder, hint, inputMode } = { ...formOf(name), ...given };
  const fault = faults.value[name];
  return (
    <div class={fault ? 'field faulty' : 'field'}>
      <label for={`field-${name}`}>
        {label} {unit && <span class="unit">{unit}</span>}
      </label>
      <div class="field-row">
        <input
          id={`field-${name}`} type="text" value={draft.value[name]} placeholder={placeholder} inputMode={inputMode}
          autocomplete="off" spellcheck={false} aria-invalid={fault ? true : undefined}
          aria-describedby={fault ? `fault-${name}` : hint ? `hint-${name}` : undefined}
          onInput={(event) => edit({ [name]: event.currentTarget.value }, name)}
          onChange={() => checkPlaces(name)}
        />
        {children}
      </div>
      {hint && !fault && <p class="hint" id={`hint-${name}`}>{hint}</p>}
      <Fault name={name} />
    </div>
  );
}

export interface Choice {
  value: string;
  title: string;
}

/** `closed`: only the first choice is offered; the element with this id gives the reason. */
export function SelectField({ name, choices, closed }: { name: TextField; choices: Choice[]; closed?: string | undefined }): VNode {
  const fault = faults.value[name];
  return (
    <div class={fault ? 'field faulty' : 'field'}>
      <label for={`field-${name}`}>{formOf(name).label}</label>
      <select
        id={`field-${name}`} value={closed ? choices[0]?.value : draft.value[name]} disabled={closed !== undefined} aria-invalid={fault ? true : undefined}
        aria-describedby={fault ? `fault-${name}` : closed}
        onChange={(event) => edit({ [name]: event.currentTarget.value })}
      >
        {choices.map(({ value, title }) => (
          <option key={value} value={value}>{title}</option>
        ))}
      </select>
      <Fault name={name} />
    </div>
  );
}

export function CheckField({ name }: { name: CheckFieldName }): VNode {
  return (
    <div class="field">
      <label class="check">
        <input type="checkbox" checked={draft.value[name]} onChange={(event) => edit({ [name]: event.currentTarget.checked })} />
        {formOf(name).label}
      </label>
      <Fault name={name} />
    </div>
  );
}

function Fault({ name }: { name: Field }): VNode | null {
  const fault = faults.value[name];
  return fault ? <p class="fault" id={`fault-${name}`}>{fault}</p> : null;
}
