// SPDX-License-Identifier: Apache-2.0
#include "sim/io/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

#include "sim/io/atomic_file.h"

namespace shading::sim {
namespace {

constexpr std::array<const char*, 8> kCodeExtensions = {"png", "tif", "tiff", "bmp",
                                                        "tga", "jpg", "jpeg", "ppm"};
constexpr std::array<const char*, 2> kFloatExtensions = {"exr", "hdr"};

[[noreturn]] void Fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}", path, what));
}

[[noreturn]] void FailEncoding(const std::string& path, std::string reason) {
  reason.resize(std::min(reason.size(), reason.find('\n')));
  Fail(path, fmt::format("cannot be encoded ({}); use another format", reason));
}

// Lower case, without the dot.
std::string Extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string().erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

template <size_t N>
bool Contains(const std::array<const char*, N>& list, const std::string& word) {
  return std::any_of(list.begin(), list.end(), [&](const char* entry) { return word == entry; });
}

// Interleaved samples, uint8_t codes or float intensities.
template <typename Sample>
std::vector<Sample> Interleave(const Image& image, size_t channels, Sample (*convert)(uint8_t)) {
  std::vector<Sample> samples(image.code.size() * channels);
  for (size_t i = 0; i < image.code.size(); ++i) {
    if (image.covered[i] == 0) continue;
    for (size_t c = 0; c < channels; ++c) {
      samples[i * channels + c] = convert(c < 3 ? image.code[i][c] : uint8_t{255});
    }
  }
  return samples;
}

// Encodes in memory: several writers of OpenImageIO take no notice of a full disk, and the one for
// JPEG ends the process.
std::vector<unsigned char> Encode(const std::string& path, const std::string& extension,
                                  const Image& image) {
  const std::string name = "image." + extension;
  const auto output = OIIO::ImageOutput::create(name);
  if (!output || output->supports("ioproxy") == 0) FailEncoding(path, "no writer is installed");
  const bool as_float = Contains(kFloatExtensions, extension);
  const int channels = output->supports("alpha") ? 4 : 3;
  OIIO::ImageSpec spec(image.width, image.height, channels,
                       as_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  if (as_float) spec.attribute("oiio:ColorSpace", "linear");
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  output->set_ioproxy(&memory);
  bool done = output->open(name, spec);
  if (done && as_float) {
    const auto samples = Interleave<float>(image, static_cast<size_t>(channels), [](uint8_t code) {
      return static_cast<float>(code) / 255.0f;
    });
    done = output->write_image(OIIO::TypeDesc::FLOAT, samples.data());
  } else if (done) {
    const auto samples = Interleave<uint8_t>(image, static_cast<size_t>(channels),
                                             [](uint8_t code) { return code; });
    done = output->write_image(OIIO::TypeDesc::UINT8, samples.data());
  }
  done = done && output->close();
  const std::string error = output->geterror();  // also clears what was only a warning
  if (!done || bytes.empty()) FailEncoding(path, error);
  return bytes;
}

}  // namespace

std::string EncodePng(const Image& image) {
  const std::vector<unsigned char> bytes = Encode("picture", "png", image);
  return {bytes.begin(), bytes.end()};
}

void CheckImageExtension(const std::string& path) {
  const std::string extension = Extension(path);
  if (Contains(kCodeExtensions, extension) || Contains(kFloatExtensions, extension)) return;
  const std::string what =
      extension.empty() ? "no extension" : fmt::format("no picture format '.{}'", extension);
  Fail(path, fmt::format("{}; use one of: {} {}", what, fmt::join(kCodeExtensions, " "),
                         fmt::join(kFloatExtensions, " ")));
}

void WriteImage(const std::string& path, const Image& image) {
  CheckImageExtension(path);
  const size_t pixels = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.code.size() != pixels ||
      image.covered.size() != pixels) {
    Fail(path, fmt::format("the image does not hold {} x {} pixels; give at least one, all of them",
                           image.width, image.height));
  }
  AtomicFile file(path);
  const std::vector<unsigned char> bytes = Encode(path, Extension(path), image);
  file.stream().write(reinterpret_cast<const char*>(bytes.data()),
                      static_cast<std::streamsize>(bytes.size()));
  file.Commit();
}

}  // namespace shading::sim
