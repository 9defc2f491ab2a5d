#include "storage/ingest/file_groups.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/files/sidecar.hpp"
#include "storage/ingest/format_of.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"
#include "storage/ingest/readers/currents/adcirc_file.hpp"
#include "storage/ingest/readers/tides/tide_layout.hpp"
#include "storage/ingest/readers/tides/tide_variables.hpp"
#include "storage/ingest/readers/tracks/seaglider_log.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {
namespace {

/// A file, with the facts that decide which other files it belongs to.
struct Member {
  std::filesystem::path path;
  std::shared_ptr<const NetcdfFile> netcdf;  // null: the file makes a group of its own
  VelocityParts parts{VelocityParts::none};
  std::vector<double> times;           // times of the velocity
  std::vector<NetcdfDimension> plane;  // horizontal dimensions of the velocity
  bool tables_alone{false};            // holds positions, but no velocity
  bool chart{false};                   // a cell of S-57, or an update of a cell
  // names the glider's track; the same for all files of a track; empty: no track
  std::string track;
  int segment{};             // number of the log's segment, or of the dive
  bool sensor_cache{false};  // a sensor list, to which binary logs refer
  bool transports{false};    // holds transports of a tide, without depths
  bool tide_depths{false};   // the grid file of such a tide model
  // the one component of a tidal current that the file holds
  std::optional<ocean::TideQuantity> tide_component;
  std::optional<tide::Constituent> constituent;  // constituent in the file's name
  std::optional<AdcircHead> adcirc;              // head of a file of an ADCIRC run
  bool taken{false};
};

void describe_velocity(Member& member) {
  const auto pair = find_some_velocity(*member.netcdf);
  if (pair == nullptr) return;
  if (const auto plane = plane_of(*member.netcdf, *pair))
    member.plane = {pair->dimensions()[plane->y], pair->dimensions()[plane->x]};
  for (const NetcdfDimension& dimension : pair->dimensions()) {
    const NetcdfVariable* coordinate = coordinate_of(*member.netcdf, dimension);
    if (coordinate == nullptr || role_of(*coordinate) != AxisRole::time) continue;
    Messages ignored;
    if (const auto times = time_nodes(*coordinate, ignored)) member.times = times->nodes;
  }
}

Member member_of(const std::filesystem::path& path) {
  Member member;
  member.path = path;
  const auto format = format_of(path);
  const Together together = format ? (*format)->together : Together::none;
  member.chart = together == Together::chart_updates;
  if (together == Together::glider_log) {
    const SlocumName name = slocum_name_of(path);
    const bool binary = (*format)->writing == Writing::binary;  // the same again where both are given
    if (!name.mission.empty()) member.track = name.mission + (binary ? " binary" : "");
    member.segment = name.segment;
  }
  if (together == Together::seaglider_dives) {
    if (const auto dive = seaglider_dive_of(first_bytes(path, 4096))) {
      member.track = dive->mission;
      member.segment = dive->dive;
    }
  }
  if (together == Together::seaexplorer_dives) {
    const SeaexplorerName name = seaexplorer_name_of(path);
    member.track = name.mission;
    member.segment = name.dive;
  }
  if (together == Together::adcirc_run) member.adcirc = adcirc_head(first_bytes(path, 4096));
  member.sensor_cache = !format && holds_sensor_cache(path);
  if (together != Together::model_output) return member;
  auto file = NetcdfFile::open(path);
  if (!file) return member;
  if (is_seaglider_dive(*file)) {
    member.track = seaglider_mission_of(*file);
    return member;
  }
  if (is_glider_track(*file)) {  // a track may have hundreds of files, so none stays open
    member.track = trajectory_of(*file);
    return member;
  }
  member.netcdf = std::make_shared<const NetcdfFile>(std::move(*file));
  member.parts = velocity_parts(*member.netcdf);
  member.tables_alone = member.parts == VelocityParts::none && !holds_tides(*member.netcdf) &&
                        holds_position_tables(*member.netcdf);
  member.transports = needs_tide_depths(*member.netcdf);
  member.tide_depths = holds_tide_depths_alone(*member.netcdf);
  member.tide_component = lone_tide_component(*member.netcdf);
  member.constituent = constituent_named_in(path.stem().string());
  if (member.parts != VelocityParts::none) describe_velocity(member);
  return member;
}

/// Whether tables lie on the horizontal grid of a velocity. A staggered grid may differ by one row and one
/// column.
bool fits(const Member& tables, const Member& velocity) {
  const auto near = [](std::uint64_t a, std::uint64_t b) { return (a > b ? a - b : b - a) <= 1; };
  return velocity.plane.size() == 2 &&
         std::ranges::any_of(tables.netcdf->variables(), [&](const NetcdfVariable& variable) {
           const auto& dimensions = variable.dimensions();
           return dimensions.size() >= 2 &&
                  near(dimensions[dimensions.size() - 2].size, velocity.plane[0].size) &&
                  near(dimensions.back().size, velocity.plane[1].size);
         });
}

/// Whether a file is an update of a chart, as CELL.001 is of CELL.000.
bool is_update_of(const Member& update, const Member& base) {
  return update.chart && base.chart && base.path.extension() == ".000" && &update != &base &&
         update.path.parent_path() == base.path.parent_path() && update.path.stem() == base.path.stem();
}

bool is_update_of_another(const Member& member, const std::vector<Member>& members) {
  return std::ranges::any_of(members, [&](const Member& base) { return is_update_of(member, base); });
}

/// Adds the files that belong to a file by their name alone.
void take_sidecars(const Member& main, std::vector<Member>& members, FileGroup& group) {
  for (Member& part : members) {
    if (part.taken || !is_sidecar_of(part.path, main.path)) continue;
    part.taken = true;
    group.push_back(part.path);
  }
}

bool is_sidecar_of_another(const Member& member, const std::vector<Member>& members) {
  return std::ranges::any_of(members,
                             [&](const Member& main) { return is_sidecar_of(member.path, main.path); });
}

void take_updates(const Member& base, std::vector<Member>& members, FileGroup& group) {
  for (Member& update : members) {
    if (!is_update_of(update, base)) continue;
    update.taken = true;
    group.push_back(update.path);
  }
}

/// Adds the other files of the same track. The order of the group does not depend on the order of the files
/// given.
void take_rest_of_track(const Member& first, std::vector<Member>& members, FileGroup& group) {
  std::vector<Member*> parts;
  for (Member& part : members)
    if (!first.track.empty() && part.track == first.track) parts.push_back(&part);
  std::ranges::sort(parts, {}, [](const Member* part) {
    return std::tuple{part->segment, part->path.filename(), part->path};
  });
  if (!parts.empty()) group.clear();
  for (Member* part : parts) {
    part->taken = true;
    group.push_back(part->path);
  }
}

/// Adds the sensor lists to which the group's binary logs refer. Several groups may use the same list.
void add_sensor_caches(std::vector<Member>& members, FileGroup& group) {
  const FileGroup logs = group;
  for (Member& cache : members) {
    const auto names_it = [&](const std::filesystem::path& log) { return is_cache_of(cache.path, log); };
    if (!cache.sensor_cache || std::ranges::none_of(logs, names_it)) continue;
    cache.taken = true;
    group.push_back(cache.path);
  }
}

/// Adds the mesh and the elevations of an ADCIRC run: those with the same number of nodes as its currents.
void add_parts_of_run(const Member& currents, std::vector<Member>& members, FileGroup& group) {
  if (!currents.adcirc || currents.adcirc->part != AdcircPart::currents) return;
  for (const AdcircPart wanted : {AdcircPart::mesh, AdcircPart::elevations}) {
    const auto part = std::ranges::find_if(members, [&](const Member& other) {
      return !other.taken && other.adcirc && other.adcirc->part == wanted &&
             other.adcirc->nodes == currents.adcirc->nodes;
    });
    if (part == members.end()) continue;
    part->taken = true;
    group.push_back(part->path);
  }
}

bool waits_for_currents(const Member& member, const std::vector<Member>& members) {
  return member.adcirc && member.adcirc->part != AdcircPart::currents &&
         std::ranges::any_of(members, [&](const Member& other) {
           return other.adcirc && other.adcirc->part == AdcircPart::currents;
         });
}

/// FES stores the two components of the tidal current of a constituent in two files, in separate folders.
void add_other_tide_component(const Member& member, std::vector<Member>& members, FileGroup& group) {
  const auto other = std::ranges::find_if(members, [&](const Member& candidate) {
    return !candidate.taken && candidate.tide_component &&
           candidate.tide_component != member.tide_component && candidate.constituent &&
           candidate.constituent == member.constituent;
  });
  if (other == members.end()) return;
  other->taken = true;
  group.push_back(other->path);
}

/// Adds the grid files of the tide model, which the files of all constituents need.
void add_tide_depths(std::vector<Member>& members, FileGroup& group) {
  for (Member& depths : members) {
    if (!depths.tide_depths) continue;
    depths.taken = true;
    group.push_back(depths.path);
  }
}

}  // namespace

