#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// A quantity of a coverage.
struct CoverageParameter {
  std::string id;     // a CF standard name
  std::string label;  // for people
  std::string unit;   // UCUM
};

/// The data from which the values of a coverage come.
struct CoverageSource {
  std::string dataset_id{};  // empty: not stated
  std::string dataset_name{};
  std::vector<std::string> further_ids{};  // ids of datasets that added time steps, or places of a trajectory
  // where values were sampled, in words; empty: at the requested place
  std::string sampling{};
};

/// Values on a grid of positions, depths and times. Axes that the data do not have are empty.
/// Shape  values of each parameter are [t][z][y][x], last index fastest; a missing value is empty
struct CoverageGrid {
  std::vector<double> x_deg;
  std::vector<double> y_deg;
  std::vector<double> z_m;  // positive down from the surface
  std::vector<core::UtcTime> t;
  std::vector<CoverageParameter> parameters;
  // values of each parameter, in the order of the parameters
  std::vector<std::vector<std::optional<double>>> values;
  CoverageSource source{};
};

/// Values along a line, one for each of its places.
struct CoverageTrajectory {
  struct Place {
    geo::LonLat place;
    std::optional<double> z_m;
    std::optional<core::UtcTime> time;
  };
  std::vector<Place> places;
  std::vector<CoverageParameter> parameters;
  std::vector<std::vector<std::optional<double>>> values;
  CoverageSource source{};
};

/// CoverageJSON. A grid with a single place becomes a Point, a PointSeries (several times) or a
/// VerticalProfile (several depths). The source is an additional member "source", which readers of the format
/// ignore.
/// Source  OGC 21-069r2
[[nodiscard]] nlohmann::json coverage_json(const CoverageGrid& grid);
[[nodiscard]] nlohmann::json coverage_json(const CoverageTrajectory& trajectory);

/// Several coverages of the same parameters.
[[nodiscard]] nlohmann::json coverage_collection(std::vector<nlohmann::json> coverages);

/// Description of the parameter in CoverageJSON and in the metadata of EDR.
[[nodiscard]] nlohmann::json parameter_json(const CoverageParameter& parameter);

}  // namespace floeplan::codec
