// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/choice/method_choice.h"
#include "model/footprint/aniso_footprint.h"
#include "model/footprint/footprint_mean.h"
#include "model/footprint/footprint_setup.h"
#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/lane_seed.h"
#include "model/intensity/quad_difference.h"
#include "model/intensity/quad_horner.h"
#include "model/intensity/quad_midpoint.h"
#include "model/intensity/quad_polynomial.h"
#include "model/intensity/quad_segment.h"
#include "model/intensity/quad_split.h"
#include "model/intensity/quad_step.h"
#include "model/intensity/quad_surface.h"
#include "model/intensity/quad_third_difference.h"
#include "model/intensity/quad_three_term.h"
#include "model/light/blinn_specular.h"
#include "model/light/dot_product.h"
#include "model/light/mean_cosines.h"
#include "model/light/pixel_light.h"
#include "model/light/quad_cosine.h"
#include "model/light/rgb_combine.h"
#include "model/light/specular_cosine.h"
#include "model/light/specular_power.h"
#include "model/light/vertex_light.h"
#include "model/normal/adaptive_normalizer.h"
#include "model/normal/duff_normalizer.h"
#include "model/normal/length_recurrence.h"
#include "model/normal/linear_recurrence.h"
#include "model/normal/normal_setup.h"
#include "model/normal/phong_direct.h"
#include "model/normal/reciprocal_sqrt.h"
#include "model/normal/slerp_direct.h"
#include "model/normal/slerp_direct_setup.h"
#include "model/normal/slerp_paper.h"
#include "model/normal/slerp_recurrence.h"
#include "model/normal/span_normals.h"
#include "model/normal/taylor_normalizer.h"
#include "model/raster/pixel_queue.h"
#include "model/raster/pixel_walker.h"
#include "model/raster/span_binder.h"
#include "model/raster/span_setup.h"
#include "model/raster/span_walker.h"
#include "model/raster/subdivision.h"
#include "model/raster/surface_fit.h"
#include "model/raster/triangle_setup.h"
#include "model/shading_unit.h"

namespace shading {

// Every unit, in the order in which a triangle meets them.
inline constexpr std::array kContracts = {
    Subdivision::kContract,
    TriangleSetup::kContract,
    SpanWalker::kContract,
    SpecularPower::kContract,
    MeanCosines::kContract,
    VertexLight::kContract,
    MethodChoice::kContract,
    SurfaceFit::kContract,
    SpanNormals::kContract,
    FootprintSetup::kContract,
    SpanSetup::kContract,
    SpanBinder::kContract,
    NormalSetup::kContract,
    PixelWalker::kContract,
    LaneSeed::kContract,
    FlatColor::kContract,
    GouraudInterpolator::kContract,
    QuadSurface::kContract,
    QuadPolynomial::kContract,
    QuadHorner::kContract,
    QuadStep::kContract,
    QuadMidpoint::kContract,
    QuadThreeTerm::kContract,
    QuadThirdDifference::kContract,
    QuadSegment::kContract,
    QuadDifference::kContract,
    QuadSplit::kContract,
    QuadCosine::kContract,
    LinearRecurrence::kContract,
    SlerpRecurrence::kContract,
    SlerpPaper::kContract,
    LengthRecurrence::kContract,
    SlerpDirectSetup::kContract,
    SlerpDirect::kContract,
    AdaptiveNormalizer::kContract,
    ReciprocalSqrt::kContract,
    PhongDirect::kContract,
    TaylorNormalizer::kContract,
    DuffNormalizer::kContract,
    AnisoFootprint::kContract,
    DotProduct::kContract,
    SpecularCosine::kContract,
    BlinnSpecular::kContract,
    FootprintMean::kContract,
    RgbCombine::kContract,
    PixelLight::kContract,
    PixelQueue::kContract,
    ShadingUnit::kContract};

}  // namespace shading
