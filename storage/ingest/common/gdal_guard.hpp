#pragma once

#include <string>
#include <utility>

namespace floeplan::ingest {

/// Registers the GDAL drivers that `storage/ingest` reads with, and no others: no virtual formats. GDAL asks no server from then
/// on, and opens no name in archives or through other names; files and its memory are left.
/// Idempotent.
/// Threads  may be called from several threads at once
void register_drivers();

/// "GDAL 3.6.2"
[[nodiscard]] std::string gdal_version();

/// Collects what GDAL reports on this thread for as long as it lives, instead of letting GDAL print it.
class GdalMessages {
 public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /// The first error in GDAL's own words; "no reason given" when it gave none.
  [[nodiscard]] std::string first_error() const;
  /// Called by GDAL's error handler.
  void add(std::string error) {
    if (first_error_.empty()) first_error_ = std::move(error);
  }

 private:
  std::string first_error_;
};

}  // namespace floeplan::ingest
