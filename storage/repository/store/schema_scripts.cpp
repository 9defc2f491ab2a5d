#include <array>

#include "storage/repository/store/schema.hpp"

namespace floeplan::repository {
namespace {

constexpr std::array scripts{R"sql(
CREATE TABLE dataset (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  kind TEXT NOT NULL CHECK (kind IN ('bathymetry', 'currents', 'icebergs', 'coastline')),
  name TEXT NOT NULL,
  west_deg REAL NOT NULL,
  south_deg REAL NOT NULL,
  east_deg REAL NOT NULL,
  north_deg REAL NOT NULL,
  time_start_s REAL,
  time_end_s REAL,
  rows_accepted INTEGER NOT NULL,
  rows_refused INTEGER NOT NULL,
  file_name TEXT NOT NULL,
  file_size_bytes INTEGER NOT NULL,
  sha256 TEXT NOT NULL,
  ingested_s REAL NOT NULL,
  tool_version TEXT NOT NULL
) STRICT;

CREATE TABLE dataset_text (
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  role TEXT NOT NULL CHECK (role IN ('variable', 'warning')),
  position INTEGER NOT NULL,
  text TEXT NOT NULL,
  PRIMARY KEY (dataset_row, role, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE grid (
  dataset_row INTEGER PRIMARY KEY REFERENCES dataset (row) ON DELETE CASCADE,
  frame TEXT NOT NULL,
  x_count INTEGER NOT NULL,
  y_count INTEGER NOT NULL,
  depth_count INTEGER NOT NULL,  -- 0: no depth axis
  time_count INTEGER NOT NULL,   -- 0: no time
  chunk_side INTEGER NOT NULL,   -- nodes along each side of a chunk
  x_nodes BLOB NOT NULL,
  y_nodes BLOB NOT NULL,
  depth_nodes_m BLOB,
  time_nodes_s BLOB
) STRICT;

CREATE TABLE field_chunk (
  dataset_row INTEGER NOT NULL REFERENCES grid (dataset_row) ON DELETE CASCADE,
  variable TEXT NOT NULL,
  time_index INTEGER NOT NULL,
  depth_index INTEGER NOT NULL,
  chunk_y INTEGER NOT NULL,
  chunk_x INTEGER NOT NULL,
  samples BLOB NOT NULL,
  UNIQUE (dataset_row, variable, time_index, depth_index, chunk_y, chunk_x)
) STRICT;

CREATE TABLE sighting (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  berg_id TEXT NOT NULL,
  lon_deg REAL NOT NULL,
  lat_deg REAL NOT NULL,
  observed_s REAL NOT NULL,
  size TEXT NOT NULL,
  length_m REAL,
  draft_m REAL,
  position_uncertainty_m REAL,
  shape TEXT NOT NULL,
  method TEXT NOT NULL,
  wrapped_lon_deg REAL AS (CASE WHEN lon_deg >= 180.0 THEN lon_deg - 360.0
                                WHEN lon_deg < -180.0 THEN lon_deg + 360.0
                                ELSE lon_deg END)
) STRICT;
CREATE INDEX sighting_by_berg ON sighting (dataset_row, berg_id, observed_s);
CREATE INDEX sighting_by_time ON sighting (observed_s);
CREATE VIRTUAL TABLE sighting_box USING rtree (row, west_deg, east_deg, south_deg, north_deg);
CREATE TRIGGER sighting_inserted AFTER INSERT ON sighting BEGIN
  INSERT INTO sighting_box VALUES (new.row, new.wrapped_lon_deg, new.wrapped_lon_deg, new.lat_deg, new.lat_deg);
END;
CREATE TRIGGER sighting_deleted AFTER DELETE ON sighting BEGIN
  DELETE FROM sighting_box WHERE row = old.row;
END;

CREATE TABLE land_polygon (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  rings BLOB NOT NULL
) STRICT;
CREATE INDEX land_polygon_by_dataset ON land_polygon (dataset_row);
CREATE VIRTUAL TABLE land_polygon_box USING rtree (row, west_deg, east_deg, south_deg, north_deg);
CREATE TRIGGER land_polygon_deleted AFTER DELETE ON land_polygon BEGIN
  DELETE FROM land_polygon_box WHERE row = old.row;
END;

CREATE TABLE plan (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  created_s REAL NOT NULL,
  departure_s REAL NOT NULL,
  arrival_s REAL NOT NULL,
  west_deg REAL NOT NULL,
  south_deg REAL NOT NULL,
  east_deg REAL NOT NULL,
  north_deg REAL NOT NULL,
  request_json TEXT NOT NULL,
  document_json TEXT NOT NULL
) STRICT;

CREATE TABLE job (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  process TEXT NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('accepted', 'running', 'successful', 'failed', 'dismissed')),
  stage TEXT NOT NULL,
  progress REAL NOT NULL,
  attempts INTEGER NOT NULL,
  created_s REAL NOT NULL,
  started_s REAL,
  finished_s REAL,
  updated_s REAL NOT NULL,
  message TEXT NOT NULL,
  worker TEXT,         -- who holds the lease; NULL: nobody
  lease_until_s REAL,  -- NULL: no lease
  request_json TEXT NOT NULL,
  result_json TEXT
) STRICT;
CREATE INDEX job_by_status ON job (status, row);
)sql",
                             R"sql(
-- Which kinds there are is the program's business: a list here would have to be rebuilt for each new one.
CREATE TABLE dataset_of_any_kind (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  kind TEXT NOT NULL,
  name TEXT NOT NULL,
  west_deg REAL NOT NULL,
  south_deg REAL NOT NULL,
  east_deg REAL NOT NULL,
  north_deg REAL NOT NULL,
  time_start_s REAL,
  time_end_s REAL,
  rows_accepted INTEGER NOT NULL,
  rows_refused INTEGER NOT NULL,
  file_name TEXT NOT NULL,
  file_size_bytes INTEGER NOT NULL,
  sha256 TEXT NOT NULL,
  ingested_s REAL NOT NULL,
  tool_version TEXT NOT NULL
) STRICT;
INSERT INTO dataset_of_any_kind SELECT row, id, kind, name, west_deg, south_deg, east_deg, north_deg,
  time_start_s, time_end_s, rows_accepted, rows_refused, file_name, file_size_bytes, sha256, ingested_s,
  tool_version FROM dataset;
DROP TABLE dataset;
ALTER TABLE dataset_of_any_kind RENAME TO dataset;
)sql",
                             R"sql(
CREATE TABLE tide_station (
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  position INTEGER NOT NULL,  -- in its file, from 0
  name TEXT NOT NULL,
  lon_deg REAL NOT NULL,
  lat_deg REAL NOT NULL,
  quantity TEXT NOT NULL,
  PRIMARY KEY (dataset_row, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE tide_constant (
  row INTEGER PRIMARY KEY,
  dataset_row INTEGER NOT NULL,
  position INTEGER NOT NULL,
  constituent TEXT NOT NULL,
  cosine REAL NOT NULL,  -- A cos g
  sine REAL NOT NULL,    -- -A sin g
  UNIQUE (dataset_row, position, constituent),
  FOREIGN KEY (dataset_row, position) REFERENCES tide_station (dataset_row, position) ON DELETE CASCADE
) STRICT;
)sql",
                             R"sql(
CREATE TABLE zone (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  name TEXT NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('no_go', 'stay_in')),
  from_s REAL,   -- NULL: since ever
  until_s REAL,  -- NULL: for ever
  top_m REAL NOT NULL,
  bottom_m REAL,  -- NULL: at every depth below the top
  rings BLOB NOT NULL
) STRICT;
CREATE INDEX zone_by_dataset ON zone (dataset_row);
CREATE VIRTUAL TABLE zone_box USING rtree (row, west_deg, east_deg, south_deg, north_deg);
CREATE TRIGGER zone_deleted AFTER DELETE ON zone BEGIN
  DELETE FROM zone_box WHERE row = old.row;
END;
)sql",
                             R"sql(
CREATE TABLE simulation (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  plan_id TEXT NOT NULL,  -- of a plan that may be gone
  name TEXT NOT NULL,
  created_s REAL NOT NULL,
  request_json TEXT NOT NULL,
  document_json TEXT NOT NULL
) STRICT;
CREATE INDEX simulation_by_plan ON simulation (plan_id, row);

CREATE TABLE simulation_flight (
  simulation_row INTEGER NOT NULL REFERENCES simulation (row) ON DELETE CASCADE,
  run INTEGER NOT NULL,
  document_json TEXT NOT NULL,
  PRIMARY KEY (simulation_row, run)
) STRICT;
)sql",
                             R"sql(
