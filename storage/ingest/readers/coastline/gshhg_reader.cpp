#include "storage/ingest/readers/coastline/gshhg_reader.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/readers/coastline/gshhg_bin.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::array array_names{"Bin_size_in_minutes",
                                 "N_bins_in_360_longitude_range",
                                 "N_bins_in_180_degree_latitude_range",
                                 "Id_of_first_segment_in_a_bin",
                                 "N_segments_in_a_bin",
                                 "Embedded_node_levels_in_a_bin",
                                 "Embedded_npts_levels_exit_entry_for_a_segment",
                                 "Id_of_first_point_in_a_segment",
                                 "Relative_longitude_from_SW_corner_of_bin",
                                 "Relative_latitude_from_SW_corner_of_bin"};
// exists only in files with both outlines of Antarctica
constexpr auto ice_front_array = "Embedded_ANT_flag";
constexpr int grounding_line_level = 6;
constexpr int deepest_level = 4;

/// Thrown when the file contradicts itself; the public function catches it and returns a violation.
struct Contradiction : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::unique_ptr<GDALDataset> open_arrays(const std::filesystem::path& file) {
  register_drivers();
  const GdalMessages kept_quiet;
  const std::array<const char*, 2> drivers{"netCDF", nullptr};
  return std::unique_ptr<GDALDataset>{
      GDALDataset::Open(file.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY, drivers.data())};
}

bool has_array(const GDALGroup& group, const std::string& name) {
  const auto names = group.GetMDArrayNames();
  return std::ranges::find(names, name) != names.end();
}

std::string missing_array(const GDALGroup& group) {
  for (const char* const name : array_names) {
    if (!has_array(group, name)) return name;
  }
  return {};
}

template <class Value>
constexpr GDALDataType element_type();
template <>
constexpr GDALDataType element_type<std::int16_t>() {
  return GDT_Int16;
}
template <>
constexpr GDALDataType element_type<std::int32_t>() {
  return GDT_Int32;
}

/// Elements [first, end) of a one-dimensional array.
template <class Value>
std::vector<Value> read(const GDALGroup& group, const char* name, std::uint64_t first, std::uint64_t end) {
  const auto array = group.OpenMDArray(name);
  if (!array || array->GetDimensionCount() != 1)
    throw Contradiction{std::string{name} + " is not one-dimensional"};
  if (first > end || end > array->GetDimensions()[0]->GetSize())
    throw Contradiction{std::string{name} + " is shorter than the other arrays say"};
  std::vector<Value> values(end - first);
  if (values.empty()) return values;
  const GUInt64 start = first;
  const std::size_t count = values.size();
  if (!array->Read(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(element_type<Value>()),
                   values.data()))
    throw Contradiction{std::string{name} + " cannot be read"};
  return values;
}

int read_number(const GDALGroup& group, const char* name) {
  return read<std::int32_t>(group, name, 0, 1).front();
}

/// A half-open range of array elements.
struct Range {
  std::uint64_t first{std::numeric_limits<std::uint64_t>::max()};
  std::uint64_t end{};

  void include(std::uint64_t from, std::uint64_t to) {
    first = std::min(first, from);
    end = std::max(end, to);
  }
  [[nodiscard]] bool empty() const { return first >= end; }
};

struct BinHeader {
  geo::LonLat south_west;
  int corner_levels{};
  std::uint64_t first_segment{};
  std::uint64_t segments{};
};

/// The bins of one file that meet an area, and the parts of its arrays that they need.
class BinnedShoreline {
 public:
  BinnedShoreline(const GDALGroup& group, const geo::BoundingBox& area) {
    read_headers(group, area);
    read_segments(group);
    read_points(group);
  }

  [[nodiscard]] const std::vector<BinHeader>& headers() const { return headers_; }

  [[nodiscard]] ShoreBin bin(const BinHeader& header) const {
    ShoreBin bin{.south_west = header.south_west, .size_deg = size_deg_, .corner_levels = {}, .segments = {}};
    for (std::size_t corner = 0; corner < 4; ++corner)
      bin.corner_levels[corner] = (header.corner_levels >> (9 - 3 * static_cast<int>(corner))) & 7;
    for (std::uint64_t i = 0; i < header.segments; ++i) {
      if (auto segment = this->segment(header.first_segment + i)) bin.segments.push_back(std::move(*segment));
    }
    return bin;
  }

 private:
  void read_headers(const GDALGroup& group, const geo::BoundingBox& area) {
    const int minutes = read_number(group, array_names[0]);
    const int across = read_number(group, array_names[1]);
    const int down = read_number(group, array_names[2]);
    if (minutes <= 0 || across * minutes != 360 * 60 || down * minutes != 180 * 60)
      throw Contradiction{"the bins do not cover the globe"};
    size_deg_ = minutes / 60.0;

    const auto bins = static_cast<std::uint64_t>(across) * static_cast<std::uint64_t>(down);
    const auto first_segment = read<std::int32_t>(group, array_names[3], 0, bins);
    const auto segments = read<std::int16_t>(group, array_names[4], 0, bins);
    const auto levels = read<std::int16_t>(group, array_names[5], 0, bins);
    for (std::size_t i = 0; i < bins; ++i) {
      const int column = static_cast<int>(i) % across;
      const int row = static_cast<int>(i) / across;
      const geo::LonLat south_west{geo::wrap_longitude(column * size_deg_), 90.0 - (row + 1) * size_deg_};
      const geo::BoundingBox box{south_west.lon_deg, south_west.lat_deg, south_west.lon_deg + size_deg_,
                                 south_west.lat_deg + size_deg_};
      if (!geo::intersects(box, area)) continue;
      if (first_segment[i] < 0 || segments[i] < 0)
        throw Contradiction{"a bin has a negative number of segments"};
      headers_.push_back({south_west, levels[i], static_cast<std::uint64_t>(first_segment[i]),
                          static_cast<std::uint64_t>(segments[i])});
    }
  }

