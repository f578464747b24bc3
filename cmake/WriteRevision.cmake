# Run at every build: cmake -DSOURCE=<dir> -DHEADER=<file> -P WriteRevision.cmake. The header is touched only when
# the revision is another one, so that nothing is compiled again without a reason.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 OUTPUT_VARIABLE revision
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(revision unknown)
endif()
set(content "#define SANDGRAPH_REVISION \"${revision}\"\n")
set(old "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} old)
endif()
if(NOT content STREQUAL old)
  file(WRITE ${HEADER} "${content}")
endif()
