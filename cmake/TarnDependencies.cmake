# Every library that Tarn stands on, in one place. All of them are Debian packages; tools/setup installs them.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(glfw3 REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
# Debian's and Ubuntu's CMake configuration of OpenImageIO stops unless its command-line programs are installed too.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO)
add_library(OpenImageIO::OpenImageIO ALIAS PkgConfig::OpenImageIO)
include(TarnTomlplusplus)
include(TarnEmbree)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl)

# GLM has no code; only the switches that all folders must agree on are set here.
find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
add_library(tarn_glm INTERFACE)
target_include_directories(tarn_glm SYSTEM INTERFACE ${GLM_INCLUDE_DIR})
target_compile_definitions(tarn_glm INTERFACE GLM_FORCE_RADIANS GLM_ENABLE_EXPERIMENTAL GLM_FORCE_XYZW_ONLY)

find_library(OSMESA_LIBRARY NAMES OSMesa REQUIRED)
find_library(OPENGL_LIBRARY NAMES GL REQUIRED)

# GLEW is linked statically: its loader then binds to whatever glXGetProcAddressARB the program defines, which
# is how the OSMesa program replaces it (src/gl/context_osmesa.cpp). Its GLX part needs libGL, which must stand after
# libOSMesa on the link line of a program that has both.
find_library(GLEW_STATIC_LIBRARY NAMES libGLEW.a REQUIRED)
find_path(GLEW_INCLUDE_DIR GL/glew.h REQUIRED)
add_library(tarn_glew INTERFACE)
target_include_directories(tarn_glew SYSTEM INTERFACE ${GLEW_INCLUDE_DIR})
target_compile_definitions(tarn_glew INTERFACE GLEW_STATIC GLEW_NO_GLU)
target_link_libraries(tarn_glew INTERFACE ${GLEW_STATIC_LIBRARY} ${OPENGL_LIBRARY})
