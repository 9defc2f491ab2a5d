#include "api/log/log.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <new>
#include <utility>

#include "engine/core/shown_text.hpp"

namespace floeplan::log {
namespace {

void write(spdlog::level::level_enum level, std::initializer_list<std::string_view> parts) noexcept {
  try {
    spdlog::memory_buf_t line;
    for (const std::string_view part : parts) line.append(part.data(), part.data() + part.size());
    std::string shown = core::without_secrets({line.data(), line.size()});
    std::replace_if(  // one event is one line, whatever a name contains
        shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; },
        '?');
    spdlog::log(level, spdlog::string_view_t{shown});
  } catch (const std::bad_alloc&) {  // the line is lost; the caller handles the event itself
  }
}

}  // namespace

void to_stderr(const std::string& level) {
  auto logger =
      std::make_shared<spdlog::logger>("floeplan", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z level=%l %v");
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(std::move(logger));
}

void set_level(const std::string& level) { spdlog::set_level(spdlog::level::from_str(level)); }

void info(std::initializer_list<std::string_view> parts) noexcept { write(spdlog::level::info, parts); }
void warn(std::initializer_list<std::string_view> parts) noexcept { write(spdlog::level::warn, parts); }
void error(std::initializer_list<std::string_view> parts) noexcept { write(spdlog::level::err, parts); }

std::string decimals(double value, int digits) {
  std::array<char, 400> text{};  // the largest double has 309 digits before the decimal point
  const int length = std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return {text.data(), static_cast<std::size_t>(length)};
}

}  // namespace floeplan::log
