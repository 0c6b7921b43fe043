// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/normal/normal_types.h"
#include "tb/bit_packer.h"

namespace shading::tb {

// arc_t of normal_pkg.sv, the last field first.
template <typename Port>
void DriveArc(const SpanArc& arc, Port& port) {
  BitPacker<8> bits;
  for (const SpanNormal* normal : {&arc.side, &arc.start}) {
    for (const SpanNormalComponent value : *normal) bits.Put(value);
  }
  bits.Put(arc.step.raw(), Angle::kWidth);
  bits.Store(port);
}

template <typename Port>
SpanArc ReadArc(const Port& port) {
  BitReader<Port> bits(port);
  SpanArc arc;
  for (SpanNormal* normal : {&arc.side, &arc.start}) {
    for (SpanNormalComponent& value : *normal) {
      value = bits.template TakeSigned<SpanNormalComponent>();
    }
  }
  arc.step = Angle::FromRaw(static_cast<int64_t>(bits.Take(Angle::kWidth)));
  return arc;
}

}  // namespace shading::tb
