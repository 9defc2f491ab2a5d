# floeplan_test(<folder> LIBRARIES <targets> SOURCES <files>): one test executable for each folder of the tree.
if(BUILD_TESTING)
  find_package(GTest REQUIRED)
endif()

# A test executable runs in so many parts, each a process: starting one for every test takes most of the time under a
# sanitizer. More parts than cores, so that one long test does not hold up the end.
set(FLOEPLAN_TEST_PARTS 8)

# floeplan_register_tests(<folder>): the parts of <folder>_test with CTest, named <folder>.<part>. Each writes a report of
# its tests to reports/<folder>.<part>.xml below the build folder.
function(floeplan_register_tests folder)
  math(EXPR last "${FLOEPLAN_TEST_PARTS} - 1")
  foreach(part RANGE ${last})
    add_test(NAME ${folder}.${part} COMMAND ${folder}_test)
    set(environment GTEST_TOTAL_SHARDS=${FLOEPLAN_TEST_PARTS} GTEST_SHARD_INDEX=${part}
      GTEST_OUTPUT=xml:${PROJECT_BINARY_DIR}/reports/${folder}.${part}.xml
      LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/leaks_of_libraries.txt)
    set_tests_properties(${folder}.${part} PROPERTIES ENVIRONMENT "${environment}")
  endforeach()
endfunction()

# floeplan_register_server_tests(<folder> <filter> <parts>): the same tests of <folder>_test once more, with their stores at a
# database server, named <folder>.server<part>. <filter> leaves out those that open no store of support::empty_store.
function(floeplan_register_server_tests folder filter parts)
  math(EXPR last "${parts} - 1")
  foreach(part RANGE ${last})
    set(name ${folder}.server${part})
    add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/support/at_database_server
      $<TARGET_FILE:${folder}_test> --gtest_filter=${filter})
    set(environment GTEST_TOTAL_SHARDS=${parts} GTEST_SHARD_INDEX=${part}
      GTEST_OUTPUT=xml:${PROJECT_BINARY_DIR}/reports/${name}.xml
      LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/leaks_of_libraries.txt)
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${environment}" SKIP_RETURN_CODE 77)
  endforeach()
endfunction()

function(floeplan_test folder)
  cmake_parse_arguments(PARSE_ARGV 1 TEST "" "" "SOURCES;LIBRARIES")
  add_executable(${folder}_test ${TEST_SOURCES})
  target_link_libraries(${folder}_test PRIVATE ${TEST_LIBRARIES} floeplan_test_places GTest::gmock_main floeplan_options)
  target_include_directories(${folder}_test PRIVATE ${PROJECT_SOURCE_DIR})
  set_target_properties(${folder}_test PROPERTIES FLOEPLAN_IS_TEST ON)
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
  floeplan_register_tests(${folder})
endfunction()
