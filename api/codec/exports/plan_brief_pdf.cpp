#include <cairo-pdf.h>

#include <array>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "api/codec/exports/plan_brief.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

// Lengths in points (1/72 inch).
constexpr double page_width = 595.0;
constexpr double page_height = 842.0;
constexpr double margin = 36.0;
constexpr double text_width = page_width - 2.0 * margin;
constexpr std::array<double, 10> column_ends{20.0,  82.0,  146.0, 248.0, 288.0,
                                             326.0, 372.0, 416.0, 482.0, 523.0};

struct Colour {
  double red, green, blue;
};
constexpr Colour ink{0.07, 0.07, 0.07};
constexpr Colour faint{0.72, 0.78, 0.82};
constexpr Colour sea{0.93, 0.96, 0.97};
constexpr Colour land{0.85, 0.82, 0.75};
constexpr Colour ice{0.04, 0.43, 0.66};
constexpr Colour route{0.76, 0.25, 0.05};
constexpr Colour surfacing{0.07, 0.47, 0.20};
constexpr Colour paper{1.0, 1.0, 1.0};
constexpr Colour hatch{0.16, 0.31, 0.42};
constexpr Colour waypoint_ink{0.49, 0.18, 0.07};

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// The text as valid UTF-8, with '?' for invalid bytes: a single invalid byte would make the drawing library
/// drop the whole drawing.
std::string drawable(const std::string& text) {
  std::string kept;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                                                             : 0;
    bool whole = length > 0 && i + length <= text.size() && lead >= 0x20 && lead != 0x7F;
    for (std::size_t k = 1; whole && k < length; ++k)
      whole = (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
    kept += whole ? text.substr(i, length) : "?";
    i += whole ? length : 1;
  }
  return kept;
}