std::vector<FileGroup> group_files(const std::vector<std::filesystem::path>& files,
                                   const std::function<void(std::size_t)>& looking_at) {
  std::vector<FileGroup> groups;
  if (files.size() == 1) return {files};
  const GdalMessages quiet;
  std::vector<Member> members;
  for (const auto& file : files) {
    if (looking_at) looking_at(members.size());
    members.push_back(member_of(file));
  }

  for (Member& member : members) {
    if (member.taken || member.tables_alone || member.sensor_cache || member.tide_depths ||
        waits_for_currents(member, members) || is_update_of_another(member, members) ||
        is_sidecar_of_another(member, members))
      continue;
    FileGroup group{member.path};
    if (member.parts == VelocityParts::first_alone || member.parts == VelocityParts::second_alone) {
      const VelocityParts wanted = member.parts == VelocityParts::first_alone ? VelocityParts::second_alone
                                                                              : VelocityParts::first_alone;
      const auto partner = std::ranges::find_if(members, [&](const Member& other) {
        return !other.taken && other.parts == wanted && other.times == member.times;
      });
      if (partner != members.end()) {
        partner->taken = true;
        group.push_back(partner->path);
      }
    }
    member.taken = true;
    take_sidecars(member, members, group);
    if (member.chart) take_updates(member, members, group);
    take_rest_of_track(member, members, group);
    add_sensor_caches(members, group);
    add_parts_of_run(member, members, group);
    if (member.tide_component) add_other_tide_component(member, members, group);
    if (member.transports) add_tide_depths(members, group);
    if (member.parts != VelocityParts::none)
      for (Member& tables : members)
        if (tables.tables_alone && fits(tables, member)) {
          tables.taken = true;
          group.push_back(tables.path);
        }
    groups.push_back(std::move(group));
  }
  for (const Member& member : members)
    if (!member.taken) groups.push_back({member.path});
  return groups;
}

}  // namespace floeplan::ingest
