// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <string>

#include "sim/report/claim.h"
#include "sim/report/html.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"
#include "sim/report/table.h"

namespace shading::report {
namespace {

int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

TEST(Html, EscapesEveryCharacterThatMeansSomething) {
  EXPECT_EQ(EscapeHtml("a<b>&\"c\" 'd' &amp;"),
            "a&lt;b&gt;&amp;&quot;c&quot; &#39;d&#39; &amp;amp;");
  EXPECT_EQ(EscapeHtml("h\xc3\xa9 I(x+1)"), "h\xc3\xa9 I(x+1)");
}

// The test vectors of RFC 4648.
TEST(Html, Base64OfTheStandard) {
  const std::pair<const char*, const char*> kVectors[] = {{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foob", "Zm9vYg=="},
                                                          {"fooba", "Zm9vYmE="},
                                                          {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : kVectors) EXPECT_EQ(Base64(bytes), text);
  EXPECT_EQ(Base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(Html, ThreeSignificantDigits) {
  EXPECT_EQ(Significant(0.001234), "0.00123");
  EXPECT_EQ(Significant(0.5), "0.5");
  EXPECT_EQ(Significant(12.34), "12.3");
  EXPECT_EQ(Significant(1234.4), "1234");
  EXPECT_EQ(Significant(0), "0");
  EXPECT_EQ(Significant(-2), "-2");
  EXPECT_EQ(Significant(INFINITY), "inf");
}

TEST(Table, NumbersCarryWhatTheyAreSortedBy) {
  Table table({"name <1>", "error, LSB"});
  table.Add({"a|b", 0.12345});
  table.Add({"<script>", Entry::Count(1234567)});
  table.Add({"none", Entry(INFINITY)});
  const std::string html = table.Html();
  EXPECT_NE(html.find("data-v=\"0.12345\">0.123<"), std::string::npos) << html;
  EXPECT_NE(html.find("data-v=\"1234567\">1234567<"), std::string::npos) << html;
  EXPECT_NE(html.find("data-v=\"1e+300\">inf<"), std::string::npos) << html;
  EXPECT_EQ(html.find("<script>"), std::string::npos);
  EXPECT_NE(html.find("name &lt;1&gt;"), std::string::npos);
  EXPECT_EQ(table.Markdown(),
            "| name <1> | error, LSB |\n|---|--:|\n| a\\|b | 0.123 |\n| <script> | 1234567 |\n"
            "| none | inf |\n");
}

TEST(Page, NeedsNothingBesideItAndEscapesItsText) {
  Page page("a < b", {"made by 'x' & y"});
  page.Section("first & last");
  page.Text("1 < 2");
  page.Command("shadesim <SCENE>");
  page.Figure({"<svg></svg>"}, "n > 1", "run & see");
  const std::string html = page.Html();
  for (const char* text :
       {"<title>a &lt; b</title>", "made by &#39;x&#39; &amp; y", "first &amp; last",
        "<p>1 &lt; 2</p>", "shadesim &lt;SCENE&gt;", "n &gt; 1", "run &amp; see", "<svg></svg>",
        "prefers-color-scheme: dark", "@media print"}) {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  for (const char* outside : {"http:", "https:", "src=\"/", "<link", "@import", "url("}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
  for (const char* tag : {"main", "figure", "nav", "style", "script", "body", "html"}) {
    EXPECT_EQ(Count(html, std::string("<") + tag + ">") + Count(html, std::string("<") + tag + " "),
              Count(html, std::string("</") + tag + ">"))
        << tag;
  }
}

// Places of all marks, by their hints.
std::map<std::string, std::pair<double, double>> Places(const std::string& svg) {
  std::map<std::string, std::pair<double, double>> places;
  const std::regex mark("<circle cx=\"([0-9.]+)\" cy=\"([0-9.]+)\" [^>]*><title>([^<]*)<");
  for (std::sregex_iterator at(svg.begin(), svg.end(), mark), end; at != end; ++at) {
    places[(*at)[3]] = {std::stod((*at)[1]), std::stod((*at)[2])};
  }
  return places;
}

TEST(Plot, LogarithmicAxesKeepRatiosAndLeaveOutWhatTheyCannotShow) {
  Plot plot("title <>", {"x", true}, {"y", true}, 400, 300);
  for (const double x : {1.0, 10.0, 100.0}) {
    plot.Add(Mark{x, 1000 / x, "", "at " + Significant(x), 1, false, false});
  }
  plot.Add(Mark{0, 1, "", "zero", 1, false, false});
  const std::string svg = plot.Svg();
  auto places = Places(svg);
  ASSERT_EQ(places.size(), 3u) << svg;
  EXPECT_NEAR(places["at 10"].first - places["at 1"].first,
              places["at 100"].first - places["at 10"].first, 0.2);
  EXPECT_NEAR(places["at 10"].second - places["at 1"].second,
              places["at 100"].second - places["at 10"].second, 0.2);
  EXPECT_GT(places["at 10"].second, places["at 1"].second) << "small values are below";
  EXPECT_NE(svg.find("title &lt;&gt;"), std::string::npos);
}

TEST(Plot, EmptyOneIsDrawn) {
  EXPECT_NE(Plot("none", {"x", true}, {"y", false}, 300, 200).Svg().find("</svg>"),
            std::string::npos);
}

TEST(Plot, LabelsKeepOffEachOtherAndInside) {
  const Box frame = {0, 0, 300, 200};
  LabelPlacer placer(frame);
  std::vector<Box> boxes;
  for (int i = 0; i < 8; ++i) {
    const std::string label = "method " + std::to_string(i);
    const LabelPlacer::Place place = placer.Find(150 + i, 100, label);
    ASSERT_TRUE(place.found);
    const Box box = {place.x, place.y + 3 - LabelPlacer::kHeight,
                     place.x + LabelPlacer::WidthOf(label), place.y + 3};
    EXPECT_GE(box.left, frame.left);
    EXPECT_LE(box.right, frame.right);
    for (const Box& other : boxes) EXPECT_FALSE(box.Overlaps(other)) << i;
    boxes.push_back(box);
  }
}

TEST(Claims, EachHasItsVerdict) {
  const std::string html =
      ClaimTable({{"000", "fast", "2 times", Verdict::kHolds, "docs/results.md"},
                  {"003", "cheap", "no", Verdict::kFails, ""}})
          .Html();
  EXPECT_NE(html.find("<b>holds</b>"), std::string::npos);
  EXPECT_NE(html.find("<b>does not hold</b>"), std::string::npos);
}

}  // namespace
}  // namespace shading::report
