#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Points of a staggered grid: those of the first velocity component, of the second, or the cell centres.
enum class GridPoints { first_component, second_component, centres };

/// Positions of the points of a variable.
/// Shape    [row][column]
struct Positions {
  std::vector<geo::LonLat> places;
  std::size_t rows{};
  std::size_t columns{};
  bool from_plain_axes{false};  // from one-dimensional axes, whose positions may only be nominal

  [[nodiscard]] geo::LonLat at(std::size_t row, std::size_t column) const {
    return places[row * columns + column];
  }
};

/// The two horizontal dimensions of a variable, as indices among its dimensions.
struct PlaneDimensions {
  std::size_t y{};
  std::size_t x{};
};

/// The two dimensions that are neither time nor depth nor levels; nullopt if there are not two.
[[nodiscard]] std::optional<PlaneDimensions> plane_of(const NetcdfFile& file, const NetcdfVariable& variable);

/// Positions of a variable's points. First choice are two-dimensional tables of longitude and latitude: those
/// that the variable names ("coordinates"), or those over its own dimensions with the names that NEMO, ROMS,
/// MOM and POP use for these points. Otherwise axes of longitude and latitude, or a projection that the store
/// has no grid for. A table with the same value everywhere does not count: some producers leave their tables
/// empty.
/// Returns  nullopt when there are none
/// Errors   tables of more points than this program accepts, or that are damaged
[[nodiscard]] Checked<std::optional<Positions>> positions_of(const NetcdfFiles& files, const NetcdfFile& file,
                                                             const NetcdfVariable& variable,
                                                             PlaneDimensions plane, GridPoints points);

/// Positions of the cell centres of a staggered grid, from tables of their own ("lon_rho").
[[nodiscard]] Checked<std::optional<Positions>> centre_positions(const NetcdfFiles& files);

/// Whether the positions of a variable follow from two-dimensional tables, or from a projection that the
/// store has no grid for.
[[nodiscard]] bool has_positions(const NetcdfFiles& files, const NetcdfFile& file,
                                 const NetcdfVariable& variable, PlaneDimensions plane);

/// Whether a file holds tables of positions for any variable.
[[nodiscard]] bool holds_position_tables(const NetcdfFile& file);

}  // namespace floeplan::ingest
