# floeplan_test(<folder> LIBRARIES <targets> SOURCES <files>): one test executable for each folder of the tree.
if(BUILD_TESTING)
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()

function(floeplan_test folder)
  cmake_parse_arguments(PARSE_ARGV 1 TEST "" "" "SOURCES;LIBRARIES")
  add_executable(${folder}_test ${TEST_SOURCES})
  target_link_libraries(${folder}_test PRIVATE ${TEST_LIBRARIES} floeplan_test_places GTest::gmock_main floeplan_options)
  target_include_directories(${folder}_test PRIVATE ${PROJECT_SOURCE_DIR})
  set_target_properties(${folder}_test PROPERTIES FLOEPLAN_JOIN_MOST 10)
  if(FLOEPLAN_SANITIZE OR NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    # What a test calls is optimised as it is for users; its own code is large, runs briefly, and compiles twice as fast.
    # At -Og the compiler takes what a constructor it does not inline sets for uninitialised.
    target_compile_options(${folder}_test PRIVATE -Og $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
  if(FLOEPLAN_SANITIZE MATCHES "undefined")
    # It is the code under test that is looked at for undefined behaviour; in matchers it takes a fifth of the time.
    target_compile_options(${folder}_test PRIVATE -fno-sanitize=undefined)
  endif()
  if(NOT CCACHE AND NOT FLOEPLAN_JOIN)  # each spares more by itself
    target_precompile_headers(${folder}_test PRIVATE <gtest/gtest.h> <gmock/gmock.h>)
  endif()
  gtest_discover_tests(${folder}_test TEST_PREFIX "${folder}." DISCOVERY_TIMEOUT 60
    PROPERTIES ENVIRONMENT "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/leaks_of_libraries.txt")
endfunction()
