// SPDX-License-Identifier: Apache-2.0
#include "tb/rtl_shading_unit.h"

#include "Vshading_unit_adaptive.h"
#include "Vshading_unit_adaptive___024root.h"
#include "Vshading_unit_all.h"
#include "Vshading_unit_all___024root.h"
#include "Vshading_unit_all_x4.h"
#include "Vshading_unit_all_x4___024root.h"
#include "Vshading_unit_auto.h"
#include "Vshading_unit_auto___024root.h"
#include "Vshading_unit_flat.h"
#include "Vshading_unit_flat___024root.h"
#include "Vshading_unit_footprint.h"
#include "Vshading_unit_footprint___024root.h"
#include "Vshading_unit_gouraud.h"
#include "Vshading_unit_gouraud___024root.h"
#include "Vshading_unit_phong.h"
#include "Vshading_unit_phong___024root.h"
#include "Vshading_unit_phong_duff.h"
#include "Vshading_unit_phong_duff___024root.h"
#include "Vshading_unit_phong_surface.h"
#include "Vshading_unit_phong_surface___024root.h"
#include "Vshading_unit_phong_taylor.h"
#include "Vshading_unit_phong_taylor___024root.h"
#include "Vshading_unit_quad.h"
#include "Vshading_unit_quad___024root.h"
#include "Vshading_unit_quad_cosine.h"
#include "Vshading_unit_quad_cosine___024root.h"
#include "Vshading_unit_quad_forms.h"
#include "Vshading_unit_quad_forms___024root.h"
#include "Vshading_unit_quad_split.h"
#include "Vshading_unit_quad_split___024root.h"
#include "Vshading_unit_slerp.h"
#include "Vshading_unit_slerp___024root.h"
#include "Vshading_unit_slerp_direct.h"
#include "Vshading_unit_slerp_direct___024root.h"
#include "Vshading_unit_slerp_intensity.h"
#include "Vshading_unit_slerp_intensity___024root.h"
#include "Vshading_unit_slerp_paper.h"
#include "Vshading_unit_slerp_paper___024root.h"
#include "tb/dut/shading_unit_dut.h"

namespace shading::tb {
namespace {

template <typename Top>
std::unique_ptr<RtlShadingUnit> OneLane() {
  return std::make_unique<ShadingUnitDut<Top, 1>>();
}

}  // namespace

std::unique_ptr<RtlShadingUnit> RtlShadingUnit::Create(Method method, int lanes) {
  if (lanes != 1) return CreateAll(lanes);
  switch (method) {
    case Method::kFlat: return OneLane<Vshading_unit_flat>();
    case Method::kGouraud: return OneLane<Vshading_unit_gouraud>();
    case Method::kQuad: return OneLane<Vshading_unit_quad>();
    case Method::kQuadSplit: return OneLane<Vshading_unit_quad_split>();
    case Method::kQuadCosine: return OneLane<Vshading_unit_quad_cosine>();
    case Method::kPhongSurface: return OneLane<Vshading_unit_phong_surface>();
    case Method::kPhong: return OneLane<Vshading_unit_phong>();
    case Method::kPhongTaylor: return OneLane<Vshading_unit_phong_taylor>();
    case Method::kPhongDuff: return OneLane<Vshading_unit_phong_duff>();
    case Method::kSlerp: return OneLane<Vshading_unit_slerp>();
    case Method::kSlerpPaper: return OneLane<Vshading_unit_slerp_paper>();
    case Method::kSlerpIntensity: return OneLane<Vshading_unit_slerp_intensity>();
    case Method::kSlerpDirect: return OneLane<Vshading_unit_slerp_direct>();
    case Method::kAdaptive:
    case Method::kAdaptivePaper:
    case Method::kAdaptiveChord: return OneLane<Vshading_unit_adaptive>();
    case Method::kFootprint:
    case Method::kFootprintPaper: return OneLane<Vshading_unit_footprint>();
    case Method::kAuto: return OneLane<Vshading_unit_auto>();
    default: return OneLane<Vshading_unit_quad_forms>();
  }
}

std::unique_ptr<RtlShadingUnit> RtlShadingUnit::CreateAll(int lanes) {
  if (lanes == 1) return OneLane<Vshading_unit_all>();
  return std::make_unique<ShadingUnitDut<Vshading_unit_all_x4, kMaxLanes>>();
}

}  // namespace shading::tb
