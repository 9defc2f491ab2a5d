#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document/message.hpp"

namespace floeplan::mission {

/// Kinds of files. Slocum: a mission (`.mi`) lists behaviors; an argument file (`.ma`) has the arguments of
/// one behavior. Seaglider: targets, a science file with depth bands, and a cmdfile with parameters.
enum class DocumentKind { mission, arguments, targets, science, cmdfile };

/// A b_arg or a sensor setting, in the form `name(unit) value`.
struct Argument {
  std::string name;     // of a b_arg in lower case, as in the firmware's dictionary
  std::string written;  // as in the file
  std::string unit;
  std::string raw;  // the value as in the file
  double value{};
  int line{};
};

struct WaypointRow {
  std::string lon_raw;
  std::string lat_raw;
  geo::LonLat place;
  int line{};
};

/// Sampling of a Seaglider down to a depth.
struct ScienceBand {
  std::optional<core::Metres> depth;  // empty: while the vehicle loiters
  double seconds{};                   // time between samples
  std::string sensors;                // one digit per sensor
  double guidance_seconds{};          // time between corrections of the course
  int line{};
};

struct Behavior {
  std::string name;     // lower case, as in the firmware's dictionary
  std::string written;  // as in the file
  int line{};
  std::vector<Argument> arguments;

  /// The first argument with this name; null if there is none.
  [[nodiscard]] const Argument* find(std::string_view argument_name) const;
};

/// A line of the file, stored so that the file can be written again.
struct SourceLine {
  std::string content;  // what the vehicle reads, with blanks normalised; often empty
  std::string comment;  // from its '#' on, UTF-8
};

/// Encoding and line ends of the file.
struct FileFormat {
  std::size_t bytes{};
  std::string encoding;      // "ascii", "utf-8" or "iso-8859-1"
  std::string line_endings;  // "LF", "CRLF", "CR", "CRLF+LF", "mixed" or "none"
  bool ends_with_newline{};
};

/// A mission file as understood, with all messages about it. A document with the verdict `reject` may only be
/// shown.
struct Document {
  std::string name;  // of the file, without folder
  DocumentKind kind{};
  FileFormat format;
  std::vector<Argument> sensors;  // of a cmdfile: its parameters
  std::vector<Behavior>
      behaviors;  // in order of priority; an argument file has exactly one, or none if it is broken
  std::vector<WaypointRow> waypoints;     // rows of a list, inline places, or targets in flown order
  std::vector<ScienceBand> bands;         // of a science file
  std::optional<int> waypoints_declared;  // num_waypoints of a list
  std::vector<SourceLine> lines;
  Messages messages;  // by line

  [[nodiscard]] Verdict verdict() const { return verdict_of(messages); }
};

/// Adds a message about a line; line 0 is the whole file.
void report(Document& document, int line, const messages::Message& message);

}  // namespace floeplan::mission
