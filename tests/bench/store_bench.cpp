#include <gdal_priv.h>
#include <gdal_utils.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/ocean/grids/mesh_lattice.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"
#include "storage/repository/store/migrations.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/child_usage.hpp"
#include "tests/bench/ocean_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::bench {
namespace {

namespace fs = std::filesystem;

constexpr double megabyte = 1e6;
constexpr std::size_t edge = 128;  // nodes on each side of the area that is read

/// The shape of a file of about a gigabyte, whatever its number type.
OceanShape shape_of(Numbers numbers) {
  return {.times = numbers == Numbers::full ? 24U : 48U, .depths = 9, .rows = 720, .columns = 840};
}

double megabytes(const fs::path& file) { return static_cast<double>(fs::file_size(file)) / megabyte; }

/// Converts a NetCDF file to a compressed one with GDAL.
void translate(const fs::path& from, const fs::path& to) {
  ingest::register_drivers();
  const GDALDatasetUniquePtr source{GDALDataset::Open(from.c_str(), GDAL_OF_MULTIDIM_RASTER)};
  CPLStringList arguments;
  for (const char* argument : {"-of", "netCDF", "-co", "ARRAY:COMPRESS=DEFLATE"})
    arguments.AddString(argument);
  auto* const options = GDALMultiDimTranslateOptionsNew(arguments.List(), nullptr);
  std::array<GDALDatasetH, 1> sources{GDALDataset::ToHandle(source.get())};
  GDALDatasetH target =
      source ? GDALMultiDimTranslate(to.c_str(), nullptr, 1, sources.data(), options, nullptr) : nullptr;
  GDALMultiDimTranslateOptionsFree(options);
  if (target == nullptr) throw std::runtime_error{"GDAL did not translate the file"};
  GDALClose(target);
}

void ingest_into(const fs::path& store, const fs::path& file) {
  auto db = repository::open_store(store);
  const auto reports =
      ingest::guarded_ingest(db, {.program = "/proc/self/exe", .staging = store / "incoming"}, {file}, {},
                             core::from_unix_seconds(1.8e9), {}, {}, {});
  if (reports.front().status != ingest::IngestStatus::stored)
    throw std::runtime_error{"the file was not stored"};
}

/// The part that is read from both files: an area in the middle, half the times, all depths.
struct Part {
  std::array<GUInt64, 4> first{};
  std::array<std::size_t, 4> count{};

