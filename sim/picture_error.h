// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "model/triangle_packet.h"
#include "sim/frame_buffer.h"

namespace shading::sim {

// Distance of the displayed codes from real values, over the three channels of every covered pixel.
// 1 LSB = 1/255 of full scale; half an LSB is the rounding of the code itself.
struct PictureError {
  double max_lsb = 0;
  double rms_lsb = 0;
  double psnr_db = 0;  // peak 255; infinite when the pictures agree
};

// Against linear-normal Phong shading, normalised and lit at every pixel, in double.
PictureError ErrorAgainstPhong(const FrameBuffer& picture, const TriangleList& list);

// Against the method's own closed form in double.
PictureError ErrorAgainstClosedForm(const FrameBuffer& picture, const TriangleList& list,
                                    Method method);

// The largest error of a pixel's channels against Phong per pixel, rounding included: black 0, red
// 4, yellow 8, white 16 LSB and more.
Image ErrorMap(const FrameBuffer& picture, const TriangleList& list);

// Replaces the codes of covered pixels by those of the method's closed form.
void ShadeIdeally(const TriangleList& list, Method method, FrameBuffer* picture);

}  // namespace shading::sim
