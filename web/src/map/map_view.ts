import { batch, effect, signal, untracked } from '@preact/signals';
import Map from 'ol/Map.js';
import type MapBrowserEvent from 'ol/MapBrowserEvent.js';
import View from 'ol/View.js';
import type BaseLayer from 'ol/layer/Base.js';
import type VectorLayer from 'ol/layer/Vector.js';
import { noModifierKeys, shiftKeyOnly } from 'ol/events/condition.js';
import { boundingExtent } from 'ol/extent.js';
import type VectorSource from 'ol/source/Vector.js';
import { DoubleClickZoom, DragPan, DragRotate, DragZoom, KeyboardPan, MouseWheelZoom, PinchZoom } from 'ol/interaction.js';
import type { Box, GliderTrackFeature, IcebergFeature, Position } from '../contract/data_types';
import { boxAround } from '../geo/boxes';
import { densify } from '../geo/geodesic';
import { northAngle, project, projections, scaleFactor, unproject, type ProjectionCode } from '../geo/projections';
import { openBergId } from '../model/ice/berg_card';
import { coveredDatasets } from '../model/coverage';
import { datasets, homeBox } from '../model/datasets';
import { draft } from '../model/setup/draft';
import { drifts } from '../model/ice/drift';
import { safePlaces } from '../model/plan/export_options';
import { coast, currents, icebergs, isLoading, seaIce } from '../model/field';
import { drawnChart } from '../model/ice/ice_chart';
import { zones } from '../model/hand_made';
import { areasOfPlanAlone } from '../model/plan/plan_areas';
import { takePlace } from '../model/placing';
import { select, selectedWaypoint, shownPlans } from '../model/plan/plans';
import { reach } from '../model/reach';
import { openEdit } from '../model/plan/route_edit';
import { change, projection } from '../model/settings';
import { announce } from '../model/screen';
import { opening } from '../model/shared_view';
import { shownFlight } from '../model/plan/simulations';
import { visible } from '../model/layers';
import { gliderTracks, hoveredTrack } from '../model/tracks';
import { command, expectedLegend_px, hoveredBerg, legendSize_px, pointer, tool, view, type Command } from '../model/view';
import { areaLayer } from './area_layer';
import { bathymetryLayer } from './bathymetry_layer';
import { coastLayer } from './coast_layer';
import { coverageLayer } from './coverage_layer';
import { currentsLayer } from './currents_layer';
import { driftLayer, ghostLayer } from './drift_layer';
import { editLayer } from './edit_layer';
import { flightLayer, flownVehicleLayer } from './flight_layer';
import { trackLayer, trackedGliderLayer } from './track_layer';
import { graticuleLayer } from './graticule_layer';
import { iceChartLayer } from './ice_chart_layer';
import { icebergLayer, keepOutLayer } from './iceberg_layer';
import { markerLayer } from './marker_layer';
import { planLayer, vehicleLayer, waypointLayer } from './plan_layer';
import { reachLayer } from './reach_layer';
import { seaIceLayer } from './sea_ice_layer';
import { escapeLayer, surfacingLayer } from './surfacing_layer';
import { registerProjections, toMap, viewExtent } from './projections';

/** Whether the map has moved to the data it opens on. */
const opened = signal(false);

const hitTolerance_px = 14;
const animation_ms = 250;

/** Step of an arrow key with Shift, small enough to bring a place to the middle. */
const fineStep_px = 8;

/**
 * Creates the map in `target` and connects it with the model. `probe` is called with the place where the probe tool is
 * used.
 */
export function createMap(target: HTMLElement, probe: (place: Position) => void): void {
  registerProjections();
  const bergs = icebergLayer();
  const route = editLayer();
  const areas = areaLayer();
  const vehicles = vehicleLayer();
  const flown = flownVehicleLayer();
  const waypoints = waypointLayer();
  const map = new Map({
    target,
    controls: [],
    interactions: [
      new DragRotate(), new DoubleClickZoom(), new DragPan({ condition: (event) => noModifierKeys(event) }), new DragZoom(),
      new PinchZoom(), new MouseWheelZoom(),
      new KeyboardPan({ condition: (event) => noModifierKeys(event) && !holdsWaypoint() }),
      new KeyboardPan({ condition: (event) => shiftKeyOnly(event) && !holdsWaypoint(), pixelDelta: fineStep_px }), route.drag, areas.draw,
    ],
    layers: Object.entries({
      bathymetry: bathymetryLayer(), seaIce: seaIceLayer(), iceChart: iceChartLayer(), currents: currentsLayer(), coast: coastLayer(), graticule: graticuleLayer(), coverage: coverageLayer(),
      reach: reachLayer(), areas: areas.layer, keepOut: keepOutLayer(), drift: driftLayer(), ghosts: ghostLayer(), tracks: trackLayer(),
      plans: planLayer(), flight: flightLayer(), icebergs: bergs, escapes: escapeLayer(), surfacings: surfacingLayer(), waypoints, trackedGliders: trackedGliderLayer(),
      vehicles, flown, edit: route.layer, markers: markerLayer(),
    }).map(([name, layer]) => {
      layer.set('name', name);
      return layer;
    }),
  });
  followProjection(map);
  followCommands(map);
  map.on('moveend', () => publishView(map, target));
  map.on('change:size', () => publishView(map, target));
  followPointer(map, target, bergs, probe);
  publishState(map, target, [vehicles, flown], waypoints);
}

