#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace floeplan::codec {

/// SHA-256 of bytes that are added block by block.
/// Threads  one at a time
class Sha256 {
 public:
  Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;
  ~Sha256();

  void add(std::string_view bytes);
  /// The digest as 64 lower-case hexadecimal digits; nothing can be added afterwards.
  [[nodiscard]] std::string text();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// SHA-256 of the bytes, as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace floeplan::codec
