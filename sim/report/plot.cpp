// SPDX-License-Identifier: Apache-2.0
#include "sim/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/report/html.h"

namespace shading::report {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void Add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  Range OrDefault() const { return low <= high ? *this : Range{1, 10}; }
};

// Short enough for the margin: powers of ten far from 1 with an exponent.
std::string TickText(double tick) {
  const double size = std::abs(tick);
  if (size == 0 || (size >= 1e-3 && size < 1e5)) return Significant(tick);
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  return fmt::format("{:.3g}e{}", tick / std::pow(10, exponent), exponent);
}

}  // namespace

bool Plot::Drawable(double x, double y) const {
  return std::isfinite(x) && std::isfinite(y) && (!x_.logarithmic || x > 0) &&
         (!y_.logarithmic || y > 0);
}

Plot::Drawing Plot::Begin() const {
  Range x, y;
  const auto add = [&](double px, double py) {
    if (!Drawable(px, py)) return;
    x.Add(px);
    y.Add(py);
  };
  double right = 10;
  for (const Mark& mark : marks_) add(mark.x, mark.y);
  for (const Line& line : lines_) {
    for (const auto& [px, py] : line.points) add(px, py);
    if (!line.label.empty() && !line.label_left)
      right = std::max(right, LabelPlacer::WidthOf(line.label) + 14);
  }
  x = x.OrDefault();
  y = y.OrDefault();
  const Box frame = {56, 24, width_ - right, height_ - 38.0};
  return {frame, Scale(x.low, x.high, x_.logarithmic, frame.left, frame.right),
          Scale(y.low, y.high, y_.logarithmic, frame.bottom, frame.top), ""};
}

void Plot::DrawAxes(Drawing* d) const {
  const Box& f = d->frame;
  const auto many = [](double pixels, double each) {
    return std::max(2, static_cast<int>(pixels / each));
  };
  for (const double tick : d->x.Ticks(many(f.right - f.left, 42))) {
    const double at = d->x(tick);
    const std::string text = TickText(tick);
    d->svg += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"soft\" x=\"{3:.1f}\" y=\"{4}\" "
        "text-anchor=\"middle\">{5}</text>\n",
        at, f.top, f.bottom, std::min(at, width_ - LabelPlacer::WidthOf(text) / 2), f.bottom + 14,
        text);
  }
  for (const double tick : d->y.Ticks(many(f.bottom - f.top, 24))) {
    const double at = d->y(tick);
    d->svg += fmt::format(
        "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"soft\" x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5}</text>\n",
        f.left, at, f.right, f.left - 5, at + 4, TickText(tick));
  }
  d->svg +=
      fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                  f.left, f.top, f.right - f.left, f.bottom - f.top);
  d->svg +=
      fmt::format("<text class=\"title\" x=\"{}\" y=\"16\">{}</text>", f.left, EscapeHtml(title_));
  d->svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                        (f.left + f.right) / 2, height_ - 8, EscapeHtml(x_.label));
  d->svg += fmt::format(
      "<text transform=\"translate(11 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      (f.top + f.bottom) / 2, EscapeHtml(y_.label));
}

void Plot::DrawLines(Drawing* d) const {
  for (const Line& line : lines_) {
    std::string path;
    for (const auto& [px, py] : line.points) {
      if (!Drawable(px, py)) continue;
      const double x = d->x(px), y = d->y(py);
      if (line.dashed && !path.empty()) path += fmt::format("H{:.1f}", x);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x, y);
    }
    if (path.empty()) continue;
    const std::string look = line.dashed ? "front" : fmt::format("line s{}", line.colour);
    d->svg += fmt::format("<path class=\"{}\" d=\"{}\"><title>{}</title></path>\n", look, path,
                          EscapeHtml(line.label));
  }
}

void Plot::DrawLineLabels(Drawing* d) const {
  constexpr double kPitch = 13;
  struct Label {
    double at, end_x, end_y;
    const Line* line;
  };
  std::vector<Label> labels;
  for (const Line& line : lines_) {
    if (line.label.empty() || line.points.empty()) continue;
    const auto& end = line.label_left ? line.points.front() : line.points.back();
    const double y = d->y(end.second);
    labels.push_back({line.label_left ? y - 8 : y, d->x(end.first), y, &line});
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.at < b.at; });
  // Up so that none covers the one below it, then down again where that left the frame.
  for (size_t i = labels.size(); i-- > 1;) {
    labels[i - 1].at = std::min(labels[i - 1].at, labels[i].at - kPitch);
  }
  double limit = d->frame.top + 6;
  for (Label& label : labels) {
    label.at = std::max(label.at, limit);
    limit = label.at + kPitch;
  }
  for (const Label& label : labels) {
    const bool left = label.line->label_left;
    const double x = left ? label.end_x + 6 : d->frame.right + 8;
    d->svg += fmt::format(
        "<path class=\"line s{}\" style=\"stroke-width:1\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>"
        "<text class=\"halo f{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
        label.line->colour, label.end_x, label.end_y, x - 1, label.at, label.line->colour, x,
        label.at + 4, EscapeHtml(label.line->label));
  }
}

void Plot::DrawMarks(Drawing* d) const {
  LabelPlacer placer(d->frame);
  std::string labels;
  // Grey ones below the others.
  for (const bool dim : {true, false}) {
    for (const Mark& mark : marks_) {
      if (mark.dim != dim || !Drawable(mark.x, mark.y)) continue;
      const double x = d->x(mark.x), y = d->y(mark.y), r = dim ? 3 : 4.5;
      placer.Occupy({x - r, y - r, x + r, y + r});
      const std::string look = dim ? "dim" : fmt::format("f{}", mark.colour);
      const std::string shape =
          mark.square ? fmt::format("rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\"",
                                    x - r, y - r, 2 * r, 2 * r)
                      : fmt::format("circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"", x, y, r);
      d->svg += fmt::format("<{} class=\"{}\"><title>{}</title></{}>\n", shape, look,
                            EscapeHtml(mark.hint), mark.square ? "rect" : "circle");
    }
  }
  for (const Mark& mark : marks_) {
    if (mark.label.empty() || !Drawable(mark.x, mark.y)) continue;
    const double x = d->x(mark.x), y = d->y(mark.y);
    const LabelPlacer::Place place = placer.Find(x, y, mark.label);
    if (place.far_away) {
      labels += fmt::format("<path class=\"grid s{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>",
                            mark.colour, x, y, place.line_x, place.line_y);
    }
    labels +=
        fmt::format("<text{} x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                    mark.dim ? " class=\"soft\"" : "", place.x, place.y, EscapeHtml(mark.label));
  }
  d->svg += labels;
}

std::string Plot::Svg() const {
  Drawing drawing = Begin();
  DrawAxes(&drawing);
  DrawLines(&drawing);
  DrawLineLabels(&drawing);
  DrawMarks(&drawing);
  return fmt::format(
      "<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "aria-label=\"{2}\">\n{3}</svg>",
      width_, height_, EscapeHtml(title_), drawing.svg);
}

}  // namespace shading::report
