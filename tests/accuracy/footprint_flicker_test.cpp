// SPDX-License-Identifier: Apache-2.0
//
// Footprints flicker less than pixel centres, by the measure and the numbers of docs/footprint.md.
#include "tests/accuracy/footprint_flicker.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

namespace shading::accuracy {
namespace {

// A part of the turn is enough for the claims; `less` is how much less it changes at least.
void ExpectCalmer(const Turning& turning, double less) {
  SCOPED_TRACE(turning.name);
  const FlickerTable table = MeasureFlicker(turning, 12);
  const Flicker &centre = table[kCentreOnly], &footprint = table[kFootprint];
  EXPECT_GT(centre.change, 0.5) << "the highlight does not move";
  EXPECT_GT(centre.change, less * footprint.change);
  EXPECT_GT(centre.beyond_ellipse, 10 * footprint.beyond_ellipse);
  EXPECT_GT(centre.beyond_sampled, 2.5 * footprint.beyond_sampled);
  EXPECT_NEAR(footprint.change, table[kEllipseMean].change, 0.05 * footprint.change);
  EXPECT_NEAR(footprint.beyond_ellipse, table[kFootprintFinest].beyond_ellipse, 0.05)
      << "the tolerance is the limit";
}

TEST(FootprintFlicker, PlaneOfRibs) { ExpectCalmer(SlantedScenes()[0], 2); }
TEST(FootprintFlicker, TessellatedCylinder) { ExpectCalmer(SlantedScenes()[1], 1.4); }

TEST(FootprintFlicker, AreTheNumbersOfThePage) {
  std::ifstream file(SHADESIM_ROOT "/docs/footprint.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const Turning& turning : SlantedScenes()) {
    const FlickerTable table = MeasureFlicker(turning, kTurningSteps);
    for (size_t d = 0; d < kDrawings; ++d) {
      SCOPED_TRACE(turning.name + ", " + kDrawingName[d]);
      const std::regex row("\\| " + turning.name + " \\| " + kDrawingName[d] +
                           " \\| ([0-9.]+) \\| ([0-9.]+) \\| ([0-9.]+) \\|");
      std::smatch cells;
      ASSERT_TRUE(std::regex_search(page, cells, row));
      const auto expect = [&](size_t cell, double value) {
        EXPECT_NEAR(std::stod(cells[cell]), value, 0.002 + 0.01 * value);
      };
      expect(1, table[d].change);
      expect(2, table[d].beyond_ellipse);
      expect(3, table[d].beyond_sampled);
    }
  }
}

TEST(FootprintFlicker, PictureHasEveryDrawing) {
  const sim::Image picture = FlickerPicture({SlantedScenes()[1]}, 0);
  const auto cell = [&](int column) {
    std::vector<std::array<uint8_t, 3>> codes;
    for (int y = 0; y < picture.height; ++y) {
      const auto row = picture.code.begin() + y * picture.width + column * picture.width / 4;
      codes.insert(codes.end(), row, row + picture.width / 4);
    }
    return codes;
  };
  EXPECT_NE(cell(0), cell(1));
  EXPECT_NE(cell(1), cell(2));
  EXPECT_NE(cell(2), cell(3));
}

}  // namespace
}  // namespace shading::accuracy