  void read_segments(const GDALGroup& group) {
    for (const BinHeader& bin : headers_) {
      if (bin.segments > 0) segment_range_.include(bin.first_segment, bin.first_segment + bin.segments);
    }
    if (segment_range_.empty()) return;
    const auto [first, end] = segment_range_;
    segment_info_ = read<std::int32_t>(group, array_names[6], first, end);
    segment_first_point_ = read<std::int32_t>(group, array_names[7], first, end);
    if (has_array(group, ice_front_array))
      ice_front_ = read<std::int16_t>(group, ice_front_array, first, end);
  }

  void read_points(const GDALGroup& group) {
    for (std::size_t i = 0; i < segment_info_.size(); ++i) {
      if (segment_info_[i] < 0 || segment_first_point_[i] < 0)
        throw Contradiction{"a segment has a negative number of points"};
      const auto first = static_cast<std::uint64_t>(segment_first_point_[i]);
      point_range_.include(first, first + static_cast<std::uint64_t>(segment_info_[i] >> 9));
    }
    if (point_range_.empty()) return;
    east_ = read<std::int16_t>(group, array_names[8], point_range_.first, point_range_.end);
    north_ = read<std::int16_t>(group, array_names[9], point_range_.first, point_range_.end);
  }

  /// The segment with this index; empty for the grounding line of Antarctica, which lies inside the ice
  /// front.
  [[nodiscard]] std::optional<ShoreSegment> segment(std::uint64_t index) const {
    const std::size_t at = index - segment_range_.first;
    const auto info = static_cast<std::uint32_t>(segment_info_[at]);
    int level = static_cast<int>((info >> 6) & 7U);
    const bool of_ice_front = !ice_front_.empty() && ice_front_[at] != 0;
    if (level == grounding_line_level && !of_ice_front) return std::nullopt;
    if (level > deepest_level) level = 1;

    const std::uint32_t entry = (info >> 3) & 7U;
    const std::uint32_t exit = info & 7U;
    const std::size_t points = info >> 9;
    if (entry > 4 || exit > 4 || (entry == 4) != (exit == 4) || points == 0)
      throw Contradiction{"a segment enters a bin and does not leave it"};

    ShoreSegment segment{level, static_cast<BinSide>(entry), static_cast<BinSide>(exit), {}};
    segment.points.reserve(points);
    const std::size_t first = static_cast<std::uint64_t>(segment_first_point_[at]) - point_range_.first;
    for (std::size_t i = first; i < first + points; ++i)
      segment.points.push_back({static_cast<std::uint16_t>(east_[i]), static_cast<std::uint16_t>(north_[i])});
    return segment;
  }

  double size_deg_{};
  std::vector<BinHeader> headers_;
  Range segment_range_;
  Range point_range_;
  std::vector<std::int32_t>
      segment_info_;  // exit side (bits 0-2), entry side (3-5), level (6-8), points (9 and up)
  std::vector<std::int32_t> segment_first_point_;
  std::vector<std::int16_t> ice_front_;
  std::vector<std::int16_t> east_;
  std::vector<std::int16_t> north_;
};

core::Violation refusal(const std::filesystem::path& file, const std::string& reason) {
  return {file.filename().string(), "must be a GSHHG shoreline in the binned format of GMT; " + reason +
                                        "; take binned_GSHHS_f.nc of the package gmt-gshhg-full"};
}

}  // namespace

bool is_gshhg(const std::filesystem::path& file) {
  const auto dataset = open_arrays(file);
  const auto group = dataset ? dataset->GetRootGroup() : nullptr;
  return group && missing_array(*group).empty();
}

tl::expected<std::vector<geo::Polygon>, core::Violation> read_gshhg(const std::filesystem::path& file,
                                                                    const geo::BoundingBox& area) {
  const auto dataset = open_arrays(file);
  const auto group = dataset ? dataset->GetRootGroup() : nullptr;
  if (!group) return tl::unexpected(refusal(file, "it cannot be opened as NetCDF"));
  if (const std::string name = missing_array(*group); !name.empty())
    return tl::unexpected(refusal(file, "it has no array " + name));

  try {
    const BinnedShoreline shoreline{*group, area};
    std::vector<geo::Polygon> land;
    for (const BinHeader& header : shoreline.headers()) {
      std::ranges::move(land_of(shoreline.bin(header)), std::back_inserter(land));
    }
    return land;
  } catch (const Contradiction& contradiction) {
    return tl::unexpected(refusal(file, contradiction.what()));
  }
}

}  // namespace floeplan::ingest
