# Headers that most files include, compiled once: a build takes less than half the time. Those of libraries; where the
# sources of a stage are compiled together also the two of ours that nearly every panel and test include, one to three
# seconds each. FEEDSCOPE_PRECOMPILE=OFF shows files that include too little.
option(FEEDSCOPE_PRECOMPILE "Compile the headers of the libraries once" ON)

set(standard_headers <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory>
  <optional> <span> <string> <string_view> <utility> <vector> <Eigen/Core> <Eigen/Geometry>)
set(core_headers ${standard_headers} <charconv> <filesystem> <numbers> <fmt/format.h> <fmt/ranges.h>)
set(scene_headers ${core_headers} <vtkActor.h> <vtkCellArray.h> <vtkNew.h> <vtkPolyData.h> <vtkRenderer.h> <vtkSmartPointer.h>)
set(gui_headers <QColor> <QCoreApplication> <QFont> <QImage> <QLocale> <QObject> <QPainter> <QString> <QStringList> <QVariant>
  <QAbstractTableModel> <QJsonArray> <QJsonDocument> <QJsonObject> <QRegularExpression> <QTimer>)
set(widget_headers ${gui_headers} <QAction> <QApplication> <QComboBox> <QFileDialog> <QHeaderView> <QKeyEvent> <QLabel>
  <QMainWindow> <QMenu> <QMouseEvent> <QPushButton> <QSettings> <QTableView> <QToolBar> <QToolButton> <QVBoxLayout> <QWidget>)
set(test_headers ${standard_headers} <fmt/format.h> <gmock/gmock.h> <gtest/gtest.h>)
if(FEEDSCOPE_UNITY)
  list(APPEND widget_headers <ui/workbench/workbench.h>)
  list(APPEND test_headers <core/analysis/run/run.h>)
endif()

# A target that only compiles headers, for those that feedscope_use_precompiled() names; OPTIONS: of the compiler, the
# same as theirs.
function(feedscope_precompile name)
  cmake_parse_arguments(arg "" "" "HEADERS;LIBRARIES;OPTIONS" ${ARGN})
  if(FEEDSCOPE_PRECOMPILE)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE feedscope_settings ${arg_LIBRARIES})
    target_compile_options(${name} PRIVATE ${arg_OPTIONS})
    target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  endif()
endfunction()

# feedscope_use_precompiled(NAME TARGETS...)
function(feedscope_use_precompiled name)
  if(FEEDSCOPE_PRECOMPILE)
    foreach(target ${ARGN})
      target_precompile_headers(${target} REUSE_FROM ${name})
    endforeach()
  endif()
endfunction()
