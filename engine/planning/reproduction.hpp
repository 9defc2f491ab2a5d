#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace floeplan::planning {

/// A row of one of the paper's tables beside our own number.
struct ReproducedRow {
  std::string row;                   // "direct drive", "optimal control", "1-sector", "frozen 1-sector", ...
  std::optional<double> paper_s;     // as printed; empty: the paper has no such row, or prints infinity
  std::optional<double> verified_s;  // the value that holds, where the print is wrong or lacks digits
  std::optional<double> ours_s;      // edges integrated to 1e-7; empty: no way
  std::optional<double> ours_at_default_tolerance_s;
  std::optional<std::int64_t> vertices;
  std::optional<std::int64_t> edges;
  std::optional<double> saving_pct;     // of time against direct drive; table 2 only
  std::optional<double> deviation_pct;  // from optimal control
  std::string remark;                   // what is known of misprints
};

/// Table II: crossing the river (equation 1), 300 m wide, V = 2.2 m/s, from (0, 30) to (300, 30).
/// Source  Eichhorn 2009, Table II; verified values by converged edge integration
[[nodiscard]] std::vector<ReproducedRow> reproduce_table_2();

/// Table III: the meandering jet (equations 2 to 4), V = 0.5, t0 = 0. The paper prints neither extents nor
/// start and goal; this is a stand-in whose four times come within 0.3 % of the paper's: x in [-10, 10], y in
/// [-5, 5], spacing 0.5, from
/// (-8, -2) to (10, 1).
/// Source  Eichhorn 2009, Table III
[[nodiscard]] std::vector<ReproducedRow> reproduce_table_3();

}  // namespace floeplan::planning
