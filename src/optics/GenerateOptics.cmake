# Turns shaders/shared/*.glsl into C++: one header for float, one for double.
#
#     cmake -DPRECISION=float|double -DNAMESPACE=... -DOUTPUT=... -DINPUTS=a.glsl|b.glsl -P GenerateOptics.cmake
#
# The files are already C++ over GLM but for five things, which this script changes:
# - SHARED before a function becomes inline;
# - UNIFORM_BLOCK(Name) becomes struct Name;
# - WAVE_ARRAY and WEIGHT_ARRAY, by which GLSL reads uniform arrays, become parameters;
# - float: literals get their `f`, without which an expression would be computed in double and then narrowed;
# - double: float, vec and mat become double, dvec and dmat.
# #line keeps the compiler's messages, and the debugger, on the shader's own file.

string(REPLACE "|" ";" inputs "${INPUTS}")
set(text "// Generated from shaders/shared by src/optics/GenerateOptics.cmake. Do not edit.\n\n")
string(APPEND text "namespace ${NAMESPACE} {\n")

foreach(input ${inputs})
  file(READ "${input}" code)
  # Comments go first: they hold numbers and words that must not be touched, and semicolons and brackets that
  # CMake's lists trip over.
  string(REGEX REPLACE "//[^\n]*" "" code "${code}")
  string(REGEX REPLACE "#define (WAVE|WEIGHT)_ARRAY" "" code "${code}")
  string(REPLACE "WAVE_ARRAY" "const WaveTerm* waves, int waveCount," code "${code}")
  string(REPLACE "WEIGHT_ARRAY" "const float* waveWeights," code "${code}")
  string(REGEX REPLACE "SHARED " "inline " code "${code}")
  string(REGEX REPLACE "UNIFORM_BLOCK\\(([A-Za-z0-9_]+)\\)" "struct \\1" code "${code}")
  if(PRECISION STREQUAL "float")
    string(REGEX REPLACE "([0-9]+\\.[0-9]+(e-?[0-9]+)?)" "\\1f" code "${code}")
  else()
    # A leading space stands in for the word boundary that CMake's expressions lack.
    string(REGEX REPLACE "([^A-Za-z0-9_])float([^A-Za-z0-9_])" "\\1double\\2" code " ${code}")
    string(REGEX REPLACE "([^A-Za-z0-9_])(vec[234]|mat[234])([^A-Za-z0-9_])" "\\1d\\2\\3" code "${code}")
  endif()
  string(APPEND text "\n#line 1 \"${input}\"\n${code}")
endforeach()

string(APPEND text "\n} // namespace ${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${text}")
