#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

/// What whoever runs the server reads: one line for each event, of "key=value" pairs, without the secrets that its parts
/// may hold and without control characters. No function throws: a line that there is no memory for is not written.
/// Threads  every function may be called from any thread
namespace floeplan::log {

/// Lines go to stderr, stdout being for answers to people and scripts; those below `level` ("debug", "info", "warning",
/// "error", "off") are not written.
void to_stderr(const std::string& level);

/// Sets the level from now on, for every thread.
void set_level(const std::string& level);

void info(std::initializer_list<std::string_view> parts) noexcept;
void warn(std::initializer_list<std::string_view> parts) noexcept;
void error(std::initializer_list<std::string_view> parts) noexcept;

/// A duration or another measured value, with so many digits after the point.
[[nodiscard]] std::string decimals(double value, int digits);

}  // namespace floeplan::log
