#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "engine/reproduction/figure_svg.hpp"
#include "engine/reproduction/figures.hpp"
#include "engine/reproduction/tables.hpp"
#include "server/cli/output/figure_geojson.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using reproduction::ReproducedRow;

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

/// A percentage; never "-0.00".
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
  std::string figures;  // folder; empty: no figures
  bool force{false};
  bool json_out{false};
};

std::filesystem::path figure_file(const ReproduceFlags& flags, int number, const char* extension) {
  return std::filesystem::path{flags.figures} / ("figure_" + std::to_string(number) + extension);
}

/// Writes a file, all or nothing: a reader never sees half of it. An existing one is replaced.
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