CREATE TABLE token (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  name TEXT NOT NULL UNIQUE,
  role TEXT NOT NULL CHECK (role IN ('viewer', 'pilot', 'admin')),
  key TEXT NOT NULL UNIQUE,  -- the part of the credential that finds the row; no secret
  digest TEXT NOT NULL,      -- SHA-256 of the secret part
  created_s REAL NOT NULL
) STRICT;

CREATE TABLE login (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  token_row INTEGER NOT NULL REFERENCES token (row) ON DELETE CASCADE,
  key TEXT NOT NULL UNIQUE,
  digest TEXT NOT NULL,
  created_s REAL NOT NULL,
  expires_s REAL NOT NULL
) STRICT;
CREATE INDEX login_by_token ON login (token_row);

CREATE TABLE audit (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  at_s REAL NOT NULL,
  caller TEXT NOT NULL,  -- name of a token that may be gone
  peer TEXT NOT NULL,
  action TEXT NOT NULL,
  target TEXT NOT NULL,
  request_id TEXT NOT NULL
) STRICT;
)sql",
                             R"sql(
ALTER TABLE job ADD COLUMN owner TEXT NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN digest TEXT;  -- of all that the result follows from; NULL: shared with nobody
ALTER TABLE job ADD COLUMN reply_json TEXT NOT NULL DEFAULT '{}';
ALTER TABLE job ADD COLUMN change INTEGER NOT NULL DEFAULT 0;  -- grows over all jobs with each thing a client sees
CREATE INDEX job_by_owner ON job (owner, started_s);
CREATE INDEX job_by_digest ON job (digest, row) WHERE digest IS NOT NULL;
CREATE INDEX job_by_change ON job (change);
CREATE TABLE job_clock (change INTEGER NOT NULL) STRICT;
INSERT INTO job_clock VALUES (0);
CREATE TRIGGER job_added AFTER INSERT ON job BEGIN
  UPDATE job_clock SET change = change + 1;
  UPDATE job SET change = (SELECT change FROM job_clock) WHERE row = new.row;
