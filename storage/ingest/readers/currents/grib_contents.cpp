#include "storage/ingest/readers/currents/grib_contents.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "engine/messages/ingest_grib_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr int oceanography = 10;
constexpr int currents_category = 1;
constexpr int meteorology = 0;
constexpr int momentum_category = 2;
constexpr int east_number = 2;  // both for current and wind: direction and speed are 0 and 1, u and v 2 and 3
constexpr int north_number = 3;
constexpr int depth_surface = 160;
constexpr int sea_surface = 1;
constexpr int pressure_surface = 100;
constexpr int height_surface = 103;
constexpr double pascals_per_hectopascal = 100.0;

bool is_current(const GribField& field) {
  return field.discipline == oceanography && field.category == currents_category;
}

bool is_wind_anywhere(const GribField& field) {
  return field.discipline == meteorology && field.category == momentum_category &&
         (field.number == east_number || field.number == north_number);
}

bool is_wind(const GribField& field) {
  return is_wind_anywhere(field) && field.surface_type == height_surface && !field.is_of_layer() &&
         is_height_of_wind(field.surface_value);
}

/// "at 100 m above the ground", "over the layer from 10 to 100 m above the ground".
/// Source  WMO code table 4.5
std::string words_of_level(const GribField& field) {
  const bool one_type = !field.is_of_layer() || field.second_surface_type == field.surface_type;
  const auto values = [&](double unit) {
    const std::string first = number(field.surface_value / unit);
    return field.is_of_layer() ? first + " to " + number(field.second_surface_value / unit) : first;
  };
  const std::string where = field.is_of_layer() ? "over the layer from " : "at ";
  if (one_type && field.surface_type == height_surface) return where + values(1.0) + " m above the ground";
  if (one_type && field.surface_type == pressure_surface)
    return where + "a pressure of " + values(pascals_per_hectopascal) + " hPa";
  const std::string type = std::to_string(field.surface_type);
  if (!field.is_of_layer()) return "at a surface of type " + type + " (code table 4.5)";
  return "over a layer between surfaces of types " + type + " and " +
         std::to_string(field.second_surface_type) + " (code table 4.5)";
}

/// All wind of a file in words: "the wind at 100 m above the ground and at a pressure of 850 hPa"; empty if
/// it has none.
std::string wind_in_words(const std::vector<GribField>& fields) {
  std::vector<std::string> levels;
  for (const GribField& field : fields) {
    if (!is_wind_anywhere(field)) continue;
    std::string words = words_of_level(field);
    if (std::ranges::find(levels, words) == levels.end()) levels.push_back(std::move(words));
  }
  return levels.empty() ? std::string{} : "the wind " + enumeration(levels);
}

/// The layer over which a current is averaged; at a single depth both are equal.
struct Layer {
  double top_m{};
  double bottom_m{};

  [[nodiscard]] double middle_m() const { return 0.5 * (top_m + bottom_m); }
  friend auto operator<=>(const Layer&, const Layer&) = default;
};

bool is_depth(int surface_type) { return surface_type == depth_surface || surface_type == sea_surface; }

/// The layer of a field.
/// Errors   a surface that is not a depth
Checked<Layer> layer_of(const GribField& field) {
  if (!is_depth(field.surface_type))
    return refuse(messages::ingest_grib_message<"grib-surface-not-a-depth">(field.surface_type));
  const double first_m = field.surface_type == depth_surface ? field.surface_value : 0.0;
  if (!field.is_of_layer()) return Layer{first_m, first_m};
  if (!is_depth(field.second_surface_type))
    return refuse(messages::ingest_grib_message<"grib-layer-not-of-depths">(number(first_m),
                                                                            field.second_surface_type));
  const double second_m = field.second_surface_type == depth_surface ? field.second_surface_value : 0.0;
  return Layer{std::min(first_m, second_m), std::max(first_m, second_m)};
}

std::string words_of_layer(const Layer& layer) {
  return number(layer.top_m) + (layer.top_m < layer.bottom_m ? " to " + number(layer.bottom_m) : "") + " m";
}

/// The fault if layers overlap, because overlapping means make no profile; the uppermost layer comes first.
std::optional<messages::Message> overlap_of(const std::set<Layer>& layers) {
  const Layer* deepest = nullptr;
  for (const Layer& layer : layers) {
    if (deepest != nullptr && layer.top_m < deepest->bottom_m)
      return messages::ingest_grib_message<"grib-layers-overlap">(words_of_layer(*deepest) + " and " +
                                                                  words_of_layer(layer));
    if (deepest == nullptr || layer.bottom_m > deepest->bottom_m) deepest = &layer;
  }
  return std::nullopt;
}

