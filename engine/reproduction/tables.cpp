#include "engine/reproduction/tables.hpp"

#include <string>
#include <utility>

#include "engine/planning/currents/analytic_currents.hpp"
#include "engine/planning/optimal_control/optimal_control.hpp"
#include "engine/planning/refinement/refinement.hpp"
#include "engine/reproduction/case_search.hpp"

namespace floeplan::reproduction {
namespace {

constexpr double converged = 1e-7;
constexpr double product_default = 1e-4;

std::optional<double> seconds(const std::optional<planning::optimal_control::TimedWay>& way) {
  return way ? std::optional{way->duration().count()} : std::nullopt;
}

/// Makes the rows of one table: one current, one start, one goal.
template <motion::SlopedPlaneCurrent Current>
class Table {
 public:
  Table(const CaseGrid& grid, const Current& current, core::MetresPerSecond through_water)
      : water_{.grid = grid, .sectors = 3}, current_{current}, through_water_{through_water} {}

  void add_direct_drive(PrintedRow printed) {
    ReproducedRow row{.printed = std::move(printed)};
    row.ours_s = direct_s(converged);
    row.ours_at_default_tolerance_s = direct_s(product_default);
    direct_s_ = row.ours_s;
    rows_.push_back(std::move(row));
  }

  void add_optimal_control(PrintedRow printed) {
    constexpr std::size_t corridors = 3;
    const planning::optimal_control::Crossing crossing{start(), goal(), core::Seconds{0.0}, through_water_};
    const CaseSearch search{water_, current_, through_water_, product_default};
    const auto extremal =
        planning::optimal_control::find_extremal(crossing, current_, search.corridors(corridors));
    if (extremal) optimum_s_ = extremal->duration.count();
    ReproducedRow row{.printed = std::move(printed)};
    row.ours_s = optimum_s_;
    rows_.push_back(std::move(row));
  }

  void add(const PaperCase& each) {
    ReproducedRow row{.printed = each.printed};
    row.ours_s = seconds(CaseSearch{each.searched, current_, through_water_, converged}.fastest());
    row.ours_at_default_tolerance_s =
        seconds(CaseSearch{each.searched, current_, through_water_, product_default}.fastest());
    row.vertices = each.searched.graph().count_open_vertices();
    row.edges = each.searched.count_open_edges();
    rows_.push_back(std::move(row));
  }

  /// Adds the route of the 3-sector search, refined to this number of legs by the product's refinement.
  void add_refined(std::size_t legs) {
    const CaseSearch product{water_, current_, through_water_, product_default};
    ReproducedRow row{.printed = {.row = "refined, " + std::to_string(legs) + " legs",
                                  .remark = "the 3-sector route with its points moved off the grid"}};
    if (const auto found = product.fastest()) {
      planning::cost::Route way{found->points, std::vector<bool>(found->points.size(), false)};
      way.fixed.front() = way.fixed.back() = true;
      const planning::optimal_control::LegTimer leg = product.legs();
      const planning::cost::Itinerary start =
          planning::refinement::LegMeter{leg, {}}.timed(std::move(way), found->times.front()).value();
      const planning::cost::Itinerary refined =
          planning::refinement::refine_route(leg, start, {.most_legs = legs, .least_gain = 0.0}, {})
              .itinerary;
      const CaseSearch exact{water_, current_, through_water_, converged};
      row.ours_s = seconds(
          planning::optimal_control::time_way(refined.route.points, core::Seconds{0.0}, exact.legs()));
      row.ours_at_default_tolerance_s = refined.travel_time().count();
    }
    rows_.push_back(std::move(row));
  }

  /// All rows with their percentages.
  [[nodiscard]] std::vector<ReproducedRow> rows() const {
    std::vector<ReproducedRow> result = rows_;
    for (ReproducedRow& row : result) {
      if (!row.ours_s) continue;
      if (direct_s_) row.saving_pct = 100.0 * (*direct_s_ - *row.ours_s) / *direct_s_;
      if (optimum_s_) row.deviation_pct = 100.0 * (*row.ours_s - *optimum_s_) / *optimum_s_;
    }
    return result;
  }

 private:
  [[nodiscard]] geo::PlanePoint start() const { return water_.grid.point(water_.grid.start); }
  [[nodiscard]] geo::PlanePoint goal() const { return water_.grid.point(water_.grid.goal); }
  [[nodiscard]] std::optional<double> direct_s(double tolerance) const {
    const CaseSearch search{water_, current_, through_water_, tolerance};
    return seconds(planning::optimal_control::time_way({start(), goal()}, core::Seconds{0.0}, search.legs()));
  }

  GridCase water_;
  const Current& current_;
  core::MetresPerSecond through_water_;
  std::vector<ReproducedRow> rows_;
  std::optional<double> direct_s_;
  std::optional<double> optimum_s_;
};

}  // namespace

std::vector<ReproducedRow> reproduce_table_2() {
  const planning::currents::RiverCurrent river;
  const std::vector<PaperCase> cases = river_cases();
  Table table{cases.front().searched.grid, river, river_speed};
  table.add_direct_drive({.row = "direct drive",
                          .paper_s = 167.52,
                          .verified_s = 179.517,
                          .remark = "misprint: the paper's own 10.96 % gives 179.52"});
  table.add_optimal_control({.row = "optimal control", .paper_s = 161.79, .verified_s = 161.792});
  for (const PaperCase& each : cases) table.add(each);
  for (const std::size_t legs : {8, 10, 16}) table.add_refined(legs);
  return table.rows();
}

std::vector<ReproducedRow> reproduce_table_3() {
  const planning::currents::MeanderingJet jet;
  const std::vector<PaperCase> cases = jet_cases();
  Table table{cases.front().searched.grid, jet, jet_speed};
  table.add_direct_drive({.row = "direct drive", .remark = "not possible, as the paper says"});
  table.add_optimal_control({.row = "optimal control", .paper_s = 17.195, .verified_s = 17.159});
  for (const PaperCase& each : cases) table.add(each);
  for (const std::size_t legs : {12, 21, 42, 84}) table.add_refined(legs);
  return table.rows();
}

}  // namespace floeplan::reproduction
