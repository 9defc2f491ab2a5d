#pragma once

#include <string>

namespace floeplan::repository {

/// Goes on from a pragma; for stores that are older than currents at a model's own points.
inline const std::string before_water_levels = "; DROP TABLE water_level_station; DROP TABLE water_level";
inline const std::string before_meshes = "; DROP TABLE mesh_block; DROP TABLE mesh" + before_water_levels;

/// For stores that are older than the polygons of ice charts.
inline const std::string before_ice_charts =
    before_meshes + "; DROP TABLE chart_polygon_box; DROP TABLE chart_polygon";

/// For stores that are older than the owners of plans and simulations.
inline const std::string before_owners_of_plans =
    before_ice_charts +
    "; DROP INDEX plan_by_owner; ALTER TABLE plan DROP COLUMN owner; ALTER TABLE plan DROP COLUMN "
    "stored_bytes; "
    "DROP INDEX simulation_by_owner; ALTER TABLE simulation DROP COLUMN owner; ALTER TABLE simulation DROP "
    "COLUMN "
    "stored_bytes";

/// For stores that are older than the classes of jobs, the owners of what is stored and the note of a token.
inline const std::string before_classes_of_jobs =
    "; DROP INDEX job_by_owner; ALTER TABLE job DROP COLUMN class; CREATE INDEX job_by_owner ON job (owner, "
    "started_s); DROP INDEX dataset_by_owner; ALTER TABLE dataset DROP COLUMN owner; DROP TRIGGER "
    "note_first_token; DROP TABLE first_token" +
    before_owners_of_plans;

}  // namespace floeplan::repository
