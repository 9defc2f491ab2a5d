#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/messages/ingest_feature_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/formats/vector/vector_files.hpp"
#include "storage/ingest/notation/stated_period.hpp"
#include "storage/ingest/notation/stated_rule.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::ingest {
namespace {

using xml::Element;
using Geometry = std::unique_ptr<OGRGeometry>;
using Attributes = std::vector<std::pair<std::string, std::string>>;

std::string named_line(const Element& element) { return "line " + std::to_string(element.line); }

/// Adds the positions in an element's coordinates, "lon,lat,height lon,lat ...", to a line.
Checked<bool> read_coordinates(const Element& holder, OGRSimpleCurve& line) {
  const Element* const coordinates = holder.child("coordinates");
  std::string_view rest = coordinates == nullptr ? std::string_view{} : xml::trimmed(coordinates->text);
  while (!rest.empty()) {
    const std::string_view place = rest.substr(0, rest.find_first_of(" \t\r\n"));
    rest = xml::trimmed(rest.substr(place.size()));
    const std::size_t comma = std::min(place.find(','), place.size() - 1);
    const auto lon = parse_number(place.substr(0, comma));
    const std::string_view behind = place.substr(comma + 1);
    const auto lat = parse_number(behind.substr(0, behind.find(',')));
    if (!lon || !lat)
      return refuse(
          about(named_line(*coordinates),
                messages::ingest_feature_message<"kml-coordinates-unreadable">(place.substr(0, 60))));
    line.addPoint(*lon, *lat);
  }
  return true;
}

Checked<Geometry> point_of(const Element& element) {
  OGRLineString places;
  if (const auto read = read_coordinates(element, places); !read) return refuse(read.error());
  if (places.getNumPoints() != 1)
    return refuse(about(named_line(element), messages::ingest_feature_message<"kml-point-of-many">()));
  return std::make_unique<OGRPoint>(places.getX(0), places.getY(0));
}

Checked<Geometry> polygon_of(const Element& element) {
  auto polygon = std::make_unique<OGRPolygon>();
  for (const char* const boundary : {"outerBoundaryIs", "innerBoundaryIs"}) {
    for (const Element& side : element.children) {
      if (side.name != boundary) continue;
      for (const Element& ring : side.children) {
        if (ring.name != "LinearRing") continue;
        OGRLinearRing line;
        if (const auto read = read_coordinates(ring, line); !read) return refuse(read.error());
        if (line.IsEmpty() == 0) line.closeRings();
        polygon->addRing(&line);
      }
    }
  }
  return polygon;
}

bool is_geometry(std::string_view name) {
  constexpr auto names = std::to_array<std::string_view>(
      {"Point", "Polygon", "MultiGeometry", "LineString", "LinearRing", "Track", "MultiTrack", "Model"});
  return std::ranges::find(names, name) != names.end();
}

Checked<Geometry> geometry_of(const Element& element);

/// Combines the parts of an element: a multipolygon if all parts are polygons, otherwise a collection.
Checked<Geometry> collection_of(const Element& element) {
  std::vector<Geometry> parts;
  for (const Element& child : element.children) {
    if (!is_geometry(child.name)) continue;
    auto part = geometry_of(child);
    if (!part) return part;
    parts.push_back(std::move(*part));
  }
  const bool are_polygons = std::ranges::all_of(
      parts, [](const Geometry& part) { return wkbFlatten(part->getGeometryType()) == wkbPolygon; });
  std::unique_ptr<OGRGeometryCollection> collection =
      are_polygons ? std::make_unique<OGRMultiPolygon>() : std::make_unique<OGRGeometryCollection>();
  for (Geometry& part : parts) collection->addGeometryDirectly(part.release());
  return collection;
}

Checked<Geometry> geometry_of(const Element& element) {
  if (element.name == "Point") return point_of(element);
  if (element.name == "Polygon") return polygon_of(element);
  if (element.name == "MultiGeometry") return collection_of(element);
  return std::make_unique<OGRLineString>();
}

/// The time span of an element, as texts of the file; an empty text: unbounded or not stated.
struct TimeTexts {
  std::string begin;
  std::string end;
  std::string when;  // the time of a TimeStamp
};

TimeTexts time_of(const Element& feature) {
  if (const Element* const span = feature.child("TimeSpan"))
    return {span->text_of("begin"), span->text_of("end"), ""};
  if (const Element* const stamp = feature.child("TimeStamp")) {
    const std::string when = stamp->text_of("when");
    return {when, when, when};
  }
  return {};
}

/// The time common to both spans: the later begin and the earlier end. A text that is not a time is kept, so
/// that the attribute reader refuses it later.
TimeTexts narrower(const TimeTexts& outer, const TimeTexts& inner) {
  const auto of_both = [](const std::string& one, const std::string& other, bool is_end) {
    const auto of_one = stated_period(one);
    const auto of_other = stated_period(other);
    if (one.empty() || (!of_other && !other.empty())) return other;
    if (other.empty() || !of_one) return one;
    const bool keeps_one = is_end ? of_one->last <= of_other->last : of_one->first >= of_other->first;
    return keeps_one ? one : other;
  };
  return {of_both(outer.begin, inner.begin, false), of_both(outer.end, inner.end, true), ""};
}

/// Adds the elements that contain only text, at any depth, under their names.
void add_leaves(const Element& element, Attributes& attributes) {
  if (element.children.empty()) attributes.emplace_back(element.name, trimmed(element.text));
  for (const Element& child : element.children) add_leaves(child, attributes);
}

/// The attributes in ExtendedData: Data with their values, SimpleData (declared or not), elements of other
/// namespaces.
Attributes extended_data_of(const Element& feature) {
  Attributes attributes;
  for (const Element& holder : feature.children) {
    if (holder.name != "ExtendedData" && holder.name != "Metadata") continue;
    for (const Element& data : holder.children) {
      if (data.name == "Data") {
        attributes.emplace_back(data.attribute("name"), data.text_of("value"));
      } else if (data.name == "SchemaData") {
        for (const Element& simple : data.children)
          attributes.emplace_back(simple.attribute("name"), trimmed(simple.text));
      } else {
        add_leaves(data, attributes);
      }
    }
  }
  return attributes;
}

/// The name of the first attribute that says what a zone is; empty if none does.
std::string word_of_zone(const Attributes& attributes) {
  for (const auto& [name, text] : attributes)
    if (!text.empty() && says_what_a_zone_is(name, text)) return name;
  return {};
}

struct Placemark {
  Geometry geometry;
  Attributes attributes;
};

/// The values that a placemark takes over from the folders around it.
struct Around {
  TimeTexts time;
  std::string names;
};

Checked<Placemark> placemark_of(const Element& element, const Around& around) {
  Placemark placemark;
  for (const Element& child : element.children) {
    if (!is_geometry(child.name)) continue;
    if (placemark.geometry)
      return refuse(about(named_line(child), messages::ingest_feature_message<"kml-second-geometry">()));
    auto geometry = geometry_of(child);
    if (!geometry) return refuse(geometry.error());
    placemark.geometry = std::move(*geometry);
  }
  const TimeTexts own = time_of(element);
  placemark.attributes = {{"Name", element.text_of("name")},
                          {"description", element.text_of("description")},
                          {"timestamp", own.when},
                          {time_stamp, own.when},
                          {"begin", own.when.empty() ? own.begin : ""},
                          {"end", own.when.empty() ? own.end : ""},
                          {folder_names, around.names},
                          {folder_begin, around.time.begin},
                          {folder_end, around.time.end}};
  for (auto& attribute : extended_data_of(element)) placemark.attributes.push_back(std::move(attribute));
  std::erase_if(placemark.attributes, [](const auto& attribute) { return attribute.second.empty(); });
  return placemark;
}

/// Collects the placemarks below `element`.
Checked<bool> gather(const Element& element, const Around& around, std::vector<Placemark>& placemarks) {
  const std::string name = element.text_of("name");
  const Around here{narrower(around.time, time_of(element)),
                    around.names + (around.names.empty() || name.empty() ? "" : " / ") + name};
  if (const std::string word = word_of_zone(extended_data_of(element)); !word.empty())
    return refuse(about(named_line(element),
                        messages::ingest_feature_message<"kml-not-handed-down">(element.name, word)));
  for (const Element& child : element.children) {
    if (child.name == "NetworkLink")
      return refuse(about(named_line(child), messages::ingest_feature_message<"kml-links-elsewhere">()));
    if (child.name == "Placemark") {
      auto placemark = placemark_of(child, here);
      if (!placemark) return refuse(placemark.error());
      placemarks.push_back(std::move(*placemark));
    } else if (child.name == "Document" || child.name == "Folder") {
      if (auto gathered = gather(child, here, placemarks); !gathered) return gathered;
    }
  }
  return true;
}

/// Adds columns to the layer for all attributes. A name that a placemark has several times gets several
/// columns.
std::map<std::pair<std::string, int>, int> add_columns(OGRLayer& layer,
                                                       const std::vector<Placemark>& placemarks) {
  std::map<std::pair<std::string, int>, int> columns;
  for (const Placemark& placemark : placemarks) {
    std::map<std::string, int> times;
    for (const auto& [name, text] : placemark.attributes) {
      const auto [column, is_new] =
          columns.try_emplace({name, times[name]++}, layer.GetLayerDefn()->GetFieldCount());
      OGRFieldDefn field{name.c_str(), OFTString};
      if (is_new) layer.CreateField(&field);
    }
  }
  return columns;
}

std::shared_ptr<GDALDataset> dataset_of(std::vector<Placemark> placemarks) {
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("Memory");
  std::shared_ptr<GDALDataset> dataset{driver.Create("", 0, 0, 0, GDT_Unknown, nullptr)};
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRLayer& layer = *dataset->CreateLayer("placemarks", &wgs84, wkbUnknown, nullptr);
  const auto columns = add_columns(layer, placemarks);
  for (Placemark& placemark : placemarks) {
    OGRFeature feature{layer.GetLayerDefn()};
    std::map<std::string, int> times;
    for (const auto& [name, text] : placemark.attributes)
      feature.SetField(columns.at({name, times[name]++}), text.c_str());
    feature.SetGeometryDirectly(placemark.geometry.release());
    if (layer.CreateFeature(&feature) != OGRERR_NONE)
      throw std::runtime_error{"a placemark found no room in memory"};
  }
  return dataset;
}

}  // namespace

Checked<std::shared_ptr<GDALDataset>> open_kml(const std::filesystem::path& file) {
  register_drivers();
  std::ifstream stream{file, std::ios::binary};
  const std::string bytes{std::istreambuf_iterator<char>{stream}, {}};
  const auto document = xml::parse(bytes);
  if (!document) return refuse(messages::ingest_feature_message<"kml-unreadable">(document.error()));
  std::vector<Placemark> placemarks;
  if (const auto gathered = gather(*document, {}, placemarks); !gathered) return refuse(gathered.error());
  if (placemarks.empty())
    return refuse(messages::ingest_feature_message<"features-missing">("KML file", "placemarks"));
  return dataset_of(std::move(placemarks));
}

}  // namespace floeplan::ingest
