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

/// Currents, or wind, ready to be checked and stored.
struct CurrentInput {
  Moving what{Moving::sea};
  std::shared_ptr<const VelocitySource> source;
  std::optional<ocean::HorizontalGrid>
      grid;  // its nodes are the source's points; empty: those of the mesh are
  ocean::Mesh mesh;
  std::shared_ptr<const ComponentSource>
      components{};    // of a staggered grid: what lies at the points of the mesh; null: the source
  std::string layout;  // of a mesh, in words
  std::vector<std::string> variables;
  bool states_unit{true};
  Messages warnings;
};

/// Leaves one level of the input, at a depth or at none.
void keep_level(CurrentInput& input, std::size_t level, std::optional<double> depth_m);

/// Reads the source once to check every value and a second time to write it, slice by slice, so memory holds a few
/// slices whatever the file's size. Every value is kept as it is, at the source's own points and levels.
/// Errors   nothing but missing values; nothing but zeros; faster than 10 m/s, wind
///          than 100 m/s; more than this program accepts
[[nodiscard]] Checked<PreparedDataset> prepare_currents(CurrentInput input,
                                                        const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
