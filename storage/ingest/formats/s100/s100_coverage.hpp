#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/hdf5/hdf5_group.hpp"
#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"

namespace floeplan::ingest {

/// Whether a file begins like a file of this S-100 product: "S-111".
[[nodiscard]] bool is_s100(std::string_view bytes, std::string_view product);

/// The product's description of one of its values.
struct S100Value {
  std::string unit;  // "metres", "knots"
  float fill;        // marks missing values; NaN: nothing marks them
};

/// Values of an S-100 product on a regular grid. Its records are sorted by name.
struct S100Coverage {
  Hdf5Group file;                           // root group, with the attributes of the whole dataset
  Hdf5Group area;                           // with the attributes of the only area
  ocean::HorizontalGrid grid;               // its nodes are the positions of the values
  std::size_t file_columns{};               // number of columns of the file's tables
  std::vector<std::size_t> columns;         // for each column of the grid its column in the tables
  std::map<std::string, S100Value> values;  // description of each value, by its name
  std::vector<Hdf5Group> records;

  /// The table of a record; checked to have the file's rows and columns and the described values.
  [[nodiscard]] Checked<Hdf5Table> table(std::size_t record) const;
  /// One value on consecutive rows of a record; NaN where it is missing.
  /// Shape  [row][column] of the grid
  [[nodiscard]] Checked<std::vector<float>> read(const Hdf5Table& table, const std::string& value,
                                                 std::size_t first_row, std::size_t rows) const;
};

/// Values of an S-100 product at listed positions. Its records are sorted by name.
struct S100Points {
  Hdf5Group file;                   // root group, with the attributes of the whole dataset
  Hdf5Group area;                   // with the attributes of the only area
  std::vector<geo::LonLat> places;  // in the order of the tables
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of places; empty if the file has none
  std::map<std::string, S100Value> values;              // description of each value, by its name
  std::vector<Hdf5Group> records;

  /// One value of a record at all positions; NaN where it is missing.
  [[nodiscard]] Checked<std::vector<float>> read(std::size_t record, const std::string& value) const;
  /// One value of the station whose record this is, at all its times (layout `stations_one_by_one`).
  [[nodiscard]] Checked<std::vector<float>> read_station(std::size_t record, const std::string& value) const;
};

/// The arrangement of a feature's values, from its dataCodingFormat. s100_coverage refuses all but a regular grid.
enum class S100Layout : std::uint8_t {
  regular_grid,
  points,               // places of their own, or a triangulated mesh; a record for each time
  stations,             // fixed stations; a record for each time
  stations_one_by_one,  // fixed stations; a record for each of them
  other
};
[[nodiscard]] Checked<S100Layout> s100_layout(const std::filesystem::path& path, const std::string& feature);

/// Opens the only area of a feature on an ungeorectified grid (dataCodingFormat 3), which is a list of
/// positions without any statement which of them are neighbours, or on a triangulated mesh (7), which may also
/// have triangles, or at fixed stations (1 and 8).
/// Errors   several areas; positions that are not longitudes and latitudes; triangles with positions that do
///          not exist; damage
/// Source   IHO S-100 edition 5.2.0, part 10c: tables 10c-6, 10c-12 and 10c-16
[[nodiscard]] Checked<S100Points> s100_points(const std::filesystem::path& path, const std::string& feature);

/// A time in the notation of S-100, "20260111T002000Z", or in ISO 8601 with separators.
[[nodiscard]] std::optional<core::UtcTime> s100_time(std::string text);
/// Times of records in ascending order, and the index of the record for each.
/// Errors  a record without a time, or two with the same
[[nodiscard]] Checked<AxisNodes> s100_times(const std::vector<Hdf5Group>& records);

/// Opens the only area of a feature ("SurfaceCurrent"). Call check_hdf5_references on the file first.
/// Errors   several areas; values at stations, on meshes or on grids that are not regular; a scanning order other than
///          rows from south to north; a reference system that the engine cannot use; damage
/// Source   IHO S-100 edition 5.2.0, part 10c: tables 10c-6 to 10c-12; the name horizontalDatumValue for the
///          reference system is from edition 4
[[nodiscard]] Checked<S100Coverage> s100_coverage(const std::filesystem::path& path,
                                                  const std::string& feature);

}  // namespace floeplan::ingest
