# One unit = one name in five places. Both functions stop the configure step when a file is missing,
# so that a unit is never half there.
#
#   add_shading_unit(NAME name GROUP group)      RTL, model, pins, test, doc page
#   add_model_unit(NAME name GROUP group)        model, test, doc page: its RTL twin does not exist yet
#
# The group is the folder: rtl/<group>, model/<group>, tests/unit/<group>, docs/units/<group>.
# GROUP top stands for the folders themselves.
include(GoogleTest)

set(SHADING_RTL_PACKAGES
  ${PROJECT_SOURCE_DIR}/rtl/pkg/fixed_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/pkg/light_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/pkg/normal_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/pkg/footprint_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/pkg/method_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/pkg/specular_table_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/pkg/shading_pkg.sv)
set(SHADING_RTL_FOLDERS
  -y ${PROJECT_SOURCE_DIR}/rtl/raster
  -y ${PROJECT_SOURCE_DIR}/rtl/intensity
  -y ${PROJECT_SOURCE_DIR}/rtl/normal
  -y ${PROJECT_SOURCE_DIR}/rtl/light
  -y ${PROJECT_SOURCE_DIR}/rtl/footprint
  -y ${PROJECT_SOURCE_DIR}/rtl/choice)

# Verilator's run time, compiled once; verilate() would compile it for every configuration.
add_library(verilated_runtime STATIC
  ${VERILATOR_ROOT}/include/verilated.cpp
  ${VERILATOR_ROOT}/include/verilated_threads.cpp
  ${VERILATOR_ROOT}/include/verilated_fst_c.cpp)
if(SHADESIM_COVERAGE)
  target_sources(verilated_runtime PRIVATE ${VERILATOR_ROOT}/include/verilated_cov.cpp)
endif()
target_compile_definitions(verilated_runtime PRIVATE VM_COVERAGE=$<BOOL:${SHADESIM_COVERAGE}>
  VM_SC=0 VM_TRACE=1 VM_TRACE_VCD=0 VM_TRACE_FST=1)
target_include_directories(verilated_runtime SYSTEM PUBLIC ${VERILATOR_ROOT}/include
  ${VERILATOR_ROOT}/include/vltstd)
target_link_libraries(verilated_runtime PUBLIC ZLIB::ZLIB)

# verilate_unit(TARGET t TOP module SOURCE file VISIBLE file.vlt [TRACE] [PARAMETERS -GName=value...]): a
# static library whose class is named after the target; VISIBLE says which names C++ sees, TRACE that it
# can write waveforms. Every configuration is verilated once and shared by programs and tests. The many
# small files that Verilator writes are compiled in batches: reading its headers costs most.
function(verilate_unit)
  cmake_parse_arguments(V "TRACE" "TARGET;TOP;SOURCE;VISIBLE" "PARAMETERS" ${ARGN})
  add_library(${V_TARGET} STATIC)
  set(features)
  set(batch 0)
  if(SHADESIM_COVERAGE)
    list(APPEND features COVERAGE)
  endif()
  if(V_TRACE)
    list(APPEND features TRACE_FST)
    set(batch 8)
  endif()
  verilate(${V_TARGET} ${features}
    PREFIX ${V_TARGET}
    TOP_MODULE ${V_TOP}
    SOURCES ${PROJECT_SOURCE_DIR}/rtl/lint.vlt ${PROJECT_SOURCE_DIR}/rtl/${V_VISIBLE}
      ${SHADING_RTL_PACKAGES} ${V_SOURCE}
    VERILATOR_ARGS -Wall --assert -O3 --x-assign fast --x-initial fast --trace-structs
      ${SHADING_RTL_FOLDERS} ${V_PARAMETERS})
  get_target_property(sources ${V_TARGET} SOURCES)
  list(FILTER sources EXCLUDE REGEX "/include/verilated[a-z_]*[.]cpp$")
  set_target_properties(${V_TARGET} PROPERTIES SOURCES "${sources}" UNITY_BUILD ON
    UNITY_BUILD_BATCH_SIZE ${batch})
  # Generated and Verilator's own headers are not held to the project's warnings.
  get_target_property(headers ${V_TARGET} INCLUDE_DIRECTORIES)
  target_include_directories(${V_TARGET} SYSTEM INTERFACE ${headers})
  target_link_libraries(${V_TARGET} PUBLIC verilated_runtime)
endfunction()

function(require_unit_files)
  foreach(file IN LISTS ARGN)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${file})
      message(FATAL_ERROR "a unit is incomplete: ${file} is missing")
    endif()
  endforeach()
endfunction()

function(unit_folder group out)
  if(group STREQUAL "top")
    set(${out} "" PARENT_SCOPE)
  else()
    set(${out} "${group}/" PARENT_SCOPE)
  endif()
endfunction()

function(add_unit_test name folder)
  add_executable(${name}_test ${PROJECT_SOURCE_DIR}/tests/unit/${folder}${name}_test.cpp)
  target_compile_options(${name}_test PRIVATE ${SHADESIM_WARNINGS})
  target_link_libraries(${name}_test PRIVATE ${ARGN} shading_model shading_ideal
    GTest::gtest_main)
  gtest_discover_tests(${name}_test TEST_PREFIX unit. PROPERTIES LABELS unit TIMEOUT 300)
endfunction()

function(add_model_unit)
  cmake_parse_arguments(UNIT "" "NAME;GROUP" "" ${ARGN})
  unit_folder(${UNIT_GROUP} folder)
  require_unit_files(
    model/${folder}${UNIT_NAME}.h
    tests/unit/${folder}${UNIT_NAME}_test.cpp
    docs/units/${folder}${UNIT_NAME}.md)
  add_unit_test(${UNIT_NAME} "${folder}")
endfunction()

function(add_shading_unit)
  cmake_parse_arguments(UNIT "" "NAME;GROUP" "" ${ARGN})
  unit_folder(${UNIT_GROUP} folder)
  require_unit_files(
    rtl/${folder}${UNIT_NAME}.sv
    model/${folder}${UNIT_NAME}.h
    tb/dut/${UNIT_NAME}_dut.h
    tests/unit/${folder}${UNIT_NAME}_test.cpp
    docs/units/${folder}${UNIT_NAME}.md)
  if(UNIT_GROUP STREQUAL "top")
    add_unit_test(${UNIT_NAME} "${folder}" shading_tb)
    return()
  endif()
  verilate_unit(TARGET V${UNIT_NAME} TOP ${UNIT_NAME} VISIBLE contract.vlt
    SOURCE ${PROJECT_SOURCE_DIR}/rtl/${folder}${UNIT_NAME}.sv)
  add_unit_test(${UNIT_NAME} "${folder}" V${UNIT_NAME})
endfunction()
