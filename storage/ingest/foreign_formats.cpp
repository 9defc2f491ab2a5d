#include "storage/ingest/foreign_formats.hpp"

#include <cstddef>
#include <cstdint>

#include "storage/ingest/formats/slocum/slocum_header.hpp"

namespace floeplan::ingest {
namespace {

std::uint32_t big_endian_at(std::string_view head, std::size_t offset) {
  std::uint32_t value = 0;
  for (const char byte : head.substr(offset, 4)) value = (value << 8) | static_cast<unsigned char>(byte);
  return value;
}

/// By the first record, whose length in bytes stands before it: of constituents nx, ny, their count, four limits and
/// their names of four letters; of a grid nx, ny, four limits, a time step, a count.
/// Source  as public readers of TPXO take the format apart; no file of it has been at hand
bool is_otis_binary(std::string_view head) {
  constexpr std::uint32_t most_nodes = 100'000;
  if (head.size() < 64) return false;
  const std::uint32_t length = big_endian_at(head, 0);
  const auto is_size = [](std::uint32_t nodes) { return nodes >= 2 && nodes <= most_nodes; };
  if (!is_size(big_endian_at(head, 4)) || !is_size(big_endian_at(head, 8))) return false;
  const std::uint32_t constituents = big_endian_at(head, 12);
  const bool is_grid = length == 32 && big_endian_at(head, 36) == length;
  return is_grid || (constituents >= 1 && constituents <= 100 && length == 28 + 4 * constituents);
}

}  // namespace

std::string refusal_of_foreign(std::string_view head) {
  if (head.find("BSB/") < 4096 || head.find("KNP/") < 4096)
    return "this is a raster chart (KAP/BSB): a picture of a chart in colours, not depths; depths cannot be "
           "read from it; give a bathymetry grid of the area";
  if (head.find("INT.IHO.S-101") != std::string_view::npos)
    return "this is an electronic chart of S-101, which this program does not read; give the S-57 cell of "
           "the same "
           "area, or its depths as S-102";
  if (is_sensor_cache(head))
    return "this is the list of the sensors of a Slocum glider's logs, which holds no data by itself; "
           "give it together with the logs that name it";
  if (is_otis_binary(head))
    return "this is a tide model in the binary format of OTIS (TPXO's h, u and grid files), which this "
           "program does not read; give what OTPS's extract_HC writes for your places, or the model as "
           "NetCDF (the TPXO atlas)";
  if (head.starts_with("PK\x03\x04") || head.starts_with("\x1f\x8b") || head.starts_with("BZh"))
    return "this is a compressed archive; unpack it and give the files in it";
  if (head.starts_with("%PDF") || head.starts_with("\x89PNG") || head.starts_with("\xff\xd8\xff"))
    return "this is a picture or a document, not data; give the data that it was made from";
  if (head.starts_with("SQLite format 3"))
    return "this is an SQLite database, but no GeoPackage; convert it to GeoJSON";
  if (head.starts_with("CDF") || head.starts_with("\x89HDF") || head.starts_with("\x0e\x03\x13\x01"))
    return "this is a variant of NetCDF or HDF that this program does not know; convert it to NetCDF-4";
  return {};
}

}  // namespace floeplan::ingest
