// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/register_map_page.h"

#include <iomanip>
#include <sstream>

#include "model/tlm/register_map.h"

namespace shading {
namespace {

constexpr std::string_view kIntroduction = R"(# Register map

Generated from [register_map.h](../model/tlm/register_map.h): `register_map > docs/register_map.md`.

Registers are 32-bit words in the host's byte order; 64-bit values have the low word first. An
access is a whole number of aligned words, done as a whole or not at all; each word takes one clock
period. There is no interrupt: poll `STATUS`.

| offset | name | words | access | reset | |
|---|---|--:|---|---|---|
)";

constexpr std::string_view kCommands = R"(
R read, W write. A reset value is that of the first word; further words are 0. `STATUS` reads with
the room in the FIFO, so not as 0 after reset.

## CONTROL
| bit | name | |
|--:|---|---|
| 0 | START | takes over the frame state (`METHOD` .. `DEPTH_STRIDE`, `MATERIALS`), clears ERROR |
| 1 | END | no more triangles: shades the frame; the frame's first cycle begins here |
| 2 | RESET | registers, FIFO and counters to their reset values; ends a frame being shaded |

Frame state may be changed and triangles be pushed for the next frame while one is being shaded;
they wait in the FIFO for its START. A START with an error in the frame state opens a frame whose
triangles are dropped.

## STATUS
| bits | name | |
|--:|---|---|
| 0 | BUSY | from START until the frame is in the frame buffer |
| 1 | SHADING | from END on |
| 15:8 | SPACE | packets that the FIFO can take without waiting |
| 23:16 | ERROR | the first error since START or RESET |

| ERROR | |
|--:|---|
)";

constexpr std::string_view kPacket = R"(
## TRIANGLE_FIFO
| word | | format |
|---|---|---|
| 0, 6, 12 | x of vertex 0, 1, 2 | S13.8, pixels |
| 1, 7, 13 | y, running down | S13.8, pixels |
| 2, 8, 14 | z, smaller is nearer | U0.24 |
| 3..5, 9..11, 15..17 | unit normal x, y, z | S1.22 |
| 18 | index in `MATERIALS` | integer |

Values stand in the low bits in two's complement; higher bits are ignored. The words may be written
one by one or as one burst. A write to a full FIFO waits, and fails where no frame makes room.

## MATERIALS
Entry i is at 0x4000 + 64 i. Words 0..2 are ambient, 3..5 diffuse, 6..8 specular (red, green, blue;
U1.16, 0..1), word 9 is the shininess (U9.7, 1..256), the others are not used.

## Frame buffer
Pixel (x, y) is the word at `COLOR_BASE` + y `COLOR_STRIDE` + 4 x: bytes red, green, blue, 255. Its
depth is the word at `DEPTH_BASE` + y `DEPTH_STRIDE` + 4 x: U0.24, upper byte 0. Clear depths to
0xffffffff.

## Counters
`PIXELS` to `NORMALISED_SKIPPED` belong to the latest complete frame and change when BUSY falls.
)";

constexpr std::string_view Letters(Access access) {
  return access == Access::kRead ? "R" : access == Access::kWrite ? "W" : "RW";
}

std::string Hex(uint32_t value, int digits) {
  std::ostringstream text;
  text << "0x" << std::hex << std::setfill('0') << std::setw(digits) << value;
  return text.str();
}

}  // namespace

std::string RegisterMapPage() {
  std::ostringstream page;
  page << kIntroduction;
  for (const Register& row : kRegisterMap) {
    page << "| " << Hex(row.offset, 4) << " | " << row.name << " | " << row.words << " | "
         << Letters(row.access) << " | " << Hex(row.reset, 8) << " | " << row.description << " |\n";
  }
  page << kCommands;
  for (size_t i = 0; i < kErrorText.size(); ++i)
    page << "| " << i << " | " << kErrorText[i] << " |\n";
  page << "\n## METHOD\n| value | |\n|--:|---|\n";
  for (const Method method : kAllMethods) {
    page << "| " << static_cast<int>(method) << " | " << Name(method) << " |\n";
  }
  page << kPacket;
  return page.str();
}

}  // namespace shading
