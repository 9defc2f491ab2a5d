#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/bytes/zip_archive.hpp"
#include "api/routes/plans/plan_exports.hpp"
#include "api/service/mission_service.hpp"
#include "api/service/plan_check.hpp"
#include "engine/messages/sentence.hpp"
#include "server/cli/output/file_set.hpp"
#include "server/cli/output/plan_output.hpp"
#include "server/cli/output/violation_output.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct ExportFlags {
  std::string plan_id;
  std::string format{"gliderdos"};
  std::filesystem::path out{"."};
  service::MissionRequest mission;
  std::string firmware{"10.5"};
  std::vector<std::string> safe;
  std::vector<std::string> science;
  std::optional<double> iceberg_depth_m;
  std::string glider;
  bool zip{false};
  bool force{false};
  bool accept_dangers{false};
  bool json_out{false};
};

/// Throws CLI::ValidationError (wrong usage) for a text that is no place.
std::vector<geo::LonLat> safe_places_of(const ExportFlags& flags) {
  std::vector<geo::LonLat> places;
  for (const std::string& text : flags.safe) {
    const auto place = parse_place(text);
    if (!place) throw flag_fault<"not-lon-lat">("--safe", text, "--safe");
    places.push_back(*place);
  }
  return places;
}

/// Throws CLI::ValidationError (wrong usage) for a flag whose text cannot be read.
service::MissionRequest mission_request(const ExportFlags& flags) {
  service::MissionRequest request = flags.mission;
  const auto firmware = service::parse_firmware(flags.firmware);
  if (!firmware) throw flag_fault<"no-firmware">("--firmware", flags.firmware);
  request.firmware = *firmware;
  request.seaglider = flags.format == "seaglider";
  if (!flags.science.empty() && !request.seaglider)
    throw flag_fault<"science-of-another-format">("--science");
  for (const std::string& text : flags.science) {
    const auto band = mission::parse_science_band(text);
    if (!band) throw flag_fault<"no-science-band">("--science", text);
    request.bands.push_back(*band);
  }
  if (flags.safe.empty()) {
    if (flags.iceberg_depth_m) throw flag_fault<"iceberg-depth-without-safe-place">("--iceberg-depth");
    return request;
  }
  request.under_ice.emplace();
  request.under_ice->safe_places = safe_places_of(flags);
  if (flags.iceberg_depth_m)
    request.under_ice->deepest_expected_iceberg = core::Metres{*flags.iceberg_depth_m};
  return request;
}

/// The end where the flag names mission files.
auto format_of(const ExportFlags& flags) {
  return std::ranges::find(routes::export_formats(), flags.format, &routes::ExportFormat::name);
}

/// A page that tells the dangers itself.
bool is_brief(const ExportFlags& flags) {
  const auto format = format_of(flags);
  return format != routes::export_formats().end() && format->is_brief;
}

/// The files of the format, before any is written.
tl::expected<mission::MissionFiles, core::Violations> files_of(sql::Connection& db,
                                                               const repository::PlanRecord& record,
                                                               const ExportFlags& flags,
                                                               const std::vector<messages::Message>& told) {
  if (flags.format == "gliderdos" || flags.format == "seaglider")
    return service::mission_of(db, record, mission_request(flags), now());
  const auto format = format_of(flags);
  auto exported = routes::export_plan(db, record, *format, told, safe_places_of(flags), now());
  if (!exported) return tl::unexpected(exported.error());
  mission::MissionFiles result;
  result.files.push_back({routes::export_file_name(*format, record.id.value), std::move(exported->bytes)});
  result.messages = std::move(exported->messages);
  return result;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names{"gliderdos", "seaglider"};
  for (const auto& format : routes::export_formats()) names.push_back(format.name);
  return names;
}

/// Puts the files in the folder in which a dockserver looks for them; if requested, in one archive.
std::vector<OutputFile> laid_out(const mission::MissionFiles& set, const repository::PlanRecord& record,
                                 const ExportFlags& flags) {
  const std::filesystem::path folder = *service::handover_folder(flags.glider, flags.format == "seaglider");
  std::vector<OutputFile> output;
  std::vector<codec::ArchivedFile> archived;
  for (const auto& file : set.files) {
    output.push_back({folder / file.name, file.text});
    archived.push_back({(folder / file.name).generic_string(), file.text});
  }
  if (!flags.zip) return output;
  return {{record.id.value + ".zip", codec::zip_archive(archived, now())}};
}

