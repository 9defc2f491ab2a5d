#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/reproduction/grid_case.hpp"

namespace floeplan::reproduction {

/// What the paper prints in a row of its tables, and what holds.
struct PrintedRow {
  std::string row;
  std::optional<double> paper_s{};     // as printed; empty: the paper has no such row, or prints infinity
  std::optional<double> verified_s{};  // the value that holds, where the print is wrong or lacks digits
  std::optional<std::int64_t> paper_edges{};
  std::string remark{};  // what is known of misprints
};

/// A row that a search on a grid gives.
struct PaperCase {
  PrintedRow printed;
  GridCase searched;
};

/// Speeds through the water, m/s in the river, without unit in the jet.
/// Source   Eichhorn 2009, below equation (1) and below equation (4)
inline constexpr core::MetresPerSecond river_speed{2.2};
inline constexpr core::MetresPerSecond jet_speed{0.5};

/// The grids of Table II: the river 300 m wide, from (0, 30) to (300, 30).
/// Source   Eichhorn 2009, Table II and the captions of Figures 5 to 7
[[nodiscard]] std::vector<PaperCase> river_cases();
/// The grids of Table III and rows that the paper leaves out. The paper prints neither extents nor start and
/// goal; this is a stand-in whose four times come within 0.3 % of the paper's: x in [-10, 10], y in [-5, 5],
/// spacing 0.5, from (-8, -2) to (10, 1).
/// Source   Eichhorn 2009, Table III
[[nodiscard]] std::vector<PaperCase> jet_cases();

/// The case of that row.
/// Errors   std::invalid_argument when there is none
[[nodiscard]] const PaperCase& find_case(const std::vector<PaperCase>& cases, const std::string& row);

}  // namespace floeplan::reproduction
