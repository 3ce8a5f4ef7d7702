# Everything outside the project, found once. The list of Debian packages is share/debian-packages.txt;
# the installed package finds what its libraries need again through this file.
include(CMakeFindDependencyMacro)
if(NOT CMAKE_FIND_PACKAGE_NAME)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)  # a project that adds this one by add_subdirectory links them too
endif()
macro(bslnav_find)
  if(CMAKE_FIND_PACKAGE_NAME)
    find_dependency(${ARGN})
  else()
    find_package(${ARGN} REQUIRED)
  endif()
endmacro()

foreach(component IN ITEMS config containers kinematics maps math obs random slam system)
  bslnav_find(mrpt-${component})
endforeach()
bslnav_find(OpenCV COMPONENTS core imgproc imgcodecs)
bslnav_find(embree 3)
bslnav_find(nlohmann_json)
if(NOT CMAKE_FIND_PACKAGE_NAME)
  bslnav_find(CLI11)  # the programs only
endif()

# Debian's Embree and OpenCV configurations define no usable interface targets of their own.
if(NOT TARGET bslnav::embree)
  add_library(bslnav::embree INTERFACE IMPORTED GLOBAL)
  target_link_libraries(bslnav::embree INTERFACE embree)
endif()
if(NOT TARGET bslnav::opencv)
  add_library(bslnav::opencv INTERFACE IMPORTED GLOBAL)
  target_link_libraries(bslnav::opencv INTERFACE opencv_core opencv_imgproc opencv_imgcodecs)
  target_include_directories(bslnav::opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
endif()
