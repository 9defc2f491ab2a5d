#include "api/routes/plans/mission_uploads.hpp"

#include "api/codec/bytes/json_text.hpp"
#include "api/codec/bytes/multipart.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "engine/core/letter_case.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using Read = tl::expected<Uploads, core::Violations>;

constexpr std::size_t longest_file_name = 200;
constexpr std::size_t most_files = 100;  // numbers of argument files have two digits

Read fault(const std::string& where, const std::string& rule) {
  return tl::unexpected(core::Violations{{where, rule}});
}

/// Some browsers and scripts send the path of a file for its name.
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
    reader.refuse<"wrong-shape">("/files",
                                 "an array of one file at least, each with \"name\" and \"text\"");
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

}  // namespace

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

}  // namespace floeplan::routes
