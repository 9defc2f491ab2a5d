#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

/// The server's log for its operator: one line of "key=value" pairs for each event. Secrets in the values are
/// hidden, control characters replaced. No function throws; if there is no memory for a line, it is not
/// written.
/// Threads  every function may be called from any thread
namespace floeplan::log {

/// Writes the log to stderr, because stdout is for answers. Lines below `level` ("debug", "info", "warning",
/// "error", "off") are not written.
void to_stderr(const std::string& level);

/// Changes the level, for all threads.
void set_level(const std::string& level);

void info(std::initializer_list<std::string_view> parts) noexcept;
void warn(std::initializer_list<std::string_view> parts) noexcept;
void error(std::initializer_list<std::string_view> parts) noexcept;

/// Text of `value`, a duration or another measured value, with `digits` decimals.
[[nodiscard]] std::string decimals(double value, int digits);

}  // namespace floeplan::log
