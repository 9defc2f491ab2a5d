#include "server/http/entity_tag.hpp"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace floeplan::http {

std::string entity_tag(std::string_view bytes) {
  constexpr std::size_t length = 16;  // bytes kept of SHA-256
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error{"the cryptographic library has no SHA-256"};
  }
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4U];
    text += digits[digest[i] & 15U];
  }
  return text;
}

}  // namespace floeplan::http
