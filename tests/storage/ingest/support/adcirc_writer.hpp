#pragma once

#include <string>

namespace floeplan::ingest {

/// An ADCIRC run with two times in a bay of triangles, as text files. Its currents are exact as floats.
struct AdcircBay {
  static constexpr int columns = 9;
  static constexpr int rows = 8;
  static constexpr int nodes = columns * rows;
  static constexpr int dry_node = 40;  // the dry node by the currents; by the elevations it is the next one

  static double lon_of(int node) { return -9.0 + 0.1 * ((node - 1) % columns); }
  static double lat_of(int node) { return 54.0 + 0.05 * ((node - 1) / columns); }
  static double east_of(int node, int record) { return 0.25 + 0.0078125 * node + 0.125 * record; }
  static double north_of(int node, int record) { return -0.5 + 0.00390625 * node - 0.0625 * record; }

  /// fort.14
  static std::string mesh();
  /// fort.63
  static std::string elevations();
  /// fort.64. `compact`: without the dry node.
  static std::string currents(bool compact);
};

}  // namespace floeplan::ingest
