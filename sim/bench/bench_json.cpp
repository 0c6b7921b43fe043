// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/bench_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sim/bench/face.h"

namespace shading::sim {
namespace {

// JSON has no infinity: null where the pictures agree.
Json Finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json ErrorJson(const PictureError& error) {
  return {
      {"max_lsb", error.max_lsb}, {"rms_lsb", error.rms_lsb}, {"psnr_db", Finite(error.psnr_db)}};
}

PictureError ErrorFrom(const Json& json) {
  PictureError error;
  error.max_lsb = json.at("max_lsb");
  error.rms_lsb = json.at("rms_lsb");
  const Json& psnr = json.at("psnr_db");
  error.psnr_db = psnr.is_null() ? std::numeric_limits<double>::infinity() : psnr.get<double>();
  return error;
}

Json OperationsJson(const Operations& o) {
  return {{"multiplications", o.multiplications},
          {"additions", o.additions},
          {"shifts", o.shifts},
          {"look_ups", o.look_ups},
          {"paper_cycles", PaperCycles(o)}};
}

Json CostJson(Method method) {
  const MethodCost cost = CostOf(method);
  return {{"method", Name(method)},
          {"triangle", OperationsJson(cost.triangle)},
          {"span", OperationsJson(cost.span)},
          {"pixel", OperationsJson(cost.pixel)},
          {"highlight", OperationsJson(cost.highlight)},
          {"normalisation", OperationsJson(cost.normalisation)},
          {"reason", cost.reason}};
}

Json SynthesisJson(const Synthesis& synthesis) {
  Json json = {{"tool", synthesis.tool},
               {"target", synthesis.target},
               {"multiplier_lut4", synthesis.multiplier_lut4}};
  for (const Synthesis::Build& build : synthesis.builds) {
    json["area"].push_back({{"method", Name(build.method)},
                            {"lanes", build.lanes},
                            {"cells", synthesis.Area(build.cells)}});
  }
  return json;
}

Json FrontJson(const Results& results) {
  Json json = Json::array();
  for (const Face& face : kFaces) {
    for (const std::string& scene : results.scenes) {
      for (const int n : results.shininess) {
        Json names = Json::array();
        for (const auto& e : Compare(results, face, scene, n, ErrorKind::kRms).entrants) {
          if (e.front) {
            names.push_back({{"method", Name(e.cell->key.method)},
                             {"tolerance", e.cell->key.tolerance},
                             {"lanes", e.cell->key.lanes},
                             {"cost", e.cost},
                             {"rms_lsb", e.error}});
          }
        }
        json.push_back({{"face", face.name}, {"scene", scene}, {"shininess", n}, {"front", names}});
      }
    }
  }
  return json;
}

}  // namespace

Json ToJson(const Cell& cell) {
  Json json = {{"scene", cell.key.scene},
          {"method", Name(cell.key.method)},
          {"shininess", cell.key.shininess},
          {"tolerance", cell.key.tolerance},
          {"lanes", cell.key.lanes},
          {"packets", cell.packets},
          {"triangles", cell.work.triangles},
          {"spans", cell.work.spans},
          {"pixels", cell.work.pixels},
          {"highlights", cell.work.highlights},
          {"normalisations", cell.work.normalisations},
          {"samples", cell.work.samples},
          {"cycles", cell.cycles},
          {"busy_cycles", cell.busy},
          {"fill_cycles", cell.fill},
          {"setup_cycles", cell.setup},
          {"stall_cycles", cell.stall},
          {"cycles_per_pixel", cell.CyclesPerPixel()},
          {"paper_cycles_per_pixel", cell.PaperCyclesPerPixel()},
          {"rtl_seconds", cell.rtl_seconds},
          {"model_seconds", cell.model_seconds},
          {"front_end_seconds", cell.front_end_seconds},
          {"against_phong", ErrorJson(cell.phong)},
          {"against_closed_form", ErrorJson(cell.closed_form)}};
  if (cell.sure != 0) json["sure"] = cell.sure;
  for (const Method method : kAllMethods) {
    const MethodShare& share = cell.work.share[static_cast<size_t>(method)];
    if (share.triangles == 0) continue;
    json["chosen"][std::string(Name(method))] = {share.triangles, share.spans, share.pixels};
  }
  return json;
}

Cell CellFromJson(const Json& json) {
  Cell cell;
  cell.key = {json.at("scene"), MethodOf(json.at("method")), json.at("shininess"),
              json.at("tolerance"), json.at("lanes")};
  cell.packets = json.at("packets");
  cell.work = {json.at("triangles"),  json.at("spans"),          json.at("pixels"),
               json.at("highlights"), json.at("normalisations"), json.at("samples"), {}};
  if (json.contains("chosen")) {
    for (const auto& [name, share] : json.at("chosen").items()) {
      cell.work.share[static_cast<size_t>(MethodOf(name))] = {share.at(0), share.at(1),
                                                              share.at(2)};
    }
  }
  cell.cycles = json.at("cycles");
  cell.busy = json.at("busy_cycles");
  cell.fill = json.at("fill_cycles");
  cell.setup = json.at("setup_cycles");
  cell.stall = json.at("stall_cycles");
  cell.rtl_seconds = json.at("rtl_seconds");
  cell.model_seconds = json.at("model_seconds");
  cell.front_end_seconds = json.at("front_end_seconds");
  cell.sure = json.value("sure", 0U);
  cell.phong = ErrorFrom(json.at("against_phong"));
  cell.closed_form = ErrorFrom(json.at("against_closed_form"));
  return cell;
}

Json ToJson(const SpanCurve& curve) {
  Json json = {{"method", Name(curve.method)}, {"lanes", curve.lanes}, {"latency", curve.latency}};
  for (const SpanCurve::Point& point : curve.points) {
    json["length"].push_back(point.length);
    json["cycles"].push_back(point.cycles);
  }
  return json;
}

SpanCurve CurveFromJson(const Json& json) {
  SpanCurve curve;
  curve.method = MethodOf(json.at("method"));
  curve.lanes = json.at("lanes");
  curve.latency = json.at("latency");
  const std::vector<int> lengths = json.at("length");
  const std::vector<double> cycles = json.at("cycles");
  for (size_t i = 0; i < lengths.size(); ++i) curve.points.push_back({lengths[i], cycles.at(i)});
  return curve;
}

Results ResultsFromJson(const Json& json) {
  if (json.at("format") != "shadesim-bench" || json.at("version") != 1) {
    throw std::invalid_argument("format is not shadesim-bench, version 1");
  }
  Results results;
  results.command = json.at("command");
  results.version = json.at("shadesim");
  results.machine = json.at("machine");
  results.width = json.at("width");
  results.height = json.at("height");
  for (const Json& method : json.at("operations")) {
    results.methods.push_back(MethodOf(method.at("method")));
  }
  const auto add = [](const auto& value, auto* list) {
    if (std::find(list->begin(), list->end(), value) == list->end()) list->push_back(value);
  };
  for (const Json& cell : json.at("cells")) {
    results.cells.push_back(CellFromJson(cell));
    add(results.cells.back().key.scene, &results.scenes);
    add(results.cells.back().key.shininess, &results.shininess);
  }
  for (const Json& curve : json.at("span_cycles")) results.curves.push_back(CurveFromJson(curve));
  if (results.cells.empty()) throw std::invalid_argument("no measurement in it");
  return results;
}

Json ToJson(const Results& results, const std::vector<report::Claim>& claims) {
  Json json = {{"format", "shadesim-bench"}, {"version", 1},
               {"command", results.command}, {"shadesim", results.version},
               {"machine", results.machine}, {"width", results.width},
               {"height", results.height}};
  for (const Method method : results.methods) json["operations"].push_back(CostJson(method));
  json["synthesis"] = results.synthesis ? SynthesisJson(*results.synthesis) : Json();
  json["fronts"] = FrontJson(results);
  for (const report::Claim& claim : claims) {
    json["claims"].push_back({{"paper", claim.source},
                              {"claim", claim.claim},
                              {"measured", claim.measured},
                              {"verdict", report::Name(claim.verdict)},
                              {"page", claim.page}});
  }
  for (const SpanCurve& curve : results.curves) json["span_cycles"].push_back(ToJson(curve));
  for (const Cell& cell : results.cells) json["cells"].push_back(ToJson(cell));
  return json;
}

std::string ToCsv(const Results& results) {
  std::string csv =
      "scene,method,shininess,tolerance,lanes,triangles,spans,pixels,cycles,busy,fill,setup,stall,"
      "cycles_per_pixel,operations_per_pixel,paper_cycles_per_pixel,rtl_ns_per_pixel,"
      "model_ns_per_pixel,front_end_ns_per_pixel,max_lsb,rms_lsb,psnr_db,closed_form_max_lsb,"
      "closed_form_rms_lsb,closed_form_psnr_db\n";
  for (const Cell& c : results.cells) {
    // Quoted, for a mesh's path may hold a comma.
    std::string scene = c.key.scene;
    for (size_t at = 0; (at = scene.find('"', at)) != std::string::npos; at += 2)
      scene.insert(at, 1, '"');
    csv += fmt::format("\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},", scene,
                       Name(c.key.method), c.key.shininess, c.key.tolerance, c.key.lanes,
                       c.work.triangles, c.work.spans, c.work.pixels, c.cycles, c.busy, c.fill,
                       c.setup, c.stall, c.CyclesPerPixel(), c.OperationsPerPixel().total(),
                       c.PaperCyclesPerPixel());
    csv += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n",
                       c.PerPixel(1e9 * c.rtl_seconds), c.PerPixel(1e9 * c.model_seconds),
                       c.PerPixel(1e9 * c.front_end_seconds), c.phong.max_lsb, c.phong.rms_lsb,
                       c.phong.psnr_db, c.closed_form.max_lsb, c.closed_form.rms_lsb,
                       c.closed_form.psnr_db);
  }
  return csv;
}

}  // namespace shading::sim
