#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document/message.hpp"

namespace floeplan::mission {

/// A mission (`.mi`) lists behaviors; an argument file (`.ma`) holds the arguments of one. A Seaglider has targets, a
/// science file with depth bands and a cmdfile with parameters.
enum class DocumentKind { mission, arguments, targets, science, cmdfile };

/// A b_arg or a sensor setting, as `name(unit) value`.
struct Argument {
  std::string name;     // of a b_arg in lower case, as the firmware's dictionary has it
  std::string written;  // as the file has it
  std::string unit;
  std::string raw;  // the value as it was written
  double value{};
  int line{};
};

struct WaypointRow {
  std::string lon_raw;
  std::string lat_raw;
  geo::LonLat place;
  int line{};
};

/// How often a Seaglider samples down to a depth.
struct ScienceBand {
  std::optional<core::Metres> depth;  // empty while it loiters
  double seconds{};                   // between samples
  std::string sensors;                // a digit for each sensor
  double guidance_seconds{};          // between looks at its course
  int line{};
};

struct Behavior {
  std::string name;     // lower case, as the firmware's dictionary has it
  std::string written;  // as the file has it
  int line{};
  std::vector<Argument> arguments;

  /// The first of that name; nothing when there is none.
  [[nodiscard]] const Argument* find(std::string_view argument_name) const;
};

/// A line of the file, kept so that it can be written again.
struct SourceLine {
  std::string content;  // what the vehicle reads, with blanks as this program writes them; often empty
  std::string comment;  // from its '#', UTF-8
};

/// How the bytes were laid out.
struct FileFormat {
  std::size_t bytes{};
  std::string encoding;      // "ascii", "utf-8" or "iso-8859-1"
  std::string line_endings;  // "LF", "CRLF", "CR", "CRLF+LF", "mixed" or "none"
  bool ends_with_newline{};
};

/// A mission file as it was understood, with all that was noticed. Only a document whose verdict is not
/// `reject` may be used for anything but showing it.
struct Document {
  std::string name;  // of the file, without its folder
  DocumentKind kind{};
  FileFormat format;
  std::vector<Argument> sensors;  // of a cmdfile its parameters
  std::vector<Behavior>
      behaviors;  // in order of priority; of an argument file exactly one, or none if broken
  std::vector<WaypointRow> waypoints;     // rows of a list, places given inline, or targets in flown order
  std::vector<ScienceBand> bands;         // of a science file
  std::optional<int> waypoints_declared;  // num_waypoints of a list
  std::vector<SourceLine> lines;
  Messages messages;  // by line

  [[nodiscard]] Verdict verdict() const { return verdict_of(messages); }
};

/// Adds what was noticed on a line; line 0 is the file as a whole.
void report(Document& document, int line, const messages::Message& message);

}  // namespace floeplan::mission
