#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "engine/messages/ingest_current_messages.hpp"
#include "engine/messages/ingest_hdf5_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/formats/s100/s100_coverage.hpp"
#include "storage/ingest/grids/scattered_mesh.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/currents/current_dataset.hpp"
#include "storage/ingest/readers/currents/current_readers.hpp"

namespace floeplan::ingest {
namespace {

constexpr const char* feature_name = "SurfaceCurrent";
constexpr const char* speed_name = "surfaceCurrentSpeed";
constexpr const char* direction_name = "surfaceCurrentDirection";

/// The depth of the currents.
struct Level {
  std::optional<double> depth_m;               // empty: the file does not say
  std::optional<messages::Message> warning{};  // empty: no warning
};

/// From where the depth of the currents counts; `layer`: it is the thickness of a layer below the surface.
enum class Reference : std::uint8_t { layer, surface, datum, bed, unknown };

/// The edition of the product specification: 1.2 for "INT.IHO.S-111.1.2". Without one, the newest edition is
/// assumed.
double edition_of(const Hdf5Group& file) {
  constexpr double today = 2.0;
  constexpr std::size_t digits = 3;  // "1.2"
  const std::string marker = "S-111.";
  const std::string product = file.text("productSpecification").value_or("");
  const std::size_t at = product.find(marker);
  return at == std::string::npos ? today
                                 : parse_number(product.substr(at + marker.size(), digits)).value_or(today);
}

/// The reference from which the depth is measured. Since edition 1.2 the vertical datum gives it; in earlier
/// editions the code depthTypeIndex.
Reference reference_of(const Hdf5Group& file) {
  constexpr double sea_floor = 47.0;  // S-100 edition 5, part 17, vertical and sounding datums
  constexpr double sea_surface = 48.0;
  const double edition = edition_of(file);
  const double type = file.number("depthTypeIndex").value_or(edition < 1.2 ? 2.0 : 1.0);
  const double datum = file.number("verticalDatum").value_or(sea_surface);
  if (edition < 1.2) {
    if (type == 1.0) return Reference::layer;
    if (type == 2.0) return Reference::surface;
    if (type == 3.0) return Reference::datum;
    return type == 4.0 ? Reference::bed : Reference::unknown;
  }
  if (type == 2.0) return Reference::layer;
  if (type != 1.0) return Reference::unknown;
  if (datum == sea_floor) return Reference::bed;
  return datum == sea_surface ? Reference::surface : Reference::datum;
}

Checked<Level> s111_level(const Hdf5Group& file) {
  const auto stated = file.number("surfaceCurrentDepth");
  if (!stated) return Level{};
  if (!std::isfinite(*stated)) return refuse(messages::ingest_hdf5_message<"s-depth-missing">());
  const double depth_m =
      std::abs(*stated);  // a depth below the surface should be negative, but not all producers do so
  switch (reference_of(file)) {
    case Reference::surface: return Level{depth_m};
    case Reference::layer:
      return Level{depth_m / 2.0, messages::ingest_hdf5_message<"uppermost-layer">(number(depth_m))};
    case Reference::datum:
      return Level{depth_m, messages::ingest_hdf5_message<"depth-from-chart-datum">(number(depth_m))};
    case Reference::bed:
    case Reference::unknown: break;
  }
  return refuse(messages::ingest_hdf5_message<"s-depth-from-the-bed">());
}

/// Components from speeds and from directions towards which the water flows, degrees from true north; NaN for
/// fill values.
VelocitySlice components_of(std::vector<float> speeds, std::vector<float> directions, double unit_m_s) {
  VelocitySlice slice{std::move(speeds), std::move(directions)};
  for (std::size_t i = 0; i < slice.east.size(); ++i) {
    const double speed_m_s = unit_m_s * static_cast<double>(slice.east[i]);
    const double direction_deg = static_cast<double>(slice.north[i]);
    if (speed_m_s == 0.0) {  // a speed of zero may have no direction
      slice.east[i] = slice.north[i] = 0.0F;
    } else if (!(speed_m_s > 0.0 && direction_deg >= 0.0 && direction_deg <= 360.0)) {
      slice.east[i] = slice.north[i] = missing;
    } else {
      const double towards_rad = direction_deg * std::numbers::pi / 180.0;
      slice.east[i] = static_cast<float>(speed_m_s * std::sin(towards_rad));
      slice.north[i] = static_cast<float>(speed_m_s * std::cos(towards_rad));
    }
  }
  return slice;
}

/// The common part of the layouts of S-111: one level, and speeds with directions.
class S111Source : public VelocitySource {
 public:
  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t /*level*/) const override {
    auto speeds = values(records_[time], speed_name);
    if (!speeds) return refuse(speeds.error());
    auto directions = values(records_[time], direction_name);
    if (!directions) return refuse(directions.error());
    return components_of(std::move(*speeds), std::move(*directions), unit_m_s_);
  }
  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t /*time*/,
                                                         std::size_t /*level*/) const override {
    return refuse(messages::ingest_current_message<"levels-not-of-the-bed">("an S-111 file"));
  }

