import { computed, signal } from '@preact/signals';
import type { VNode } from 'preact';
import { time_ms } from '../../model/clock';
import { chosenBathymetry, chosenCurrents, chosenSeaIce, ofKind, vehicles } from '../../model/datasets';
import { draft } from '../../model/setup/draft';
import { openBerg } from '../../model/ice/berg_card';
import { drifts, driftsLeftOut } from '../../model/ice/drift';
import { icebergs, seaIce, seaIceFault } from '../../model/field';
import { chartInWords, drawnChart } from '../../model/ice/ice_chart';
import { choiceInWords } from '../../model/setup/iceberg_choice';
import { crowd, validity_h } from '../../model/ice/icebergs';
import { visible } from '../../model/layers';
import { selectedShown, type ShownPlan } from '../../model/plan/plans';
import { goToSeaIce, heldSeaIceStep_ms, iceEdge, nearestSeaIceStep_ms, seaIceLevels, surfacingLimit } from '../../model/ice/sea_ice';
import { probed } from '../../model/probe';
import { change, settings } from '../../model/settings';
import { shortTime } from '../../model/time';
import { gliderTracks } from '../../model/tracks';
import { speedFigure, speedUnit } from '../../model/units';
import { cardsBottom_px, expectedLegend_px, legendSize_px, view } from '../../model/view';
import { closedWaypoints, isLegBelowIce } from '../../model/ice/under_ice';
import { belowIceDash, currentLimits_m_s, depthLimits_m, palette, planColour, seaIceHatches } from '../../theme/palette';
import { useSize } from '../common/use_size';

/**
 * Folded where the map is small, until a person folds or unfolds it; what they chose is remembered. Also folded while
 * a card on the map would reach it.
 */
const roomy = window.matchMedia('(min-width: 1361px) and (min-height: 780px)');
const hasRoom = signal(roomy.matches);
roomy.addEventListener('change', ({ matches }) => {
  hasRoom.value = matches;
});
/** Distance between the legend and the lower edge of the map, as in map.css. */
const belowLegend_px = 34;

/** Height of the legend when it was last unfolded. */
const unfolded_px = signal(expectedLegend_px.height);

const isReachedByCards = computed(() => {
  const hasCards = openBerg.value !== undefined || probed.value !== undefined;
  return hasCards && cardsBottom_px.value + unfolded_px.value + belowLegend_px > (view.value?.height_px ?? Infinity);
});
const open = computed(() => (settings.value.legend ?? hasRoom.value) && !isReachedByCards.value);

const publishSize = (legend: HTMLDetailsElement | undefined): void => {
  legendSize_px.value = legend?.open ? { width: legend.offsetWidth, height: legend.offsetHeight } : { width: 0, height: 0 };
  if (legend?.open) unfolded_px.value = legend.offsetHeight;
};

/** The meaning of colours and signs, with units. */
export function Legend(): VNode | null {
  const shown = visible.value;
  const depths = shown.bathymetry && chosenBathymetry.value;
  const currents = shown.currents && chosenCurrents.value;
  const ice = shown.seaIce && chosenSeaIce.value;
  const bergs = shown.icebergs && ofKind('icebergs').length > 0;
  const tracks = shown.tracks && gliderTracks.value.length > 0;
  const chart = shown.iceChart && drawnChart.value;
  const plan = shown.plans && selectedShown.value;
  const box = useSize(publishSize);
  if (!depths && !currents && !ice && !chart && !bergs && !tracks) return null;
  return (
    <details ref={box} class="legend" open={open.value} onToggle={(event) => { if (event.currentTarget.open !== open.peek()) change({ legend: event.currentTarget.open }); }}>
      <summary>Legend</summary>
      {depths && <Depths />}
      {currents && <Currents />}
      {ice && <SeaIce />}
      {chart && <Chart chart={chart} />}
      {plan && <UnderIce shown={plan} surfacings={shown.surfacings} />}
      {bergs && <Icebergs circles={shown.keepOut} drift={shown.drift && drifts.value.length > 0} />}
      {tracks && <Tracks />}
    </details>
  );
}

