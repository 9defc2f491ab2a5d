#include "storage/ingest/process/reader_messages.hpp"

#include <cmath>
#include <stdexcept>

#include "storage/json/json.hpp"

namespace floeplan::ingest {
namespace {

using nlohmann::json;

template <class T>
json optional_json(const std::optional<T>& value) {
  return value ? json(*value) : json();
}

std::optional<std::string> optional_text(const json& object, const char* key) {
  const json& value = object.at(key);
  return value.is_null() ? std::nullopt : std::optional{value.get<std::string>()};
}

json to_json(const IngestOptions& options) {
  json at;
  if (options.at) at = {options.at->lon_deg, options.at->lat_deg};
  return {{"name", optional_json(options.name)},
          {"kind", options.kind ? json(repository::kind_name(*options.kind)) : json()},
          {"crs", optional_json(options.crs)},
          {"positive", optional_json(options.positive)},
          {"at", at},
          {"unit", optional_json(options.unit)},
          {"zone_kind", optional_json(options.zone_kind)},
          {"variable", optional_json(options.variable)},
          {"missing", options.missing ? json(*options.missing) : json()},
          {"time_s", options.time ? json(core::unix_seconds(*options.time)) : json()},
          {"archive", optional_json(options.archive)}};
}

IngestOptions options_of(const json& object) {
  IngestOptions options{.name = optional_text(object, "name"),
                        .crs = optional_text(object, "crs"),
                        .positive = optional_text(object, "positive"),
                        .unit = optional_text(object, "unit"),
                        .zone_kind = optional_text(object, "zone_kind"),
                        .variable = optional_text(object, "variable"),
                        .archive = optional_text(object, "archive")};
  if (const auto kind = optional_text(object, "kind")) options.kind = repository::parse_kind(*kind);
  if (const json& missing = object.at("missing"); !missing.is_null()) options.missing = missing.get<double>();
  if (const json& time_s = object.at("time_s"); !time_s.is_null())
    options.time = core::from_unix_seconds(time_s.get<double>());
  if (const json& at = object.at("at"); !at.is_null())
    options.at = geo::LonLat{at.at(0).get<double>(), at.at(1).get<double>()};
  return options;
}

json to_json(const messages::Message& message) {
  json values = json::array();
  for (const auto& [name, value] : message.values)
    std::visit([&](const auto& held) { values.push_back({name, held}); }, value);
  return {{"code", message.code},
          {"rank", messages::rank_name(message.rank)},
          {"values", std::move(values)},
          {"text", message.text},
          {"hint", message.hint}};
}

messages::Value value_of(const json& value) {
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_string()) return value.get<std::string>();
  return value.is_null() ? std::nan("") : value.get<double>();  // JSON has no NaN; it is written as null
}

messages::Message message_of(const json& object) {
  const auto rank = messages::parse_rank(object.at("rank").get<std::string>());
  messages::Message message{.code = object.at("code").get<std::string>(),
                            .rank = rank.value_or(messages::Rank::caution),
                            .text = object.at("text").get<std::string>(),
                            .hint = object.at("hint").get<std::string>()};
  for (const json& value : object.at("values"))
    message.values.push_back({value.at(0).get<std::string>(), value_of(value.at(1))});
  return message;
}

json to_json(const Messages& messages) {
  json all = json::array();
  for (const messages::Message& message : messages) all.push_back(to_json(message));
  return all;
}

Messages messages_of(const json& array) {
  Messages all;
  for (const json& message : array) all.push_back(message_of(message));
  return all;
}

json to_json(const IngestReport& report) {
  return {{"file", report.file},
          {"status", static_cast<int>(report.status)},
          {"dataset", report.dataset ? json(report.dataset->id.value) : json()},
          {"warnings", to_json(report.warnings)},
          {"errors", to_json(report.errors)}};
}

IngestReport report_of(const json& object) {
  IngestReport report;
  report.file = object.at("file");
  const int status = object.at("status");
  if (status == static_cast<int>(IngestStatus::stored)) report.status = IngestStatus::stored;
  if (status == static_cast<int>(IngestStatus::unchanged)) report.status = IngestStatus::unchanged;
  if (const auto id = optional_text(object, "dataset")) report.dataset.emplace().id = {*id};
  report.warnings = messages_of(object.at("warnings"));
  report.errors = messages_of(object.at("errors"));
  return report;
}

ReaderRequest::Task task_of(int number) {
  if (number == static_cast<int>(ReaderRequest::Task::unpack)) return ReaderRequest::Task::unpack;
  if (number == static_cast<int>(ReaderRequest::Task::group)) return ReaderRequest::Task::group;
  if (number == static_cast<int>(ReaderRequest::Task::probe)) return ReaderRequest::Task::probe;
  return ReaderRequest::Task::ingest;
}

Failed::Cause cause_of(int number) {
  if (number == static_cast<int>(Failed::Cause::memory)) return Failed::Cause::memory;
  if (number == static_cast<int>(Failed::Cause::store)) return Failed::Cause::store;
  if (number == static_cast<int>(Failed::Cause::sandbox)) return Failed::Cause::sandbox;
  return Failed::Cause::reader;
}

struct EventToJson {
  json operator()(const Confined& confined) const {
    return {{"confined", {confined.layers.system_calls, confined.layers.landlock}}};
  }
  json operator()(const Progressed& made) const { return {{"progress", {made.stage, made.share}}}; }
  json operator()(const LooksAt& look) const { return {{"looks_at", look.file}}; }
  json operator()(const Grouped& grouped) const { return {{"groups", grouped.groups}}; }
  json operator()(const UnpackedArchive& unpacked) const {
    return {{"unpacked", {unpacked.data, unpacked.left_out}}};
  }
  json operator()(const RowsFollow& rows) const { return {{"rows", rows.bytes}}; }
  json operator()(const Reported& reported) const { return {{"report", to_json(reported.report)}}; }
  json operator()(const Failed& failed) const {
    return {{"failed", {static_cast<int>(failed.cause), failed.reason}}};
  }
  json operator()(const Finished&) const { return {{"finished", true}}; }
};

std::optional<ReaderEvent> event_of(const json& event) {
  if (!event.is_object() || event.size() != 1) return std::nullopt;
  const auto member = event.begin();
  const std::string& name = member.key();
  const json& value = member.value();
  if (name == "confined")
    return Confined{{.system_calls = value.at(0).get<bool>(), .landlock = value.at(1).get<int>()}};
  if (name == "rows") return RowsFollow{value.get<std::size_t>()};
  if (name == "progress") return Progressed{value.at(0), value.at(1)};
  if (name == "looks_at") return LooksAt{value.get<std::size_t>()};
  if (name == "groups") return Grouped{value.get<std::vector<std::vector<std::size_t>>>()};
  if (name == "unpacked")
    return UnpackedArchive{value.at(0).get<std::vector<std::string>>(),
                           value.at(1).get<std::vector<std::string>>()};
  if (name == "report") return Reported{report_of(value)};
  if (name == "failed") return Failed{cause_of(value.at(0).get<int>()), value.at(1)};
  if (name == "finished") return Finished{};
  return std::nullopt;
}

/// A document as text. Messages of libraries about a damaged file may not be valid UTF-8; invalid bytes are
/// replaced.
std::string text_of(const json& document) {
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string to_text(const ReaderRequest& request) {
  const ReaderLimits& limits = request.limits;
  return text_of({{"task", static_cast<int>(request.task)},
                  {"options", to_json(request.options)},
                  {"now_s", core::unix_seconds(request.now)},
                  {"limits",
                   {limits.memory_bytes, limits.address_bytes, limits.cpu_s, limits.wall_s, limits.file_bytes,
                    limits.open_files}},
                  {"allow_weak_sandbox", request.allow_weak_sandbox}});
}

std::string to_text(const ReaderEvent& event) { return text_of(std::visit(EventToJson{}, event)); }

ReaderRequest parse_reader_request(const std::string& text) {
  try {
    const json document = json::parse(text);
    const json& limits = document.at("limits");
    ReaderRequest request;
    request.task = task_of(document.at("task").get<int>());
    request.options = options_of(document.at("options"));
    request.now = core::from_unix_seconds(document.at("now_s").get<double>());
    request.limits = {limits.at(0), limits.at(1), limits.at(2), limits.at(3), limits.at(4), limits.at(5)};
    request.allow_weak_sandbox = document.at("allow_weak_sandbox").get<bool>();
    return request;
  } catch (const std::exception& fault) {
    throw std::runtime_error{std::string{"this is no request to read files: "} + fault.what()};
  }
}

std::optional<ReaderEvent> parse_reader_event(const std::string& line) {
  try {
    return event_of(json::parse(line));
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace floeplan::ingest
