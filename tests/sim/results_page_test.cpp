// SPDX-License-Identifier: Apache-2.0
//
// docs/results.md from made-up files: what it shows, and that it refuses what is missing or broken.
#include "sim/bench/bench_json.h"
#include "sim/results/page_sections.h"
#include "sim/results/run_tables.h"
#include "sim/results/stress_tables.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

TEST(Template, IsFilledLineByLine) {
  EXPECT_EQ(FillTemplate("# A\n{{b}}\ntext {{c}}\n", {{"b", "| x |"}}), "# A\n| x |\ntext {{c}}\n");
  ExpectError([] { FillTemplate("{{other}}\n", {{"b", "x"}}); }, "{{other}}");
  ExpectError([] { FillTemplate("# A\n", {{"b", "x"}}); }, "{{b}}");
}

Json RunJson(const std::string& method, int lanes, int64_t cycles) {
  return {{"method", method},
          {"lanes", lanes},
          {"spans", 10},
          {"pixels", 100},
          {"cycles", cycles},
          {"cycles_per_pixel", static_cast<double>(cycles) / 100},
          {"normalised", method == "adaptive" ? 7 : 0},
          {"normalisations_skipped", 93},
          {"samples_taken", 0},
          {"samples_saved", 0},
          {"samples_excluded", 0},
          {"max_error_lsb", 1.25},
          {"rms_error_lsb", 0.3},
          {"psnr_db", nullptr},
          {"closed_form_max_error_lsb", 0.5},
          {"closed_form_rms_error_lsb", 0.29}};
}

Json Runs(int lanes) {
  Json json = {{"shadesim", "9.9"},      {"machine", "a loom"},   {"pixels_compared", 200},
               {"pixels_expected", 203}, {"pixel_mismatches", 3}, {"spans_compared", 20},
               {"spans_expected", 20},   {"cycle_mismatches", 0}, {"bad_frames", 0}};
  json["runs"] = {RunJson("adaptive", lanes, 140), RunJson("quad", lanes, 101)};
  return json;
}

Json Speeds() {
  Json list = Json::array();
  for (const auto& [name, rate] :
       std::vector<std::pair<std::string, double>>{{"rtl_alone/quad", 1e6},
                                                   {"rtl_checked/quad", 0.8e6},
                                                   {"model_alone/quad", 21e6},
                                                   {"rtl_alone/slerp", 1e6},
                                                   {"rtl_checked/slerp", 1e6},
                                                   {"model_alone/slerp", 19e6}}) {
    list.push_back({{"run_name", name}, {"items_per_second", rate}});
  }
  return {{"benchmarks", list}};
}

Json Stress(double share, bool broken) {
  return {{"shadesim", "9.9"},
          {"machine", "a loom"},
          {"units",
           {{{"unit", "quad_surface"},
             {"worst", share / 32},
             {"bound", 1. / 32},
             {"ulp", "codes"},
             {"worst_over_bound", share},
             {"broken", broken},
             {"evaluations", 1000}}}},
          {"conditions", Json::array()},
          {"word_lengths",
           {{{"form", "(5)"}, {"fraction_bits", 10}, {"nearest", 2.5}, {"truncated", 5}}}},
          {"not_searched", {{{"unit", "span_setup"}, {"reason", "exact"}}}}};
}

Json BenchJson() {
  Results results;
  results.version = "9.9";
  results.machine = "a loom";
  results.methods = {Method::kQuad};
  Cell cell;
  cell.key = {"torus", Method::kQuad, 8, 0, 1};
  cell.work = {1, 10, 100, 50, 0};
  cell.cycles = 101;
  results.cells = {cell};
  results.curves = {{Method::kQuad, 1, 5, {{16, 16}}}, {Method::kQuad, 4, 5, {{16, 4}}}};
  results.scenes = {"torus"};
  results.shininess = {8};
  return ToJson(results, {});
}

// A folder as scripts/results.sh leaves it.
class ResultsTest : public FileTest {
 protected:
  ResultsTest() {
    for (const char* part : {"bench", "stress", "narrow"}) {
      std::filesystem::create_directories(Path(part));
    }
    Json steps = Json::array();
    const auto put = [&](const std::string& file, const std::string& command, const Json& json) {
      Write(file, json.dump());
      steps.push_back({{"file", file}, {"command", command}, {"seconds", 2}});
    };
    put("verify-scenes-1.json", "shadesim verify torus --json a.json --jobs 2", Runs(1));
    put("cycles-1.json", "shadesim cycles torus --lanes 1", Runs(1));
    put("cycles-4.json", "shadesim cycles torus --lanes 4", Runs(4));
    put("errors.json", "shadesim render torus", Runs(1));
    put("bench/bench.json", "shadesim bench torus", BenchJson());
    put("stress/stress.json", "shadesim stress", Stress(0.998, false));
    put("narrow/stress.json", "shadesim stress --narrow all", Stress(1.996, true));
    put("speed.json", "shading_unit_bench", Speeds());
    run_ = {{"format", "shadesim-results"},
            {"version", 1},
            {"revision", "abc123"},
            {"quick", false},
            {"synthesis", ""},
            {"synthesis_note", "not made"},
            {"steps", steps}};
    WriteRun();
  }
  void WriteRun() const { Write("run.json", run_.dump()); }
  Sections Make() const {
    RunFolder folder(Path("."));
    return MakeSections(&folder);
  }
  void ExpectRefused(const std::string& file) const {
    ExpectError([this] { Make(); }, file);
    ExpectError([this] { Make(); }, "scripts/results.sh");
  }

