# tarn_library(NAME SOURCES ... [DEPENDS ...] [LINK ...] [COLD])
#
# One static library per folder of src/, each with an include root of its own: a library sees the headers of
# the folders it names in DEPENDS (and theirs), and nothing else, so that an include against the grain of the
# house does not compile. The include root is a folder that holds one link, NAME -> src/NAME.

# COLD: nothing in the library is computed for every pixel, ray or vertex, and a release build optimises it with -O1, which takes
# 60 % of the compile time of -O3. The same for single sources: tarn_cold(SOURCE...).

function(tarn_cold)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -O1)
  endif()
endfunction()

add_library(tarn_warnings INTERFACE)
target_compile_options(tarn_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
# GCC 12 sees overlapping copies, or endless ones, in `"text" + std::string` at -O3 where there are none (GCC bug 105329);
# which of the two depends on what it inlines. AddressSanitizer looks for real ones (tools/test --sanitize).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(tarn_warnings INTERFACE -Wno-restrict -Wno-stringop-overflow)
endif()

if(TARN_SANITIZE)
  # -g1: files and lines of stack traces, without the variables, which nobody reads there and which take long to compile.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=address,undefined)
endif()

function(tarn_library name)
  cmake_parse_arguments(ARG "COLD" "" "SOURCES;DEPENDS;LINK" ${ARGN})
  set(root ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${root})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/${name} ${root}/${name} SYMBOLIC)
  add_library(tarn_${name} STATIC ${ARG_SOURCES})
  if(ARG_COLD)
    tarn_cold(${ARG_SOURCES})
  endif()
  target_include_directories(tarn_${name} PUBLIC ${root})
  foreach(dependency ${ARG_DEPENDS})
    target_link_libraries(tarn_${name} PUBLIC tarn_${dependency})
  endforeach()
  target_link_libraries(tarn_${name} PUBLIC ${ARG_LINK} PRIVATE $<BUILD_INTERFACE:tarn_warnings>)
  if("nlohmann_json::nlohmann_json" IN_LIST ARG_LINK)
    tarn_precompiled(tarn_${name} json)
  else()
    tarn_precompiled(tarn_${name} common)
  endif()
endfunction()
