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

/// What the columns of a table of icebergs, or the attributes of features, say of the error of their positions. Such a
/// column is told by its words, in any spelling: an error, uncertainty, accuracy or precision of a position, a location
/// or of nothing else, and a unit of length at the end ("position_error_km", "Accuracy (m)", "posErrM"). "nm" is a
/// nautical mile.
class PositionErrors {
 public:
  /// `names`  as the file has them; those `read_otherwise`, in lower case, are none of these
  explicit PositionErrors(const std::vector<std::string>& names,
                          const std::vector<std::string_view>& read_otherwise = {});

  using Text = std::function<std::string(std::size_t column)>;
  using Number = std::function<std::optional<double>(const std::string& text)>;
  /// Position error of one row: the largest that its columns state, empty if none does; or why one of them is no
  /// length.
  [[nodiscard]] Checked<std::optional<core::Metres>> of(const Text& text, const Number& number) const;

  [[nodiscard]] bool is_read(std::size_t column) const;
  /// One for each column that speaks of an error or an accuracy and is not understood.
  [[nodiscard]] Messages warnings() const;

 private:
  struct Column {
    std::size_t index{};
    std::string name;
    double metres{1.0};  // in one of its unit
  };
  std::vector<Column> columns_;
  std::vector<std::string> not_read_;
};

/// A sighting with the error that the fields of its row state, if any.
[[nodiscard]] Checked<ocean::Iceberg> with_position_error(ocean::Iceberg iceberg,
                                                          const PositionErrors& errors,
                                                          const std::vector<std::string>& fields);

}  // namespace floeplan::ingest