END;
CREATE TRIGGER job_changed AFTER UPDATE OF status, stage, progress ON job
WHEN old.status <> new.status OR old.stage <> new.stage OR old.progress <> new.progress BEGIN
  UPDATE job_clock SET change = change + 1;
  UPDATE job SET change = (SELECT change FROM job_clock) WHERE row = new.row;
END;

CREATE TABLE kept_answer (
  owner TEXT NOT NULL,
  key TEXT NOT NULL,
  request_sha256 TEXT NOT NULL,
  created_s REAL NOT NULL,
  job_id TEXT,   -- the answer was this job; NULL: it is in the text
  answer TEXT,
  PRIMARY KEY (owner, key)
) STRICT, WITHOUT ROWID;
CREATE INDEX kept_answer_by_age ON kept_answer (created_s);
)sql",
                             R"sql(
ALTER TABLE dataset ADD COLUMN run_s REAL;       -- when the model run began that made the data; NULL: not stated
ALTER TABLE dataset ADD COLUMN arriving_s REAL;  -- last sign of life of who copies it here; NULL: all of it is here
)sql",
                             R"sql(
CREATE TABLE glider_track (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  position INTEGER NOT NULL,  -- among the tracks of its dataset, from 0
  glider TEXT NOT NULL,
  start_s REAL NOT NULL,
  end_s REAL NOT NULL,
  deepest_m REAL,  -- NULL: no depth is known
  points INTEGER NOT NULL,
  way BLOB NOT NULL,  -- all times, longitudes, latitudes, depths (NaN: not known), fixes (1; 0: reckoned)
  UNIQUE (dataset_row, position)
) STRICT;
CREATE VIRTUAL TABLE glider_track_box USING rtree (row, west_deg, east_deg, south_deg, north_deg);
CREATE TRIGGER glider_track_deleted AFTER DELETE ON glider_track BEGIN
  DELETE FROM glider_track_box WHERE row = old.row;