 protected:
  S111Source(std::size_t columns, std::size_t rows, AxisNodes times, std::optional<double> depth_m,
             double unit_m_s)
      : records_{std::move(times.source)}, unit_m_s_{unit_m_s} {
    shape_.columns = columns;
    shape_.rows = rows;
    shape_.times_s = std::move(times.nodes);
    if (depth_m) shape_.depths_m = {*depth_m};
  }

  /// Values of one component at all points, in one record of the file.
  [[nodiscard]] virtual Checked<std::vector<float>> values(std::size_t record, const char* name) const = 0;

 private:
  std::vector<std::size_t> records_;  // index of the record for each time
  double unit_m_s_;
  SourceShape shape_;
};

/// Currents on a grid.
class S111GridSource : public S111Source {
 public:
  S111GridSource(S100Coverage currents, AxisNodes times, std::optional<double> depth_m, double unit_m_s)
      : S111Source{currents.grid.x().size(), currents.grid.y().size(), std::move(times), depth_m, unit_m_s},
        currents_{std::move(currents)} {}

  [[nodiscard]] geo::LonLat place(std::size_t point) const override {
    return currents_.grid.place(point % shape().columns, point / shape().columns);
  }

 private:
  [[nodiscard]] Checked<std::vector<float>> values(std::size_t record, const char* name) const override {
    const auto table = currents_.table(record);
    if (!table) return refuse(table.error());
    return currents_.read(*table, name, 0, shape().rows);
  }

  S100Coverage currents_;
};

/// Currents at listed positions.
class S111PointSource : public S111Source {
 public:
  S111PointSource(S100Points currents, AxisNodes times, std::optional<double> depth_m, double unit_m_s)
      : S111Source{currents.places.size(), 1, std::move(times), depth_m, unit_m_s},
        currents_{std::move(currents)} {}

  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return currents_.places[point]; }

 private:
  [[nodiscard]] Checked<std::vector<float>> values(std::size_t record, const char* name) const override {
    return currents_.read(record, name);
  }

  S100Points currents_;
};

/// The metadata of all values of a file, whatever their layout.
struct S111Head {
  double unit_m_s{};
  AxisNodes times;
  Level level;
};

template <class Values>
Checked<S111Head> head_of(const Values& currents) {
  const auto speed = currents.values.find(speed_name);
  const std::string unit = speed == currents.values.end() ? "" : speed->second.unit;
  const auto unit_m_s = speed_factor(unit);
  if (!unit_m_s) return refuse(messages::ingest_hdf5_message<"s-speed-unit-unknown">(unit));
  auto times = s100_times(currents.records);
  if (!times) return refuse(times.error());
  const auto level = s111_level(currents.file);
  if (!level) return refuse(level.error());
  return S111Head{*unit_m_s, std::move(*times), *level};
}

Checked<CurrentInput> points_in(const std::filesystem::path& file) {
  auto currents = s100_points(file, feature_name);
  if (!currents) return refuse(currents.error());
  auto head = head_of(*currents);
  if (!head) return refuse(head.error());
  CurrentInput input;
  auto mesh = mesh_of(*currents);
  if (!mesh) return refuse(mesh.error());
  input.mesh = std::move(mesh->mesh);
  input.layout = std::move(mesh->layout);
  if (head->level.warning) input.warnings.push_back(*head->level.warning);
  input.source = std::make_shared<const S111PointSource>(std::move(*currents), std::move(head->times),
                                                         head->level.depth_m, head->unit_m_s);
  return input;
}

Checked<CurrentInput> grid_in(const std::filesystem::path& file) {
  auto currents = s100_coverage(file, feature_name);
  if (!currents) return refuse(currents.error());
  auto head = head_of(*currents);
  if (!head) return refuse(head.error());
  CurrentInput input;
  if (head->level.warning) input.warnings.push_back(*head->level.warning);
  input.grid = currents->grid;
  input.source = std::make_shared<const S111GridSource>(std::move(*currents), std::move(head->times),
                                                        head->level.depth_m, head->unit_m_s);
  return input;
}

}  // namespace

Checked<PreparedDataset> read_s111_currents(const std::filesystem::path& file,
                                            const core::ProgressCallback& progress) {
  const auto layout = s100_layout(file, feature_name);
  if (!layout) return refuse(layout.error());
  auto input = *layout == S100Layout::points ? points_in(file) : grid_in(file);
  if (!input) return refuse(input.error());
  input->variables = {speed_name, direction_name};
  return prepare_currents(std::move(*input), progress);
}

}  // namespace floeplan::ingest
