// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/io/image_io.h"
#include "sim/scene/camera.h"
#include "sim/scene/scene.h"

namespace shading::accuracy {

// By what a pixel is drawn: phong, footprint, footprint with --tolerance 0, the mean over the same
// ellipse in double, and the mean of 16 x 16 pixels of phong's picture of 16 times the size, which
// knows nothing of ellipses and of triangles' planes.
enum Drawing { kCentreOnly, kFootprint, kFootprintFinest, kEllipseMean, kSupersampled, kDrawings };
extern const std::array<const char*, kDrawings> kDrawingName;

// A scene that turns by small steps.
struct Turning {
  std::string name;
  sim::Scene scene;
  sim::ViewOptions view;  // of frame 0
  double yaw_step = 0;    // degrees
};
inline constexpr int kTurningSteps = 60;

// A glossy plane of narrow ribs and a tessellated cylinder, n = 128, seen and lit at a slant, and
// the cylinder three times as large, whose highlight is wider than a pixel.
std::vector<Turning> SlantedScenes();

// Of the pixels that lie wholly inside the scene in both frames; codes, all channels.
struct Flicker {
  double change = 0;          // mean of |frame to frame|
  double beyond_ellipse = 0;  // mean of |its change less that of the ellipse's mean|
  double beyond_sampled = 0;  // the same against the supersampled picture
};
using FlickerTable = std::array<Flicker, kDrawings>;
FlickerTable MeasureFlicker(const Turning& turning, int steps);

// A frame by each drawing.
using Drawn = std::array<sim::Image, kDrawings>;
Drawn DrawFrame(const Turning& turning, int frame);

// Two frames, one above the other, of each scene: centre only, footprint, the ellipse's mean,
// supersampled. Every pixel is enlarged to a square.
sim::Image FlickerPicture(const std::vector<Turning>& scenes, int frame);

}  // namespace shading::accuracy
