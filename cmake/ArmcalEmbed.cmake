# armcal_embed(TARGET FUNCTION name HEADER its/header.h FILES a b c...): makes text files part of a library, so that the
# tool finds them wherever it is installed. Each file becomes one entry of `FUNCTION()`, found by its path in the
# repository; a generated file (absolute path) by its name.

function(armcal_embed target)
  cmake_parse_arguments(EMBED "" "FUNCTION;HEADER" "FILES" ${ARGN})
  set(output ${PROJECT_BINARY_DIR}/generated/${target}_${EMBED_FUNCTION}.cc)
  set(entries "")
  foreach(path IN LISTS EMBED_FILES)
    if(IS_ABSOLUTE ${path})
      set(source ${path})
      get_filename_component(path ${path} NAME)
    else()
      set(source ${PROJECT_SOURCE_DIR}/${path})
    endif()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(READ ${source} text)
    string(APPEND entries "    {\"${path}\",\n     R\"armcal-file(${text})armcal-file\"sv},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Made by cmake/ArmcalEmbed.cmake from files of the repository. Do not edit.
#include \"@EMBED_HEADER@\"

#include <array>

namespace armcal {
namespace {
using namespace std::string_view_literals;  // of a literal: its length need not be counted
constexpr std::array kFiles = std::to_array<EmbeddedFile>({
@entries@});
}  // namespace

std::span<const EmbeddedFile> @EMBED_FUNCTION@() { return kFiles; }

}  // namespace armcal
")
  target_sources(${target} PRIVATE ${output})
endfunction()
