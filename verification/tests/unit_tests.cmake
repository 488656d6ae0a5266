# The unit tests: one executable a folder.
include(GoogleTest)

# What every test begins with is parsed once for all of them.
add_library(test_headers STATIC headers.cpp)
target_link_libraries(test_headers PUBLIC type21_options GTest::gtest_main fmt::fmt Eigen3::Eigen)
target_compile_definitions(test_headers PUBLIC TYPE21_SOURCE_DIR="${PROJECT_SOURCE_DIR}" TYPE21_BINARY="${CMAKE_BINARY_DIR}/type21")
target_precompile_headers(test_headers PRIVATE <string> <vector> <fmt/format.h> <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry>)

type21_sees(test_headers verification/tests)

# These give a name of another file of their folder another meaning.
set_source_files_properties(
  contact/test_friction_laws.cpp contact/test_heat.cpp contact/test_projection.cpp decisions/queries/test_decision_json_answers.cpp
  model/test_defaults.cpp model/test_friction_rules.cpp model/test_heat_rules.cpp model/test_interface_card.cpp
  model/test_interface_rules.cpp model/test_secondary_side.cpp optimized/test_filter.cpp stability/test_sliding.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# Tests of what a missing package leaves out, or that compare with it.
find_package(GSL QUIET)
set(left_out)
if(NOT GSL_FOUND)
  type21_without("GSL" "the tests that compare with its quadrature and ODE solutions are not built (contact/test_heat, contact/test_pmax_and_gap)")
  list(APPEND left_out test_heat test_pmax_and_gap)
endif()
if(NOT XXHASH_LIBRARY)
  list(APPEND left_out test_kept_checks)
endif()
if(NOT pugixml_FOUND OR NOT Boost_FOUND)
  list(APPEND left_out test_paraview_files)
endif()

# type21_test(FOLDER LIBRARY...): the tests of a folder; they see what their libraries see.
function(type21_test folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  foreach(one ${left_out})
    list(FILTER sources EXCLUDE REGEX "/${one}\\.cpp$")
  endforeach()
  string(REPLACE "/" "_" name ${folder})
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE ${ARGN} test_headers)
  target_precompile_headers(test_${name} REUSE_FROM test_headers)
  type21_by_folder(test_${name})
  gtest_discover_tests(test_${name} TEST_PREFIX ${folder}/ DISCOVERY_TIMEOUT 60)
endfunction()

type21_test(deck type21_model)
type21_test(model type21_host)
type21_test(contact type21_support)
if(GSL_FOUND)
  target_link_libraries(test_contact PRIVATE GSL::gsl)
endif()
# It computes with intervals, which change the rounding mode.
set_source_files_properties(exact/test_numbers.cpp PROPERTIES COMPILE_OPTIONS -frounding-math SKIP_PRECOMPILE_HEADERS ON)
type21_test(exact type21_host type21_reference)
type21_test(host type21_support)
type21_test(optimized type21_support TBB::tbb nlohmann_json::nlohmann_json)
type21_test(decisions/deck_fuzz type21_fuzz_input)
foreach(folder support decisions/queries decisions/fuzz decisions/atlas results/tables results/record results/compare results/t01
               results/paraview results/balance criteria/cases criteria/lockstep criteria/mutation stability explain
               performance/accuracy performance/bench invariance cli)
  type21_test(${folder} type21_stability type21_explain type21_report type21_bench)
endforeach()
# They start the program.
foreach(name explain performance_accuracy decisions_fuzz decisions_atlas cli)
  add_dependencies(test_${name} type21)
endforeach()
