#include "storage/demo/write_demo.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/demo/bathymetry_file.hpp"
#include "storage/demo/current_file.hpp"
#include "storage/demo/disko.hpp"
#include "storage/demo/disko_bathymetry.hpp"
#include "storage/demo/disko_places.hpp"
#include "storage/demo/geojson_files.hpp"
#include "storage/demo/ice_file.hpp"
#include "storage/demo/readme_text.hpp"
#include "storage/demo/scenarios.hpp"
#include "storage/ingest/readers/coastline/gshhg_reader.hpp"

namespace floeplan::demo {
namespace {

constexpr auto shoreline_file = "/usr/share/gmt-gshhg/binned_GSHHS_f.nc";
constexpr int hours = 144;

std::vector<geo::Polygon> shoreline(const geo::BoundingBox& area) {
  if (!std::filesystem::exists(shoreline_file))
    throw std::runtime_error{
        std::string{"the coastline "} + shoreline_file +
        " is missing; the scenario disko is built on it; install the package gmt-gshhg-full"};
  auto land = ingest::read_gshhg(shoreline_file, area);
  if (!land) throw std::runtime_error{land.error().field + ' ' + land.error().rule};
  return std::move(*land);
}

std::vector<std::filesystem::path> write_disko(const std::filesystem::path& dir, std::uint64_t seed,
                                               core::UtcTime start) {
  const std::vector<std::filesystem::path> files{
      dir / "disko-synthetic-bathymetry.tif", dir / "disko-synthetic-currents.nc",
      dir / "disko-synthetic-ice.nc", dir / "disko-synthetic-icebergs.geojson",
      dir / "disko-coastline.geojson"};
  const std::vector<geo::Polygon> land = shoreline(disko::area);
  const Relief relief = make_disko_relief(land, seed);
  const DiskoCurrents currents{relief, land, seed, start};
  std::vector<core::UtcTime> times;
  for (int hour = 0; hour <= hours; ++hour) times.push_back(start + std::chrono::hours{hour});

  write_bathymetry(files[0], relief.frame, relief.elevation_m,
                   "Disko Bay relief: synthetic, not for navigation. Only the coast (GSHHG) is real. Metres, "
                   "positive up.");
  write_currents(files[1],
                 {.title = "Disko Bay currents (synthetic, not for navigation)",
                  .comment = "Synthetic, not for navigation: tide (M2, S2), bay circulation, outflow of the "
                             "icefjord and eddies "
                             "from stream functions on an invented sea bed. No forecast model was run.",
                  .frame = DiskoCurrents::frame(),
                  .depth_m = {0.0, 20.0, 50.0, 100.0, 200.0, 400.0},
                  .times = times,
                  .layer = [&](core::UtcTime time, double depth_m) {
                    CurrentLayer layer{currents.at(depth_m, time), {}};
                    for (std::size_t i = 0; i < layer.flow.east.size(); ++i)
                      layer.masked.push_back(currents.is_masked(i, depth_m));
                    return layer;
                  }});
  std::vector<core::UtcTime> days;
  for (int hour = 0; hour <= hours; hour += 24) days.push_back(start + std::chrono::hours{hour});
  write_ice(files[2],
            {.title = "Disko Bay sea ice (synthetic, not for navigation)",
             .comment = "Synthetic, not for navigation: a field of drift ice in the south of the bay with "
                        "a patch of open water in its middle, drifting westwards. No ice was observed.",
             .frame = DiskoCurrents::frame(),
             .times = days,
             .layer = [&](core::UtcTime time) {
               return make_disko_ice(relief, DiskoCurrents::frame(), seed, time - start);
             }});
  write_icebergs(
      files[3], make_disko_icebergs(relief, seed, start),
      {.name = "Disko Bay icebergs (synthetic, not for navigation)",
       .description = "Synthetic icebergs drawn at random, not for navigation. No berg here was ever seen.",
       .source = ""});
  write_coastline(
      files[4], shoreline(disko::coast_area), disko::coast_area,
      {.name = "Disko Bay coastline (GSHHG, not for navigation)",
       .description =
           "Real coastline: GSHHG 2.3.7, full resolution, cut to the area. Glacier fronts and small "
           "islands may have moved.",
       .source = "GSHHG, Wessel and Smith 1996, J. Geophys. Res. 101, 8741-8743, doi:10.1029/96JB00104",
       .license = "GSHHG, Wessel and Smith 1996, LGPL"});
  return files;
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  std::ofstream out{file, std::ios::binary | std::ios::trunc};
  out << text;
  out.close();
  if (!out) throw std::runtime_error{"cannot write " + file.string()};
}

}  // namespace

const std::vector<std::string>& scenario_names() {
  static const std::vector<std::string> names{"disko", "strait", "pack-ice", "river", "jet"};
  return names;
}

std::optional<Scenario> parse_scenario(std::string_view name) {
  const auto found = std::ranges::find(scenario_names(), name);
  if (found == scenario_names().end()) return std::nullopt;
  return static_cast<Scenario>(found - scenario_names().begin());
}

std::vector<std::string> example_request(Scenario scenario, core::UtcTime start) {
  const std::string depart = core::iso8601(start + std::chrono::hours{6});
  switch (scenario) {
    case Scenario::disko: return {"plan", "--from=-53.20,69.20", "--to=-51.80,69.15", "--depart", depart};
    case Scenario::strait: return {"plan", "--from=-58.90,64.20", "--to=-58.10,64.20", "--depart", depart};
    case Scenario::pack_ice:
      return {
          "plan",  "--from=-65.5,73.0", "--to=-62.5,73.0", "--depart", depart, "--max-time-without-surfacing",
          "PT12H", "--escape-plan"};
    case Scenario::river: return {"plan", "--from=-56.98,66.00", "--to=-56.36,66.02", "--depart", depart};
    case Scenario::jet: return {"plan", "--from=-58.00,66.00", "--to=-56.00,66.00", "--depart", depart};
  }
  throw std::logic_error{"Scenario without an example"};
}

std::vector<std::filesystem::path> write_demo(const std::filesystem::path& dir, Scenario scenario,
                                              std::uint64_t seed, core::UtcTime start) {
  std::filesystem::create_directories(dir);
  const auto with_readme = [&](std::vector<std::filesystem::path> files, std::string_view text) {
    write_text(dir / "README.txt", text);
    return files;
  };
  switch (scenario) {
    case Scenario::disko: return with_readme(write_disko(dir, seed, start), disko_readme);
    case Scenario::strait: return with_readme(write_strait(dir, seed, start), strait_readme);
    case Scenario::pack_ice: return with_readme(write_pack_ice(dir, seed, start), pack_ice_readme);
    case Scenario::river: return with_readme(write_river(dir, start), paper_readme);
    case Scenario::jet: return with_readme(write_jet(dir, start), paper_readme);
  }
  throw std::logic_error{"Scenario without data"};
}

}  // namespace floeplan::demo
