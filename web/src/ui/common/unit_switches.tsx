import type { VNode } from 'preact';
import { change, settings } from '../../model/settings';

/** Choices of the units of distances and speeds. */
export function UnitSwitches(): VNode {
  const { distance, speed } = settings.value;
  return (
    <>
      <Switch label="Distances" now={distance} choices={[['km', 'km'], ['nm', 'NM']]} choose={(unit) => change({ distance: unit })} />
      <Switch label="Speeds" now={speed} choices={[['m/s', 'm/s'], ['kn', 'kn']]} choose={(unit) => change({ speed: unit })} />
    </>
  );
}

function Switch<T extends string>({ label, now, choices, choose }: { label: string; now: T; choices: [T, string][]; choose: (value: T) => void }): VNode {
  return (
    <div class="switch" role="group" aria-label={label}>
      {choices.map(([value, title]) => (
        <button type="button" key={value} aria-pressed={now === value} onClick={() => choose(value)}>{title}</button>
      ))}
    </div>
  );
}
