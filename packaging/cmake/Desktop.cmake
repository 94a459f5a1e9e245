# What a desktop and a shell know of the program: menu entry, icon, file types, software centre, man page, completion.
set(FEEDSCOPE_HOMEPAGE "https://feedscope.example" CACHE STRING "Where the project is published; its pictures stand in /images")

set(desktop ${PROJECT_SOURCE_DIR}/packaging/desktop)
set(FEEDSCOPE_ID org.feedscope.Feedscope)
configure_file(${desktop}/${FEEDSCOPE_ID}.metainfo.xml.in ${PROJECT_BINARY_DIR}/${FEEDSCOPE_ID}.metainfo.xml @ONLY)
install(FILES ${desktop}/${FEEDSCOPE_ID}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/${FEEDSCOPE_ID}.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${PROJECT_BINARY_DIR}/${FEEDSCOPE_ID}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${PROJECT_SOURCE_DIR}/resources/icons/feedscope.svg
  DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps RENAME ${FEEDSCOPE_ID}.svg)

# Written by the program itself, from the options that its parser knows.
set(shell_dir ${PROJECT_BINARY_DIR}/shell)
set(man_page ${shell_dir}/feedscope.1.gz)
set(run ${CMAKE_COMMAND} -E env FEEDSCOPE_DATA=${PROJECT_SOURCE_DIR} $<TARGET_FILE:feedscope>)
set(completions)
foreach(shell bash zsh fish)
  list(APPEND completions ${shell_dir}/completion.${shell})
  list(APPEND write_completions COMMAND ${run} help --completion ${shell} --out ${shell_dir}/completion.${shell})
endforeach()
add_custom_command(OUTPUT ${man_page} ${completions}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${shell_dir}
  COMMAND ${run} help --man --out ${shell_dir}/feedscope.1
  COMMAND gzip -9nf ${shell_dir}/feedscope.1
  ${write_completions}
  DEPENDS feedscope
  COMMENT "Writing man page and completions")
add_custom_target(feedscope_shell ALL DEPENDS ${man_page} ${completions})
install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${shell_dir}/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME feedscope)
install(FILES ${shell_dir}/completion.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions RENAME _feedscope)
install(FILES ${shell_dir}/completion.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d RENAME feedscope.fish)
