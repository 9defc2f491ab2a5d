#include <algorithm>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "api/codec/bytes/json_text.hpp"
#include "api/codec/bytes/multipart.hpp"
#include "api/codec/documents/mission_document.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "api/routes/request/message.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/service/flight_check_service.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/core/violation.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// A mission file from a client.
struct UploadedFile {
  std::string name;  // without folders
  std::string bytes;
};

/// The mission files of one request, in the order of the flight.
struct Uploads {
  std::vector<UploadedFile> files;                   // at least one
  nlohmann::json inputs = nlohmann::json::object();  // inputs of the flight in the body, if there are any
  // true: the body is a single file, and the answer is a single document
  bool alone{false};
};

using Read = tl::expected<Uploads, core::Violations>;

constexpr std::size_t longest_file_name = 200;
constexpr std::size_t most_files = 100;  // the number in a mission file's name has two digits

Read fault(const std::string& where, const std::string& rule) {
  return tl::unexpected(core::Violations{{where, rule}});
}

/// The file name without folders; some browsers and scripts send the whole path.
std::string without_folder(const std::string& name) { return name.substr(name.find_last_of("/\\") + 1); }

Read read_form(const Request& request) {
  auto parts = codec::parse_multipart(request.header("content-type"), request.body);
  if (!parts) return fault("", parts.error());
  Uploads uploads;
  for (codec::FormPart& part : *parts) {
    if (!part.file_name.empty())
      uploads.files.push_back({without_folder(part.file_name), std::move(part.content)});
  }
  if (uploads.files.empty()) return fault("", "must hold a part with a file name at least");
  return uploads;
}

Read read_json(const Request& request) {
  const auto document = codec::parse_json(request.body);
  if (!document) return fault("", document.error());
  codec::InputReader reader{*document};
  Uploads uploads;
  const json* files = reader.member("files");
  const bool listed = files != nullptr && files->is_array() && !files->empty();
  if (!listed)
    reader.refuse<"wrong-shape">("/files", "an array of one file at least, each with \"name\" and \"text\"");
  for (std::size_t i = 0; listed && i < files->size() && !reader.is_full(); ++i) {
    const std::string pointer = "/files/" + std::to_string(i);
    if (!(*files)[i].is_object()) {
      reader.refuse<"wrong-shape">(pointer, "an object of a file's \"name\" and its \"text\"");
      continue;
    }
    codec::InputReader file{(*files)[i], pointer};
    const auto name = file.text("name");
    const auto text = file.text("text", request.body.size());
    file.require("name", "the file's name with its ending, .mi or .ma");
    file.require("text", "what the file holds");
    file.refuse_unknown();
    reader.refuse_all("", file.violations());
    uploads.files.push_back({without_folder(name.value_or("")), text.value_or("")});
  }
  if (const json* inputs = reader.member("inputs")) {
    if (!inputs->is_object())
      reader.refuse<"wrong-shape">("/inputs", "an object: departure, vehicle, data and rules");
    uploads.inputs = *inputs;
  }
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  return uploads;
}

Read read_alone(const Request& request) {
  Uploads uploads;
  uploads.files.push_back({request.parameter("name").value_or(""), request.body});
  uploads.alone = true;
  return uploads;
}

/// Reads the body according to its Content-Type. `multipart/form-data`: each part with a file name is a file,
/// in any encoding. `application/json`: {"files": [{"name", "text"}], "inputs": {...}}. Any other type: the
/// body is one file, with its name in the query parameter `name`.
/// Errors   all violations; more than 100 files; names of more than 200 characters
Read read_uploads(const Request& request) {
  const std::string type = core::lower_case(request.header("content-type"));
  Read uploads = type.starts_with("multipart/form-data") ? read_form(request)
                 : type.starts_with("application/json")  ? read_json(request)
                                                         : read_alone(request);
  if (!uploads) return uploads;
  if (uploads->files.size() > most_files) return fault("/files", "must be 100 at most");
  for (const UploadedFile& file : uploads->files) {
    if (file.name.size() > longest_file_name)
      return fault("name", "must be a file name of at most 200 characters");
  }
  return uploads;
}

/// Query parameters that are members of a plan's inputs, too: with one of them the sea is asked.
const std::vector<std::string> texts{"depart",     "vehicle", "currents", "tides",     "tides_mode", "wind",
                                     "bathymetry", "ice",     "icebergs", "coastline", "zones"};
const std::vector<std::string> numbers{"speed_m_s", "dive_depth_m", "margin_m"};

/// Adds the inputs that the query gives to the inputs of the body.
void add_query(const Request& request, json& inputs) {
  for (const std::string& name : texts) {
    if (const auto text = request.parameter(name)) inputs[name] = *text;
  }
  for (const std::string& name : numbers) {
    const auto text = request.parameter(name);
    if (!text) continue;
    const auto number = codec::parse_json(*text);
    inputs[name] = number ? *number : json(*text);
  }
  if (request.parameter("steady")) inputs["steady"] = request.parameter("steady") == "true";
}

/// The vehicle's position in the query or the inputs; it is removed from the inputs.
std::optional<geo::LonLat> take_start(const Request& request, json& inputs, core::Violations& faults) {
  ParameterReader query{request};
  codec::InputReader body{inputs, "/inputs"};
  const auto from_query = query.places("from");
  const auto from_body = body.place("from");
  faults = query.violations();
  faults.insert(faults.end(), body.violations().begin(), body.violations().end());
  inputs.erase("from");
  return from_query ? std::optional{from_query->front()} : from_body;
}

/// Checks the files in the body as one flight. A file that is rejected is a valid answer, not a fault of the
/// request.
Response check_missions(const Context& context, const Request& request, const PathParameters&) {
  auto uploads = read_uploads(request);
  if (!uploads) return invalid(request, uploads.error());
  add_query(request, uploads->inputs);
  core::Violations faults;
  const auto start = take_start(request, uploads->inputs, faults);
  if (!faults.empty()) return invalid(request, faults);

  std::vector<mission::Document> documents;
  for (const UploadedFile& file : uploads->files)
    documents.push_back(mission::read_document(file.name, file.bytes));
  if (!uploads->inputs.empty() || start) {
    faults = service::check_flight(context.db, uploads->inputs, start, documents);
    if (!faults.empty()) return invalid(request, faults);
  }
  if (const auto plan = request.parameter("plan_id")) {
    faults = service::compare_with_plan(context.db, *plan, documents);
    if (!faults.empty()) return invalid(request, faults);
  }
  if (uploads->alone)
    return json_reply(codec::mission_document(documents.front(), uploads->files.front().name));
  json answers = json::array();
  for (std::size_t i = 0; i < documents.size(); ++i)
    answers.push_back(codec::mission_document(documents[i], uploads->files[i].name));
  return json_reply(answers);
}

}  // namespace

std::vector<Route> mission_check_routes() {
  std::vector<std::string> parameters{"name", "from", "plan_id", "steady"};
  parameters.insert(parameters.end(), texts.begin(), texts.end());
  parameters.insert(parameters.end(), numbers.begin(), numbers.end());
  return {{"POST", "/missions/check", parameters, check_missions, Access::viewer}};
}

}  // namespace floeplan::routes
