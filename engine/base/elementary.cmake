# hazumi_elementary: sin, cos, exp, pow and their like of one make on every machine.
#
# The system's C library takes another routine where the processor has fused multiplication, with
# other last bits. So these are taken out of musl's (MIT licence; package musl-dev), which has one
# routine each for all processors of a kind, and are linked into our programs; the rest stays the
# system's. Functions that are exact by their definition (sqrt, floor, round) need no replacement.
set(HAZUMI_MUSL_LIBRARY "" CACHE FILEPATH "musl's libc.a, for sin, cos and their like")
if(NOT HAZUMI_MUSL_LIBRARY)
  file(GLOB found /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/musl/libc.a
       /usr/lib/*-linux-musl/libc.a /usr/lib/musl/lib/libc.a)
  list(LENGTH found count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "musl's libc.a, for the same sin and cos on every machine: ${count} found; "
            "install musl-dev, or give -DHAZUMI_MUSL_LIBRARY=PATH")
  endif()
  set(HAZUMI_MUSL_LIBRARY ${found} CACHE FILEPATH "musl's libc.a" FORCE)
endif()

set(elementary_objects
    acos acosf asin asinf atan atanf atan2 atan2f cos cosf sin sinf sincos sincosf tan tanf
    exp expf exp2 exp2f expm1 log logf log2 log2f log10 log10f log1p pow powf hypot hypotf cbrt cbrtf
    fmod fmodf remainder remquo sinh cosh tanh
    # What these are made of.
    __sin __cos __tan __sindf __cosdf __tandf __rem_pio2 __rem_pio2f __rem_pio2_large __expo2
    exp_data exp2f_data log_data logf_data log2_data log2f_data pow_data powf_data
    __math_divzero __math_divzerof __math_invalid __math_invalidf __math_oflow __math_oflowf
    __math_uflow __math_uflowf __math_xflow __math_xflowf)
list(TRANSFORM elementary_objects APPEND .lo)
set(elementary_folder ${PROJECT_BINARY_DIR}/elementary)
set(elementary_library ${elementary_folder}/libhazumi_elementary.a)
file(MAKE_DIRECTORY ${elementary_folder})
add_custom_command(
  OUTPUT ${elementary_library}
  COMMAND ${CMAKE_COMMAND} -E rm -f ${elementary_library}
  COMMAND ${CMAKE_AR} x ${HAZUMI_MUSL_LIBRARY} ${elementary_objects}
  COMMAND ${CMAKE_AR} rcsD ${elementary_library} ${elementary_objects}
  DEPENDS ${HAZUMI_MUSL_LIBRARY}
  WORKING_DIRECTORY ${elementary_folder} VERBATIM)
add_custom_target(hazumi_elementary_file DEPENDS ${elementary_library})
add_library(hazumi_elementary INTERFACE)
add_dependencies(hazumi_elementary hazumi_elementary_file)
# For us alone: other libraries in the process keep the system's.
target_link_libraries(hazumi_elementary INTERFACE ${elementary_library})
target_link_options(hazumi_elementary INTERFACE -Wl,--exclude-libs,libhazumi_elementary.a)
