// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_horner.h"

#include "tb/dut/quad_horner_dut.h"
#include "tests/unit/intensity/point_form_suite.h"

namespace shading {
namespace {

struct HornerForm {
  using Model = QuadHorner;
  using Dut = tb::QuadHornerDut;
  using LaneDut = tb::QuadHornerLane3Of4Dut;
};

INSTANTIATE_TYPED_TEST_SUITE_P(QuadHorner, PointForm, HornerForm);

}  // namespace
}  // namespace shading
