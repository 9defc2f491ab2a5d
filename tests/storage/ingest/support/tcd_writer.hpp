#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::ingest {

/// A station of a TCD file as libtcd writes it: in its zone's standard time, hours and minutes east of UTC (-330).
struct TcdSampleStation {
  struct Constant {
    double amplitude{};
    double phase_deg{};
  };

  std::string name;  // Latin-1
  geo::LonLat place;
  std::string unit{"meters"};
  int zone{};
  std::map<std::string, Constant> constants;
  int differs_from{-1};  // the number of another station: a subordinate one
};

/// Writes a TCD file of the constituents M2, S2, K1, O1 and SA-IOS.
void write_tcd(const std::filesystem::path& file, const std::vector<TcdSampleStation>& stations);

}  // namespace floeplan::ingest
