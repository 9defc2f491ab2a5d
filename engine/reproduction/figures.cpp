#include <cstdio>

#include "engine/planning/currents/analytic_currents.hpp"
#include "engine/planning/optimal_control/optimal_control.hpp"
#include "engine/reproduction/case_search.hpp"
#include "engine/reproduction/figure.hpp"
#include "engine/reproduction/paper_cases.hpp"

namespace floeplan::reproduction {
namespace {

constexpr double tolerance = 1e-4;
constexpr const char* optimum_name = "optimal control";

// Colours that people with any colour vision can tell apart: Okabe and Ito 2008, Color Universal Design.
constexpr const char* black = "#000000";
constexpr const char* orange = "#e69f00";
constexpr const char* green = "#009e73";
constexpr const char* blue = "#0072b2";

/// A row of the tables, and the colour of its path.
struct Shown {
  std::string row;
  std::string colour;
};

/// One of the paper's two currents with its cases.
template <motion::SlopedPlaneCurrent Current>
struct Water {
  Current current;
  core::MetresPerSecond through_water;
  std::vector<PaperCase> cases;

  [[nodiscard]] FigurePath path(const Shown& shown) const {
    const GridCase& searched = find_case(cases, shown.row).searched;
    const auto way = CaseSearch{searched, current, through_water, tolerance}.fastest();
    return {.name = shown.row,
            .travel_time = way.value().duration().count(),
            .colour = shown.colour,
            .points = way->points};
  }

  [[nodiscard]] FigurePath optimum() const {
    constexpr std::size_t corridors = 3;
    const GridCase& searched = find_case(cases, "3-sector").searched;
    const CaseSearch search{searched, current, through_water, tolerance};
    const planning::optimal_control::Crossing crossing{searched.grid.point(searched.grid.start),
                                                       searched.grid.point(searched.grid.goal),
                                                       core::Seconds{0.0}, through_water};
    const auto extremal =
        planning::optimal_control::find_extremal(crossing, current, search.corridors(corridors));
    FigurePath path{.name = optimum_name,
                    .travel_time = extremal.value().duration.count(),
                    .colour = black,
                    .dashed = true,
                    .points = {}};
    for (const planning::optimal_control::SteeredPoint& at : extremal->points)
      path.points.push_back({at.x_m, at.y_m});
    return path;
  }

  [[nodiscard]] std::vector<FigurePath> paths(const std::vector<Shown>& rows) const {
    std::vector<FigurePath> result;
    result.reserve(rows.size());
    for (const Shown& row : rows) result.push_back(path(row));
    return result;
  }

