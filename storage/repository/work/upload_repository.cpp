#include "storage/repository/work/upload_repository.hpp"

#include <algorithm>
#include <random>
#include <string_view>

namespace floeplan::repository {
namespace {

constexpr std::size_t upload_id_length = 32;
constexpr std::string_view hexadecimal = "0123456789abcdef";

std::string random_id() {
  std::random_device source;
  std::string text;
  while (text.size() < upload_id_length) {
    const auto bits = source();
    for (unsigned shift = 0; shift < 32; shift += 4) text += hexadecimal[(bits >> shift) & 15U];
  }
  return text;
}

}  // namespace

Upload new_upload(const std::filesystem::path& file, const std::string& name, const std::string& sha256,
                  const std::string& owner, core::UtcTime now) {
  return {.id = random_id(),
          .name = plain_file_name(name),
          .bytes = std::filesystem::file_size(file),
          .sha256 = sha256,
          .owner = owner,
          .created = now,
          .expires = now + UploadRepository::lifetime};
}

bool is_upload_id(const std::string& text) {
  return text.size() == upload_id_length && text.find_first_not_of(hexadecimal) == std::string::npos;
}

std::string plain_file_name(const std::string& name) {
  constexpr std::size_t longest = 100;
  std::string plain = name.substr(name.find_last_of("/\\") + 1);
  for (char& c : plain) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '.' || c == '_' || c == '-';
    if (!kept) c = '_';
  }
  plain.erase(0, std::min(plain.find_first_not_of('.'), plain.size()));
  if (plain.size() > longest) plain = plain.substr(plain.size() - longest);
  plain.erase(0, std::min(plain.find_first_not_of('.'), plain.size()));
  return plain.empty() ? "upload" : plain;
}

}  // namespace floeplan::repository
