#include "engine/motion/edge_fan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace floeplan::motion {
namespace {

constexpr std::size_t block = EdgeFan::block;
constexpr float least_share =
    0.02F;                         // of the speed through water: twice the share `least_progress` of Crabbing
constexpr float rounding = 2e-5F;  // of a time: far above the rounding of some fifty float operations
constexpr int sharpenings = 3;

using Lanes = std::array<float, block>;

// Each function computes one lane, without branches, so that a loop over lanes is vectorised. The reference
// and all other paths call the same functions, so the operations and their order are the same.

[[gnu::always_inline]] inline float larger(float a, float b) { return a > b ? a : b; }
[[gnu::always_inline]] inline float smaller(float a, float b) { return a < b ? a : b; }

/// The largest speed over ground along (ex, ey) of a vehicle with speed `v` through the current (x, y); zero
/// or negative if it makes no way.
[[gnu::always_inline]] inline float greatest_speed(float x, float y, float ex, float ey, float v) {
  const float across = x * ey - y * ex;
  const float margin = v * v - across * across;
  const float speed = x * ex + y * ey + std::sqrt(larger(margin, 0.0F));
  return static_cast<float>((margin > 0.0F) & (v > 0.0F)) * speed;
}

[[gnu::always_inline]] inline float time_at(float length, float speed, float longest) {
  return length / larger(speed, length / longest);
}

/// The value for the quarter that an edge leads into.
[[gnu::always_inline]] inline float in_quarter(const NearbyCurrent::ByQuarter& values, bool down_u,
                                               bool down_v) {
  using Current = NearbyCurrent;
  const float up = down_u ? values[Current::quarter(true, false)] : values[Current::quarter(false, false)];
  const float down = down_u ? values[Current::quarter(true, true)] : values[Current::quarter(false, true)];
  return down_v ? down : up;
}

struct LaneState {
  float length;
  float shift_x;  // change of the current over the edge
  float shift_y;
  float off;     // bound of its error
  float mean_x;  // mean current over the drive, for the latest estimate of its time
  float mean_y;
  float time;
};

[[gnu::always_inline]] inline LaneState begin(float x_m, float y_m, float plane_m, float ex, float ey,
                                              const NearbyCurrent& c, const FanVehicle& vehicle) {
  const float du = c.u_x * x_m + c.u_y * y_m;
  const float dv = c.v_x * x_m + c.v_y * y_m;
  LaneState s{};
  s.length = plane_m * vehicle.ground_per_plane;
  const bool down_u = du < 0.0F;
  const bool down_v = dv < 0.0F;
  const auto here = [&](const NearbyCurrent::ByQuarter& values)
                        __attribute__((always_inline)) { return in_quarter(values, down_u, down_v); };
  s.shift_x = here(c.x_by_u) * du + here(c.x_by_v) * dv;
  s.shift_y = here(c.y_by_u) * du + here(c.y_by_v) * dv;
  s.off = here(c.off_by_u) * std::abs(du) + here(c.off_by_v) * std::abs(dv);
  const float x = c.x_m_s + 0.5F * s.shift_x;
  const float y = c.y_m_s + 0.5F * s.shift_y;
  s.time = time_at(s.length, greatest_speed(x, y, ex, ey, vehicle.through_water_m_s), vehicle.longest_s);
  return s;
}

/// Adds the contribution of a knot to the mean current over a drive of `time`, in units of the squared time.
/// `finish_mean` then computes the mean.
[[gnu::always_inline]] inline void add_knot(LaneState& s, float knot_s, float bend_x, float bend_y) {
  const float past = larger(s.time - knot_s, 0.0F);
  s.mean_x += bend_x * (past * past);
  s.mean_y += bend_y * (past * past);
}

[[gnu::always_inline]] inline void finish_mean(LaneState& s, const NearbyCurrent& c) {
  const float per_time = 1.0F / s.time;
  s.mean_x = c.x_m_s + 0.5F * (s.shift_x + c.x_m_s2 * s.time + s.mean_x * per_time);
  s.mean_y = c.y_m_s + 0.5F * (s.shift_y + c.y_m_s2 * s.time + s.mean_y * per_time);
}

[[gnu::always_inline]] inline void retime(LaneState& s, float ex, float ey, const FanVehicle& vehicle) {
  const float speed = greatest_speed(s.mean_x, s.mean_y, ex, ey, vehicle.through_water_m_s);
  s.time = time_at(s.length, speed, vehicle.longest_s);
}

/// Bounds of a drive, from its mean current.
struct Enclosure {
  float slowest;   // lower bound of the speed over ground
  float of_place;  // error of the mean that comes from the unknown place of the vehicle at each time
  float least;     // lower bound of the duration
  float is_open;   // 1: certainly passable for every vehicle; 0: maybe not
};

[[gnu::always_inline]] inline Enclosure enclose(const LaneState& s, float ex, float ey,
                                                const NearbyCurrent& c, const FanVehicle& vehicle) {
  const float v = vehicle.through_water_m_s;
  const float shift = std::abs(s.shift_x) + std::abs(s.shift_y);
  // The current at any time until `until` differs from the mean by at most this.
  const auto apart = [&](float until) __attribute__((always_inline)) {
    return c.steepest_m_s2 * (until - 0.5F * s.time) + 0.5F * shift + s.off + c.unseen_m_s;
  };
  // For a drive that takes longer than estimated, the estimate is already a lower bound.
  const float near = apart(s.time);
  const float fastest = greatest_speed(s.mean_x, s.mean_y, ex, ey, v + near);
  const float slowest = greatest_speed(s.mean_x, s.mean_y, ex, ey, v - near);
  // Also with the worst current in the window the drive must end within it.
  const float window = smaller(1.5F * s.time, smaller(vehicle.longest_s, c.known_s));
  const float slowest_late = greatest_speed(s.mean_x, s.mean_y, ex, ey, v - apart(window));
  const float gets_on = static_cast<float>(slowest_late > least_share * v);
  const float in_time = static_cast<float>(s.length < slowest_late * window);
  const float in_window = static_cast<float>(s.time <= window);

  // The mean place lies off the middle of the edge by at most an eighth of the relative difference of the two
  // speeds.
  const float safe_slowest = larger(slowest, least_share * v);
  const float off_middle = smaller((fastest - slowest) / (8.0F * safe_slowest), 0.5F);
  return {safe_slowest, off_middle * shift + (0.5F + off_middle) * s.off + c.unseen_m_s,
          smaller(s.length / larger(fastest, safe_slowest), s.time),
          larger(gets_on * in_time, vehicle.never_stopped ? 1.0F : 0.0F) * in_window};
}

[[gnu::always_inline]] inline float sharpened(const LaneState& s, const Enclosure& e, float ex, float ey,
                                              const NearbyCurrent& c, const FanVehicle& vehicle) {
  // If the duration changes, the mean over it changes by at most half the slope times that change.
  const float radius = e.of_place + 0.5F * c.steepest_m_s2 * (s.time - e.least);
  const float speed = greatest_speed(s.mean_x, s.mean_y, ex, ey, vehicle.through_water_m_s + radius);
  return larger(e.least, smaller(s.length / larger(speed, e.slowest), s.time));
}

[[gnu::always_inline]] inline float bound(const Enclosure& e) {
  return e.is_open * (e.least * (1.0F - rounding));
}

struct Job {
  const EdgeFan& fan;
  const NearbyCurrent& current;
  const FanVehicle& vehicle;
  FanTimes& times;
};

constexpr int estimates = 2;

void one_by_one(const Job& job, bool as_bound) {
  const auto& [fan, c, vehicle, times] = job;
  for (std::size_t i = 0; i < fan.lanes; ++i) {
    LaneState s = begin(fan.x_m[i], fan.y_m[i], fan.length_m[i], fan.ex[i], fan.ey[i], c, vehicle);
    for (int round = 0; round < estimates; ++round) {
      s.mean_x = s.mean_y = 0.0F;
      for (std::size_t k = 0; k < c.knots; ++k) add_knot(s, c.knot_s[k], c.bend_x[k], c.bend_y[k]);
      finish_mean(s, c);
      if (round + 1 < estimates || !as_bound) retime(s, fan.ex[i], fan.ey[i], vehicle);
    }
    times.time_s[i] = s.time;
    if (!as_bound) continue;
    Enclosure e = enclose(s, fan.ex[i], fan.ey[i], c, vehicle);
    for (int j = 0; j < sharpenings; ++j) e.least = sharpened(s, e, fan.ex[i], fan.ey[i], c, vehicle);
    times.time_s[i] = bound(e);
  }
}

/// Computes one block of lanes after another.
template <bool as_bound>
[[gnu::always_inline]] inline void block_by_block(const Job& job) {
  const auto& [fan, c, vehicle, times] = job;
  for (std::size_t first = 0; first < fan.lanes; first += block) {
    const float* const ex = fan.ex.data() + first;
    const float* const ey = fan.ey.data() + first;
    alignas(64) Lanes length;
    alignas(64) Lanes shift_x;
    alignas(64) Lanes shift_y;
    alignas(64) Lanes off;
    alignas(64) Lanes mean_x;
    alignas(64) Lanes mean_y;
    alignas(64) Lanes time;
    const auto load = [&](std::size_t i) __attribute__((always_inline)) {
      return LaneState{length[i], shift_x[i], shift_y[i], off[i], mean_x[i], mean_y[i], time[i]};
    };
    for (std::size_t i = 0; i < block; ++i) {
      const LaneState s =
          begin(fan.x_m[first + i], fan.y_m[first + i], fan.length_m[first + i], ex[i], ey[i], c, vehicle);
      length[i] = s.length;
      shift_x[i] = s.shift_x;
      shift_y[i] = s.shift_y;
      off[i] = s.off;
      time[i] = s.time;
    }
    for (int round = 0; round < estimates; ++round) {
      mean_x.fill(0.0F);
      mean_y.fill(0.0F);
      for (std::size_t k = 0; k < c.knots; ++k) {
        const float knot_s = c.knot_s[k];
        const float bend_x = c.bend_x[k];
        const float bend_y = c.bend_y[k];
        for (std::size_t i = 0; i < block; ++i) {
          LaneState s = load(i);
          add_knot(s, knot_s, bend_x, bend_y);
          mean_x[i] = s.mean_x;
          mean_y[i] = s.mean_y;
        }
      }
      for (std::size_t i = 0; i < block; ++i) {
        LaneState s = load(i);
        finish_mean(s, c);
        mean_x[i] = s.mean_x;
        mean_y[i] = s.mean_y;
      }
      if (round + 1 == estimates && as_bound) break;
      for (std::size_t i = 0; i < block; ++i) {
        LaneState s = load(i);
        retime(s, ex[i], ey[i], vehicle);
        time[i] = s.time;
      }
    }
    float* const out = times.time_s.data() + first;
    if constexpr (!as_bound) {
      for (std::size_t i = 0; i < block; ++i) out[i] = time[i];
      continue;
    }
    alignas(64) Lanes slowest;
    alignas(64) Lanes of_place;
    alignas(64) Lanes least;
    alignas(64) Lanes is_open;
    for (std::size_t i = 0; i < block; ++i) {
      const Enclosure e = enclose(load(i), ex[i], ey[i], c, vehicle);
      slowest[i] = e.slowest;
      of_place[i] = e.of_place;
      least[i] = e.least;
      is_open[i] = e.is_open;
    }
    const auto enclosure = [&](std::size_t i) __attribute__((always_inline)) {
      return Enclosure{slowest[i], of_place[i], least[i], is_open[i]};
    };
    for (int j = 0; j < sharpenings; ++j) {
      for (std::size_t i = 0; i < block; ++i) {
        least[i] = sharpened(load(i), enclosure(i), ex[i], ey[i], c, vehicle);
      }
    }
    for (std::size_t i = 0; i < block; ++i) out[i] = bound(enclosure(i));
  }
}

template <bool as_bound>
void baseline(const Job& job) {
  block_by_block<as_bound>(job);
}

#if defined(__x86_64__)
template <bool as_bound>
__attribute__((target("avx2"))) void with_avx2(const Job& job) {
  block_by_block<as_bound>(job);
}
template <bool as_bound>
__attribute__((target("avx512f,avx512dq,avx512vl"))) void with_avx512(const Job& job) {
  block_by_block<as_bound>(job);
}
#endif

template <bool as_bound>
void work(const Job& job, FanPath path) {
  switch (path) {
    case FanPath::reference: one_by_one(job, as_bound); return;
    case FanPath::baseline: baseline<as_bound>(job); return;
#if defined(__x86_64__)
    case FanPath::avx2: with_avx2<as_bound>(job); return;
    case FanPath::avx512: with_avx512<as_bound>(job); return;
#else
    case FanPath::avx2:
    case FanPath::avx512: break;
#endif
  }
  throw std::invalid_argument{"this processor has no such path"};
}

std::vector<FanPath> possible_paths() {
  std::vector<FanPath> paths{FanPath::reference, FanPath::baseline};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) paths.push_back(FanPath::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    paths.push_back(FanPath::avx512);
  }
#endif
  return paths;
}

