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

foreach(component IN ITEMS comms config containers hwdrivers kinematics maps math nav obs opengl random slam system)
  bslnav_find(mrpt-${component})
endforeach()
bslnav_find(OpenCV COMPONENTS core imgproc imgcodecs)
bslnav_find(embree 3)
bslnav_find(PCL COMPONENTS common filters kdtree search segmentation)
bslnav_find(TBB)
bslnav_find(nlohmann_json)
if(NOT CMAKE_FIND_PACKAGE_NAME)
  bslnav_find(CLI11)  # the programs only
  set(MPI_CXX_SKIP_MPICXX ON)  # the C interface is enough
  bslnav_find(MPI COMPONENTS CXX)
endif()

# Debian's Embree, OpenCV and PCL configurations define no usable interface targets of their own.
if(NOT TARGET bslnav::embree)
  add_library(bslnav::embree INTERFACE IMPORTED GLOBAL)
  target_link_libraries(bslnav::embree INTERFACE embree)
endif()
if(NOT TARGET bslnav::opencv)
  add_library(bslnav::opencv INTERFACE IMPORTED GLOBAL)
  target_link_libraries(bslnav::opencv INTERFACE opencv_core opencv_imgproc opencv_imgcodecs)
  target_include_directories(bslnav::opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
endif()
if(NOT TARGET bslnav::pcl)  # its own targets bring all of VTK
  add_library(bslnav::pcl INTERFACE IMPORTED GLOBAL)
  target_link_libraries(bslnav::pcl INTERFACE pcl_common pcl_filters pcl_kdtree pcl_search pcl_segmentation)
  target_include_directories(bslnav::pcl SYSTEM INTERFACE ${PCL_INCLUDE_DIRS})
endif()
