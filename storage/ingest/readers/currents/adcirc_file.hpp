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

/// The content of a text file of the model ADCIRC: its mesh (fort.14), elevations of the surface (fort.63) or
/// currents averaged over depth (fort.64).
/// Source  ADCIRC user's manual, "Grid and Boundary Information File" and "Elevation Time Series at All Nodes",
///         "Depth-averaged Velocity Time Series at All Nodes"
enum class AdcircPart { mesh, elevations, currents };

struct AdcircHead {
  AdcircPart part{};
  std::size_t nodes{};
};

/// Parses the head of an ADCIRC file (mesh or output) from its first bytes; nullopt if the text is not such a
/// head.
[[nodiscard]] std::optional<AdcircHead> adcirc_head(std::string_view text);

/// Reads nodes and triangles of a fort.14 file; its boundaries are not read.
/// Errors   lines that are not nodes or elements, or are missing; positions that are not longitudes and
///          latitudes
[[nodiscard]] Checked<ocean::Mesh> read_adcirc_mesh(const std::filesystem::path& file);

/// Values at all nodes and times of fort.63 or fort.64, in their full or their compact form.
/// Threads  one thread at a time
class AdcircOutput {
 public:
  /// Reads the file once to its end and remembers where in the file (offset) the values of each time begin.
  /// Errors   lines that are not values; too few or too many lines; times that do not increase
  [[nodiscard]] static Checked<AdcircOutput> open(const std::filesystem::path& file);

  [[nodiscard]] const AdcircHead& head() const { return head_; }
  /// Times of the output, in seconds since the start of the model run.
  [[nodiscard]] const std::vector<double>& seconds() const { return seconds_; }
  /// The values of the file at the time with index `time`.
  /// Shape   [component][node]; NaN where the file marks a node as dry
  /// Errors  the file can no longer be read
  [[nodiscard]] Checked<std::vector<std::vector<float>>> read(std::size_t time) const;

 private:
  struct Record {
    std::streamoff start{};  // offset in the file of the first line of values
    std::size_t first_line{};
    std::size_t lines{};
    double otherwise{};  // value at nodes without a line
  };

  std::filesystem::path file_;
  AdcircHead head_;
  std::vector<double> seconds_;
  std::vector<Record> records_;
};

}  // namespace floeplan::ingest
