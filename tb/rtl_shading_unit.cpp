// SPDX-License-Identifier: Apache-2.0
#include "tb/rtl_shading_unit.h"

#include "Vshading_unit_all.h"
#include "Vshading_unit_all___024root.h"
#include "Vshading_unit_flat.h"
#include "Vshading_unit_flat___024root.h"
#include "Vshading_unit_gouraud.h"
#include "Vshading_unit_gouraud___024root.h"
#include "Vshading_unit_quad.h"
#include "Vshading_unit_quad___024root.h"
#include "tb/dut/shading_unit_dut.h"

namespace shading::tb {

std::unique_ptr<RtlShadingUnit> RtlShadingUnit::Create(Method method) {
  switch (method) {
    case Method::kFlat: return std::make_unique<ShadingUnitDut<Vshading_unit_flat>>();
    case Method::kGouraud: return std::make_unique<ShadingUnitDut<Vshading_unit_gouraud>>();
    case Method::kQuad: return std::make_unique<ShadingUnitDut<Vshading_unit_quad>>();
  }
  return nullptr;
}

std::unique_ptr<RtlShadingUnit> RtlShadingUnit::CreateAll() {
  return std::make_unique<ShadingUnitDut<Vshading_unit_all>>();
}

}  // namespace shading::tb
