# tarn_precompiled(TARGET common|json|tests)
#
# Headers of the standard library and of other projects that most sources read are parsed once: reading them again and again
# is a quarter of what compiling Tarn costs. Only those: a header of Tarn's own would rebuild everything when it changes. A
# source still includes all that it uses; the preset `dev` builds without any of this and shows when one does not.
#
# A compiler cache does better than precompiled headers and works badly with them, so that they are off where there is one.

set(precompile ON)
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(precompile OFF)
endif()
option(TARN_PRECOMPILED_HEADERS "Parse the headers of other projects once for all sources" ${precompile})

# A set belongs to a library of its own, since compilers ask for the same definitions and options where it is used.
function(tarn_header_set name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK;OPTIONS" ${ARGN})
  set(source ${PROJECT_BINARY_DIR}/generated/headers_${name}.cpp)
  file(WRITE ${source}.new "// Nothing but the precompiled headers of ${name}.\n")
  file(COPY_FILE ${source}.new ${source} ONLY_IF_DIFFERENT)
  add_library(tarn_headers_${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(tarn_headers_${name} PRIVATE ${ARG_LINK})
  target_compile_options(tarn_headers_${name} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(tarn_headers_${name} PRIVATE ${ARG_HEADERS})
endfunction()

function(tarn_precompiled target name)
  if(TARN_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM tarn_headers_${name})
  endif()
endfunction()

set(TARN_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span> <string> <string_view>
  <utility> <variant> <vector>
  <glm/glm.hpp> <glm/gtc/matrix_transform.hpp> <glm/gtc/quaternion.hpp> <glm/gtc/type_ptr.hpp>
  <fmt/format.h>)
if(TARN_PRECOMPILED_HEADERS)
  tarn_header_set(common HEADERS ${TARN_COMMON_HEADERS} LINK tarn_glm fmt::fmt tarn_warnings)
  tarn_header_set(json HEADERS ${TARN_COMMON_HEADERS} <nlohmann/json.hpp> LINK tarn_glm fmt::fmt nlohmann_json::nlohmann_json
    tarn_warnings)
endif()
