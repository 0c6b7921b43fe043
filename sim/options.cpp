// SPDX-License-Identifier: Apache-2.0
#include "sim/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <thread>

#include "sim/option_checks.h"
#include "sim/option_words.h"
#include "sim/scene/builtin.h"

namespace shading::sim {
namespace {

// Scenes and how they are looked at.
void AddViewOptions(CLI::App* command, Options* o, Words* w) {
  const auto view = [o](CLI::Option* option) {
    option->each([o](const std::string&) { o->view_given = true; });
  };
  command->add_option("SCENE", o->scenes,
                      "mesh file, builtin:NAME[:N] (see shadesim list), or .jsonl of packets");
  view(command->add_option("--size", w->size, "picture WxH, 1..4096 each (640x480)"));
  view(command->add_option("--camera", w->camera, "ortho or persp")
           ->check(CLI::IsMember({"ortho", "persp"})));
  view(command->add_option("--rotate", w->rotate, "YAW,PITCH in degrees"));
  view(command->add_option("--light", w->light, "X,Y,Z towards the light: right, up, to viewer"));
  view(command->add_option("--lighting", w->lighting, "specular cosine: N.H or R.V")
           ->check(CLI::IsMember({"blinn", "phong"})));
  view(command->add_option("--cull", w->cull, "which faces to drop")
           ->check(CLI::IsMember({"back", "none"})));
}

void AddSceneOptions(CLI::App* command, Options* o, Words* w) {
  AddViewOptions(command, o, w);
  command
      ->add_option("--method", w->method, "methods of shadesim list, with commas between, or all")
      ->capture_default_str();
  command->add_option("--lanes", w->lanes, "pixels per cycle: 1 or 4")
      ->check(CLI::IsMember({1, 4}));
  command
      ->add_option(
          "--tolerance", w->tolerance,
          "codes that auto, quad-segment, adaptive, footprint and --subdivide may spend, 0..15.99")
      ->check(CLI::Range(0.0, 15.99))
      ->capture_default_str();
  command
      ->add_option("--subdivide", w->subdivide,
                   "triangles whose normals turn too far for the tolerance: none, report or split")
      ->check(CLI::IsMember({"none", "report", "split"}))
      ->capture_default_str();
  command->add_option("--triangles-out", o->triangles_out, "write the packets, .jsonl");
}

void AddSeed(CLI::App* command, Options* o, const char* of_what) {
  command->add_option("--seed", o->seed, of_what)
      ->capture_default_str()
      ->check(SeedFault, "UINT32");
}

void AddRunOptions(CLI::App* command, Options* o) {
  command
      ->add_option("--backpressure", o->backpressure,
                   "none, quarter, random, bits such as 110100, or a file of bits")
      ->each([o](const std::string&) { o->backpressure_given = true; });
  AddSeed(command, o, "of random patterns and triangles");
  command->add_option("--trace", o->trace, "write a waveform, .fst (one scene, one method)");
  command->add_option("--json", o->json, "write the numbers");
  command->add_option("--jobs", o->jobs, "threads")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  command->add_flag("--quiet", o->quiet, "print errors only");
}

void AddRender(CLI::App* app, Options* o, Words* w) {
  CLI::App* render = app->add_subcommand("render", "simulate and write a picture");
  render->callback([o] { o->command = Command::kRender; });
  render->footer("Example: shadesim render builtin:mixed --method quad -o mixed.png");
  AddSceneOptions(render, o, w);
  render->add_option("-o,--output", o->image, "picture: .png, .exr, .tif ...")->required();
  render->add_option("--engine", w->engine, "who computes the pixels")
      ->check(CLI::IsMember({"model", "rtl", "ideal"}))
      ->capture_default_str();
  render->add_option("--error-map", o->error_map,
                     "picture of the error against Phong per pixel: white is 16 LSB and more");
  render
      ->add_option("--fraction-bits", o->fraction_bits, "of slerp-paper; below 38: --engine model")
      ->check(CLI::Range(8, Quantity::kFraction));
  AddRunOptions(render, o);
}

void AddVerify(CLI::App* app, Options* o, Words* w) {
  CLI::App* verify = app->add_subcommand("verify", "compare the RTL with the model, bit and cycle");
  verify->callback([o] { o->command = Command::kVerify; });
  verify->footer("Example: shadesim verify --random 20000 --method all --backpressure random");
  AddSceneOptions(verify, o, w);
  verify->add_option("--random", o->random, "random triangles instead of a scene")
      ->check(CLI::Range(int64_t{1}, int64_t{1000000000}));
  AddRunOptions(verify, o);
}

void AddCycles(CLI::App* app, Options* o, Words* w) {
  CLI::App* cycles = app->add_subcommand("cycles", "count cycles per span and where they went");
  cycles->callback([o] { o->command = Command::kCycles; });
  cycles->footer("Example: shadesim cycles builtin:torus --method all --csv spans.csv");
  AddSceneOptions(cycles, o, w);
  cycles->add_option("--csv", o->csv, "write a line per span");
  AddRunOptions(cycles, o);
}

void AddBench(CLI::App* app, Options* o, Words* w) {
  CLI::App* bench = app->add_subcommand("bench", "run time against error, all methods: a report");
  bench->callback([o] { o->command = Command::kBench; });
  bench->footer("Example: shadesim bench --quick --out bench\nWithout a SCENE: all built-in ones.");
  AddViewOptions(bench, o, w);
  bench->add_option("--out", o->out, "folder for report.html, bench.json, bench.csv")->required();
  bench
      ->add_option("--methods,--method", w->methods,
                   "methods of shadesim list, with commas between, or all")
      ->capture_default_str();
  bench->add_flag("--quick", o->quick, "small pictures, about a minute on two cores");
  bench->add_flag("--fresh", o->fresh, "forget what an earlier run left in the folder");
  bench->add_option("--synthesis", o->synthesis, "areas, from scripts/synth.sh --json")
      ->capture_default_str()
      ->each([o](const std::string&) { o->synthesis_given = true; });
  bench->add_option("--markdown", o->markdown, "write the tables as Markdown");
  bench->add_option("--jobs", o->jobs, "threads")->capture_default_str()->check(CLI::Range(1, 256));
  bench->add_flag("--quiet", o->quiet, "print errors only");
}

void AddList(CLI::App* app, Options* o) {
  CLI::App* list = app->add_subcommand("list", "methods, units and built-in scenes");
  list->callback([o] { o->command = Command::kList; });
  list->footer("Example: shadesim list --json units.json");
  list->add_option("--json", o->json, "write the tables");
  list->add_flag("--quiet", o->quiet, "print errors only");
}

// Small pictures when quick; all built-in scenes when none is named, then in half as many parts, so
// that their spans have some pixels.
void AddStress(CLI::App* app, Options* o) {
  CLI::App* stress = app->add_subcommand("stress", "worst cases of every unit against its bound");
  stress->callback([o] { o->command = Command::kStress; });
  stress->footer(
      "Example: shadesim stress --quick --out stress\nExit status 1: a bound is broken.");
  stress->add_option("--out", o->out, "folder for report.html, stress.json and the worst cases");
  AddSeed(stress, o, "of the search");
  stress->add_flag("--quick", o->quick, "under a minute on two cores");
  stress->add_flag("--fresh", o->fresh, "forget what a run that was stopped left in the folder");
  stress->add_option("--narrow", o->narrow,
                     "a UNIT or all with one bit less than stated: must break");
  stress->add_option("--replay", o->replay, "a file UNIT.worst.jsonl again");
  stress->add_option("--jobs", o->jobs, "threads")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  stress->add_flag("--quiet", o->quiet, "print broken bounds only");
}

void FinishBench(const Words& w, Options* o) {
  o->methods = MethodList(w.methods);
  if (o->quick && w.size.empty()) {
    o->view.width = 240;
    o->view.height = 180;
  }
  if (!o->scenes.empty()) return;
  for (const BuiltinScene& scene : kBuiltinScenes) {
    const int n = o->quick ? std::max(scene.min_n, scene.default_n / 2) : scene.default_n;
    o->scenes.push_back(fmt::format("builtin:{}:{}", scene.name, n));
  }
}

void Finish(const Words& w, Options* o) {
  o->methods = MethodList(w.method);
  o->lanes = w.lanes;
  if (std::isnan(w.tolerance)) Refuse("--tolerance nan: give codes, 0..15.99");
  o->front_end.tolerance = Tolerance::Round(w.tolerance);
  o->front_end.subdivide = w.subdivide == "split"    ? Subdivide::kSplit
                           : w.subdivide == "report" ? Subdivide::kReport
                                                     : Subdivide::kNever;
  o->view.perspective = w.camera == "persp";
  o->view.lighting = w.lighting == "phong" ? Lighting::kPhong : Lighting::kBlinn;
  o->view.cull = w.cull == "none" ? Cull::kNone : Cull::kBack;
  o->engine = w.engine == "model"   ? Engine::kModel
              : w.engine == "ideal" ? Engine::kIdeal
                                    : Engine::kRtl;
  if (!w.size.empty()) {
    const auto size = Numbers("--size", w.size, 'x', 2);
    for (const double side : size) {
      if (side != std::floor(side) || side < 1 || side > kMaxScreen) {
        Refuse(fmt::format("--size takes WxH from 1x1 to {0}x{0}, not '{1}'", kMaxScreen, w.size));
      }
    }
    o->view.width = static_cast<int>(size[0]);
    o->view.height = static_cast<int>(size[1]);
  }
  if (!w.rotate.empty()) {
    const auto angle = Numbers("--rotate", w.rotate, ',', 2);
    o->view.yaw = angle[0];
    o->view.pitch = angle[1];
  }
  if (!w.light.empty()) {
    const auto light = Numbers("--light", w.light, ',', 3);
    o->view.light = {light[0], light[1], light[2]};
  }
  if (o->command == Command::kBench) FinishBench(w, o);
}

}  // namespace

std::optional<Options> ParseOptions(int argc, char** argv) {
  Options o;
  Words w;
  o.command_line = "shadesim";
  for (int i = 1; i < argc; ++i) o.command_line += fmt::format(" {}", argv[i]);
  o.jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 256u));
  CLI::App app("Cycle-accurate hardware model of a Phong shading unit", "shadesim");
  app.require_subcommand(1);
  app.set_version_flag("--version", SHADESIM_VERSION);

  AddRender(&app, &o, &w);
  AddVerify(&app, &o, &w);
  AddCycles(&app, &o, &w);
  AddBench(&app, &o, &w);
  AddStress(&app, &o);
  AddList(&app, &o);

  CheckCommand(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    app.exit(asked);
    return std::nullopt;
  }
  Finish(w, &o);
  CheckOptions(o);
  return o;
}

}  // namespace shading::sim
