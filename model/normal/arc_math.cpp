// SPDX-License-Identifier: Apache-2.0
#include "model/normal/arc_math.h"

namespace shading {
namespace {

// Taylor coefficients h^k / k!, h = pi / 2, of sin(h x) / x and cos(h x) in x^2: the first one left
// out is below 2^-67.
constexpr std::array<int64_t, 12> kSine = {1811004864519280711,
                                           -744745899218905439,
                                           91879342557802013,
                                           -5397695021890950,
                                           184976092165948,
                                           -4149183757585,
                                           65626285697,
                                           -771077950,
                                           6994701,
                                           -50464,
                                           296,
                                           -1};
constexpr std::array<int64_t, 12> kCosine = {1152921504606846976,
                                             -1422359894497287770,
                                             292461030722154733,
                                             -24053955633020904,
                                             1059834939193175,
                                             -29055976611915,
                                             543126883801,
                                             -7363252037,
                                             75700401,
                                             -610403,
                                             3963,
                                             -21};

// atan(x) / h / x in x^2; for |x| <= 1/63 the first one left out is below 2^-65.
constexpr std::array<int64_t, 5> kArcTangent = {733972625820500307, -244657541940166769,
                                                146794525164100061, -104853232260071472,
                                                81552513980055590};
// atan(k / 32) / h.
constexpr std::array<int64_t, 33> kArcTangentTable = {0,
                                                      22929182573009054,
                                                      45813697873323707,
                                                      68609398520218177,
                                                      91273161881380487,
                                                      113763365663537387,
                                                      136040321548786875,
                                                      158066656337811560,
                                                      179807632645220259,
                                                      201231404012809634,
                                                      222309202162474374,
                                                      243015456817397615,
                                                      263327850925872798,
                                                      283227316116728228,
                                                      302697974735026449,
                                                      321727035832070199,
                                                      340304653033718298,
                                                      358423752334169642,
                                                      376079837627021180,
                                                      393270781269974473,
                                                      409996606264248208,
                                                      426259265790001924,
                                                      442062424941140217,
                                                      457411248601282690,
                                                      472312198539410381,
                                                      486772842008505379,
                                                      500801673422216336,
                                                      514407950072821846,
                                                      527601542340832980,
                                                      540392798429349328,
                                                      552792423327895199,
                                                      564811371461748771,
                                                      576460752303423488};

template <size_t N>
int64_t Horner(const std::array<int64_t, N>& coefficient, int64_t x) {
  int64_t sum = coefficient[N - 1];
  for (size_t k = N - 1; k-- > 0;) sum = coefficient[k] + ArcProduct(sum, x);
  return sum;
}

// 2.67084 - 3.28536 m + 1.63857 m^2 is within 2.5 % of 1 / sqrt(m) on [1/4, 1].
constexpr std::array<int64_t, 3> kInverseRoot = {2670835389265985 * (kArcOne / 1000000000000000),
                                                 -3285356590841617 * (kArcOne / 1000000000000000),
                                                 1638567835925180 * (kArcOne / 1000000000000000)};
constexpr int kNewtonSteps = 4;  // 2.5 % -> 9e-4 -> 1.1e-6 -> 2e-12 -> 5e-24

int LeadingZeros(Uint128 value) {
  const auto high = static_cast<uint64_t>(value >> 64);
  return high ? __builtin_clzll(high) : 64 + __builtin_clzll(static_cast<uint64_t>(value));
}

}  // namespace

SineCosine SineCosineOf(int64_t quarter_turns) {
  const int64_t square = ArcProduct(quarter_turns, quarter_turns);
  return {ArcProduct(Horner(kSine, square), quarter_turns), Horner(kCosine, square)};
}

int64_t QuarterTurnsOf(int64_t y, int64_t x) {
  const int64_t low = y < x ? y : x, high = y < x ? x : y;
  // atan(t) = atan(k/32) + atan((t - k/32) / (1 + t k/32)), t = low / high, k/32 the nearest.
  const int64_t k = ((low >> 24) / (high >> 30) + 1) >> 1;
  const Int128 numerator = static_cast<Int128>(low) * 32 - static_cast<Int128>(high) * k;
  const Int128 denominator = high + ((static_cast<Int128>(low) * k) >> 5);
  const auto u = static_cast<int64_t>((numerator << (kArcFraction - 5)) / denominator);
  const int64_t rest = ArcProduct(Horner(kArcTangent, ArcProduct(u, u)), u);
  const int64_t angle = kArcTangentTable[static_cast<size_t>(k)] + rest;
  return y < x ? angle : kArcOne - angle;
}

Root RootOf(Uint128 square) {
  if (square == 0) return {};
  const int shift = LeadingZeros(square) & ~1;
  const auto m = static_cast<int64_t>((square << shift) >> (128 - kArcFraction));  // [1/4, 1)
  int64_t inverse = Horner(kInverseRoot, m);
  for (int step = 0; step < kNewtonSteps; ++step) {
    const int64_t excess = ArcProduct(m, ArcProduct(inverse, inverse)) - kArcOne;
    inverse -= ArcProduct(inverse, excess) / 2;
  }
  // square = m 2^(8 - shift).
  const int exponent = shift / 2 - 4;
  return {RoundShift(static_cast<Int128>(m) * inverse, kArcFraction + exponent), inverse, exponent};
}

int64_t ArcRatio(Uint128 a, Uint128 b) {
  const int excess = 66 - LeadingZeros(b);  // 62 bits remain
  if (excess > 0) {
    a >>= excess;
    b >>= excess;
  }
  return static_cast<int64_t>(((a << kArcFraction) + (b >> 1)) / b);
}

}  // namespace shading
