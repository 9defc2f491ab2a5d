# What `cmake --install` and the Debian package hold. The package is made by deploy/package.sh.
include(GNUInstallDirs)

install(TARGETS floeplan RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY web/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/floeplan/web OPTIONAL)
install(PROGRAMS deploy/backup.sh deploy/restore.sh DESTINATION ${CMAKE_INSTALL_DATADIR}/floeplan)
install(DIRECTORY api/examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/floeplan/examples USE_SOURCE_PERMISSIONS OPTIONAL
  PATTERN __pycache__ EXCLUDE)
install(FILES README.md SECURITY.md deploy/nginx.conf deploy/Caddyfile deploy/alerts.yaml
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY web/guide DESTINATION ${CMAKE_INSTALL_DOCDIR}/web FILES_MATCHING PATTERN *.md PATTERN *.png)
install(FILES web/reproduced_figure_7.svg web/reproduced_figure_9.svg DESTINATION ${CMAKE_INSTALL_DOCDIR}/web)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES deploy/floeplan.service deploy/floeplan-worker.service deploy/floeplan-backup.service deploy/floeplan-backup.timer
  DESTINATION lib/systemd/system)
install(FILES deploy/debian/default DESTINATION /etc/default RENAME floeplan)
install(FILES deploy/debian/worker-default DESTINATION /etc/default RENAME floeplan-worker)
# What the program says of itself follows from its commands: it writes man pages and completions itself.
install(CODE "
  set(share \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\")
  execute_process(COMMAND \"$<TARGET_FILE:floeplan>\" write-manual \"\${share}\" COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB pages \"\${share}/man/man1/floeplan*.1\")
  execute_process(COMMAND gzip -9nf \${pages} COMMAND_ERROR_IS_FATAL ANY)")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME floeplan)
set(CPACK_PACKAGE_CONTACT "the Floeplan maintainers <floeplan@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Mission planning for underwater gliders in and under ice")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "adduser")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core, gmt-gshhg-full")
file(WRITE ${PROJECT_BINARY_DIR}/conffiles "/etc/default/floeplan\n/etc/default/floeplan-worker\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  ${PROJECT_SOURCE_DIR}/deploy/debian/postinst
  ${PROJECT_SOURCE_DIR}/deploy/debian/prerm
  ${PROJECT_SOURCE_DIR}/deploy/debian/postrm
  ${PROJECT_BINARY_DIR}/conffiles)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
