// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/bench_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/report/html.h"
#include "sim/report/plot.h"

namespace shading::sim {
namespace {

using report::Significant;

constexpr std::array<const char*, 6> kKinds = {"flat, gouraud",        "second-order intensity",
                                               "second-order cosines", "linear normals",
                                               "spherical normals",    "adaptive normals"};

// Which of kKinds; the colour of the page's style likewise.
int KindOf(Method method) {
  if (IsQuadRow(method) || method == Method::kQuadSplit) return 1;
  if (method == Method::kPhongSurface) return 3;
  if (method == Method::kQuadCosine) return 2;
  if (!InterpolatesNormals(method)) return 0;
  if (IsAdaptive(method)) return 5;
  return IsSpherical(method) ? 4 : 3;
}

// Marks that would lie on each other, of one kind.
struct Cluster {
  const Contest::Entrant* first;
  std::vector<const Contest::Entrant*> members;
};

bool Near(double a, double b) {
  return std::abs(a - b) <= 0.004 * std::max(std::abs(a), std::abs(b));
}

std::vector<Cluster> Clusters(const Contest& contest, bool front) {
  std::vector<Cluster> clusters;
  for (const Contest::Entrant& e : contest.entrants) {
    if (e.front != front) continue;
    const auto at = std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& c) {
      return Near(c.first->cost, e.cost) && Near(c.first->error, e.error) &&
             c.first->cell->key.lanes == e.cell->key.lanes;
    });
    if (at == clusters.end()) {
      clusters.push_back({&e, {&e}});
    } else {
      at->members.push_back(&e);
    }
  }
  return clusters;
}

std::string Hint(const Cluster& cluster) {
  std::string names;
  for (const Contest::Entrant* e : cluster.members) {
    names += (names.empty() ? "" : ", ") + Label(e->cell->key);
  }
  return fmt::format("{}: cost {}, error {} LSB RMS, {} lane{}", names,
                     Significant(cluster.first->cost), Significant(cluster.first->error),
                     cluster.first->cell->key.lanes, cluster.first->cell->key.lanes > 1 ? "s" : "");
}

std::string MarkLabel(const Cluster& cluster) {
  const std::string name = Label(cluster.first->cell->key);
  return cluster.members.size() == 1 ? name
                                     : fmt::format("{} +{}", name, cluster.members.size() - 1);
}

std::vector<std::pair<double, double>> SortedFront(const Contest& contest) {
  std::vector<std::pair<double, double>> points;
  for (const Contest::Entrant& e : contest.entrants) {
    if (e.front) points.emplace_back(e.cost, e.error);
  }
  std::sort(points.begin(), points.end());
  return points;
}

bool SameCurve(const SpanCurve& a, const SpanCurve& b) {
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const SpanCurve::Point& p, const SpanCurve::Point& q) {
                      return p.length == q.length && Near(p.cycles, q.cycles);
                    });
}

}  // namespace

std::string ParetoPlot(const Results& results, const Face& face, const std::string& scene,
                       int shininess) {
  constexpr int kWidth = 292, kHeight = 268;
  report::Plot plot(fmt::format("n = {}", shininess), {face.label, true}, {"RMS error, LSB", true},
                    kWidth, kHeight);
  const Contest contest = Compare(results, face, scene, shininess, ErrorKind::kRms);
  plot.Add(report::Line{SortedFront(contest), "", 0, true});
  for (const bool front : {false, true}) {
    for (const Cluster& cluster : Clusters(contest, front)) {
      const CellKey& key = cluster.first->cell->key;
      plot.Add(report::Mark{cluster.first->cost, cluster.first->error,
                            front ? MarkLabel(cluster) : "", Hint(cluster), KindOf(key.method),
                            !front, key.lanes > 1});
    }
  }
  return plot.Svg();
}

std::string SpanPlot(const Results& results, int lanes) {
  constexpr int kWidth = 600, kHeight = 380;
  constexpr size_t kMostNames = 2;
  report::Plot plot(lanes == 1 ? "one lane" : fmt::format("{} lanes", lanes),
                    {"pixels of a span", true}, {"cycles per span", true}, kWidth, kHeight);
  std::vector<std::vector<const SpanCurve*>> groups;
  for (const SpanCurve& curve : results.curves) {
    if (curve.lanes != lanes) continue;
    const auto at = std::find_if(groups.begin(), groups.end(),
                                 [&](const auto& group) { return SameCurve(*group[0], curve); });
    if (at == groups.end()) {
      groups.push_back({&curve});
    } else {
      at->push_back(&curve);
    }
  }
  for (const auto& group : groups) {
    report::Line line;
    for (const SpanCurve::Point& point : group[0]->points)
      line.points.emplace_back(point.length, point.cycles);
    for (size_t i = 0; i < std::min(group.size(), kMostNames); ++i) {
      line.label += (i > 0 ? ", " : "") + std::string(Name(group[i]->method));
    }
    if (group.size() > kMostNames) line.label += fmt::format(" +{}", group.size() - kMostNames);
    line.label_left = true;  // where they differ
    line.colour = KindOf(group[0]->method);
    plot.Add(line);
  }
  return plot.Svg();
}

std::string KindLegend() {
  std::string svg;
  double x = 8;
  for (size_t i = 0; i < kKinds.size(); ++i) {
    svg += fmt::format(
        "<circle class=\"f{}\" cx=\"{:.0f}\" cy=\"10\" r=\"4.5\"/><text x=\"{:.0f}\" "
        "y=\"14\">{}</text>",
        i, x, x + 9, report::EscapeHtml(kKinds[i]));
    x += 24 + report::LabelPlacer::WidthOf(kKinds[i]);
  }
  svg += fmt::format(
      "<circle class=\"dim\" cx=\"{:.0f}\" cy=\"10\" r=\"3\"/><text x=\"{:.0f}\" "
      "y=\"14\">dominated</text>",
      x, x + 9);
  x += 24 + report::LabelPlacer::WidthOf("dominated");
  return fmt::format("<svg width=\"{0:.0f}\" height=\"20\" viewBox=\"0 0 {0:.0f} 20\">{1}</svg>", x,
                     svg);
}

}  // namespace shading::sim
