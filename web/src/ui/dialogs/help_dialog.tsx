import type { VNode } from 'preact';
import { change, settings } from '../../model/settings';
import { dialog } from '../../model/screen';
import { copyLink } from '../common/copy_link';
import { Icon } from '../common/icon';
import { Modal } from '../common/modal';
import { UnitSwitches } from '../common/unit_switches';

const keys: [string, string][] = [
  ['Space', 'play or pause the clock'],
  [', .', 'one hour back, on'],
  ['[ ]', 'six hours back, on'],
  ['Home End', 'start and end of the clock'],
  ['P', 'plan'],
  ['S', 'pick the start on the map'],
  ['E', 'pick the goal on the map'],
  ['Esc', 'put the tool away'],
  ['Enter', 'close the area that is being drawn'],
  ['Backspace', 'take back its last corner'],
  ['Arrows', 'move the map (when it has the focus); with Shift a little'],
  ['Space', 'with a tool: set the place or corner under the cross'],
  ['+ −', 'zoom'],
  ['N', 'north up, and back'],
  ['F', 'fit the selected plan'],
  ['D', 'edit a copy of the selected plan'],
  ['Ins Del', 'insert after, remove the waypoint'],
  ['Ctrl+Z', 'undo the last change, whatever it was; with Shift redo'],
  ['1 … 9', 'select a plan on the map'],
  ['G', 'type the start'],
  ['I', 'what is known at the middle of the map'],
  ['L', 'to the layers'],
  ['?', 'this list'],
];

/** The keys, and the settings of this browser. The bar at the top has no room for some of these on a narrow or magnified screen. */
export function HelpDialog(): VNode {
  return (
    <Modal title="Help and settings" guide="front">
      <p>
        Give a start and a goal (click or type), a departure and a vehicle, and press <b>Plan route</b>. One clock drives currents,
        icebergs and the vehicle. All times are UTC; positions are WGS84.
      </p>
      <div class="settings-row only-narrow">
        <UnitSwitches />
        <button type="button" onClick={() => { dialog.value = 'jobs'; }}><Icon name="list" /> Jobs</button>
        <button type="button" onClick={() => void copyLink()}><Icon name="share" /> Copy a link to this view</button>
      </div>
      <dl class="keys">
        {keys.map(([key, text]) => (
          <div key={key}>
            <dt>{key.split(' ').map((one) => <kbd key={one}>{one}</kbd>)}</dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
      <label class="check">
        <input type="checkbox" checked={settings.value.shortcuts} onChange={(event) => change({ shortcuts: event.currentTarget.checked })} />
        Single keys act as shortcuts
      </label>
      <label class="check">
        <input
          type="checkbox" checked={settings.value.coordinates === 'decimal'}
          onChange={(event) => change({ coordinates: event.currentTarget.checked ? 'decimal' : 'dm' })}
        />
        Write positions in decimal degrees
      </label>
      <p class="hint">Not for navigation. Model output and satellite positions are uncertain: check every mission before it flies.</p>
    </Modal>
  );
}
