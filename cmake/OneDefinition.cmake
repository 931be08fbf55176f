# Links the libraries' objects into one, only to see that no two types have one name: -Wodr compares
# them across all sources, which neither a compiler nor an ordinary linker does.
set(libraries millwear_mill millwear_meshgen millwear_liggghts_inputs millwear_wear millwear_deck_lines
  millwear_orchestrator)
set(objects "")
foreach(library ${libraries})
  # The objects hold both code, which the programs are linked from, and what -Wodr compares.
  target_compile_options(${library} PRIVATE -flto -ffat-lto-objects)
  list(APPEND objects $<TARGET_OBJECTS:${library}>)
endforeach()
# An archive of such objects also lists functions that their code lacks: the linker reads some twice.
target_link_options(millwear_options INTERFACE -fno-lto -Wl,-z,muldefs)
set(one_object ${CMAKE_CURRENT_BINARY_DIR}/one_definition.o)
add_custom_command(OUTPUT ${one_object}
  COMMAND ${CMAKE_CXX_COMPILER} -flto -Wodr -Werror=odr -r -nostdlib -flinker-output=rel ${objects}
    -o ${one_object}
  DEPENDS ${libraries} ${objects} COMMAND_EXPAND_LISTS VERBATIM
  COMMENT "Looking for two types of one name")
add_custom_target(one_definition DEPENDS ${one_object})
