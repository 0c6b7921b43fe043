// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "sim/bench/bench_json.h"
#include "sim/bench/bench_page.h"
#include "sim/bench/claims.h"
#include "sim/bench/fingerprint.h"
#include "sim/bench/journal.h"
#include "sim/bench/measure.h"
#include "sim/commands/commands.h"
#include "sim/io/atomic_file.h"
#include "sim/machine.h"
#include "sim/parallel.h"
#include "sim/progress.h"
#include "sim/scene/builtin.h"
#include "sim/simulate.h"

namespace shading::sim {
namespace {

namespace fs = std::filesystem;

constexpr int kGalleryWidth = 192, kGalleryHeight = 144, kGalleryShininess = 32;

// What a run measures, and how thoroughly.
struct Plan {
  int repeats = 5;  // of timings in software
  int spans = 64;   // of each length
  std::vector<int> lengths, shininess = {1, 8, 32, 128};
  std::vector<double> tolerances = {0.5, 1, 2, 4};  // LSB, the least first
};

Plan PlanOf(bool quick) {
  Plan plan;
  if (quick) {
    plan.repeats = 2;
    plan.spans = 24;
    plan.tolerances = {0.5, 2};
    plan.lengths = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 20, 24, 32, 40, 48, 64, 96, 128, 192, 256};
  } else {
    for (int length = 1; length <= 256; ++length) plan.lengths.push_back(length);
  }
  return plan;
}

class Bench {
 public:
  explicit Bench(const Options& options)
      : options_(options), plan_(PlanOf(options.quick)), out_(options.out) {}

  int Run() {
    Prepare();
    Journal journal((out_ / "bench-cells.jsonl").string(),
                    fmt::format("{} {}", ProgramFingerprint(), options_.quick ? "quick" : "full"),
                    options_.fresh);
    PrintKept(journal);
    Progress progress("bench", static_cast<int64_t>(keys_.size() + results_.curves.size()),
                      options_.quiet);
    ParallelFor(options_.jobs, static_cast<int>(keys_.size() + results_.curves.size()), [&](int i) {
      const auto at = static_cast<size_t>(i);
      if (at < keys_.size()) {
        RunCell(order_[at], &journal);
      } else {
        RunCurve(at - keys_.size(), &journal);
      }
      progress.Step();
    });
    Write();
    return 0;
  }

 private:
  // Everything that can be refused before the work begins.
  void Prepare() {
    results_.synthesis = ReadSynthesis(options_.synthesis);
    if (options_.synthesis_given && !results_.synthesis) {
      throw std::runtime_error(fmt::format(
          "{0}: no such file; scripts/synth.sh --json {0} writes it", options_.synthesis));
    }
    results_.synthesis_note = fmt::format(
        "Not synthesised: no {}; scripts/synth.sh --json writes it", options_.synthesis);
    for (const std::string& scene : options_.scenes) {
      const Frame frame = LoadFrame(scene, options_);
      frames_.push_back(frame);
      results_.scenes.push_back(frame.scene);
    }
    std::error_code error;
    fs::create_directories(out_, error);
    if (error || !fs::is_directory(out_)) {
      throw std::runtime_error(
          fmt::format("{}: no folder and cannot be made one; choose another --out", options_.out));
    }
    results_.command = options_.command_line;
    results_.machine = DescribeMachine();
    results_.version = SHADESIM_VERSION;
    results_.width = options_.view.width;
    results_.height = options_.view.height;
    results_.methods = options_.methods;
    results_.shininess = plan_.shininess;
    ListWork();
  }

  void ListWork() {
    for (size_t f = 0; f < frames_.size(); ++f) {
      fingerprints_.push_back(Fingerprint(frames_[f].list));
      for (const Method method : options_.methods) {
        const std::vector<double> none = {0};
        for (const int n : plan_.shininess) {
          for (const double tolerance : UsesTolerance(method) ? plan_.tolerances : none) {
            for (const int lanes : {1, kMaxLanes}) {
              if (options_.quick && lanes > 1 && tolerance > plan_.tolerances[0]) continue;
              keys_.push_back({frames_[f].scene, method, n, tolerance, lanes});
              frame_of_.push_back(f);
            }
          }
        }
      }
    }
    results_.cells.resize(keys_.size());
    OrderWork();
    for (const int lanes : {1, kMaxLanes}) {
      for (const Method method : options_.methods) {
        if (method == Method::kAuto) continue;  // its spans are those of the chosen methods
        results_.curves.emplace_back();
        results_.curves.back().method = method;
        results_.curves.back().lanes = lanes;
      }
    }
  }

