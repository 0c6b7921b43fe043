// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "model/light/light_types.h"
#include "model/shading_types.h"

namespace shading {

enum class Access { kRead, kWrite, kReadWrite };

// One row of the register map: a 32-bit register, a 64-bit value (low word first) or a window.
struct Register {
  std::string_view name;
  uint32_t offset;  // bytes
  uint32_t words;   // 32-bit words
  Access access;
  uint32_t reset;  // of its first word; further words are 0
  std::string_view description;
};

inline constexpr uint32_t kWordBytes = 4;
inline constexpr uint32_t kAddressSpace = 0x8000;  // bytes
inline constexpr uint32_t kPacketWords = 19;
inline constexpr uint32_t kMaterialWords = 16;  // of one entry; 10 are used

constexpr uint32_t MethodBits() {
  uint32_t bits = 0;
  for (const Method method : kAllMethods) bits |= 1u << static_cast<unsigned>(method);
  return bits;
}

inline constexpr uint32_t kUnit = 1u << 22;  // 1 as S1.22, a component of a vector

// What software sees. docs/register_map.md is generated from this table.
inline constexpr std::array kRegisterMap = {
    Register{"ID", 0x000, 1, Access::kRead, 0x44414853, "\"SHAD\", first letter lowest"},
    Register{"VERSION", 0x004, 1, Access::kRead, 0x00000200, "major << 8 + minor of this map"},
    Register{"CAPABILITIES", 0x008, 1, Access::kRead, MethodBits(), "bit m: METHOD m is built in"},
    Register{"CONTROL", 0x010, 1, Access::kWrite, 0, "commands, see below"},
    Register{"STATUS", 0x014, 1, Access::kRead, 0, "state, room in the FIFO, error; see below"},
    Register{"METHOD", 0x018, 1, Access::kReadWrite, 0, "shading method, see below"},
    Register{"LIGHTING", 0x01c, 1, Access::kReadWrite, 0, "specular cosine: 0 N.H, 1 R.V"},
    Register{"CULL", 0x020, 1, Access::kReadWrite, 0, "0 back faces, 1 nothing"},
    Register{"WIDTH", 0x024, 1, Access::kReadWrite, 0, "pixels, 1..4096"},
    Register{"HEIGHT", 0x028, 1, Access::kReadWrite, 0, "pixels, 1..4096"},
    Register{"MATERIAL_COUNT", 0x02c, 1, Access::kReadWrite, 0, "valid MATERIALS, 0..256"},
    Register{"LIGHT_X", 0x030, 1, Access::kReadWrite, 0, "S1.22, unit vector to the light"},
    Register{"LIGHT_Y", 0x034, 1, Access::kReadWrite, 0, ""},
    Register{"LIGHT_Z", 0x038, 1, Access::kReadWrite, kUnit, ""},
    Register{"HALF_X", 0x03c, 1, Access::kReadWrite, 0, "S1.22, unit half vector"},
    Register{"HALF_Y", 0x040, 1, Access::kReadWrite, 0, ""},
    Register{"HALF_Z", 0x044, 1, Access::kReadWrite, kUnit, ""},
    Register{"VIEW_X", 0x048, 1, Access::kReadWrite, 0, "S1.22, unit vector to the viewer"},
    Register{"VIEW_Y", 0x04c, 1, Access::kReadWrite, 0, ""},
    Register{"VIEW_Z", 0x050, 1, Access::kReadWrite, kUnit, ""},
    Register{"TOLERANCE", 0x054, 1, Access::kReadWrite, 1u << 11,
             "U4.12 codes, quad-segment, adaptive, footprint, auto"},
    Register{"COLOR_BASE", 0x058, 2, Access::kReadWrite, 0, "bus address, multiple of 4"},
    Register{"COLOR_STRIDE", 0x060, 1, Access::kReadWrite, 0, "bytes, >= 4 WIDTH, multiple of 4"},
    Register{"DEPTH_TEST", 0x064, 1, Access::kReadWrite, 0,
             "1: less; the earlier pixel wins a tie"},
    Register{"DEPTH_BASE", 0x068, 2, Access::kReadWrite, 0, "as COLOR_BASE, with DEPTH_TEST"},
    Register{"DEPTH_STRIDE", 0x070, 1, Access::kReadWrite, 0, "as COLOR_STRIDE, with DEPTH_TEST"},
    Register{"DEPTH_SLOPE", 0x074, 1, Access::kReadWrite, 0,
             "U0.24 perspective, 1 / distance = 1 - slope z; footprint"},
    Register{"PIXELS", 0x080, 2, Access::kRead, 0, "pixels that left the core"},
    Register{"STALL", 0x088, 2, Access::kRead, 0, "cycles in which a pixel was not taken"},
    Register{"SETUP", 0x090, 2, Access::kRead, 0, "cycles with a span inside but no pixel"},
    Register{"CYCLES", 0x098, 2, Access::kRead, 0, "frame accepted to core empty"},
    Register{"TRIANGLES", 0x0a0, 2, Access::kRead, 0, "triangles that cover pixels"},
    Register{"SPANS", 0x0a8, 2, Access::kRead, 0, "their spans"},
    Register{"WRITTEN", 0x0b0, 2, Access::kRead, 0, "pixels that passed the depth test"},
    Register{"SKIPPED_BACK_FACING", 0x0b8, 2, Access::kRead, 0, "triangles culled"},
    Register{"SKIPPED_DEGENERATE", 0x0c0, 2, Access::kRead, 0, "triangles of zero area"},
    Register{"SKIPPED_OFF_SCREEN", 0x0c8, 2, Access::kRead, 0, "triangles beside the screen"},
    Register{"SKIPPED_EMPTY", 0x0d0, 2, Access::kRead, 0, "triangles between pixel centres"},
    Register{"NORMALISED", 0x0d8, 2, Access::kRead, 0, "normalisations, adaptive methods"},
    Register{"NORMALISED_SKIPPED", 0x0e0, 2, Access::kRead, 0, "pixels less those, span by span"},
    Register{"SAMPLES_TAKEN", 0x0e8, 2, Access::kRead, 0, "samples that were lit, footprint"},
    Register{"SAMPLES_EXCLUDED", 0x0f0, 2, Access::kRead, 0, "samples outside, footprint-paper"},
    Register{"SAMPLES_SAVED", 0x0f8, 2, Access::kRead, 0, "of 7 a pixel, those not wanted"},
    Register{"TRIANGLE_FIFO", 0x100, kPacketWords, Access::kWrite, 0,
             "triangle packet, see below; the last word pushes"},
    Register{"SKIPPED_AMBIENT", 0x180, 2, Access::kRead, 0,
             "triangles that no light reaches, auto"},
    Register{"SPANS_CONSTANT", 0x188, 2, Access::kRead, 0, "spans of one colour, auto"},
    Register{"SPANS_DARK", 0x190, 2, Access::kRead, 0, "spans lit without a highlight, auto"},
    Register{"SPANS_UNNORMALISED", 0x198, 2, Access::kRead, 0,
             "spans lit without a normalisation, auto"},
    Register{"CHANNELS_BLACK", 0x1a0, 2, Access::kRead, 0, "spans times black channels, auto"},
    Register{"MATERIALS", 0x4000, kMaxMaterials* kMaterialWords, Access::kReadWrite, 0,
             "material table, see below"},
};

// Row of the map by name; in a constant expression a name that is not there does not compile.
constexpr const Register& RegisterNamed(std::string_view name) {
  for (const Register& row : kRegisterMap) {
    if (row.name == name) return row;
  }
  throw std::invalid_argument("no such register");
}
constexpr uint32_t OffsetOf(std::string_view name) { return RegisterNamed(name).offset; }

constexpr bool RowsAreDisjoint() {
  uint32_t end = 0;
  for (const Register& row : kRegisterMap) {
    if (row.offset < end || row.offset % kWordBytes != 0 || row.words == 0) return false;
    end = row.offset + row.words * kWordBytes;
  }
  return end <= kAddressSpace;
}
static_assert(RowsAreDisjoint(), "rows in rising order, aligned, inside the address space");

// Bits of CONTROL.
inline constexpr uint32_t kControlStart = 1u << 0;
inline constexpr uint32_t kControlEnd = 1u << 1;
inline constexpr uint32_t kControlReset = 1u << 2;

// Fields of STATUS.
inline constexpr uint32_t kStatusBusy = 1u << 0;
inline constexpr uint32_t kStatusShading = 1u << 1;
constexpr uint32_t StatusSpace(uint32_t status) { return status >> 8 & 0xff; }  // packets
constexpr uint32_t StatusError(uint32_t status) { return status >> 16 & 0xff; }
inline constexpr uint32_t kMaxFifo = 255;  // packets that the field can tell

// Values of the error field of STATUS: the first error since START or soft reset.
enum class DeviceError : uint8_t {
  kNone,
  kMethod,
  kState,
  kSize,
  kVector,
  kMaterial,
  kFrameBuffer,
  kMaterialIndex,
  kNormal,
  kFifo,
  kSequence,
  kBus,
  kCore
};

inline constexpr std::array<std::string_view, 13> kErrorText = {
    "none",
    "METHOD is not built in",
    "LIGHTING, CULL or DEPTH_TEST above 1, TOLERANCE above 65535, or DEPTH_SLOPE of 2^24 or more",
    "WIDTH or HEIGHT outside 1..4096",
    "LIGHT, HALF or VIEW not unit within 2^-10",
    "MATERIAL_COUNT above 256, or a reflectance above 1 or a shininess outside 1..256",
    "base or stride not a multiple of 4, stride under 4 WIDTH, or end above 2^64",
    "a triangle names a material at or above MATERIAL_COUNT; it is skipped",
    "a triangle has a normal that is not unit within 2^-10; it is skipped",
    "a triangle was written to a full FIFO while no frame makes room; it is lost",
    "START while busy or END without an open frame; ignored",
    "the frame buffer answered with an error; the frame ended early",
    "the core stopped responding; the frame ended early",
};

}  // namespace shading
