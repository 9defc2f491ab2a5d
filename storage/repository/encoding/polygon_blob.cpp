#include "storage/repository/encoding/polygon_blob.hpp"

#include <stdexcept>
#include <vector>

#include "engine/messages/store_messages.hpp"

namespace floeplan::repository {
namespace {

std::vector<double> flattened(const geo::Polygon& polygon) {
  std::vector<const geo::Ring*> rings{&polygon.outer};
  for (const geo::Ring& hole : polygon.holes) rings.push_back(&hole);

  std::vector<double> numbers{static_cast<double>(rings.size())};
  for (const geo::Ring* ring : rings) numbers.push_back(static_cast<double>(ring->size()));
  for (const geo::Ring* ring : rings) {
    for (const geo::LonLat place : *ring) numbers.push_back(place.lon_deg);
  }
  for (const geo::Ring* ring : rings) {
    for (const geo::LonLat place : *ring) numbers.push_back(place.lat_deg);
  }
  return numbers;
}

/// A count in a blob. It is checked, because a damaged file may have broken the process that wrote it.
std::size_t count_at(const std::vector<double>& numbers, std::size_t index) {
  const double count = numbers.at(index);
  if (!(count >= 0.0 && count <= static_cast<double>(numbers.size())))
    throw std::runtime_error{messages::store_text<"stored-polygon-damaged">()};
  return static_cast<std::size_t>(count);
}

geo::Polygon from_flattened(const std::vector<double>& numbers) {
  const std::size_t rings = count_at(numbers, 0);
  std::size_t places = 0;
  for (std::size_t ring = 0; ring < rings; ++ring) places += count_at(numbers, 1 + ring);
  if (rings < 1 || numbers.size() != 1 + rings + 2 * places)
    throw std::runtime_error{messages::store_text<"stored-polygon-damaged">()};

  geo::Polygon polygon;
  polygon.holes.resize(rings - 1);
  std::size_t next = 1 + rings;
  for (std::size_t i = 0; i < rings; ++i) {
    geo::Ring& ring = i == 0 ? polygon.outer : polygon.holes[i - 1];
    const std::size_t size = count_at(numbers, 1 + i);
    ring.reserve(size);
    for (std::size_t k = 0; k < size; ++k, ++next) {
      ring.push_back({numbers[next], numbers[next + places]});
    }
  }
  return polygon;
}

}  // namespace

std::span<const std::byte> pack_polygon(BlobCodec& codec, const geo::Polygon& polygon) {
  const std::vector<double> numbers = flattened(polygon);
  return codec.pack(std::span{numbers});
}

geo::Polygon unpack_polygon(BlobCodec& codec, std::span<const std::byte> blob) {
  return from_flattened(codec.unpack_doubles(blob, BlobCodec::unpacked_bytes(blob) / sizeof(double)));
}

}  // namespace floeplan::repository
