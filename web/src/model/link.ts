import type { Position } from '../contract/data_types';
import { projectionCodes, type ProjectionCode } from '../geo/projections';
import { isoOf } from './time';

/** The content of an address, with which another user opens the same view. */
export interface Link {
  projection?: ProjectionCode;
  centre?: Position;
  metresPerPixel?: number;
  time_ms?: number;
  hidden?: string[]; // layers
  plans?: string[]; // ids, in the order of their letters
  selected?: string;
}

/** The part of the address after the #. */
export function written({ projection, centre, metresPerPixel, time_ms, hidden, plans, selected }: Link): string {
  const parts = new URLSearchParams();
  if (projection) parts.set('crs', projection.replace('EPSG:', ''));
  if (centre && metresPerPixel !== undefined) {
    parts.set('at', `${centre[1].toFixed(4)},${centre[0].toFixed(4)},${metresPerPixel.toPrecision(4)}`);
  }
  if (time_ms !== undefined) parts.set('time', isoOf(time_ms));
  if (hidden && hidden.length > 0) parts.set('hide', hidden.join(','));
  if (plans && plans.length > 0) parts.set('plans', plans.join(','));
  if (selected) parts.set('plan', selected);
  return parts.toString().replaceAll('%2C', ',').replaceAll('%3A', ':');
}

/** The readable parts of an address; the others are ignored. */
export function readLink(hash: string): Link {
  const parts = new URLSearchParams(hash.replace(/^#/, ''));
  const list = (name: string): string[] | undefined => parts.get(name)?.split(',').filter((word) => /^[\w-]{1,64}$/.test(word));
  const link: Link = {};
  const code = projectionCodes.find((known) => known === `EPSG:${parts.get('crs') ?? ''}`);
  if (code) link.projection = code;
  const [lat = NaN, lon = NaN, scale = NaN] = (parts.get('at') ?? '').split(',').map((word) => (word === '' ? NaN : Number(word)));
  if (Math.abs(lat) <= 90 && Math.abs(lon) <= 180 && scale >= 0.5 && scale < 50_000) {
    link.centre = [lon, lat];
    link.metresPerPixel = scale;
  }
  const time_ms = Date.parse(parts.get('time') ?? '');
  if (Number.isFinite(time_ms)) link.time_ms = time_ms;
  const [hidden, plans, selected] = [list('hide'), list('plans'), list('plan')?.[0]];
  if (hidden) link.hidden = hidden;
  if (plans) link.plans = plans;
  if (selected) link.selected = selected;
  return link;
}
