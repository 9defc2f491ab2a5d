#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/reproduction/paper_cases.hpp"

namespace floeplan::reproduction {

/// A row of one of the paper's tables, with our own value.
struct ReproducedRow {
  PrintedRow printed;
  std::optional<double> ours_s{};  // from edges integrated to 1e-7; empty: no route
  std::optional<double> ours_at_default_tolerance_s{};
  std::optional<std::int64_t> vertices{};
  std::optional<std::int64_t> edges{};
  std::optional<double> saving_pct{};     // time saved against the direct route; Table II only
  std::optional<double> deviation_pct{};  // from optimal control
};

/// Table II: crossing the river (equation 1).
/// Source   Eichhorn 2009, Table II; verified values by converged edge integration
[[nodiscard]] std::vector<ReproducedRow> reproduce_table_2();

/// Table III: the meandering jet (equations 2 to 4), with our assumptions for what the paper does not give.
/// Source   Eichhorn 2009, Table III; verified values by converged edge integration and by collocation
[[nodiscard]] std::vector<ReproducedRow> reproduce_table_3();

}  // namespace floeplan::reproduction
