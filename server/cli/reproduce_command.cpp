#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>

#include "engine/reproduction/figure.hpp"
#include "engine/reproduction/tables.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using reproduction::ReproducedRow;

using reproduction::Figure;

/// Length of a degree of the WGS84 equator.
constexpr double metres_per_degree = 111'319.490'793;

json plane_position(geo::PlanePoint point) { return {point.x_m, point.y_m}; }

json plane_positions(const std::vector<geo::PlanePoint>& points) {
  json positions = json::array();
  for (const geo::PlanePoint point : points) positions.push_back(plane_position(point));
  return positions;
}

/// Converts positions in nested lists, of any depth, from the plane to the map.
json on_map(const json& plane, double unit_m) {
  json result = json::array();
  for (const json& each : plane) {
    result.push_back(each.is_array() ? on_map(each, unit_m)
                                     : json(each.get<double>() * unit_m / metres_per_degree));
  }
  return result;
}

json feature(const Figure& figure, const char* type, const json& plane, json properties) {
  properties["plane_xy"] = plane;
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", on_map(plane, figure.unit_m)}}},
          {"properties", std::move(properties)}};
}

void add_panel(json& features, const Figure& figure, const reproduction::FigurePanel& panel) {
  for (const auto& path : panel.paths) {
    if (path.points.size() < 2) continue;  // at the departure there is no line yet
    features.push_back(feature(figure, "LineString", plane_positions(path.points),
                               {{"kind", "path"},
                                {"name", path.name},
                                {"travel_time", path.travel_time},
                                {"stroke", path.colour},
                                {"panel", panel.title}}));
  }
  for (const auto& obstacle : panel.obstacles) {
    const std::vector<geo::PlanePoint> ring{obstacle.low,
                                            {obstacle.high.x_m, obstacle.low.y_m},
                                            obstacle.high,
                                            {obstacle.low.x_m, obstacle.high.y_m},
                                            obstacle.low};
    features.push_back(feature(figure, "Polygon", json::array({plane_positions(ring)}),
                               {{"kind", "obstacle"}, {"panel", panel.title}}));
  }
  for (const auto& arrow : panel.arrows) {
    features.push_back(feature(figure, "Point", plane_position(arrow.at),
                               {{"kind", "current"},
                                {"x_velocity", arrow.current.x_m_s},
                                {"y_velocity", arrow.current.y_m_s},
                                {"panel", panel.title}}));
  }
  if (panel.vehicle) {
    features.push_back(feature(figure, "Point", plane_position(*panel.vehicle),
                               {{"kind", "vehicle"}, {"panel", panel.title}}));
  }
}

/// The figure as GeoJSON (RFC 7946): paths, start, goal, obstacles, arrows of the current. The paper's waters
/// are at no place on Earth. For maps they are put on the equator at 0 E; each feature has its plane
/// coordinates in the property plane_xy, as the note of the collection explains.
json figure_geojson(const Figure& figure) {
  json features = json::array();
  features.push_back(feature(figure, "Point", plane_position(figure.start), {{"kind", "start"}}));
  features.push_back(feature(figure, "Point", plane_position(figure.goal), {{"kind", "goal"}}));
  for (const auto& panel : figure.panels) add_panel(features, figure, panel);
  return {{"type", "FeatureCollection"},
          {"title", figure.title},
          {"note",
           "A model water that lies nowhere on Earth: on the map its origin is at 0 N 0 E and one unit of "
           "its plane is " +
               std::to_string(static_cast<int>(figure.unit_m)) +
               " m. The property plane_xy has the coordinates x, y in the plane's own units."},
          {"features", std::move(features)}};
}

template <class T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

json table_document(const std::vector<ReproducedRow>& rows) {
  json table = json::array();
  for (const ReproducedRow& row : rows) {
    table.push_back({{"row", row.printed.row},
                     {"paper_s", or_null(row.printed.paper_s)},
                     {"verified_s", or_null(row.printed.verified_s)},
                     {"ours_s", or_null(row.ours_s)},
                     {"ours_at_default_tolerance_s", or_null(row.ours_at_default_tolerance_s)},
                     {"vertices", or_null(row.vertices)},
                     {"edges", or_null(row.edges)},
                     {"paper_edges", or_null(row.printed.paper_edges)},
                     {"saving_pct", or_null(row.saving_pct)},
                     {"deviation_pct", or_null(row.deviation_pct)},
                     {"remark", row.printed.remark}});
  }
  return table;
}

template <class T>
std::string table_cell(const std::optional<T>& value, const char* format) {
  if (!value) return "-";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, static_cast<double>(*value));
  return text.data();
}

