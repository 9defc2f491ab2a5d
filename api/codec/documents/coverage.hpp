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

/// Which data answered, and at which of their places.
struct CoverageSource {
  std::string dataset_id{};  // empty: not told
  std::string dataset_name{};
  std::vector<std::string> further_ids{};  // of datasets that added steps of time, or places of a trajectory
  std::string sampling{};                  // in words; empty: at the place that was asked for
};

/// Values where and when they are. Axes that the data do not have are empty.
/// Shape  values of each parameter are [t][z][y][x], last index fastest; missing ones are empty
struct CoverageGrid {
  std::vector<double> x_deg;
  std::vector<double> y_deg;
  std::vector<double> z_m;  // positive down from the surface
  std::vector<core::UtcTime> t;
  std::vector<CoverageParameter> parameters;
  std::vector<std::vector<std::optional<double>>> values;  // in the order of the parameters
  CoverageSource source{};
};

/// Values along a way, one for each of its places.
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

/// CoverageJSON. A grid with a single place is a Point, a PointSeries (several times) or a VerticalProfile (several
/// depths). Its source is a member of our own, "source", which readers of the format pass over.
/// Source  OGC 21-069r2
[[nodiscard]] nlohmann::json coverage_json(const CoverageGrid& grid);
[[nodiscard]] nlohmann::json coverage_json(const CoverageTrajectory& trajectory);

/// Several coverages of the same parameters.
[[nodiscard]] nlohmann::json coverage_collection(std::vector<nlohmann::json> coverages);

/// The parameter as CoverageJSON and the metadata of EDR describe it.
[[nodiscard]] nlohmann::json parameter_json(const CoverageParameter& parameter);

}  // namespace floeplan::codec
