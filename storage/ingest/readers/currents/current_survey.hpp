#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/core/progress.hpp"
#include "storage/ingest/grids/velocity_source.hpp"
#include "storage/ingest/readers/currents/zero_land.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// Facts found by reading every value of a source once.
struct CurrentSurvey {
  std::int64_t valid{};
  std::int64_t undeclared_fill{};
  FlagCount flagged{};
  bool everything_is_zero{true};
  std::shared_ptr<const ZeroLand> land;    // null: no land was written as still water
  std::optional<messages::Message> doubt;  // warning about a number that may mark missing values
};

/// Errors  a current or a wind faster than any that occurs; the file cannot be read to its end
[[nodiscard]] Checked<CurrentSurvey> survey(const VelocitySource& source, Moving what, bool states_unit,
                                            const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
