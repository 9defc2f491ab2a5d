# Compiles many sources of a target as one unit, which takes a quarter of the time: headers are read, and templates
# are instantiated, once for all of them. Sources of one unit share their unnamed namespaces, so a name in two of them
# is an error there, or worse: of two functions the one that fits better is called (tests/architecture looks for them).
# Which unit a source goes into depends on its name alone, so that a new source moves no other.
# The units name their sources from the top of the tree (CMake's own name them by absolute paths), so that the compiler's
# cache knows them again in another clone.

# floeplan_join_sources(<folder>): of every target that this folder and those below it define.
function(floeplan_join_sources folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "STATIC_LIBRARY" OR target MATCHES "_test$")
      floeplan_join_sources_of(${target})
    endif()
  endforeach()
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder IN LISTS subfolders)
    floeplan_join_sources(${subfolder})
  endforeach()
  file(GLOB joined RELATIVE ${PROJECT_BINARY_DIR}/joint ${PROJECT_BINARY_DIR}/joint/*)
  foreach(name IN LISTS joined)
    if(NOT TARGET ${name})  # of an earlier state of the tree
      file(REMOVE_RECURSE ${PROJECT_BINARY_DIR}/joint/${name})
    endif()
  endforeach()
endfunction()

# A unit has 10 to 20 sources on average, or half of FLOEPLAN_JOIN_MOST up to as many where a target has this property:
# large units make the build from nothing shorter, and the one after a change longer. The number of units doubles as the
# target grows, or every addition would move all.
function(floeplan_join_sources_of target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  list(LENGTH sources count)
  get_target_property(most ${target} FLOEPLAN_JOIN_MOST)
  if(NOT most)
    set(most 20)
  endif()
  set(units 1)
  while(count GREATER most)
    math(EXPR units "2 * ${units}")
    math(EXPR most "2 * ${most}")
  endwhile()
  foreach(source IN LISTS sources)
    get_filename_component(path ${source} ABSOLUTE BASE_DIR ${folder})
    get_source_file_property(options ${path} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
    get_source_file_property(includes ${path} TARGET_DIRECTORY ${target} INCLUDE_DIRECTORIES)
    get_source_file_property(definitions ${path} TARGET_DIRECTORY ${target} COMPILE_DEFINITIONS)
    if(options OR includes OR definitions OR NOT path MATCHES "\\.cpp$")
      continue()  # compiled in a way of its own, or not at all
    endif()
    get_filename_component(name ${source} NAME)
    string(MD5 digest ${name})
    string(SUBSTRING ${digest} 0 4 digits)
    math(EXPR unit "0x${digits} % ${units}")
    file(RELATIVE_PATH include ${PROJECT_SOURCE_DIR} ${path})
    string(APPEND text_of_${unit} "#include \"${include}\"\n")
    set_source_files_properties(${path} TARGET_DIRECTORY ${target} PROPERTIES HEADER_FILE_ONLY ON)
  endforeach()
  file(GLOB left ${PROJECT_BINARY_DIR}/joint/${target}/unit*.cpp)
  math(EXPR last "${units} - 1")
  foreach(unit RANGE ${last})
    if(DEFINED text_of_${unit})
      set(joint ${PROJECT_BINARY_DIR}/joint/${target}/unit${unit}.cpp)
      list(REMOVE_ITEM left ${joint})
      file(CONFIGURE OUTPUT ${joint} CONTENT "${text_of_${unit}}" @ONLY)
      target_sources(${target} PRIVATE ${joint})
    endif()
  endforeach()
  if(left)  # of an earlier state of the tree
    file(REMOVE ${left})
  endif()
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()
