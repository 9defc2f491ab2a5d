#include "storage/demo/write_demo.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

#include "storage/demo/bathymetry_file.hpp"
#include "storage/demo/current_file.hpp"
#include "storage/demo/disko_bathymetry.hpp"
#include "storage/demo/disko_currents.hpp"
#include "storage/demo/disko_ice.hpp"
#include "storage/demo/disko_icebergs.hpp"
#include "storage/demo/disko_places.hpp"
#include "storage/demo/geojson_files.hpp"
#include "storage/demo/ice_file.hpp"
#include "storage/demo/paper_scenarios.hpp"
#include "storage/demo/readme_text.hpp"
#include "storage/ingest/gshhg_reader.hpp"

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
  write_icebergs(files[3], make_disko_icebergs(relief, seed, start));
  write_coastline(files[4], shoreline(disko::coast_area), disko::coast_area);
  return files;
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  std::ofstream out{file, std::ios::binary | std::ios::trunc};
  out << text;
  out.close();
  if (!out) throw std::runtime_error{"cannot write " + file.string()};
}

}  // namespace

std::optional<Scenario> parse_scenario(std::string_view name) {
  if (name == "disko") return Scenario::disko;
  if (name == "river") return Scenario::river;
  if (name == "jet") return Scenario::jet;
  return std::nullopt;
}

std::vector<std::filesystem::path> write_demo(const std::filesystem::path& dir, Scenario scenario,
                                              std::uint64_t seed, core::UtcTime start) {
  std::filesystem::create_directories(dir);
  switch (scenario) {
    case Scenario::disko: {
      auto files = write_disko(dir, seed, start);
      write_text(dir / "README.txt", disko_readme);
      return files;
    }
    case Scenario::river: {
      auto files = write_river(dir, start);
      write_text(dir / "README.txt", paper_readme);
      return files;
    }
    case Scenario::jet: {
      auto files = write_jet(dir, start);
      write_text(dir / "README.txt", paper_readme);
      return files;
    }
  }
  throw std::logic_error{"Scenario without data"};
}

}  // namespace floeplan::demo