  // Neighbours in the order of work differ in n, so that threads that run them at the same time do
  // not wait for the same closed form.
  void OrderWork() {
    order_.resize(keys_.size());
    std::iota(order_.begin(), order_.end(), size_t{0});
    const auto place = [this](size_t at) {
      const CellKey& key = keys_[at];
      return std::make_tuple(frame_of_[at], key.method, key.lanes, key.tolerance);
    };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](size_t a, size_t b) { return place(a) < place(b); });
  }

  std::string CellId(size_t at) const {
    return fmt::format("{} packets={}", keys_[at].Text(), fingerprints_[frame_of_[at]]);
  }
  static std::string CurveId(const SpanCurve& curve) {
    return fmt::format("spans {} lanes={}", Name(curve.method), curve.lanes);
  }

  // What an earlier run left of this run's work; it may have done more.
  void PrintKept(const Journal& journal) const {
    size_t cells = 0, curves = 0;
    for (size_t at = 0; at < keys_.size(); ++at) cells += journal.Find(CellId(at)).has_value();
    for (const SpanCurve& curve : results_.curves) {
      curves += journal.Find(CurveId(curve)).has_value();
    }
    if (cells + curves == 0 || options_.quiet) return;
    fmt::print("kept {} of {} measurements and {} of {} curves of {}; --fresh measures anew\n",
               cells, keys_.size(), curves, results_.curves.size(),
               (out_ / "bench-cells.jsonl").string());
  }

  void RunCell(size_t at, Journal* journal) {
    const CellKey& key = keys_[at];
    const size_t f = frame_of_[at];
    const std::string id = CellId(at);
    if (const auto kept = journal->Find(id)) {
      results_.cells[at] = CellFromJson(*kept);
      return;
    }
    const TriangleList list = WithShininess(frames_[f].list, key.shininess);
    FrameBuffer picture(list.frame.width, list.frame.height);
    results_.cells[at] = MeasureCell(list, key, plan_.repeats, &picture, &ideals_);
    journal->Append(id, ToJson(results_.cells[at]));
  }

  void RunCurve(size_t at, Journal* journal) {
    SpanCurve& curve = results_.curves[at];
    const std::string id = CurveId(curve);
    if (const auto kept = journal->Find(id)) {
      curve = CurveFromJson(*kept);
      return;
    }
    curve = MeasureSpans(curve.method, curve.lanes, plan_.lengths, plan_.spans);
    journal->Append(id, ToJson(curve));
  }

  // Small pictures of the last scene by every method.
  Gallery MakeGallery() const {
    Options small = options_;
    small.view.width = kGalleryWidth;
    small.view.height = kGalleryHeight;
    const std::string& scene = options_.scenes.back();
    const TriangleList list = WithShininess(LoadFrame(scene, small).list, kGalleryShininess);
    Gallery gallery;
    gallery.title = fmt::format("{}, {} x {} pixels, n = {}, by the RTL.", scene, list.frame.width,
                                list.frame.height, kGalleryShininess);
    gallery.command = options_.command_line;
    gallery.pictures.resize(options_.methods.size());
    IdealCache ideals;
    ParallelFor(options_.jobs, static_cast<int>(options_.methods.size()), [&](int i) {
      const Method method = options_.methods[static_cast<size_t>(i)];
      const CellKey key = {scene, method, kGalleryShininess,
                           UsesTolerance(method) ? plan_.tolerances[0] : 0, 1};
      FrameBuffer picture(list.frame.width, list.frame.height);
      const Cell cell = MeasureCell(list, key, 1, &picture, &ideals);
      gallery.pictures[static_cast<size_t>(i)] = {Label(key), EncodePng(picture.ToImage()),
                                                  EncodePng(ErrorMap(picture, list)), cell.phong};
    });
    return gallery;
  }

  void Write() const {
    const std::vector<report::Claim> claims = PaperClaims(results_);
    const std::string page = BenchPage(results_, claims, MakeGallery());
    WriteWhole(out_ / "bench.json", ToJson(results_, claims).dump(1) + "\n");
    WriteWhole(out_ / "bench.csv", ToCsv(results_));
    WriteWhole(out_ / "report.html", page);
    if (!options_.markdown.empty()) WriteWhole(options_.markdown, BenchMarkdown(results_, claims));
    if (options_.quiet) return;
    fmt::print("{} measurements, {} curves of cycles by length; {}, bench.json, bench.csv{}{}\n",
               keys_.size(), results_.curves.size(), (out_ / "report.html").string(),
               options_.markdown.empty() ? "" : ", ", options_.markdown);
    if (!results_.synthesis) fmt::print("{}\n", results_.synthesis_note);
  }

  const Options& options_;
  const Plan plan_;
  const fs::path out_;
  std::vector<Frame> frames_;
  std::vector<std::string> fingerprints_;  // of the frames' packets
  std::vector<CellKey> keys_;
  std::vector<size_t> frame_of_;  // of each key
  std::vector<size_t> order_;     // in which keys are measured
  Results results_;
  IdealCache ideals_;
};

}  // namespace

int RunBench(const Options& options) { return Bench(options).Run(); }

}  // namespace shading::sim
