#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::codec {

/// Inputs of the process "ingest": what to read, and what the user says about it beyond the files themselves.
struct IngestInputs {
  std::vector<std::string> uploads;  // ids; files that belong together in one request
  std::optional<std::string> name;
  std::optional<repository::DatasetKind> kind;  // empty: recognised
  std::optional<std::string> crs;               // "EPSG:4326"
  std::optional<std::string> positive;          // "up" or "down"
  std::optional<std::string> variable;
  std::optional<double> missing;      // marks missing values beside what the files declare
  std::optional<core::UtcTime> time;  // for which an ice chart holds that does not say it
  std::optional<geo::LonLat> at;
  std::optional<std::string> unit;       // as of ingest::IngestOptions
  std::optional<std::string> zone_kind;  // "no_go" or "stay_in"
};

/// Errors   every violation, with its JSON pointer
[[nodiscard]] tl::expected<IngestInputs, core::Violations> parse_ingest_inputs(const nlohmann::json& inputs);
[[nodiscard]] nlohmann::json to_json(const IngestInputs& inputs);

}  // namespace floeplan::codec
