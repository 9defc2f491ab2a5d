#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace floeplan::codec {

/// What somebody shows to prove who it is, "floeplan_<key>_<secret>": the key finds the record in the store, the secret
/// proves the right to it. Of the secret the store keeps SHA-256 alone. A slow key derivation would add nothing: it
/// makes guessing words that people choose expensive, and a secret of 256 random bits is none.
struct Credential {
  std::string key;     // 64 random bits as 16 hexadecimal digits
  std::string secret;  // 256 random bits as 64 hexadecimal digits

  friend bool operator==(const Credential&, const Credential&) = default;
};

/// A random credential from the generator of the cryptographic library.
/// Errors   std::runtime_error when it has no randomness
[[nodiscard]] Credential new_credential();

[[nodiscard]] std::string credential_text(const Credential& credential);
/// Nothing for a text that is none.
[[nodiscard]] std::optional<Credential> parse_credential(std::string_view text);

/// What is kept of the secret: SHA-256 as lower-case hexadecimal digits.
[[nodiscard]] std::string digest_of(const Credential& credential);
/// Compares with a kept digest in a time that does not depend on where they differ.
[[nodiscard]] bool proves(const Credential& credential, const std::string& digest);

}  // namespace floeplan::codec
