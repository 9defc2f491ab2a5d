import type { VNode } from 'preact';
import { useState } from 'preact/hooks';
import { readAgain } from '../../actions/importing';
import type { FileReport } from '../../contract/data_types';
import { toggleCoverage, covered } from '../../model/coverage';
import { askedFor, emptyForm, ingestOptions, inWords, optionNames, optionsOf, type IngestForm, type OptionName } from '../../model/ingest_options';
import { asSentence } from '../../model/page_words';
import { Icon } from '../common/icon';

const titles = { stored: 'Stored', unchanged: 'In the store already', refused: 'Refused' } as const;
const shownAtFirst = 3;

/** The result for one kind of data in a file: every violation and warning, and questions about missing information. */
export function Report({ report, number }: { report: FileReport; number: number }): VNode {
  const { dataset_id, errors, file, kind, name, rows_accepted = 0, rows_refused = 0, status, warnings } = report;
  const isCovered = dataset_id !== null && covered.value.includes(dataset_id);
  return (
    <div class={`report ${status}`}>
      <p class="report-title"><Icon name={status === 'refused' ? 'warning' : 'database'} size={14} /> <b>{titles[status]}</b> {kind ? `${kind}: ` : ''}{name ?? file}</p>
      {kind === 'icebergs' && <p>{rows_accepted.toLocaleString('en')} accepted{rows_refused > 0 ? `, ${rows_refused.toLocaleString('en')} refused` : ''}</p>}
      <Texts texts={errors} title="What is wrong" />
      <Texts texts={warnings} title="Messages" />
      {status === 'refused' && <Options report={report} number={number} />}
      {dataset_id !== null && (
        <button type="button" class="link" aria-pressed={isCovered} onClick={() => toggleCoverage(dataset_id)}>{isCovered ? 'Hide' : 'Show'} its coverage</button>
      )}
    </div>
  );
}

function Texts({ texts, title }: { texts: string[]; title: string }): VNode | null {
  const [all, setAll] = useState(false);
  if (texts.length === 0) return null;
  const hidden = all ? 0 : Math.max(0, texts.length - shownAtFirst - 1);
  return (
    <div>
      <h3>{title} <span class="unit">{texts.length}</span></h3>
      <ul class="report-texts">{texts.slice(0, texts.length - hidden).map((text, i) => <li key={i}>{asSentence(inWords(text))}</li>)}</ul>
      {hidden > 0 && <button type="button" class="link" onClick={() => setAll(true)}>Show {hidden} more</button>}
    </div>
  );
}

/** Fields for the options that the refusal asks for, the other options folded, and the button that tries again. */
function Options({ report, number }: { report: FileReport; number: number }): VNode {
  const [form, setForm] = useState<IngestForm>(emptyForm);
  const [fault, setFault] = useState<string | undefined>(undefined);
  const asked = askedFor(report.errors);
  const others = optionNames.filter((name) => !asked.includes(name));
  const field = (name: OptionName): VNode => (
    <OptionField key={name} id={`import-${number}-${report.file}-${name}`} name={name} isAsked={asked.includes(name)} value={form[name]} onChange={(value) => setForm({ ...form, [name]: value })} />
  );
  const submit = (event: Event): void => {
    event.preventDefault();
    const stated = optionsOf(form);
    if ('fault' in stated) setFault(stated.fault);
    else void readAgain(number, report, stated.options);
  };
  return (
    <form class="import-options" onSubmit={submit} aria-label={`Options for ${report.file}`}>
      {asked.map(field)}
      <details>
        <summary>{asked.length > 0 ? 'More options' : 'Options'}</summary>
        {others.map(field)}
      </details>
      {fault && <p class="fault" role="alert">{fault}</p>}
      <button type="submit" disabled={optionNames.every((name) => form[name].trim() === '')}><Icon name="refresh" /> Read again with this</button>
    </form>
  );
}

interface OptionFieldProps {
  id: string;
  name: OptionName;
  isAsked: boolean;
  value: string;
  onChange: (value: string) => void;
}

function OptionField({ id, name, isAsked, value, onChange }: OptionFieldProps): VNode {
  const { title, choices, placeholder } = ingestOptions[name];
  return (
    <div class="field">
      <label for={id}>{title}</label>
      {choices ? (
        <select id={id} value={value} onChange={(event) => onChange(event.currentTarget.value)}>
          <option value="">{isAsked ? 'choose …' : 'as the file says'}</option>
          {choices.map(([choice, text]) => <option key={choice} value={choice}>{text}</option>)}
        </select>
      ) : (
        <input id={id} type="text" value={value} placeholder={placeholder} autocomplete="off" spellcheck={false} onInput={(event) => onChange(event.currentTarget.value)} />
      )}
    </div>
  );
}
