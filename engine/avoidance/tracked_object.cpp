#include "engine/avoidance/tracked_object.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/avoidance/echo_confirmation.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double neighbourhood_m = 15.0;    // cells within it define the line through the surface
constexpr double straightness = 3.0;        // least ratio of the cells' variances along and across the line
constexpr double surface_sigma_m = 2.0;     // roughness of a berg around the line through its surface
constexpr double independent_echoes = 4.0;  // per ping: errors of adjacent beams are correlated
constexpr double drift_walk_m2_s3 = 1e-6;   // (0.01 m/s)^2 in 100 s
constexpr std::uint16_t settled_hits = 6;   // then a cell's place is fixed, and the drift is measured by it
constexpr double join_m = 25.0;             // a surface this near belongs to the same body
constexpr double past_cell_m = 15.0;        // an echo this far behind a cell shows that it is gone

double squared(double x) { return x * x; }

double squared_distance(geo::PlanePoint a, geo::PlanePoint b) {
  return squared(a.x_m - b.x_m) + squared(a.y_m - b.y_m);
}

/// Greater of the two eigenvalues of the symmetric matrix (a, b; b, d).
double greater_eigenvalue(double a, double b, double d) {
  return 0.5 * (a + d) + std::hypot(0.5 * (a - d), b);
}

/// The line through the cells around an echo.
class LocalLine {
 public:
  void add(geo::PlanePoint p) {
    ++count_;
    x_ += p.x_m;
    y_ += p.y_m;
    xx_ += p.x_m * p.x_m;
    xy_ += p.x_m * p.y_m;
    yy_ += p.y_m * p.y_m;
  }

  struct Fit {
    double normal_x;
    double normal_y;
    double residual_m;  // distance of the echo from the line, along the normal
  };
  /// The line through the cells, relative to an echo at (0, 0); empty if the cells are not on a line.
  [[nodiscard]] std::optional<Fit> fit() const {
    if (count_ < 3) return std::nullopt;
    const double n = count_;
    const double mean_x = x_ / n;
    const double mean_y = y_ / n;
    const double a = xx_ / n - mean_x * mean_x;
    const double b = xy_ / n - mean_x * mean_y;
    const double d = yy_ / n - mean_y * mean_y;
    const double along = greater_eigenvalue(a, b, d);
    const double across = a + d - along;
    if (!(along > straightness * std::max(across, 1.0))) return std::nullopt;
    const double direction = 0.5 * std::atan2(2.0 * b, a - d);
    const Fit line{-std::sin(direction), std::cos(direction), 0.0};
    return Fit{line.normal_x, line.normal_y, -(line.normal_x * mean_x + line.normal_y * mean_y)};
  }

 private:
  int count_{};
  double x_{}, y_{}, xx_{}, xy_{}, yy_{};
};

}  // namespace

TrackedObject::TrackedObject(std::uint32_t id, const Echo& first, double now_s,
                             core::MetresPerSecond drift_sigma)
    : id_{id}, state_{first.place.x_m, first.place.y_m, 0.0, 0.0}, now_s_{now_s}, seen_s_{now_s} {
  covariance_[0][0] = covariance_[1][1] = 1.0;  // a metre: the error of the first echo
  covariance_[2][2] = covariance_[3][3] = squared(drift_sigma.value);
}

void TrackedObject::advance(double now_s) {
  const double dt = now_s - now_s_;
  if (!(dt > 0.0)) return;
  now_s_ = now_s;
  state_[0] += dt * state_[2];
  state_[1] += dt * state_[3];
  for (std::size_t row : {0U, 1U}) {  // F P, F = (1, dt; 0, 1) for each axis
    for (std::size_t column = 0; column < 4; ++column)
      covariance_[row][column] += dt * covariance_[row + 2][column];
  }
  for (std::size_t column : {0U, 1U}) {  // and (F P) F^T
    for (std::size_t row = 0; row < 4; ++row) covariance_[row][column] += dt * covariance_[row][column + 2];
  }
  for (std::size_t axis : {0U, 1U}) {
    covariance_[axis][axis] += drift_walk_m2_s3 * dt * dt * dt / 3.0;
    covariance_[axis][axis + 2] += drift_walk_m2_s3 * dt * dt / 2.0;
    covariance_[axis + 2][axis] += drift_walk_m2_s3 * dt * dt / 2.0;
    covariance_[axis + 2][axis + 2] += drift_walk_m2_s3 * dt;
  }
}

