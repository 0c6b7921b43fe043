// SPDX-License-Identifier: Apache-2.0
//
// What shadesim bench keeps, reads and says, from made-up numbers.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/bench/bench_json.h"
#include "sim/bench/bench_page.h"
#include "sim/bench/claims.h"
#include "sim/bench/face.h"
#include "sim/bench/journal.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

using JournalTest = FileTest;

TEST_F(JournalTest, GoesOnWhereItWasStopped) {
  const std::string path = Path("cells.jsonl");
  {
    Journal journal(path, "a", false);
    journal.Append("one", {{"n", 1}});
    journal.Append("two", {{"n", 2}});
  }
  // Cut in the middle of the last line.
  const std::string whole = Read("cells.jsonl");
  Write("cells.jsonl", whole.substr(0, whole.size() - 5));
  {
    Journal journal(path, "a", false);
    EXPECT_EQ(journal.kept(), 1u);
    ASSERT_TRUE(journal.Find("one"));
    EXPECT_EQ((*journal.Find("one"))["n"], 1);
    EXPECT_FALSE(journal.Find("two"));
    journal.Append("two", {{"n", 3}});
  }
  Journal journal(path, "a", false);
  EXPECT_EQ(journal.kept(), 2u);
  EXPECT_EQ((*journal.Find("two"))["n"], 3);
}

TEST_F(JournalTest, KeepsNothingOfAnotherProgramOrWhenFresh) {
  const std::string path = Path("cells.jsonl");
  const auto fill = [&] { Journal(path, "a", true).Append("one", {{"n", 1}}); };
  fill();
  EXPECT_EQ(Journal(path, "b", false).kept(), 0u);
  fill();
  EXPECT_EQ(Journal(path, "a", true).kept(), 0u);
  Write("cells.jsonl", "no journal\n{\"id\":\"one\",\"value\":1}\n");
  EXPECT_EQ(Journal(path, "a", false).kept(), 0u);
  Write("cells.jsonl", "{\"fingerprint\":7}\n{\"id\":\"one\",\"value\":1}\n");
  EXPECT_EQ(Journal(path, "7", false).kept(), 0u);
}

TEST_F(JournalTest, RefusesAFolderThatIsNot) {
  ExpectError([&] { Journal(Path("no/cells.jsonl"), "a", false); }, "cells.jsonl");
}

using SynthesisTest = FileTest;

TEST_F(SynthesisTest, ReadsWhatTheScriptWrites) {
  EXPECT_FALSE(ReadSynthesis(Path("none.json")));
  const std::string path = Write("synth.json", R"({"format": "shadesim-synthesis", "version": 1,
    "tool": "Yosys", "target": "ecp5", "rtl": "00", "multiplier_lut4": 1000,
    "units": [{"name": "dot_product", "lut4": 1, "flip_flops": 2, "carry": 3,
      "multipliers": 4, "path_lut4": 16}],
    "builds": [{"method": "quad", "lanes": 4, "lut4": 10, "flip_flops": 20, "carry": 30,
      "multipliers": 2},
               {"method": "of-tomorrow", "lanes": 1, "lut4": 1, "flip_flops": 1, "carry": 1,
      "multipliers": 1}]})");
  const auto synthesis = ReadSynthesis(path);
  ASSERT_TRUE(synthesis);
  ASSERT_NE(synthesis->FindUnit("dot_product"), nullptr);
  EXPECT_EQ(synthesis->FindUnit("dot_product")->cells.path, 16);
  EXPECT_EQ(synthesis->builds.size(), 1u);
  EXPECT_EQ(*synthesis->Area(Method::kQuad, 4), 10 + 20 + 2 * 30 + 2 * 1000);
  EXPECT_FALSE(synthesis->Area(Method::kQuad, 1));
}

TEST_F(SynthesisTest, RefusesOtherFiles) {
  for (const char* text : {"", "{", "[]", R"({"format": "shadesim-synthesis", "version": 2})",
                           R"({"format": "shadesim-synthesis", "version": 1, "tool": "Yosys"})"}) {
    const std::string path = Write("synth.json", text);
    ExpectError([&] { ReadSynthesis(path); }, "scripts/synth.sh --json");
  }
}

