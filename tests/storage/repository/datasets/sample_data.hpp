#pragma once

#include <string>

#include "engine/ocean/ice/iceberg.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::repository {

constexpr core::UtcTime sample_time = core::from_unix_seconds(1'800'000'000.0);  // 2027-01-15T08:00:00Z
constexpr core::Seconds hour{3600.0};
constexpr core::Seconds day{86400.0};

inline Dataset sample_dataset(const std::string& id, DatasetKind kind, const geo::BoundingBox& bounds = {}) {
  return {.id = {id},
          .kind = kind,
          .name = "sample " + id,
          .variables = {"uo", "vo"},
          .bounds = bounds,
          .time_start = std::nullopt,
          .time_end = std::nullopt,
          .rows_accepted = 12,
          .rows_refused = 3,
          .warnings = {"first", "second"},
          .provenance = {.file_name = id + ".nc",
                         .file_size_bytes = 1'000'000'000'000,
                         .sha256 = "0123" + id,
                         .ingested = sample_time,
                         .tool_version = "floeplan 0.1.0"}};
}

inline ocean::Iceberg sample_berg(const std::string& id, geo::LonLat place,
                                  core::UtcTime observed = sample_time) {
  ocean::Iceberg berg;
  berg.id = id;
  berg.place = place;
  berg.observed = observed;
  return berg;
}

}  // namespace floeplan::repository
