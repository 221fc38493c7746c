// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <cairo.h>

/// @file
/// Drawing that becomes an SVG or a PNG, the same bytes for the same drawing.

namespace nacre::tool {

struct Paint {
    double red, green, blue, alpha = 1.0;  ///< encoded as sRGB
};

inline constexpr Paint kInk{0.13, 0.14, 0.16};

struct Point {
    double x, y;
};

/// y downwards, as screens have it.
struct Box {
    double left, top, right, bottom;
};

struct GradientStop {
    double position;  ///< 0 at the left of what is filled, 1 at its right
    Paint paint;
};

enum class Anchor { left, middle, right };

struct Lettering {
    double size;
    Paint paint;
    Anchor anchor = Anchor::left;
    bool bold = false;
    bool upwards = false;  ///< turned by a quarter, read from the right
};

/// Units are pixels of the SVG.
class Canvas {
public:
    explicit Canvas(cairo_t& context) : context_(context) {}

    void fill(const Box& box, const Paint& paint);
    void frame(const Box& box, const Paint& paint);
    void line(const std::vector<Point>& points, const Paint& paint, double width);
    /// @param left, right  where the gradient starts and ends
    void fill(const std::vector<Point>& outline, const std::vector<GradientStop>& stops,
              double left, double right);
    /// On the baseline `at.y`.
    void text(const Point& at, const std::string& text, const Lettering& lettering);
    /// The start of a text that fits, with an ellipsis where it is cut.
    [[nodiscard]] std::string fitted(const std::string& text, const Lettering& lettering,
                                     double width);
    /// Lines that fit, broken at spaces; the last of `most` is cut where more follows.
    [[nodiscard]] std::vector<std::string> wrapped(const std::string& text,
                                                   const Lettering& lettering, double width,
                                                   std::size_t most);

private:
    void use(const Paint& paint);
    void use(const Lettering& lettering);
    [[nodiscard]] double width_of(const std::string& text);
    void trace(const std::vector<Point>& points);

    cairo_t& context_;
};

using Drawing = std::function<void(Canvas&)>;

/// @param title  of the document, as readers of a page hear it
/// @throws InputError when a text is no UTF-8
[[nodiscard]] std::string draw_svg(int width, int height, std::string_view title,
                                   const Drawing& drawing);
/// @param scale  pixels a unit
[[nodiscard]] std::string draw_png(int width, int height, int scale, const Drawing& drawing);

}  // namespace nacre::tool
