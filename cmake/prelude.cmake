# Precompiled headers of the libraries that nearly every file reads (Eigen and Qt cost more time than our own code):
# measured, they halve the time of a full build. No header of ours is in them, so the walls between the rooms stand.
# Each kind is compiled once; a target takes the widest kind whose libraries it links.

set(PRELUDE_plain
  <algorithm> <array> <atomic> <cmath> <cstdint> <cstdio> <cstring> <functional> <map> <memory> <mutex> <optional>
  <set> <span> <string> <string_view> <thread> <unordered_map> <utility> <variant> <vector> <Eigen/Geometry>
  <tl/expected.hpp>)
set(PRELUDE_core ${PRELUDE_plain}
  <QByteArray> <QDateTime> <QDir> <QFile> <QJsonArray> <QJsonDocument> <QJsonObject> <QMetaObject> <QObject>
  <QPointer> <QString> <QStringList> <QTimer> <QUrl>)
set(PRELUDE_widgets ${PRELUDE_core}
  <QAction> <QApplication> <QGraphicsItem> <QGraphicsView> <QImage> <QKeyEvent> <QLabel> <QLineEdit> <QMainWindow>
  <QPainter> <QPainterPath> <QPushButton> <QSettings> <QStyle> <QToolButton> <QVBoxLayout>)
# How long tests wait is the one thing of ours in it.
set(PRELUDE_test ${PRELUDE_widgets} <QtTest> <QTcpServer> <test_timeouts.h>)

set(PRELUDE_LIBRARIES_plain PkgConfig::EIGEN)
set(PRELUDE_LIBRARIES_core ${PRELUDE_LIBRARIES_plain} Qt6::Core)
set(PRELUDE_LIBRARIES_widgets ${PRELUDE_LIBRARIES_core} Qt6::Widgets)
set(PRELUDE_LIBRARIES_test ${PRELUDE_LIBRARIES_widgets} Qt6::Network Qt6::Test)
set(PRELUDE_FOLDERS_test ${PROJECT_SOURCE_DIR}/tests)

# Qt Test defines the folder of every test on its command line, and a precompiled header that has seen one folder is
# refused in the next. Our tests find their data by MAPWRIGHT_TEST_DATA.
set_target_properties(Qt6::Test PROPERTIES INTERFACE_COMPILE_DEFINITIONS QT_TESTLIB_LIB)
# Since Qt 6.8 its macros that wait (QTRY_VERIFY) make an int of a long.
if(Qt6_VERSION VERSION_GREATER_EQUAL 6.8)
  set_property(TARGET Qt6::Test APPEND PROPERTY INTERFACE_COMPILE_OPTIONS -Wno-conversion)
endif()

file(WRITE ${CMAKE_BINARY_DIR}/prelude.cpp.in "")
configure_file(${CMAKE_BINARY_DIR}/prelude.cpp.in ${CMAKE_BINARY_DIR}/prelude.cpp COPYONLY)

# Tests are compiled without optimising: half of the time that it takes to build them, and what they test is optimised.
set(MAPWRIGHT_TEST_OPTIONS -O0)

# g++ compiles with the optimisation of the precompiled header, whatever its command line says: each level has a header
# of its own. Without levels (sanitizers, coverage) there is one of each kind.
function(take_prelude target kind optimize)
  set(prelude mw_prelude_${kind})
  set(options)
  if(kind STREQUAL "test")
    set(options ${MAPWRIGHT_TEST_OPTIONS})
  elseif(CMAKE_BUILD_TYPE STREQUAL "Release")
    set(prelude ${prelude}_O${optimize})
    set(options -O${optimize})
  endif()
  if(NOT TARGET ${prelude})
    add_library(${prelude} OBJECT ${CMAKE_BINARY_DIR}/prelude.cpp)
    target_link_libraries(${prelude} PRIVATE mw_warnings ${PRELUDE_LIBRARIES_${kind}})
    target_compile_options(${prelude} PRIVATE ${options})
    target_include_directories(${prelude} PRIVATE ${PRELUDE_FOLDERS_${kind}})
    target_precompile_headers(${prelude} PRIVATE ${PRELUDE_${kind}})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${prelude})
endfunction()