TrackedObject::Match TrackedObject::take(const Echo& echo, const SonarView& sonar) {
  const geo::PlanePoint seen{echo.place.x_m - state_[0], echo.place.y_m - state_[1]};
  if (seen.x_m < low_.x_m - join_m || seen.x_m > high_.x_m + join_m || seen.y_m < low_.y_m - join_m ||
      seen.y_m > high_.y_m + join_m) {
    return Match::none;
  }
  SurfaceCell* nearest = nullptr;
  double nearest_m2 = std::numeric_limits<double>::infinity();
  double any_m2 = nearest_m2;
  LocalLine line;
  for (std::size_t i = 0; i < size_; ++i) {
    SurfaceCell& cell = cells_[i];
    const double apart_m2 = squared_distance(cell.offset, seen);
    any_m2 = std::min(any_m2, apart_m2);
    if (std::abs(cell.depth_m - echo.depth_m) > SurfaceCell::size_m) continue;
    if (apart_m2 < squared(neighbourhood_m))
      line.add({cell.offset.x_m - seen.x_m, cell.offset.y_m - seen.y_m});
    if (apart_m2 >= nearest_m2) continue;
    nearest_m2 = apart_m2;
    nearest = &cell;
  }
  if (any_m2 > squared(join_m)) return Match::none;

  if (const auto fit = line.fit(); fit && std::abs(fit->residual_m) < neighbourhood_m) {
    const double weight = 1.0 / (squared(surface_sigma_m) + squared(sonar.range_sigma.value) +
                                 squared(sonar.bearing_sigma.value * echo.range_m));
    information_[0] += weight * fit->normal_x * fit->normal_x;
    information_[1] += weight * fit->normal_x * fit->normal_y;
    information_[2] += weight * fit->normal_y * fit->normal_y;
    pull_[0] += weight * fit->normal_x * fit->residual_m;
    pull_[1] += weight * fit->normal_y * fit->residual_m;
    ++echoes_;
  }
  if (nearest == nullptr || nearest_m2 > squared(SurfaceCell::size_m)) return Match::near_by;
  if (nearest->hits < settled_hits) {
    const double share = 1.0 / (nearest->hits + 1);
    nearest->offset.x_m += share * (seen.x_m - nearest->offset.x_m);
    nearest->offset.y_m += share * (seen.y_m - nearest->offset.y_m);
    nearest->depth_m += share * (echo.depth_m - nearest->depth_m);
    measure_box();
  }
  nearest->deepest_m = std::min(nearest->deepest_m, echo.deepest_m);
  if (nearest->hits < std::numeric_limits<std::uint16_t>::max()) ++nearest->hits;
  nearest->seen_s = now_s_;
  seen_s_ = now_s_;
  return Match::on_surface;
}

void TrackedObject::correct() {
  if (echoes_ == 0) return;
  const double share = std::min(1.0, independent_echoes / echoes_);
  const double a = share * information_[0];
  const double b = share * information_[1];
  const double d = share * information_[2];
  const double pull_x = share * pull_[0];
  const double pull_y = share * pull_[1];
  information_ = {};
  pull_ = {};
  echoes_ = 0;

  // x += P_o (A P_oo + 1)^-1 b,  P -= P_o (A P_oo + 1)^-1 A P_o^T: Kalman's update in information form
  // (matrix A, vector b). It needs no inverse of A, which is singular if only one direction was measured.
  const auto& p = covariance_;
  const double m00 = a * p[0][0] + b * p[1][0] + 1.0;
  const double m01 = a * p[0][1] + b * p[1][1];
  const double m10 = b * p[0][0] + d * p[1][0];
  const double m11 = b * p[0][1] + d * p[1][1] + 1.0;
  const double determinant = m00 * m11 - m01 * m10;
  const double i00 = m11 / determinant;
  const double i01 = -m01 / determinant;
  const double i10 = -m10 / determinant;
  const double i11 = m00 / determinant;
  const double s00 = i00 * a + i01 * b;
  const double s01 = i00 * b + i01 * d;
  const double s10 = i10 * a + i11 * b;
  const double s11 = i10 * b + i11 * d;
  const double u0 = i00 * pull_x + i01 * pull_y;
  const double u1 = i10 * pull_x + i11 * pull_y;
  const auto before = covariance_;
  for (std::size_t row = 0; row < 4; ++row) {
    state_[row] += before[row][0] * u0 + before[row][1] * u1;
    const double g0 = before[row][0] * s00 + before[row][1] * s10;
    const double g1 = before[row][0] * s01 + before[row][1] * s11;
    for (std::size_t column = 0; column < 4; ++column) {
      covariance_[row][column] -= g0 * before[0][column] + g1 * before[1][column];
    }
  }
  for (std::size_t row = 0; row < 4; ++row) {  // keeps it symmetric in spite of rounding
    for (std::size_t column = row + 1; column < 4; ++column) {
      covariance_[row][column] = covariance_[column][row] =
          0.5 * (covariance_[row][column] + covariance_[column][row]);
    }
  }
}

void TrackedObject::add(const Echo& confirmed, geo::PlanePoint vehicle) {
  const geo::PlanePoint offset{confirmed.place.x_m - state_[0], confirmed.place.y_m - state_[1]};
  const geo::PlanePoint from{vehicle.x_m - state_[0], vehicle.y_m - state_[1]};
  SurfaceCell added{.offset = offset,
                    .depth_m = confirmed.depth_m,
                    .deepest_m = confirmed.deepest_m,
                    .seen_s = now_s_,
                    .hits = EchoConfirmation::needed};
  for (std::size_t i = 0; i < size_; ++i) {
    if (!cells_[i].beside_other &&
        squared_distance(cells_[i].offset, offset) < squared(0.5 * SurfaceCell::size_m)) {
      added.beside_other = true;
    }
  }
  if (size_ == most_cells) {
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < size_; ++i) {
      if (squared_distance(cells_[i].offset, from) > squared_distance(cells_[farthest].offset, from))
        farthest = i;
    }
    remove(farthest);
  }
  cells_[size_++] = added;
  seen_s_ = now_s_;
  if (confirmed.depth_m > keel_m_ + 0.5 * SurfaceCell::size_m) looks_below_ = 0;
  if (confirmed.depth_m < top_m_ - 0.5 * SurfaceCell::size_m) looks_above_ = 0;
  measure_box();
}

