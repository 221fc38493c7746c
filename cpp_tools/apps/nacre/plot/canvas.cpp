// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "plot/canvas.h"

#include <memory>
#include <numbers>

#include <cairo-svg.h>
#include <fmt/format.h>

#include "nacre/core/diagnostics.h"

namespace nacre::tool {
namespace {

constexpr const char* kFont = "DejaVu Sans";
constexpr std::string_view kEllipsis = "…";

struct Release {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length)
{
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status)
{
    if (status != CAIRO_STATUS_SUCCESS)
        throw InputError(
            {{}, 0, "--plot", fmt::format("cannot be drawn: {}", cairo_status_to_string(status))});
}

void draw_on(cairo_surface_t& surface, const Drawing& drawing)
{
    const Owned<cairo_t> context(cairo_create(&surface));
    Canvas canvas(*context);
    drawing(canvas);
    check(cairo_status(context.get()));
}

/// As XML has it between tags.
std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return result;
}

/// Removes the last character, which may be several bytes of UTF-8.
void pop_character(std::string& text)
{
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U)
        text.pop_back();
    if (!text.empty()) text.pop_back();
}

std::vector<std::string> words_of(const std::string& text)
{
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (static_cast<unsigned char>(c) <= 0x20)
            words.emplace_back();
        else
            words.back() += c;
    }
    std::erase(words, "");
    return words;
}

}  // namespace

void Canvas::use(const Paint& paint)
{
    cairo_set_source_rgba(&context_, paint.red, paint.green, paint.blue, paint.alpha);
}

void Canvas::use(const Lettering& lettering)
{
    cairo_select_font_face(&context_, kFont, CAIRO_FONT_SLANT_NORMAL,
                           lettering.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(&context_, lettering.size);
    use(lettering.paint);
}

double Canvas::width_of(const std::string& text)
{
    cairo_text_extents_t extents;
    cairo_text_extents(&context_, text.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::trace(const std::vector<Point>& points)
{
    cairo_new_path(&context_);
    for (const Point& point : points) cairo_line_to(&context_, point.x, point.y);
}

void Canvas::fill(const Box& box, const Paint& paint)
{
    use(paint);
    cairo_rectangle(&context_, box.left, box.top, box.right - box.left, box.bottom - box.top);
    cairo_fill(&context_);
}

void Canvas::frame(const Box& box, const Paint& paint)
{
    line({{box.left, box.top},
          {box.right, box.top},
          {box.right, box.bottom},
          {box.left, box.bottom},
          {box.left, box.top}},
         paint, 1.0);
}

void Canvas::line(const std::vector<Point>& points, const Paint& paint, double width)
{
    use(paint);
    cairo_set_line_width(&context_, width);
    cairo_set_line_join(&context_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(&context_, CAIRO_LINE_CAP_SQUARE);
    trace(points);
    cairo_stroke(&context_);
}

void Canvas::fill(const std::vector<Point>& outline, const std::vector<GradientStop>& stops,
                  double left, double right)
{
    const Owned<cairo_pattern_t> pattern(cairo_pattern_create_linear(left, 0.0, right, 0.0));
    for (const auto& [position, paint] : stops)
        cairo_pattern_add_color_stop_rgba(pattern.get(), position, paint.red, paint.green,
                                          paint.blue, paint.alpha);
    cairo_set_source(&context_, pattern.get());
    trace(outline);
    cairo_close_path(&context_);
    cairo_fill(&context_);
}

void Canvas::text(const Point& at, const std::string& text, const Lettering& lettering)
{
    use(lettering);
    double shift = 0.0;
    if (lettering.anchor == Anchor::middle) shift = 0.5 * width_of(text);
    if (lettering.anchor == Anchor::right) shift = width_of(text);
    cairo_save(&context_);
    cairo_translate(&context_, at.x, at.y);
    if (lettering.upwards) cairo_rotate(&context_, -0.5 * std::numbers::pi);
    cairo_move_to(&context_, -shift, 0.0);
    cairo_show_text(&context_, text.c_str());
    cairo_restore(&context_);
}

std::string Canvas::fitted(const std::string& text, const Lettering& lettering, double width)
{
    use(lettering);
    if (width_of(text) <= width) return text;
    std::string start = text;
    // A megabyte of text is cut before it is measured.
    constexpr std::size_t kLongest = 1000;
    if (start.size() > kLongest) {
        start.resize(kLongest);
        pop_character(start);
    }
    while (!start.empty() && width_of(fmt::format("{}{}", start, kEllipsis)) > width)
        pop_character(start);
    return fmt::format("{}{}", start, kEllipsis);
}

std::vector<std::string> Canvas::wrapped(const std::string& text, const Lettering& lettering,
                                         double width, std::size_t most)
{
    use(lettering);
    std::vector<std::string> lines;
    for (const std::string& word : words_of(text)) {
        if (!lines.empty() &&
            (lines.size() == most || width_of(lines.back() + " " + word) <= width))
            lines.back() += " " + word;
        else
            lines.push_back(word);
        if (lines.size() == most && width_of(lines.back()) > width) break;
    }
    for (std::string& line : lines) line = fitted(line, lettering, width);
    return lines;
}

std::string draw_svg(int width, int height, std::string_view title, const Drawing& drawing)
{
    std::string svg;
    {
        const Owned<cairo_surface_t> surface(
            cairo_svg_surface_create_for_stream(append, &svg, width, height));
        cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
        draw_on(*surface, drawing);
        cairo_surface_finish(surface.get());
        check(cairo_surface_status(surface.get()));
    }
    const std::size_t start = svg.find('>', svg.find("<svg"));
    svg.insert(start + 1, fmt::format("\n<title>{}</title>", escaped(title)));
    return svg;
}

std::string draw_png(int width, int height, int scale, const Drawing& drawing)
{
    const Owned<cairo_surface_t> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, width * scale, height * scale));
    cairo_surface_set_device_scale(surface.get(), scale, scale);
    draw_on(*surface, drawing);
    std::string png;
    check(cairo_surface_write_to_png_stream(surface.get(), append, &png));
    return png;
}

}  // namespace nacre::tool
