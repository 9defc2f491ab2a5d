#include "engine/reproduction/paper_cases.hpp"

#include <algorithm>
#include <stdexcept>

namespace floeplan::reproduction {
namespace {

/// 60 m of the river from bank to bank; start and goal are half-way along.
CaseGrid river_grid(double dx_m, double dy_m) {
  constexpr double width_m = 300.0;
  constexpr double height_m = 60.0;
  const int columns = static_cast<int>(width_m / dx_m);
  const int rows = static_cast<int>(height_m / dy_m);
  return {.low = {0.0, 0.0},
          .dx = dx_m,
          .dy = dy_m,
          .nx = columns + 1,
          .ny = rows + 1,
          .start = {0, rows / 2},
          .goal = {columns, rows / 2}};
}

const CaseGrid jet_grid{
    .low = {-10.0, -5.0}, .dx = 0.5, .dy = 0.5, .nx = 41, .ny = 21, .start = {4, 6}, .goal = {40, 12}};

PaperCase frozen(const std::string& row, const CaseGrid& grid, int sectors, const std::string& remark) {
  return {{.row = row, .remark = remark}, {.grid = grid, .sectors = sectors, .frozen = true}};
}

PaperCase with_obstacles(int sectors, double paper_s, double verified_s, std::int64_t paper_edges) {
  return {{.row = std::to_string(sectors) + "-sector with obstacles",
           .paper_s = paper_s,
           .verified_s = verified_s,
           .paper_edges = paper_edges,
           .remark = "obstacles of our own: the paper does not print where its own stand"},
          {.grid = jet_grid, .sectors = sectors, .obstacles = jet_obstacles()}};
}

}  // namespace

std::vector<PaperCase> river_cases() {
  const CaseGrid large = river_grid(10.0, 5.0);
  const std::string steady = "the river is steady: same as TVE";
  return {
      {{"large", 165.48, 165.484, 2964, ""}, {large, 1}},
      {{"medium", 165.48, 165.484, 11688, ""}, {river_grid(5.0, 2.5), 1}},
      {{"small", 165.47, 165.468, 72420, ""}, {river_grid(2.0, 1.0), 1}},
      {{"2:1", 165.48, 165.484, 2964, ""}, {large, 1}},
      {{"1:1", 176.33, 176.334, 5904, ""}, {river_grid(5.0, 5.0), 1}},
      {{"1:2", 179.52, 179.517, 3012, "equals direct drive"}, {river_grid(5.0, 10.0), 1}},
      {{"1-sector", 165.48, 165.484, 2964, ""}, {large, 1}},
      {{"2-sector", 162.79, 162.790, 5676, ""}, {large, 2}},
      {{"3-sector", 162.73, 162.362, 10612, "misprint: the paper's own 9.56 % and 0.35 % give 162.36"},
       {large, 3}},
      frozen("frozen 1-sector", large, 1, steady),
      frozen("frozen 2-sector", large, 2, steady),
      frozen("frozen 3-sector", large, 3, steady),
  };
}

std::vector<PaperCase> jet_cases() {
  const std::string no_gain = "no gain, as the paper says";
  const std::string closed = "the route found with the weights at departure is closed later";
  return {
      {{"1-sector", 19.623, 19.606, 6520, ""}, {jet_grid, 1}},
      {{"2-sector", 17.951, 18.006, 12680, ""}, {jet_grid, 2}},
      {{"3-sector", 17.719, 17.730, 24296, ""}, {jet_grid, 3}},
      {{.row = "4-sector", .verified_s = 17.730, .remark = no_gain}, {jet_grid, 4}},
      {{.row = "5-sector", .verified_s = 17.730, .remark = no_gain}, {jet_grid, 5}},
      with_obstacles(1, 23.094, 23.149, 5910),
      with_obstacles(2, 21.319, 21.035, 11195),
      with_obstacles(3, 20.903, 20.927, 20517),
      frozen("frozen 1-sector", jet_grid, 1, closed),
      frozen("frozen 2-sector", jet_grid, 2, closed),
      frozen("frozen 3-sector", jet_grid, 3, closed),
  };
}

const PaperCase& find_case(const std::vector<PaperCase>& cases, const std::string& row) {
  const auto found =
      std::ranges::find_if(cases, [&](const PaperCase& each) { return each.printed.row == row; });
  if (found == cases.end()) throw std::invalid_argument{"the paper has no case " + row};
  return *found;
}

}  // namespace floeplan::reproduction
