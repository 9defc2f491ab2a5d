#include "tests/storage/ingest/support/tcd_writer.hpp"

#include <tcd.h>

#include <array>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace floeplan::ingest {
namespace {

constexpr std::array<const char*, 5> names{"M2", "S2", "K1", "O1", "SA-IOS"};
constexpr std::size_t count = names.size();

}  // namespace

void write_tcd(const std::filesystem::path& file, const std::vector<TcdSampleStation>& stations) {
  std::array<std::string, count> texts;
  std::array<char*, count> constituents{};
  for (std::size_t i = 0; i < count; ++i) {
    texts.at(i) = names.at(i);
    constituents.at(i) = texts.at(i).data();
  }
  std::array<double, count> speeds{28.9841042, 30.0, 15.0410686, 13.9430356, 0.0410667};
  std::array<float, 1> argument{10.0F};
  std::array<float, 1> factor{1.0F};
  std::array<float*, count> arguments{};
  std::array<float*, count> factors{};
  arguments.fill(argument.data());
  factors.fill(factor.data());
  std::string path = file.string();
  DB_HEADER_PUBLIC header{};
  if (create_tide_db(path.data(), count, constituents.data(), speeds.data(), 2026, 1, arguments.data(),
                     factors.data()) == NVFalse)
    throw std::runtime_error{"no file to write to: " + path};
  for (const TcdSampleStation& station : stations) {
    const auto record = std::make_unique<TIDE_RECORD>();
    std::strncpy(record->header.name, station.name.c_str(), sizeof record->header.name - 1);
    record->header.record_type = station.differs_from < 0 ? REFERENCE_STATION : SUBORDINATE_STATION;
    record->header.reference_station = station.differs_from;
    record->header.longitude = station.place.lon_deg;
    record->header.latitude = station.place.lat_deg;
    std::string unit = station.unit;
    record->level_units = static_cast<std::uint8_t>(find_level_units(unit.data()));
    record->zone_offset = station.zone;
    record->min_direction = record->max_direction = 361;  // not stated
    record->flood_begins = record->ebb_begins = NULLSLACKOFFSET;
    for (std::size_t i = 0; i < count; ++i)
      if (const auto constant = station.constants.find(names.at(i)); constant != station.constants.end()) {
        record->amplitude[i] = static_cast<float>(constant->second.amplitude);
        record->epoch[i] = static_cast<float>(constant->second.phase_deg);
      }
    if (add_tide_record(record.get(), &header) == NVFalse)
      throw std::runtime_error{"libtcd refuses the station " + station.name};
  }
  close_tide_db();
}

}  // namespace floeplan::ingest
