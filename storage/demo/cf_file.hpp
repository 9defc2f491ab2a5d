#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/demo/raster_frame.hpp"

class GDALDataset;
class GDALDimension;
class GDALGroup;
class GDALMDArray;

/// Parts of the CF-1.8 NetCDF-4 files that the demonstration writes. The files have no date of creation and
/// no history, so the same content gives the same bytes. Every function throws std::runtime_error when the
/// file cannot be written.
namespace floeplan::demo {

using CfDimensions = std::vector<std::shared_ptr<GDALDimension>>;

[[nodiscard]] std::unique_ptr<GDALDataset> create_cf_file(const std::filesystem::path& file,
                                                          const std::string& title,
                                                          const std::string& comment);

/// Adds a text attribute to a group or a variable.
template <class Owner>
void add_cf_text(Owner& owner, const std::string& name, const std::string& text);

/// A dimension and its coordinate variable.
[[nodiscard]] std::shared_ptr<GDALDimension> add_axis(
    GDALGroup& group, const std::string& name, const std::vector<double>& nodes,
    const std::vector<std::pair<std::string, std::string>>& attributes);
[[nodiscard]] std::shared_ptr<GDALDimension> add_time_axis(GDALGroup& group,
                                                           const std::vector<core::UtcTime>& times);
[[nodiscard]] std::shared_ptr<GDALDimension> add_latitudes(GDALGroup& group, const RasterFrame& frame);
[[nodiscard]] std::shared_ptr<GDALDimension> add_longitudes(GDALGroup& group, const RasterFrame& frame);

inline constexpr std::int16_t packed_missing = -32767;

/// A variable stored as int16 in units of `step`; `packed_missing` marks a node without a value.
struct PackedVariable {
  std::string name;
  double step{};
};

/// Adds a variable whose last two axes are latitude and longitude. One horizontal slice is one chunk, because
/// readers take the file slice by slice.
[[nodiscard]] std::shared_ptr<GDALMDArray> add_packed(GDALGroup& group, const CfDimensions& axes,
                                                      const PackedVariable& variable);

}  // namespace floeplan::demo
