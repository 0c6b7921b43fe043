// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/ideal/lighting.h"
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

// The method that stands for all with the same closed form; phong for those that have Phong's.
Method ClosedFormOf(Method method);

// A closed form at every covered pixel, for all pictures that show the same triangles.
class IdealPicture {
 public:
  IdealPicture(const FrameBuffer& covered, const TriangleList& list, Method method);

  // Whether the picture shows the same triangle at every pixel.
  bool Fits(const FrameBuffer& picture) const;
  // Of a picture that fits.
  PictureError ErrorOf(const FrameBuffer& picture) const;
  size_t bytes() const;

 private:
  std::vector<int32_t> triangle_;  // of every pixel
  std::vector<ideal::Rgb> exact_;  // of covered pixels, in order
};

// The largest error of a pixel's channels against Phong per pixel, rounding included: black 0, red
// 4, yellow 8, white 16 LSB and more.
Image ErrorMap(const FrameBuffer& picture, const TriangleList& list);

// Replaces the codes of covered pixels by those of the method's closed form.
void ShadeIdeally(const TriangleList& list, Method method, FrameBuffer* picture);

}  // namespace shading::sim
