#include <iostream>
#include <memory>

#include "api/service/ingest_service.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/sentence.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/store/migrations.hpp"

namespace floeplan::cli {
namespace {

struct IngestFlags {
  std::vector<std::string> files;
  std::optional<std::string> name;
  std::string kind{"auto"};
  std::optional<std::string> crs;
  std::optional<std::string> positive;
  std::optional<std::string> variable;
  std::optional<double> missing;
  std::optional<std::string> time;
  std::optional<std::string> at;
  std::optional<std::string> unit;
  std::optional<std::string> zone_kind;
  bool json_out{false};
  bool allow_weak_sandbox{false};
};

void complain_of(const ingest::IngestReport& report) {
  for (const messages::Message& error : report.errors)
    complain(bad_data, report.file + ": " + messages::sentence(error));
  if (!report.technical_cause.empty())
    complain(bad_data,
             report.file + ": technical cause, for a report of this fault: " + report.technical_cause);
}

void print_report(const ingest::IngestReport& report) {
  std::cout << service::status_name(report.status) << "  " << report.file;
  if (report.dataset) {
    const repository::Dataset& dataset = *report.dataset;
    std::cout << "  " << repository::kind_name(dataset.kind) << "  " << dataset.id.value << "  "
              << repository::rows_text(dataset.kind, dataset.rows_accepted) << " accepted";
    if (dataset.rows_refused > 0) std::cout << ", " << dataset.rows_refused << " refused";
  }
  std::cout << '\n';
  for (const messages::Message& warning : report.warnings)
    std::cout << "  " << messages::rank_name(warning.rank) << ": " << messages::sentence(warning) << '\n';
  std::cout.flush();
  complain_of(report);
}

int run_ingest(const IngestFlags& flags, const Program& program) {
  ingest::IngestOptions options{
      .name = flags.name, .crs = flags.crs, .positive = flags.positive, .variable = flags.variable};
  options.missing = flags.missing;
  options.unit = flags.unit;
  options.zone_kind = flags.zone_kind;
  if (flags.time) {
    options.time = core::parse_iso8601(*flags.time);
    if (!options.time) throw flag_fault<"no-moment">("--time", *flags.time);
  }
  if (flags.at) {
    options.at = parse_place(*flags.at);
    if (!options.at || !geo::is_valid(*options.at))
      throw flag_fault<"not-lon-lat">("--at", *flags.at, "--at");
  }
  if (flags.kind != "auto") options.kind = repository::parse_kind(flags.kind);

  auto db = open_store(program);
  int exit_code = done;
  const auto tell = [&](const ingest::IngestReport& report) {
    if (report.status == ingest::IngestStatus::refused) exit_code = bad_data;
    if (!flags.json_out) return print_report(report);
    complain_of(report);
  };
  std::vector<std::filesystem::path> files(flags.files.begin(), flags.files.end());
  for (std::filesystem::path& file : files)
    if (!file.has_filename()) file = file.parent_path();  // "ice.zarr/" without its slash
  const ingest::Guard guard{.program = own_program(),
                            .staging = program.store / "incoming",
                            .allow_weak_sandbox = flags.allow_weak_sandbox};
  const auto reports =
      ingest::guarded_ingest(db, guard, files, options, now(), {}, terminal_progress(), tell);
  if (flags.json_out) std::cout << service::report_document(reports).dump(2) << '\n';
  return exit_code;
}

}  // namespace

void add_ingest(CLI::App& app, Program& program) {
  auto flags = std::make_shared<IngestFlags>();
  auto* command = app.add_subcommand("ingest", "Read data files into the store");
  command
      ->add_option("FILE", flags->files,
                   "Bathymetry, currents, tides, sea ice, icebergs, coastline, zones or tracks of gliders, "
                   "packed (zip, KMZ, tar, gz) or "
                   "not; files that belong together (both components of a current, a model's grid, the "
                   "segments of a glider's mission) in one "
                   "command")
      ->required();
  command->add_option("--name", flags->name, "Name of the dataset; default: the file's name");
  command->add_option("--kind", flags->kind, "Kind of data in the file")
      ->check(CLI::IsMember({"auto", "bathymetry", "currents", "ice", "icebergs", "coastline", "tides",
                             "water-levels", "wind", "zones", "glider-tracks"}))
      ->capture_default_str();
  command->add_option("--crs", flags->crs,
                      "Reference system, if the file states none, for example EPSG:4326");
  command
      ->add_option("--positive", flags->positive,
                   "Sign of bathymetry, if the file does not state it: up (elevation) or down (depth)")
      ->check(CLI::IsMember({"up", "down"}));
  command->add_option("--variable", flags->variable,
                      "Variable to use of a file that holds several: a component of the currents (its pair "
                      "is used, too), or a concentration of sea ice (default: the greatest)");
  command->add_option(
      "--missing", flags->missing,
      "Number that marks missing values, if a NetCDF file does not declare it, for example -99.99");
  command->add_option(
      "--time", flags->time,
      "Valid time of sea ice, or start of a run of ADCIRC, if the file does not state it; for "
      "example 2026-11-20T12:00:00Z");
  command->add_option("--at", flags->at,
                      "Position of a tide station, LON,LAT, if the file does not state it; for example "
                      "--at=-53.20,69.20");
  command
      ->add_option(
          "--unit", flags->unit,
          "Unit, if the file does not state it: of a tide station's amplitudes (m, cm, mm, ft) or of a "
          "concentration of sea ice (share of 1, percent)")
      ->check(CLI::IsMember({"m", "cm", "mm", "ft", "share", "percent"}));
  command
      ->add_option("--zone-kind", flags->zone_kind,
                   "Rule of zones, if the file states none: no_go or stay_in")
      ->check(CLI::IsMember({"no_go", "stay_in"}));
  command->add_flag("--allow-weak-sandbox", flags->allow_weak_sandbox,
                    "Read files even if this machine cannot confine the reading process");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run_ingest(*flags, program); });
}

}  // namespace floeplan::cli
