#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::ingest {

/// How the lines of a table are parted, told by its header: by the first of tab, semicolon and comma that occurs in it,
/// else by blanks.
class DelimitedText {
 public:
  /// A mark of the byte order before the header is no part of it.
  explicit DelimitedText(std::string_view header);

  /// Letters and digits in lower case, an underscore for whatever is between them: "Length (m)" is "length_m", "#Lon"
  /// is "lon".
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// The name of a column as the table has it, for messages.
  [[nodiscard]] const std::string& header(std::size_t column) const { return headers_[column]; }
  [[nodiscard]] const std::vector<std::string>& headers() const { return headers_; }
  /// The only column with one of the names; empty when none has, or several.
  [[nodiscard]] std::optional<std::size_t> column(const std::vector<std::string_view>& names) const;
  /// Without quotes and blanks around them; empty of a blank line.
  [[nodiscard]] std::vector<std::string> fields(std::string_view line) const;
  /// A number, also with a decimal comma where commas part no columns.
  [[nodiscard]] std::optional<double> number(std::string_view field) const;

 private:
  char separator_;
  std::vector<std::string> columns_;
  std::vector<std::string> headers_;
};

/// The fields of one line of comma-separated values; quotes as in RFC 4180, but no line ends inside them.
[[nodiscard]] std::vector<std::string> csv_fields(const std::string& line);

/// Whether a text begins with numbers: at least three on each of the first lines, parted by blanks, commas, semicolons
/// or tabs.
[[nodiscard]] bool is_number_table(std::string_view head);

}  // namespace floeplan::ingest
