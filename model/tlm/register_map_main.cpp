// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "model/tlm/register_map_page.h"

int main() {
  std::cout << shading::RegisterMapPage() << std::flush;
  return std::cout ? 0 : 1;
}
