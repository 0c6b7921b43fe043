// SPDX-License-Identifier: Apache-2.0
#include "sim/io/image_io.h"

#include <OpenImageIO/imageio.h>

#include "tests/sim/disk_limit.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

using ImageIoTest = FileTest;

// Every code in every channel; uncovered pixels hold codes that must not show.
Image TestImage() {
  Image image{32, 24, {}, {}};
  for (int i = 0; i < 32 * 24; ++i) {
    image.code.push_back(
        {static_cast<uint8_t>(i), static_cast<uint8_t>(7 * i + 1), static_cast<uint8_t>(255 - i)});
    image.covered.push_back(i % 5 != 0);
  }
  return image;
}

template <typename Sample>
std::vector<Sample> ReadBack(const std::string& path, OIIO::TypeDesc type, int channels,
                             OIIO::TypeDesc stored) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) {
    ADD_FAILURE() << OIIO::geterror();
    return {};
  }
  EXPECT_EQ(input->spec().width, 32);
  EXPECT_EQ(input->spec().height, 24);
  EXPECT_EQ(input->spec().nchannels, channels);
  EXPECT_EQ(input->spec().format, stored);
  std::vector<Sample> samples(static_cast<size_t>(32 * 24 * channels));
  EXPECT_TRUE(input->read_image(0, 0, 0, channels, type, samples.data()));
  return samples;
}

TEST_F(ImageIoTest, CodesInEightBits) {
  const Image image = TestImage();
  for (const auto& [name, channels] :
       {std::pair("a.png", 4), std::pair("a.tif", 4), std::pair("a.TIFF", 4), std::pair("a.bmp", 4),
        std::pair("a.tga", 4), std::pair("a.ppm", 3)}) {
    WriteImage(Path(name), image);
    const auto samples =
        ReadBack<uint8_t>(Path(name), OIIO::TypeDesc::UINT8, channels, OIIO::TypeDesc::UINT8);
    ASSERT_FALSE(samples.empty());
    for (size_t i = 0; i < image.code.size(); ++i) {
      for (size_t c = 0; c < static_cast<size_t>(channels); ++c) {
        const int code = c < 3 ? image.code[i][c] : 255;
        ASSERT_EQ(samples[i * static_cast<size_t>(channels) + c], image.covered[i] ? code : 0)
            << name << " pixel " << i << " channel " << c;
      }
    }
  }
  EXPECT_EQ(FileCount(), 6);
}

TEST_F(ImageIoTest, LinearFloat) {
  const Image image = TestImage();
  WriteImage(Path("a.exr"), image);
  const auto samples =
      ReadBack<float>(Path("a.exr"), OIIO::TypeDesc::FLOAT, 4, OIIO::TypeDesc::FLOAT);
  ASSERT_FALSE(samples.empty());
  for (size_t i = 0; i < image.code.size(); ++i) {
    for (size_t c = 0; c < 4; ++c) {
      const float intensity = c < 3 ? static_cast<float>(image.code[i][c]) / 255.0f : 1.0f;
      ASSERT_EQ(samples[4 * i + c], image.covered[i] ? intensity : 0.0f);
    }
  }
}

// Lossy formats: size and channels are right and the picture is not far off.
TEST_F(ImageIoTest, JpegAndHdr) {
  Image image = TestImage();
  for (auto& code : image.code) code = {200, 100, 50};
  for (auto& covered : image.covered) covered = 1;
  WriteImage(Path("a.jpg"), image);
  WriteImage(Path("a.hdr"), image);
  const auto jpeg =
      ReadBack<uint8_t>(Path("a.jpg"), OIIO::TypeDesc::UINT8, 3, OIIO::TypeDesc::UINT8);
  EXPECT_NEAR(jpeg[300], 200, 4);
  const auto hdr = ReadBack<float>(Path("a.hdr"), OIIO::TypeDesc::FLOAT, 3, OIIO::TypeDesc::FLOAT);
  EXPECT_NEAR(hdr[301], 100 / 255.0, 0.01);
}

TEST_F(ImageIoTest, SameImageSameBytes) {
  for (const char* extension : {".png", ".exr"}) {
    WriteImage(Path("a") + extension, TestImage());
    WriteImage(Path("b") + extension, TestImage());
    EXPECT_EQ(Read(std::string("a") + extension), Read(std::string("b") + extension));
  }
}

TEST_F(ImageIoTest, BadPlaces) {
  const Image image = TestImage();
  ExpectError([&] { WriteImage(Path("a.xyz"), image); },
              "a.xyz: no picture format '.xyz'; use one of: png");
  ExpectError([&] { WriteImage(Path("a"), image); }, "a: no extension; use one of: png");
  ExpectError([&] { WriteImage(Path("a.term"), image); }, "no picture format");
  ExpectError([&] { WriteImage(Path("none/a.png"), image); }, "create it");
  std::filesystem::create_directory(Path("sub.png"));
  ExpectError([&] { WriteImage(Path("sub.png"), image); }, "is a folder");
  EXPECT_EQ(FileCount(), 1);
}

TEST_F(ImageIoTest, FullDiskLeavesNothing) {
  Image image{200, 150, {}, std::vector<uint8_t>(200 * 150, 1)};
  uint32_t random = 1;
  for (int i = 0; i < 200 * 150; ++i) {
    random = random * 1664525u + 1013904223u;
    image.code.push_back({static_cast<uint8_t>(random >> 24), static_cast<uint8_t>(random >> 16),
                          static_cast<uint8_t>(random >> 8)});
  }
  for (const char* name :
       {"a.png", "a.exr", "a.tif", "a.jpg", "a.bmp", "a.tga", "a.hdr", "a.ppm"}) {
    const DiskLimit limit(4096);
    ExpectError([&] { WriteImage(Path(name), image); }, "could not be written in full");
    EXPECT_EQ(FileCount(), 0) << name;
  }
}

TEST_F(ImageIoTest, IncompleteImage) {
  Image image = TestImage();
  image.code.pop_back();
  ExpectError([&] { WriteImage(Path("a.png"), image); }, "does not hold 32 x 24 pixels");
  ExpectError([&] { WriteImage(Path("a.png"), Image{}); }, "0 x 0");
  EXPECT_EQ(FileCount(), 0);
}

}  // namespace
}  // namespace shading::sim