function Depths(): VNode {
  const limits = [0, ...depthLimits_m];
  const vehicle = vehicles.value.find(({ name }) => name === draft.value.vehicle) ?? vehicles.value[0];
  return (
    <div class="legend-part">
      <h3>Depth <span class="unit">m</span></h3>
      <svg width="176" height="26" role="img" aria-label={`Depth tints change at ${depthLimits_m.join(', ')} metres`}>
        {palette.value.depthTints.map((colour, i) => (
          <g key={colour} transform={`translate(${i * 35})`}>
            <rect class="swatch" x="0.5" y="0.5" width="35" height="11" fill={colour} />
            <text x={i === 0 ? 0 : 0} y="23" text-anchor={i === 0 ? 'start' : 'middle'}>{limits[i]}</text>
          </g>
        ))}
      </svg>
      {vehicle && vehicle.minimum_working_depth_m > 0 && (
        <p><svg width="22" height="11" aria-hidden="true"><path class="shallow" d="M0 11 L11 0 M6 11 L17 0 M12 11 L22 1" /></svg> shallower than {vehicle.minimum_working_depth_m} m</p>
      )}
    </div>
  );
}

function Currents(): VNode {
  const [slow, fast] = currentLimits_m_s;
  const texts = [`under ${speedFigure(slow)}`, `to ${speedFigure(fast)}`, 'above'];
  return (
    <div class="legend-part">
      <h3>Current <span class="unit">{speedUnit()}</span></h3>
      <ul class="legend-arrows">
        {palette.value.currents.map((colour, i) => (
          <li key={colour}>
            <svg width="30" height="12" aria-hidden="true" focusable="false">
              <path d={`M2 6 H${14 + 6 * i} m-5 -3.5 l5 3.5 l-5 3.5`} stroke={colour} stroke-width={1.1 + 0.35 * i} fill="none" />
            </svg>
            {texts[i]}
          </li>
        ))}
      </ul>
    </div>
  );
}

function Tracks(): VNode {
  return (
    <div class="legend-part">
      <h3>Glider tracks <span class="unit">{gliderTracks.value.length}</span></h3>
      <p><svg width="22" height="14" aria-hidden="true"><path class="track" d="M1 7 H21" /></svg> with a diamond at the clock’s time</p>
      {gliderTracks.value.some(({ properties }) => properties.currents.length > 0) && <p>arrows: depth-averaged current met</p>}
    </div>
  );
}

function SeaIce(): VNode {
  const colours = palette.value.seaIce;
  const percent = (share: number): string => String(Math.round(100 * share));
  const step_ms = nearestSeaIceStep_ms.value;
  return (
    <div class="legend-part">
      <h3>Sea ice <span class="unit">% of the sea</span></h3>
      <svg width="176" height="30" role="img" aria-label={`Hatching grows denser at ${seaIceLevels.map(percent).join(', ')} percent of the sea`}>
        <defs>
          {seaIceHatches.map(({ tile_px, marks, width }, k) => (
            <pattern key={marks} id={`sea-ice-${k}`} width={tile_px} height={tile_px} patternUnits="userSpaceOnUse">
              <path d={marks} stroke={colours.hatch} stroke-width={width} stroke-linecap="round" fill="none" />
            </pattern>
          ))}
        </defs>
        {seaIceLevels.map((level, k) => (
          <g key={level}>
            <rect x={0.5 + 44 * k} y="0.5" width={175 - 44 * k} height="16" fill={colours.veil} />
            <rect x={0.5 + 44 * k} y="0.5" width={175 - 44 * k} height="16" fill={`url(#sea-ice-${k})`} />
            <text x={44 * k} y="28" text-anchor={k === 0 ? 'start' : 'middle'}>{percent(level)}</text>
          </g>
        ))}
        <rect class="swatch" x="0.5" y="0.5" width="175" height="16" fill="none" />
      </svg>
      <p><svg width="22" height="14" aria-hidden="true"><path class="surfacing-limit" d="M1 7 H21" /></svg> may surface up to {percent(surfacingLimit.value)} %</p>
      <p>
        <svg width="22" height="14" aria-hidden="true"><path class="ice-edge" d="M1 7 H21" /></svg> edge, {percent(iceEdge)} %
        <svg width="22" height="14" aria-hidden="true"><path class="no-ice-data" d="M3 4 h6 M13 10 h6" /></svg> no data
      </p>
      <p><b class="sounding">0.6</b> thickness in m; ? unknown</p>
      {heldSeaIceStep_ms.value !== undefined && <p class="caution">held as of {shortTime(heldSeaIceStep_ms.value)}</p>}
      {seaIceFault.value && (
        <p class="caution">
          {seaIceFault.value}.{' '}
          {!seaIce.value && step_ms !== undefined && step_ms !== time_ms.value && (
            <button type="button" class="link" onClick={goToSeaIce}>Go to {shortTime(step_ms)}</button>
          )}
        </p>
      )}
    </div>
  );
}

