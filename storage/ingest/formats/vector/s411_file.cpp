#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/messages/ingest_feature_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/formats/vector/vector_files.hpp"
#include "storage/ingest/notation/crs_text.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::ingest {
namespace {

using xml::Element;

constexpr const char* geographic_crs = "EPSG:4326";
constexpr const char* undetermined_total = "99";

/// Attributes for the partial stages in the order of icesod: three of the egg code, traces, and the rest.
constexpr std::array stage_names{"SA", "SB", "SC", "CN", "CD"};
/// Attributes of the egg code for partial concentrations and forms, in the order of iceapc and iceflz; for
/// display only.
constexpr std::array part_names{"CA", "CB", "CC"};
constexpr std::array form_names{"FA", "FB", "FC"};

struct IceArea {
  std::unique_ptr<OGRPolygon> shape;
  std::string crs;  // the reference system, as text of the file
  std::string total;
  std::vector<std::string> stages;
  std::vector<std::string> parts;
  std::vector<std::string> forms;
};

std::string line_words(const Element& element) { return "line " + std::to_string(element.line); }

tl::unexpected<Messages> corners_unreadable(const Element& element) {
  return refuse(about(line_words(element), messages::ingest_feature_message<"ice-gml-corners-unreadable">()));
}

/// The numbers in "[87, '85', 99]" or "87", without brackets, quotes and commas.
std::vector<std::string> codes_in(const std::string& text) {
  std::vector<std::string> codes;
  for (const char c : text) {
    if (is_digit(c)) {
      if (codes.empty()) codes.emplace_back();
      codes.back() += c;
    } else if (!codes.empty() && !codes.back().empty()) {
      codes.emplace_back();
    }
  }
  if (!codes.empty() && codes.back().empty()) codes.pop_back();
  return codes;
}

/// The SIGRID-3 code for a total concentration.
std::string total_of(const std::string& iceact) {
  const std::vector<std::string> codes = codes_in(iceact);
  if (codes.size() != 1) return undetermined_total;
  const auto value = parse_number(codes.front());
  return value && *value >= 1.0 && *value <= 4.0 ? "02" : codes.front();
}

std::string stage_of(const std::string& icesod) { return icesod == "1" || icesod == "01" ? "00" : icesod; }

/// The corners of a ring; `latitude_first` says that x and y have to be exchanged.
Checked<OGRLinearRing> ring_of(const Element& boundary, bool latitude_first) {
  const Element* const ring = boundary.child("LinearRing");
  const Element* const list = ring == nullptr ? nullptr : ring->child("posList");
  if (list == nullptr) return corners_unreadable(boundary);
  OGRLinearRing line;
  std::vector<double> numbers;
  for (const std::string& word : words_between_blanks(list->text)) {
    const auto value = parse_number(word);
    if (!value) return corners_unreadable(*list);
    numbers.push_back(*value);
  }
  if (numbers.size() < 8 || numbers.size() % 2 != 0)  // three corners and the first one repeated
    return corners_unreadable(*list);
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (latitude_first && std::abs(numbers[i]) > 90.0)
      return refuse(about(line_words(*list),
                          messages::ingest_feature_message<"ice-gml-axes-swapped">(number(numbers[i]))));
    line.addPoint(numbers[latitude_first ? i + 1 : i], numbers[latitude_first ? i : i + 1]);
  }
  line.closeRings();
  return line;
}

Checked<std::unique_ptr<OGRPolygon>> area_polygon(const Element& element, bool latitude_first) {
  auto polygon = std::make_unique<OGRPolygon>();
  for (const char* const boundary : {"exterior", "interior"}) {
    for (const Element& side : element.children) {
      if (side.name != boundary) continue;
      auto ring = ring_of(side, latitude_first);
      if (!ring) return refuse(ring.error());
      polygon->addRing(&*ring);
    }
  }
  if (polygon->getExteriorRing() == nullptr) return corners_unreadable(element);
  return polygon;
}

/// "EPSG:3995" from any notation of a reference system's name.
std::string crs_of_name(const std::string& srs_name) {
  if (srs_name.empty()) return geographic_crs;
  const std::size_t end = srs_name.find_last_not_of("0123456789");
  return end == std::string::npos ? srs_name : "EPSG:" + srs_name.substr(end + 1);
}

