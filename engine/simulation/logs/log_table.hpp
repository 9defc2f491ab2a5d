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

/// The columns of a log by sensor name, from comma-separated text or the output of the vendor's dbd2asc. An
/// empty field or nan is an empty value.
class LogTable {
 public:
  using Column = std::vector<std::optional<double>>;

  /// `wanted`  the sensors to store, so that a wide log takes little memory; empty: all
  /// Errors   unreadable rows, at most ten of them; no line of names
  [[nodiscard]] static tl::expected<LogTable, core::Violations> read(
      std::string_view text, std::span<const std::string_view> wanted = {});

  /// A table from columns read elsewhere, each with `rows` values.
  [[nodiscard]] static LogTable of(std::map<std::string, Column> columns,
                                   std::map<std::string, std::string> units, std::size_t rows);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] bool has(const std::string& name) const { return columns_.contains(name); }
  /// Errors   std::out_of_range for a missing column
  [[nodiscard]] const Column& operator[](const std::string& name) const { return columns_.at(name); }
  /// The unit above a column; empty: none.
  [[nodiscard]] std::string unit(const std::string& name) const;
  /// Replaces the values of a column; `value` may return empty. Does nothing if the column is missing.
  void change(const std::string& name, const std::function<std::optional<double>(double)>& value);
  /// The last value at or before a row.
  [[nodiscard]] std::optional<double> before(const std::string& name, std::size_t row) const;

 private:
  std::map<std::string, Column> columns_;
  std::map<std::string, std::string> units_;
  std::size_t rows_{};
};

}  // namespace floeplan::simulation
