#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <utility>

#include "api/codec/documents/mission_document.hpp"
#include "api/fields/process_fields.hpp"
#include "api/service/flight_check_service.hpp"
#include "engine/core/shown_text.hpp"
#include "engine/mission/document/file_text.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "server/cli/output/plan_output.hpp"
#include "server/cli/output/violation_output.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "server/cli/program/input_flags.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/store/migrations.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct CheckFlags {
  std::vector<std::string> files;
  std::optional<std::string> from;
  std::optional<std::string> plan;
  InputFlags sea;
  bool json_out{false};
};

/// The bytes of a file; at most one more than the reader's limit, so that the reader can refuse a file that
/// is too large.
std::optional<std::string> read_bytes(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::string bytes(mission::max_file_bytes + 1, '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) && !stream.eof())
    return std::nullopt;
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

bool is_mission_file(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return file.extension() == ".ma" || file.extension() == ".mi" || name == "targets" || name == "science" ||
         name == "cmdfile";
}

/// The files as named, and instead of a folder the mission files in it, in the order of their names. A folder
/// without mission files stays.
std::vector<std::string> with_files_of_folders(const std::vector<std::string>& named) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    std::vector<std::string> found;
    std::error_code error;  // a folder that cannot be read holds no files
    for (const auto& entry : std::filesystem::directory_iterator{name, error})
      if (is_mission_file(entry.path())) found.push_back(entry.path().string());
    std::ranges::sort(found);
    if (found.empty()) found.push_back(name);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

mission::Document document_of(const std::string& file) {
  const std::string name = std::filesystem::path{file}.filename().string();
  if (const auto bytes = read_bytes(file)) return mission::read_document(name, *bytes);
  mission::Document unreadable;
  unreadable.name = name;
  const bool is_folder = std::filesystem::is_directory(file);
  unreadable.messages.push_back(
      {0, mission::Severity::error, "unreadable",
       is_folder
           ? "the folder holds no mission files (.ma, .mi, targets, science, cmdfile); name these files, "
             "or the folder that holds them"
           : "the file cannot be read; check its name and rights"});
  return unreadable;
}

/// The verdict as everything else printed for people has it: refused.
std::string verdict_word(mission::Verdict verdict) {
  return verdict == mission::Verdict::reject ? "refused" : mission::verdict_name(verdict);
}

void print_document(const mission::Document& document, const std::string& file) {
  std::printf("%s: %s", file.c_str(), verdict_word(document.verdict()).c_str());
  if (document.kind == mission::DocumentKind::arguments && !document.behaviors.empty())
    std::printf(", %s", document.behaviors.front().name.c_str());
  if (document.kind == mission::DocumentKind::mission && !document.behaviors.empty())
    std::printf(", mission of %s", core::counted(document.behaviors.size(), "behavior").c_str());
  for (const auto& [count, thing] :
       {std::pair{document.bands.size(), "depth band"}, std::pair{document.waypoints.size(), "waypoint"}})
    if (count > 0) std::printf(", %s", core::counted(count, thing).c_str());
  std::printf("\n");
  for (const auto& message : document.messages) {
    const std::string line = message.line > 0 ? "line " + std::to_string(message.line) + ": " : "";
    std::printf("  %s%s: %s [%s]\n", line.c_str(), mission::severity_name(message.severity).c_str(),
                message.text.c_str(), message.code.c_str());
  }
}

/// The files as read; if a departure, a start or a plan is given, also checked in the stored data.
tl::expected<std::vector<mission::Document>, core::Violations> judged(const CheckFlags& flags,
                                                                      const Program& program) {
  std::vector<mission::Document> documents;
  documents.reserve(flags.files.size());
  for (const std::string& file : flags.files) documents.push_back(document_of(file));
  const json inputs = flags.sea.inputs();
  if (inputs.empty() && !flags.from && !flags.plan) return documents;

  std::optional<geo::LonLat> start;
  if (flags.from) {
    start = parse_place(*flags.from);
    if (!start) throw flag_fault<"not-lon-lat">("--from", *flags.from, "--from");
  }
  auto db = open_store(program);
  core::Violations faults;
  if (!inputs.empty() || start) faults = service::check_flight(db, inputs, start, documents);
  if (faults.empty() && flags.plan) faults = service::compare_with_plan(db, *flags.plan, documents);
  if (!faults.empty()) return tl::unexpected(faults);
  return documents;
}

int run_check(const CheckFlags& flags, const Program& program) {
  const auto documents = judged(flags, program);
  if (!documents)
    return print_violations(documents.error(), flags.json_out, flags_of(fields::Process::evaluate_route));
  bool rejected = false;
  json answers = json::array();
  for (std::size_t i = 0; i < documents->size(); ++i) {
    const mission::Document& document = (*documents)[i];
    rejected = rejected || document.verdict() == mission::Verdict::reject;
    if (flags.json_out) {
      answers.push_back(codec::mission_document(document, flags.files[i]));
    } else {
      print_document(document, flags.files[i]);
    }
  }
  if (flags.json_out) std::cout << answers.dump(2, ' ', false, json::error_handler_t::replace) << '\n';
  return rejected ? bad_data : done;
}

}  // namespace

void add_check(CLI::App& app, Program& program) {
  auto flags = std::make_shared<CheckFlags>();
  auto* command = app.add_subcommand(
      "check",
      "Read mission files (.ma, .mi; a Seaglider's targets, science, cmdfile) and judge them; "
      "with --depart as one flight through the stored data");
  command
      ->add_option("FILE", flags->files,
                   "Mission files, lists in the order in which they are flown; or a folder of them")
      ->required();
  command->add_option("--from", flags->from, "Where the vehicle is, LON,LAT; default: the first waypoint");
  command->add_option(
      "--plan", flags->plan,
      "Id of a stored plan, for example p0123456789ab: tell where goto lists and holds differ from it");
  flags->sea.add_request(*command, "the inputs of process evaluate-route, without a route");
  flags->sea.add(*command, fields::conditions_of_route());
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] {
    flags->files = with_files_of_folders(flags->files);
    program.exit_code = run_check(*flags, program);
  });
}

}  // namespace floeplan::cli
