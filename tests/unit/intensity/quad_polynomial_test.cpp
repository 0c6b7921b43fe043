// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_polynomial.h"

#include "tb/dut/quad_polynomial_dut.h"
#include "tests/unit/intensity/point_form_suite.h"

namespace shading {
namespace {

struct PolynomialForm {
  using Model = QuadPolynomial;
  using Dut = tb::QuadPolynomialDut;
  using LaneDut = tb::QuadPolynomialLane3Of4Dut;
};

INSTANTIATE_TYPED_TEST_SUITE_P(QuadPolynomial, PointForm, PolynomialForm);

}  // namespace
}  // namespace shading
