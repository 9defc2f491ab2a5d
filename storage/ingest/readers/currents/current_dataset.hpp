#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/grids/velocity_source.hpp"
#include "storage/ingest/readers/currents/component_source.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// Currents, or wind, to be checked and stored.
struct CurrentInput {
  Moving what{Moving::sea};
  std::shared_ptr<const VelocitySource> source;
  std::optional<ocean::HorizontalGrid>
      grid;  // its nodes are the source's points; empty: the points are those of the mesh
  ocean::Mesh mesh;
  std::shared_ptr<const ComponentSource>
      components{};    // for a staggered grid: components at the points of the mesh; null: use the source
  std::string layout;  // layout of a mesh, in words
  std::vector<std::string> variables;
  bool states_unit{true};
  Messages warnings;
};

/// Reduces the input to one level, with this depth or without one.
void keep_level(CurrentInput& input, std::size_t level, std::optional<double> depth_m);

/// Reads the source twice: to check every value, then to write it. It is read slice by slice, so that memory
/// holds only a few slices. Every value is stored unchanged, at the source's own points and levels.
/// Errors   all values missing or zero; currents over 10 m/s, wind over 100 m/s; more values than this
///          program accepts
[[nodiscard]] Checked<PreparedDataset> prepare_currents(CurrentInput input,
                                                        const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
