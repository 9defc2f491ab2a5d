#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/hdf5/hdf5_group.hpp"

namespace floeplan::ingest {

/// Whether a file begins as one of this product of the S-100 family does: "S-111".
[[nodiscard]] bool is_s100(std::string_view bytes, std::string_view product);

/// What a product says of one of its values.
struct S100Value {
  std::string unit;  // "metres", "knots"
  float fill;        // stands where there is no value; NaN: nothing does
};

/// Values of an S-100 product on a regular grid, its records sorted by name.
struct S100Coverage {
  Hdf5Group file;                           // with what is said of the whole dataset
  ocean::HorizontalGrid grid;               // its nodes are where the values lie
  std::size_t file_columns{};               // of the tables
  std::vector<std::size_t> columns;         // of the tables, by column of the grid
  std::map<std::string, S100Value> values;  // by the name of the value
  std::vector<Hdf5Group> records;

  /// The table of a record, which has as many rows and columns as the file says, and these values.
  [[nodiscard]] Checked<Hdf5Table> table(std::size_t record) const;
  /// One value of each of a number of consecutive rows of a record; NaN where there is none.
  /// Shape  [row][column] of the grid
  [[nodiscard]] Checked<std::vector<float>> read(const Hdf5Table& table, const std::string& value,
                                                 std::size_t first_row, std::size_t rows) const;
};

/// Values of an S-100 product at places of their own, its records sorted by name.
struct S100Points {
  Hdf5Group file;                                       // with what is said of the whole dataset
  std::vector<geo::LonLat> places;                      // in the order of the tables
  std::vector<std::array<std::uint32_t, 3>> triangles;  // of places, where the file joins them; else empty
  std::map<std::string, S100Value> values;              // by the name of the value
  std::vector<Hdf5Group> records;

  /// One value of a record at all places, NaN where there is none.
  [[nodiscard]] Checked<std::vector<float>> read(std::size_t record, const std::string& value) const;
};

/// How the values of a feature lie, as its dataCodingFormat says it. What is neither is refused by s100_coverage.
enum class S100Layout : std::uint8_t { regular_grid, points, other };
[[nodiscard]] Checked<S100Layout> s100_layout(const std::filesystem::path& path, const std::string& feature);

/// Opens the one area of a feature whose values are those of an ungeorectified grid (dataCodingFormat 3), which has a
/// list of places and nothing that says which of them are neighbours, or of a triangulated mesh (7), which may have its
/// triangles beside them.
/// Errors   several areas; places that are no longitudes and latitudes; triangles of places that do not exist; damage
/// Source   IHO S-100 edition 5.2.0, part 10c: tables 10c-6, 10c-12 and 10c-16
[[nodiscard]] Checked<S100Points> s100_points(const std::filesystem::path& path, const std::string& feature);

/// Opens the one area of a feature ("SurfaceCurrent") of a file that check_hdf5_references has looked at.
/// Errors   several areas; values at stations, on meshes or on grids that are not regular; a scanning order other than
///          rows from south to north; a reference system that the engine cannot use; damage
/// Source   IHO S-100 edition 5.2.0, part 10c: tables 10c-6 to 10c-12; of edition 4 the reference system, which it calls
///          horizontalDatumValue
[[nodiscard]] Checked<S100Coverage> s100_coverage(const std::filesystem::path& path,
                                                  const std::string& feature);

}  // namespace floeplan::ingest