/// A document that is drawn from top to bottom.
class Sheet {
 public:
  explicit Sheet(core::UtcTime generated)
      : surface_{cairo_pdf_surface_create_for_stream(append, &bytes_, page_width, page_height),
                 cairo_surface_destroy},
        draw_{cairo_create(surface_.get()), cairo_destroy} {
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   core::iso8601(generated).c_str());
    cairo_set_line_join(pen(), CAIRO_LINE_JOIN_ROUND);
  }

  [[nodiscard]] cairo_t* pen() const { return draw_.get(); }
  void colour(Colour c) const { cairo_set_source_rgb(pen(), c.red, c.green, c.blue); }

  void font(double size, bool bold) const {
    cairo_select_font_face(pen(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(pen(), size);
  }
  [[nodiscard]] double width_of(const std::string& text) const {
    cairo_text_extents_t extents{};
    cairo_text_extents(pen(), text.c_str(), &extents);
    return extents.x_advance;
  }
  void write_at(double x, double y, const std::string& text) const {
    cairo_move_to(pen(), x, y);
    cairo_show_text(pen(), text.c_str());
  }

  /// Begins a new page if less than `height` is left.
  void need(double height) {
    if (y_ + height <= page_height - margin) return;
    cairo_show_page(pen());
    y_ = margin;
  }
  void skip(double height) { y_ += height; }
  [[nodiscard]] double y() const { return y_; }

  /// Draws a text, broken into lines between words.
  void paragraph(const std::string& text, double size, bool bold = false) {
    font(size, bold);
    colour(ink);
    std::string line;
    const auto flush = [&] {
      need(1.35 * size);
      y_ += 1.2 * size;
      write_at(margin, y_, line);
      line.clear();
    };
    std::size_t begin = 0;
    const std::string words = drawable(text);
    while (begin < words.size()) {
      const std::size_t end = std::min(words.find(' ', begin), words.size());
      const std::string word = words.substr(begin, end - begin);
      if (!line.empty() && width_of(line + " " + word) > text_width) flush();
      line += (line.empty() ? "" : " ") + word;
      begin = end + 1;
    }
    if (!line.empty()) flush();
    y_ += 0.3 * size;
  }

  [[nodiscard]] std::string finish() {
    cairo_show_page(pen());
    cairo_surface_finish(surface_.get());
    if (cairo_status(pen()) != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error{std::string{"the PDF cannot be drawn: "} +
                               cairo_status_to_string(cairo_status(pen()))};
    return bytes_;
  }

 private:
  std::string bytes_;
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
  std::unique_ptr<cairo_t, void (*)(cairo_t*)> draw_;
  double y_{margin};
};

void trace(cairo_t* pen, const std::vector<MapPicture::Point>& points) {
  cairo_new_path(pen);  // drawing text leaves a current point, which would start a line
  for (const auto& point : points) cairo_line_to(pen, point.x, point.y);
}

void stroke(const Sheet& sheet, const std::vector<MapPicture::Point>& points, Colour colour, double width) {
  trace(sheet.pen(), points);
  sheet.colour(colour);
  cairo_set_line_width(sheet.pen(), width);
  cairo_stroke(sheet.pen());
}

void disc(const Sheet& sheet, const MapPicture::Point& centre, double radius, Colour fill, Colour edge) {
  cairo_t* pen = sheet.pen();
  cairo_new_sub_path(pen);
  cairo_arc(pen, centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
  sheet.colour(fill);
  cairo_fill_preserve(pen);
  sheet.colour(edge);
  cairo_set_line_width(pen, 1.0);
  cairo_stroke(pen);
}

/// Draws the mark of a waypoint where the vehicle may not surface.
void square(const Sheet& sheet, const MapPicture::Point& centre) {
  cairo_t* pen = sheet.pen();
  cairo_rectangle(pen, centre.x - 0.5 * closed_side, centre.y - 0.5 * closed_side, closed_side, closed_side);
  sheet.colour(route);
  cairo_fill_preserve(pen);
  sheet.colour(paper);
  cairo_set_line_width(pen, 1.0);
  cairo_stroke(pen);
}

/// Writes the name of a waypoint with a white edge, to be read on hatched ice.
void write_on_white(const Sheet& sheet, const MapPicture::Label& label) {
  cairo_t* pen = sheet.pen();
  cairo_move_to(pen, label.at.x, label.at.y);
  cairo_text_path(pen, label.text.c_str());
  sheet.colour(paper);
  cairo_set_line_width(pen, 3.0);
  cairo_stroke(pen);
  sheet.colour(waypoint_ink);
  sheet.write_at(label.at.x, label.at.y, label.text);
}

void draw_ice(const Sheet& sheet, const IceMarks& marks, cairo_t* pen) {
  for (const auto& line : marks.hatch) stroke(sheet, line, hatch, 0.7);
  for (const auto& line : marks.unknown) stroke(sheet, line, hatch, 0.7);
  for (const auto& line : marks.edge) stroke(sheet, line, ink, 1.0);
  constexpr std::array dashes{7.0, 4.0};
  cairo_set_dash(pen, dashes.data(), dashes.size(), 0.0);
  for (const auto& line : marks.limit) stroke(sheet, line, ink, 1.8);
  cairo_set_dash(pen, nullptr, 0, 0.0);
}

/// Draws a picture of this size, scaled to the width of the text, on this ground; continues below it.
template <class Draw>
void draw_across(Sheet& sheet, double width, double height, Colour ground, const Draw& draw) {
  cairo_t* pen = sheet.pen();
  const double scale = text_width / width;
  sheet.need(scale * height + 6.0);
  cairo_save(pen);
  cairo_translate(pen, margin, sheet.y());
  cairo_scale(pen, scale, scale);
  cairo_rectangle(pen, 0.0, 0.0, width, height);
  sheet.colour(ground);
  cairo_fill(pen);
  draw(pen);
  cairo_restore(pen);
  sheet.skip(scale * height + 6.0);
}

void draw_map(Sheet& sheet, const MapPicture& picture, cairo_t* pen) {
  cairo_rectangle(pen, 0.0, 0.0, picture.width, picture.height);
  cairo_clip(pen);
  if (picture.ice) draw_ice(sheet, picture.ice->marks, pen);
  for (const auto& outline : picture.land) {
    trace(pen, outline);
    cairo_close_path(pen);
    sheet.colour(land);
    cairo_fill(pen);
  }
  for (const auto& line : picture.grid) stroke(sheet, line, faint, 0.5);
  sheet.font(9.0, false);
  sheet.colour(ink);
  for (const auto& label : picture.grid_labels) sheet.write_at(label.at.x, label.at.y, label.text);
  for (const auto& berg : picture.icebergs) disc(sheet, berg.centre, berg.radius, paper, ice);
  for (const auto& way : picture.escapes) stroke(sheet, way, paper, 6.0);
  constexpr std::array dots{2.0, 3.0};
  cairo_set_dash(pen, dots.data(), dots.size(), 0.0);
  for (const auto& way : picture.escapes) stroke(sheet, way, surfacing, 2.5);
  cairo_set_dash(pen, nullptr, 0, 0.0);
  stroke(sheet, picture.route, paper, 6.0);
  stroke(sheet, picture.route, route, 2.5);
  constexpr std::array dashes{6.0, 6.0};
  cairo_set_dash(pen, dashes.data(), dashes.size(), 0.0);
  for (const auto& leg : picture.below_ice) stroke(sheet, leg, paper, 4.0);
  cairo_set_dash(pen, nullptr, 0, 0.0);
  for (const auto& place : picture.closed) square(sheet, place);
  for (const auto& place : picture.surfacings) {
    disc(sheet, place, surfacing_radius, surfacing, paper);
    for (const auto& line : surfacing_arrow(place)) stroke(sheet, line, paper, 1.5);
  }
  sheet.font(11.0, true);
  for (const auto& label : picture.waypoints) write_on_white(sheet, label);
  stroke(sheet, picture.scale, ink, 2.0);
  sheet.font(9.0, false);
  sheet.write_at(picture.scale.front().x, picture.scale.front().y - 4.0, picture.scale_label);
}

void draw_key(Sheet& sheet, const IceKey& key, cairo_t* pen) {
  draw_ice(sheet, key.marks, pen);
  sheet.font(9.0, false);
  sheet.colour(ink);
  for (const auto& label : key.labels) sheet.write_at(label.at.x, label.at.y, label.text);
}

void draw_section(Sheet& sheet, const IceSection& section, cairo_t* pen) {
  for (const auto& line : section.grid) stroke(sheet, line, faint, 0.5);
  sheet.font(9.0, false);
  sheet.colour(ink);
  for (const auto& label : section.labels) sheet.write_at(label.at.x, label.at.y, label.text);
  constexpr std::array dots{2.0, 3.0};
  cairo_set_dash(pen, dots.data(), dots.size(), 0.0);
  for (const auto& line : section.keel) stroke(sheet, line, ink, 1.5);
  cairo_set_dash(pen, nullptr, 0, 0.0);
  for (const auto& line : section.draft) stroke(sheet, line, ink, 3.0);
  stroke(sheet, section.turn, route, 2.0);
}

void write_row(Sheet& sheet, const std::vector<std::string>& cells, bool bold) {
  sheet.need(13.0);
  sheet.skip(12.0);
  sheet.font(8.5, bold);
  sheet.colour(ink);
  for (std::size_t i = 0; i < cells.size() && i < column_ends.size(); ++i)
    sheet.write_at(margin + column_ends[i] - sheet.width_of(cells[i]), sheet.y(), cells[i]);
}

}  // namespace

std::string plan_brief_pdf(const planning::Plan& plan, const BriefPictures& pictures,
                           const BriefNotes& notes) {
  Sheet sheet{notes.generated};
  sheet.paragraph(notes.name.empty() ? "Plan " + notes.plan_id : notes.name, 16.0, true);
  sheet.paragraph(brief_origin(notes), 9.0);
  for (const std::string& fact : brief_facts(plan, notes)) sheet.paragraph(fact, 9.0);
  draw_across(sheet, pictures.map.width, pictures.map.height, sea,
              [&](cairo_t* pen) { draw_map(sheet, pictures.map, pen); });
  if (pictures.map.ice) {
    const IceKey key = draw_ice_key(pictures.map.width, pictures.map.ice->limit);
    draw_across(sheet, key.width, key.height, paper, [&](cairo_t* pen) { draw_key(sheet, key, pen); });
  }
  sheet.paragraph(brief_caption(pictures.map), 7.5);
  if (pictures.ice) {
    draw_across(sheet, pictures.ice->width, pictures.ice->height, sea,
                [&](cairo_t* pen) { draw_section(sheet, *pictures.ice, pen); });
    sheet.paragraph(section_caption, 7.5);
  }
  write_row(sheet,
            {"no.", "latitude", "longitude", "ETA (UTC)", "leg km", "course", "SOG m/s", "depth m",
             "may surface", "turn m"},
            true);
  for (const auto& row : brief_rows(plan)) write_row(sheet, row, false);
  sheet.skip(8.0);
  for (const auto& [title, sentences] : brief_messages(plan, notes)) {
    sheet.paragraph(title, 9.0, true);
    for (const std::string& sentence : sentences) sheet.paragraph(sentence, 9.0);
  }
  if (!notes.alternatives.empty()) sheet.paragraph("Alternatives", 9.0, true);
  for (const std::string& alternative : notes.alternatives) sheet.paragraph(alternative, 9.0);
  for (const auto& dataset : plan.datasets)
    sheet.paragraph(dataset.kind + ": " + dataset.name + " (" + dataset.id + "), sha256 " + dataset.sha256,
                    7.0);
  sheet.paragraph("No exported file has been tried on a vehicle. Check it before use.", 9.0, true);
  return sheet.finish();
}

}  // namespace floeplan::codec
