#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What may be shown of text that came from outside, in logs, answers and lists.
namespace floeplan::core {

/// The text with "(hidden)" for every credential in it: tokens and logins ("floeplan_" and hexadecimal digits), what
/// follows "Bearer", and the value of a login's cookie.
[[nodiscard]] std::string without_secrets(std::string_view text);

/// The address of a request, as it was sent, for a log: without the secrets in it, however often they were
/// percent-encoded, without the values of parameters whose names speak of secrets ("?token=", "?password="), and with no
/// more than `most` bytes.
[[nodiscard]] std::string shown_target(std::string_view target, std::size_t most = 300);

/// The text with every word that is too long to be read cut to its beginning and its length, and cut itself where it is
/// longer than a page.
[[nodiscard]] std::string excerpt(std::string_view text);

/// The first ten names, with commas between them, and how many more there are.
[[nodiscard]] std::string shortened_list(const std::vector<std::string>& names);

}  // namespace floeplan::core
