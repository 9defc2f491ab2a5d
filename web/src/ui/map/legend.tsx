import { signal } from '@preact/signals';
import type { VNode } from 'preact';
import { chosenBathymetry, chosenCurrents, ofKind, vehicles } from '../../model/datasets';
import { draft } from '../../model/draft';
import { drifts } from '../../model/drift';
import { icebergs } from '../../model/field';
import { choiceInWords } from '../../model/iceberg_choice';
import { crowd, validity_h } from '../../model/icebergs';
import { visible } from '../../model/layers';
import { gliderTracks } from '../../model/tracks';
import { speedFigure, speedUnit } from '../../model/units';
import { currentLimits_m_s, depthLimits_m, palette } from '../../theme/palette';

/** Folded where the map is small, until a person unfolds it. */
const roomy = window.matchMedia('(min-width: 1100px) and (min-height: 780px)');
const open = signal(roomy.matches);
roomy.addEventListener('change', ({ matches }) => {
  open.value = matches;
});

/** What the colours and signs mean, with units. */
export function Legend(): VNode | null {
  const shown = visible.value;
  const depths = shown.bathymetry && chosenBathymetry.value;
  const currents = shown.currents && chosenCurrents.value;
  const ice = shown.icebergs && ofKind('icebergs').length > 0;
  const tracks = shown.tracks && gliderTracks.value.length > 0;
  if (!depths && !currents && !ice && !tracks) return null;
  return (
    <details class="legend" open={open.value} onToggle={(event) => { open.value = event.currentTarget.open; }}>
      <summary>Legend</summary>
      {depths && <Depths />}
      {currents && <Currents />}
      {ice && <Ice circles={shown.safety} drift={shown.drift && drifts.value.length > 0} />}
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

function Ice({ circles, drift }: { circles: boolean; drift: boolean }): VNode {
  const margin = draft.value.margin_m;
  return (
    <div class="legend-part">
      <h3>Icebergs <span class="unit">{icebergs.value.length}</span></h3>
      {choiceInWords.value !== undefined && <p class="caution">{choiceInWords.value}</p>}
      <p><svg width="22" height="14" aria-hidden="true"><path class="berg" d="M11 1 L19 12 H3 Z" /></svg> by size; grey after {validity_h} h</p>
      {drift && <p><svg width="22" height="14" aria-hidden="true"><path class="ghost" d="M11 1 L19 12 H3 Z" /></svg> expected, within the ring</p>}
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
