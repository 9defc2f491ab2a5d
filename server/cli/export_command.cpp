#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/codec/plan_csv.hpp"
#include "api/codec/plan_document.hpp"
#include "api/codec/plan_geojson.hpp"
#include "api/codec/plan_gpx.hpp"
#include "api/routes/mission_service.hpp"
#include "server/cli/command.hpp"
#include "server/cli/plan_output.hpp"
#include "storage/repository/migrations.hpp"
#include "storage/repository/plan_repository.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct Flags {
  std::string plan_id;
  std::string format{"gliderdos"};
  std::filesystem::path out{"."};
  int number{10};
  bool force{false};
  bool json_out{false};
};

/// All or nothing of one file: a reader never sees half of it.
void write_whole(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path part = file.string() + ".part";
  {
    std::ofstream stream{part, std::ios::binary | std::ios::trunc};
    stream << text;
    stream.flush();
    if (!stream)
      throw std::runtime_error{file.string() + " cannot be written; check the folder and the free space"};
  }
  std::filesystem::rename(part, file);
}

/// The files of the format, before any is written.
tl::expected<mission::GotoLists, core::Violations> files_of(const repository::PlanRecord& record,
                                                            const Flags& flags) {
  if (flags.format == "gliderdos") return routes::mission_of(record, flags.number, now());
  const std::string& id = record.id.value;
  const planning::Plan plan = codec::parse_plan_document(json::parse(record.document_json));
  mission::GotoLists result;
  if (flags.format == "gpx") result.files.push_back({id + ".gpx", codec::plan_gpx(plan, id, record.name)});
  if (flags.format == "csv") result.files.push_back({id + ".csv", codec::plan_csv(plan)});
  if (flags.format == "geojson")
    result.files.push_back({id + ".geojson", codec::plan_geojson(record).dump(2) + "\n"});
  return result;
}

int run(const Flags& flags, const Program& program) {
  auto db = repository::open_store(program.store);
  const auto record = repository::PlanRepository{db}.find({flags.plan_id});
  if (!record)
    return complain(could_not, "no plan has the id " + flags.plan_id + "; floeplan plan prints the id");

  const auto files = files_of(*record, flags);
  if (!files) return print_violations(files.error(), flags.json_out);
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
  command->add_option("--number", flags->number, "NN of the first goto_lNN.ma")
      ->check(CLI::Range(0, 97))
      ->capture_default_str();
  command->add_flag("--force", flags->force, "Replace files that exist");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run(*flags, program); });
}

}  // namespace floeplan::cli
