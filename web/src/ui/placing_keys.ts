import { effect, untracked } from '@preact/signals';
import { probeAt } from '../actions/probing';
import { formatPosition } from '../geo/coordinates';
import { drawingWish, isDrawing } from '../model/drawing';
import { takePlace } from '../model/placing';
import { announce } from '../model/screen';
import { settings } from '../model/settings';
import { tool, view } from '../model/view';

const focusedMap = (): Element | null => document.querySelector('#map:focus-visible');

/** After a tool was chosen by key, moves the focus to the map. The tool then takes the place in the middle of the map. */
export function goOnByKey(event: MouseEvent): void {
  const isByKey = event.detail === 0;
  if (isByKey && tool.peek() !== 'pan') document.getElementById('map')?.focus();
}

/** Space sets the place (or corner) at the cross in the map's middle; Enter does so too unless it closes an area. */
export function placeByKey(event: KeyboardEvent): boolean {
  const place = view.peek()?.centre;
  const isKey = event.key === ' ' || (event.key === 'Enter' && !isDrawing.peek());
  if (!isKey || !place || tool.peek() === 'pan' || event.ctrlKey || event.altKey || event.metaKey || event.target !== focusedMap()) return false;
  if (isDrawing.peek()) drawingWish.value = { do: 'corner', place };
  else takePlace(place, (where) => void probeAt(where));
  return true;
}

/** Announces the position at the cross when the map stops moving. Call once. */
export function readOutCross(): void {
  effect(() => {
    const now = view.value;
    const waits = tool.value !== 'pan';
    if (now && waits && focusedMap()) announce(formatPosition(now.centre, untracked(() => settings.value.coordinates)));
  });
}
