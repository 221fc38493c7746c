// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "plot/frame.h"

#include "files/output.h"
#include "nacre/core/diagnostics.h"
#include "plot/colours.h"

namespace nacre::tool {
namespace {

constexpr Paint kPaper = {1.0, 1.0, 1.0};
constexpr Paint kGrey = {0.42, 0.44, 0.47};
constexpr Paint kRule = {0.89, 0.90, 0.91};
constexpr double kMargin = 24.0;

/// Draws one plot; each member one part of it.
class Page {
public:
    Page(Canvas& canvas, const Plot& plot)
        : canvas_(canvas),
          plot_(plot),
          x_(Axis::exactly(plot.wavelengths_nm.front(), plot.wavelengths_nm.back(), kPlotArea.left,
                           kPlotArea.right))
    {}

    void draw()
    {
        canvas_.fill(Box{0.0, 0.0, kPlotWidth, kPlotHeight}, kPaper);
        heading();
        rules();
        spectrum();
        for (std::size_t i = 0; i < plot_.curves.size(); ++i) curve(plot_.curves[i], i == 0);
        canvas_.frame(kPlotArea, kGrey);
        wavelengths();
        panel();
        citation();
    }

private:
    void heading()
    {
        const double width = kPlotWidth - 2.0 * kMargin;
        const Lettering title = {.size = 22.0, .paint = kInk, .bold = true};
        canvas_.text({kMargin, 40.0}, canvas_.fitted(plot_.title, title, width), title);
        const Lettering subtitle = {.size = 13.0, .paint = kGrey};
        canvas_.text({kMargin, 64.0}, canvas_.fitted(plot_.subtitle, subtitle, width), subtitle);
    }

    void rules()
    {
        for (const auto& tick : x_.ticks()) {
            const double x = x_.place(tick.value);
            canvas_.line({{x, kPlotArea.top}, {x, kPlotArea.bottom}}, kRule, 1.0);
        }
        const Axis& axis = plot_.curves.front().axis;
        for (const auto& tick : axis.ticks()) {
            const double y = axis.place(tick.value);
            canvas_.line({{kPlotArea.left, y}, {kPlotArea.right, y}}, kRule, 1.0);
        }
    }

    [[nodiscard]] std::vector<Point> points(const Curve& curve) const
    {
        std::vector<Point> result;
        result.reserve(curve.values.size());
        for (std::size_t i = 0; i < curve.values.size(); ++i)
            result.push_back(
                {x_.place(plot_.wavelengths_nm[i]), curve.axis.place(curve.values[i])});
        return result;
    }

    void spectrum()
    {
        constexpr double kStrip = 12.0;
        std::vector<Point> outline;
        if (plot_.filled)
            outline = points(plot_.curves.front());
        else
            outline = {{kPlotArea.left, kPlotArea.bottom - kStrip},
                       {kPlotArea.right, kPlotArea.bottom - kStrip}};
        outline.push_back({kPlotArea.right, kPlotArea.bottom});
        outline.push_back({kPlotArea.left, kPlotArea.bottom});
        canvas_.fill(outline,
                     visible_spectrum(plot_.wavelengths_nm.front(), plot_.wavelengths_nm.back()),
                     kPlotArea.left, kPlotArea.right);
    }

    void curve(const Curve& curve, bool left)
    {
        canvas_.line(points(curve), curve.paint, 2.0);
        if (!curve.numbered) return;
        const Lettering number = {
            .size = 12.0, .paint = curve.paint, .anchor = left ? Anchor::right : Anchor::left};
        const double side = left ? kPlotArea.left - 8.0 : kPlotArea.right + 8.0;
        for (const auto& tick : curve.axis.ticks())
            canvas_.text({side, curve.axis.place(tick.value) + 4.5}, tick.label, number);
        const bool letter = curve.label.size() == 1;
        const Lettering label = {.size = letter ? 15.0 : 13.0,
                                 .paint = curve.paint,
                                 .anchor = Anchor::middle,
                                 .bold = letter,
                                 .upwards = !letter};
        const double middle = 0.5 * (kPlotArea.top + kPlotArea.bottom);
        canvas_.text({left ? kPlotArea.left - 52.0 : kPlotArea.right + 54.0, middle}, curve.label,
                     label);
    }

    void wavelengths()
    {
        const Lettering number = {.size = 12.0, .paint = kInk, .anchor = Anchor::middle};
        for (const auto& tick : x_.ticks())
            canvas_.text({x_.place(tick.value), kPlotArea.bottom + 18.0}, tick.label, number);
        const Lettering label = {.size = 13.0, .paint = kInk, .anchor = Anchor::middle};
        canvas_.text({0.5 * (kPlotArea.left + kPlotArea.right), kPlotArea.bottom + 40.0},
                     "wavelength in nm", label);
    }

    void panel()
    {
        double y = kSwatchArea.top + 10.0;
        if (plot_.swatch) {
            canvas_.fill(kSwatchArea, *plot_.swatch);
            canvas_.frame(kSwatchArea, kGrey);
            const Lettering caption = {.size = 11.0, .paint = kGrey};
            y = kSwatchArea.bottom + 18.0;
            for (const std::string& line : canvas_.wrapped(plot_.caption, caption, 162.0, 2)) {
                canvas_.text({kSwatchArea.left, y}, line, caption);
                y += 15.0;
            }
            y += 9.0;
        }
        constexpr double kValues = 46.0;
        const Lettering name = {.size = 12.0, .paint = kGrey};
        for (const Fact& fact : plot_.facts) {
            const Lettering value = {.size = 12.0, .paint = fact.paint.value_or(kInk)};
            canvas_.text({kSwatchArea.left, y}, fact.name, name);
            canvas_.text({kSwatchArea.left + kValues, y}, fact.value, value);
            y += 18.0;
        }
    }

    void citation()
    {
        const Lettering small = {.size = 10.5, .paint = kGrey};
        double y = kPlotHeight - 50.0;
        for (const std::string& line :
             canvas_.wrapped(plot_.citation, small, kPlotWidth - 2.0 * kMargin, 3)) {
            canvas_.text({kMargin, y}, line, small);
            y += 15.0;
        }
    }

    Canvas& canvas_;
    const Plot& plot_;
    Axis x_;
};

}  // namespace

void check_plot_file(const std::filesystem::path& file)
{
    if (file.extension() != ".svg" && file.extension() != ".png")
        throw InputError({file.string(), 0, "--plot", "must end in .svg or .png"});
}

void write_plot(const std::filesystem::path& file, const Plot& plot)
{
    check_plot_file(file);
    const Drawing drawing = [&plot](Canvas& canvas) { Page(canvas, plot).draw(); };
    write_text_output(file.string(), file.extension() == ".svg"
                                         ? draw_svg(kPlotWidth, kPlotHeight, plot.title, drawing)
                                         : draw_png(kPlotWidth, kPlotHeight, kPlotPixels, drawing));
}

}  // namespace nacre::tool
