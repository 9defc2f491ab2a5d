#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "api/codec/bytes/sha256.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::http {

/// Which bodies are written to disk as they come in instead of being held in memory, and how large they may be.
struct Streaming {
  std::function<bool(const std::string& method, const std::string& path)> wanted;  // empty: none
  std::filesystem::path folder;
  std::uint64_t most_bytes{};
  /// Asked before such a body is read, on a thread of the handlers; empty: all are welcome.
  std::function<std::optional<routes::Response>(const routes::Request&)> refuse{};
};

/// A body on its way to disk: a file of a name of its own in `folder`, which is created when missing. The file is
/// removed at the end unless somebody has moved it away.
/// Errors   std::runtime_error when it cannot be written
class BodySink {
 public:
  explicit BodySink(const std::filesystem::path& folder);
  BodySink(const BodySink&) = delete;
  BodySink& operator=(const BodySink&) = delete;
  ~BodySink();

  void add(std::string_view bytes);
  /// Where the whole body lies, with its digest.
  [[nodiscard]] routes::BodyFile finish();

 private:
  std::filesystem::path path_;
  int descriptor_;
  codec::Sha256 digest_;
};

}  // namespace floeplan::http
