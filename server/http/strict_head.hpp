#pragma once

#include <cstddef>
#include <string_view>

namespace floeplan::http {

/// Finds the end of a request's header as bytes arrive, and checks it before it is parsed. Servers parse
/// unusual headers differently, which can hide one request in another (request smuggling). So these are
/// refused: line ends other than CR LF, folded lines, a space before a colon, control characters, several or
/// empty lengths, and any transfer coding except a single "chunked" in HTTP/1.1.
/// Source   RFC 9112, 2.2, 5.1, 5.2, 6.1 and 11.2
class StrictHead {
 public:
  enum class State { incomplete, complete, faulty };

  /// `bytes`  all bytes of the header received so far, also in earlier calls
  [[nodiscard]] State look_at(std::string_view bytes);

 private:
  std::size_t looked_at_{0};
};

}  // namespace floeplan::http
