#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "api/routes/request/message.hpp"
#include "engine/core/violation.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {

/// A mission file as a client sent it.
struct UploadedFile {
  std::string name;  // without folders
  std::string bytes;
};

/// The mission files of one request, in the order in which they are flown.
struct Uploads {
  std::vector<UploadedFile> files;                   // one at least
  nlohmann::json inputs = nlohmann::json::object();  // of the flight, where the body gives them
  bool alone{false};                                 // the body is the file, and so the answer is one too
};

/// Reads the body by its Content-Type. `multipart/form-data`: each part with a file name is a file, whatever its
/// encoding. `application/json`: {"files": [{"name", "text"}], "inputs": {...}}. Anything else: the body is one file,
/// named by the parameter `name`.
/// Errors   every violation; more than 100 files, names of more than 200 characters
[[nodiscard]] tl::expected<Uploads, core::Violations> read_uploads(const Request& request);

}  // namespace floeplan::routes
