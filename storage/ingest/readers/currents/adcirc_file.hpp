#pragma once

#include <cstddef>
#include <filesystem>
#include <ios>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ocean/grids/mesh.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// What a text file of the model ADCIRC holds: its mesh (fort.14), elevations of the surface (fort.63) or currents
/// averaged over depth (fort.64).
/// Source  ADCIRC user's manual, "Grid and Boundary Information File" and "Elevation Time Series at All Nodes",
///         "Depth-averaged Velocity Time Series at All Nodes"
enum class AdcircPart { mesh, elevations, currents };

struct AdcircHead {
  AdcircPart part{};
  std::size_t nodes{};
};

/// By the first bytes of a file; nullopt for any other text.
[[nodiscard]] std::optional<AdcircHead> adcirc_head(std::string_view text);

/// Nodes and triangles of fort.14; its boundaries are not read.
/// Errors   lines that are no nodes or elements, or are missing; places that are no longitudes and latitudes
[[nodiscard]] Checked<ocean::Mesh> read_adcirc_mesh(const std::filesystem::path& file);

/// Values at all nodes and times of fort.63 or fort.64, in their full or their compact form.
/// Threads  one thread at a time
class AdcircOutput {
 public:
  /// Reads the file once to its end and remembers where each time begins.
  /// Errors   lines that are no values, are missing or too many; times that do not rise
  [[nodiscard]] static Checked<AdcircOutput> open(const std::filesystem::path& file);

  [[nodiscard]] const AdcircHead& head() const { return head_; }
  /// From the start of the model's run.
  [[nodiscard]] const std::vector<double>& seconds() const { return seconds_; }
  /// Shape   [component][node]; NaN where the file marks a node as dry
  /// Errors  the file can no longer be read
  [[nodiscard]] Checked<std::vector<std::vector<float>>> read(std::size_t time) const;

 private:
  struct Record {
    std::streamoff start{};  // of its first line of values
    std::size_t first_line{};
    std::size_t lines{};
    double otherwise{};  // at the nodes without a line
  };

  std::filesystem::path file_;
  AdcircHead head_;
  std::vector<double> seconds_;
  std::vector<Record> records_;
};

}  // namespace floeplan::ingest
