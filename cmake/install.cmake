# What `cmake --install` puts where. Programs and libraries find their data from where they lie, so the
# prefix can be moved.
#
#   bin/pineda
#   lib/           libpineda_golden, libpineda_tb, archives of the SystemC model; cmake/, pkgconfig/
#   lib/pineda/    built RTL plug-ins, what writes a design's package
#   include/pineda golden.h; headers as they lie in the sources, from model/ and tb/ on
#   share/pineda/  rtl/, tb/, dpi/, vectors/, studies/ as in the sources
#   share/doc/     documentation, examples
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(private ${CMAKE_INSTALL_LIBDIR}/pineda)
set(data ${CMAKE_INSTALL_DATADIR}/pineda)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/pineda)

# What must be built before an install; `cmake --build build` builds it too.
add_custom_target(product DEPENDS pineda_golden)

# The C interface.
install(TARGETS pineda_golden EXPORT pineda-golden LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES golden/include/pineda/golden.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pineda)
set_target_properties(pineda_golden PROPERTIES EXPORT_NAME golden)
configure_file(cmake/pineda-golden.pc.in pineda-golden.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pineda-golden.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(components golden)

if(PINEDA_RTL)
  # The program, and what it builds RTL with.
  add_dependencies(product pineda emit_package)
  install(TARGETS pineda RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(TARGETS emit_package RUNTIME DESTINATION ${private})
  # Designs of which no plug-in is built yet are verilated when they are first asked for.
  install(DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/ DESTINATION ${private}
          FILES_MATCHING PATTERN "pineda_rtl_*.so")
  install(DIRECTORY rtl DESTINATION ${data}
          FILES_MATCHING PATTERN "*.sv" PATTERN "*.f" PATTERN "*.vlt" PATTERN "*.core")
  file(GLOB plugin_sources CONFIGURE_DEPENDS tb/*plugin.*)
  install(FILES ${plugin_sources} DESTINATION ${data}/tb)
  install(DIRECTORY model/spec DESTINATION ${data}/model FILES_MATCHING PATTERN "*.h")
  install(DIRECTORY studies/area/technologies DESTINATION ${data}/studies/area)
  install(DIRECTORY studies/run/page DESTINATION ${data}/studies/run)
  install(DIRECTORY studies/netlist studies/score DESTINATION ${data}/studies
          FILES_MATCHING PATTERN "*.sv" PATTERN "*.v")
  install(DIRECTORY vectors/setup vectors/traversal vectors/interp_ztest vectors/frame vectors/mutants
          DESTINATION ${data}/vectors)
  install(FILES vectors/testplan.hjson DESTINATION ${data}/vectors)
  install(FILES vectors/coverage/code_waivers.toml DESTINATION ${data}/vectors/coverage)

  install(DIRECTORY golden/dpi DESTINATION ${data})

  # The SystemC modules, and what they are made of.
  set(archives pineda_timing pineda_counters pineda_fast pineda_memory pineda_core pineda_spec)
  add_dependencies(product ${archives})
  install(TARGETS ${archives} EXPORT pineda-timing ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set_target_properties(pineda_timing PROPERTIES EXPORT_NAME timing)
  foreach(folder IN ITEMS spec core fast memory timing files)
    install(DIRECTORY model/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pineda/model
            FILES_MATCHING PATTERN "*.h")
  endforeach()

  # The benches of the RTL. Shared, so that they find plug-ins and sources from where the library lies.
  add_library(pineda_tb_shared SHARED)
  target_sources(pineda_tb_shared PRIVATE cmake/empty.cpp)
  target_link_libraries(pineda_tb_shared PRIVATE
    -Wl,--whole-archive pineda_tb pineda_counters pineda_memory pineda_core pineda_spec pineda_files
    -Wl,--no-whole-archive)
  target_link_libraries(pineda_tb_shared PUBLIC fmt::fmt)
  target_include_directories(pineda_tb_shared INTERFACE
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/pineda>)
  set_target_properties(pineda_tb_shared PROPERTIES
    OUTPUT_NAME pineda_tb EXPORT_NAME tb VERSION ${PROJECT_VERSION} SOVERSION 0)
  add_dependencies(product pineda_tb_shared)
  install(TARGETS pineda_tb_shared EXPORT pineda-tb LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY tb DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pineda FILES_MATCHING PATTERN "*.h")
  list(APPEND components timing tb)
endif()

# The CMake package: a file of targets for each component.
foreach(component IN LISTS components)
  install(EXPORT pineda-${component} NAMESPACE pineda:: DESTINATION ${package})
endforeach()
configure_package_config_file(cmake/pineda-config.cmake.in pineda-config.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(pineda-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pineda-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/pineda-config-version.cmake DESTINATION ${package})

install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples/installed/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)

# The Debian package of all this.
configure_file(cmake/deb.cmake.in deb.cmake @ONLY)
