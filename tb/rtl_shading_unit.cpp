// SPDX-License-Identifier: Apache-2.0
#include "tb/rtl_shading_unit.h"

#include "Vshading_unit_all.h"
#include "Vshading_unit_all___024root.h"
#include "Vshading_unit_all_x4.h"
#include "Vshading_unit_all_x4___024root.h"
#include "Vshading_unit_flat.h"
#include "Vshading_unit_flat___024root.h"
#include "Vshading_unit_gouraud.h"
#include "Vshading_unit_gouraud___024root.h"
#include "Vshading_unit_phong.h"
#include "Vshading_unit_phong___024root.h"
#include "Vshading_unit_phong_duff.h"
#include "Vshading_unit_phong_duff___024root.h"
#include "Vshading_unit_phong_taylor.h"
#include "Vshading_unit_phong_taylor___024root.h"
#include "Vshading_unit_quad.h"
#include "Vshading_unit_quad___024root.h"
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

std::unique_ptr<RtlShadingUnit> RtlShadingUnit::Create(Method method, int lanes) {
  if (lanes != 1) return CreateAll(lanes);
  switch (method) {
    case Method::kFlat: return std::make_unique<ShadingUnitDut<Vshading_unit_flat, 1>>();
    case Method::kGouraud: return std::make_unique<ShadingUnitDut<Vshading_unit_gouraud, 1>>();
    case Method::kQuad: return std::make_unique<ShadingUnitDut<Vshading_unit_quad, 1>>();
    case Method::kPhong: return std::make_unique<ShadingUnitDut<Vshading_unit_phong, 1>>();
    case Method::kPhongTaylor:
      return std::make_unique<ShadingUnitDut<Vshading_unit_phong_taylor, 1>>();
    case Method::kPhongDuff: return std::make_unique<ShadingUnitDut<Vshading_unit_phong_duff, 1>>();
    case Method::kSlerp: return std::make_unique<ShadingUnitDut<Vshading_unit_slerp, 1>>();
    case Method::kSlerpPaper:
      return std::make_unique<ShadingUnitDut<Vshading_unit_slerp_paper, 1>>();
    case Method::kSlerpIntensity:
      return std::make_unique<ShadingUnitDut<Vshading_unit_slerp_intensity, 1>>();
    case Method::kSlerpDirect:
      return std::make_unique<ShadingUnitDut<Vshading_unit_slerp_direct, 1>>();
  }
  return nullptr;
}

std::unique_ptr<RtlShadingUnit> RtlShadingUnit::CreateAll(int lanes) {
  if (lanes == 1) return std::make_unique<ShadingUnitDut<Vshading_unit_all, 1>>();
  return std::make_unique<ShadingUnitDut<Vshading_unit_all_x4, kMaxLanes>>();
}

}  // namespace shading::tb