/** The signs of a plan that passes below ice. */
function UnderIce({ shown: { plan, style }, surfacings }: { shown: ShownPlan; surfacings: boolean }): VNode | null {
  const { ink, casing, start } = palette.value;
  const colour = planColour(palette.value, style);
  const isBelow = plan.waypoints.some((waypoint) => isLegBelowIce(waypoint));
  const isClosed = (closedWaypoints(plan) ?? 0) > 0;
  const planned = surfacings && (plan.surfacing?.planned.length ?? 0) > 0;
  const escapes = surfacings && (plan.surfacing?.escapes.some(({ time_s }) => time_s > 0) ?? false);
  if (!isBelow && !isClosed && !planned && !escapes) return null;
  return (
    <div class="legend-part">
      <h3>Plan below ice</h3>
      {isBelow && (
        <p>
          <svg width="22" height="14" aria-hidden="true">
            <path d="M1 7 H21" stroke={ink} stroke-width="9" stroke-dasharray="8 4" />
            <path d="M1 7 H21" stroke={casing} stroke-width="6" />
            <path d="M1 7 H21" stroke={colour} stroke-width="3" stroke-dasharray={belowIceDash.join(' ')} />
          </svg> below ice
        </p>
      )}
      {isClosed && <p><svg width="22" height="14" aria-hidden="true"><rect x="6.5" y="2.5" width="9" height="9" fill={colour} /></svg> must not surface here</p>}
      {planned && (
        <p>
          <svg width="22" height="14" aria-hidden="true">
            <circle cx="11" cy="7" r="6.5" fill={start} />
            <path d="M11 11 V4 M8 6.5 L11 3.5 L14 6.5" stroke={casing} stroke-width="1.6" fill="none" />
          </svg> planned surfacing
        </p>
      )}
      {escapes && <p><svg width="22" height="14" aria-hidden="true"><path d="M2 7 H21" stroke={start} stroke-width="2.4" stroke-dasharray="1 4" stroke-linecap="round" /></svg> escape to open water</p>}
    </div>
  );
}

function Chart({ chart }: { chart: NonNullable<typeof drawnChart.value> }): VNode {
  return (
    <div class="legend-part">
      <h3>Ice chart <span class="unit">tenths</span></h3>
      <p><svg width="22" height="14" aria-hidden="true"><path class="chart-line" d="M1 7 H21" /></svg> {chartInWords(chart)}</p>
      {!chart.isHeld && <p class="caution">too old for plans</p>}
      {!chart.complete && <p class="caution">not all of it; zoom in</p>}
    </div>
  );
}

function Icebergs({ circles, drift }: { circles: boolean; drift: boolean }): VNode {
  const margin = draft.value.margin_m;
  return (
    <div class="legend-part">
      <h3>Icebergs <span class="unit">{icebergs.value.length}</span></h3>
      {choiceInWords.value !== undefined && <p class="caution">{choiceInWords.value}</p>}
      <p><svg width="22" height="14" aria-hidden="true"><path class="berg" d="M11 1 L19 12 H3 Z" /></svg> by size; grey after {validity_h} h</p>
      {drift && <p><svg width="22" height="14" aria-hidden="true"><path class="ghost" d="M11 1 L19 12 H3 Z" /></svg> expected, in its keep-out ring</p>}
      {drift && driftsLeftOut.value > 0 && <p class="caution">not expected for {driftsLeftOut.value} more; zoom in</p>}
      {drift && drifts.value.length > crowd && <p>too many icebergs for drift lines</p>}
      {circles && (
        <>
          <p><svg width="22" height="14" aria-hidden="true"><circle class="ring" cx="11" cy="7" r="6" /></svg> hull + {margin || '0'} m margin</p>
          <p><svg width="22" height="14" aria-hidden="true"><circle class="ring dashed" cx="11" cy="7" r="6" /></svg> + position uncertainty</p>
          {icebergs.value.length > crowd && <p>no rings around small bergs</p>}
        </>
      )}
    </div>
  );
}
