#include "api/codec/exports/plan_brief.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <utility>

#include "api/codec/bytes/bare_value.hpp"
#include "api/codec/bytes/document_values.hpp"
#include "api/codec/bytes/xml_text.hpp"
#include "api/fields/process_fields.hpp"
#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/written_place.hpp"
#include "engine/messages/sentence.hpp"

namespace floeplan::codec {
namespace {

std::string position_text(geo::LonLat place) {
  return geo::latitude_text(place.lat_deg) + " " + geo::longitude_text(place.lon_deg);
}

std::string number(std::optional<double> value, int decimals, double factor = 1.0) {
  if (!value) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, *value * factor);
  return text.data();
}

std::string distance(const std::optional<core::Metres>& known) {
  return known ? core::distance_text(*known) : "not known";
}

constexpr const char* style =
    "@page{size:A4;margin:12mm}body{font:10pt sans-serif;color:#111;max-width:190mm;margin:auto}"
    "h1{font-size:16pt;margin:0 0 2mm}p,ul{margin:1mm 0}svg{width:100%;height:auto;border:1px solid #888}"
    "table{border-collapse:collapse;width:100%;margin-top:2mm}th,td{border-bottom:1px solid "
    "#ccc;padding:.4mm 1mm;"
    "text-align:right;font-size:8.5pt}td{white-space:nowrap}li{break-inside:avoid}.sea{fill:#eef4f8}.land{"
    "fill:#d9d2c0;stroke:#8a8170;stroke-width:.6}"
    ".grid{stroke:#b8c6d0;stroke-width:.5;fill:none}.ice{fill:#fff;stroke:#0a6ea8;stroke-width:1}"
    ".route{fill:none;stroke:#c2410c;stroke-width:2.5}.below{fill:none;stroke:#fff;stroke-width:4;stroke-"
    "dasharray:6 6}"
    ".closed{fill:#c2410c;stroke:#fff;stroke-width:1}.escape{fill:none;stroke:#117733;stroke-width:2.5;"
    "stroke-dasharray:2 3}"
    ".draft{fill:none;stroke:#0a2f4a;stroke-width:3}.keel{fill:none;stroke:#0a2f4a;stroke-width:1.5;"
    "stroke-dasharray:2 "
    "3}.surfacing{fill:#117733;stroke:#fff;stroke-width:1}.arrow{fill:none;stroke:#fff;stroke-width:1.5}."
    "casing{fill:none;stroke:#fff;stroke-width:6}"
    ".paper{fill:#fff}.hatch{fill:none;stroke:#28506b;stroke-width:.7}.edge{fill:none;stroke:#0a2f4a;stroke-"
    "width:1}"
    ".limit{fill:none;stroke:#0a2f4a;stroke-width:1.8;stroke-dasharray:7 4}"
    ".scale{stroke:#111;stroke-width:2}.small{font:9px "
    "sans-serif;"
    "fill:#456}.number{font:bold 11px "
    "sans-serif;fill:#7c2d12;stroke:#fff;stroke-width:3;paint-order:stroke}.warn{border:1px solid "
    "#c2410c;padding:1mm 2mm}"
    ".caption{font-size:8pt;color:#456}.hash{font-family:monospace;font-size:8pt}";

std::string table(const planning::Plan& plan) {
  std::string text =
      "<table><thead><tr><th>no.</th><th>latitude</th><th>longitude</th><th>ETA (UTC)</th><th>leg km</th>"
      "<th>course</th><th>SOG m/s</th><th>depth m</th><th>may surface</th><th>turn "
      "m</th></tr></thead><tbody>\n";
  for (const auto& row : brief_rows(plan)) {
    text += "<tr>";
    for (const std::string& cell : row) text += "<td>" + xml_text(cell) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

/// Whether the vehicle may surface at a waypoint, in words; "-" if no ice is known.
std::string may_surface(const planning::Plan& plan, std::size_t waypoint) {
  if (!plan.surfacing) return "-";
  return plan.surfacing->waypoints.at(waypoint).may_surface ? "yes" : "no";
}

/// Depth at which dives on the leg to a waypoint must turn, rounded to the deeper metre.
std::string leg_turn(const planning::Plan& plan, std::size_t waypoint) {
  const auto turn = plan.surfacing ? plan.surfacing->waypoints.at(waypoint).leg_upper_turn : std::nullopt;
  return turn ? number(std::ceil(turn->value), 0) : "-";
}

/// One sentence for each hold: "Hold 2 h 40 min at waypoint 4."
std::vector<std::string> hold_facts(const planning::Plan& plan) {
  std::vector<std::string> facts;
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    if (const auto wait = plan.waypoints[i].wait; wait.count() > 0.0)
      facts.push_back("Hold " + core::hours_minutes(wait) + " at waypoint " + waypoint_label(i) + ".");
  }
  return facts;
}

/// "Safe places: R1 69°12.000′N 053°12.000′W; R2 ...", by the names that the map gives them.
std::string safe_places_fact(const std::vector<geo::LonLat>& places) {
  std::string text = "Safe places:";
  for (std::size_t i = 0; i < places.size(); ++i)
    text += (i == 0 ? " R" : "; R") + std::to_string(i + 1) + " " + position_text(places[i]);
  return text + ".";
}

/// The lines about sea ice and surfacing; empty if the plan knows nothing about ice.
std::vector<std::string> ice_facts(const planning::Plan& plan) {
  if (!plan.surfacing) return {};
  const auto below = planning::time_below_ice(*plan.surfacing);
  return {"Below ice or icebergs: " + distance(planning::length_below_ice(*plan.surfacing)) + ", " +
          (below ? core::hours_minutes(*below) : "-") + ". Longest time without a place to surface: " +
          core::hours_minutes(plan.surfacing->longest_without) +
          ". Sea ice unknown: " + distance(plan.surfacing->unknown_ice) +
          ". Planned surfacings: " + std::to_string(plan.surfacing->surfacings.size()) + "."};
}

/// What the plan would be without the weight on encounters; empty if it has none.
std::string without_weight(const std::optional<planning::EncounterTrade>& trade) {
  if (!trade) return "";
  return " An encounter counts as " + core::hours_minutes(trade->weight) +
         "; without this weight: " + core::hours_minutes(trade->time_before) + " and " +
         number(trade->encounters_before, 2) + " encounters.";
}

/// How the arrival spreads with the currents, and the chance of the arrival that was asked for.
std::string spread_fact(const planning::UncertaintyReport& report) {
  const planning::ArrivalSpread& spread = report.spread;
  const auto taken = [](const std::optional<core::Seconds>& time) {
    return time ? core::hours_minutes(*time) : "not known";
  };
  std::string text = "Uncertain currents: " + std::to_string(spread.arrived()) + " of " +
                     std::to_string(spread.travel_times().size()) + " members arrive, in the mean after " +
                     taken(spread.mean()) + "; 90 % of all within " + taken(spread.quantile(0.9)) + ".";
  if (report.chance && report.arrive_before)
    text += " Chance to arrive before " + core::iso8601(*report.arrive_before) + ": " +
            number(report.chance, 0, 100.0) + " %.";
  return text;
}

/// The label of each setting in the forms of the desk, by its flag.
std::map<std::string, std::string, std::less<>> labels_by_flag() {
  std::map<std::string, std::string, std::less<>> labels;
  for (const auto& all : {fields::fields_of(fields::Process::plan_route), fields::fields_of_vehicle()})
    for (const fields::Field& field : all)
      if (!field.flag.empty() && !field.form.label.empty())
        labels.emplace(std::string{field.flag}, std::string{field.form.label});
  return labels;
}

/// The text with each match of the pattern replaced by what `write` makes of it.
std::string rewritten(const std::string& text, const std::regex& pattern,
                      const std::function<std::string(const std::smatch&)>& write) {
  std::string result;
  auto rest = text.cbegin();
  for (std::sregex_iterator found{text.begin(), text.end(), pattern}, none; found != none; ++found) {
    result.append(rest, (*found)[0].first);
    result += write(*found);
    rest = (*found)[0].second;
  }
  return result.append(rest, text.cend());
}

/// A sentence with labels, as “Via points”, in place of flags, as --via: whoever holds the page may have no command line.
/// A flag without a label loses its dashes.
std::string with_labels(const std::string& sentence) {
  static const auto labels = labels_by_flag();
  static const std::regex flag{"--([a-z]+(?:-[a-z]+)*)"};
  return rewritten(sentence, flag, [](const std::smatch& found) {
    const auto label = labels.find(found[1].str());
    return "\u201c" + (label == labels.end() ? found[1].str() : label->second) + "\u201d";
  });
}

/// A sentence with its positions, as -51.3500, 69.1707, written as in the table of waypoints.
std::string with_positions(const std::string& sentence) {
  static const std::regex lon_lat{"(-?[0-9]{1,3}\\.[0-9]{4}), (-?[0-9]{1,2}\\.[0-9]{4})"};
  return rewritten(sentence, lon_lat, [](const std::smatch& found) {
    return position_text({std::stod(found[1].str()), std::stod(found[2].str())});
  });
}

/// The message with a capital, a full stop and, unless the sentence has it, its position.
std::string printed_sentence(const messages::Message& message) {
  std::string sentence = with_positions(with_labels(messages::whole_text(message)));
  if (sentence.empty()) return sentence;
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  if (message.place && sentence.find(position_text(*message.place)) == std::string::npos)
    sentence += " (" + position_text(*message.place) + ")";
  return sentence + (sentence.ends_with('.') ? "" : ".");
}

std::string list(const std::string& title, const std::vector<std::string>& sentences,
                 const char* style_class) {
  if (sentences.empty()) return "";
  std::string text = "<div class=\"" + std::string{style_class} + "\"><b>" + title + "</b><ul>\n";
  for (const std::string& sentence : sentences) text += "<li>" + xml_text(sentence) + "</li>\n";
  return text + "</ul></div>\n";
}

}  // namespace

std::vector<std::vector<std::string>> brief_rows(const planning::Plan& plan) {
  std::vector<std::vector<std::string>> rows;
  rows.reserve(plan.waypoints.size());
  for (const planning::Waypoint& waypoint : plan.waypoints) {
    rows.push_back({waypoint_label(rows.size()), geo::latitude_text(waypoint.place.lat_deg),
                    geo::longitude_text(waypoint.place.lon_deg), core::iso8601(waypoint.eta),
                    number(bare(waypoint.leg_length), 2, 1e-3), number(waypoint.course_deg, 1),
                    number(bare(waypoint.speed_over_ground), 3), number(bare(waypoint.depth), 0),
                    may_surface(plan, rows.size()), leg_turn(plan, rows.size())});
  }
  return rows;
}

std::vector<std::string> brief_facts(const planning::Plan& plan, const BriefNotes& notes) {
  std::vector<std::string> facts{
      "Vehicle " + plan.vehicle + ". Departure " + core::iso8601(plan.departure) + ", arrival " +
          core::iso8601(plan.arrival) + ": " + core::hours_minutes(plan.travel_time()) + ", " +
          distance(plan.distance) + ".",
      "Least distance to icebergs " + distance(plan.clearances.iceberg) +
          (plan.clearances.nearest_iceberg.empty() ? "" : " (" + plan.clearances.nearest_iceberg + ")") +
          ", to land " + distance(plan.clearances.land) + ", to the sea bed " +
          distance(plan.clearances.bottom) + "."};
  if (plan.uncertainty) facts.push_back(spread_fact(*plan.uncertainty));
  std::ranges::move(hold_facts(plan), std::back_inserter(facts));
  if (plan.iceberg_encounters)
    facts.push_back("Expected encounters with icebergs: " + number(*plan.iceberg_encounters, 2) + "." +
                    without_weight(plan.encounter_trade));
  std::ranges::move(ice_facts(plan), std::back_inserter(facts));
  if (!notes.safe_places.empty()) facts.push_back(safe_places_fact(notes.safe_places));
  return facts;
}

std::string brief_origin(const BriefNotes& notes) {
  // otherwise the title contains the id
  const std::string plan = notes.name.empty() ? "" : "Plan " + notes.plan_id + ". ";
  return plan + "Printed " + core::iso8601(notes.generated) + " by Floeplan.";
}

std::string brief_caption(const MapPicture& picture) {
  std::string caption = "The route and its waypoints by number; north is up.";
  if (!picture.below_ice.empty()) caption += " Dashed: below ice or icebergs.";
  if (!picture.closed.empty()) caption += " Squares: the vehicle must not surface.";
  if (!picture.escapes.empty()) caption += " Dotted: escape routes to where it may.";
  if (!picture.surfacings.empty()) caption += " Discs with an arrow: planned surfacings.";
  if (picture.ice)
    caption += " Sea ice as of the departure, " + core::iso8601(picture.ice->time) +
               "; it moves while the vehicle is under way.";
  if (picture.icebergs.empty()) return caption;
  return caption +
         " Light discs: icebergs where they were last seen before the departure. They drift; the clearances "
         "are "
         "from where they are expected when the vehicle passes.";
}

std::vector<BriefMessages> brief_messages(const planning::Plan& plan, const BriefNotes& notes) {
  std::vector<messages::Message> told = notes.messages;
  told.insert(told.end(), plan.messages.begin(), plan.messages.end());
  std::vector<BriefMessages> ranks;
  for (const auto& [rank, title] : {std::pair{messages::Rank::danger, "Dangers"},
                                    {messages::Rank::caution, "Cautions"},
                                    {messages::Rank::note, "Notes"}}) {
    BriefMessages of_rank{title, {}};
    for (const messages::Message& message : told) {
      if (message.rank != rank) continue;
      std::string sentence = printed_sentence(message);
      if (std::ranges::find(of_rank.sentences, sentence) == of_rank.sentences.end())
        of_rank.sentences.push_back(std::move(sentence));
    }
    if (!of_rank.sentences.empty()) ranks.push_back(std::move(of_rank));
  }
  return ranks;
}

std::string plan_brief_html(const planning::Plan& plan, const BriefPictures& pictures,
                            const BriefNotes& notes) {
  const std::string title = xml_text(notes.name.empty() ? "Plan " + notes.plan_id : notes.name);
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
                     "</title><style>" + style + "</style></head><body>\n<h1>" + title + "</h1>\n<p>" +
                     xml_text(brief_origin(notes)) + "</p>\n";
  for (const std::string& fact : brief_facts(plan, notes)) text += "<p>" + xml_text(fact) + "</p>\n";
  const auto caption = [](const std::string& words) {
    return "<p class=\"caption\">" + xml_text(words) + "</p>\n";
  };
  text += svg(pictures.map);
  if (pictures.map.ice) text += svg(draw_ice_key(pictures.map.width, pictures.map.ice->limit));
  text += caption(brief_caption(pictures.map));
  if (pictures.ice) text += svg(*pictures.ice) + caption(section_caption);
  text += table(plan);
  for (const auto& [title_of_rank, sentences] : brief_messages(plan, notes))
    text += list(title_of_rank, sentences, "warn");
  text += list("Alternatives", notes.alternatives, "warn");
  std::vector<std::string> data;
  data.reserve(plan.datasets.size());
  for (const auto& dataset : plan.datasets)
    data.push_back(dataset.kind + ": " + dataset.name + " (" + dataset.id + "), sha256 " + dataset.sha256);
  text += list("Data", data, "hash");
  return text + "<p>No exported file has been tried on a vehicle. Check it before use.</p>\n</body></html>\n";
}

}  // namespace floeplan::codec
