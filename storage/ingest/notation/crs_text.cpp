#include "storage/ingest/notation/crs_text.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t longest_text = 65'536;  // WKT of compound systems takes a few thousand bytes

bool consists_of(std::string_view text, std::string_view others) {
  return !text.empty() && std::ranges::all_of(text, [&](unsigned char c) {
    return std::isalnum(c) != 0 || others.find(static_cast<char>(c)) != std::string_view::npos;
  });
}

/// "EPSG:3413", "EPSG:4326+5773", "urn:ogc:def:crs:OGC:1.3:CRS84"
bool is_code(std::string_view text) {
  constexpr auto authorities = std::to_array<std::string_view>(
      {"epsg:", "esri:", "ogc:", "crs:", "iau_2015:", "ignf:", "nkg:", "urn:ogc:def:crs"});
  const std::string small = lower(std::string{text});
  return consists_of(text, ":+._,-") &&
         std::ranges::any_of(authorities, [&](auto start) { return small.starts_with(start); });
}

/// A name of the OGC in the form of a URL; GDAL parses it and contacts no server.
bool is_name_of_ogc(std::string_view text) {
  constexpr auto starts = std::to_array<std::string_view>(
      {"http://www.opengis.net/def/crs/", "https://www.opengis.net/def/crs/", "http://opengis.net/def/crs/",
       "https://opengis.net/def/crs/", "http://www.opengis.net/gml/srs/epsg.xml#"});
  return std::ranges::any_of(starts, [&](std::string_view start) {
    return text.starts_with(start) && consists_of(text.substr(start.size()), "/_.");
  });
}

/// Whether the text has the form of a name: "WGS84", "NAD83".
bool is_name(std::string_view text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
         consists_of(text, " _");
}

/// Whether a definition names a grid or a file for a datum shift of PROJ. "@null" is no grid; GDAL writes it
/// into the definition of web map projections.
bool names_files(const std::string& definition) {
  const std::string small = lower(definition);
  for (const char* const word :
       {"parameterfile", "geoidgrids", "+grids", "+file", "+init", "pipeline", "/vsi"})
    if (small.find(word) != std::string::npos) return true;
  constexpr std::string_view grids = "nadgrids";
  for (std::size_t at = small.find(grids); at != std::string::npos; at = small.find(grids, at + 1))
    if (small.compare(at + grids.size(), 6, "=@null") != 0) return true;
  return false;
}

/// Whether a text is a PROJ string whose parameters are known and have a number or a plain word.
bool is_proj_string(const std::string& text) {
  constexpr auto keys = std::to_array<std::string_view>(
      {"proj",    "lat_0",   "lat_1",   "lat_2",   "lat_3",    "lat_ts", "lat_b",     "lon_0",    "lon_1",
       "lon_2",   "lon_3",   "lonc",    "alpha",   "gamma",    "k",      "k_0",       "x_0",      "y_0",
       "zone",    "south",   "datum",   "ellps",   "a",        "b",      "r",         "r_a",      "rf",
       "f",       "e",       "es",      "units",   "to_meter", "vunits", "vto_meter", "no_defs",  "type",
       "wktext",  "over",    "pm",      "axis",    "h",        "sweep",  "towgs84",   "lon_wrap", "o_proj",
       "o_lat_p", "o_lon_p", "o_lon_c", "o_alpha", "m",        "n",      "w",         "no_off",   "no_rot",
       "no_uoff", "geoc",    "nadgrids"});
  if (!text.starts_with("+proj=")) return false;
  std::istringstream words{text};
  for (std::string word; words >> word;) {
    const std::size_t equals = std::min(word.find('='), word.size());
    if (word.front() != '+' || std::ranges::find(keys, lower(word.substr(1, equals - 1))) == keys.end())
      return false;
    const std::string value = word.substr(std::min(equals + 1, word.size()));
    if (!value.empty() && value != "@null" && !consists_of(value, "_.,+-'")) return false;
  }
  return true;
}

bool is_definition(std::string_view text) {
  constexpr auto keywords = std::to_array<std::string_view>(
      {"geogcs", "projcs", "geoccs", "compd_cs", "vert_cs", "local_cs", "geogcrs", "geographiccrs", "geodcrs",
       "geodeticcrs", "projcrs", "projectedcrs", "compoundcrs", "boundcrs", "vertcrs", "derivedprojcrs",
       "engcrs"});
  if (text.starts_with("{")) return true;  // PROJJSON
  const std::string word = lower(trimmed(std::string{text.substr(0, text.find_first_of("[("))}));
  return text.find_first_of("[(") != std::string_view::npos &&
         std::ranges::find(keywords, word) != keywords.end();
}

}  // namespace

bool read_crs(const std::string& text, OGRSpatialReference& crs) {
  crs.Clear();
  const std::string clean = trimmed(text);
  if (clean.size() > longest_text || clean.find('\0') != std::string::npos || names_files(clean))
    return false;
  if (!is_definition(clean) && !is_code(clean) && !is_name_of_ogc(clean) && !is_name(clean) &&
      !is_proj_string(clean))
    return false;
  const GdalMessages messages;
  return crs.SetFromUserInput(clean.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) ==
         OGRERR_NONE;
}

}  // namespace floeplan::ingest
