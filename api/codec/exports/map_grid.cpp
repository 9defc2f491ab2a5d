#include "api/codec/exports/map_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

constexpr std::int16_t missing = -32768;

std::string header(const MapGrid& grid) {
  nlohmann::json names = nlohmann::json::array();
  nlohmann::json scales = nlohmann::json::array();
  for (const auto& variable : grid.variables) {
    names.push_back(variable.name);
    scales.push_back(variable.scale);
  }
  return nlohmann::json{{"variables", names},
                        {"scale", scales},
                        {"missing", missing},
                        {"nx", grid.nx},
                        {"ny", grid.ny},
                        {"west_deg", grid.west_deg},
                        {"south_deg", grid.south_deg},
                        {"dx_deg", grid.dx_deg},
                        {"dy_deg", grid.dy_deg},
                        {"time", grid.time ? nlohmann::json(core::iso8601(*grid.time)) : nlohmann::json()},
                        {"dataset_id", grid.dataset_id},
                        {"dataset_name", grid.dataset_name},
                        {"warnings", grid.warnings}}
      .dump();
}

std::int16_t quantised(const std::optional<double>& value, double scale) {
  if (!value) return missing;
  return static_cast<std::int16_t>(std::clamp(std::round(*value / scale), -32767.0, 32767.0));
}

}  // namespace

std::string encode(const MapGrid& grid) {
  std::string text = header(grid);
  while ((4 + text.size()) % 8 != 0) text += ' ';

  std::string bytes;
  bytes.reserve(4 + text.size() + 2 * grid.variables.size() * grid.nx * grid.ny);
  const auto length = static_cast<std::uint32_t>(text.size());
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((length >> shift) & 0xffU);
  bytes += text;
  for (const auto& variable : grid.variables) {
    for (const auto& value : variable.values) {
      const auto word = static_cast<std::uint16_t>(quantised(value, variable.scale));
      bytes += static_cast<char>(word & 0xffU);
      bytes += static_cast<char>(word >> 8U);
    }
  }
  return bytes;
}

}  // namespace floeplan::codec