  /// Arrows of the current on a lattice, at least half a step from the edges.
  [[nodiscard]] std::vector<FigureArrow> arrows(const Figure& figure, double dx, double dy,
                                                double time) const {
    std::vector<FigureArrow> result;
    for (double y = figure.y.low + 0.5 * dy; y < figure.y.high; y += dy) {
      for (double x = figure.x.low + 0.5 * dx; x < figure.x.high; x += dx) {
        if (const auto c = current(geo::PlanePoint{x, y}, core::Seconds{time})) {
          result.push_back({{x, y}, *c});
        }
      }
    }
    return result;
  }
};

Figure river_figure(int number, const std::string& title,
                    const Water<planning::currents::RiverCurrent>& river, const FigurePath& optimum,
                    const std::vector<Shown>& rows) {
  Figure figure{.number = number,
                .title = title,
                .x = {"x in m", 0.0, 300.0, 50.0, 750.0},
                .y = {"y in m (drawn 2:1)", 0.0, 60.0, 10.0, 300.0},
                .start = {0.0, 30.0},
                .goal = {300.0, 30.0},
                .unit_m = 1.0,
                .time_unit = " s",
                .speed_unit = " m/s",
                .pixels_per_speed = 20.0,
                .panels = {}};
  FigurePanel panel{.title = {},
                    .arrows = river.arrows(figure, 25.0, 10.0, 0.0),
                    .obstacles = {},
                    .paths = river.paths(rows),
                    .vehicle = {}};
  panel.paths.push_back(optimum);
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure jet_figure(int number, const std::string& title, double width_pixels) {
  return {.number = number,
          .title = title,
          .x = {"x", -10.0, 10.0, 2.0, width_pixels},
          .y = {"y", -5.0, 5.0, 1.0, 0.5 * width_pixels},
          .start = {-8.0, -2.0},
          .goal = {10.0, 1.0},
          .unit_m = 1000.0,
          .time_unit = {},
          .speed_unit = {},
          .pixels_per_speed = width_pixels / 24.0,
          .panels = {}};
}

/// `path` with new points: the points of `way` that are reached before `time`, and the place on `way` at
/// `time`.
FigurePath until(const FigurePath& path, const planning::optimal_control::TimedWay& way, core::Seconds time) {
  FigurePath result = path;
  result.points.clear();
  for (std::size_t i = 0; i < way.points.size() && way.times[i] < time; ++i) {
    result.points.push_back(way.points[i]);
  }
  result.points.push_back(way.at(time));
  return result;
}

Figure time_sequence(const Water<planning::currents::MeanderingJet>& jet) {
  constexpr int panels = 6;
  Figure figure = jet_figure(8, "Figure 8: the route on the 3-sector grid at several times", 460.0);
  figure.panels_in_a_row = 2;
  const GridCase& searched = find_case(jet.cases, "3-sector").searched;
  const auto way = CaseSearch{searched, jet.current, jet.through_water, tolerance}.fastest().value();
  const FigurePath path{
      .name = "3-sector", .travel_time = way.duration().count(), .colour = blue, .points = way.points};
  for (int i = 0; i < panels; ++i) {
    const core::Seconds time = static_cast<double>(i) / (panels - 1) * way.duration();
    char title[40];
    std::snprintf(title, sizeof title, "t = %.2f", time.count());
    figure.panels.push_back({.title = title,
                             .arrows = jet.arrows(figure, 1.0, 1.0, time.count()),
                             .obstacles = {},
                             .paths = {until(path, way, time)},
                             .vehicle = way.at(time)});
  }
  return figure;
}

/// A figure of all paths over the current at one time, half-way.
Figure comparison(const Figure& blank, const Water<planning::currents::MeanderingJet>& jet,
                  std::vector<FigurePath> paths, const std::vector<Obstacle>& obstacles) {
  constexpr double half_way = 8.5;
  Figure figure = blank;
  figure.panels.push_back({.title = "current at t = 8.5",
                           .arrows = jet.arrows(figure, 0.8, 0.8, half_way),
                           .obstacles = obstacles,
                           .paths = std::move(paths),
                           .vehicle = {}});
  return figure;
}

}  // namespace

std::vector<Figure> reproduce_figures() {
  const Water<planning::currents::RiverCurrent> river{{}, river_speed, river_cases()};
  const FigurePath over_the_river = river.optimum();
  std::vector<Figure> figures;
  figures.push_back(river_figure(5, "Figure 5: one aspect ratio, three grid sizes", river, over_the_river,
                                 {{"large", orange}, {"medium", green}, {"small", blue}}));
  figures.push_back(river_figure(6, "Figure 6: three aspect ratios, 1-sector grid", river, over_the_river,
                                 {{"2:1", orange}, {"1:1", green}, {"1:2", blue}}));
  figures.push_back(river_figure(7, "Figure 7: three grid structures", river, over_the_river,
                                 {{"1-sector", orange}, {"2-sector", green}, {"3-sector", blue}}));

  const Water<planning::currents::MeanderingJet> jet{{}, jet_speed, jet_cases()};
  figures.push_back(time_sequence(jet));
  std::vector<FigurePath> open = jet.paths({{"1-sector", orange}, {"2-sector", green}, {"3-sector", blue}});
  open.push_back(jet.optimum());
  figures.push_back(
      comparison(jet_figure(9, "Figure 9: the jet by three grid structures and by optimal control", 860.0),
                 jet, std::move(open), {}));
  figures.push_back(comparison(jet_figure(10, "Figure 10: the jet with obstacles (of our own)", 860.0), jet,
                               jet.paths({{"1-sector with obstacles", orange},
                                          {"2-sector with obstacles", green},
                                          {"3-sector with obstacles", blue}}),
                               jet_obstacles()));
  return figures;
}

}  // namespace floeplan::reproduction
