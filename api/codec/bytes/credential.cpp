#include "api/codec/bytes/credential.hpp"

#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <array>
#include <stdexcept>

#include "api/codec/bytes/sha256.hpp"

namespace floeplan::codec {
namespace {

// lets programs that search for leaked secrets recognise one
constexpr std::string_view prefix = "floeplan_";
constexpr std::size_t key_digits = 16;
constexpr std::size_t secret_digits = 64;
constexpr std::string_view digits = "0123456789abcdef";

template <std::size_t Digits>
std::string random_digits() {
  std::array<unsigned char, Digits / 2> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw std::runtime_error{"the cryptographic library has no randomness"};
  std::string text;
  for (const unsigned char byte : bytes) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

bool is_hexadecimal(std::string_view text) {
  return text.find_first_not_of(digits) == std::string_view::npos;
}

}  // namespace

Credential new_credential() { return {random_digits<key_digits>(), random_digits<secret_digits>()}; }

std::string credential_text(const Credential& credential) {
  return std::string{prefix} + credential.key + "_" + credential.secret;
}

std::optional<Credential> parse_credential(std::string_view text) {
  if (text.size() != prefix.size() + key_digits + 1 + secret_digits || !text.starts_with(prefix))
    return std::nullopt;
  const std::string_view key = text.substr(prefix.size(), key_digits);
  const std::string_view secret = text.substr(text.size() - secret_digits);
  if (text[prefix.size() + key_digits] != '_' || !is_hexadecimal(key) || !is_hexadecimal(secret))
    return std::nullopt;
  return Credential{std::string{key}, std::string{secret}};
}

std::string digest_of(const Credential& credential) { return sha256(credential.secret); }

bool proves(const Credential& credential, const std::string& digest) {
  const std::string shown = digest_of(credential);
  return shown.size() == digest.size() && CRYPTO_memcmp(shown.data(), digest.data(), shown.size()) == 0;
}

}  // namespace floeplan::codec
