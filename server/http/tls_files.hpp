#pragma once

#include <filesystem>

namespace floeplan::http {

/// Files in PEM format: the server's certificate with those between it and the authority's, and its key.
struct TlsFiles {
  std::filesystem::path certificate;
  std::filesystem::path key;
};

}  // namespace floeplan::http
