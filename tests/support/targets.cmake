# What tests share: hazumi_test_support, and hazumi_test_mujoco where MuJoCo is installed.
include_guard(GLOBAL)

set(_support ${CMAKE_CURRENT_LIST_DIR})

add_library(hazumi_test_support STATIC ${_support}/arm7_cases.cpp ${_support}/data_folder.cpp
            ${_support}/dense_dynamics.cpp ${_support}/figures.cpp ${_support}/free_figure.cpp
            ${_support}/multipliers.cpp ${_support}/path.cpp ${_support}/random.cpp
            ${_support}/random_tree.cpp)
target_link_libraries(hazumi_test_support PUBLIC hazumi_engine GTest::gtest PRIVATE hazumi_flags)
target_compile_definitions(hazumi_test_support PRIVATE HAZUMI_SOURCE_DIR="${PROJECT_SOURCE_DIR}")

find_library(MUJOCO_LIBRARY mujoco)
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
if(MUJOCO_LIBRARY AND MUJOCO_INCLUDE_DIR)
  add_library(hazumi_test_mujoco STATIC ${_support}/mujoco_figure.cpp ${_support}/sample.cpp)
  target_include_directories(hazumi_test_mujoco SYSTEM PRIVATE ${MUJOCO_INCLUDE_DIR})
  target_link_libraries(hazumi_test_mujoco PUBLIC hazumi_test_support ${MUJOCO_LIBRARY}
                        PRIVATE hazumi_flags)
else()
  message(STATUS "MuJoCo not found: the tests against it are left out")
endif()
