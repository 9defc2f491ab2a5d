#include "storage/ingest/files/file_digest.hpp"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "engine/messages/ingest_file_messages.hpp"

namespace floeplan::ingest {

namespace {

/// SHA-256 of bytes that are added block by block.
class Digest {
 public:
  Digest() : context_{EVP_MD_CTX_new(), &EVP_MD_CTX_free} {
    if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1)
      throw std::runtime_error{"SHA-256 is not available from OpenSSL"};
  }

  void add(const char* bytes, std::size_t count) {
    if (EVP_DigestUpdate(context_.get(), bytes, count) != 1)
      throw std::runtime_error{"SHA-256 failed in OpenSSL"};
  }

  std::string text() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    if (EVP_DigestFinal_ex(context_.get(), digest.data(), &size) != 1)
      throw std::runtime_error{"SHA-256 failed in OpenSSL"};
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += digits[digest[i] >> 4U];
      text += digits[digest[i] & 15U];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

Checked<std::string> sha256_of_file(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  if (!in) return refuse(messages::ingest_file_message<"file-unreadable">());
  Digest digest;
  std::array<char, 65536> block{};
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    digest.add(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) return refuse(messages::ingest_file_message<"file-not-read-to-its-end">());
  return digest.text();
}

Checked<std::string> sha256_of_files(const std::vector<std::filesystem::path>& files) {
  if (files.size() == 1) return sha256_of_file(files.front());
  Digest all;
  for (const std::filesystem::path& file : files) {
    const auto one = sha256_of_file(file);
    if (!one) return one;
    all.add(one->data(), one->size());
  }
  return all.text();
}

std::string sha256_of_text(const std::string& text) {
  Digest digest;
  digest.add(text.data(), text.size());
  return digest.text();
}

}  // namespace floeplan::ingest