/** Whether arrow keys move a waypoint instead of the map. */
const holdsWaypoint = (): boolean => openEdit.peek() !== undefined && selectedWaypoint.peek() !== undefined && tool.peek() === 'pan';

const reducedMotion = (): boolean => window.matchMedia('(prefers-reduced-motion: reduce)').matches;
const duration = (): number => (reducedMotion() ? 0 : animation_ms);

/**
 * Creates a new view when the projection changes, with the same centre and true scale. The first view shows the home
 * box.
 */
function followProjection(map: Map): void {
  effect(() => {
    const code = projection.value;
    untracked(() => {
      const old = map.getView();
      const oldCode = old.getProjection().getCode() as ProjectionCode;
      const next = new View({
        projection: code, extent: viewExtent(code), constrainOnlyCenter: true, minResolution: 1, maxResolution: 16_000,
        center: [0, 0], resolution: 4000,
      });
      const centre = old.getCenter();
      const resolution = old.getResolution();
      const carried = view.peek() !== undefined && centre && resolution !== undefined && oldCode in projections;
      map.setView(next);
      if (!carried) return;
      const place = unproject(oldCode, [centre[0] ?? 0, centre[1] ?? 0]);
      next.setCenter(project(code, place));
      next.setResolution((resolution / scaleFactor(oldCode, place)) * scaleFactor(code, place));
    });
  });

  effect(() => {
    const box = homeBox.value;
    if (opened.value || datasets.value === undefined) return;
    untracked(() => {
      const { centre, metresPerPixel } = opening;
      if (centre && metresPerPixel !== undefined) {
        const code = projection.peek();
        map.getView().setCenter(project(code, centre));
        map.getView().setResolution(metresPerPixel * scaleFactor(code, centre));
      } else fit(map, cornersOf(box), 0);
      map.renderSync();
      opened.value = true;
    });
  });
}

/** Places along the border of a box, dense enough that a border that is curved in the projection also fits into the view. */
function cornersOf([west, south, east, north]: Box): Position[] {
  const width = east >= west ? east - west : east - west + 360;
  const places: Position[] = [];
  for (let i = 0; i <= 8; ++i) {
    for (let j = 0; j <= 8; ++j) places.push([west + (width * i) / 8, south + ((north - south) * j) / 8]);
  }
  return places;
}

/**
 * Width of the screen elements over the map's edges, clockwise from the top: tools on the left, and an unfolded legend
 * at the lower right. Fitted places lie beside the legend or above it, where there is more room.
 */
function coveredEdges_px(map: Map): [number, number, number, number] {
  const [width = 0, height = 0] = map.getSize() ?? [];
  const [top, right, bottom, left] = width > 600 ? [70, 60, 80, 100] : [70, 20, 60, 60];
  const legend = legendSize_px.peek() ?? (width > 600 ? expectedLegend_px : { width: 0, height: 0 });
  if (legend.width === 0) return [top, right, bottom, left];
  const beside_px = legend.width + 54; // with the name of the goal
  const below_px = legend.height + 54;
  const isBeside = (width - left - beside_px) * (height - top - bottom) >= (width - left - right) * (height - top - below_px);
  return isBeside ? [top, beside_px, bottom, left] : [top, right, below_px, left];
}

/** Southern limit for fitting the map: in a polar projection shapes are too distorted further south. */
const southEnd_deg = (code: ProjectionCode): number => (projections[code].polar ? 40 : -84);

