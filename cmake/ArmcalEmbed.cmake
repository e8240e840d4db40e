# armcal_embed(TARGET FILES...): makes text files of the repository part of a library, so that the tool can
# show its examples wherever it is installed. Each file becomes one entry of `embedded_files()`,
# found by its path in the repository.

function(armcal_embed target)
  set(output ${PROJECT_BINARY_DIR}/generated/${target}_embedded_files.cc)
  set(entries "")
  foreach(path IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${path})
    file(READ ${PROJECT_SOURCE_DIR}/${path} text)
    string(APPEND entries "    {\"${path}\",\n     R\"armcal-file(${text})armcal-file\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Made by cmake/ArmcalEmbed.cmake from files of the repository. Do not edit.
#include \"armcal/workflow/embedded_files.h\"

#include <array>

namespace armcal {
namespace {
constexpr std::array kFiles = std::to_array<EmbeddedFile>({
@entries@});
}  // namespace

std::span<const EmbeddedFile> embedded_files() { return kFiles; }

}  // namespace armcal
")
  target_sources(${target} PRIVATE ${output})
endfunction()