Checked<IceArea> area_of(const Element& feature) {
  const Element* const polygon = feature.child("Polygon");
  if (polygon == nullptr)
    return refuse(
        about(line_words(feature), messages::ingest_feature_message<"ice-gml-area-without-polygon">()));
  IceArea area;
  area.crs = crs_of_name(polygon->attribute("srsName"));
  auto shape = area_polygon(*polygon, area.crs == geographic_crs);
  if (!shape) return refuse(shape.error());
  area.shape = std::move(*shape);
  area.total = total_of(feature.text_of("iceact"));
  area.stages = codes_in(feature.text_of("icesod"));
  area.parts = codes_in(feature.text_of("iceapc"));
  area.forms = codes_in(feature.text_of("iceflz"));
  if (area.stages.size() > stage_names.size())
    return refuse(about(line_words(feature), messages::ingest_feature_message<"ice-gml-stages-too-many">()));
  return area;
}

std::shared_ptr<GDALDataset> dataset_of_areas(std::vector<IceArea> areas, OGRSpatialReference& crs) {
  GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("Memory");
  std::shared_ptr<GDALDataset> dataset{driver.Create("", 0, 0, 0, GDT_Unknown, nullptr)};
  OGRLayer& layer = *dataset->CreateLayer("seaice", &crs, wkbPolygon, nullptr);
  for (const char* const name :
       {"POLY_TYPE", "CT", "SA", "SB", "SC", "CN", "CD", "CA", "CB", "CC", "FA", "FB", "FC"}) {
    OGRFieldDefn field{name, OFTString};
    layer.CreateField(&field);
  }
  for (IceArea& area : areas) {
    OGRFeature feature{layer.GetLayerDefn()};
    feature.SetField("POLY_TYPE", "I");
    feature.SetField("CT", area.total.c_str());
    for (std::size_t i = 0; i < area.stages.size(); ++i)
      feature.SetField(stage_names.at(i), stage_of(area.stages[i]).c_str());
    for (std::size_t i = 0; i < std::min(area.parts.size(), part_names.size()); ++i)
      feature.SetField(part_names.at(i), area.parts[i].c_str());
    for (std::size_t i = 0; i < std::min(area.forms.size(), form_names.size()); ++i)
      feature.SetField(form_names.at(i), area.forms[i].c_str());
    feature.SetGeometryDirectly(area.shape.release());
    if (layer.CreateFeature(&feature) != OGRERR_NONE)
      throw std::runtime_error{"an area of ice found no room in memory"};
  }
  return dataset;
}

}  // namespace

bool is_s411(std::string_view head) {
  const std::string root = xml::root_name(head);
  return root == "IceDataSet" || (root == "Dataset" && head.find("S-411") != std::string_view::npos);
}

Checked<std::shared_ptr<GDALDataset>> open_s411(const std::filesystem::path& file, Messages& told) {
  register_drivers();
  std::ifstream stream{file, std::ios::binary};
  const std::string bytes{std::istreambuf_iterator<char>{stream}, {}};
  const auto document = xml::parse(bytes);
  if (!document) return refuse(messages::ingest_feature_message<"ice-gml-unreadable">(document.error()));
  if (document->name != "IceDataSet")
    return refuse(messages::ingest_feature_message<"ice-gml-edition-not-read">());

  std::vector<IceArea> areas;
  std::set<std::string> left_out;
  for (const Element& member : document->children) {
    for (const Element& feature : member.children) {
      if (member.name != "IceFeatureMember") continue;
      if (feature.name != "seaice") {
        left_out.insert(feature.name);
        continue;
      }
      auto area = area_of(feature);
      if (!area) return refuse(area.error());
      if (!areas.empty() && area->crs != areas.front().crs)
        return refuse(messages::ingest_feature_message<"ice-gml-several-crs">(areas.front().crs, area->crs));
      areas.push_back(std::move(*area));
    }
  }
  if (areas.empty())
    return refuse(messages::ingest_feature_message<"features-missing">("S-411 chart", "areas of sea ice"));
  OGRSpatialReference crs;
  if (!read_crs(areas.front().crs, crs))
    return refuse(messages::ingest_feature_message<"ice-gml-crs-unknown">(areas.front().crs));
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!left_out.empty())
    told.push_back(messages::ingest_feature_message<"ice-gml-features-left-out">(
        enumeration({left_out.begin(), left_out.end()})));
  return dataset_of_areas(std::move(areas), crs);
}

}  // namespace floeplan::ingest
