#include "api/codec/exports/map_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/documents/surfacing_document.hpp"
#include "api/codec/exports/svg_parts.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

constexpr double metres_per_degree = 111'195.0;  // of latitude, on a sphere of 6371 km
constexpr double margin_share = 0.12;            // margin around the route, as a share of the picture
constexpr double least_span_m = 2'000.0;         // smallest span shown, for very short routes
constexpr double least_berg = 4.0;               // smallest radius of an iceberg, to be seen on hatched ice
constexpr double finest_line = 0.7;              // shorter pieces of an outline are not visible

/// Longitudes and latitudes to picture units, true along the middle parallel.
class Frame {
 public:
  Frame(const planning::Plan& plan, double width, double height) : width_{width}, height_{height} {
    west_deg_ = plan.waypoints.front().place.lon_deg;
    double least_x = 0.0;
    double most_x = 0.0;
    double south = 90.0;
    double north = -90.0;
    for (const auto& waypoint : plan.waypoints) {
      const double x = geo::longitude_difference(west_deg_, waypoint.place.lon_deg);
      least_x = std::min(least_x, x);
      most_x = std::max(most_x, x);
      south = std::min(south, waypoint.place.lat_deg);
      north = std::max(north, waypoint.place.lat_deg);
    }
    middle_lon_deg_ = west_deg_ + 0.5 * (least_x + most_x);
    middle_lat_deg_ = 0.5 * (south + north);
    shrink_ = std::max(0.01, std::cos(middle_lat_deg_ * std::numbers::pi / 180.0));
    const double span_x_m = std::max(least_span_m, (most_x - least_x) * shrink_ * metres_per_degree);
    const double span_y_m = std::max(least_span_m, (north - south) * metres_per_degree);
    const double room = 1.0 - 2.0 * margin_share;
    units_per_m_ = std::min(room * width / span_x_m, room * height / span_y_m);
  }

  [[nodiscard]] MapPicture::Point at(geo::LonLat place) const {
    const double x_m =
        geo::longitude_difference(middle_lon_deg_, place.lon_deg) * shrink_ * metres_per_degree;
    const double y_m = (place.lat_deg - middle_lat_deg_) * metres_per_degree;
    return {0.5 * width_ + units_per_m_ * x_m, 0.5 * height_ - units_per_m_ * y_m};
  }
  [[nodiscard]] double units_per_m() const { return units_per_m_; }
  [[nodiscard]] double lon_deg(double x) const {
    return middle_lon_deg_ + (x - 0.5 * width_) / (units_per_m_ * shrink_ * metres_per_degree);
  }
  [[nodiscard]] double lat_deg(double y) const {
    return middle_lat_deg_ - (y - 0.5 * height_) / (units_per_m_ * metres_per_degree);
  }

 private:
  double width_;
  double height_;
  double west_deg_{};
  double middle_lon_deg_{};
  double middle_lat_deg_{};
  double shrink_{};
  double units_per_m_{};
};

geo::BoundingBox area_of(const Frame& frame, double width, double height) {
  const double west = frame.lon_deg(0.0);
  const double east = frame.lon_deg(width);
  const bool is_all_round = east - west >= 360.0;
  return {is_all_round ? -180.0 : geo::wrap_longitude(west), std::max(-90.0, frame.lat_deg(height)),
          is_all_round ? 180.0 : geo::wrap_longitude(east), std::min(90.0, frame.lat_deg(0.0))};
}

/// An outline without invisible details. Far corners are moved to just outside the frame.
std::vector<MapPicture::Point> outline(const geo::Ring& ring, const Frame& frame, double width,
                                       double height) {
  std::vector<MapPicture::Point> points;
  for (const geo::LonLat place : ring) {
    MapPicture::Point point = frame.at(place);
    point.x = std::clamp(point.x, -width, 2.0 * width);
    point.y = std::clamp(point.y, -height, 2.0 * height);
    if (points.empty() || std::hypot(point.x - points.back().x, point.y - points.back().y) >= finest_line)
      points.push_back(point);
  }
  return points.size() >= 3 ? points : std::vector<MapPicture::Point>{};
}

bool meets_frame(const std::vector<MapPicture::Point>& points, double width, double height) {
  const auto [left, right] = std::ranges::minmax(points, {}, &MapPicture::Point::x);
  const auto [top, bottom] = std::ranges::minmax(points, {}, &MapPicture::Point::y);
  return left.x < width && right.x > 0.0 && top.y < height && bottom.y > 0.0;
}

/// A round step that divides the span into about four parts.
double grid_step_deg(double span_deg) {
  for (const double step : {20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.25, 1.0 / 6.0, 0.1, 0.05, 1.0 / 60.0}) {
    if (span_deg / step >= 3.0) return step;
  }
  return 1.0 / 120.0;
}

