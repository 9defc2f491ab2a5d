#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "storage/demo/disko.hpp"
#include "storage/demo/disko_places.hpp"
#include "storage/demo/land_mask.hpp"

namespace floeplan::demo {
namespace {

constexpr double corridor_clearance_m = 7000.0;
// least distance of other bergs from the one in the corridor, so that no two close a gap
constexpr double alone_m = 13'000.0;
constexpr geo::LonLat corridor_berg{-52.42, 69.227};  // three kilometres beside the corridor's line

/// A region and how many bergs lie there.
struct Field {
  geo::BoundingBox box;
  int bergs{};
  double spread_m{};  // typical distance of the bergs from the outflow's line
  double median_m{};  // median length of the bergs
};

constexpr std::array fields{Field{{-51.06, 69.12, -50.52, 69.22}, 15, 2500.0, 170.0},  // icefjord
                            Field{{-51.16, 69.13, -51.06, 69.20}, 8, 2500.0, 260.0},   // aground on the sill
                            Field{{-51.60, 69.06, -51.16, 69.34}, 15, 5000.0, 120.0},  // before the mouth
                            Field{{-52.00, 69.28, -51.45, 69.59}, 8, 6000.0, 100.0},   // on the way to Vaigat
                            Field{{-54.00, 68.80, -51.50, 69.42}, 13, 60'000.0, 90.0}};  // scattered

double uniform_share(std::mt19937_64& rng) { return static_cast<double>(rng() >> 11) * 0x1.0p-53; }

double normal(std::mt19937_64& rng) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform_share(rng)));
  return radius * std::cos(2.0 * std::numbers::pi * uniform_share(rng));
}

double draft_m(double length_m) {
  return length_m <= 160.0 ? 2.91 * std::pow(length_m, 0.71) : 3.78 * std::pow(length_m, 0.63);
}

ocean::IcebergSize size_of(double length_m) {
  if (length_m <= 60.0) return ocean::IcebergSize::small;
  if (length_m <= 120.0) return ocean::IcebergSize::medium;
  if (length_m <= 200.0) return ocean::IcebergSize::large;
  return ocean::IcebergSize::very_large;
}

double rounded(double value, double step) { return std::round(value / step) * step; }

class BergMaker {
 public:
  BergMaker(const Relief& relief, std::uint64_t seed, core::UtcTime start)
      : relief_{relief}, coast_cells_{cells_to(relief.frame, relief.land, 1)}, rng_{seed}, start_{start} {}

  ocean::Iceberg in(const Field& field) {
    const double length_m =
        rounded(std::clamp(field.median_m * std::exp(0.55 * normal(rng_)), 20.0, 600.0), 1.0);
    for (int attempt = 0; attempt < 10'000; ++attempt) {
      const geo::LonLat place{
          rounded(field.box.west_deg + (field.box.east_deg - field.box.west_deg) * uniform_share(rng_), 1e-5),
          rounded(field.box.south_deg + (field.box.north_deg - field.box.south_deg) * uniform_share(rng_),
                  1e-5)};
      const double aside = beside(disko::outflow, place, disko::earth).across_m / field.spread_m;
      if (uniform_share(rng_) < std::exp(-aside * aside) && is_free(place, length_m))
        return berg(place, length_m);
    }
    throw std::logic_error{"no free water for an iceberg"};
  }

  ocean::Iceberg berg(geo::LonLat place, double length_m) {
    places_.push_back(place);
    std::array<char, 16> id{};
    std::snprintf(id.data(), id.size(), "SYN-%03zu", places_.size());
    const double age_s = rounded((0.5 + 19.5 * uniform_share(rng_)) * 3600.0, 60.0);
    ocean::Iceberg berg;
    berg.id = id.data();
    berg.place = place;
    berg.observed = start_ - core::Seconds{age_s};
    berg.size = size_of(length_m);
    berg.length = core::Metres{length_m};
    berg.draft = core::Metres{std::floor(std::min(draft_m(length_m), depth_m(relief_, place)))};
    berg.position_uncertainty = core::Metres{rounded(100.0 + 300.0 * uniform_share(rng_), 10.0)};
    berg.method = "SAT-HIGH";
    return berg;
  }

 private:
  [[nodiscard]] bool is_free(geo::LonLat place, double length_m) const {
    const double corridor_m = beside(disko::corridor, place, disko::earth).across_m;
    const bool crowded = std::ranges::any_of(
        places_, [&](geo::LonLat other) { return disko::earth.distance_m(place, other) < 700.0; });
    const bool alone = disko::earth.distance_m(place, corridor_berg) > alone_m;
    return !crowded && alone && corridor_m > corridor_clearance_m && depth_m(relief_, place) > 30.0 &&
           coast_m(place) > 0.5 * length_m + disko_cell_m;
  }

  [[nodiscard]] double coast_m(geo::LonLat place) const {
    const RasterFrame& frame = relief_.frame;
    const auto column = static_cast<std::size_t>((place.lon_deg - frame.west_deg) / frame.step_lon_deg);
    const auto row = static_cast<std::size_t>((place.lat_deg - frame.south_deg) / frame.step_lat_deg);
    return disko_cell_m * static_cast<double>(coast_cells_[frame.index(column, row)]);
  }

  const Relief& relief_;
  std::vector<float> coast_cells_;
  std::mt19937_64 rng_;
  core::UtcTime start_;
  std::vector<geo::LonLat> places_;
};

}  // namespace

std::vector<ocean::Iceberg> make_disko_icebergs(const Relief& relief, std::uint64_t seed,
                                                core::UtcTime start) {
  BergMaker maker{relief, seed, start};
  std::vector<ocean::Iceberg> bergs{maker.berg(corridor_berg, 58.0)};
  for (const Field& field : fields) {
    for (int i = 0; i < field.bergs; ++i) bergs.push_back(maker.in(field));
  }
  return bergs;
}

}  // namespace floeplan::demo
