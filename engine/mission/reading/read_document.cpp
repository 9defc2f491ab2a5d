#include "engine/mission/reading/read_document.hpp"

#include <algorithm>

#include "engine/core/letter_case.hpp"
#include "engine/messages/mission_file_messages.hpp"
#include "engine/mission/document/document_rules.hpp"
#include "engine/mission/document/file_text.hpp"
#include "engine/mission/document/hold_order.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/document/setting_line.hpp"
#include "engine/mission/reading/seaglider_readers.hpp"

namespace floeplan::mission {
namespace {

constexpr std::size_t max_waypoint_rows = 1000;  // the longest real list seen has 71
constexpr std::ptrdiff_t max_errors = 100;

/// The rest of the line after `keyword`, if the line begins with it in any case of letters.
std::optional<std::string_view> after(std::string_view content, std::string_view keyword) {
  if (content.size() < keyword.size() || core::lower_case(content.substr(0, keyword.size())) != keyword)
    return std::nullopt;
  return content.substr(keyword.size());
}

std::string setting_text(const char* keyword, const Argument& setting) {
  return std::string{keyword} + setting.written + "(" + setting.unit + ") " + setting.raw;
}

/// Common parts of the readers of both kinds of Slocum files.
class Reader {
 public:
  explicit Reader(Document& document) : document_{document} {}

 protected:
  template <messages::Code code>
  void report() {
    document_.messages.push_back(finding(line_, messages::mission_file_message<code>()));
  }

  void keep(std::string content) { document_.lines.back().content = std::move(content); }

  /// Warns of surplus words on a line that is understood without them.
  void warn_of_extra(const std::vector<std::string_view>& words) {
    if (words.size() > 1) report<"extra_tokens">();
  }

  void read_sensor(std::string_view text) {
    if (auto sensor = read_setting(text, line_, document_.messages)) {
      keep(setting_text("sensor: ", *sensor));
      document_.sensors.push_back(std::move(*sensor));
    }
  }

  void read_argument(std::string_view text) {
    if (auto argument = read_setting(text, line_, document_.messages)) {
      keep(setting_text("\tb_arg: ", *argument));
      argument->name = core::lower_case(argument->name);
      document_.behaviors.back().arguments.push_back(std::move(*argument));
    }
  }

  void begin_behavior(std::string_view name) {
    document_.behaviors.push_back({core::lower_case(name), std::string{name}, line_, {}});
  }

  Document& document_;  // borrowed
  int line_{};
};

class MissionReader : private Reader {
 public:
  using Reader::Reader;

  void read(std::string_view content, int line) {
    line_ = line;
    if (const auto sensor = after(content, "sensor:")) return read_sensor(*sensor);
    if (const auto argument = after(content, "b_arg:")) {
      if (!document_.behaviors.empty()) return read_argument(*argument);
      return report<"b_arg_before_behavior">();
    }
    if (const auto behavior = after(content, "behavior:")) return read_behavior(*behavior);
    read_configuration(content);
  }

  void finish() {
    line_ = 0;
    if (document_.behaviors.empty() && document_.sensors.empty()) report<"empty_mission">();
  }

 private:
  void read_behavior(std::string_view text) {
    const auto words = words_of(text);
    if (words.empty() || !is_name(words.front())) return report<"malformed_behavior">();
    warn_of_extra(words);
    keep("behavior: " + std::string{words.front()});
    begin_behavior(words.front());
  }

  /// Reads a line that only a vehicle's autoexec.mi has; other lines are errors.
  void read_configuration(std::string_view content) {
    const auto words = words_of(content);
    if (words.size() == 2 && (words[0] == "name" || words[0] == "installed")) {
      keep(std::string{words[0]} + " " + std::string{words[1]});
      return report<"configuration_line">();
    }
    report<"unknown_line">();
  }
};

class ArgumentsReader : private Reader {
 public:
  using Reader::Reader;

  void read(std::string_view content, int line) {
    line_ = line;
    if (content.starts_with('<')) return read_tag(content);
    if (section_ == Section::waypoints) return read_row(content);
    if (const auto argument = after(content, "b_arg:")) {
      if (section_ == Section::arguments) return read_argument_of_file(*argument);
      return report<"b_arg_outside_section">();
    }
    if (const auto sensor = after(content, "sensor:")) return read_sensor(*sensor);
    if (const auto name = after(content, "behavior_name"); name && section_ == Section::none)
      return read_name(*name);
    report<"unknown_line/arguments">();
  }

  void finish() {
    if (section_ != Section::none) {
      report<"section_not_closed_at_eof">();
    }
    line_ = 0;
    if (!named_) report<"no_behavior_name">();
    if (!arguments_read_ && section_ != Section::arguments) report<"no_b_arg_section">();
  }

 private:
  enum class Section { none, arguments, waypoints };

  void read_name(std::string_view text) {
    const std::size_t equals = text.find_first_not_of(" \t");
    const bool assigned = equals != std::string_view::npos && text[equals] == '=';
    const auto words = assigned ? words_of(text.substr(equals + 1)) : std::vector<std::string_view>{};
    if (words.empty() || !is_name(words.front())) return report<"malformed_behavior_name">();
    if (equals > 0 || !text.substr(1).starts_with(words.front())) report<"blanks_around_equals">();
    warn_of_extra(words);
    if (named_) return read_name_again(words.front());
    if (arguments_read_ || waypoints_read_) report<"unusual_order">();
    named_ = true;
    if (document_.behaviors.empty()) begin_behavior("");
    document_.behaviors.back().name = core::lower_case(words.front());
    document_.behaviors.back().written = words.front();
    document_.behaviors.back().line = line_;
    keep("behavior_name=" + std::string{words.front()});
  }

