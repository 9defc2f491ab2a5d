#include "storage/repository/fields/native_currents.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/ocean/currents/level_columns.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "engine/ocean/grids/staggered_sampling.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::repository {
namespace {

using ocean::PointVelocities;
using Components = ocean::LevelColumns::Components;

/// Whether each point has one component of the current, along an axis of its own.
bool has_components_apart(sql::Connection& db, std::int64_t dataset_row) {
  sql::Statement query{
      db, "SELECT 1 FROM field_chunk WHERE dataset_row = ?1 AND variable = 'first_axis_rad' LIMIT 1"};
  query.bind(1, dataset_row);
  return query.step();
}

/// Reads the currents of a part of a mesh.
class VelocityReader {
 public:
  VelocityReader(sql::Connection& db, const NativeLayout& layout, const MeshPart& part)
      : points_{db, layout, part},
        mesh_{part.mesh},
        components_{has_components_apart(db, layout.chunks.dataset_row) ? Components::one
                                                                        : Components::both} {}

  [[nodiscard]] Components components() const { return components_; }

  /// The currents of one level. If each point has only one component, `north` is empty.
  [[nodiscard]] PointVelocities velocities(std::size_t time, std::size_t level) {
    if (components_ == Components::one) return {read({"component_m_s", time, level}), {}};
    PointVelocities slice{read({"u_m_s", time, level}), read({"v_m_s", time, level})};
    if (mesh_.in_faces) {
      fill_nodes_from_faces(mesh_, slice.east);
      fill_nodes_from_faces(mesh_, slice.north);
    }
    return slice;
  }

  [[nodiscard]] std::vector<float> level_depths(std::size_t time, std::size_t level) {
    return read({"level_depth_m", time, level});
  }

  [[nodiscard]] ocean::ComponentAxes axes() {
    return {read({"first_axis_rad", 0, 0}), read({"second_axis_rad", 0, 0})};
  }

 private:
  [[nodiscard]] std::vector<float> read(const SliceKey& slice) { return points_.read(slice); }

  PointReader points_;
  const ocean::Mesh& mesh_;
  Components components_;
};

/// Interpolates values at a model's points to the nodes of a lattice.
class NodeSampling {
 public:
  /// Errors  as refuse_overlapping_cells
  static NodeSampling of(const ocean::Mesh& mesh, const ocean::HorizontalGrid& nodes,
                         VelocityReader& reader) {
    if (reader.components() == Components::both) return NodeSampling{sampling_of(mesh, nodes)};
    auto found = ocean::StaggeredSampling::of(mesh, reader.axes(), nodes);
    if (!found) refuse_overlapping_cells();
    return NodeSampling{std::move(*found)};
  }

  [[nodiscard]] PointVelocities velocities(const PointVelocities& slice) const {
    if (const auto* apart = std::get_if<ocean::StaggeredSampling>(&sampling_))
      return apart->apply(slice.east);
    return std::get<ocean::MeshSampling>(sampling_).apply(slice);
  }

  /// Depths of a level at the nodes. If each point has only one component, first the depths for the points of
  /// the first component, then for the points of the second.
  [[nodiscard]] std::vector<float> depths(const std::vector<float>& level) const {
    if (const auto* apart = std::get_if<ocean::StaggeredSampling>(&sampling_)) {
      auto [first, second] = apart->apply_to_numbers(level);
      first.insert(first.end(), second.begin(), second.end());
      return first;
    }
    return std::get<ocean::MeshSampling>(sampling_).apply(level);
  }

 private:
  using Sampling = std::variant<ocean::MeshSampling, ocean::StaggeredSampling>;
  explicit NodeSampling(Sampling sampling) : sampling_{std::move(sampling)} {}

  Sampling sampling_;
};

/// The depths asked for, joined by those at which the levels lie between the first and the last of them.
std::vector<double> with_levels(const std::vector<double>& depths_m, const NativeLayout& layout,
                                const NodeRun& times, const NodeSampling& sampling, VelocityReader& reader) {
  std::vector<double> all_m = depths_m;
  for (std::size_t time = times.first; time < times.first + times.count; ++time) {
    for (std::size_t level = 0; level <= layout.bed_levels; ++level) {
      for (const float level_m : sampling.depths(reader.level_depths(time, level))) {
        const double depth_m = static_cast<double>(level_m);
        if (depth_m > depths_m.front() && depth_m < depths_m.back()) all_m.push_back(depth_m);
      }
    }
  }
  std::ranges::sort(all_m);
  all_m.erase(std::unique(all_m.begin(), all_m.end()), all_m.end());
  return all_m;
}

std::vector<PointVelocities> at_depths(const std::vector<double>& depths_m, std::size_t levels,
                                       std::size_t time, std::size_t points, VelocityReader& reader) {
  ocean::LevelColumns columns{depths_m, points, reader.components()};
  for (std::size_t level = 0; level < levels; ++level)
    columns.add(reader.velocities(time, level), reader.level_depths(time, level));
  return std::move(columns).down_to(reader.level_depths(time, levels));
}

void add_slice(const PointVelocities& slice, ocean::CurrentGrid::Samples& samples) {
  samples.u.insert(samples.u.end(), slice.east.begin(), slice.east.end());
  samples.v.insert(samples.v.end(), slice.north.begin(), slice.north.end());
}

}  // namespace

ocean::CurrentGrid read_native_currents(sql::Connection& db, const NativeLayout& layout,
                                        const NativeRequest& request, const std::stop_token& stop) {
  const MeshPart part = MeshBlocks{db}.around(layout.chunks.dataset_row, request.area);
  const ocean::HorizontalGrid lattice = nodes_of_use(request.area, request.lattice, part.mesh);
  VelocityReader reader{db, layout, part};
  const NodeSampling sampling = NodeSampling::of(part.mesh, lattice, reader);
  const NodeRun times = request.times.runs.front();
  ocean::CurrentGrid::Samples samples{
      .grid = lattice, .depths_m = std::nullopt, .times_s = request.times.nodes, .u = {}, .v = {}};
  std::vector<double> depths_m;
  if (request.depths) depths_m = request.depths->nodes.nodes();
  if (layout.bed_levels > 0 && is_one_place(request.area))
    depths_m = with_levels(depths_m, layout, times, sampling, reader);
  if (request.depths) samples.depths_m = ocean::Axis{depths_m};

  const std::size_t slices = times.count * std::max<std::size_t>(depths_m.size(), 1);
  samples.u.reserve(slices * lattice.size());
  samples.v.reserve(slices * lattice.size());
  const NodeRun levels = request.depths ? request.depths->runs.front() : NodeRun{0, 1};
  for (std::size_t time = times.first; time < times.first + times.count && !stop.stop_requested(); ++time) {
    if (layout.bed_levels > 0) {
      for (const PointVelocities& slice :
           at_depths(depths_m, layout.bed_levels, time, part.mesh.points.size(), reader))
        add_slice(sampling.velocities(slice), samples);
      continue;
    }
    for (std::size_t level = levels.first; level < levels.first + levels.count; ++level)
      add_slice(sampling.velocities(reader.velocities(time, level)), samples);
  }
  samples.u.resize(slices * lattice.size());  // pads slices that were not read because of a stop
  samples.v.resize(slices * lattice.size());
  return ocean::CurrentGrid{std::move(samples)};
}

}  // namespace floeplan::repository
