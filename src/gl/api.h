// OpenGL itself, for the few places that need its enums or a call that has no wrapper. GLEW enters only here;
// the headers of this folder do not include it.
#pragma once

#include <GL/glew.h>