END;

CREATE TABLE glider_current (
  row INTEGER PRIMARY KEY,
  dataset_row INTEGER NOT NULL,
  position INTEGER NOT NULL,  -- of its track
  time_s REAL NOT NULL,
  lon_deg REAL NOT NULL,
  lat_deg REAL NOT NULL,
  east_m_s REAL NOT NULL,
  north_m_s REAL NOT NULL,
  FOREIGN KEY (dataset_row, position) REFERENCES glider_track (dataset_row, position) ON DELETE CASCADE
) STRICT;
CREATE INDEX glider_current_by_track ON glider_current (dataset_row, position, time_s);
)sql",
                             R"sql(
-- The samples of field_chunk may be counts of steps from here on; a program that does not know it must not open the store.
)sql",
                             R"sql(
ALTER TABLE dataset ADD COLUMN outdated INTEGER NOT NULL DEFAULT 0;  -- 1: misread; the same file, given again, replaces it

-- In which frame the currents of a track are, and from which axes they were turned. NULL: not turned.
ALTER TABLE glider_track ADD COLUMN frame TEXT NOT NULL DEFAULT 'stated';
ALTER TABLE glider_track ADD COLUMN variation_source TEXT;
ALTER TABLE glider_track ADD COLUMN variation_west_rad REAL;
ALTER TABLE glider_track ADD COLUMN utm_zone INTEGER;

-- Currents from logs of Slocums were stored in the vehicle's own axes until here.
UPDATE glider_track SET frame = 'vehicle' WHERE dataset_row IN (
  SELECT dataset_row FROM dataset_text WHERE role = 'variable' AND text = 'm_present_time');
UPDATE dataset SET outdated = 1 WHERE row IN (
  SELECT glider_current.dataset_row FROM glider_current JOIN glider_track USING (dataset_row, position)
  WHERE frame = 'vehicle');
INSERT INTO dataset_text (dataset_row, role, position, text)
  SELECT row, 'warning',
    (SELECT count(*) FROM dataset_text WHERE dataset_row = dataset.row AND role = 'warning'),
    'the depth-averaged currents are in the vehicle''s own axes, not true east and north; in Greenland''s waters they '
    || 'point about 30 degrees off; ingest the same files again to turn them'
  FROM dataset WHERE outdated = 1;
)sql",
                             R"sql(
-- Pages end with checksums from here on; a program that does not write them must not open the store.
)sql",
                             R"sql(
ALTER TABLE job ADD COLUMN class TEXT NOT NULL DEFAULT 'interactive' CHECK (class IN ('interactive', 'batch', 'ingest'));
UPDATE job SET class = 'ingest' WHERE process = 'ingest';
UPDATE job SET class = 'batch' WHERE process IN ('simulate-plan', 'fly-scenario');
DROP INDEX job_by_owner;
CREATE INDEX job_by_owner ON job (owner, class, started_s);

ALTER TABLE dataset ADD COLUMN owner TEXT;  -- who sent its file over HTTP; '': the user of an open server; NULL: no request
CREATE INDEX dataset_by_owner ON dataset (owner) WHERE owner IS NOT NULL;
)sql",
                             R"sql(
-- Holds a row once there has been a token. It is never deleted: with the last token the doors must not open again.
CREATE TABLE first_token (row INTEGER PRIMARY KEY CHECK (row = 1), created_s REAL NOT NULL) STRICT;
CREATE TRIGGER note_first_token AFTER INSERT ON token BEGIN
  INSERT OR IGNORE INTO first_token (row, created_s) VALUES (1, NEW.created_s);
