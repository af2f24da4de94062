# cmake --install and find_package(drapeau): the headers, the programs, their shaders and assets.
include(CMakePackageConfigHelpers)

install(TARGETS drapeau_core EXPORT drapeau)
install(DIRECTORY include/drapeau DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT drapeau NAMESPACE drapeau:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/drapeau FILE drapeau-targets.cmake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/drapeau-config-version.cmake COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)
file(WRITE ${PROJECT_BINARY_DIR}/drapeau-config.cmake
  "include(CMakeFindDependencyMacro)\nfind_dependency(glm)\nfind_dependency(Threads)\n"
  "include(\${CMAKE_CURRENT_LIST_DIR}/drapeau-targets.cmake)\n")
install(FILES ${PROJECT_BINARY_DIR}/drapeau-config.cmake ${PROJECT_BINARY_DIR}/drapeau-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/drapeau)

if(DRAPEAU_PROGRAMS)
  install(TARGETS drapeau-lab)
  install(DIRECTORY assets DESTINATION ${CMAKE_INSTALL_DATADIR}/drapeau)
endif()
if(DRAPEAU_VIEWER)
  install(TARGETS drapeau)
  install(DIRECTORY shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/drapeau)
endif()
