#pragma once

#include <cstddef>
#include <string_view>

namespace floeplan::http {

/// Finds where the header of a request ends, as its bytes come in, and looks at it before anybody interprets it. What one
/// server reads differently from the next lets a request hide in another, so it is refused where others guess: line ends
/// other than CR LF, folded lines, space before a colon, control characters, more than one length, an empty one, and a
/// coding of the transfer other than "chunked" alone, in HTTP/1.1 alone.
/// Source   RFC 9112, 2.2, 5.1, 5.2, 6.1 and 11.2
class StrictHead {
 public:
  enum class State { incomplete, complete, faulty };

  /// `bytes`  all that have come so far: those of the last call, and what has come since
  [[nodiscard]] State look_at(std::string_view bytes);

 private:
  std::size_t looked_at_{0};
};

}  // namespace floeplan::http
