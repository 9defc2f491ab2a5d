#include "storage/ingest/foreign_formats.hpp"

#include <cstddef>
#include <cstdint>

#include "engine/messages/ingest_file_messages.hpp"
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

std::optional<messages::Message> refusal_of_foreign(std::string_view head) {
  if (head.find("BSB/") < 4096 || head.find("KNP/") < 4096)
    return messages::ingest_file_message<"raster-chart">();
  if (head.find("INT.IHO.S-101") != std::string_view::npos)
    return messages::ingest_file_message<"electronic-chart-not-read">();
  if (is_sensor_cache(head)) return messages::ingest_file_message<"lone-sensor-list">();
  if (is_otis_binary(head)) return messages::ingest_file_message<"tide-model-of-otis">();
  if (head.starts_with("PK\x03\x04") || head.starts_with("\x1f\x8b") || head.starts_with("BZh"))
    return messages::ingest_file_message<"archive-not-readable">();
  if (head.starts_with("%PDF") || head.starts_with("\x89PNG") || head.starts_with("\xff\xd8\xff"))
    return messages::ingest_file_message<"picture-or-document">();
  if (head.starts_with("SQLite format 3")) return messages::ingest_file_message<"other-database">();
  if (head.starts_with("CDF") || head.starts_with("\x89HDF") || head.starts_with("\x0e\x03\x13\x01"))
    return messages::ingest_file_message<"other-hdf">();
  return std::nullopt;
}

}  // namespace floeplan::ingest
