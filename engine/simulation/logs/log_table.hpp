#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"

namespace floeplan::simulation {

/// Columns of a log as comma-separated text, or as the vendor's dbd2asc writes it, by the name of their sensor; a field
/// that is empty or no number of the sea (nan) is not there.
class LogTable {
 public:
  using Column = std::vector<std::optional<double>>;

  /// `wanted`  the sensors to keep, so that those of a wide log take no memory; empty: all
  /// Errors   lines that are no row, at most ten of them; no line of names
  [[nodiscard]] static tl::expected<LogTable, core::Violations> read(
      std::string_view text, std::span<const std::string_view> wanted = {});

  /// One whose columns were read elsewhere, all of `rows` fields.
  [[nodiscard]] static LogTable of(std::map<std::string, Column> columns,
                                   std::map<std::string, std::string> units, std::size_t rows);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool has(const std::string& name) const { return columns_.contains(name); }
  /// Errors   std::out_of_range for a column that is not there
  [[nodiscard]] const Column& operator[](const std::string& name) const { return columns_.at(name); }
  /// What stands above a column for its unit; empty: nothing does.
  [[nodiscard]] std::string unit(const std::string& name) const;
  /// Puts other values into a column, or none. Nothing for a column that is not there.
  void change(const std::string& name, const std::function<std::optional<double>(double)>& value);
  /// The last value at or before a row.
  [[nodiscard]] std::optional<double> before(const std::string& name, std::size_t row) const;

 private:
  std::map<std::string, Column> columns_;
  std::map<std::string, std::string> units_;
  std::size_t rows_{};
};

}  // namespace floeplan::simulation
