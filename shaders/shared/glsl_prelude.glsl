// Put in front of every shader by ShaderLibrary. Gives GLSL's meaning to the words that the files of this folder use
// so that C++ can read them too (src/optics gives C++'s).

// A function that both languages compile.
#define SHARED

// C++ has the library's, which are as exact as can be; a shader sums waves in every pixel.
#define sineAndCosine sinCosTogether

// A block of uniforms whose layout C++ shares: `UNIFORM_BLOCK(FrameBlock) { … };`
#define UNIFORM_BLOCK(name) layout(std140) uniform name
