#pragma once

#include <string>
#include <utility>

namespace floeplan::ingest {

/// Registers only the GDAL drivers that `storage/ingest` reads with; none of them is a virtual format.
/// Afterwards GDAL contacts no server and opens only plain files and its own memory, no archives and no other
/// virtual names. May be called again; the second call does nothing.
/// Threads  may be called from several threads at once
void register_drivers();

/// "GDAL 3.6.2"
[[nodiscard]] std::string gdal_version();

/// As long as an object of this class lives, it collects GDAL's reports on this thread; GDAL prints nothing.
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
