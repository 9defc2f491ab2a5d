#include "tests/architecture/include_rules.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace floeplan::support {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The headers that a folder may include besides its own: those of whole folders with everything that these
/// use; single headers; or the headers of a folder without what that folder uses.
struct Folder {
  Names uses;
  Names headers{};
};

/// A folder that only contains other folders stands for all of them.
const std::map<std::string, Folder>& folders() {
  static const std::map<std::string, Folder> all{
      {"engine/elementary", {{}}},
      {"engine/core", {{}}},
      {"engine/tide", {{"engine/core"}}},
      {"engine/geo", {{"engine/core"}}},
      {"engine/messages", {{"engine/geo"}}},
      {"engine/graph", {{"engine/geo"}}},
      {"engine/motion", {{"engine/geo"}}},
      {"engine/ocean/grids", {{"engine/geo"}}},
      {"engine/ocean/currents", {{"engine/ocean/grids", "engine/tide", "engine/messages"}}},
      {"engine/ocean/bed", {{"engine/ocean/grids"}}},
      {"engine/ocean/ice", {{"engine/ocean/grids"}}},
      {"engine/ocean", {{"engine/ocean/currents", "engine/ocean/bed", "engine/ocean/ice"}}},
      {"engine/vehicle", {{"engine/messages"}}},
      {"engine/planning/problem", {{"engine/motion", "engine/ocean", "engine/vehicle"}}},
      {"engine/planning/plane", {{"engine/ocean"}}},
      {"engine/planning/obstacles", {{"engine/planning/plane", "engine/planning/problem"}}},
      {"engine/planning/ice", {{"engine/planning/obstacles"}}},
      {"engine/planning/currents", {{"engine/planning/ice"}}},
      {"engine/planning/energy", {{"engine/planning/currents"}}},
      {"engine/planning/cost", {{"engine/planning/energy", "engine/graph"}}},
      {"engine/planning/optimal_control", {{"engine/planning/cost"}}},
      {"engine/planning/refinement", {{"engine/planning/cost"}}},
      {"engine/planning/search/grid", {{"engine/planning/cost"}}},
      {"engine/planning/search/bounds", {{"engine/planning/search/grid"}}},
      {"engine/planning/search/holding", {{"engine/planning/search/bounds"}}},
      {"engine/planning/search/surfacing", {{"engine/planning/search/bounds"}}},
      {"engine/planning/search", {{"engine/planning/search/surfacing", "engine/planning/search/holding"}}},
      {"engine/planning/search/energy", {{"engine/planning/search"}}},
      {"engine/planning/publish",
       {{"engine/planning/search", "engine/planning/refinement", "engine/planning/optimal_control"}}},
      {"engine/planning/planner", {{"engine/planning/publish", "engine/planning/search/energy"}}},
      {"engine/planning/diagnosis", {{"engine/planning/planner"}}},
      {"engine/planning", {{"engine/planning/diagnosis"}}},
      // Outside of the planner only its six functions, with their arguments and results, are used, and a few
      // further headers.
      {"engine/reproduction", {{"engine/planning/optimal_control", "engine/planning/refinement"}}},
      {"engine/mission/document", {{"engine/planning/problem"}}},
      {"engine/mission/reading", {{"engine/mission/document"}}},
      {"engine/mission/writing", {{"engine/mission/reading"}}},
      {"engine/mission/checking", {{"engine/mission/writing"}, {"engine/planning"}}},
      {"engine/mission", {{"engine/mission/checking"}}},
      {"engine/avoidance", {{"engine/graph", "engine/motion", "engine/vehicle"}}},
      {"engine/simulation/world", {{"engine/planning/ice"}}},
      {"engine/simulation/vehicle", {{"engine/simulation/world", "engine/mission/writing"}}},
      {"engine/simulation/sensors", {{"engine/simulation/vehicle", "engine/avoidance"}}},
      {"engine/simulation/flight", {{"engine/simulation/sensors"}}},
      {"engine/simulation/logs", {{"engine/simulation/flight"}}},
      {"engine/simulation", {{"engine/simulation/logs"}}},
      {"storage/sql/driver", {{}}},
      {"storage/sql/sqlite", {{"storage/sql/driver", "engine/messages"}}},
      {"storage/sql/postgresql", {{"storage/sql/driver", "engine/messages"}}},
      {"storage/sql", {{"storage/sql/sqlite", "storage/sql/postgresql", "engine/core"}}},
      {"storage/sql/copies", {{"storage/sql"}}},
      {"storage/sql/shared", {{"storage/sql"}}},
      {"storage/json", {{}}},
      {"storage/repository/encoding", {{"storage/sql", "engine/geo"}}},
      {"storage/repository/store", {{"storage/repository/encoding", "storage/sql/copies"}}},
      {"storage/repository/datasets", {{"storage/repository/store", "engine/messages"}}},
      {"storage/repository/fields", {{"storage/repository/datasets", "engine/ocean"}}},
      {"storage/repository/features", {{"storage/repository/datasets", "engine/ocean"}}},
      {"storage/repository/environment", {{"storage/repository/fields", "storage/repository/features"}}},
      {"storage/repository/work", {{"storage/repository/store", "storage/sql/shared", "storage/json"}}},
      {"storage/repository/access", {{"storage/repository/store"}}},
      // Contains no code of its own: it stands for all its folders, for users of the store.
      {"storage/repository",
       {{"storage/repository/environment", "storage/repository/work", "storage/repository/access"}}},
      {"storage/xml", {{"engine/core"}}},
      {"storage/sandbox", {{}}},
      {"storage/ingest/common", {{"engine/messages", "storage/repository"}}},
      {"storage/ingest/notation", {{"storage/ingest/common"}}},
      {"storage/ingest/files", {{"storage/ingest/notation"}}},
      {"storage/ingest/formats/zarr", {{"storage/ingest/files"}}},
      {"storage/ingest/formats/hdf5", {{"storage/ingest/files"}}},
      {"storage/ingest/formats/netcdf", {{"storage/ingest/formats/zarr", "storage/ingest/formats/hdf5"}}},
      {"storage/ingest/formats/s100", {{"storage/ingest/formats/netcdf"}}},
      {"storage/ingest/formats/grib", {{"storage/ingest/notation"}}},
      {"storage/ingest/formats/vector", {{"storage/ingest/notation", "storage/xml"}}},
      {"storage/ingest/formats/slocum", {{"storage/ingest/formats/netcdf", "engine/simulation"}}},
      {"storage/ingest/formats/tcd", {{"storage/ingest/notation"}}},
      {"storage/ingest/grids", {{"storage/ingest/formats/s100"}}},
      {"storage/ingest/readers/velocity", {{"storage/ingest/grids"}}},
      {"storage/ingest/readers/currents",
       {{"storage/ingest/readers/velocity", "storage/ingest/formats/grib"}}},
      {"storage/ingest/readers/bathymetry", {{"storage/ingest/grids"}}},
      {"storage/ingest/readers/tides", {{"storage/ingest/readers/velocity", "storage/ingest/formats/tcd"}}},
      {"storage/ingest/readers/icebergs", {{"storage/ingest/formats/vector"}}},
      {"storage/ingest/readers/zones", {{"storage/ingest/formats/vector"}}},
      {"storage/ingest/readers/ice", {{"storage/ingest/grids", "storage/ingest/readers/zones"}}},
      {"storage/ingest/readers/coastline", {{"storage/ingest/readers/zones"}}},
      {"storage/ingest/readers/tracks",
       {{"storage/ingest/readers/velocity", "storage/ingest/formats/slocum"}}},
      {"storage/ingest",
       {{"storage/ingest/readers/currents", "storage/ingest/readers/bathymetry",
         "storage/ingest/readers/tides", "storage/ingest/readers/icebergs", "storage/ingest/readers/ice",
         "storage/ingest/readers/coastline", "storage/ingest/readers/tracks"}}},
      {"storage/ingest/process", {{"storage/ingest", "storage/sandbox"}}},
      {"storage/demo", {{"storage/ingest"}}},
      {"api/problems", {{"engine/messages"}}},
      {"api/fields", {{"storage/repository", "engine/simulation"}}},
      {"api/codec/bytes", {{"engine/messages", "storage/json"}}},
      {"api/codec/reading", {{"api/codec/bytes", "api/fields"}}},
      {"api/codec/route_files", {{"api/codec/reading", "engine/mission", "storage/xml"}}},
      {"api/codec/inputs", {{"api/codec/route_files"}, {"engine/planning/cost/layout.hpp"}}},
      {"api/codec/documents", {{"api/codec/inputs", "api/problems"}, {"engine/planning"}}},
      {"api/codec/features", {{"api/codec/documents"}}},
      {"api/codec/exports", {{"api/codec/features"}}},
      {"api/codec", {{"api/codec/exports"}}},
      {"api/service",
       {{"storage/ingest/process", "api/codec", "api/log"},
        {"engine/planning", "engine/planning/search/route_ground.hpp"}}},
      {"api/openapi", {{}}},
      {"api/log", {{"engine/core"}}},
      {"api/routes/request", {{"api/codec", "api/openapi", "api/log"}}},
      {"api/routes/access", {{"api/routes/request"}}},
      {"api/routes/features", {{"api/routes/request"}}},
      {"api/routes/edr", {{"api/routes/features"}}},
      {"api/routes/plans", {{"api/routes/features"}, {"api/service"}}},
      {"api/routes/processes", {{"api/routes/access"}}},
      {"api/routes/data", {{"api/routes/access"}, {"api/service"}}},
      {"api/routes/server", {{"api/routes/access"}}},
      {"api/routes",
       {{"api/routes/edr", "api/routes/plans", "api/routes/processes", "api/routes/data",
         "api/routes/server"}}},
      {"server/jobs",
       {{"api/service", "api/log"},
        {"api/routes/request/job_gateway.hpp", "engine/planning/search/route_ground.hpp"}}},
      // The HTTP server only knows messages and problems, and no resource.
      {"server/http",
       {{"engine/core", "engine/messages", "api/log", "api/problems"},
        {"api/codec/bytes/sha256.hpp", "api/routes/request/message.hpp", "api/routes/request/reply.hpp"}}},
      {"server/manual", {{"engine/messages"}}},
      {"server/cli/program", {{"api/codec"}}},
      {"server/cli/output", {{"server/cli/program", "engine/reproduction"}}},
      {"server/cli/serving", {{"server/cli/program", "api/routes", "server/http", "server/jobs"}}},
      {"server/cli", {{"server/cli/output", "server/cli/serving", "server/manual", "storage/demo"}}},
      {"server", {{"server/cli"}}},
  };
  return all;
}

