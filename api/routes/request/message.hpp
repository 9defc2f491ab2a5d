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

/// A response that was put off is asked for again with this.
struct Resumption {
  std::string token;  // what the response that waited had put into its Wait
  bool last{false};   // the time is up: answer now
};

/// A body that was written to disk while it came in. The file is removed after the answer unless it was moved away.
struct BodyFile {
  std::filesystem::path path;
  std::string sha256;  // lower-case hexadecimal
};

/// Who asks: the name is that of a token, and owns what is asked for.
struct Caller {
  std::string name;
  repository::Role role{repository::Role::viewer};
  std::string token_key{};  // when the token itself was shown, not a login that was opened with it
};

/// The caller of a server that runs open, for this machine alone.
inline const Caller local_caller{"local", repository::Role::admin};

/// An HTTP request, free of sockets.
struct Request {
  std::string method;
  std::string path;  // percent-decoded, without the query
  std::vector<std::pair<std::string, std::string>>
      query;                                   // decoded, in order; of repeats the last one counts
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;
  std::optional<BodyFile> body_file;  // then `body` is empty
  core::UtcTime now;
  std::string id;                // in the answer's X-Request-Id and in every line of the log
  std::string peer;              // address of the client, or of the proxy before it
  std::optional<Caller> caller;  // set by the doorkeeper; nothing: nobody has said who asks
  std::optional<Resumption> resumption;

  /// Empty text when there is no such header.
  [[nodiscard]] std::string header(const std::string& lower_case_name) const;
  [[nodiscard]] std::optional<std::string> parameter(const std::string& name) const;
};

/// Asks the server to call the handler again with `token` after `wake` or when the time is up.
struct Wait {
  core::Seconds at_most{};
  std::string token;
  /// Begins to listen; the returned object ends it. `wake` may be called from any thread, any number of
  /// times.
  std::function<std::shared_ptr<void>(std::function<void()> wake)> subscribe;
};

/// An HTTP response, free of sockets. With `wait` set everything else is ignored, unless it streams.
struct Response {
  int status{200};
  std::string content_type;
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  std::optional<Wait> wait;
  /// The body is a piece of a stream. With `wait` the handler is asked for the next piece after a wake-up, or with
  /// `last` when the time is up; a piece without `wait` is the stream's end.
  bool streams{false};
  std::string route;   // pattern of the operation that answered, for log and counts; empty: none did
  std::string caller;  // name, for the log
};

/// Notes that the response depends on this header of the request.
void vary_by(Response& response, const std::string& header);

/// Answers one request. May block on the store, so never called on an I/O thread; may be called from several
/// at once.
using Handler = std::function<Response(const Request&)>;

/// Splits "path?a=b" into path and query and decodes both. Nothing when a percent sign is not followed by two
/// hexadecimal digits, or a NUL would result.
struct Target {
  std::string path;
  std::vector<std::pair<std::string, std::string>> query;
};
[[nodiscard]] std::optional<Target> parse_target(std::string_view target);

}  // namespace floeplan::routes