/// A percentage; small negative values become 0, because they would be printed as "-0.00".
std::optional<double> percent(const std::optional<double>& value) {
  if (!value || std::abs(*value) >= 0.005) return value;
  return 0.0;
}

void print_rows(const char* title, const std::vector<ReproducedRow>& rows) {
  std::printf("%s\n%-23s %8s %8s %8s %8s %8s %6s %6s %8s %7s\n", title, "method", "paper", "verified", "ours",
              "at 1e-4", "vertices", "edges", "print", "saving %", "dev. %");
  for (const ReproducedRow& row : rows) {
    std::printf("%-23s %8s %8s %8s %8s %8s %6s %6s %8s %7s  %s\n", row.printed.row.c_str(),
                table_cell(row.printed.paper_s, "%.3f").c_str(),
                table_cell(row.printed.verified_s, "%.3f").c_str(), table_cell(row.ours_s, "%.3f").c_str(),
                table_cell(row.ours_at_default_tolerance_s, "%.3f").c_str(),
                table_cell(row.vertices, "%.0f").c_str(), table_cell(row.edges, "%.0f").c_str(),
                table_cell(row.printed.paper_edges, "%.0f").c_str(),
                table_cell(percent(row.saving_pct), "%.2f").c_str(),
                table_cell(percent(row.deviation_pct), "%.2f").c_str(), row.printed.remark.c_str());
  }
}

struct ReproduceFlags {
  std::string figures;  // folder for figures; empty: none
  bool force{false};
  bool json_out{false};
};

std::filesystem::path figure_file(const ReproduceFlags& flags, int number, const char* extension) {
  return std::filesystem::path{flags.figures} / ("figure_" + std::to_string(number) + extension);
}

/// Writes a file via a temporary one, so that a reader never sees half of it. An existing file is replaced.
/// Errors   std::runtime_error when it cannot be written
void write_whole(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path part = file.string() + ".part";
  {
    std::ofstream stream{part, std::ios::binary | std::ios::trunc};
    stream << text;
    stream.flush();
    if (!stream) throw std::runtime_error{messages::command_text<"file-not-written">(file.string())};
  }
  std::filesystem::rename(part, file);
}

int write_figures(const ReproduceFlags& flags) {
  for (int number = reproduction::first_figure; number <= reproduction::last_figure; ++number) {
    for (const char* extension : {".svg", ".geojson"}) {
      const std::filesystem::path file = figure_file(flags, number, extension);
      if (flags.force || !std::filesystem::exists(file)) continue;
      return complain<"file-exists">(could_not, file.string());
    }
  }
  std::filesystem::create_directories(flags.figures);
  json written = json::array();
  const auto write = [&](const std::filesystem::path& file, const std::string& text) {
    write_whole(file, text);
    written.push_back(file.string());
    if (!flags.json_out) std::cout << file.string() << '\n';
  };
  for (const reproduction::Figure& figure : reproduction::reproduce_figures()) {
    write(figure_file(flags, figure.number, ".svg"), reproduction::figure_svg(figure));
    write(figure_file(flags, figure.number, ".geojson"), figure_geojson(figure).dump(1) + '\n');
  }
  if (flags.json_out) std::cout << json{{"files", written}}.dump(2) << '\n';
  return done;
}

int print_tables(bool json_out) {
  const auto table_2 = reproduction::reproduce_table_2();
  const auto table_3 = reproduction::reproduce_table_3();
  if (json_out) {
    std::cout << json{{"table_2", table_document(table_2)}, {"table_3", table_document(table_3)}}.dump(2)
              << '\n';
    return done;
  }
  print_rows("Table II: crossing a river (Eichhorn 2009), times in seconds", table_2);
  std::printf("\n");
  print_rows("Table III: a meandering jet; start and goal are a stand-in, since the paper prints none",
             table_3);
  return done;
}

}  // namespace

void add_reproduce(CLI::App& app, Program& program) {
  auto flags = std::make_shared<ReproduceFlags>();
  auto* command = app.add_subcommand("reproduce", "Print the paper's tables beside our numbers");
  command
      ->add_option("--figures", flags->figures,
                   "Write Figures 5 to 10 as SVG and GeoJSON into this folder, made when missing, instead")
      ->type_name("DIR");
  command->add_flag("--force", flags->force, "Replace figures that exist");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] {
    program.exit_code = flags->figures.empty() ? print_tables(flags->json_out) : write_figures(*flags);
  });
}

}  // namespace floeplan::cli
