# Run by cpack when all is installed below CPACK_TEMPORARY_DIRECTORY: makes the Debian package of it. The same commit
# gives the same bytes.
set(root ${CPACK_TEMPORARY_DIRECTORY})

function(ask result)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${CPACK_MAPWRIGHT_SOURCES}
    OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${said}" PARENT_SCOPE)
endfunction()

ask(said packaging/version . ${CPACK_PACKAGE_VERSION})
string(REPLACE " " ";" said "${said}")
list(GET said 0 version)
list(GET said 1 epoch)
set(ENV{SOURCE_DATE_EPOCH} ${epoch})
ask(architecture dpkg --print-architecture)

set(maintainer "The mapwright maintainers <maintainers@mapwright.example>")
ask(date date -uR -d @$ENV{SOURCE_DATE_EPOCH})
set(changelog ${root}/usr/share/doc/mapwright/changelog)
file(STRINGS /etc/os-release release REGEX "^VERSION_CODENAME=")
string(REGEX REPLACE ".*=" "" release "${release}")
file(WRITE ${changelog} "mapwright (${version}) ${release}; urgency=medium

  * NEWS.gz beside this file says what is new.

 -- ${maintainer}  ${date}
")
execute_process(COMMAND gzip -9n ${changelog} COMMAND_ERROR_IS_FATAL ANY)

# dpkg-shlibdeps wants a source package around it, and the folder of a package.
file(MAKE_DIRECTORY ${root}/DEBIAN)
set(work ${CPACK_TOPLEVEL_DIRECTORY}/shlibdeps)
file(WRITE ${work}/debian/control "Source: mapwright\n\nPackage: mapwright\nArchitecture: any\n")
execute_process(COMMAND dpkg-shlibdeps -O ${root}/usr/bin/mapwright WORKING_DIRECTORY ${work}
  OUTPUT_VARIABLE libraries OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "shlibs:Depends=" "" libraries "${libraries}")

# As dpkg-gencontrol counts: a file in whole KiB, everything else as one.
file(GLOB_RECURSE entries LIST_DIRECTORIES true RELATIVE ${root} ${root}/usr/*)
set(kib 0)
set(sums)
foreach(entry ${entries})
  set(size 1)
  if(NOT IS_DIRECTORY ${root}/${entry})
    file(SIZE ${root}/${entry} size)
    math(EXPR size "(${size} + 1023) / 1024")
    file(MD5 ${root}/${entry} sum)
    string(APPEND sums "${sum}  ${entry}\n")
  endif()
  math(EXPR kib "${kib} + ${size}")
endforeach()
file(WRITE ${root}/DEBIAN/md5sums "${sums}")
# Qt's plugins for X11, offscreen, SVG and TLS come with its libraries. Beside them: authorities for
# encrypted links, letters in the window, windows under Wayland, a key ring for secrets, names in Chinese, Japanese and
# Korean and emoji; what Qt itself says in Chinese; films of bags.
file(WRITE ${root}/DEBIAN/control "Package: mapwright
Version: ${version}
Architecture: ${architecture}
Maintainer: ${maintainer}
Installed-Size: ${kib}
Depends: ${libraries}
Recommends: ca-certificates, fonts-dejavu-core, qt6-wayland, gnome-keyring | kwalletmanager, fonts-noto-cjk, fonts-noto-color-emoji, qt6-translations-l10n
Suggests: ffmpeg
Section: science
Priority: optional
Description: view and edit the maps of mobile robots
 mapwright shows the maps of mobile robots: live, exact to the cell, with every
 gap marked. It connects to Autoxing and Agibot robots and to ROS 1 and ROS 2
 robots with a rosbridge server, opens maps of map_server, and replays
 recordings (MCAP, bags of ROS 1 and ROS 2). Overlays, waypoints and pictures of
 maps are edited; robots are recorded; maps are compared and exported.
 .
 All of it works in a window and on the command line.
")

# Neither the umask nor when something was checked out or built is to be seen.
execute_process(COMMAND chmod -R u=rwX,go=rX ${root} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND find ${root} -exec touch -hd @$ENV{SOURCE_DATE_EPOCH} {} + COMMAND_ERROR_IS_FATAL ANY)
file(GLOB older ${CPACK_PACKAGE_DIRECTORY}/mapwright_*.deb)
if(older)
  file(REMOVE ${older})
endif()
set(package ${CPACK_PACKAGE_DIRECTORY}/mapwright_${version}_${architecture}.deb)
execute_process(COMMAND dpkg-deb --root-owner-group -Zxz --build ${root} ${package}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(CPACK_EXTERNAL_BUILT_PACKAGES ${package})
