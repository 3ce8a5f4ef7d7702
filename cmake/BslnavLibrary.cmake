# bslnav_add_library(<name> USES <lower libraries> LINKS <outside targets> [PRIVATE_LINKS <outside targets>])
#
# Adds libs/<name> as target bslnav::<name>: headers include/bslnav/<name>/*.h, sources src/*.cpp.
# The direction of the house is enforced here: a library sees only the libraries it names under USES,
# and may name only those that BSLNAV_MAY_USE_<name> (libs/CMakeLists.txt) allows.
set(BSLNAV_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(BSLNAV_WARNINGS_AS_ERRORS)
  list(APPEND BSLNAV_WARNINGS -Werror)
endif()

function(bslnav_add_library name)
  cmake_parse_arguments(ARG "" "" "USES;LINKS;PRIVATE_LINKS" ${ARGN})
  foreach(used IN LISTS ARG_USES)
    if(NOT used IN_LIST BSLNAV_MAY_USE_${name})
      message(FATAL_ERROR "libs/${name} may not use libs/${used}: allowed are '${BSLNAV_MAY_USE_${name}}'")
    endif()
  endforeach()
  file(GLOB headers CONFIGURE_DEPENDS include/bslnav/${name}/*.h)
  file(GLOB sources CONFIGURE_DEPENDS src/*.cpp)
  if(NOT sources)  # INTERIM
    return()
  endif()
  add_library(${name} ${sources})
  add_library(bslnav::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES OUTPUT_NAME bslnav_${name} VERSION ${PROJECT_VERSION}
                                           SOVERSION ${PROJECT_VERSION_MAJOR})
  target_sources(${name} PUBLIC FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  list(TRANSFORM ARG_USES PREPEND bslnav::)
  target_link_libraries(${name} PUBLIC ${ARG_USES} ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  target_compile_features(${name} PUBLIC cxx_std_17)
  target_compile_options(${name} PRIVATE ${BSLNAV_WARNINGS})
  install(TARGETS ${name} EXPORT bslnavTargets FILE_SET HEADERS)
endfunction()
