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

/// Inputs of the process "ingest": the files to read, and what the user states about them.
struct IngestInputs {
  std::vector<std::string> uploads;  // ids of uploads; files that belong together must be in one request
  std::optional<std::string> name;
  std::optional<repository::DatasetKind> kind;  // empty: recognised by content
  std::optional<std::string> crs;               // "EPSG:4326"
  std::optional<std::string> positive;          // "up" or "down"
  std::optional<std::string> variable;
  std::optional<double> missing;      // further value that marks missing values
  std::optional<core::UtcTime> time;  // valid time of an ice chart that does not state one
  std::optional<geo::LonLat> at;
  std::optional<std::string> unit;       // as in ingest::IngestOptions
  std::optional<std::string> zone_kind;  // "no_go" or "stay_in"
};

/// Errors   every violation, with its JSON pointer
[[nodiscard]] tl::expected<IngestInputs, core::Violations> parse_ingest_inputs(const nlohmann::json& inputs);
[[nodiscard]] nlohmann::json to_json(const IngestInputs& inputs);

}  // namespace floeplan::codec
