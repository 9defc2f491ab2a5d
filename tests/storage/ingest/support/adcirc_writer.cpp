#include "tests/storage/ingest/support/adcirc_writer.hpp"

#include <sstream>

namespace floeplan::ingest {

std::string AdcircBay::mesh() {
  std::ostringstream out;
  out.precision(10);
  out << "a bay\n" << 2 * (columns - 1) * (rows - 1) << ' ' << nodes << "  ! NE NP\n";
  for (int node = 1; node <= nodes; ++node)
    out << node << ' ' << lon_of(node) << ' ' << lat_of(node) << ' ' << 20.0 + node << '\n';
  int element = 0;
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const int a = row * columns + column + 1;
      out << ++element << " 3 " << a << ' ' << a + 1 << ' ' << a + columns << '\n';
      out << ++element << " 3 " << a + 1 << ' ' << a + columns + 1 << ' ' << a + columns << '\n';
    }
  out << "0 = Number of open boundaries\n0 = Total number of open boundary nodes\n";
  return out.str();
}

std::string AdcircBay::currents(bool compact) {
  std::ostringstream out;
  out.precision(12);
  out << "a bay run 1\n2 " << nodes << " 3600.0 720 2 FileFmtVersion: 1050624\n";
  for (int record = 1; record <= 2; ++record) {
    out << ' ' << 3600.0 * record << ' ' << 720 * record;
    if (compact) out << ' ' << nodes - 1 << " -99999.0";
    out << '\n';
    for (int node = 1; node <= nodes; ++node) {
      if (compact && node == dry_node) continue;
      const bool dry = node == dry_node;
      out << node << ' ' << (dry ? 0.0 : east_of(node, record)) << ' ' << (dry ? 0.0 : north_of(node, record))
          << '\n';
    }
  }
  return out.str();
}

std::string AdcircBay::elevations() {
  std::ostringstream out;
  out << "a bay run 1\n2 " << nodes << " 3600.0 720 1\n";
  for (int record = 1; record <= 2; ++record) {
    out << 3600.0 * record << ' ' << 720 * record << '\n';
    for (int node = 1; node <= nodes; ++node)
      out << node << ' ' << (node == dry_node + 1 ? "-99999.0" : "1.5D-01") << '\n';
  }
  return out.str();
}

}  // namespace floeplan::ingest
