# A room of the house (docs/architecture.md): a static library that sees the headers of the rooms it USES and of no
# other. Each room's headers are reached through an include root of its own that holds a link to each of them, and
# USES is linked PRIVATE, so neither an #include over a wall nor one through a neighbour compiles. tests/house proves
# it.
#   mapwright_room(NAME [PREFIX <include prefix>] [PRELUDE plain|core|widgets] SOURCES ... [APART ...] USES ...
#                  [LIBRARIES ...])
# Several sources of a room are compiled as one (MAPWRIGHT_UNITY: a third of the time). Those that
# give the same name to things of their own are listed as APART and compiled alone.
function(mapwright_room name)
  cmake_parse_arguments(ROOM "" "PREFIX;PRELUDE" "SOURCES;APART;USES;LIBRARIES" ${ARGN})
  if(NOT ROOM_PREFIX)
    set(ROOM_PREFIX ${name})
  endif()
  add_library(mw_${name} STATIC ${ROOM_SOURCES})
  set_target_properties(mw_${name} PROPERTIES UNITY_BUILD ${MAPWRIGHT_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  set_source_files_properties(${ROOM_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  open_door(${name} ${ROOM_PREFIX})
  foreach(used ${ROOM_USES})
    target_link_libraries(mw_${name} PRIVATE mw_${used})
  endforeach()
  target_link_libraries(mw_${name} PUBLIC ${ROOM_LIBRARIES} PRIVATE mw_warnings)
  set_property(GLOBAL PROPERTY ROOM_USES_${name} "${ROOM_USES}")
  set_property(GLOBAL APPEND PROPERTY ROOMS ${name})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set_property(GLOBAL PROPERTY ROOM_FOLDER_${name} ${folder})
  set_property(GLOBAL PROPERTY ROOM_PREFIX_${name} ${ROOM_PREFIX})
  if(ROOM_PRELUDE)
    take_prelude(mw_${name} ${ROOM_PRELUDE})
  endif()
endfunction()

# The include root of a room: PREFIX/<every header of its folder>. A folder below that is a room of its own stays
# outside.
function(open_door name prefix)
  set(root ${CMAKE_BINARY_DIR}/rooms/${name})
  set(here ${CMAKE_CURRENT_SOURCE_DIR})
  file(GLOB_RECURSE headers RELATIVE ${here} CONFIGURE_DEPENDS ${here}/*.h)
  file(GLOB_RECURSE lists RELATIVE ${here} ${here}/*/CMakeLists.txt)
  foreach(list ${lists})
    get_filename_component(inner ${list} DIRECTORY)
    list(FILTER headers EXCLUDE REGEX "^${inner}/")
  endforeach()
  file(GLOB_RECURSE old LIST_DIRECTORIES false RELATIVE ${root}/${prefix} ${root}/${prefix}/*)
  if(IS_SYMLINK ${root}/${prefix})  # as it was made once
    file(REMOVE ${root}/${prefix})
    set(old)
  endif()
  foreach(header ${old})
    if(NOT header IN_LIST headers)
      file(REMOVE ${root}/${prefix}/${header})
    endif()
  endforeach()
  file(MAKE_DIRECTORY ${root})
  foreach(header ${headers})
    get_filename_component(folder ${root}/${prefix}/${header} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    if(NOT EXISTS ${root}/${prefix}/${header})
      file(CREATE_LINK ${here}/${header} ${root}/${prefix}/${header} SYMBOLIC)
    endif()
  endforeach()
  target_include_directories(mw_${name} PUBLIC ${root})
endfunction()

# `rooms` and all whose headers theirs may name: what a test of them sees.
function(rooms_within_reach result)
  set(reached)
  set(waiting ${ARGN})
  while(waiting)
    list(POP_FRONT waiting room)
    if(NOT room IN_LIST reached)
      list(APPEND reached ${room})
      get_property(uses GLOBAL PROPERTY ROOM_USES_${room})
      list(APPEND waiting ${uses})
    endif()
  endwhile()
  set(${result} ${reached} PARENT_SCOPE)
endfunction()

# A test's class stands in its source, which includes what moc says of it. AUTOMOC would look through every header
# that the test reaches and compile one more file: a third of the time that all tests take to build.
function(moc_of_tests target)
  set_target_properties(${target} PROPERTIES AUTOMOC OFF AUTORCC OFF)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_moc)
  foreach(source ${ARGN})
    get_filename_component(noun ${source} NAME_WE)
    if(source MATCHES "\\.cpp$" AND noun MATCHES "^test_")
      get_filename_component(path ${source} ABSOLUTE)
      qt6_generate_moc(${path} ${folder}/${noun}.moc)
      set_source_files_properties(${path} PROPERTIES OBJECT_DEPENDS ${folder}/${noun}.moc)
      target_include_directories(${target} PRIVATE ${folder})
    endif()
  endforeach()
endfunction()

# Tests are many and each is linked for itself: lld takes a fifth of the time that the usual linker takes, gold a
# quarter. The product is linked by the usual one.
include(CheckLinkerFlag)
foreach(linker lld gold)
  check_linker_flag(CXX -fuse-ld=${linker} MAPWRIGHT_HAS_${linker})
  if(MAPWRIGHT_HAS_${linker})
    set(MAPWRIGHT_TEST_LINKER -fuse-ld=${linker})
    break()
  endif()
endforeach()

# A Qt Test program that runs offscreen under ctest: mapwright_test(name [WITH_DATA] SOURCES ... USES ...
# [LIBRARIES ...]). Only one WITH_DATA knows where this build lies: ccache can take the others from another clone.
# It sees the rooms that it USES and those that they see.
function(mapwright_test name)
  cmake_parse_arguments(TEST "WITH_DATA" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  add_executable(test_${name} ${TEST_SOURCES})
  rooms_within_reach(seen ${TEST_USES})
  foreach(used ${seen})
    target_link_libraries(test_${name} PRIVATE mw_${used})
  endforeach()
  target_link_libraries(test_${name} PRIVATE mw_warnings ${PRELUDE_LIBRARIES_test} ${TEST_LIBRARIES})
  target_compile_options(test_${name} PRIVATE ${MAPWRIGHT_TEST_OPTIONS})
  target_link_options(test_${name} PRIVATE ${MAPWRIGHT_TEST_LINKER})
  take_prelude(test_${name} test)
  moc_of_tests(test_${name} ${TEST_SOURCES})
  if(TEST_WITH_DATA)
    target_compile_definitions(test_${name} PRIVATE MAPWRIGHT_TEST_DATA="${CMAKE_BINARY_DIR}/test-data")
    add_dependencies(test_${name} test_data)
  endif()
  add_test(NAME ${name} COMMAND test_${name})
  set_tests_properties(${name} PROPERTIES
    TIMEOUT 600
    ENVIRONMENT "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/cmake/leaks.supp:print_suppressions=0;QT_QPA_PLATFORM=offscreen;LC_ALL=C.UTF-8;TZ=UTC;XDG_CONFIG_HOME=${CMAKE_BINARY_DIR}/test-home/${name}/config;XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/test-home/${name}/cache;XDG_DATA_HOME=${CMAKE_BINARY_DIR}/test-home/${name}/data")
endfunction()
