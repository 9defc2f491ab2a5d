#include "storage/ingest/dataset_identity.hpp"

#include <charconv>

#include "storage/ingest/files/file_digest.hpp"

namespace floeplan::ingest {
namespace {

using repository::DatasetKind;

/// The shortest text that gives the same number again.
std::string exact(double value) {
  constexpr std::size_t longest = 32;  // enough for -2.2250738585072014e-308
  std::string text(longest, '\0');
  text.resize(
      static_cast<std::size_t>(std::to_chars(text.data(), text.data() + longest, value).ptr - text.data()));
  return text;
}

/// The options that the readers of a kind use, one on each line.
std::string options_in_use(DatasetKind kind, const IngestOptions& options) {
  std::string lines;
  const auto say = [&](const char* name, const std::string& value) {
    lines += "\n" + (name + (" " + value));
  };
  const auto say_text = [&](const char* name, const std::optional<std::string>& value) {
    if (value) say(name, *value);
  };
  if (options.missing) say("missing", exact(*options.missing));
  if (kind != DatasetKind::icebergs && kind != DatasetKind::glider_tracks) say_text("crs", options.crs);
  switch (kind) {
    case DatasetKind::bathymetry: say_text("positive", options.positive); break;
    case DatasetKind::zones: say_text("zone_kind", options.zone_kind); break;
    case DatasetKind::tides:
      say_text("unit", options.unit);
      if (options.at) say("at", exact(options.at->lon_deg) + "," + exact(options.at->lat_deg));
      break;
    case DatasetKind::ice: say_text("unit", options.unit); [[fallthrough]];
    case DatasetKind::currents:
      say_text("variable", options.variable);
      if (options.time) say("time", exact(core::unix_seconds(*options.time)));
      break;
    case DatasetKind::wind:
    case DatasetKind::water_levels:
    case DatasetKind::icebergs:
    case DatasetKind::coastline:
    case DatasetKind::glider_tracks: break;
  }
  return lines;
}

}  // namespace

std::string identity_of(const std::string& sha256, DatasetKind kind, const IngestOptions& options) {
  const std::string lines = options_in_use(kind, options);
  return lines.empty() ? sha256 : sha256_of_text(sha256 + lines);
}

repository::DatasetId id_of(DatasetKind kind, const std::string& identity, Keeping keeping) {
  constexpr std::size_t digits = 8;
  return {repository::kind_name(kind) + "-" +
          identity.substr(static_cast<std::size_t>(keeping) * digits, digits)};
}

}  // namespace floeplan::ingest
