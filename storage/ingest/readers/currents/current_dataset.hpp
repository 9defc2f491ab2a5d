#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/grids/source_mesh.hpp"
#include "storage/ingest/grids/velocity_source.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// Currents, or wind, ready to be checked and stored.
struct CurrentInput {
  Moving what{Moving::sea};
  std::shared_ptr<const VelocitySource> source;
  std::optional<ocean::HorizontalGrid> grid;  // its nodes are the source's points; empty: they are resampled
  SourceMesh mesh;                            // of a source that is resampled
  std::string layout;                         // of a source that is resampled, in words
  std::vector<std::string> variables;
  bool states_unit{true};
  Messages warnings;
};

/// Reads the source once to check every value and a second time to write it, slice by slice, so memory holds a few
/// slices whatever the file's size. A source on any other layout than a regular grid is resampled; how far the stored
/// currents then differ from the source at its own points is among the warnings.
/// Errors   nothing but missing values; nothing but zeros; faster than 10 m/s, wind
///          than 100 m/s; more than this program accepts
[[nodiscard]] Checked<PreparedDataset> prepare_currents(CurrentInput input,
                                                        const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
