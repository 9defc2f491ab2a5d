#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace floeplan::codec {

/// The credential of a token or a login, "floeplan_<key>_<secret>". The key finds the record in the store;
/// the secret proves the right to it. The store keeps only the SHA-256 of the secret. A slow key derivation
/// is not needed: it protects secrets that can be guessed, and 256 random bits cannot.
struct Credential {
  std::string key;     // 64 random bits as 16 hexadecimal digits
  std::string secret;  // 256 random bits as 64 hexadecimal digits

  friend bool operator==(const Credential&, const Credential&) = default;
};

/// A random credential from the generator of the cryptographic library.
/// Errors   std::runtime_error when it has no randomness
[[nodiscard]] Credential new_credential();

[[nodiscard]] std::string credential_text(const Credential& credential);
/// nullopt for a text that is not a credential.
[[nodiscard]] std::optional<Credential> parse_credential(std::string_view text);

/// The digest to store: SHA-256 of the secret, lower-case hexadecimal digits.
[[nodiscard]] std::string digest_of(const Credential& credential);
/// Whether the credential has this digest. The time of the comparison does not depend on where they differ.
[[nodiscard]] bool proves(const Credential& credential, const std::string& digest);

}  // namespace floeplan::codec
