# Installs the data and a package configuration, so that find_package(bslnav) gives bslnav::<library>.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bslnav)
write_basic_package_version_file(bslnavConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT bslnavTargets NAMESPACE bslnav:: DESTINATION ${package_dir})
if(TARGET bslnav::mvsim)  # of its own, because it needs what others need not have
  install(EXPORT bslnavMvsimTargets NAMESPACE bslnav:: DESTINATION ${package_dir})
endif()
install(FILES cmake/bslnavConfig.cmake cmake/BslnavDependencies.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/bslnavConfigVersion.cmake DESTINATION ${package_dir})
install(DIRECTORY config maps DESTINATION ${CMAKE_INSTALL_DATADIR}/bslnav)
