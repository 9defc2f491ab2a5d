/**
 * The server's documents about stored data, with the same fields. Positions are decimal degrees, longitude first; times
 * are ISO 8601 in UTC.
 */

export type Position = [lon: number, lat: number];
export type Box = [west: number, south: number, east: number, north: number];

export type DatasetKind = 'bathymetry' | 'currents' | 'ice' | 'icebergs' | 'coastline' | 'tides' | 'water-levels' | 'wind' | 'zones' | 'glider-tracks';

/** Kinds of data that plans use; water levels and glider tracks are only stored and shown. */
export type PlanningKind = Exclude<DatasetKind, 'glider-tracks' | 'water-levels'>;

export interface Dataset {
  id: string;
  kind: DatasetKind;
  name: string;
  variables: string[];
  bbox: Box;
  time_start: string | null;
  time_end: string | null;
  times?: string[];
  rows_accepted: number;
  rows_refused: number;
  warnings: string[];
  stale?: string; // what to do, if an earlier version misread or resampled it
  better_id?: string; // of the stored dataset of the same file that replaces it
  file_name: string;
  file_size_bytes: number;
  sha256: string;
  ingested: string;
  tool_version: string;
}

export interface Upload {
  id: string;
  name: string; // name on the server
  bytes: number;
  sha256: string;
  created: string;
  expires: string;
}

/** What the user states about files and the files do not. */
export interface IngestOptions {
  name?: string;
  kind?: DatasetKind;
  crs?: string;
  positive?: 'up' | 'down';
  variable?: string;
  missing?: number;
  time?: string;
  at?: Position;
  unit?: 'm' | 'cm' | 'mm' | 'ft' | 'share' | 'percent';
  zone_kind?: 'no_go' | 'stay_in';
}

export type IngestInputs = IngestOptions & { uploads: string[] };

/** The result for one kind of data in a file. */
export interface FileReport {
  file: string;
  status: 'stored' | 'refused' | 'unchanged';
  dataset_id: string | null;
  kind?: DatasetKind | null;
  name?: string | null;
  time_start?: string | null;
  time_end?: string | null;
  rows_accepted?: number;
  rows_refused?: number;
  warnings: string[];
  errors: string[];
}

export interface IngestReport {
  datasets: FileReport[];
}

export interface Vehicle {
  name: string;
  title: string;
  speed_m_s: number;
  dive_depth_m: number;
  depth_rating_m: number;
  minimum_working_depth_m: number;
  max_waypoints_per_list: number;
  pitch_deg?: number;
  climb_to_m?: number;
  altimeter_margin_m?: number;
  battery_j?: number;
  battery_start_share?: number;
  battery_reserve_share?: number;
  buoyancy_cm3?: number;
  hotel_w?: number;
  surfacing_j?: number;
  surfacing_interval_s?: number | null;
}

export interface IcebergProperties {
  berg_id: string;
  observed: string;
  size: string;
  length_m: number | null;
  safe_length_m: number;
  draft_m: number | null;
  position_uncertainty_m: number | null;
  shape: string;
  method: string;
  dataset_id: string;
}

export interface IcebergFeature {
  type: 'Feature';
  id: number | string;
  geometry: { type: 'Point'; coordinates: Position };
  properties: IcebergProperties;
}

/** The track of an iceberg that was seen more than once. */
export interface IcebergTrackFeature {
  type: 'Feature';
  id: number | string;
  properties: { berg_id: string; from: string; until: string; sightings: number; times: string[]; dataset_id: string };
}

/** The track of a glider, with its depth-averaged currents. */
export interface GliderTrackFeature {
  type: 'Feature';
  id: number | string;
  geometry: { type: 'LineString'; coordinates: number[][] } | { type: 'MultiLineString'; coordinates: number[][][] };
  properties: {
    glider: string;
    start: string;
    end: string;
    deepest_m: number | null;
    mean_east_m_s: number | null;
    mean_north_m_s: number | null;
    // vehicle: along the vehicle's own axes, so directions on the map are wrong
    current_frame: 'stated' | 'true' | 'vehicle' | null;
    times: string[];
    currents: { time: string; lon: number; lat: number; east_m_s: number; north_m_s: number }[];
    dataset_id: string;
  };
}

/** A stored zone; plans obey it wherever it meets their route. */
export interface ZoneFeature {
  type: 'Feature';
  id: number | string;
  geometry: { type: 'Polygon'; coordinates: Position[][] };
  properties: {
    kind: AreaProperties['kind'];
    name: string | null;
    from: string | null; // null: no beginning
    until: string | null; // null: no end
    top_m: number | null;
    bottom_m: number | null; // null: to the sea bed
    dataset_id: string;
  };
}

/** A feature to be stored. */
export interface NewFeature {
  type: 'Feature';
  geometry: { type: 'Point'; coordinates: Position } | { type: 'Polygon'; coordinates: Position[][] };
  properties: object;
}

/** The forecast drift of a berg, as columns that begin with its sighting. */
export interface IcebergDrift {
  berg_id: string;
  observed: string;
  safe_length_m: number;
  time: string[];
  lon: number[];
  lat: number[];
  error_m: number[];
}

/** An entry missing in a list because it is damaged in the server's store. */
export interface DamagedThing {
  type: string;
  kind: string;
  id: string | null;
  detail: string;
}

export interface StoredDatasets {
  datasets: Dataset[];
  damaged?: DamagedThing[];
}

export interface Link {
  rel: string;
  href: string;
  type?: string;
}

export interface FeaturePage<F> {
  type: 'FeatureCollection';
  features: F[];
  numberMatched?: number;
  numberReturned: number;
  links: Link[];
}

export interface CoastFeature {
  type: 'Feature';
  geometry: { type: 'Polygon'; coordinates: Position[][] } | { type: 'MultiPolygon'; coordinates: Position[][][] };
}

/** A polygon of an ice chart: its egg code, and the same in words; null where the chart leaves it open. */
export interface IceEgg {
  codes: Record<string, string>;
  total: string | null;
  parts: { concentration: string | null; stage: string | null; form: string | null }[];
}

export interface IceChart {
  dataset_id: string;
  dataset_name: string;
  time: string | null;
  complete: boolean; // false: some polygons were omitted because a picture can show only a limited number
  features: { type: 'Feature'; properties: IceEgg; geometry: { type: 'Polygon'; coordinates: Position[][] } }[];
}

export interface AreaProperties {
  kind: 'no_go' | 'stay_in';
  name?: string;
  from?: string;
  until?: string;
  top_m?: number;
  bottom_m?: number;
}

export interface Areas {
  type: 'FeatureCollection';
  features: { type: 'Feature'; properties: AreaProperties; geometry: { type: 'Polygon'; coordinates: Position[][] } }[];
}
