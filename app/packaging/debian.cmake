# The Debian package: `scripts/package` sets HAZUMI_DEBIAN, builds, and has CPack make it. With it
# go what Debian wants besides: a compressed manual page, its own folder for zsh, changelogs.

# Lower than any release of Debian's own, of which the first ends in -1.
set(HAZUMI_PACKAGE_RELEASE 0hazumi1)
set(HAZUMI_MAINTAINER "" CACHE STRING "who makes the package: Name <address>")
if(HAZUMI_DEBIAN)
  if(NOT HAZUMI_MAINTAINER MATCHES "^[^<>]+ <[^<>@ ]+@[^<>@ ]+>$")
    message(FATAL_ERROR "HAZUMI_MAINTAINER: say who makes the package, as \"Name <address>\"")
  endif()
  function(hazumi_compressed source name folder)
    add_custom_command(OUTPUT ${made}/${name}.gz DEPENDS ${source} VERBATIM
                       COMMAND gzip -9nc ${source} > ${made}/${name}.gz)
    add_custom_target(hazumi_${name} ALL DEPENDS ${made}/${name}.gz)
    install(FILES ${made}/${name}.gz DESTINATION ${folder})
  endfunction()
  # Of the package's own changelog: the time is that of the commit, or now.
  string(TIMESTAMP HAZUMI_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
  configure_file(changelog.in ${made}/changelog @ONLY)
  hazumi_compressed(${made}/hazumi.1 hazumi.1 share/man/man1)
  hazumi_compressed(${made}/changelog changelog.Debian share/doc/hazumi)
  hazumi_compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog share/doc/hazumi)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hazumi)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${HAZUMI_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "animation editor whose limbs swing by their own inertia")
set(CPACK_PACKAGE_DESCRIPTION
"Hazumi is an editor for keyframe animation in which a stretch of time and a
set of joints can be marked as a dynamics region. There the joints swing by
their own inertia, started by the speed that the keys gave them. A pinned
joint, or gravity and contact, places the figure in the world.

It reads characters from BVH, FBX, glTF and Collada files, writes motion as
glTF, BVH, CSV, JSON, pictures or video, and does all that without a display
as well.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${HAZUMI_PACKAGE_RELEASE})
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# What is linked, as dpkg-shlibdeps finds it, and what is loaded by its name: pictures need OSMesa;
# the editor does without sound and with the letters that there are.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS libosmesa6)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, fonts-dejavu-core, fonts-noto-cjk, libopenal1")
include(CPack)
