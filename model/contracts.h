// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/quad_surface.h"
#include "model/light/mean_cosines.h"
#include "model/light/specular_power.h"
#include "model/light/vertex_light.h"
#include "model/raster/pixel_walker.h"
#include "model/raster/span_setup.h"
#include "model/raster/span_walker.h"
#include "model/raster/surface_fit.h"
#include "model/raster/triangle_setup.h"
#include "model/shading_unit.h"

namespace shading {

// Every unit, in the order in which a triangle meets them.
inline constexpr std::array<UnitContract, 12> kContracts = {
    TriangleSetup::kContract,       SpanWalker::kContract,  SpecularPower::kContract,
    MeanCosines::kContract,         VertexLight::kContract, SurfaceFit::kContract,
    SpanSetup::kContract,           PixelWalker::kContract, FlatColor::kContract,
    GouraudInterpolator::kContract, QuadSurface::kContract, ShadingUnit::kContract};

}  // namespace shading