/** Changes to Mercator if the places lie outside of the polar projections. Returns whether it changed. */
function leavesPolesFor(places: Position[]): boolean {
  const end_deg = southEnd_deg(projection.peek());
  if (!projections[projection.peek()].polar || places.length === 0 || places.some(([, lat]) => lat >= end_deg)) return false;
  change({ projection: 'EPSG:3857' });
  announce(`That lies south of ${end_deg}° N, where the polar projections end: the map changed to Mercator.`);
  return true;
}

function fit(map: Map, places: Position[], time_ms: number): void {
  if (places.length === 0) return;
  const code = projection.peek();
  const south_deg = southEnd_deg(code);
  const drawn = toMap(code, places.map(([lon, lat]) => [lon, Math.max(lat, south_deg)]));
  map.getView().fit(boundingExtent(drawn), { padding: coveredEdges_px(map), minResolution: 15, duration: time_ms });
}

function followCommands(map: Map): void {
  effect(() => {
    const wish = command.value;
    if (wish) untracked(() => carryOut(map, wish));
  });
}

function carryOut(map: Map, wish: Command): void {
  const places = wish.do === 'fit' ? wish.places : wish.do === 'centre' ? [wish.place] : [];
  if (leavesPolesFor(places)) {
    queueMicrotask(() => carryOut(map, wish)); // after the view of the new projection exists
    return;
  }
  const current = map.getView();
  switch (wish.do) {
    case 'fit':
      fit(map, densify(wish.places, 20_000), duration());
      return;
    case 'centre':
      current.animate({ center: project(projection.peek(), wish.place), duration: duration() });
      return;
    case 'zoom':
      current.animate({ zoom: (current.getZoom() ?? 0) + wish.by, duration: duration() });
      return;
    case 'north': {
      const [x = 0, y = 0] = current.getCenter() ?? [];
      const north = northAngle(projection.peek(), unproject(projection.peek(), [x, y]));
      const upright = north - Math.PI / 2;
      const isUp = Math.abs(Math.sin((current.getRotation() - upright) / 2)) < 1e-3;
      current.animate({ rotation: isUp ? 0 : upright, duration: duration() });
    }
  }
}

function publishView(map: Map, target: HTMLElement): void {
  const [width = 0, height = 0] = map.getSize() ?? [];
  const [x, y] = map.getView().getCenter() ?? [];
  const resolution = map.getView().getResolution();
  if (width === 0 || height === 0 || x === undefined || y === undefined || resolution === undefined) return;
  const code = projection.peek();
  const centre = unproject(code, [x, y]);
  const rotation = map.getView().getRotation();
  const up = northAngle(code, centre) - rotation;
  target.dataset['view'] = JSON.stringify({ projection: code, centre: [x, y], resolution, rotation });
  view.value = {
    box: boxInView(map, code, centre, width, height),
    centre,
    width_px: width,
    height_px: height,
    metresPerPixel: resolution / scaleFactor(code, centre),
    north_deg: 90 - (up * 180) / Math.PI,
  };
}

/** The box around everything in view, from a lattice of pixels; all the way round when the pole is among them. */
function boxInView(map: Map, code: ProjectionCode, centre: Position, width: number, height: number): Box {
  const places: Position[] = [centre];
  for (let i = 0; i <= 8; ++i) {
    for (let j = 0; j <= 8; ++j) {
      const [x = 0, y = 0] = map.getCoordinateFromPixel([(width * i) / 8, (height * j) / 8]);
      const place = unproject(code, [x, y]);
      if (Number.isFinite(place[0]) && Number.isFinite(place[1])) places.push(place);
    }
  }
  const box = boxAround(places) ?? [-180, 35, 180, 90];
  const south = Math.max(-90, box[1]);
  if (!projections[code].polar) return [box[0], south, box[2], Math.min(90, box[3])];
  const [poleX = -1, poleY = -1] = map.getPixelFromCoordinate([0, 0]);
  const poleSeen = poleX >= 0 && poleX <= width && poleY >= 0 && poleY <= height;
  return poleSeen ? [-180, Math.max(south, 35), 180, 90] : [box[0], Math.max(south, 35), box[2], box[3]];
}

