// SPDX-License-Identifier: Apache-2.0
#include "sim/results/run_tables.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>

namespace shading::sim {
namespace {

using report::Entry;
using report::Table;

Entry Count(const Json& run, const char* key) { return Entry::Count(run.at(key).get<int64_t>()); }

Entry Fixed(double value, int digits) {
  return Entry(value, fmt::format("{:.{}f}", value, digits));
}

Entry Decibels(const Json& psnr) {
  return psnr.is_null() ? Entry("no error") : Fixed(psnr.get<double>(), 1);
}

// Pixels per second of one method by rtl_alone, rtl_checked and model_alone.
struct Speed {
  std::string method;
  double rtl = 0, checked = 0, model = 0;
};

std::vector<Speed> SpeedsOf(const Json& benchmark) {
  std::vector<std::string> order;
  std::map<std::string, std::map<std::string, double>> rates;
  for (const Json& run : benchmark.at("benchmarks")) {
    const std::string name = run.at("run_name");
    const size_t slash = name.find('/');
    const std::string method = name.substr(slash + 1);
    if (slash == std::string::npos || run.contains("aggregate_name")) continue;
    if (rates[method].empty()) order.push_back(method);
    rates[method][name.substr(0, slash)] = run.at("items_per_second");
  }
  std::vector<Speed> speeds;
  for (const std::string& method : order) {
    const auto& rate = rates[method];
    speeds.push_back(
        {method, rate.at("rtl_alone"), rate.at("rtl_checked"), rate.at("model_alone")});
  }
  if (speeds.empty()) throw std::invalid_argument("no benchmark in it");
  return speeds;
}

}  // namespace

Table VerifyTable(const std::vector<std::pair<std::string, Json>>& files) {
  Table table({"command", "methods", "pixels", "spans", "pixel mismatches", "cycle mismatches",
               "pixels, spans not compared", "bad frames"});
  for (const auto& [command, all] : files) {
    std::set<std::string> methods;
    for (const Json& run : all.at("runs")) methods.insert(run.at("method").get<std::string>());
    const auto missing = [&all = all](const char* what) {
      return all.at(fmt::format("{}_expected", what)).get<int64_t>() -
             all.at(fmt::format("{}_compared", what)).get<int64_t>();
    };
    table.Add({fmt::format("`{}`", command), Entry::Count(static_cast<int64_t>(methods.size())),
               Count(all, "pixels_compared"), Count(all, "spans_compared"),
               Count(all, "pixel_mismatches"), Count(all, "cycle_mismatches"),
               fmt::format("{}, {}", missing("pixels"), missing("spans")),
               Count(all, "bad_frames")});
  }
  return table;
}

Table FrameCycleTable(const Json& one, const Json& four) {
  Table table({"method", "cycles, 1 lane", "per pixel", "cycles, 4 lanes", "per pixel"});
  const Json &runs = one.at("runs"), &wide = four.at("runs");
  for (size_t i = 0; i < runs.size(); ++i) {
    const Json &a = runs[i], &b = wide.at(i);
    if (a.at("method") != b.at("method") || a.at("lanes") != 1 || b.at("lanes") != 4) {
      throw std::invalid_argument("not the same methods with 1 and 4 lanes");
    }
    table.Add({a.at("method").get<std::string>(), Count(a, "cycles"),
               Fixed(a.at("cycles_per_pixel"), 3), Count(b, "cycles"),
               Fixed(b.at("cycles_per_pixel"), 3)});
  }
  return table;
}

Table WorkTable(const Json& cycles) {
  Table table({"method", "normalisations", "pixels without one", "samples", "samples saved",
               "samples excluded"});
  for (const Json& run : cycles.at("runs")) {
    const bool samples = run.at("samples_taken") > 0;
    if (!samples && run.at("normalised") == 0) continue;
    const Entry none("");
    table.Add({run.at("method").get<std::string>(), samples ? none : Count(run, "normalised"),
               samples ? none : Count(run, "normalisations_skipped"),
               samples ? Count(run, "samples_taken") : none,
               samples ? Count(run, "samples_saved") : none,
               samples ? Count(run, "samples_excluded") : none});
  }
  return table;
}

Table FrameErrorTable(const Json& render) {
  Table table({"method", "against Phong per pixel: max", "RMS", "PSNR, dB",
               "against its closed form: max", "RMS"});
  for (const Json& run : render.at("runs")) {
    table.Add({run.at("method").get<std::string>(), Fixed(run.at("max_error_lsb"), 2),
               Fixed(run.at("rms_error_lsb"), 2), Decibels(run.at("psnr_db")),
               Fixed(run.at("closed_form_max_error_lsb"), 2),
               Fixed(run.at("closed_form_rms_error_lsb"), 2)});
  }
  return table;
}

Table SpeedTable(const Json& benchmark) {
  Table table({"method", "RTL alone", "RTL + model + scoreboard", "model alone", "checking costs",
               "model / RTL", "model / RTL checked"});
  for (const Speed& s : SpeedsOf(benchmark)) {
    const double cost = 100 * (s.rtl / s.checked - 1);
    table.Add({s.method, s.rtl / 1e6, s.checked / 1e6, s.model / 1e6,
               Entry(cost, fmt::format("{:.0f} %", cost)), Fixed(s.model / s.rtl, 1),
               Fixed(s.model / s.checked, 1)});
  }
  return table;
}

std::string SpeedWords(const Json& benchmark, double factor) {
  std::string above, below;
  for (const Speed& s : SpeedsOf(benchmark)) {
    std::string& names = s.model >= factor * s.rtl ? above : below;
    names += (names.empty() ? "" : ", ") + s.method;
  }
  return fmt::format("The model is {:g} times as fast as the RTL alone or faster: {}. Less: {}.",
                     factor, above.empty() ? "none" : above, below.empty() ? "none" : below);
}

}  // namespace shading::sim