  Json run_;
};

TEST_F(ResultsTest, ShowsWhatWasMeasured) {
  const Sections page = Make();
  EXPECT_NE(page.at("head").find("shadesim 9.9, revision abc123, on a loom."), std::string::npos);
  EXPECT_EQ(page.at("head").find("quick"), std::string::npos);
  EXPECT_NE(page.at("steps").find("| `shadesim bench torus` | 2 |"), std::string::npos);
  EXPECT_NE(page.at("verify").find("| `shadesim verify torus` | 2 | 200 | 20 | 3 | 0 | 3, 0 | 0 |"),
            std::string::npos)
      << page.at("verify");
  EXPECT_NE(page.at("cycles").find("| quad | 101 | 1.010 | 101 | 1.010 |"), std::string::npos);
  EXPECT_NE(page.at("work").find("| adaptive | 7 | 93 |"), std::string::npos);
  EXPECT_EQ(page.at("work").find("quad"), std::string::npos) << "it counts nothing";
  EXPECT_NE(page.at("errors").find("| quad | 1.25 | 0.30 | no error | 0.50 | 0.29 |"),
            std::string::npos);
  EXPECT_NE(page.at("fronts").find("quad in"), page.at("fronts").find("| quad |"));
  EXPECT_NE(page.at("spans").find("| quad | 5 |"), std::string::npos);
  EXPECT_NE(page.at("stress-bounds")
                .find("0 of 1 bounds and 0 of 0 conditions are broken; with a "
                      "bit less 1 of 1 bounds."),
            std::string::npos);
  EXPECT_NE(page.at("stress-bounds").find("| codes | 0.998 | 1.996 | 1000 |"), std::string::npos);
  EXPECT_NE(page.at("stress-words").find("| 10 | 2.5 / 5 |"), std::string::npos);
  EXPECT_NE(page.at("speed").find("or faster: quad. Less: slerp."), std::string::npos);
  EXPECT_NE(page.at("speed").find("| quad | 1 | 0.8 | 21 | 25 % | 21.0 | 26.2 |"),
            std::string::npos)
      << page.at("speed");
  EXPECT_EQ(page.at("synthesis-units"), "not made\n");
}

TEST_F(ResultsTest, SaysThatItWasQuick) {
  run_["quick"] = true;
  WriteRun();
  EXPECT_NE(Make().at("head").find("**A quick run**"), std::string::npos);
}

TEST_F(ResultsTest, ShowsSynthesisAndWhatItLacks) {
  run_["synthesis"] = Write("synth.json", R"({"format": "shadesim-synthesis", "version": 1,
    "tool": "Yosys", "target": "ecp5", "multiplier_lut4": 1000, "units": [],
    "builds": [{"method": "quad", "lanes": 1, "lut4": 10, "flip_flops": 20, "carry": 30,
      "multipliers": 2}]})");
  WriteRun();
  const std::string builds = Make().at("synthesis-builds");
  EXPECT_NE(builds.find("| quad | 1 | 10 | 20 | 30 | 2 | 2090 |"), std::string::npos) << builds;
  EXPECT_NE(builds.find("Not synthesised: quad, 4 lanes."), std::string::npos) << builds;
}

TEST_F(ResultsTest, RefusesEveryFileThatIsMissingCutOffOrEmpty) {
  std::vector<std::string> files = {"run.json"};
  for (const Json& step : run_["steps"]) files.push_back(step["file"]);
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const std::string whole = Read(file);
    Write(file, whole.substr(0, whole.size() / 2));
    ExpectRefused(file + ": not JSON at byte");
    for (const char* other : {"[]", "{}"}) {
      Write(file, other);
      ExpectRefused(file + ": not what");
    }
    std::filesystem::remove(Path(file));
    ExpectRefused(file + ": no such file");
    Write(file, whole);
  }
  EXPECT_NO_THROW(Make());
}

TEST_F(ResultsTest, RefusesFilesOfTwoMachinesOrVersions) {
  for (const char* key : {"machine", "shadesim"}) {
    Json other = Runs(1);
    other[key] = "another";
    Write("errors.json", other.dump());
    ExpectRefused("errors.json: not what scripts/results.sh wrote (another machine or version");
  }
}

}  // namespace
}  // namespace shading::sim
