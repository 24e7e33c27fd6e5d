# What tests share: hazumi_test_support, and hazumi_test_mujoco and hazumi_test_simbody where those
# programs are installed.
include_guard(GLOBAL)

set(_support ${CMAKE_CURRENT_LIST_DIR})

add_library(hazumi_test_support STATIC ${_support}/arm7_cases.cpp ${_support}/data_folder.cpp
            ${_support}/dense_dynamics.cpp ${_support}/figures.cpp ${_support}/free_figure.cpp
            ${_support}/path.cpp ${_support}/random.cpp
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

find_package(Simbody QUIET)
if(Simbody_FOUND)
  set(_bench ${_support}/../bench)
  add_library(hazumi_test_simbody_tree OBJECT ${_bench}/simbody_tree.cpp)
  set_target_properties(hazumi_test_simbody_tree PROPERTIES CXX_STANDARD 17 UNITY_BUILD OFF)
  # Debian's Simbody is built without NDEBUG, on which the layout of its states depends.
  target_compile_options(hazumi_test_simbody_tree PRIVATE -UNDEBUG)
  target_include_directories(hazumi_test_simbody_tree SYSTEM PRIVATE ${Simbody_INCLUDE_DIR})
  target_link_libraries(hazumi_test_simbody_tree PRIVATE hazumi_engine hazumi_flags)
  add_library(hazumi_test_simbody STATIC $<TARGET_OBJECTS:hazumi_test_simbody_tree>
              ${_bench}/peer_joints.cpp ${_bench}/simbody_bodies.cpp)
  target_link_libraries(hazumi_test_simbody PUBLIC hazumi_engine ${Simbody_LIBRARIES}
                        PRIVATE hazumi_flags)
else()
  message(STATUS "Simbody not found: the tests against it are left out")
endif()
