# Writes commit.cpp if what it says has changed. Run at each build:
#   cmake -DSOURCE=top of the tree -DOUTPUT=commit.cpp -P commit.cmake
# The commit is git's, where the tree is a git repository itself (not a folder in another one), else
# that of commit.txt, which `git archive` fills in, else "unknown".

set(HAZUMI_COMMIT "")
find_program(git git NO_CACHE)
unset(ENV{GIT_DIR})  # of another repository, if one of its hooks builds this
if(git AND EXISTS ${SOURCE}/.git)
  execute_process(
    COMMAND ${git} --no-optional-locks -C ${SOURCE} describe --always --abbrev=7 --dirty=+ --exclude=*
    OUTPUT_VARIABLE HAZUMI_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT HAZUMI_COMMIT MATCHES "^[0-9a-f]+[+]?$")
  file(READ ${CMAKE_CURRENT_LIST_DIR}/commit.txt HAZUMI_COMMIT)
  string(STRIP "${HAZUMI_COMMIT}" HAZUMI_COMMIT)
endif()
if(NOT HAZUMI_COMMIT MATCHES "^[0-9a-f]+[+]?$")
  set(HAZUMI_COMMIT unknown)
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/commit.cpp.in ${OUTPUT} @ONLY)