/// "0 to 10 m and 10 to 50 m"; empty if all are single depths.
std::string words_of_layers(const std::set<Layer>& layers) {
  std::vector<std::string> words;
  for (const Layer& layer : layers)
    if (layer.top_m < layer.bottom_m) words.push_back(words_of_layer(layer));
  return words.empty() ? std::string{} : enumeration(words);
}

/// Whether a field is a value or a mean. Extremes, sums and deviations over a period are not the state of the
/// sea or the air.
bool is_state(const GribField& field) { return field.statistic == 0; }

messages::Message nothing_in_grib(Moving what, const std::vector<GribField>& fields, bool direction,
                                  bool statistic) {
  if (statistic)
    return messages::ingest_grib_message<"grib-without-values">(what == Moving::sea ? "current" : "wind");
  const std::string elsewhere = wind_in_words(fields);
  const std::string beside = elsewhere.empty() ? "" : elsewhere + ", but ";
  if (what == Moving::air) return messages::ingest_grib_message<"grib-without-wind">(beside);
  if (direction) return messages::ingest_grib_message<"grib-current-as-direction">();
  return messages::ingest_grib_message<"grib-without-currents">(beside);
}

}  // namespace

Checked<GribContents> grib_contents(const std::vector<GribField>& fields, Moving what) {
  const std::string name = what == Moving::sea ? "current" : "wind";
  std::map<std::pair<double, Layer>, GribBands> found;
  std::set<double> times;
  std::set<Layer> layers;
  const GribField* first = nullptr;
  bool direction = false;
  bool statistic = false;
  bool one_run = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const GribField& field = fields[i];
    if (!(what == Moving::sea ? is_current(field) : is_wind(field))) continue;
    direction = direction || field.number <= 1;
    statistic = statistic || !is_state(field);
    if (!is_state(field)) continue;
    if (field.number != east_number && field.number != north_number) continue;
    const auto layer = what == Moving::sea ? layer_of(field) : Checked<Layer>{Layer{}};
    if (!layer) return refuse(layer.error());
    if (first == nullptr) first = &field;
    if (field.grid != first->grid)
      return refuse(messages::ingest_grib_message<"grib-fields-on-several-grids">());
    GribBands& bands = found[{field.valid_s, *layer}];
    int& band = field.number == east_number ? bands.east : bands.north;
    if (band != 0) return refuse(messages::ingest_grib_message<"grib-component-twice">(name));
    band = static_cast<int>(i) + 1;
    one_run = one_run && field.run_s == first->run_s;
    times.insert(field.valid_s);
    layers.insert(*layer);
  }
  if (first == nullptr) return refuse(nothing_in_grib(what, fields, direction, statistic));
  if (auto overlap = overlap_of(layers)) return refuse(std::move(*overlap));
  std::vector<double> depths_m;
  for (const Layer& layer : layers) depths_m.push_back(layer.middle_m());

  GribContents contents{{times.begin(), times.end()},
                        std::move(depths_m),
                        {},
                        first->run_s ? std::optional{core::from_unix_seconds(*first->run_s)} : std::nullopt,
                        first->grid,
                        first->along_grid,
                        what == Moving::sea,
                        words_of_layers(layers)};
  if (!one_run) contents.run = std::nullopt;
  if (contents.depths_m.front() < 0.0 || contents.depths_m.back() > 12000.0)
    return refuse(messages::ingest_grib_message<"grib-depths-impossible">(number(contents.depths_m.front()),
                                                                          number(contents.depths_m.back())));
  for (const double time : contents.times_s) {
    for (const Layer& layer : layers) {
      const GribBands bands = found[{time, layer}];
      if (bands.east == 0 || bands.north == 0)
        return refuse(messages::ingest_grib_message<"grib-component-missing">(
            name, what == Moving::sea ? " at a depth of " + words_of_layer(layer) : std::string{}));
      contents.bands.push_back(bands);
    }
  }
  return contents;
}

Checked<std::vector<repository::DatasetKind>> kinds_of_grib(const std::filesystem::path& file) {
  const auto fields = grib_fields(file);
  if (!fields) return refuse(fields.error());
  std::vector<repository::DatasetKind> kinds;
  const bool current = std::ranges::any_of(*fields, is_current);
  const bool wind = std::ranges::any_of(
      *fields, [&](const GribField& field) { return is_wind(field) && (!current || is_state(field)); });
  if (!wind || current) kinds.push_back(repository::DatasetKind::currents);
  if (wind) kinds.push_back(repository::DatasetKind::wind);
  return kinds;
}

}  // namespace floeplan::ingest
