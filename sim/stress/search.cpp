// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/search.h"

#include <algorithm>
#include <random>

namespace shading::stress {
namespace {

Genes Corner(size_t count, std::mt19937& random) {
  Genes genes(count);
  std::uniform_real_distribution<double> unit(0, 1);
  for (double& gene : genes)
    gene = random() % 4 ? static_cast<double>(random() % 3) / 2 : unit(random);
  return genes;
}

Genes Anywhere(size_t count, std::mt19937& random) {
  Genes genes(count);
  std::uniform_real_distribution<double> unit(0, 1);
  for (double& gene : genes) gene = unit(random);
  return genes;
}

Genes Moved(Genes genes, std::mt19937& random) {
  std::normal_distribution<double> move(0, 1);
  const size_t only = random() % (2 * genes.size());  // half of the moves are along one axis
  for (size_t i = 0; i < genes.size(); ++i) {
    if (only < genes.size() && i != only) continue;
    if (random() % 16 == 0) {
      genes[i] = 1 - genes[i];
      continue;
    }
    const double size = std::ldexp(0.5, -static_cast<int>(random() % 48));
    genes[i] = std::clamp(genes[i] + size * move(random), 0.0, 1.0);
  }
  return genes;
}

}  // namespace

Worst Search(const Check& check, int64_t evaluations, uint32_t seed, int narrow) {
  std::mt19937 random(seed);
  Worst worst;
  const auto attempt = [&](const Genes& genes, Worst* best) {
    double error = check.error(genes, narrow);
    if (std::isnan(error)) error = HUGE_VAL;
    ++worst.evaluations;
    if (error > best->error) best->error = error, best->genes = genes;
  };
  for (const Genes& start : check.starts) attempt(start, &worst);
  constexpr int kClimbs = 6;
  const int64_t share = std::max<int64_t>(evaluations / kClimbs, 8);
  for (int climb = 0; climb < kClimbs; ++climb) {
    Worst best;
    if (climb == 0 && worst.error >= 0) best = worst;
    for (int64_t i = 0; i < share / 3; ++i) {
      attempt(i % 2 ? Corner(check.genes.size(), random) : Anywhere(check.genes.size(), random),
              &best);
    }
    for (int64_t i = share / 3; i < share; ++i) attempt(Moved(best.genes, random), &best);
    if (best.error > worst.error) worst.error = best.error, worst.genes = best.genes;
  }
  return worst;
}

}  // namespace shading::stress