// Two methods in one scene, made up.
Results MadeUp() {
  Results results;
  results.scenes = {"scene <1>"};
  results.shininess = {8};
  for (const Method method : {Method::kPhong, Method::kSlerpPaper}) {
    results.methods.push_back(method);
    Cell cell;
    cell.key = {"scene <1>", method, 8, 0, 1};
    cell.work = {1, 10, 100, 50, 0};
    cell.packets = 1;
    cell.cycles = 120;
    cell.model_seconds = method == Method::kPhong ? 3e-6 : 1e-6;
    cell.front_end_seconds = 1e-6;
    cell.phong = {0.5, 0.3, 58};
    cell.closed_form = {0.5, 0.3, INFINITY};
    results.cells.push_back(cell);
  }
  results.synthesis_note = "Not synthesised";
  return results;
}

TEST(Results, SurviveJson) {
  const Results results = MadeUp();
  const Cell& cell = results.cells[0];
  EXPECT_EQ(ToJson(CellFromJson(Json::parse(ToJson(cell).dump()))), ToJson(cell));
  const SpanCurve curve = {Method::kQuad, 4, 7, {{1, 2}, {16, 4}}};
  EXPECT_EQ(ToJson(CurveFromJson(ToJson(curve))), ToJson(curve));
  EXPECT_THROW(CellFromJson(Json::object()), std::exception);
}

TEST(Results, RatiosAreGeometricMeans) {
  const auto ratio = MeanRatio(MadeUp(), Method::kPhong, Method::kSlerpPaper,
                               [](const Cell& c) { return c.model_seconds; });
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(*ratio, 3, 1e-9);
  EXPECT_FALSE(MeanRatio(MadeUp(), Method::kPhong, Method::kQuad,
                         [](const Cell& c) { return c.model_seconds; }));
}

TEST(Results, EqualErrorsLeaveTheCheaperOnTheFront) {
  Results results = MadeUp();
  results.cells[0].phong.rms_lsb = 0.301;  // rounds to the other's
  const auto software = std::find_if(kFaces.begin(), kFaces.end(),
                                     [](const Face& f) { return f.kind == Face::Kind::kSoftware; });
  const Contest contest = Compare(results, *software, "scene <1>", 8, ErrorKind::kRms);
  ASSERT_EQ(contest.entrants.size(), 2u);
  EXPECT_FALSE(contest.entrants[0].front);
  EXPECT_TRUE(contest.entrants[1].front);
}

// The claim is 2 times; made-up times are 3 and 1.
TEST(Claims, AreTakenFromTheRun) {
  const auto verdict = [](const Results& results) {
    for (const report::Claim& claim : PaperClaims(results)) {
      if (claim.claim.find("2 times faster") != std::string::npos) return claim.verdict;
    }
    return report::Verdict::kOnPage;
  };
  Results results = MadeUp();
  EXPECT_EQ(verdict(results), report::Verdict::kHolds);
  results.cells[0].model_seconds = 1.5e-6;
  EXPECT_EQ(verdict(results), report::Verdict::kFails);
  results.cells.pop_back();
  EXPECT_EQ(verdict(results), report::Verdict::kNotMeasured);
}

TEST(Report, EscapesNamesAndSaysWhatIsMissing) {
  const Results results = MadeUp();
  const std::string page = BenchPage(results, PaperClaims(results), {});
  EXPECT_EQ(page.find("scene <1>"), std::string::npos);
  EXPECT_NE(page.find("scene &lt;1&gt;"), std::string::npos);
  EXPECT_NE(page.find("Not synthesised"), std::string::npos);
  const std::string text = BenchMarkdown(results, PaperClaims(results));
  EXPECT_NE(text.find("## What the papers claim"), std::string::npos);
}

}  // namespace
}  // namespace shading::sim
