import { useEffect, useRef } from 'preact/hooks';
import type { VNode } from 'preact';
import { probeAt } from '../../actions/probing';
import { createMap } from '../../map/map_view';
import { isSynthetic } from '../../model/datasets';
import { drawnCorners, fewestCorners } from '../../model/drawing';
import { currentsFault, isLoading } from '../../model/field';
import { routeOf, selectedPlan } from '../../model/plan/plans';
import { ask, cardsBottom_px, noteHeight_px, tool, toolsReach_px, view } from '../../model/view';
import { IconButton } from '../common/icon';
import { UndoButtons } from '../common/undo_buttons';
import { useSize } from '../common/use_size';
import { BergCard } from './berg_card';
import { EmptyStore } from './empty_store';
import { Legend } from './legend';
import { ProbeCard } from './probe_card';
import { Readout } from './readout';
import { ScaleBar } from './scale_bar';

const map_keys =
  'Map. Arrow keys move it, with Shift a little, plus and minus zoom, N turns north up, question mark lists all keys. With a tool, Space sets the place in the middle.';

/** It has no height on a wide screen, where the note stands in the left panel. */
const publishNote = (note: HTMLParagraphElement | undefined): void => {
  noteHeight_px.value = note?.offsetHeight ?? 0;
};

const publishCards = (cards: HTMLDivElement | undefined): void => {
  cardsBottom_px.value = cards ? cards.offsetTop + cards.offsetHeight : 0;
};

/** The map and the elements on its frame. */
export function MapPanel(): VNode {
  const target = useRef<HTMLDivElement>(null);
  const note = useSize(publishNote);
  const cards = useSize(publishCards);
  useEffect(() => {
    if (target.current) createMap(target.current, (place) => void probeAt(place));
  }, []);
  return (
    <main class="map-panel" id="map-panel">
      <h2 class="visually-hidden">Map</h2>
      <div ref={target} id="map" class="map" tabIndex={0} role="application" aria-label={map_keys} />
      <Toolbar />
      {tool.value !== 'pan' && <div class="map-cross" aria-hidden="true" />}
      <Prompt />
      <div ref={cards} class="map-upper-right">
        <NorthArrow />
        <ProbeCard />
        <BergCard />
      </div>
      <Legend />
      <div class="map-lower" style={{ marginBottom: `${noteHeight_px.value}px` }}>
        <Readout />
        <ScaleBar />
      </div>
      {currentsFault.value && <p class="map-note" role="status">{currentsFault.value}</p>}
      {isLoading.value && <div class="map-loading" aria-hidden="true" />}
      <p ref={note} class="map-disclaimer">{isSynthetic.value ? 'Synthetic data. ' : ''}Not for navigation; check before flight.</p>
      <EmptyStore />
    </main>
  );
}

const publishTools = (tools: HTMLDivElement | undefined): void => {
  if (tools) toolsReach_px.value = { right: tools.offsetLeft + tools.offsetWidth, bottom: tools.offsetTop + tools.offsetHeight };
};

function Toolbar(): VNode {
  const plan = selectedPlan.value;
  const box = useSize(publishTools);
  return (
    <div ref={box} class="toolbar" role="toolbar" aria-label="Map tools" aria-orientation="vertical">
      <IconButton icon="plus" label="Zoom in (+)" onClick={() => ask({ do: 'zoom', by: 1 })} />
      <IconButton icon="minus" label="Zoom out (−)" onClick={() => ask({ do: 'zoom', by: -1 })} />
      <IconButton icon="maximize" label="Fit the selected plan (F)" disabled={!plan} onClick={() => plan && ask({ do: 'fit', places: routeOf(plan) })} />
      <span class="separator" />
      <UndoButtons />
      <span class="separator" />
      <IconButton icon="hand" label="Move and select" pressed={tool.value === 'pan'} onClick={() => { tool.value = 'pan'; }} />
      <IconButton icon="probe" label="Probe: everything known at a place" pressed={tool.value === 'probe'} onClick={() => { tool.value = tool.value === 'probe' ? 'pan' : 'probe'; }} />
    </div>
  );
}

/** The effect of a click on the map, while a tool waits for one. */
function Prompt(): VNode | null {
  const toClose = drawnCorners.value >= fewestCorners ? '; Enter, a double click or the first corner closes it' : '';
  const texts = {
    from: 'Click the map to set the start', to: 'Click the map to set the goal', probe: 'Click the map to probe a place',
    via: 'Click the map for each via point', area: `Click the corners of the area${toClose}`, zone: `Click the corners of the zone${toClose}`, berg: 'Click where the iceberg is',
    safe: 'Click open water that the glider can recover to',
  };
  if (tool.value === 'pan') return null;
  return (
    <p class="prompt" role="status">
      {texts[tool.value]} <span class="by-key">(by key: arrows move the map under the cross, with Shift a little, <kbd>Space</kbd> sets)</span> <kbd>Esc</kbd>
    </p>
  );
}

function NorthArrow(): VNode {
  const turn = view.value?.north_deg ?? 0;
  return (
    <button type="button" class="north" aria-label="Turn north up (N)" title="Turn north up (N)" onClick={() => ask({ do: 'north' })}>
      <svg width="34" height="34" viewBox="-17 -17 34 34" aria-hidden="true" focusable="false">
        <g transform={`rotate(${turn.toFixed(1)})`}>
          <path class="north-half" d="M0 -12 L5 8 L0 4 Z" />
          <path class="south-half" d="M0 -12 L-5 8 L0 4 Z" />
        </g>
      </svg>
      <span>N</span>
    </button>
  );
}
