#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace floeplan::ingest {

/// A file of the S-100 family with one feature on one regular grid; tests change its members.
struct S100Sample {
  struct Value {
    std::string code;
    std::string unit;
    std::string fill;
  };
  struct Record {
    std::string time;                        // empty: none
    std::vector<std::vector<float>> values;  // by value, each [row][column]; of a station [time]
    std::map<std::string, std::string> texts{};
    std::map<std::string, double> numbers{};
    std::vector<std::string> times{};  // of a station, beside its values; empty: none
  };

  std::string product;
  std::string feature;
  std::vector<Value> values;
  std::map<std::string, double> file_numbers{{"horizontalCRS", 4326.0}};
  std::map<std::string, double> feature_numbers{
      {"dataCodingFormat", 2.0}, {"dataOffsetCode", 5.0}, {"sequencingRule.type", 1.0}};
  std::string scan_direction{"longitude,latitude"};
  double west{};
  double south{};
  double step{};
  std::size_t columns{};
  std::size_t rows{};
  std::vector<Record> records;
  double announced_records{-1.0};  // less than 0: the actual number
  int areas{1};                    // all alike
  std::map<std::string, std::string> file_texts{};
  std::vector<std::pair<double, double>>
      places{};  // longitude and latitude of values that are not on a grid; one row
  std::vector<std::array<int, 3>> triangles{};  // indices of places; empty: the file has none

  std::filesystem::path write(const std::filesystem::path& path) const;
};

/// Currents over 3 x 2 nodes off Newfoundland at two times, every value by `current(column, row, time)` in knots and
/// degrees towards.
[[nodiscard]] S100Sample s111_sample(
    const std::function<std::pair<float, float>(std::size_t, std::size_t, std::size_t)>& current);

/// Water levels over 3 x 2 nodes off Newfoundland above the lowest astronomical tide, 20 minutes apart, every value by
/// `level(column, row, time)` in metres.
[[nodiscard]] S100Sample s104_sample(
    const std::function<float(std::size_t, std::size_t, std::size_t)>& level);

/// The same levels at two fixed stations, a record for each station.
[[nodiscard]] S100Sample s104_stations();

/// Depths over 3 x 2 nodes, each with the same uncertainty.
[[nodiscard]] S100Sample s102_sample(const std::vector<float>& depths_m, float uncertainty_m);

}  // namespace floeplan::ingest
