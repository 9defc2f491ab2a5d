#include "storage/ingest/readers/currents/adcirc_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <span>
#include <utility>

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double dry = -99999.0;
constexpr std::size_t numbers_looked_at = 8;  // at most this number of numbers is read from a line

/// The numbers at the beginning of a line, up to the first word that is not a number.
struct Numbers {
  std::array<double, numbers_looked_at> values{};
  std::size_t count{};

  /// The number at this index, if it is a whole number of at least `least`; otherwise empty.
  [[nodiscard]] std::optional<std::size_t> whole(std::size_t at, double least) const {
    constexpr double most = 4e9;
    if (at >= count || std::floor(values[at]) != values[at] || values[at] < least || values[at] > most)
      return std::nullopt;
    return static_cast<std::size_t>(values[at]);
  }
};

/// A number in Fortran's notation, also "1.5D+02".
std::optional<double> fortran_number(std::string_view word) {
  if (word.find_first_of("dD") == std::string_view::npos) return parse_number(word);
  std::string text{word};
  std::ranges::replace_if(text, [](char c) { return c == 'd' || c == 'D'; }, 'e');
  return parse_number(text);
}

Numbers numbers_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r,";
  Numbers found;
  while (found.count < numbers_looked_at) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const auto value = fortran_number(line.substr(begin, end - begin));
    if (!value) break;
    found.values[found.count++] = *value;
    line.remove_prefix(end);
  }
  return found;
}

std::size_t component_count(AdcircPart part) { return part == AdcircPart::currents ? 2 : 1; }

/// Recognises a file by its second and third line. An output has the numbers of times and nodes, seconds and
/// steps from one time to the next, and 1 or 2 components. A mesh has the numbers of elements and nodes; the
/// first node follows.
std::optional<AdcircHead> head_of_lines(std::string_view second, std::string_view third) {
  const Numbers sizes = numbers_of(second);
  const Numbers next = numbers_of(third);
  const auto nodes = sizes.whole(1, 3.0);
  if (!sizes.whole(0, 1.0) || !nodes) return std::nullopt;
  if (sizes.count >= 5 && sizes.values[2] > 0.0 && sizes.whole(3, 1.0)) {
    const auto components = sizes.whole(4, 1.0);
    if (!components || *components > 2 || (next.count != 2 && next.count != 4)) return std::nullopt;
    return AdcircHead{*components == 2 ? AdcircPart::currents : AdcircPart::elevations, *nodes};
  }
  if (sizes.count > 2 || next.count != 4 || next.whole(0, 1.0) != std::size_t{1}) return std::nullopt;
  return AdcircHead{AdcircPart::mesh, *nodes};
}

/// The lines of a file, counted from one. A last line without a line end is ignored: its last number may be
/// cut off.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& file) : in_{file, std::ios::binary} {}
  Lines(const std::filesystem::path& file, std::streamoff start, std::size_t number) : Lines{file} {
    in_.seekg(start);
    number_ = number;
  }

  bool next() {
    ++number_;
    return std::getline(in_, line_) && !in_.eof();
  }
  [[nodiscard]] const std::string& line() const { return line_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] std::streamoff position() { return in_.tellg(); }

 private:
  std::ifstream in_;
  std::string line_;
  std::size_t number_{0};
};

messages::Message bad_line(const Lines& lines, const std::string& expected) {
  return messages::ingest_current_message<"adcirc-line-unreadable">(
      lines.number(), trimmed(lines.line().substr(0, 60)), expected);
}

messages::Message ends_early(const Lines& lines, const std::string& expected) {
  return messages::ingest_current_message<"adcirc-file-cut-short">(lines.number(), expected);
}

/// The next line, which must have at least `count` numbers.
Checked<Numbers> next_numbers(Lines& lines, std::size_t count, const std::string& expected) {
  if (!lines.next()) return refuse(ends_early(lines, expected));
  const Numbers found = numbers_of(lines.line());
  if (found.count < count) return refuse(bad_line(lines, expected));
  return found;
}

/// Skips the title and reads the line with the numbers of elements or times, and nodes.
Checked<Numbers> sizes_of(Lines& lines, std::size_t count) {
  if (!lines.next()) return refuse(ends_early(lines, "the title of the run"));
  return next_numbers(lines, count, "the number of nodes");
}

/// Whether a file is long enough for this number of lines. Prevents allocating memory for a damaged number.
bool holds_lines(const std::filesystem::path& file, std::size_t lines) {
  constexpr std::uintmax_t shortest_line = 4;  // "1 0" with its end
  return lines <= std::filesystem::file_size(file) / shortest_line;
}

Checked<geo::LonLat> next_node(Lines& lines, std::size_t number) {
  const auto line = next_numbers(lines, 4, "a node: its number, longitude, latitude and depth");
  if (!line) return refuse(line.error());
  if (line->whole(0, 1.0) != number) return refuse(bad_line(lines, "node " + std::to_string(number)));
  const geo::LonLat place{line->values[1], line->values[2]};
  if (std::abs(place.lon_deg) > 360.0 || std::abs(place.lat_deg) > 90.0)
    return refuse(messages::ingest_current_message<"adcirc-not-in-degrees">(
        ingest::number(place.lon_deg, 9), ingest::number(place.lat_deg, 9)));
  return geo::LonLat{geo::wrap_longitude(place.lon_deg), place.lat_deg};
}

