#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::ingest {

/// Splits the lines of a table. Its header decides the separator: the first of tab, semicolon and comma that
/// occurs in it, or else blanks.
class DelimitedText {
 public:
  /// A byte order mark before the header is ignored.
  explicit DelimitedText(std::string_view header);

  /// Names of the columns: letters and digits in lower case, an underscore for everything between them.
  /// "Length (m)" becomes "length_m", "#Lon" becomes "lon".
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// The original name of a column, for messages.
  [[nodiscard]] const std::string& header(std::size_t column) const { return headers_[column]; }
  [[nodiscard]] const std::vector<std::string>& headers() const { return headers_; }
  /// The only column with one of the names; empty if no column or several columns have one.
  [[nodiscard]] std::optional<std::size_t> column(const std::vector<std::string_view>& names) const;
  /// The fields of a line, without quotes and blanks around them; empty for a blank line.
  [[nodiscard]] std::vector<std::string> fields(std::string_view line) const;
  /// A number; also with a decimal comma, if the table's separator is not the comma.
  [[nodiscard]] std::optional<double> number(std::string_view field) const;

 private:
  char separator_;
  std::vector<std::string> columns_;
  std::vector<std::string> headers_;
};

/// Whether a header names measurements of the water, such as the temperature and salinity of a glider's CTD.
/// The depths of such a table are those of the sensor, not of the sea bed.
[[nodiscard]] bool names_water_properties(std::string_view header);

/// The fields of one line of comma-separated values; quotes as in RFC 4180, but no line ends inside them.
[[nodiscard]] std::vector<std::string> csv_fields(const std::string& line);

/// Whether a text begins with numbers: at least three on each of the first lines, separated by blanks,
/// commas, semicolons or tabs.
[[nodiscard]] bool is_number_table(std::string_view head);

}  // namespace floeplan::ingest