std::string degrees_text(double degrees, char positive, char negative) {
  const auto minutes = static_cast<long>(std::lround(std::abs(degrees) * 60.0));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%ld %02ld' %c", minutes / 60, minutes % 60,
                degrees < 0.0 ? negative : positive);
  return text.data();
}

void add_grid(MapPicture& picture, const Frame& frame) {
  const double west = frame.lon_deg(0.0);
  const double east = frame.lon_deg(picture.width);
  const double south = frame.lat_deg(picture.height);
  const double north = frame.lat_deg(0.0);
  const double lon_step = grid_step_deg(east - west);
  for (double k = std::ceil(west / lon_step); k * lon_step <= east; k += 1.0) {
    const double x = frame.at({k * lon_step, south}).x;
    picture.grid.push_back({{x, 0.0}, {x, picture.height}});
    picture.grid_labels.push_back(
        {{x + 3.0, picture.height - 4.0}, degrees_text(geo::wrap_longitude(k * lon_step), 'E', 'W')});
  }
  const double lat_step = grid_step_deg(north - south);
  for (double k = std::ceil(south / lat_step); k * lat_step <= north; k += 1.0) {
    const double y = frame.at({west, k * lat_step}).y;
    picture.grid.push_back({{0.0, y}, {picture.width, y}});
    picture.grid_labels.push_back({{3.0, y - 3.0}, degrees_text(k * lat_step, 'N', 'S')});
  }
}

void add_scale(MapPicture& picture, const Frame& frame) {
  double length_m = 1.0;
  for (const double candidate : {1e6, 5e5, 2e5, 1e5, 5e4, 2e4, 1e4, 5e3, 2e3, 1e3, 500.0, 200.0, 100.0}) {
    length_m = candidate;
    if (candidate * frame.units_per_m() <= 0.25 * picture.width) break;
  }
  const double right = picture.width - 12.0;
  picture.scale = {{right - length_m * frame.units_per_m(), 16.0}, {right, 16.0}};
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), length_m >= 1000.0 ? "%.0f km" : "%.0f m",
                length_m >= 1000.0 ? length_m / 1000.0 : length_m);
  picture.scale_label = text.data();
}

std::string circle_text(const char* style, const MapPicture::Point& centre, double radius) {
  std::array<char, 96> circle{};
  std::snprintf(circle.data(), circle.size(), "<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n",
                style, centre.x, centre.y, radius);
  return circle.data();
}

std::string square_text(const char* style, const MapPicture::Point& centre) {
  std::array<char, 96> square{};
  std::snprintf(square.data(), square.size(),
                "<rect class=\"%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n", style,
                centre.x - 0.5 * closed_side, centre.y - 0.5 * closed_side, closed_side, closed_side);
  return square.data();
}

/// A position beside a point where a number covers no earlier number; the first choice if the map is too
/// crowded.
/// Accuracy  a digit is taken to be 8 units wide and 10 high, as in bold type of 11 points
MapPicture::Point free_spot(MapPicture::Point point, std::size_t digits, const MapPicture& picture) {
  constexpr double digit_width = 8.0;
  constexpr double digit_height = 10.0;
  const double text_width = digit_width * static_cast<double>(digits);
  const auto is_free = [&](MapPicture::Point at) {
    if (at.x < 0.0 || at.x + text_width > picture.width || at.y < digit_height || at.y > picture.height)
      return false;
    return std::ranges::none_of(picture.waypoints, [&](const MapPicture::Label& other) {
      const double other_width = digit_width * static_cast<double>(other.text.size());
      return at.x < other.at.x + other_width && other.at.x < at.x + text_width &&
             std::abs(at.y - other.at.y) < digit_height;
    });
  };
  const MapPicture::Point first{point.x + 5.0, point.y - 5.0};
  if (is_free(first)) return first;
  for (const double away : {5.0, 17.0, 29.0}) {
    const double right = point.x + away;
    const double left = point.x - away - text_width;
    const double middle = point.x - 0.5 * text_width;
    for (const MapPicture::Point at :
         {MapPicture::Point{right, point.y - away}, MapPicture::Point{right, point.y + 4.0},
          MapPicture::Point{right, point.y + away + digit_height}, MapPicture::Point{middle, point.y - away},
          MapPicture::Point{middle, point.y + away + digit_height}, MapPicture::Point{left, point.y - away},
          MapPicture::Point{left, point.y + 4.0}, MapPicture::Point{left, point.y + away + digit_height}}) {
      if (is_free(at)) return at;
    }
  }
  return first;
}

void add_ways_up(MapPicture& picture, const Frame& frame, const planning::SurfacingPlan& surfacing) {
  for (const auto& planned : surfacing.surfacings) picture.surfacings.push_back(frame.at(planned.place));
  for (const auto& escape : surfacing.escapes) {
    if (escape.way.size() < 2) continue;  // the vehicle may surface there
    auto& line = picture.escapes.emplace_back();
    for (const geo::LonLat place : escape.way) line.push_back(frame.at(place));
  }
}

