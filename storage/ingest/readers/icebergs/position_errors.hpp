#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

/// Position errors in the columns of a table of icebergs or in the attributes of features. The words of the
/// name, in any spelling, show such a column: an error, uncertainty, accuracy or precision, of a position, a
/// location or without an object, and a unit of length at the end ("position_error_km", "Accuracy (m)",
/// "posErrM"). "nm" is a nautical mile.
class PositionErrors {
 public:
  /// `names`  the names in the file; columns with a name in `read_otherwise` (lower case) are not position
  ///          errors
  explicit PositionErrors(const std::vector<std::string>& names,
                          const std::vector<std::string_view>& read_otherwise = {});

  using Text = std::function<std::string(std::size_t column)>;
  using Number = std::function<std::optional<double>(const std::string& text)>;
  /// Position error of one row: the largest that its columns state, empty if they state none; or why one of
  /// them is not a length.
  [[nodiscard]] Checked<std::optional<core::Metres>> of(const Text& text, const Number& number) const;

  [[nodiscard]] bool is_read(std::size_t column) const;
  /// A warning for each column whose name speaks of an error or an accuracy but is not understood.
  [[nodiscard]] Messages warnings() const;

 private:
  struct Column {
    std::size_t index{};
    std::string name;
    double metres{1.0};  // metres per unit
  };
  std::vector<Column> columns_;
  std::vector<std::string> not_read_;
};

/// A sighting with the position error that its row states, if any.
[[nodiscard]] Checked<ocean::Iceberg> with_position_error(ocean::Iceberg iceberg,
                                                          const PositionErrors& errors,
                                                          const std::vector<std::string>& fields);

}  // namespace floeplan::ingest
