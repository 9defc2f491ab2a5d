import { computed } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { VNode } from 'preact';
import { plan } from '../../actions/planning';
import { time_ms } from '../../model/clock';
import { connectionFault, datasets, isEmptyStore, vehicles } from '../../model/datasets';
import { draft, edit, emptyDraft, faultyAttempts, generalFaults } from '../../model/setup/draft';
import { whyNotPlanned } from '../../model/drawing';
import { failure, running } from '../../model/job';
import { may } from '../../model/login';
import { placesOfText } from '../../model/setup/pasted_places';
import { announce } from '../../model/screen';
import { fieldOf } from '../../model/time';
import { Icon, IconButton } from '../common/icon';
import { RoleNote } from '../common/role_note';
import { UndoButtons } from '../common/undo_buttons';
import { Advanced } from './advanced';
import { AlternativesField, AlternativesHint } from './alternatives_field';
import { FailureCard } from './failure_card';
import { SelectField, TextField, type Choice } from './field';
import { GoalField } from './goal_field';
import { JobRow } from './job_row';
import { PickButton } from './pick_button';

/** The server's vehicle profiles; until they are known, the profile that was chosen on an earlier visit. */
const vehicleChoices = computed<Choice[]>(() => {
  if (vehicles.value.length > 0) return vehicles.value.map(({ name, title }) => ({ value: name, title: title || name }));
  const { vehicle } = draft.value;
  return [{ value: vehicle, title: vehicle || (connectionFault.value ? 'Not known' : 'Reading …') }];
});

const canPlan = computed(() => datasets.value !== undefined && !isEmptyStore.value && may('pilot'));

/** The request: start, goal, departure, vehicle, margin, and the button that plans. */
export function SetupPanel(): VNode {
  const form = useRef<HTMLFormElement>(null);
  const attempts = faultyAttempts.value;
  useEffect(() => {
    if (attempts > 0) form.current?.querySelector<HTMLElement>('[aria-invalid="true"]')?.focus();
  }, [attempts]);

  const submit = (event: Event): void => {
    event.preventDefault();
    void plan();
  };
  return (
    <form ref={form} class="setup" onSubmit={submit} onPaste={pastePlaces} noValidate aria-label="Set-up">
      <div class="setup-head">
        <h2>New plan</h2>
        <UndoButtons />
        <button type="button" class="link" onClick={clear}>Clear</button>
      </div>
      <TextField name="from">
        <PickButton which="from" label="Pick the start on the map" />
      </TextField>
      <GoalField />
      <div class="field-pair departure-row">
        <TextField name="depart">
          <IconButton icon="clock" label="Depart at the clock's time" onClick={() => edit({ depart: fieldOf(time_ms.value) })} />
        </TextField>
        <AlternativesField />
      </div>
      <AlternativesHint />
      <div class="field-pair wide-first">
        <SelectField name="vehicle" choices={vehicleChoices.value} />
        <TextField name="margin_m" />
      </div>
      <Advanced />
      {generalFaults.value.map((fault) => (
        <p class="fault" key={fault} role="alert">{fault}</p>
      ))}
      <RoleNote role="pilot" what="Planning" id="plan-role" />
      {whyNotPlanned.value && <p class="hint">{whyNotPlanned.value}</p>}
      {running.value ? (
        <JobRow job={running.value} />
      ) : (
        <button type="submit" class="primary" disabled={!canPlan.value} aria-describedby={may('pilot') ? undefined : 'plan-role'}>
          <Icon name="route" /> {draft.value.name ? `Plan “${draft.value.name}”` : 'Plan route'}
        </button>
      )}
      <FailureCard />
    </form>
  );
}

/** A list of positions that is pasted into start or goal fills both and the via points between. */
function pastePlaces(event: ClipboardEvent): void {
  const isOfPlaces = event.target instanceof HTMLInputElement && ['field-from', 'field-to'].includes(event.target.id);
  const places = isOfPlaces ? placesOfText(event.clipboardData?.getData('text/plain') ?? '') : undefined;
  if (!places) return;
  event.preventDefault();
  edit({ ...places, goals_file: emptyDraft.goals_file, route_name: '' });
  const between = places.via === '' ? 0 : places.via.split('\n').length;
  announce(`Start${between > 0 ? `, ${between} via point${between === 1 ? '' : 's'}` : ''} and goal were filled in from the list.`);
}

/** Resets everything except the vehicle and the departure. */
function clear(): void {
  const { vehicle, depart } = draft.value;
  edit({ ...emptyDraft, vehicle, depart });
  failure.value = undefined;
}
