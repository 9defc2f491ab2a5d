#include <algorithm>
#include <map>

#include "api/codec/bytes/foreign_members.hpp"
#include "api/codec/bytes/json_text.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "api/codec/route_files/route_formats.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using Line = std::vector<geo::LonLat>;

constexpr std::size_t deepest_collection = 8;

/// The geometries of one feature.
struct Feature {
  std::string name;
  std::vector<Line> lines{};
  Line points{};
  // set for legs and waypoints of a plan, which the server returns as separate features
  std::string plan_id{};
  double index{};  // index of the leg or waypoint in the plan
};

std::string name_of(const json& feature, const json& properties) {
  for (const char* const key : {"name", "Name", "NAME", "title"})
    if (std::string name = text_at(properties, key); !name.empty()) return name;
  return text_at(feature, "id");
}

/// Collects the geometries of a GeoJSON value.
class Gathering {
 public:
  explicit Gathering(InputReader& reader) : reader_{reader} {}

  void gather(const json& value, const std::string& pointer, std::size_t depth = 0) {
    if (value.is_array()) return add_line(value, pointer, feature());
    if (!value.is_object() || reader_.is_full() || depth > deepest_collection) return;
    const std::string type = text_at(value, "type");
    if (type == "FeatureCollection") {
      note_pages(value);
      gather_each(value, "features", pointer, depth);
    } else if (type == "GeometryCollection") {
      gather_each(value, "geometries", pointer, depth);
    } else if (type == "Feature") {
      begin_feature(value);
      if (value.contains("geometry")) gather(value.at("geometry"), pointer + "/geometry", depth + 1);
      is_in_feature_ = false;
    } else if (value.contains("coordinates")) {
      add_geometry(type, value.at("coordinates"), pointer + "/coordinates");
    }
  }

  [[nodiscard]] std::vector<Feature>& features() { return features_; }
  /// Whether the document is one page of several, so that features are missing.
  [[nodiscard]] bool is_a_page() const { return is_a_page_; }

 private:
  void gather_each(const json& value, const char* key, const std::string& pointer, std::size_t depth) {
    if (!value.contains(key) || !value.at(key).is_array()) return reader_.refuse<"no-array">(pointer, key);
    const json& members = value.at(key);
    for (std::size_t i = 0; i < members.size(); ++i)
      gather(members[i], pointer + "/" + key + "/" + std::to_string(i), depth + 1);
  }

  void note_pages(const json& collection) {
    const auto matched = number_at(collection, "numberMatched");
    const auto returned = number_at(collection, "numberReturned");
    is_a_page_ = is_a_page_ || (matched && returned && *returned < *matched);
  }

  void begin_feature(const json& value) {
    static const json none = json::object();
    const bool has_properties = value.contains("properties") && value.at("properties").is_object();
    const json& properties = has_properties ? value.at("properties") : none;
    Feature next{.name = name_of(value, properties)};
    const std::string plan_id = text_at(properties, "plan_id");
    const auto index = number_at(properties, "index");
    if (!plan_id.empty() && index) {
      next.plan_id = plan_id;
      next.index = *index;
      next.name = text_at(properties, "plan_name");
      if (next.name.empty()) next.name = plan_id;
    }
    features_.push_back(std::move(next));
    is_in_feature_ = true;
  }

  /// The current feature; a geometry without a feature gets its own.
  Feature& feature() {
    if (!is_in_feature_) features_.emplace_back();
    return features_.back();
  }

  void add_geometry(const std::string& type, const json& coordinates, const std::string& pointer) {
    if (type == "LineString") return add_line(coordinates, pointer, feature());
    if (type == "Point") return add_points(json::array({coordinates}), pointer);
    if (type == "MultiPoint") return add_points(coordinates, pointer);
    if (type != "MultiLineString") return;
    if (!coordinates.is_array()) return reader_.refuse<"wrong-shape">(pointer, "an array of lines");
    Feature& of_all = feature();
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      add_line(coordinates[i], pointer + "/" + std::to_string(i), of_all);
  }

  void add_line(const json& positions, const std::string& pointer, Feature& to) {
    if (auto line = reader_.places(positions, pointer, 1, max_places)) to.lines.push_back(std::move(*line));
  }

  void add_points(const json& positions, const std::string& pointer) {
    const auto points = reader_.places(positions, pointer, 1, max_places);
    if (!points) return;
    Line& all = feature().points;
    all.insert(all.end(), points->begin(), points->end());
  }

  InputReader& reader_;
  std::vector<Feature> features_;
  bool is_in_feature_{false};
  bool is_a_page_{false};
};

/// Joins the features of each plan, in their order, at the position of the first one. Other features stay
/// unchanged.
std::vector<Feature> with_whole_plans(InputReader& reader, Gathering& all, const std::string& pointer) {
  std::vector<Feature> whole;
  std::map<std::string, std::vector<Feature>> parts;
  for (Feature& feature : all.features()) {
    if (feature.plan_id.empty()) {
      whole.push_back(std::move(feature));
      continue;
    }
    auto& of_plan = parts[feature.plan_id];
    if (of_plan.empty()) whole.push_back({.name = feature.name, .plan_id = feature.plan_id});
    of_plan.push_back(std::move(feature));
  }
  for (Feature& plan : whole) {
    if (plan.plan_id.empty()) continue;
    auto& of_plan = parts[plan.plan_id];
    std::ranges::stable_sort(of_plan, {}, &Feature::index);
    for (std::size_t i = 1; i < of_plan.size(); ++i)
      if (of_plan[i].index != of_plan[i - 1].index + 1.0)
        reader.refuse<"plan-with-a-gap">(pointer, plan.name, shown(of_plan[i - 1].index),
                                         shown(of_plan[i].index));
    for (Feature& part : of_plan) {
      plan.lines.insert(plan.lines.end(), part.lines.begin(), part.lines.end());
      plan.points.insert(plan.points.end(), part.points.begin(), part.points.end());
    }
    if (all.is_a_page()) reader.refuse<"page-of-a-plan">(pointer);
  }
  return whole;
}

}  // namespace

FileRoutes geojson_routes(InputReader& reader, const json& value, const std::string& pointer) {
  Gathering all{reader};
  all.gather(value, pointer);
  std::vector<Feature> features = with_whole_plans(reader, all, pointer);

  FileRoutes file;
  for (Feature& feature : features)
    if (!feature.lines.empty()) file.routes.push_back({feature.name, std::move(feature.lines)});
  if (!file.routes.empty()) return file;

  Line points;
  for (Feature& feature : features) {
    if (!feature.plan_id.empty() && !feature.points.empty())
      file.routes.push_back({feature.name, {std::move(feature.points)}});
    if (feature.plan_id.empty()) points.insert(points.end(), feature.points.begin(), feature.points.end());
  }
  if (!points.empty()) file.routes.push_back({"", {std::move(points)}});
  if (file.routes.empty() && reader.violations().empty())
    reader.refuse<"holds-no">(pointer, "LineString and no Point");
  return file;
}

ReadRoutes read_geojson(std::string_view bytes) {
  const auto document = parse_json(bytes);
  if (!document) return route_fault<"route-file-unreadable">("file", document.error());
  static const json nothing = json::object();
  InputReader reader{nothing};
  FileRoutes file = geojson_routes(reader, *document, "");
  core::Violations faults = reader.violations();
  for (core::Violation& fault : faults)
    if (fault.field.empty()) fault.field = "file";
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  file.warnings = reader.remarks();
  return file;
}

}  // namespace floeplan::codec