/// Checks that a glider's name is a plain folder name, which cannot lead to another folder.
std::string check_glider(const std::string& name) {
  const auto folder = service::handover_folder(name, false);
  return folder ? "" : messages::command_text<"no-such-folder-name">(name, folder.error().rule);
}

/// Refuses to write files of a plan with dangers that were not confirmed.
int refuse(const std::vector<messages::Message>& to_confirm, bool json_out) {
  std::vector<std::string> dangers;
  std::ranges::transform(to_confirm, std::back_inserter(dangers), messages::whole_text);
  if (json_out) std::cout << json{{"status", "dangerous"}, {"dangers", dangers}}.dump(2) << '\n';
  for (const std::string& danger : dangers) complain(could_not, danger);
  return complain<"dangers-not-confirmed">(could_not);
}

int run_export(const ExportFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  const auto record = repository::PlanRepository{db}.find({flags.plan_id});
  if (!record) return complain_of_no_plan(flags.plan_id);

  const service::PlanCheck check = service::check_plan(db, *record);
  std::vector<messages::Message> told = service::all_of(check);
  auto files = files_of(db, *record, flags, told);
  if (!files) return print_violations(files.error(), flags.json_out);
  const std::vector<messages::Message> dangers = check.to_confirm();
  if (!dangers.empty() && !flags.accept_dangers && !is_brief(flags)) return refuse(dangers, flags.json_out);
  std::ranges::move(files->messages, std::back_inserter(told));
  const std::vector<OutputFile> output = laid_out(*files, *record, flags);
  if (const auto there = first_existing(flags.out, output); there && !flags.force) {
    return complain<"file-exists">(could_not, there->string());
  }
  json written = json::array();
  for (const auto& file : write_set(flags.out, output)) {
    written.push_back(file.string());
    if (!flags.json_out) std::cout << file.string() << '\n';
  }
  if (flags.json_out) {
    json document{{"files", written}};
    codec::tell(document, told);
    std::cout << document.dump(2) << '\n';
  }
  for (const messages::Message& message : told)
    std::cerr << messages::rank_name(message.rank) << ": " << messages::whole_text(message) << '\n';
  return done;
}

}  // namespace

void add_export(CLI::App& app, Program& program) {
  auto flags = std::make_shared<ExportFlags>();
  auto* command = app.add_subcommand("export", "Write a plan as mission files");
  command->add_option("PLAN", flags->plan_id, "The plan's id")->required();
  command
      ->add_option(
          "--format", flags->format,
          "One file; or gliderdos, mission files of a Slocum, or seaglider: targets, cmdfile and science")
      ->check(CLI::IsMember(format_names()))
      ->capture_default_str();
  command->add_option("--out", flags->out, "Folder to write into, made when missing")->capture_default_str();
  command->add_option("--number", flags->mission.number, "NN of the first goto_lNN.ma and of all other files")
      ->check(CLI::Range(0, 97))
      ->capture_default_str();
  command->add_flag("--full", flags->mission.full,
                    "Write the mission with yo, surfac, sample and prepar files, too");
  command->add_option("--mission", flags->mission.name, "Name of the mission with --full")
      ->capture_default_str();
  command->add_option("--firmware", flags->firmware, "Firmware version of the vehicle")
      ->capture_default_str();
  command
      ->add_option("--safe", flags->safe,
                   "Safe place in open water for a recovery from under ice, LON,LAT, for example "
                   "--safe=-53.20,69.20; may be repeated; writes "
                   "the full set with its "
                   "ice settings, which a plan below ice or icebergs needs")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--science", flags->science,
          "Band of a Seaglider's science file, DEPTH:SECONDS:SENSORS:GC, from the surface down; may be "
          "repeated; for example 200:10:1110:120")
      ->allow_extra_args(false);
  command->add_option(
      "--iceberg-depth", flags->iceberg_depth_m,
      "Deepest iceberg to expect, metres; default: the deepest keel that the plan passes below, 20 at "
      "least");
  command
      ->add_option(
          "--glider", flags->glider,
          "Name of the glider, for example unit_042: write into gliders/GLIDER/to-glider below --out, "
          "the folder of a dockserver (for a Seaglider: into GLIDER)")
      ->check(check_glider);
  command->add_flag("--zip", flags->zip, "Write one ZIP archive instead of the files");
  command->add_flag("--force", flags->force, "Replace files that exist");
  command->add_flag("--accept-dangers", flags->accept_dangers,
                    "Write a plan that is dangerous by itself or in the newest data, and put the dangers "
                    "among its warnings");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run_export(*flags, program); });
}

}  // namespace floeplan::cli
