#include "server/http/gzip.hpp"

#include <zlib.h>

#include <stdexcept>

namespace floeplan::http {

std::string gzip(std::string_view bytes) {
  constexpr int window_bits_for_gzip = 15 + 16;
  constexpr int memory_level = 8;
  constexpr int fast = 3;  // answers are made for one request: time counts more than the last percent
  z_stream stream{};
  if (deflateInit2(&stream, fast, Z_DEFLATED, window_bits_for_gzip, memory_level, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error{"gzip could not begin"};
  }
  std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  std::string input{bytes};  // zlib's interface is not const
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error{"gzip could not end"};
  return result;
}

}  // namespace floeplan::http