function followPointer(map: Map, target: HTMLElement, bergs: BaseLayer, probe: (place: Position) => void): void {
  const placeOf = (event: MapBrowserEvent): Position => {
    const [x = 0, y = 0] = event.coordinate;
    return unproject(projection.peek(), [x, y]);
  };
  map.on('pointermove', (event) => {
    if (event.dragging) return;
    batch(() => {
      pointer.value = placeOf(event);
      const berg = map.forEachFeatureAtPixel(event.pixel, (feature) => feature.get('berg') as IcebergFeature | undefined, {
        hitTolerance: 4,
        layerFilter: (layer) => layer === bergs,
      });
      hoveredBerg.value = berg;
      hoveredTrack.value = gliderTracks.value.length > 0 && !berg
        ? map.forEachFeatureAtPixel(event.pixel, (feature) => feature.get('track') as GliderTrackFeature | undefined, { hitTolerance: 4 })
        : undefined;
    });
  });
  target.addEventListener('pointerleave', () => {
    pointer.value = undefined;
    hoveredBerg.value = undefined;
    hoveredTrack.value = undefined;
  });
  map.on('click', (event) => use(map, event, placeOf(event), probe));
  effect(() => {
    target.style.cursor = tool.value === 'pan' ? '' : 'crosshair';
  });
}

function use(map: Map, event: MapBrowserEvent, place: Position, probe: (place: Position) => void): void {
  if (tool.peek() !== 'pan') {
    takePlace(place, probe);
    return;
  }
  map.forEachFeatureAtPixel(
    event.pixel,
    (feature) => {
      const berg = feature.get('berg') as IcebergFeature | undefined;
      if (berg) {
        openBergId.value = berg.properties.berg_id;
        return true;
      }
      const handle = feature.get('handle') as number | undefined;
      if (handle !== undefined) {
        selectedWaypoint.value = handle;
        return true;
      }
      const id = feature.get('planId') as string | undefined;
      if (id === undefined) return false;
      select(id);
      selectedWaypoint.value = feature.get('waypoint') as number | undefined;
      return true;
    },
    { hitTolerance: hitTolerance_px },
  );
}

/** Publishes counts, motion and readiness as attributes of the map's element, for tests. */
function publishState(map: Map, target: HTMLElement, vehicles: VectorLayer<VectorSource>[], waypoints: VectorLayer<VectorSource>): void {
  const inDrawingOrder = map.getAllLayers().sort((a, b) => (a.getZIndex() ?? 0) - (b.getZIndex() ?? 0));
  target.dataset['layers'] = inDrawingOrder.map((layer) => layer.get('name') as string).join(' ');
  effect(() => {
    target.dataset['icebergs'] = String(icebergs.value.length);
    target.dataset['drifts'] = String(drifts.value.length);
    target.dataset['plans'] = String(shownPlans.value.length);
    target.dataset['reach'] = reach.value?.state ?? 'none';
    target.dataset['flight'] = shownFlight.value ? String(shownFlight.value.run) : 'none';
    target.dataset['coverage'] = String(coveredDatasets.value.length);
    target.dataset['safePlaces'] = String(safePlaces.value.length);
    target.dataset['areas'] = String(draft.value.areas.length);
    target.dataset['planAreas'] = String(areasOfPlanAlone.value.length);
    target.dataset['zones'] = String(zones.value.length);
    target.dataset['tracks'] = String(visible.value.tracks ? gliderTracks.value.length : 0);
    target.dataset['handles'] = String(openEdit.value?.route.length ?? 0);
    target.dataset['coast'] = String(coast.value.length);
    target.dataset['currents'] = currents.value ? 'shown' : 'none';
    target.dataset['seaIce'] = seaIce.value ? 'shown' : 'none';
    target.dataset['iceChart'] = drawnChart.value ? String(drawnChart.value.features.length) : 'none';
    target.dataset['loading'] = String(isLoading.value);
  });
  const settle = (): void => {
    target.dataset['ready'] = String(opened.value && !isLoading.value);
    target.dataset['waypoints'] = (waypoints.getSource()?.getFeatures() ?? []).map((waypoint) => waypoint.get('name') as string).join(' ');
    const drawn = vehicles.flatMap((layer) => layer.getSource()?.getFeatures() ?? []);
    target.dataset['vehicles'] = drawn.map((vehicle) => vehicle.getGeometry()?.getExtent().slice(0, 2).map(Math.round).join(',')).join(' ');
  };
  map.on('rendercomplete', settle);
  map.on('postrender', ({ frameState }) => {
    target.dataset['moving'] = String(map.getView().getAnimating() || map.getView().getInteracting());
    // If a single layer lets OpenLayers thin its labels, every layer is painted twice.
    target.dataset['passes'] = frameState?.declutter ? '2' : '1';
  });
  effect(() => {
    if (isLoading.value) settle();
    else map.render(); // the new data may not have changed anything drawn
  });
}