  void read_name_again(std::string_view name) {
    const bool same = core::lower_case(name) == document_.behaviors.back().name;
    if (same)
      report<"behavior_name_twice/same">();
    else
      report<"behavior_name_twice">();
  }

  void read_argument_of_file(std::string_view text) {
    if (document_.behaviors.empty()) begin_behavior("");
    read_argument(text);
  }

  void read_row(std::string_view content) {
    if (document_.waypoints.size() == max_waypoint_rows) {
      if (!too_many_)
        document_.messages.push_back(
            finding(line_, messages::mission_file_message<"too_many_waypoints">(max_waypoint_rows)));
      too_many_ = true;
      return;
    }
    if (auto row = read_waypoint_row(content, line_, document_.messages)) {
      keep(row->lon_raw + "\t" + row->lat_raw);
      document_.waypoints.push_back(std::move(*row));
    }
  }

  void read_tag(std::string_view content) {
    const auto words = words_of(content);
    warn_of_extra(words);
    const std::string tag = core::lower_case(words.front());
    if (tag == "<start:b_arg>") {
      if (waypoints_read_) report<"unusual_order/sections">();
      open(Section::arguments, arguments_read_);
    } else if (tag == "<start:waypoints>") {
      open(Section::waypoints, waypoints_read_);
    } else if (tag == "<end:b_arg>") {
      close(Section::arguments);
    } else if (tag == "<end:waypoints>") {
      close(Section::waypoints);
    } else {
      return report<"unknown_section">();
    }
    keep(tag);
  }

  void open(Section section, bool& read_before) {
    if (section_ != Section::none) report<"section_not_closed">();
    if (read_before) report<"section_twice">();
    read_before = true;
    section_ = section;
  }

  void close(Section section) {
    if (section_ != section) report<"section_not_open">();
    section_ = Section::none;
  }

  Section section_{Section::none};
  bool named_{false};
  bool arguments_read_{false};
  bool waypoints_read_{false};
  bool too_many_{false};
};

/// The kind of Seaglider file that a line shows; empty if any file could have this line.
std::optional<DocumentKind> seaglider_kind(std::string_view line) {
  if (line.find("goto=") != std::string_view::npos) return DocumentKind::targets;
  if (line.find("sensors=") != std::string_view::npos) return DocumentKind::science;
  if (line.starts_with('$')) return DocumentKind::cmdfile;
  return std::nullopt;
}

DocumentKind kind_of(const std::string& name, const FileText& text) {
  const std::string lower = core::lower_case(name);
  if (lower.ends_with(".mi")) return DocumentKind::mission;
  if (lower.ends_with(".ma")) return DocumentKind::arguments;
  for (const auto& [word, kind] : {std::pair{"targets", DocumentKind::targets},
                                   {"science", DocumentKind::science},
                                   {"cmdfile", DocumentKind::cmdfile}}) {
    if (lower.find(word) != std::string::npos) return kind;
  }
  const bool named = std::ranges::any_of(text.lines, [](const std::string& line) {
    return after(split_comment(line).content, "behavior_name").has_value();
  });
  if (named) return DocumentKind::arguments;
  for (const std::string& line : text.lines) {
    if (line.starts_with('/')) continue;
    if (const auto kind = seaglider_kind(line)) return *kind;
  }
  return DocumentKind::mission;
}

bool has_too_many_errors(const Messages& messages) {
  return std::ranges::count(messages, Severity::error, &Message::severity) > max_errors;
}

template <class LineReader>
void read_lines(const FileText& text, LineReader reader, Document& document) {
  std::size_t judged = 0;
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    const SplitLine line = split_comment(text.lines[i]);
    document.lines.push_back({"", std::string{line.comment}});
    if (line.content.empty()) continue;
    reader.read(line.content, static_cast<int>(i) + 1);
    if (document.messages.size() == judged) continue;
    judged = document.messages.size();
    if (has_too_many_errors(document.messages)) {
      report(document, static_cast<int>(i) + 1,
             messages::mission_file_message<"too_many_errors">(max_errors));
      return;
    }
  }
  reader.finish();
}

void warn_of_layout(const FileText& text, Messages& messages) {
  if (text.byte_order_mark) {
    messages.push_back(finding(1, messages::mission_file_message<"byte_order_mark">()));
  }
  if (text.format.line_endings == "CR" || text.format.line_endings == "mixed") {
    messages.push_back(finding(0, messages::mission_file_message<"carriage_return_alone">()));
  }
}

void read_text(const FileText& text, Document& document) {
  switch (document.kind) {
    case DocumentKind::targets: return read_targets(text, document);
    case DocumentKind::science: return read_science(text, document);
    case DocumentKind::cmdfile: return read_cmdfile(text, document);
    case DocumentKind::mission: read_lines(text, MissionReader{document}, document); break;
    case DocumentKind::arguments: read_lines(text, ArgumentsReader{document}, document); break;
  }
  check_document(document);
  if (const auto hold = hold_order(document))
    report(document, 0, messages::mission_file_message<"holds_station">(hold_text(*hold)));
}

}  // namespace

Document read_document(std::string name, std::string_view bytes) {
  Document document;
  document.name = std::move(name);
  document.format.bytes = bytes.size();
  const auto text = decode_file(bytes);
  if (!text) {
    document.kind = kind_of(document.name, {});
    document.messages.push_back(text.error());
    return document;
  }
  document.format = text->format;
  document.format.bytes = bytes.size();
  document.kind = kind_of(document.name, *text);
  warn_of_layout(*text, document.messages);
  read_text(*text, document);
  std::ranges::stable_sort(document.messages, {}, &Message::line);
  return document;
}

}  // namespace floeplan::mission