END;
INSERT INTO first_token (row, created_s) SELECT 1, min(created_s) FROM token HAVING count(*) > 0;
-- Tokens that were revoked before this schema are known by what was done with them.
INSERT OR IGNORE INTO first_token (row, created_s)
  SELECT 1, min(at_s) FROM audit WHERE caller NOT IN ('local', '') HAVING count(*) > 0;
)sql",
                             R"sql(
ALTER TABLE plan ADD COLUMN owner TEXT;  -- whose request made it; as of a dataset
ALTER TABLE plan ADD COLUMN stored_bytes INTEGER NOT NULL DEFAULT 0;  -- counted for its owner; of older ones not known
CREATE INDEX plan_by_owner ON plan (owner, stored_bytes) WHERE owner IS NOT NULL;
ALTER TABLE simulation ADD COLUMN owner TEXT;
ALTER TABLE simulation ADD COLUMN stored_bytes INTEGER NOT NULL DEFAULT 0;  -- with the flights that are kept whole
CREATE INDEX simulation_by_owner ON simulation (owner, stored_bytes) WHERE owner IS NOT NULL;
)sql",
                             R"sql(
CREATE TABLE chart_polygon (  -- of an ice chart, whose grid is what plans obey
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  codes TEXT NOT NULL,  -- as the chart has them, "CT=91 CA=60 SA=87 ..."
  rings BLOB NOT NULL
) STRICT;
CREATE INDEX chart_polygon_by_dataset ON chart_polygon (dataset_row);
CREATE VIRTUAL TABLE chart_polygon_box USING rtree (row, west_deg, east_deg, south_deg, north_deg);
CREATE TRIGGER chart_polygon_deleted AFTER DELETE ON chart_polygon BEGIN
  DELETE FROM chart_polygon_box WHERE row = old.row;
END;
)sql",
                             R"sql(
CREATE TABLE mesh (  -- of a field whose samples are kept at a model's own points; its grid is where they are used
  dataset_row INTEGER PRIMARY KEY REFERENCES grid (dataset_row) ON DELETE CASCADE,
  point_count INTEGER NOT NULL,
  in_faces INTEGER NOT NULL,    -- 1: the values are those of faces, each cut into cells round its middle
  level_count INTEGER NOT NULL  -- that follow the sea bed, their depths beside the samples; 0: the depths of the grid
) STRICT;

CREATE TABLE mesh_block (
  dataset_row INTEGER NOT NULL REFERENCES grid (dataset_row) ON DELETE CASCADE,
  block INTEGER NOT NULL,  -- of points, and of the cells whose first corner is one of them
  west_deg REAL NOT NULL,  -- round the cells
  south_deg REAL NOT NULL,
  east_deg REAL NOT NULL,
  north_deg REAL NOT NULL,
  longest_side_m REAL NOT NULL,
  cell_count INTEGER NOT NULL,
  lons_deg BLOB NOT NULL,
  lats_deg BLOB NOT NULL,
  corners BLOB NOT NULL,  -- numbers of points, four for each cell
  PRIMARY KEY (dataset_row, block)
) STRICT;
)sql",
                             R"sql(
CREATE TABLE water_level (  -- heights above a datum, upwards: of a field, or of stations
  dataset_row INTEGER PRIMARY KEY REFERENCES dataset (row) ON DELETE CASCADE,
  datum TEXT NOT NULL  -- in words
) STRICT;

CREATE TABLE water_level_station (
  dataset_row INTEGER NOT NULL REFERENCES dataset (row) ON DELETE CASCADE,
  position INTEGER NOT NULL,  -- in its file, from 0
  name TEXT NOT NULL,
  lon_deg REAL NOT NULL,
  lat_deg REAL NOT NULL,
  level_count INTEGER NOT NULL,
  times_s BLOB NOT NULL,
  heights_m BLOB NOT NULL,
  PRIMARY KEY (dataset_row, position)
) STRICT;
)sql"};

}  // namespace

std::span<const char* const> schema_scripts() { return scripts; }

}  // namespace floeplan::repository