void TrackedObject::forget_before(double seen_s) {
  const std::size_t before = size_;
  for (std::size_t i = size_; i-- > 0;) {
    if (cells_[i].seen_s < seen_s) remove(i);
  }
  if (size_ != before) measure_box();
}

void TrackedObject::contradict(const Echo& echo, geo::PlanePoint vehicle, double vehicle_depth_m) {
  const double dx = echo.place.x_m - vehicle.x_m;
  const double dy = echo.place.y_m - vehicle.y_m;
  const double far_m = std::hypot(dx, dy);
  if (!(far_m > past_cell_m)) return;
  bool removed = false;
  for (std::size_t i = size_; i-- > 0;) {
    SurfaceCell& cell = cells_[i];
    const geo::PlanePoint p = place(cell);
    const double along_m = ((p.x_m - vehicle.x_m) * dx + (p.y_m - vehicle.y_m) * dy) / far_m;
    const double across_m = ((p.x_m - vehicle.x_m) * dy - (p.y_m - vehicle.y_m) * dx) / far_m;
    if (along_m < 0.0 || along_m > far_m - past_cell_m || std::abs(across_m) > 0.25 * SurfaceCell::size_m)
      continue;
    const double beam_depth_m = vehicle_depth_m + along_m / far_m * (echo.depth_m - vehicle_depth_m);
    if (std::abs(beam_depth_m - cell.depth_m) > 0.25 * SurfaceCell::size_m) continue;
    if (cell.hits > 1) {
      cell.hits = static_cast<std::uint16_t>(cell.hits / 2);
    } else {
      remove(i);
      removed = true;
    }
  }
  if (removed) measure_box();
}

double TrackedObject::place_sigma_m() const {
  return std::sqrt(
      std::max(0.0, greater_eigenvalue(covariance_[0][0], covariance_[0][1], covariance_[1][1])));
}

double TrackedObject::drift_sigma_m_s() const {
  return std::sqrt(
      std::max(0.0, greater_eigenvalue(covariance_[2][2], covariance_[2][3], covariance_[3][3])));
}

geo::PlanePoint TrackedObject::centre() const {
  return {state_[0] + 0.5 * (low_.x_m + high_.x_m), state_[1] + 0.5 * (low_.y_m + high_.y_m)};
}

double TrackedObject::half_extent_m() const { return 0.5 * geo::distance_m(low_, high_); }

void TrackedObject::look_below(double lowest_look_m) {
  if (lowest_look_m > keel_m_ + 2.0 * SurfaceCell::size_m) ++looks_below_;
}

void TrackedObject::stand_on(const Echo& bed) {
  if (looks_below_ == 0 || bed.deepest_m < keel_m_ || bed.shallowest_m > keel_m_ + SurfaceCell::size_m)
    return;
  const geo::PlanePoint at{bed.place.x_m - state_[0], bed.place.y_m - state_[1]};
  if (at.x_m < low_.x_m - join_m || at.x_m > high_.x_m + join_m || at.y_m < low_.y_m - join_m ||
      at.y_m > high_.y_m + join_m)
    return;
  for (std::size_t i = 0; i < size_; ++i) {
    if (squared_distance(cells_[i].offset, at) > squared(join_m)) continue;
    looks_below_ = 0;
    return;
  }
}

void TrackedObject::look_above(double least_top_m) {
  looks_above_ = top_m_ > least_top_m ? looks_above_ + 1 : 0;
}

void TrackedObject::measure_box() {
  low_ = high_ = size_ > 0 ? cells_[0].offset : geo::PlanePoint{};
  keel_m_ = 0.0;
  top_m_ = size_ > 0 ? cells_[0].depth_m : 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    low_ = {std::min(low_.x_m, cells_[i].offset.x_m), std::min(low_.y_m, cells_[i].offset.y_m)};
    high_ = {std::max(high_.x_m, cells_[i].offset.x_m), std::max(high_.y_m, cells_[i].offset.y_m)};
    keel_m_ = std::max(keel_m_, cells_[i].depth_m);
    top_m_ = std::min(top_m_, cells_[i].depth_m);
  }
}

void TrackedObject::remove(std::size_t i) {
  if (!cells_[i].beside_other) {  // cells beside it must be seen from above again
    for (std::size_t k = 0; k < size_; ++k) {
      if (squared_distance(cells_[k].offset, cells_[i].offset) < squared(0.5 * SurfaceCell::size_m)) {
        cells_[k].beside_other = false;
      }
    }
  }
  cells_[i] = cells_[--size_];
}

}  // namespace floeplan::avoidance