/// A library, recognised by the beginning of its headers, and the folders that may include it, with their
/// subfolders.
struct Library {
  std::regex header;
  Names allowed;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> all{
      {std::regex{"fstream|iostream|thread"}, {"storage", "api", "server"}},
      {std::regex{"spdlog/.*"}, {"api/log"}},
      {std::regex{"fmt/.*"}, {"engine/messages"}},
      {std::regex{"nlohmann/json_fwd.*"}, {"storage", "api", "server"}},
      {std::regex{"nlohmann/(?!json_fwd\\.hpp).*"}, {"storage/json"}},
      {std::regex{"gdal.*|ogr.*|cpl_.*"}, {"storage/ingest", "storage/demo"}},
      {std::regex{"seccomp\\.h"}, {"storage/sandbox"}},
      {std::regex{"expat\\.h"}, {"storage/xml"}},
      {std::regex{"sqlite3.*|SQLiteCpp/.*"}, {"storage/sql/sqlite"}},
      {std::regex{"libpq-fe\\.h"}, {"storage/sql/postgresql"}},
      {std::regex{"boost/(beast|asio).*|openssl/ssl.*"}, {"server"}},
  };
  return all;
}

void add_reach(const std::string& folder, Names& reached) {
  if (!reached.insert(folder).second) return;
  for (const std::string& used : folders().at(folder).uses) add_reach(used, reached);
}

