// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <type_traits>

#include "model/contracts.h"
#include "sim/stress/check.h"
#include "sim/stress/model_value.h"

namespace shading::stress {
namespace {

constexpr int kLast = 2047;  // the last of the pixels for which bounds are stated
constexpr int kFraction = IntensityAcc::kFraction;

// A real number in ulp of the registers: an integer that a gene of the curve gives, and a part
// below an ulp of a narrowed register, -1/2..1/2, which rounding loses.
Real InUlps(double codes, double gene, int narrow) {
  const double ulp = std::ldexp(1, narrow);
  const double whole = std::round(std::ldexp(codes, kFraction) / ulp) * ulp;
  return static_cast<Real>(whole) + static_cast<Real>((gene - 0.5) * ulp);
}
int64_t Kept(Real ulps, int narrow) { return RoundNarrow(std::ldexp(ulps, -26), 26, narrow); }

// Parabolas of 17 codes at pixel 0 that stay in the range of the registers.
struct Curve {
  Real first, slope, a;  // I(t) = first + slope t + a t^2, ulps
  Real At(int t) const { return first + slope * t + a * t * t; }
};
const std::vector<std::string> kParts = {"part of the 1st number below an ulp", "of the 2nd",
                                         "of the 3rd", "slope", "curvature"};

using Seeds = ChannelSeed (*)(const Genes& g, int narrow, Curve* real);

ChannelSeed SeedOf(int64_t first, int64_t difference, int64_t curvature) {
  return {IntensityAcc::Wrap(first), IntensityAcc::Wrap(first + difference),
          IntensityAcc::Wrap(difference), IntensityAcc::Wrap(curvature)};
}
double Slope(const Genes& g) { return Between(-100, 100, g[3]) / kLast; }
double Bend(const Genes& g) { return Between(-50, 50, g[4]) / kLast / kLast; }

// Rounds I(0), I(1) and A.
ChannelSeed TwoValues(const Genes& g, int narrow, Curve* real) {
  const Real first = InUlps(17, g[0], narrow), a = InUlps(Bend(g), g[2], narrow);
  const Real second = InUlps(17 + Slope(g), g[1], narrow);
  *real = {first, second - first - a, a};
  return SeedOf(Kept(first, narrow), Kept(second, narrow) - Kept(first, narrow),
                2 * Kept(a, narrow));
}
// Rounds F, D and A.
ChannelSeed Coefficients(const Genes& g, int narrow, Curve* real) {
  const Real first = InUlps(17, g[0], narrow), a = InUlps(Bend(g), g[2], narrow);
  const Real slope = InUlps(Slope(g), g[1], narrow);
  *real = {first, slope, a};
  return SeedOf(Kept(first, narrow), Kept(slope, narrow) + Kept(a, narrow), 2 * Kept(a, narrow));
}
// Rounds I(0), I(1) - I(0) and A.
ChannelSeed DifferenceAndA(const Genes& g, int narrow, Curve* real) {
  const Real first = InUlps(17, g[0], narrow), a = InUlps(Bend(g), g[2], narrow);
  const Real difference = InUlps(Slope(g), g[1], narrow);
  *real = {first, difference - a, a};
  return SeedOf(Kept(first, narrow), Kept(difference, narrow), 2 * Kept(a, narrow));
}
// Rounds I(0), I(1) - I(0) and 2A.
ChannelSeed Differences(const Genes& g, int narrow, Curve* real) {
  const Real first = InUlps(17, g[0], narrow), twice = InUlps(2 * Bend(g), g[2], narrow);
  const Real difference = InUlps(Slope(g), g[1], narrow);
  *real = {first, difference - twice / 2, twice / 2};
  return SeedOf(Kept(first, narrow), Kept(difference, narrow), Kept(twice, narrow));
}
// Rounds I(0), I(1), I(2) and, for those that hold it, A.
ChannelSeed ThreeValues(const Genes& g, int narrow, Curve* real) {
  const Real first = InUlps(17, g[0], narrow), second = InUlps(17 + Slope(g), g[1], narrow);
  const Real third = InUlps(17 + 2 * Slope(g) + 2 * Bend(g), g[2], narrow);
  const Real a = (first - 2 * second + third) / 2;
  *real = {first, second - first - a, a};
  const int64_t curvature = 2 * Kept(a, narrow);
  ChannelSeed seed = SeedOf(Kept(first, narrow), Kept(second, narrow) - Kept(first, narrow), 0);
  seed.difference = IntensityAcc::Wrap(Kept(third, narrow) - Kept(second, narrow) - curvature);
  seed.curvature = IntensityAcc::Wrap(curvature);
  return seed;
}
// As (7) does it: I(2) is what I(0), I(1) and A make it, and rounded as well.
ChannelSeed ThreeValuesAndA(const Genes& g, int narrow, Curve* real) {
  const ChannelSeed two = TwoValues(g, narrow, real);
  ChannelSeed seed = two;
  const int64_t third = Kept(real->At(2), narrow);
  seed.difference = IntensityAcc::Wrap(third - two.second.raw() - two.curvature.raw());
  return seed;
}

// The unit's accumulator at the last pixel against the parabola in real numbers.
template <typename Unit>
double LastError(const ChannelSeed& seed, const Curve& real) {
  const Real off = static_cast<Real>(AfterSteps(Unit(seed), kLast)) - real.At(kLast);
  // A midpoint is half of a sum modulo 1024 codes.
  constexpr bool kHalved = std::is_same_v<Unit, BasicQuadMidpoint<SeenWord>>;
  const Real known = kHalved ? std::remainder(off, std::ldexp(512.0L, kFraction)) : off;
  return static_cast<double>(std::ldexp(std::abs(known), -kFraction));
}

template <typename Unit>
Check Form(const UnitContract& contract, Seeds seeds) {
  Check check = CheckOf(contract, "codes", "registers S9.25");
  check.genes = kParts;
  check.error = [seeds](const Genes& g, int narrow) {
    Curve real;
    const ChannelSeed seed = seeds(g, narrow, &real);
    return LastError<Unit>(seed, real);
  };
  check.starts = {{1e-9, 1e-9, 1e-9, 0.4, 0.6},
                  {1 - 1e-9, 1 - 1e-9, 1 - 1e-9, 0.4, 0.6},
                  {1e-9, 1 - 1e-9, 1 - 1e-9, 0.4, 0.6}};
  check.cost = 6;
  check.blind = 0.9;
  return check;
}

Check Segment() {
  Check check = Form<BasicQuadSurface<SeenWord>>(QuadSegment::kContract, DifferenceAndA);
  check.genes.push_back("tolerance, 2^-9..8 codes");
  check.error = [](const Genes& g, int narrow) {
    Curve real;
    const ChannelSeed seed = DifferenceAndA(g, narrow, &real);
    const Tolerance tolerance = Tolerance::Round(Geometric(1.0 / 512, 8, g[5]));
    QuadSegment unit(seed, tolerance);
    Real worst = 0;
    for (int t = 0; t <= kLast; ++t, unit.Step()) {
      const auto at = static_cast<Real>(unit.value().raw());
      Raise(&worst, std::abs(at - real.At(t)));
    }
    return static_cast<double>(std::ldexp(worst, -kFraction)) - tolerance.ToReal();
  };
  for (Genes& start : check.starts) start.push_back(0);
  check.cost = 12;
  return check;
}

// Two parabolas above 0, so that neither is clamped; ambient 0.
Check Split() {
  Check check = CheckOf(QuadSplit::kContract, "codes", "seeds S9.25");
  check.genes = kParts;
  check.genes.insert(check.genes.end(), kParts.begin(), kParts.end());
  check.error = [](const Genes& g, int narrow) {
    const Genes other(g.begin() + 5, g.end());
    const auto lifted = [&](const Genes& genes, Curve* real) {
      ChannelSeed seed = Differences(genes, narrow, real);
      const int64_t lift = int64_t{150} << kFraction;
      seed.first = IntensityAcc::Wrap(seed.first.raw() + lift);
      real->first += static_cast<Real>(lift);
      return seed;
    };
    Curve diffuse, specular;
    const ChannelSeed d = lifted(g, &diffuse), s = lifted(other, &specular);
    QuadSplit unit(d, {s, {}});
    for (int t = 0; t < kLast; ++t) unit.Step();
    const Real ideal = std::max<Real>(diffuse.At(kLast), 0) + std::max<Real>(specular.At(kLast), 0);
    return static_cast<double>(
        std::ldexp(std::abs(static_cast<Real>(unit.sum()) - ideal), -kFraction));
  };
  check.starts = {Genes(10, 1e-9), Genes(10, 1 - 1e-9)};
  for (Genes& start : check.starts) start[3] = start[4] = start[8] = start[9] = 0.6;
  check.cost = 6;
  check.blind = 0.9;
  return check;
}

Check Gouraud() {
  Check check = CheckOf(GouraudInterpolator::kContract, "codes", "seeds S9.25");
  check.genes = {"part of the start below an ulp", "part of the slope", "", "slope", ""};
  check.error = [](const Genes& g, int narrow) {
    constexpr int kLastPixel = kMaxScreen - 1;
    const Real first = InUlps(17, g[0], narrow), slope = InUlps(Slope(g) / 2, g[1], narrow);
    const auto at =
        static_cast<Real>(GouraudAfter(Kept(first, narrow), Kept(slope, narrow), kLastPixel));
    return static_cast<double>(std::ldexp(std::abs(at - first - slope * kLastPixel), -kFraction));
  };
  check.starts = {{1e-9, 1e-9, 0, 0.6, 0}, {1 - 1e-9, 1 - 1e-9, 0, 0.6, 0}};
  check.cost = 15;
  return check;
}

// Six coefficients, rounded: all that a form errs that evaluates every pixel anew.
template <typename Unit>
Check Point(const UnitContract& contract) {
  Check check = CheckOf(contract, "codes", "coefficients S9.25");
  check.genes = {"part of A below an ulp", "of B", "of C", "of D", "of E", "of F", "x", "y"};
  check.error = [](const Genes& g, int narrow) {
    const auto x = static_cast<int>(std::lround(Between(-2047, 2047, g[6])));
    const auto y = static_cast<int>(std::lround(Between(-2047, 2047, g[7])));
    const std::array<Real, 6> term = {Real(x) * x, Real(y) * y, Real(x) * y, Real(x), Real(y), 1};
    const std::array<double, 6> codes = {1e-5, -1e-5, 5e-6, 0.01, -0.02, 100};
    Real ideal = 0;
    std::array<IntensityAcc, 6> kept;
    for (size_t i = 0; i < 6; ++i) {
      const Real real = InUlps(codes[i], g[i], narrow);
      ideal += real * term[i];
      kept[i] = IntensityAcc::Wrap(Kept(real, narrow));
    }
    const SurfacePoint point = {{kept[0], kept[1], kept[2], kept[3], kept[4], kept[5]}, x, y};
    const auto at = static_cast<Real>(AfterSteps(Unit(point), 0));
    return static_cast<double>(std::ldexp(std::abs(at - ideal), -kFraction));
  };
  check.starts = {Genes(8, 1 - 1e-9), Genes(8, 1e-9)};
  check.starts[1][6] = check.starts[1][7] = 1;
  return check;
}

}  // namespace

std::vector<Check> QuadChecks() {
  return {Gouraud(),
          Form<BasicQuadSurface<SeenWord>>(QuadSurface::kContract, TwoValues),
          Form<BasicQuadStep<SeenWord>>(QuadStep::kContract, Coefficients),
          Form<BasicQuadMidpoint<SeenWord>>(QuadMidpoint::kContract, TwoValues),
          Form<BasicQuadThreeTerm<SeenWord>>(QuadThreeTerm::kContract, ThreeValuesAndA),
          Form<BasicQuadThirdDifference<SeenWord>>(QuadThirdDifference::kContract, ThreeValues),
          Form<BasicQuadDifference<SeenWord>>(QuadDifference::kContract, Differences),
          Segment(),
          Split(),
          Point<BasicQuadPolynomial<SeenWord>>(QuadPolynomial::kContract),
          Point<BasicQuadHorner<SeenWord>>(QuadHorner::kContract)};
}

}  // namespace shading::stress
