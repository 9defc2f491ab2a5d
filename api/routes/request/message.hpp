#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/repository/access/token_repository.hpp"

namespace floeplan::routes {

/// Passed to the handler when it is called again for a response that waits.
struct Resumption {
  std::string token;  // the token in the Wait of the earlier response
  bool last{false};   // the time is up: answer now
};

/// A body that was written to disk while it was received. The file is removed after the answer unless it was
/// moved.
struct BodyFile {
  std::filesystem::path path;
  std::string sha256;  // lower-case hexadecimal
};

/// The caller: name and role of the token. The name is the owner of what the caller requests.
struct Caller {
  std::string name;
  repository::Role role{repository::Role::viewer};
  std::string token_key{};  // set if the request contains the token itself, not a login with it
};

/// The caller on a server without tokens, which only this machine can reach.
inline const Caller local_caller{"local", repository::Role::admin};

/// An HTTP request, independent of sockets.
struct Request {
  std::string method;
  std::string path;  // percent-decoded, without the query
  std::vector<std::pair<std::string, std::string>>
      // decoded, in order; of a repeated parameter the last one counts
      query;
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;
  std::optional<BodyFile> body_file;  // if set, `body` is empty
  core::UtcTime now;             // by the clock of the store
  std::string id;                // for X-Request-Id in the answer, and for the log
  std::string peer;              // address of the client, or of the proxy
  std::optional<Caller> caller;  // set by the doorkeeper; empty: not identified
  std::optional<Resumption> resumption;

  /// The value of a header; empty if there is none.
  [[nodiscard]] std::string header(const std::string& lower_case_name) const;
  [[nodiscard]] std::optional<std::string> parameter(const std::string& name) const;
};

/// Asks the server to call the handler again with `token`, after `wake` was called or when the time is up.
struct Wait {
  core::Seconds at_most{};
  std::string token;
  /// Starts listening until the returned object is destroyed. `wake` may be called from any thread and any
  /// number of times.
  std::function<std::shared_ptr<void>(std::function<void()> wake)> subscribe;
};

/// An HTTP response, independent of sockets. If `wait` is set, all other members are ignored unless the
/// response streams.
struct Response {
  int status{200};
  std::string content_type;
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  std::optional<Wait> wait;
  /// The body is a piece of a stream. With `wait` the handler is called for the next piece after a wake-up,
  /// or with `last` when the time is up. A piece without `wait` ends the stream.
  bool streams{false};
  std::string route;   // pattern of the operation that answered, for the log and the counts; empty: none
  std::string caller;  // name, for the log
};

/// Adds the name of a request header on which the response depends to Vary.
void vary_by(Response& response, const std::string& header);

/// Answers one request. It may block on the store, so it must not run on an I/O thread. Several calls may run
/// at the same time.
using Handler = std::function<Response(const Request&)>;

/// Splits "path?a=b" into path and query and decodes both. nullopt if a percent sign is not followed by two
/// hexadecimal digits, or a decoded character is NUL.
struct Target {
  std::string path;
  std::vector<std::pair<std::string, std::string>> query;
};
[[nodiscard]] std::optional<Target> parse_target(std::string_view target);

}  // namespace floeplan::routes
