#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Which points of a staggered grid are meant.
enum class GridPoints { first_component, second_component, centres };

/// Where the points of a variable lie.
/// Shape    [row][column]
struct Positions {
  std::vector<geo::LonLat> places;
  std::size_t rows{};
  std::size_t columns{};
  bool from_plain_axes{false};  // not from tables: they may be only nominal

  [[nodiscard]] geo::LonLat at(std::size_t row, std::size_t column) const {
    return places[row * columns + column];
  }
};

/// The two dimensions along which a variable's places vary.
struct PlaneDimensions {
  std::size_t y{};
  std::size_t x{};
};

/// The dimensions that are neither time nor depth nor levels; nullopt when they are not two.
[[nodiscard]] std::optional<PlaneDimensions> plane_of(const NetcdfFile& file, const NetcdfVariable& variable);

/// Positions from two-dimensional tables of longitude and latitude, which the variable names ("coordinates"), or which
/// lie on its own dimensions and are called as its points are in NEMO, ROMS, MOM and POP; else from plain axes of
/// longitude and latitude, or from a projection on which no grid of the store lies. Tables that hold one value
/// everywhere do not count: some producers leave them empty.
/// Returns  nullopt when there are none
/// Errors   tables of more points than this program accepts, or that are damaged
[[nodiscard]] Checked<std::optional<Positions>> positions_of(const NetcdfFiles& files, const NetcdfFile& file,
                                                             const NetcdfVariable& variable,
                                                             PlaneDimensions plane, GridPoints points);

/// Positions of the centres between staggered points, from tables of their own ("lon_rho").
[[nodiscard]] Checked<std::optional<Positions>> centre_positions(const NetcdfFiles& files);

/// Whether tables of two dimensions, or a projection on which no grid of the store lies, say where the variable lies.
[[nodiscard]] bool has_positions(const NetcdfFiles& files, const NetcdfFile& file,
                                 const NetcdfVariable& variable, PlaneDimensions plane);

/// Whether a file holds tables of positions at all.
[[nodiscard]] bool holds_position_tables(const NetcdfFile& file);

}  // namespace floeplan::ingest
