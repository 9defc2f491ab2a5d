#include "api/codec/bytes/multipart.hpp"

#include <algorithm>
#include <optional>

#include "engine/core/letter_case.hpp"

namespace floeplan::codec {
namespace {

using core::lower_case;

constexpr std::size_t most_parts = 1000;
constexpr std::size_t longest_boundary = 70;  // RFC 2046, section 5.1.1

/// The value of a header's parameter, with or without quotes: name="field" or boundary=abc.
std::optional<std::string> parameter_of(std::string_view header, std::string_view name) {
  std::size_t at = header.find(';');
  while (at != std::string_view::npos) {
    const std::size_t begin = std::min(header.find_first_not_of("; \t", at), header.size());
    const std::size_t equals = header.find('=', begin);
    if (equals == std::string_view::npos) return std::nullopt;
    const bool quoted = equals + 1 < header.size() && header[equals + 1] == '"';
    std::string value;
    std::size_t i = equals + (quoted ? 2 : 1);
    for (; i < header.size() && header[i] != (quoted ? '"' : ';'); ++i) {
      if (quoted && header.substr(i, 2) == "\\\"") ++i;
      value += header[i];
    }
    if (lower_case(header.substr(begin, equals - begin)) == name) return value;
    at = header.find(';', i);
  }
  return std::nullopt;
}

/// Parses the text between two boundaries: header lines, an empty line, the content.
tl::expected<FormPart, std::string> read_part(std::string_view text) {
  const bool bare = text.starts_with("\r\n");
  const std::size_t end = bare ? 0 : text.find("\r\n\r\n");
  if (end == std::string_view::npos)
    return tl::unexpected(std::string{"a part has no empty line after its headers"});
  const std::string_view content = text.substr(end + (bare ? 2 : 4));
  std::string_view headers = text.substr(0, end);
  while (!headers.empty()) {
    const std::string_view line = headers.substr(0, headers.find("\r\n"));
    headers.remove_prefix(std::min(line.size() + 2, headers.size()));
    if (!lower_case(line).starts_with("content-disposition:")) continue;
    if (const auto name = parameter_of(line, "name"))
      return FormPart{*name, parameter_of(line, "filename").value_or(""), std::string{content}};
  }
  return tl::unexpected(std::string{"a part has no Content-Disposition with a name"});
}

}  // namespace

tl::expected<std::vector<FormPart>, std::string> parse_multipart(std::string_view content_type,
                                                                 std::string_view body) {
  const auto boundary = parameter_of(content_type, "boundary");
  if (!boundary || boundary->empty() || boundary->size() > longest_boundary)
    return tl::unexpected(std::string{"the Content-Type has no boundary of 1 to 70 characters"});

  // The line end before a boundary belongs to the boundary. The first boundary may have none.
  const std::string opening = "--" + *boundary;
  const std::string between = "\r\n" + opening;
  if (!body.starts_with(opening)) {
    const std::size_t first = body.find(between);
    if (first == std::string_view::npos)
      return tl::unexpected(std::string{"the body does not hold its boundary"});
    body.remove_prefix(first + 2);
  }
  body.remove_prefix(opening.size());

  std::vector<FormPart> parts;
  while (!body.starts_with("--")) {
    const std::size_t line = body.find("\r\n");
    const std::size_t next = line == std::string_view::npos ? line : body.find(between, line);
    if (next == std::string_view::npos)
      return tl::unexpected(std::string{"the body ends before its closing boundary"});
    if (parts.size() == most_parts) return tl::unexpected(std::string{"the body has more than 1000 parts"});
    const std::size_t begin = line + 2;
    auto part = read_part(next < begin ? std::string_view{} : body.substr(begin, next - begin));
    if (!part) return tl::unexpected(part.error());
    parts.push_back(std::move(*part));
    body.remove_prefix(next + between.size());
  }
  return parts;
}

}  // namespace floeplan::codec
