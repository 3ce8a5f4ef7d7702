include("${CMAKE_CURRENT_LIST_DIR}/BslnavDependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/bslnavTargets.cmake")
