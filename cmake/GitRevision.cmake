# Writes a source with the git revision of the checkout, at build time. The source is left alone
# where nothing changed, so nothing is compiled again.
#   cmake -DSOURCE=checkout -DTEMPLATE=version.cpp.in -DOUTPUT=version.cpp -DPROJECT_VERSION=0.1.0
#         -P GitRevision.cmake
# A folder that is no checkout of its own (a release's archive, even inside another repository) has
# the revision "unknown".
cmake_minimum_required(VERSION 3.25)
set(GIT_COMMIT unknown)
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH ${SOURCE} source)
  if(top STREQUAL source)
    execute_process(COMMAND ${GIT} rev-parse --short HEAD WORKING_DIRECTORY ${SOURCE}
      OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(revision)
      set(GIT_COMMIT ${revision})
    endif()
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
