#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/reproduction/grid_case.hpp"

namespace floeplan::reproduction {

/// A row of the paper's tables: the printed value and the verified one.
struct PrintedRow {
  std::string row;
  std::optional<double> paper_s{};     // as printed; empty: no such row, or printed as infinity
  std::optional<double> verified_s{};  // correct value, if the print is wrong or has too few digits
  std::optional<std::int64_t> paper_edges{};
  std::string remark{};  // about misprints
};

/// A row that is computed by a search on a grid.
struct PaperCase {
  PrintedRow printed;
  GridCase searched;
};

/// Speeds through the water: m/s in the river, dimensionless in the jet.
/// Source   Eichhorn 2009, below equation (1) and below equation (4)
inline constexpr core::MetresPerSecond river_speed{2.2};
inline constexpr core::MetresPerSecond jet_speed{0.5};

/// The grids of Table II: the river 300 m wide, from (0, 30) to (300, 30).
/// Source   Eichhorn 2009, Table II and the captions of Figures 5 to 7
[[nodiscard]] std::vector<PaperCase> river_cases();
/// The grids of Table III, and rows that the paper omits. The paper gives neither extents nor start and goal.
/// Ours are assumed, and their four times agree with the paper's within 0.3 %: x in [-10, 10], y in [-5, 5],
/// spacing 0.5, from (-8, -2) to (10, 1).
/// Source   Eichhorn 2009, Table III
[[nodiscard]] std::vector<PaperCase> jet_cases();

/// The case of the row with this name.
/// Errors   std::invalid_argument if there is none
[[nodiscard]] const PaperCase& find_case(const std::vector<PaperCase>& cases, const std::string& row);

}  // namespace floeplan::reproduction
