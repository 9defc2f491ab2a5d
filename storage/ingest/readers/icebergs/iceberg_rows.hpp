#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/ice/iceberg.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

inline constexpr double longest_iceberg_m = 400'000.0;  // B-15 was 295 km long
inline constexpr double deepest_iceberg_m = 1'000.0;    // the deepest that a file may state
inline constexpr double least_certain_m = 1e6;  // the widest error of a position that a file may state

enum class Zero : std::uint8_t { allowed, refused };

/// A length in metres out of a text, empty where that is; or why it is none. `value`: the number that the text is, if
/// any.
[[nodiscard]] Checked<std::optional<core::Metres>> metres_of(const std::string& name, const std::string& text,
                                                             std::optional<double> value, double most_m,
                                                             Zero zero = Zero::refused);

/// Collects the sightings of one file: good rows are kept, bad ones counted, the first ten with their reason.
class IcebergRows {
 public:
  void accept(ocean::Iceberg iceberg) { icebergs_.push_back(std::move(iceberg)); }
  /// `where` names the row for a person: "line 12", "feature 3".
  void reject(const std::string& where, messages::Message reason);

  /// `warnings`  of the file as a whole, told before those of its rows
  /// Errors  no good row at all
  [[nodiscard]] Checked<PreparedDataset> prepared(std::vector<std::string> variables,
                                                  Messages warnings = {}) &&;

 private:
  std::vector<ocean::Iceberg> icebergs_;
  Messages reasons_;
  std::int64_t rejected_{};
};

}  // namespace floeplan::ingest
