import type { VNode } from 'preact';
import { settings } from '../../model/settings';
import { view } from '../../model/view';

const metresPerNauticalMile = 1852;

/** A round distance that fits into about 130 pixels at the centre of the map. */
export function ScaleBar(): VNode | null {
  const seen = view.value;
  if (!seen) return null;
  const inMiles = settings.value.distance === 'nm';
  const unit_m = inMiles ? metresPerNauticalMile : 1000;
  const most = (130 * seen.metresPerPixel) / unit_m;
  const power = 10 ** Math.floor(Math.log10(most));
  const figure = ([5, 2, 1].find((digit) => digit * power <= most) ?? 1) * power;
  const width = (figure * unit_m) / seen.metresPerPixel;
  const text = !inMiles && figure < 1 ? `${Math.round(figure * 1000)} m` : `${Number(figure.toPrecision(2))} ${inMiles ? 'NM' : 'km'}`;
  return (
    <div class="scale-bar" role="img" aria-label={`Scale: the bar is ${text} long at the centre of the map`}>
      <svg width={width + 2} height="8" aria-hidden="true" focusable="false">
        <path d={`M1 0 V6 H${width + 1} V0`} fill="none" stroke="currentColor" stroke-width="1.5" />
      </svg>
      <span>{text}</span>
    </div>
  );
}
