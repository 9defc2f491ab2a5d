import { effect } from '@preact/signals';
import { playing, time_ms } from './clock';
import { layerNames, visible } from './layers';
import { readLink, written, type Link } from './link';
import { selectedId, shown } from './plan/plans';
import { change, projection } from './settings';
import { view } from './view';

/** The view in the address of the page when it was opened. */
export const opening: Link = readLink(location.hash);

const pause_ms = 300;
let timer: ReturnType<typeof setTimeout> | undefined;

/** Applies the parts of the address that need no data. From then on the address follows the view. Call once. */
export function followAddress(): void {
  if (opening.projection) change({ projection: opening.projection });
  const hidden = opening.hidden ?? [];
  if (hidden.length > 0) {
    visible.value = { ...visible.value, ...Object.fromEntries(layerNames.filter((name) => hidden.includes(name)).map((name) => [name, false])) };
  }
  effect(() => {
    const link = linkToView();
    clearTimeout(timer);
    if (link && !playing.value) timer = setTimeout(() => write(link), pause_ms);
  });
  // The page itself changes the address without an event. An event means that somebody has put a link into the address bar.
  addEventListener('hashchange', () => {
    if (Object.keys(readLink(location.hash)).length > 0) location.reload();
  });
}

/** The address of the present view. The address bar may show it a moment later. */
export function addressOfView(): string {
  clearTimeout(timer);
  const link = linkToView();
  if (link) write(link);
  return location.href;
}

/** Empty until the map knows what it shows. */
function linkToView(): Link | undefined {
  const seen = view.value;
  const link: Link = {
    projection: projection.value, time_ms: time_ms.value, hidden: layerNames.filter((name) => !visible.value[name]), plans: shown.value,
    ...(selectedId.value ? { selected: selectedId.value } : {}),
  };
  return seen && { ...link, centre: seen.centre, metresPerPixel: seen.metresPerPixel };
}

function write(link: Link): void {
  history.replaceState(null, '', `#${written(link)}`);
}
