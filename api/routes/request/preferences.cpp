#include "api/routes/request/preferences.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "api/codec/bytes/text_values.hpp"

namespace floeplan::routes {
namespace {

std::vector<std::string_view> trimmed_parts(std::string_view text, char separator) {
  auto parts = codec::split(text, separator);
  for (auto& part : parts) part = codec::trimmed(part);
  return parts;
}

double quality(const std::vector<std::string_view>& media_range) {
  for (const auto parameter : media_range) {
    if (!parameter.starts_with("q=")) continue;
    return codec::parse_number(parameter.substr(2)).value_or(0.0);
  }
  return 1.0;
}

}  // namespace

bool prefers_html(const std::string& accept) {
  double html = 0.0;
  double json = 0.0;
  for (const auto range : trimmed_parts(accept, ',')) {
    const auto parts = trimmed_parts(range, ';');
    if (parts.front() == "text/html") html = std::max(html, quality(parts));
    if (parts.front() == "application/json") json = std::max(json, quality(parts));
  }
  return html > 0.0 && html >= json;
}

Preferences parse_prefer(const std::string& prefer) {
  Preferences preferences;
  for (const auto preference : trimmed_parts(prefer, ',')) {
    const std::string_view name = trimmed_parts(preference, ';').front();
    if (name == "respond-sync") preferences.respond_sync = true;
    if (name == "respond-async") preferences.respond_async = true;
    if (name.starts_with("wait=")) {
      constexpr std::int64_t longest = 86'400;
      const auto seconds = codec::parse_integer(name.substr(5));
      if (seconds && *seconds >= 0) preferences.wait_s = static_cast<int>(std::min(*seconds, longest));
    }
  }
  return preferences;
}

}  // namespace floeplan::routes
