# What `cmake --install` puts in place: the programs with their man page and completion, and the
# library as headers, static libraries, a CMake package and a pkg-config file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/millwear)
set(header_folder ${CMAKE_INSTALL_INCLUDEDIR}/millwear)

if(MILLWEAR_SANITIZE)
  install(CODE "message(FATAL_ERROR \"a build with sanitizers is not installed: a program that links \
its library would need them too; install build/release\")")
endif()

install(TARGETS millwear millwear-recorder RUNTIME)

# Headers that know another library than Eigen are for our own sources.
set(private_headers versioned_json number_or_null gsl_status hdf5_file hdf5_reader hdf5_writer number_type)
list(TRANSFORM private_headers APPEND "\\.h$")
list(JOIN private_headers "|" private_headers)

foreach(component mill wear meshgen)
  add_library(millwear::${component} ALIAS millwear_${component})
  set_target_properties(millwear_${component} PROPERTIES EXPORT_NAME ${component})
  target_include_directories(millwear_${component} INTERFACE $<INSTALL_INTERFACE:${header_folder}>)
  install(TARGETS millwear_${component} EXPORT millwear-${component} ARCHIVE)
  install(EXPORT millwear-${component} NAMESPACE millwear:: DESTINATION ${package_folder})
  install(DIRECTORY ${component} DESTINATION ${header_folder} FILES_MATCHING PATTERN "*.h"
    PATTERN bench EXCLUDE REGEX "/(${private_headers})" EXCLUDE)
endforeach()

configure_package_config_file(cmake/millwearConfig.cmake.in millwearConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(millwearConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/millwearConfig.cmake ${PROJECT_BINARY_DIR}/millwearConfigVersion.cmake
  cmake/FindGmsh.cmake DESTINATION ${package_folder})

# The prefix is found from where the file lies, so that an installed tree can be moved.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
  OUTPUT_VARIABLE PREFIX_FROM_PKGCONFIG)
configure_file(cmake/millwear.pc.in millwear.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/millwear.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# Both pages are made from what the program itself says to --help.
set(page_script ${PROJECT_SOURCE_DIR}/scripts/command_pages.sh)
set(pages "")
foreach(page man completion)
  set(file ${PROJECT_BINARY_DIR}/pages/${page})
  add_custom_command(OUTPUT ${file} COMMAND ${CMAKE_COMMAND} -E make_directory pages
    COMMAND sh ${page_script} ${page} $<TARGET_FILE:millwear> > ${file}
    DEPENDS millwear ${page_script} VERBATIM)
  list(APPEND pages ${file})
endforeach()
add_custom_target(millwear_pages ALL DEPENDS ${pages})
install(FILES ${PROJECT_BINARY_DIR}/pages/man RENAME millwear.1
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/pages/completion RENAME millwear
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