MapPicture::Ice ice_of(const planning::Plan& plan, const SeaIce& ice, const Frame& frame, double width,
                       double height) {
  const auto concentration = [&](PicturePoint at) {
    return ice.concentration(
        {geo::wrap_longitude(frame.lon_deg(at.x)), std::clamp(frame.lat_deg(at.y), -90.0, 90.0)});
  };
  return {draw_ice(width, height, concentration, ice.limit), ice.limit, plan.departure};
}

}  // namespace

std::vector<std::vector<PicturePoint>> surfacing_arrow(PicturePoint centre) {
  constexpr double half = 3.5;
  constexpr double barb = 2.5;
  const PicturePoint tip{centre.x, centre.y - half};
  return {{{centre.x, centre.y + half}, tip},
          {{tip.x - barb, tip.y + barb}, tip, {tip.x + barb, tip.y + barb}}};
}

geo::BoundingBox map_area(const planning::Plan& plan, double width, double height) {
  return area_of(Frame{plan, width, height}, width, height);
}

MapPicture draw_map(const planning::Plan& plan, const std::vector<geo::Polygon>& land,
                    const std::vector<ocean::Iceberg>& icebergs, double width, double height,
                    const std::optional<SeaIce>& ice) {
  if (plan.waypoints.empty() || !(width > 0.0 && height > 0.0))
    throw std::invalid_argument{"draw_map: no waypoints or no room"};
  const Frame frame{plan, width, height};
  MapPicture picture;
  picture.width = width;
  picture.height = height;
  if (ice) picture.ice = ice_of(plan, *ice, frame, width, height);
  for (const geo::Polygon& polygon : land) {
    auto points = outline(polygon.outer, frame, width, height);
    if (!points.empty() && meets_frame(points, width, height)) picture.land.push_back(std::move(points));
  }
  add_grid(picture, frame);
  for (const ocean::Iceberg& iceberg : icebergs) {
    const double radius = 0.5 * ocean::safe_length(iceberg).value * frame.units_per_m();
    const MapPicture::Point centre = frame.at(iceberg.place);
    if (centre.x < 0.0 || centre.x > width || centre.y < 0.0 || centre.y > height) continue;
    picture.icebergs.push_back({centre, std::max(least_berg, radius)});
  }
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const MapPicture::Point point = frame.at(plan.waypoints[i].place);
    picture.route.push_back(point);
    const core::Seconds wait = plan.waypoints[i].wait;
    const std::string label =
        waypoint_label(i) + (wait.count() > 0.0 ? " hold " + core::hours_minutes(wait) : "");
    picture.waypoints.push_back({free_spot(point, label.size(), picture), label});
    const bool is_of_older_version = plan.surfacing && !plan.surfacing->below_ice;
    if (i > 0 && is_of_older_version && is_leg_below_ice(plan.surfacing, i))
      picture.below_ice.push_back({picture.route[i - 1], point});
    if (plan.surfacing && !plan.surfacing->waypoints.at(i).may_surface) picture.closed.push_back(point);
  }
  if (plan.surfacing) {
    for (const auto& stretch : plan.surfacing->below_ice.value_or(std::vector<planning::StretchBelowIce>{}))
      picture.below_ice.push_back({frame.at(stretch.from), frame.at(stretch.to)});
    add_ways_up(picture, frame, *plan.surfacing);
  }
  add_scale(picture, frame);
  return picture;
}

std::string svg(const MapPicture& picture) {
  std::string text = svg_head("sea", picture.width, picture.height);
  if (picture.ice) text += svg(picture.ice->marks);
  for (const auto& outline : picture.land)
    text += "<polygon class=\"land\" points=\"" + svg_points(outline) + "\"/>\n";
  for (const auto& line : picture.grid) text += svg_line(line, "grid");
  for (const auto& label : picture.grid_labels) text += svg_label(label, "small");
  for (const auto& disc : picture.icebergs) text += circle_text("ice", disc.centre, disc.radius);
  for (const auto& way : picture.escapes) text += svg_line(way, "casing") + svg_line(way, "escape");
  text += svg_line(picture.route, "casing") + svg_line(picture.route, "route");
  for (const auto& leg : picture.below_ice) text += svg_line(leg, "below");
  for (const auto& place : picture.closed) text += square_text("closed", place);
  for (const auto& place : picture.surfacings) {
    text += circle_text("surfacing", place, surfacing_radius);
    for (const auto& line : surfacing_arrow(place)) text += svg_line(line, "arrow");
  }
  for (const auto& label : picture.waypoints) text += svg_label(label, "number");
  text += svg_line(picture.scale, "scale");
  text += svg_label({{picture.scale.front().x, picture.scale.front().y - 4.0}, picture.scale_label}, "small");
  return text + "</svg>\n";
}

}  // namespace floeplan::codec