bool may_include(const std::string& from, const fs::path& header) {
  const Names& headers = folders().at(from).headers;
  if (headers.contains(header.generic_string()) || headers.contains(header.parent_path().generic_string()))
    return true;
  Names reached;
  add_reach(from, reached);
  return reached.contains(header.parent_path().generic_string());
}

/// Whether the folder or one above it may include the library.
bool knows(const Library& library, const std::string& folder) {
  for (fs::path place = folder; !place.empty(); place = place.parent_path())
    if (library.allowed.contains(place.generic_string())) return true;
  return false;
}

/// Why `folder` may not include this header; empty if it may.
std::string fault_of(const fs::path& root, const std::string& folder, bool quoted,
                     const std::string& header) {
  for (const Library& library : libraries()) {
    if (std::regex_match(header, library.header) && !knows(library, folder)) {
      return folder + " must not know <" + header + ">";
    }
  }
  if (!quoted) return "";
  if (header.starts_with(".") || !fs::exists(root / header))
    return "\"" + header + "\" is no path from the root";
  if (!may_include(folder, header)) return folder + " must not use \"" + header + "\"";
  return "";
}

void check_file(const fs::path& root, const fs::path& file, std::vector<std::string>& faults) {
  static const std::regex include_line{R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)"};
  const std::string folder = file.parent_path().generic_string();
  if (!folders().contains(folder)) {
    faults.push_back(file.generic_string() + ":1: " + folder + " is not in the list of folders");
    return;
  }
  std::ifstream lines{root / file};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch parts;
    if (!std::regex_match(line, parts, include_line)) continue;
    const std::string fault = fault_of(root, folder, parts[1] == "\"", parts[2]);
    if (!fault.empty()) faults.push_back(file.generic_string() + ":" + std::to_string(number) + ": " + fault);
  }
}

}  // namespace

std::vector<std::string> broken_include_rules(const fs::path& root) {
  std::vector<fs::path> files;
  for (const char* layer : {"engine", "storage", "api", "server"}) {
    for (const auto& entry : fs::recursive_directory_iterator{root / layer}) {
      const fs::path ending = entry.path().extension();
      if (ending == ".hpp" || ending == ".cpp") files.push_back(entry.path().lexically_relative(root));
    }
  }
  std::sort(files.begin(), files.end());

  std::vector<std::string> faults;
  for (const fs::path& file : files) check_file(root, file, faults);
  return faults;
}

}  // namespace floeplan::support
