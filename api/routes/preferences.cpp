#include "api/routes/preferences.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

namespace floeplan::routes {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double quality(const std::vector<std::string_view>& media_range) {
  for (const auto parameter : media_range) {
    if (!parameter.starts_with("q=")) continue;
    double value = 0.0;
    std::from_chars(parameter.data() + 2, parameter.data() + parameter.size(), value);
    return value;
  }
  return 1.0;
}

}  // namespace

bool prefers_html(const std::string& accept) {
  double html = 0.0;
  double json = 0.0;
  for (const auto range : split(accept, ',')) {
    const auto parts = split(range, ';');
    if (parts.front() == "text/html") html = std::max(html, quality(parts));
    if (parts.front() == "application/json") json = std::max(json, quality(parts));
  }
  return html > 0.0 && html >= json;
}

Preferences parse_prefer(const std::string& prefer) {
  Preferences preferences;
  for (const auto preference : split(prefer, ',')) {
    const std::string_view name = split(preference, ';').front();
    if (name == "respond-sync") preferences.respond_sync = true;
    if (name == "respond-async") preferences.respond_async = true;
    if (name.starts_with("wait=")) {
      int seconds = 0;
      const auto [end, error] = std::from_chars(name.data() + 5, name.data() + name.size(), seconds);
      if (error == std::errc{} && seconds >= 0) preferences.wait_s = seconds;
    }
  }
  return preferences;
}

}  // namespace floeplan::routes
