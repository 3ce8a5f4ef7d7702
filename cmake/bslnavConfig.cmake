include("${CMAKE_CURRENT_LIST_DIR}/BslnavDependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/bslnavTargets.cmake")

# The MVSim adapter, where bslnav was installed with it and MVSim is found.
if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/bslnavMvsimTargets.cmake")
  find_package(mvsim-simulator QUIET)
  if(mvsim-simulator_FOUND)
    include("${CMAKE_CURRENT_LIST_DIR}/bslnavMvsimTargets.cmake")
  endif()
endif()