std::vector<FanPath>& paths_to_take() {
  static std::vector<FanPath> paths = possible_paths();
  return paths;
}

}  // namespace

EdgeFan::EdgeFan(const std::vector<geo::PlanePoint>& edges) {
  if (edges.empty() || edges.size() > most) throw std::invalid_argument{"a fan has 1 to 80 edges"};
  lanes = (edges.size() + block - 1) / block * block;
  for (std::size_t i = 0; i < lanes; ++i) {
    const geo::PlanePoint edge = edges[std::min(i, edges.size() - 1)];
    const double length = std::hypot(edge.x_m, edge.y_m);
    if (!(length > 0.0)) throw std::invalid_argument{"an edge of a fan needs a length"};
    x_m[i] = static_cast<float>(edge.x_m);
    y_m[i] = static_cast<float>(edge.y_m);
    length_m[i] = static_cast<float>(length);
    ex[i] = static_cast<float>(edge.x_m / length);
    ey[i] = static_cast<float>(edge.y_m / length);
  }
}

const std::vector<FanPath>& fan_paths() { return paths_to_take(); }

void limit_fan_paths(FanPath widest) {
  const auto found = std::ranges::find(paths_to_take(), widest);
  if (found == paths_to_take().end()) throw std::invalid_argument{"this processor has no such path"};
  paths_to_take().erase(found + 1, paths_to_take().end());
}

void estimate_fan(const EdgeFan& fan, const NearbyCurrent& current, const FanVehicle& vehicle,
                  FanTimes& times, FanPath path) {
  work<false>({fan, current, vehicle, times}, path);
}

void bound_fan(const EdgeFan& fan, const NearbyCurrent& current, const FanVehicle& vehicle, FanTimes& times,
               FanPath path) {
  work<true>({fan, current, vehicle, times}, path);
}

}  // namespace floeplan::motion
