#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/codec/plan_csv.hpp"
#include "api/codec/plan_document.hpp"
#include "api/codec/plan_geojson.hpp"
#include "api/codec/plan_gpx.hpp"
#include "api/routes/mission_service.hpp"
#include "server/cli/command.hpp"
#include "server/cli/flag_values.hpp"
#include "server/cli/plan_output.hpp"
#include "server/cli/whole_file.hpp"
#include "storage/repository/migrations.hpp"
#include "storage/repository/plan_repository.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct Flags {
  std::string plan_id;
  std::string format{"gliderdos"};
  std::filesystem::path out{"."};
  routes::MissionRequest mission;
  std::string firmware{"10.5"};
  std::vector<std::string> safe;
  std::optional<double> iceberg_depth_m;
  bool force{false};
  bool json_out{false};
};

/// Throws CLI::ValidationError (wrong usage) for a flag whose text cannot be read.
routes::MissionRequest mission_request(const Flags& flags) {
  routes::MissionRequest request = flags.mission;
  const auto firmware = routes::parse_firmware(flags.firmware);
  if (!firmware) throw CLI::ValidationError{"--firmware", flags.firmware + " is not a version; as 10.5"};
  request.firmware = *firmware;
  if (flags.safe.empty()) {
    if (flags.iceberg_depth_m)
      throw CLI::ValidationError{"--iceberg-depth", "is for work under ice, which takes --safe LON,LAT too"};
    return request;
  }
  request.under_ice.emplace();
  for (const std::string& text : flags.safe) {
    const auto place = parse_place(text);
    if (!place)
      throw CLI::ValidationError{"--safe", text + " is not LON,LAT in degrees; as --safe=-53.2,69.2"};
    request.under_ice->safe_places.push_back(*place);
  }
  if (flags.iceberg_depth_m)
    request.under_ice->deepest_expected_iceberg = core::Metres{*flags.iceberg_depth_m};
  return request;
}

/// The files of the format, before any is written.
tl::expected<mission::MissionFiles, core::Violations> files_of(const repository::PlanRecord& record,
                                                               const Flags& flags) {
  if (flags.format == "gliderdos") return routes::mission_of(record, mission_request(flags), now());
  const std::string& id = record.id.value;
  const planning::Plan plan = codec::parse_plan_document(json::parse(record.document_json));
  mission::MissionFiles result;
  if (flags.format == "gpx") result.files.push_back({id + ".gpx", codec::plan_gpx(plan, id, record.name)});
  if (flags.format == "csv") result.files.push_back({id + ".csv", codec::plan_csv(plan)});
  if (flags.format == "geojson")
    result.files.push_back({id + ".geojson", codec::plan_geojson(record).dump(2) + "\n"});
  return result;
}

/// Nothing is written of a plan that newer data close.
int refuse(const routes::PlanCheck& check, bool json_out) {
  if (json_out) std::cout << json{{"status", "dangerous"}, {"dangers", check.dangers}}.dump(2) << '\n';
  for (const std::string& danger : check.dangers) complain(could_not, danger);
  return complain(could_not,
                  "nothing was written; plan anew in the newest data; --force writes it all the same");
}

int run(const Flags& flags, const Program& program) {
  auto db = repository::open_store(program.store);
  const auto record = repository::PlanRepository{db}.find({flags.plan_id});
  if (!record)
    return complain(could_not, "no plan has the id " + flags.plan_id + "; floeplan plan prints the id");

  routes::PlanCheck check = routes::check_plan(db, *record);
  if (!check.dangers.empty() && !flags.force) return refuse(check, flags.json_out);
  auto files = files_of(*record, flags);
  if (!files) return print_violations(files.error(), flags.json_out);
  files->warnings.insert(files->warnings.begin(), check.warnings.begin(), check.warnings.end());
  files->warnings.insert(files->warnings.begin(), check.dangers.begin(), check.dangers.end());
  std::filesystem::create_directories(flags.out);
  for (const auto& file : files->files) {
    if (!flags.force && std::filesystem::exists(flags.out / file.name)) {
      return complain(could_not,
                      (flags.out / file.name).string() + " exists; nothing was written; --force replaces it");
    }
  }
  json written = json::array();
  for (const auto& file : files->files) {
    write_whole(flags.out / file.name, file.text);
    written.push_back((flags.out / file.name).string());
    if (!flags.json_out) std::cout << (flags.out / file.name).string() << '\n';
  }
  if (flags.json_out) std::cout << json{{"files", written}, {"warnings", files->warnings}}.dump(2) << '\n';
  for (const std::string& warning : files->warnings) std::cerr << "warning: " << warning << '\n';
  return done;
}

}  // namespace

void add_export(CLI::App& app, Program& program) {
  auto flags = std::make_shared<Flags>();
  auto* command = app.add_subcommand("export", "Write a plan as mission files");
  command->add_option("PLAN", flags->plan_id, "The plan's id")->required();
  command->add_option("--format", flags->format, "gliderdos, gpx, geojson or csv")
      ->check(CLI::IsMember({"gliderdos", "gpx", "geojson", "csv"}))
      ->capture_default_str();
  command->add_option("--out", flags->out, "Folder to write into, made when missing")->capture_default_str();
  command->add_option("--number", flags->mission.number, "NN of the first goto_lNN.ma and of all other files")
      ->check(CLI::Range(0, 97))
      ->capture_default_str();
  command->add_flag("--full", flags->mission.full,
                    "Write the mission with yo, surfac, sample and prepar files, too");
  command->add_option("--mission", flags->mission.name, "Name of the mission with --full")
      ->capture_default_str();
  command->add_option("--firmware", flags->firmware, "Of the vehicle")->capture_default_str();
  command
      ->add_option(
          "--safe", flags->safe,
          "Open water to recover to from under ice, LON,LAT; may be repeated; writes the full set with its "
          "ice settings")
      ->allow_extra_args(false);
  command->add_option("--iceberg-depth", flags->iceberg_depth_m,
                      "Deepest iceberg to expect, metres; default 20");
  command->add_flag("--force", flags->force,
                    "Replace files that exist; write a plan that has become dangerous");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run(*flags, program); });
}

}  // namespace floeplan::cli