  [[nodiscard]] std::size_t size() const { return count[0] * count[1] * count[2] * count[3]; }
};

Part part_of(const OceanShape& shape) {
  return {{shape.times / 4, 0, (shape.rows - edge) / 2, (shape.columns - edge) / 2},
          {shape.times / 2, shape.depths, edge, edge}};
}

void read_with_gdal(const fs::path& file, const Part& part) {
  const GDALDatasetUniquePtr dataset{GDALDataset::Open(file.c_str(), GDAL_OF_MULTIDIM_RASTER)};
  std::vector<float> values(part.size());
  for (const char* name : {"uo", "vo"}) {
    const auto array = dataset->GetRootGroup()->OpenMDArray(name)->GetUnscaled();
    if (!array->Read(part.first.data(), part.count.data(), nullptr, nullptr,
                     GDALExtendedDataType::Create(GDT_Float32), values.data()))
      throw std::runtime_error{"GDAL did not read the part of the file"};
  }
}

void read_from_store(const fs::path& store, const Part& part) {
  auto db = repository::open_store(store);
  const auto dataset = repository::DatasetRepository{db}.list().front();
  const repository::FieldRepository fields{db};
  const auto shape = fields.shape(dataset.id).value();
  const auto inside = [&](const ocean::Axis& axis,
                          std::size_t dimension) {  // between the outermost nodes and the next ones
    const auto first = static_cast<std::size_t>(part.first.at(dimension));
    const std::size_t last = first + part.count.at(dimension) - 1;
    return std::pair{0.5 * (axis[first] + axis[first + 1]), 0.5 * (axis[last - 1] + axis[last])};
  };
  const auto [south, north] = inside(shape.grid.y(), 2);
  const auto [west, east] = inside(shape.grid.x(), 3);
  const ocean::Axis& times_s = shape.times_s.value();
  const auto last = part.first[0] + part.count[0] - 1;
  const repository::Period period{core::from_unix_seconds(times_s[part.first[0]]),
                                  core::from_unix_seconds(times_s[last])};
  const auto read = fields.load_currents(dataset.id, {west, south, east, north}, period, std::nullopt);
  if (!read || read->samples().grid.size() != part.count[2] * part.count[3] ||
      read->times_s().size() != part.count[0])
    throw std::runtime_error{"another part of the store was read"};
}

Row with_target(Row row, double least_ratio, std::string target) {
  row.gauge = Gauge::comparator;
  row.meets_target = row.ratio >= least_ratio;
  row.target = std::move(target);
  return row;
}

std::vector<Row> rows_for(Numbers numbers, const std::string& called) {
  const support::TemporaryFolder folder;
  const OceanShape shape = shape_of(numbers);
  const fs::path file = folder.path() / "ocean.nc";
  const fs::path deflated = folder.path() / "deflated.nc";
  const fs::path store = folder.path() / "store";
  usage_of([&] { write_ocean(file, shape, numbers); });
  const ChildUsage translated = usage_of([&] { translate(file, deflated); });
  const ChildUsage ingested = usage_of([&] { ingest_into(store, file); });

  ingest::register_drivers();
  const Part part = part_of(shape);
  const double ours_s = least_seconds(3, [&] { read_from_store(store, part); });
  const double theirs_s = least_seconds(3, [&] { read_with_gdal(deflated, part); });
  const double plain_s = least_seconds(3, [&] { read_with_gdal(file, part); });
  Row memory{.what = called + ": memory of the ingest",
             .unit = "MB",
             .ours = ingested.largest_mb,
             .comparator = "",
             .comparator_value = 0.0,
             .ratio = 0.0};
  memory.meets_target = memory.ours < 512.0;
  memory.target = "< 512 MB";
  return {
      with_target(more_is_better(called + ": ingest", "MB/s", megabytes(file) / ingested.cpu_s,
                                 "GDAL's translation to deflated NetCDF", megabytes(file) / translated.cpu_s),
                  0.8, "at least 0.8 of its rate"),
      with_target(less_is_better(called + ": size of the store", "MB", megabytes(store / "floeplan.sqlite"),
                                 "deflated NetCDF", megabytes(deflated)),
                  1.0 / 1.2, "at most 1.2 times its size"),
      with_target(less_is_better(called + ": read an area and period", "ms", 1e3 * ours_s,
                                 "GDAL, from the deflated NetCDF", 1e3 * theirs_s),
                  5.0, "at least 5 times as fast"),
      less_is_better(called + ": read an area and period", "ms", 1e3 * ours_s,
                     "GDAL, from the NetCDF without compression", 1e3 * plain_s),
      memory};
}

/// A mesh of a million points in rows, joined to triangles, over ten degrees of longitude by five of
/// latitude.
ocean::Mesh million_points() {
  constexpr std::uint32_t side = 1000;
  ocean::Mesh mesh;
  for (std::uint32_t row = 0; row < side; ++row)
    for (std::uint32_t column = 0; column < side; ++column)
      mesh.points.push_back({-60.0 + 0.01 * (column + 0.3 * (row % 2)), 62.0 + 0.005 * row});
  for (std::uint32_t row = 0; row + 1 < side; ++row) {
    for (std::uint32_t column = 0; column + 1 < side; ++column) {
      const std::uint32_t a = row * side + column;
      mesh.cells.push_back({a, a + 1, a + side, a + side});
      mesh.cells.push_back({a + 1, a + side + 1, a + side, a + side});
    }
  }
  return mesh;
}

/// Stores currents of one time in a new store; `fields` creates the grid or the mesh of the dataset.
template <class Create>
void store_currents(const fs::path& store, const repository::DatasetId& id, const std::vector<float>& speeds,
                    const Create& create) {
  auto db = repository::open_store(store);
  repository::Dataset dataset;
  dataset.id = id;
  dataset.kind = repository::DatasetKind::currents;
  dataset.name = id.value;
  repository::DatasetRepository{db}.insert(dataset);
  repository::FieldRepository fields{db};
  create(fields);
  for (const char* component : {"u_m_s", "v_m_s"}) fields.write_slice(id, component, 0, 0, speeds);
}

/// The least time to read all currents of a store of `store_currents`, as a plan reads them.
double seconds_to_read_all(const fs::path& store, const repository::DatasetId& id) {
  return least_seconds(3, [&] {
    auto db = repository::open_store(store);
    const auto read = repository::FieldRepository{db}.load_currents(id, {-61.0, 61.0, -49.0, 68.0},
                                                                    std::nullopt, std::nullopt);
    if (!read || read->samples().grid.size() < 500'000) throw std::runtime_error{"not all was read"};
  });
}

/// The reading of a million nodes at one time, of a mesh and of a regular grid over the same area, from the store to the
/// grid that a plan uses.
std::vector<Row> rows_of_a_million_nodes() {
  const repository::DatasetId id{"currents"};
  const support::TemporaryFolder meshes;
  const ocean::Mesh mesh = repository::in_blocks(million_points()).mesh;
  std::vector<float> speeds;
  for (const geo::LonLat point : mesh.points) speeds.push_back(static_cast<float>(std::sin(point.lon_deg)));
  store_currents(meshes.path(), id, speeds, [&](repository::FieldRepository& fields) {
    fields.create(id, {ocean::lattice_for(mesh).value(), std::nullopt, ocean::Axis{{1.8e9}}}, {mesh, 0});
  });
  const double mesh_s = seconds_to_read_all(meshes.path(), id);

  const support::TemporaryFolder grids;
  std::vector<double> lons;
  std::vector<double> lats;
  for (int i = 0; i < 1000; ++i) {
    lons.push_back(-60.0 + 0.01 * i);
    lats.push_back(62.0 + 0.005 * i);
  }
  speeds.clear();
  for (std::size_t row = 0; row < lats.size(); ++row)
    for (const double lon_deg : lons) speeds.push_back(static_cast<float>(std::sin(lon_deg)));
  store_currents(grids.path(), id, speeds, [&](repository::FieldRepository& fields) {
    fields.create(
        id,
        {{geo::GeographicFrame{}, ocean::Axis{lons}, ocean::Axis{lats}}, std::nullopt, ocean::Axis{{1.8e9}}});
  });
  const double grid_s = seconds_to_read_all(grids.path(), id);

  Row of_mesh{.what = "a mesh of a million nodes: read and interpolate all",
              .unit = "ms",
              .ours = 1e3 * mesh_s,
              .comparator = "",
              .comparator_value = 0.0,
              .ratio = 0.0};
  of_mesh.meets_target = mesh_s < 1.0;
  of_mesh.target = "< 1000 ms";
  return {of_mesh,
          gauged_by(Gauge::time, less_is_better("a regular grid of a million nodes: read all", "ms",
                                                1e3 * grid_s, "the mesh of as many nodes", 1e3 * mesh_s))};
}

}  // namespace

std::vector<Row> store_rows() {
  std::vector<Row> rows = rows_for(Numbers::full, "1 GB of float32");
  for (Row& row : rows_for(Numbers::packed, "1 GB of packed int16")) rows.push_back(std::move(row));
  for (Row& row : rows_of_a_million_nodes()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace floeplan::bench
