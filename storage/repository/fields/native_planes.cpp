#include "storage/repository/fields/native_planes.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/ocean/grids/cell_minima.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"

namespace floeplan::repository {

ocean::Bathymetry read_native_depths(sql::Connection& db, const NativeLayout& layout,
                                     const geo::BoundingBox& area, const ocean::HorizontalGrid& lattice,
                                     bool has_shoalest) {
  const MeshPart part = MeshBlocks{db}.around(layout.chunks.dataset_row, area);
  ocean::HorizontalGrid nodes = nodes_of_use(area, lattice, part.mesh);
  const ocean::MeshSampling sampling = sampling_of(part.mesh, nodes);
  PointReader reader{db, layout, part};
  const std::vector<float> depths_m = reader.read({"depth_m", 0, 0});
  const std::vector<float> around_m = has_shoalest ? reader.read({"shoalest_m", 0, 0}) : depths_m;
  std::vector<float> shoalest_m =
      is_one_place(area) ? sampling.least(around_m) : ocean::least_of_cells(part.mesh, nodes, around_m);
  return {std::move(nodes), sampling.apply(depths_m), std::move(shoalest_m)};
}

ocean::IceField read_native_ice(sql::Connection& db, const NativeLayout& layout, const geo::BoundingBox& area,
                                const ocean::HorizontalGrid& lattice, const AxisWindow& times,
                                bool has_thickness, const std::stop_token& stop) {
  const MeshPart part = MeshBlocks{db}.around(layout.chunks.dataset_row, area);
  const ocean::HorizontalGrid nodes = nodes_of_use(area, lattice, part.mesh);
  const ocean::MeshSampling sampling = sampling_of(part.mesh, nodes);
  PointReader reader{db, layout, part};
  const NodeRun steps = times.runs.front();
  const auto read = [&](const std::string& variable) {
    std::vector<float> all;
    all.reserve(steps.count * nodes.size());
    for (std::size_t time = steps.first; time < steps.first + steps.count && !stop.stop_requested(); ++time) {
      const std::vector<float> slice = sampling.apply(reader.read({variable, time, 0}));
      all.insert(all.end(), slice.begin(), slice.end());
    }
    all.resize(steps.count * nodes.size());  // of steps that were not read once it stopped
    return all;
  };
  return ocean::IceField{{.grid = nodes,
                          .times_s = times.nodes,
                          .concentration = read("concentration"),
                          .thickness_m = has_thickness ? read("thickness_m") : std::vector<float>{}}};
}

std::vector<float> read_native_series(sql::Connection& db, const NativeLayout& layout, geo::LonLat place,
                                      const std::string& variable, const AxisWindow& times) {
  const geo::BoundingBox here{place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
  const MeshPart part = MeshBlocks{db}.around(layout.chunks.dataset_row, here);
  const ocean::HorizontalGrid node{geo::GeographicFrame{}, ocean::Axis{{place.lon_deg}},
                                   ocean::Axis{{place.lat_deg}}};
  const ocean::MeshSampling sampling = sampling_of(part.mesh, node);
  PointReader reader{db, layout, part};
  const NodeRun steps = times.runs.front();
  std::vector<float> values;
  for (std::size_t time = steps.first; time < steps.first + steps.count; ++time)
    values.push_back(sampling.apply(reader.read({variable, time, 0})).front());
  return values;
}

}  // namespace floeplan::repository
