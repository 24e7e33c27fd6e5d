# The pages to read, below share/doc/hazumi: README.md, examples/README.md and sweeps.md, with the
# pictures that they show. What a checkout alone has (how it is built, measured, changed) is left out,
# and so are links to it.
set(doc share/doc/hazumi)

# Reads a page of the tree into `variable`.
function(hazumi_read_page name variable)
  set(source ${PROJECT_SOURCE_DIR}/${name})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} text)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# Replaces in a page what has to be there.
function(hazumi_replace variable was is)
  string(FIND "${${variable}}" "${was}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "pages.cmake: the ${variable} page has no \"${was}\"")
  endif()
  string(REPLACE "${was}" "${is}" text "${${variable}}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# Takes out a page's part from where `first` stands on and before `next`, or to its end.
function(hazumi_leave_out variable first)
  string(FIND "${${variable}}" "${first}" begin)
  string(LENGTH "${${variable}}" end)
  if(ARGC GREATER 2)
    string(FIND "${${variable}}" "${ARGV2}" end)
  endif()
  if(begin EQUAL -1 OR end LESS begin)
    message(FATAL_ERROR "pages.cmake: the ${variable} page has no \"${first}\" before \"${ARGV2}\"")
  endif()
  string(SUBSTRING "${${variable}}" 0 ${begin} before)
  string(SUBSTRING "${${variable}}" ${end} -1 after)
  set(${variable} "${before}${after}" PARENT_SCOPE)
endfunction()

hazumi_read_page(README.md readme)
hazumi_leave_out(readme "## Two commands" "## The examples")
hazumi_leave_out(readme "## Fast and accurate")
hazumi_replace(readme "`assets/examples/" "`share/hazumi/examples/")
hazumi_replace(readme "`assets/schema/" "`share/hazumi/schema/")
hazumi_replace(readme "[assets/examples/README.md](assets/examples/README.md)"
               "[examples/README.md](examples/README.md)")
hazumi_replace(readme "[engine/sweep/README.md](engine/sweep/README.md)" "[sweeps.md](sweeps.md)")
hazumi_replace(readme "(assets/pictures/" "(pictures/")
hazumi_replace(readme "; `scripts/farm` does it on a Slurm cluster" "")
file(WRITE ${made}/pages/README.md "${readme}MIT licence: `copyright`.\n")

hazumi_read_page(assets/examples/README.md examples)
hazumi_replace(examples "Copy one beside the others (its figure's path is relative to it) and change its keys."
               "They lie in `share/hazumi/examples`. Copy one anywhere and change its keys.")
hazumi_replace(examples " (`scripts/tour` does all of this by operators, and with\n`--window` by mouse and keys.)" "")
hazumi_replace(examples "Jumps (which ones: `engine/analysis/README.md`) are" "Jumps are")
file(WRITE ${made}/pages/examples/README.md "${examples}")

hazumi_read_page(engine/sweep/README.md sweeps)
hazumi_replace(sweeps "(`engine/project/address`)" "(`hazumi --fields FILE`)")
hazumi_leave_out(sweeps "    sweep file --LoadSweep" "```\n{")
hazumi_replace(sweeps "`quantity` (quantities.h; `hazumi --quantities`)" "`quantity` (`hazumi --quantities`)")
hazumi_leave_out(sweeps "May include:")
hazumi_replace(sweeps "# sweep: variations of one project" "# Sweeps: variations of one project")
file(WRITE ${made}/pages/sweeps.md "${sweeps}All fields: `share/hazumi/schema/sweep.schema.json`. An example: `share/hazumi/examples/throw_sweep.json`.\n")

install(FILES ${made}/pages/README.md ${made}/pages/sweeps.md DESTINATION ${doc})
install(FILES ${made}/pages/examples/README.md DESTINATION ${doc}/examples)
# Those that the pages show.
string(REGEX MATCHALL "pictures/[a-z0-9_]+\\.(jpg|png)" shown "${readme}${examples}${sweeps}")
list(REMOVE_DUPLICATES shown)
foreach(picture ${shown})
  install(FILES ${assets}/${picture} DESTINATION ${doc}/pictures)
endforeach()
