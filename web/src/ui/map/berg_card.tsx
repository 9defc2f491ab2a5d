import type { VNode } from 'preact';
import { formatPosition } from '../../geo/coordinates';
import { bergHistory, bergSource, expectedNow, forecastEnd_ms, openBerg, openBergId } from '../../model/ice/berg_card';
import { allowance_m, keepOut_m, sizeTitle } from '../../model/ice/icebergs';
import { settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { depth, distance, none } from '../../model/units';
import { IconButton } from '../common/icon';

/** The iceberg chosen on the map: its sighting with its source, its history and its forecast. */
export function BergCard(): VNode | null {
  const berg = openBerg.value;
  if (!berg) return null;
  const { berg_id, observed, size, length_m, safe_length_m, draft_m, position_uncertainty_m, method } = berg.properties;
  const history = bergHistory.value;
  const expected = expectedNow.value;
  const end_ms = forecastEnd_ms.value;
  const position = (place: [number, number]): string => formatPosition(place, settings.value.coordinates);
  return (
    <section class="probe-card" aria-label={`Iceberg ${berg_id}`} aria-live="polite">
      <h3>{berg_id}</h3>
      <IconButton icon="x" label="Close the card of the iceberg" class="corner" onClick={() => { openBergId.value = undefined; }} />
      <dl>
        <dt>Seen</dt>
        <dd>
          {shortTime(Date.parse(observed))}
          <small>{position(berg.geometry.coordinates)}{position_uncertainty_m === null ? '' : `, position error ±${distance(position_uncertainty_m)}`}</small>
        </dd>
        <dt>Size</dt>
        <dd>{sizeTitle(size)}{length_m === null ? '' : `, ${distance(length_m)} long`}</dd>
        <dt>Keel</dt>
        <dd>{draft_m === null ? none : depth(draft_m)}{draft_m === null && <small>not stated</small>}</dd>
        <dt>Source</dt>
        <dd>{bergSource.value ?? none}<small>{method}</small></dd>
        <dt>History</dt>
        <dd>{history?.berg_id === berg_id ? (history.sightings === 1 ? '1 sighting' : `${history.sightings} sightings since ${shortTime(Date.parse(history.from))}`) : '…'}</dd>
        <dt>Expected now</dt>
        <dd>{expected ? position(expected.place) : none}{expected && <small>forecast error ±{distance(expected.error_m)}</small>}</dd>
        <dt>Kept clear</dt>
        <dd>
          {distance(keepOut_m(safe_length_m, position_uncertainty_m ?? 0))} <small>of the sighting, as its rings: hull, margin and position error</small>
          {expected && <>{distance(keepOut_m(safe_length_m, expected.error_m))} <small>of where it is expected, as the ring there: with the forecast error</small></>}
          <small>Errors count up to {distance(allowance_m.value)}.</small>
        </dd>
        <dt>Forecast to</dt>
        <dd>{end_ms === undefined ? none : shortTime(end_ms)}</dd>
      </dl>
    </section>
  );
}