Checked<ocean::Mesh::Cell> next_triangle(Lines& lines, std::size_t nodes) {
  const std::string expected = "an element: its number, 3 and its three nodes";
  const auto line = next_numbers(lines, 5, expected);
  if (!line) return refuse(line.error());
  ocean::Mesh::Cell cell{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto node = line->whole(2 + corner, 1.0);
    if (line->whole(1, 1.0) != std::size_t{3} || !node || *node > nodes)
      return refuse(bad_line(lines, expected));
    cell[corner] = static_cast<std::uint32_t>(*node - 1);
  }
  cell[3] = cell[2];
  if (cell[0] == cell[1] || cell[1] == cell[2] || cell[0] == cell[2])
    return refuse(bad_line(lines, expected));
  return cell;
}

/// The next line of an output: a node and its values.
Checked<Numbers> next_values(Lines& lines, const AdcircHead& head) {
  const std::string expected = head.part == AdcircPart::currents
                                   ? "a node and its two components of the current"
                                   : "a node and its elevation";
  const auto line = next_numbers(lines, 1 + component_count(head.part), expected);
  if (!line) return line;
  const auto node = line->whole(0, 1.0);
  if (!node || *node > head.nodes) return refuse(bad_line(lines, expected));
  return line;
}

}  // namespace

std::optional<AdcircHead> adcirc_head(std::string_view text) {
  std::array<std::string_view, 3> lines;
  for (std::string_view& line : lines) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    line = text.substr(0, end);
    text.remove_prefix(end + 1);
  }
  return head_of_lines(lines[1], lines[2]);
}

Checked<ocean::Mesh> read_adcirc_mesh(const std::filesystem::path& file) {
  Lines lines{file};
  const auto sizes = sizes_of(lines, 2);
  if (!sizes) return refuse(sizes.error());
  const auto elements = sizes->whole(0, 1.0);
  const auto nodes = sizes->whole(1, 3.0);
  if (!elements || !nodes || !holds_lines(file, *elements + *nodes))
    return refuse(bad_line(lines, "the numbers of elements and nodes that the file holds"));
  ocean::Mesh mesh;
  mesh.points.reserve(*nodes);
  for (std::size_t node = 1; node <= *nodes; ++node) {
    const auto place = next_node(lines, node);
    if (!place) return refuse(place.error());
    mesh.points.push_back(*place);
  }
  mesh.cells.reserve(*elements);
  for (std::size_t element = 0; element < *elements; ++element) {
    const auto cell = next_triangle(lines, *nodes);
    if (!cell) return refuse(cell.error());
    mesh.cells.push_back(*cell);
  }
  return mesh;
}

Checked<AdcircOutput> AdcircOutput::open(const std::filesystem::path& file) {
  Lines lines{file};
  const auto sizes = sizes_of(lines, 5);
  if (!sizes) return refuse(sizes.error());
  const auto components = sizes->whole(4, 1.0);
  const auto nodes = sizes->whole(1, 3.0);
  if (!nodes || !components || *components > 2 || *nodes > std::filesystem::file_size(file))
    return refuse(bad_line(lines, "times, nodes, seconds and steps between times, and 1 or 2 components"));
  AdcircOutput output;
  output.file_ = file;
  output.head_ = {*components == 2 ? AdcircPart::currents : AdcircPart::elevations, *nodes};
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    const Numbers time = numbers_of(lines.line());
    const bool compact = time.count == 4;
    const auto given = compact ? time.whole(2, 0.0) : nodes;
    if ((time.count != 2 && !compact) || !given || *given > *nodes ||
        (!output.seconds_.empty() && time.values[0] <= output.seconds_.back()))
      return refuse(bad_line(lines, "a time in seconds, later than the one before"));
    output.seconds_.push_back(time.values[0]);
    output.records_.push_back({lines.position(), lines.number(), *given, compact ? time.values[3] : dry});
    for (std::size_t line = 1; line <= *given; ++line) {
      const auto values = next_values(lines, output.head_);
      if (!values) return refuse(values.error());
      if (!compact && values->whole(0, 1.0) != line)
        return refuse(bad_line(lines, "node " + std::to_string(line)));
    }
  }
  if (output.records_.empty()) return refuse(ends_early(lines, "a time and its values"));
  return output;
}

Checked<std::vector<std::vector<float>>> AdcircOutput::read(std::size_t time) const {
  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  const Record& record = records_[time];
  const auto value_of = [](double value) { return value == dry ? missing : static_cast<float>(value); };
  std::vector<std::vector<float>> values(component_count(head_.part),
                                         std::vector<float>(head_.nodes, value_of(record.otherwise)));
  Lines lines{file_, record.start, record.first_line};
  for (std::size_t line = 0; line < record.lines; ++line) {
    const auto found = next_values(lines, head_);
    if (!found) return refuse(found.error());
    const std::size_t node = static_cast<std::size_t>(found->values[0]) - 1;
    for (std::size_t i = 0; i < values.size(); ++i) values[i][node] = value_of(found->values[i + 1]);
  }
  return values;
}

}  // namespace floeplan::ingest
