// Put in front of every shader by ShaderLibrary. Gives GLSL's meaning to the words that the files of this folder use
// so that C++ can read them too (src/optics gives C++'s).

// A function that both languages compile.
#define SHARED

// A block of uniforms whose layout C++ shares: `UNIFORM_BLOCK(FrameBlock) { … };`
#define UNIFORM_BLOCK(name) layout(std140) uniform name
