import { addCoordinateTransforms, addProjection, get } from 'ol/proj.js';
import Projection from 'ol/proj/Projection.js';
import type { Position } from '../contract/data_types';
import { project, projectionCodes, projections, unproject, type ProjectionCode } from '../geo/projections';

const polarExtent = [-6e6, -6e6, 6e6, 6e6];

/** Registers the polar projections with OpenLayers; call before the first view is created. */
export function registerProjections(): void {
  for (const code of projectionCodes) {
    if (!projections[code].polar || get(code)) continue;
    const projection = new Projection({ code, units: 'm', extent: polarExtent, worldExtent: [-180, 35, 180, 90] });
    addProjection(projection);
    addCoordinateTransforms(
      'EPSG:4326',
      projection,
      (lonLat) => project(code, [lonLat[0] ?? NaN, lonLat[1] ?? NaN]),
      (metres) => unproject(code, [metres[0] ?? NaN, metres[1] ?? NaN]),
    );
  }
}

/** How far the centre of a view may be moved. */
export function viewExtent(code: ProjectionCode): number[] {
  return projections[code].polar ? polarExtent : [-20037508, -9e6, 20037508, 19.9e6];
}

export const toMap = (code: ProjectionCode, places: Position[]): Position[] => places.map((place) => project(code, place));
