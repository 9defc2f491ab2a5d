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

/// Which bodies are written to disk while they are received, instead of being kept in memory, and their
/// largest size.
struct Streaming {
  std::function<bool(const std::string& method, const std::string& path)> wanted;  // empty: none
  std::filesystem::path folder;
  std::uint64_t most_bytes{};
  /// Called on a handler thread before the body is read; returns the refusal, if any. An empty function accepts
  /// all bodies.
  std::function<std::optional<routes::Response>(const routes::Request&)> refuse{};
};

/// Writes a body to a file with a unique name in `folder`, which is created if missing. The destructor
/// removes the file unless it was moved.
/// Errors   std::runtime_error when the file cannot be written
class BodySink {
 public:
  explicit BodySink(const std::filesystem::path& folder);
  BodySink(const BodySink&) = delete;
  BodySink& operator=(const BodySink&) = delete;
  ~BodySink();

  void add(std::string_view bytes);
  /// The file with the complete body, and its digest.
  [[nodiscard]] routes::BodyFile finish();

 private:
  std::filesystem::path path_;
  int descriptor_;
  codec::Sha256 digest_;
};

}  // namespace floeplan::http
