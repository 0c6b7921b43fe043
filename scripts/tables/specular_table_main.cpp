// SPDX-License-Identifier: Apache-2.0
//
// Writes the tables of blinn_specular for model and RTL into the source tree given as argument.
#include <fstream>
#include <iostream>
#include <string>

#include "scripts/tables/specular_table.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: specular_table <root of the source tree>\n";
    return 2;
  }
  const std::string root = argv[1];
  std::ofstream model(root + "/" + shading::tables::kModelFile);
  std::ofstream rtl(root + "/" + shading::tables::kRtlFile);
  shading::tables::WriteModel(model);
  shading::tables::WriteRtl(rtl);
  model.close();
  rtl.close();
  if (!model || !rtl) {
    std::cerr << "specular_table: cannot write into " << root << '\n';
    return 1;
  }
  return 0;
}
