import type { VNode } from 'preact';
import { hideReach, showReach } from '../../actions/reaching';
import { guidePages } from '../../model/guide_pages';
import { may } from '../../model/login';
import { reach, reachHours } from '../../model/reach';
import { GuideLink } from '../common/guide_link';
import { Icon } from '../common/icon';

/** Isochrones: where the vehicle can be after some hours. */
export function ReachPart(): VNode {
  const shown = reach.value;
  return (
    <details class="advanced">
      <summary>Reach from the start</summary>
      <div class="field">
        <label for="reach-hours">Hours after departure</label>
        <input
          id="reach-hours" type="text" value={reachHours.value} autocomplete="off"
          onInput={(event) => { reachHours.value = event.currentTarget.value; }}
        />
      </div>
      {shown?.state === 'failed' && <p class="fault" role="alert">{shown.detail}</p>}
      {shown?.state === 'ok' && (
        <ul class="reach-list" aria-label="Areas within reach">
          {shown.answer.features.map(({ properties }) => (
            <li key={properties.hours}><b>{properties.hours} h</b> {Math.round(properties.area_km2).toLocaleString('en')} km²</li>
          ))}
        </ul>
      )}
      <div class="field-row">
        <button type="button" disabled={shown?.state === 'pending' || !may('pilot')} onClick={() => void showReach()}>
          <Icon name="reach" /> {shown?.state === 'pending' ? 'Working …' : 'Draw reach'}
        </button>
        {shown && <button type="button" onClick={hideReach}>{shown.state === 'pending' ? 'Cancel' : 'Remove'}</button>}
      </div>
      <GuideLink page={guidePages.reach} />
    </details>
  );
}
