import { effect } from '@preact/signals';
import { playing, time_ms } from './clock';
import { layerNames, visible } from './layers';
import { readLink, written, type Link } from './link';
import { selectedId, shown } from './plans';
import { change, projection } from './settings';
import { view } from './view';

/** What the address asked for when the page was opened. */
export const opening: Link = readLink(location.hash);

const pause_ms = 300;
let timer: ReturnType<typeof setTimeout> | undefined;

/** Takes from the address what needs no data, and keeps the address in step with the view from then on. Call once. */
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
  // Written here without an event: what comes with one is a link that somebody has put into the address of an open page.
  addEventListener('hashchange', () => {
    if (Object.keys(readLink(location.hash)).length > 0) location.reload();
  });
}

/** The address of what is seen at this moment, which the address bar may still be waiting to show. */
export function addressOfView(): string {
  clearTimeout(timer);
  const link = linkToView();
  if (link) write(link);
  return location.href;
}

/** Nothing before the map knows what it shows. */
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
