#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/ice/iceberg.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

inline constexpr double longest_iceberg_m = 400'000.0;  // B-15 was 295 km long
inline constexpr double deepest_iceberg_m = 1'000.0;    // the greatest draft that is accepted. Chosen
inline constexpr double least_certain_m = 1e6;          // the largest position error that is accepted. Chosen

enum class Zero : std::uint8_t { allowed, refused };

/// A length in metres from a text; empty if the text is empty; or why it is not a length. `value` is the
/// number in the text, if it is one.
[[nodiscard]] Checked<std::optional<core::Metres>> metres_of(const std::string& name, const std::string& text,
                                                             std::optional<double> value, double most_m,
                                                             Zero zero = Zero::refused);

/// Collects the sightings of one file: good rows are kept; bad rows are counted, and the first ten are
/// reported.
class IcebergRows {
 public:
  void accept(ocean::Iceberg iceberg) { icebergs_.push_back(std::move(iceberg)); }
  /// `where` tells the user which row it is: "line 12", "feature 3".
  void reject(const std::string& where, messages::Message reason);

  /// The dataset of the good rows.
  /// `warnings`  about the file as a whole; they come before those about rows
  /// Errors  no good row
  [[nodiscard]] Checked<PreparedDataset> prepared(std::vector<std::string> variables,
                                                  Messages warnings = {}) &&;

 private:
  std::vector<ocean::Iceberg> icebergs_;
  Messages reasons_;
  std::int64_t rejected_{};
};

}  // namespace floeplan::ingest
